#include <string>

#include <nlohmann/json.hpp>

#include "mpi_tool/mpi_tool.h"

namespace brindle {
namespace {

using test::content;
using test::MpiTool;
using test::Words;

struct MpiToolShapes : MpiTool {
  nlohmann::json report_of(int ranks, Words arguments) const {
    arguments.insert(arguments.end(), {"--direction", "0.3,0.9,0.2", "--threads", "1", "--quiet",
                                       "--plan-below", "0", "--report", "out.json"});
    const auto result = on(ranks, arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return nlohmann::json::parse(content(folder / "out.json"));
  }
};

/// On eight ranks none needs nearly as much as one that has all.
TEST_F(MpiToolShapes, NoRankHoldsTheWhole) {
  for (const Words& mesh : {Words{"shape:torus,resolution=512"},
                            Words{"shape:torus,resolution=128", "--subdivide", "2"},
                            Words{"shape:trefoil,resolution=45", "--subdivide", "2"}}) {
    const auto one = report_of(1, mesh), eight = report_of(8, mesh);
    for (const char* key : {"vertices", "triangles", "edges"}) EXPECT_EQ(one[key], eight[key]);
    const double whole = one["ranks"]["memory_peak_most"],
                 most = eight["ranks"]["memory_peak_most"];
    if (whole == 0) GTEST_SKIP() << "the system does not tell of memory";
    EXPECT_LT(most, 0.6 * whole);
    EXPECT_LT(eight["ranks"]["vertices_most"], one["vertices"].get<double>() / 5);
  }
}

/// Strips of one shape have borders as long as its rows: ranks have two each.
TEST_F(MpiToolShapes, HaveBordersOfTheirRows) {
  for (const int ranks : {2, 4, 7}) {
    const auto report = report_of(ranks, {"shape:torus,resolution=200"});
    EXPECT_EQ(report["ranks"]["count"], ranks);
    EXPECT_EQ(report["ranks"]["ghosts"], 2 * 200 * ranks);
  }
}

}  // namespace
}  // namespace brindle
