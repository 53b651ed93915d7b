#include "brindle/camera.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/render/parsed_words.h"
#include "render/test_drawings.h"

namespace brindle {
namespace {

/// The box in normalised device coordinates that a mesh fills.
Eigen::AlignedBox<float, 2> seen_box(const Mesh& mesh, const Camera& camera) {
  Eigen::AlignedBox<float, 2> box;
  for (const Vec3& p : mesh.positions) {
    const Eigen::Vector4f clip =
        camera.clip_from_view * camera.view_from_world * (p - camera.origin).homogeneous();
    EXPECT_GT(clip.w(), 0);
    EXPECT_LE(std::abs(clip.z()), clip.w());
    box.extend(Eigen::Vector2f(clip.head<2>() / clip.w()));
  }
  return box;
}

TEST(Camera, FramesAnyMeshTightlyAndWhole) {
  for (const float scale : {1e-3f, 1.0f, 1e4f}) {
    Mesh mesh = test::saddle(5);
    for (Vec3& p : mesh.positions) p = scale * Vec3(p.x() + 3, 0.3f * p.y(), p.z());
    for (const auto& [width, height] : {std::pair{1200, 900}, {300, 900}, {640, 640}}) {
      for (const CameraView& view : {CameraView{30, 20, 1}, {200, -70, 1}, {0, 90, 1, UpAxis::z}}) {
        const auto box =
            seen_box(mesh, framed_camera(points_of_triangles(mesh), view, width, height));
        EXPECT_LE(box.max().cwiseAbs().maxCoeff(), 0.951f);
        EXPECT_LE(box.min().cwiseAbs().maxCoeff(), 0.951f);
        const bool fills_x = box.max().x() > 0.949f && box.min().x() < -0.949f;
        const bool fills_y = box.max().y() > 0.949f && box.min().y() < -0.949f;
        EXPECT_TRUE(fills_x || fills_y);
      }
    }
  }
}

TEST(Camera, ZoomEnlargesAboutTheMiddle) {
  const Mesh mesh = test::square(2);
  const auto box = seen_box(mesh, framed_camera(points_of_triangles(mesh), {0, 0, 1}, 400, 400));
  const auto zoomed = seen_box(mesh, framed_camera(points_of_triangles(mesh), {0, 0, 2}, 400, 400));
  EXPECT_TRUE(zoomed.max().isApprox(2 * box.max(), 1e-4f));
  EXPECT_TRUE(zoomed.min().isApprox(2 * box.min(), 1e-4f));
}

TEST(Camera, AnglesTurnAsDocumented) {
  const Mesh mesh = test::square(1);
  const auto axis_seen = [&](const CameraView& view, const Vec3& axis) -> Vec3 {
    return framed_camera(points_of_triangles(mesh), view, 100, 100)
               .view_from_world.topLeftCorner<3, 3>() *
           axis;
  };
  // Seen from the camera: x to the right, y up, z towards it.
  EXPECT_TRUE(axis_seen({0, 0}, Vec3::UnitZ()).isApprox(Vec3::UnitZ(), 1e-5f));
  EXPECT_TRUE(axis_seen({0, 0}, Vec3::UnitX()).isApprox(Vec3::UnitX(), 1e-5f));
  EXPECT_TRUE(axis_seen({90, 0}, Vec3::UnitX()).isApprox(Vec3::UnitZ(), 1e-5f));
  EXPECT_TRUE(axis_seen({0, 90}, Vec3::UnitY()).isApprox(Vec3::UnitZ(), 1e-5f));
  EXPECT_TRUE(axis_seen({0, 0, 1, UpAxis::z}, Vec3::UnitZ()).isApprox(Vec3::UnitY(), 1e-5f));
  EXPECT_TRUE(axis_seen({0, 0, 1, UpAxis::z}, -Vec3::UnitY()).isApprox(Vec3::UnitZ(), 1e-5f));
  EXPECT_TRUE(axis_seen({90, 0, 1, UpAxis::z}, Vec3::UnitX()).isApprox(Vec3::UnitZ(), 1e-5f));
}

constexpr UpAxis kAllUp[] = {UpAxis::x,       UpAxis::y,       UpAxis::z,
                             UpAxis::minus_x, UpAxis::minus_y, UpAxis::minus_z};

TEST(Camera, EveryAxisMayPointUp) {
  const std::vector<Vec3> points = points_of_triangles(test::square(1));
  for (const UpAxis up : kAllUp) {
    const std::string name(name_of(up));
    Vec3 axis = Vec3::Zero();
    axis[name.back() - 'x'] = name.front() == '-' ? -1 : 1;
    for (const float azimuth : {0.0f, 40.0f, 210.0f}) {
      const Camera camera = framed_camera(points, {azimuth, 0, 1, up}, 100, 100);
      const Eigen::Matrix3f turn = camera.view_from_world.topLeftCorner<3, 3>();
      EXPECT_NEAR(turn.determinant(), 1, 1e-5f) << name << ": no mirror image";
      EXPECT_TRUE((turn * axis).isApprox(Vec3::UnitY(), 1e-5f)) << name;
    }
    const Camera above = framed_camera(points, {40, 90, 1, up}, 100, 100);
    const Eigen::Matrix3f turn = above.view_from_world.topLeftCorner<3, 3>();
    EXPECT_TRUE((turn * axis).isApprox(Vec3::UnitZ(), 1e-5f)) << name;
    EXPECT_EQ(parse_up_axis(name), up);
  }
  for (const char* text : {"", "w", "+z", "zz", "--z", "Z"}) EXPECT_FALSE(parse_up_axis(text));
}

TEST(Camera, ShapesAndStlStandOnZ) {
  for (const char* mesh : {"shape:torus", "part.stl", "folder/PART.STL", "v*.stl"}) {
    EXPECT_EQ(usual_up_axis(mesh), UpAxis::z) << mesh;
  }
  for (const char* mesh : {"a.obj", "a.ply", "a.glb", "a.vtp", "a.off", "stl", "arrays", ""}) {
    EXPECT_FALSE(usual_up_axis(mesh)) << mesh;
  }
}

TEST(Camera, MeshWithoutExtentGivesFiniteMatrices) {
  Mesh mesh;
  EXPECT_TRUE(framed_camera(points_of_triangles(mesh), {}, 10, 10).clip_from_view.allFinite());
  mesh.positions.assign(3, Vec3(1, 2, 3));
  mesh.triangles.push_back({0, 1, 2});
  const Camera camera = framed_camera(points_of_triangles(mesh), {}, 10, 10);
  EXPECT_TRUE(camera.clip_from_view.allFinite());
  EXPECT_TRUE(camera.view_from_world.allFinite());
}

TEST(Camera, VerticesWithoutTriangleAreNotFramed) {
  Mesh mesh = test::square(2);
  const std::size_t count = mesh.vertex_count();
  mesh.positions.push_back(Vec3(100, 0, 0));
  EXPECT_EQ(points_of_triangles(mesh).size(), count);
}

TEST(CameraView, IsReadFromText) {
  const auto view = parse_camera_view("-30,45.5,2", UpAxis::z);
  ASSERT_TRUE(view);
  EXPECT_EQ(view->azimuth_deg, -30);
  EXPECT_EQ(view->elevation_deg, 45.5f);
  EXPECT_EQ(view->zoom, 2);
  EXPECT_EQ(view->up, UpAxis::z);
  EXPECT_EQ(parse_camera_view("10,20")->zoom, 1);
  const auto top = parse_camera_view("top,2", UpAxis::z);
  ASSERT_TRUE(top);
  EXPECT_EQ(*top, *parse_camera_view("0,90,2", UpAxis::z));
  EXPECT_EQ(*parse_camera_view("left"), *parse_camera_view("-90,0"));
  for (const char* text :
       {"tops", "top,", "top,2,1", "top,x", "", "10", "10,", "10,20,", "10,20,1,1", "a,b", "10 20",
        "10,91", "10,20,0", "nan,0", "inf,0", "10,20,-1", "1e99,0", " 10,20"}) {
    EXPECT_FALSE(parse_camera_view(text)) << text;
  }
}

}  // namespace
}  // namespace brindle
