#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/random.h"
#include "brindle/mesh.h"
#include "brindle/shapes/noise.h"
#include "brindle/shapes/parametric_shapes.h"
#include "gallery/hare.h"
#include "gallery/items.h"
#include "gallery/rough_meshes.h"

namespace brindle {
namespace {

using Point = Eigen::Vector3d;
using Cell = std::array<int, 3>;

/// The faces between inner and outer voxels, as two triangles each.
class VoxelFaces {
 public:
  VoxelFaces(const ImplicitFunction& function, double voxel) : function_(function), voxel_(voxel) {}

  void add(const Cell& cell) {
    if (!is_in(cell)) return;
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        Cell next = cell;
        next[axis] += 2 * side - 1;
        if (!is_in(next)) add_face(cell, axis, side);
      }
    }
  }

  Mesh mesh;

 private:
  bool is_in(const Cell& cell) const {
    const Point middle = voxel_ * (Point(cell[0], cell[1], cell[2]) + Point::Constant(0.5));
    std::uint64_t place = 0;
    for (const int along : cell) place = 2048 * place + static_cast<std::uint64_t>(along + 1024);
    // Noise of a scan.
    return function_(middle) + 0.35 * voxel_ * (random_number(8, place) - 0.5) < 0;
  }

  void add_face(const Cell& cell, int axis, int side) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::array<Index, 4> corners{};
    for (int k = 0; k < 4; ++k) {
      Cell corner = cell;
      corner[axis] += side;
      corner[u] += k == 1 || k == 2 ? 1 : 0;
      corner[v] += k >= 2 ? 1 : 0;
      corners[k] = vertex(corner);
    }
    if (side == 0) std::swap(corners[1], corners[3]);
    mesh.triangles.push_back({corners[0], corners[1], corners[2]});
    mesh.triangles.push_back({corners[0], corners[2], corners[3]});
  }

  Index vertex(const Cell& corner) {
    const auto [found, added] =
        vertices_.try_emplace(corner, static_cast<Index>(mesh.positions.size()));
    if (added) {
      mesh.positions.push_back(static_cast<float>(voxel_) * Vec3(static_cast<float>(corner[0]),
                                                                 static_cast<float>(corner[1]),
                                                                 static_cast<float>(corner[2])));
    }
    return found->second;
  }

  const ImplicitFunction& function_;
  double voxel_;
  std::map<Cell, Index> vertices_;
};

std::vector<GalleryFile> make_rough(double detail, const Progress& progress) {
  GalleryFile file{"rough.vtp", {}, {}, {}};
  const std::array<Mesh, 4> meshes = {
      incomplete_mesh(detail, progress.part(0, 0.6)), non_manifold_mesh(detail),
      segmented_mesh(detail, progress.part(0.6, 1)), noisy_mesh(detail)};
  // Equally high, side by side on one ground.
  constexpr float kHeight = 2.2f, kGap = 0.28f;
  float left = 0;
  for (Mesh mesh : meshes) {
    const BoundingBox before = bounding_box(mesh);
    for (Vec3& p : mesh.positions) p *= kHeight / (before.upper.z() - before.lower.z());
    const BoundingBox box = bounding_box(mesh);
    translate(mesh, Vec3(left - box.lower.x(), -box.center().y(), -box.lower.z()));
    left += box.upper.x() - box.lower.x() + kGap;
    append(mesh, file.mesh);
  }
  return {std::move(file)};
}

}  // namespace

Mesh incomplete_mesh(double detail, const Progress& progress) {
  Mesh mesh = hare_mesh(static_cast<float>(0.026 / detail), progress);
  // Holes of a scan, and single missing triangles.
  const std::array<std::pair<Vec3, float>, 5> holes = {{{{0.5f, -0.2f, 0.55f}, 0.2f},
                                                        {{-0.25f, -0.5f, 0.55f}, 0.24f},
                                                        {{0.6f, 0.26f, 1.3f}, 0.13f},
                                                        {{0.1f, 0.25f, 1.05f}, 0.16f},
                                                        {{0.2f, -0.2f, 2.2f}, 0.17f}}};
  std::uint64_t drawn = 0;
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    const Vec3 middle = (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3;
    if (random_number(3, drawn++) < 0.004 || middle.z() < 0.06f) return true;
    return std::ranges::any_of(
        holes, [&](const auto& hole) { return (middle - hole.first).norm() < hole.second; });
  });
  drop_unreferenced_vertices(mesh);
  return mesh;
}

Mesh non_manifold_mesh(double detail) {
  const int resolution = std::max(4, static_cast<int>(46 * detail));
  Mesh mesh =
      mesh_of(sheets_strips({.count = 5, .width = 0.95f, .height = 2, .resolution = resolution}));
  for (Vec3& p : mesh.positions) {
    const float out = p.head<2>().norm();
    const float turn = 0.55f * p.z() + 0.9f * out;
    p = Eigen::AngleAxisf(turn, Vec3::UnitZ()) * p;
  }
  return mesh;
}

Mesh segmented_mesh(double detail, const Progress& progress) {
  const ImplicitFunction tumour =
      blended({ball({0, 0, 0}, 0.5), ball({0.3, 0.42, 0.25}, 0.34), ball({-0.3, 0.1, 0.45}, 0.32),
               ball({0.1, -0.45, -0.2}, 0.34), ball({-0.1, 0.3, -0.45}, 0.28),
               ball({0.2, -0.75, 0.72}, 0.17), ball({-0.3, -0.6, 0.85}, 0.09),
               ball({0.1, 0.85, -0.55}, 0.14), ball({0, -0.95, -0.5}, 0.12)},
              0.035);
  const double voxel = 0.085 / std::sqrt(detail);
  const int reach = static_cast<int>(std::ceil(1.3 / voxel));
  VoxelFaces faces(tumour, voxel);
  for (int x = -reach; x < reach; ++x) {
    progress.report(static_cast<double>(x + reach) / (2 * reach));
    for (int y = -reach; y < reach; ++y) {
      for (int z = -reach; z < reach; ++z) faces.add({x, y, z});
    }
  }
  return subdivide(std::move(faces.mesh), 1);  // otherwise, stripes are finer than the triangles
}

Mesh noisy_mesh(double detail) {
  Mesh mesh = mesh_of(
      trefoil_strips({.radius = 0.2f, .resolution = std::max(8, static_cast<int>(44 * detail))}));
  for (Vec3& p : mesh.positions) p = Vec3(p.z(), p.x(), p.y());  // upright
  add_noise(mesh, 0.3f, 7);
  return mesh;
}

GalleryItem rough_item() {
  return {"rough",
          "an incomplete, a non-manifold, an unconnected and a noisy surface",
          make_rough,
          {{"all",
            "one pattern over all of them",
            "stripe {surface=rough.vtp} --field {field=smooth} --stripes 92 "
            "--colors #1c325a,#f4efe6,#ffffff --up z --camera 8,12,0.95",
            "880x320",
            {"stripes", "rotate", "curvature-anchor"}}}};
}

}  // namespace brindle
