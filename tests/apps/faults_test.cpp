/// Files that mean harm, and a machine that has too little.
#include <cstdint>
#include <filesystem>
#include <string>

#include <sys/resource.h>
#include <zlib.h>

#include "tool.h"

namespace brindle::test {
namespace {

namespace fs = std::filesystem;

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  all.reserve(times * text.size());
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

/// A triangle whose points are written as `points`, behind `prologue`.
std::string triangle_vtp(const std::string& prologue, const std::string& points,
                         const std::string& count = "3") {
  return "<?xml version=\"1.0\"?>" + prologue +
         "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\"><PolyData>"
         "<Piece NumberOfPoints=\"" +
         count +
         "\" NumberOfPolys=\"1\"><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" " +
         points +
         "</DataArray></Points><Polys><DataArray type=\"Int64\" Name=\"connectivity\" "
         "format=\"ascii\">0 1 2</DataArray><DataArray type=\"Int64\" Name=\"offsets\" "
         "format=\"ascii\">3</DataArray></Polys></Piece></PolyData></VTKFile>";
}

/// Limits what this process and those that it starts may take until the end of the scope.
class Limited {
 public:
  Limited(int resource, rlim_t most) : resource_(resource) {
    getrlimit(resource_, &before_);
    const rlimit limit{most, before_.rlim_max};
    setrlimit(resource_, &limit);
  }
  ~Limited() { setrlimit(resource_, &before_); }
  Limited(const Limited&) = delete;

 private:
  int resource_;
  rlimit before_{};
};

struct Faults : ToolTest {};

#ifdef __SANITIZE_ADDRESS__
constexpr bool kMemoryMayBeLimited = false;  // its shadow takes terabytes of addresses
#else
constexpr bool kMemoryMayBeLimited = true;
#endif

TEST_F(Faults, EntitiesOfXmlAreNotFollowed) {
  std::string laughs = "<!DOCTYPE x [<!ENTITY a0 \"0 0 0 1 0 0 0 1 0\">";
  for (int i = 1; i < 12; ++i) {
    laughs += "<!ENTITY a" + std::to_string(i) + " \"" +
              repeated("&a" + std::to_string(i - 1) + ";", 10) + "\">";
  }
  write_text(folder / "laughs.vtp", triangle_vtp(laughs + "]>", "format=\"ascii\">&a11;"));
  expect_refusal(1, "laughs.vtp", {"stripe", "laughs.vtp"});
  // What stands in another file does not come into this one.
  write_text(folder / "secret", "0 0 0 1 0 0 0 1 0");
  write_text(folder / "outside.vtp", triangle_vtp("<!DOCTYPE x [<!ENTITY a SYSTEM \"file://" +
                                                      (folder / "secret").string() + "\">]>",
                                                  "format=\"ascii\">&a;"));
  expect_refusal(1, "outside.vtp", {"stripe", "outside.vtp"});
}

TEST_F(Faults, DeepNestingIsRefused) {
  const std::size_t depth = 500000;
  const std::string lists = repeated("[", depth) + repeated("]", depth);
  write_text(folder / "a.gltf", R"({"asset": {"version": "2.0"}, "meshes": )" + lists + "}");
  expect_refusal(1, "a.gltf", {"stripe", "a.gltf"});
  write_text(folder / "a.json", R"({"strokes": )" + lists + "}");
  expect_refusal(1, "a.json", {"stripe", "shape:sphere", "--strokes", "a.json"});
  write_text(folder / "a.series", R"({"files": )" + lists + "}");
  expect_refusal(1, "a.series", {"animate", "--series", "a.series", "--output", "%04d.vtp"});
  write_text(folder / "a.vtp", repeated("<a>", depth) + repeated("</a>", depth));
  expect_refusal(1, "a.vtp", {"stripe", "a.vtp"});
}

/// 14 MB that say they are 14 GB, and are: points that are all alike.
TEST_F(Faults, PackedDataThatFillTheMemoryAreRefused) {
  if (!kMemoryMayBeLimited) GTEST_SKIP() << "not under the address sanitizer";
  const std::size_t block = 24u << 20, blocks = 600;
  const std::string zeros(block, '\0');
  std::string packed(compressBound(block), '\0');
  uLongf size = packed.size();
  ASSERT_EQ(compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                      reinterpret_cast<const Bytef*>(zeros.data()), block, 9),
            Z_OK);
  packed.resize(size);
  std::string data;
  const auto number = [&](std::uint64_t value) {
    data.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (const std::uint64_t value :
       {std::uint64_t{blocks}, std::uint64_t{block}, std::uint64_t{0}}) {
    number(value);
  }
  for (std::size_t i = 0; i < blocks; ++i) number(size);
  for (std::size_t i = 0; i < blocks; ++i) data += packed;
  std::string file =
      triangle_vtp("", "format=\"appended\" offset=\"0\">", std::to_string(blocks * block / 12));
  const std::string end = "</VTKFile>";
  file.insert(file.size() - end.size(),
              "<AppendedData encoding=\"raw\">_" + data + "</AppendedData>");
  write_text(folder / "a.vtp", file);
  const Limited memory(RLIMIT_AS, 4ull << 30);
  expect_refusal(1, "not enough memory", {"stripe", "a.vtp"});
}

/// Whatever the limit is, a whole file or none, and a sentence.
TEST_F(Faults, TooLittleMemoryIsAMessage) {
  if (!kMemoryMayBeLimited) GTEST_SKIP() << "not under the address sanitizer";
  int refused = 0, done = 0;
  for (const rlim_t megabytes : {150, 250, 350, 500, 4000}) {
    ToolResult result;
    {
      const Limited memory(RLIMIT_AS, megabytes << 20);
      result = run({"stripe", "shape:torus,resolution=700", "--quiet", "--threads", "2", "--output",
                    "a.vtp"});
    }
    SCOPED_TRACE(megabytes);
    if (result.exit_code == 0) {
      EXPECT_EQ(run({"info", "a.vtp"}).exit_code, 0);
      fs::remove(folder / "a.vtp");
      ++done;
      continue;
    }
    EXPECT_EQ(result.exit_code, 1) << result.err;
    EXPECT_NE(result.err.find("memory"), std::string::npos) << result.err;
    EXPECT_TRUE(listing().empty());
    ++refused;
  }
  EXPECT_GT(done, 0);
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace brindle::test
