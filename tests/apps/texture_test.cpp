#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "tool.h"

#ifdef BRINDLE_HAS_GL

#include "brindle/image.h"

namespace brindle::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

struct TextureTool : ToolTest {
  Arguments with(const Arguments& more, const std::string& mesh = kTorus48) const {
    Arguments arguments = {"stripe", mesh, "--stripes", "10"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const bool draws =
        std::any_of(arguments.begin(), arguments.end(), [&](const std::string& word) {
          return word.ends_with(".png") && &word != &arguments.front() && (&word)[-1] == "-o";
        });
    if (draws) arguments.insert(arguments.end(), {"--size", "64x48"});
    return arguments;
  }
  Json report(const Arguments& more, const std::string& mesh = kTorus48) const {
    Arguments arguments = with(more, mesh);
    arguments.insert(arguments.end(), {"--report", "report.json"});
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return Json::parse(content(folder / "report.json"));
  }
};

TEST_F(TextureTool, ReportsDistortionAndSeamsBesideTheContractsKeys) {
  const Json report = this->report({"--texture", "checker"});
  EXPECT_TRUE(report.contains("energy"));
  const Json& texture = report.at("texture");
  for (const char* key :
       {"energy_v", "branches_u", "branches_v", "turned_edges", "mirrored_edges",
        "unoriented_triangles", "angle_distortion_mean_deg", "angle_distortion_95th_deg",
        "area_distortion_mean", "area_distortion_95th"}) {
    EXPECT_TRUE(texture.contains(key)) << key;
  }
  // Tiles are cut by branches of either wave.
  const auto u = texture["branches_u"].get<int>(), v = texture["branches_v"].get<int>();
  EXPECT_GE(report["branches"], std::max(u, v));
  EXPECT_LE(report["branches"], u + v);
  EXPECT_LE(texture["angle_distortion_mean_deg"].get<double>(),
            texture["angle_distortion_95th_deg"].get<double>());
  EXPECT_FALSE(this->report({}).contains("texture"));
}

TEST_F(TextureTool, DrawsTilesAndPictures) {
  const ToolResult first = run(with({"-o", "tile.png", "-o", "stripes.png"}));
  ASSERT_EQ(first.exit_code, 0) << first.err;
  for (const char* tile : {"checker", "arrows", "hatch", "tile.png"}) {
    const ToolResult result = run(with({"--texture", tile, "-o", "out.png"}));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(content(folder / "out.png"), content(folder / "stripes.png")) << tile;
  }
}

TEST_F(TextureTool, TilesAreWholeWhereTheyHaveAShapeOfTheirOwn) {
  const auto picture = [&](const Arguments& more) {
    Arguments arguments = with(more);
    arguments.insert(arguments.end(), {"-o", "out.png", "-o", "out.ply", "--size", "150x110"});
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return content(folder / "out.png");
  };
  const auto has_flags = [&] {
    return content(folder / "out.ply").find("tile_broken") != std::string::npos;
  };
  for (const auto& [tile, own] : std::map<std::string, bool>{
           {"arrows", true}, {"dots", true}, {"plusminus", true}, {"hatch", false}}) {
    const auto tiles = [&](const Arguments& more) {
      Arguments all = {"--direction", "0.3,0.9,0.2"};
      all.insert(all.end(), more.begin(), more.end());
      return picture(all);
    };
    const std::string whole = tiles({"--texture", tile + ",whole"});
    EXPECT_TRUE(has_flags()) << tile;
    const std::string cut = tiles({"--texture", tile + ",cut"});
    EXPECT_FALSE(has_flags()) << tile;
    EXPECT_NE(whole, cut) << tile;
    EXPECT_EQ(tiles({"--texture", tile}), own ? whole : cut) << tile;
    if (tile == "dots" || tile == "plusminus") continue;
    // Styles draw the same tiles; of regions each has its own.
    EXPECT_NE(tiles({"--texture", tile + ",shift=0.3"}),
              tiles({"--texture", tile + ",shift=0.3" + (own ? ",cut" : ",whole")}));
    const std::string regions = "height,regions=0,plus";
    EXPECT_NE(tiles({"--texture", tile, "--texture-by", regions}),
              tiles({"--texture", tile + ",cut", "--texture-by", regions}));
    EXPECT_NE(tiles({"--texture", tile + ",whole", "--between", "nothing"}),
              tiles({"--texture", tile + ",cut", "--between", "nothing"}));
  }
}

TEST_F(TextureTool, MeshesCarryCoordinatesAndTheirPicture) {
  const ToolResult result = run(with({"--texture", "arrows", "-o", "a.obj", "-o", "b.ply", "-o",
                                      "c.glb", "-o", "d.gltf", "-o", "e.vtp"}));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(listing(),
            (std::set<std::string>{"a.obj", "a.mtl", "a_texture.png", "b.ply", "b_texture.png",
                                   "c.glb", "d.gltf", "e.vtp", "e_texture.png"}));
  EXPECT_NE(content(folder / "a.obj").find("mtllib a.mtl"), std::string::npos);
  EXPECT_NE(content(folder / "a.mtl").find("map_Kd a_texture.png"), std::string::npos);
  EXPECT_NE(content(folder / "b.ply").find("comment TextureFile b_texture.png"), std::string::npos);
  for (const char* name :
       {"texture_u", "phase", "phase_v", "direction_v_x", "branch", "branch_v"}) {
    EXPECT_NE(content(folder / "b.ply").find("property float " + std::string(name)),
              std::string::npos)
        << name;
  }
  EXPECT_NE(content(folder / "e.vtp").find("TCoords=\"uv\""), std::string::npos);
  EXPECT_EQ(read_png(folder / "a_texture.png").width, 512);
  const Json gltf = Json::parse(content(folder / "d.gltf"));
  EXPECT_EQ(gltf["samplers"][0]["wrapS"], 10497);
  EXPECT_EQ(gltf["images"][0]["mimeType"], "image/png");
  EXPECT_TRUE(gltf["meshes"][0]["primitives"][0]["attributes"].contains("TEXCOORD_0"));
}

TEST_F(TextureTool, ItsMeshesAreReadBack) {
  for (const char* name : {"a.obj", "a.ply", "a.glb"}) {
    const ToolResult result = run(with({"--texture", "checker", "-o", name, "-q"}));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Json again = report({}, name);
    EXPECT_GE(again["triangles"].get<int>(), report({})["triangles"].get<int>()) << name;
  }
}

TEST_F(TextureTool, FrequenciesOfVAreIndependent) {
  write_text(folder / "mesh.obj", kSquareObj);
  write_text(folder / "field.csv", "x,y,z,f,g\n1,0,0,2,5\n1,0,0,2,5\n1,0,0,2,5\n1,0,0,2,5\n");
  const auto frequencies_v = [&](const Arguments& more) {
    Arguments arguments = {"stripe", "mesh.obj", "--texture", "dots", "-o", "out.gltf", "-q"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const Json gltf = Json::parse(content(folder / "out.gltf"));
    return gltf["meshes"][0]["primitives"][0]["attributes"].contains("_FREQUENCY_V");
  };
  EXPECT_TRUE(frequencies_v({"--field", "field.csv"}));
  const Json file =
      report({"--texture", "dots", "--field", "field.csv", "--frequency-v", "3"}, "mesh.obj");
  EXPECT_LT(file["texture"]["area_distortion_mean"].get<double>(), 0.02);
  EXPECT_TRUE(frequencies_v({"--stripes-v", "30"}));
}

TEST_F(TextureTool, BadPicturesAreRefused) {
  expect_refusal(1, "none.png", with({"--texture", "none.png", "-o", "out.png"}));
  expect_refusal(2, "did you mean 'checker'", with({"--texture", "cheker", "-o", "out.png"}));
  write_text(folder / "text.png", "this is not a picture");
  expect_refusal(1, "text.png", with({"--texture", "text.png", "-o", "out.png"}));
  write_text(folder / "empty.png", "");
  expect_refusal(1, "empty.png", with({"--texture", "empty.png", "-o", "out.png"}));
  fs::create_directory(folder / "folder.png");
  expect_refusal(1, "folder.png", with({"--texture", "folder.png", "-o", "out.png"}));
  ASSERT_EQ(run(with({"-o", "half.png", "-q"})).exit_code, 0);
  fs::resize_file(folder / "half.png", fs::file_size(folder / "half.png") / 2);
  expect_refusal(1, "half.png", with({"--texture", "half.png", "-o", "out.png"}));
}

TEST_F(TextureTool, TinyAndHugePicturesAreDrawn) {
  Image one(1, 1);
  one.at(0, 0) = {255, 0, 0, 255};
  write_png(folder / "one.png", one);
  write_png(folder / "wide.png", Image(20000, 2));
  for (const char* name : {"one.png", "wide.png"}) {
    const ToolResult result = run(with({"--texture", name, "-o", "out.png", "-o", "out.glb"}));
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }
}

TEST_F(TextureTool, FieldsForAnotherNumberOfVerticesAreRefused) {
  write_text(folder / "mesh.obj", kSquareObj);
  write_text(folder / "short.csv", "1,0,0\n1,0,0\n");
  expect_refusal(1, "short.csv",
                 with({"--texture", "dots", "--field", "short.csv", "-o", "o.png"}, "mesh.obj"));
  write_text(folder / "zero.csv", "1,0,0,1,1\n1,0,0,1,0\n1,0,0,1,1\n1,0,0,1,1\n");
  expect_refusal(1, "line 2",
                 with({"--texture", "dots", "--field", "zero.csv", "-o", "o.png"}, "mesh.obj"));
  write_text(folder / "six.csv", "1,0,0,1,1,1\n");
  expect_refusal(1, "6 columns",
                 with({"--texture", "dots", "--field", "six.csv", "-o", "o.png"}, "mesh.obj"));
}

TEST_F(TextureTool, FormatsThatCannotHoldATextureAreRefusedWithOneThatCan) {
  for (const char* name : {"out.stl", "out.off", "out.csv"}) {
    expect_refusal(2, ".glb", with({"--texture", "dots", "-o", name}));
  }
}

TEST_F(TextureTool, FilesBesideMeshesAreCheckedBeforeTheWorkBegins) {
  fs::create_directory(folder / "a_texture.png");
  expect_refusal(1, "a_texture.png", with({"--texture", "dots", "-o", "a.obj"}));
  fs::create_directory(folder / "b.mtl");
  expect_refusal(1, "b.mtl", with({"--texture", "dots", "-o", "b.obj"}));
}

TEST_F(TextureTool, OptionsOfTexturesNeedOne) {
  expect_refusal(2, "--texture", with({"--oriented", "-o", "out.png"}));
  expect_refusal(2, "--texture", with({"--stripes-v", "20", "-o", "out.png"}));
  expect_refusal(2, "--stripes-v",
                 with({"--texture", "dots", "--stripes-v", "20", "--frequency-v", "2"}));
  expect_refusal(2, "--frequency-v", with({"--texture", "dots", "--frequency-v", "-2"}));
}

TEST_F(TextureTool, NumbersDoNotDependOnThreads) {
  Json one = report({"--texture", "checker", "--threads", "1"});
  Json two = report({"--texture", "checker", "--threads", "2"});
  EXPECT_EQ(one["texture"], two["texture"]);
}

}  // namespace
}  // namespace brindle::test

#endif
