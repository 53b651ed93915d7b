#include "brindle/files/assimp_file.h"

#include <string>

#include "brindle/error.h"

#ifdef BRINDLE_HAS_ASSIMP

#include <exception>
#include <utility>
#include <vector>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include "brindle/base/printable.h"
#include "brindle/geometry/local_positions.h"

namespace brindle {
namespace {

/// A mesh with its positions as doubles too: floats may be too coarse for where nodes put them.
struct Placed {
  Mesh mesh;
  std::vector<Eigen::Vector3d> positions;
};

Eigen::Vector3d moved(const aiVector3D& point, const Eigen::Matrix4d& transform) {
  return transform.topLeftCorner<3, 3>() * Eigen::Vector3d(point.x, point.y, point.z) +
         transform.topRightCorner<3, 1>();
}

/// With the translation that `known` names, if that is what was rounded.
Eigen::Matrix4d in_doubles(const aiMatrix4x4& matrix, const GltfNode* known) {
  Eigen::Matrix4d result;
  for (unsigned row = 0; row < 4; ++row) {
    for (unsigned column = 0; column < 4; ++column) {
      result(row, column) = static_cast<double>(matrix[row][column]);
    }
  }
  const Eigen::Vector3d rounded = result.topRightCorner<3, 1>();
  if (known != nullptr && known->translation.cast<float>().cast<double>() == rounded) {
    result.topRightCorner<3, 1>() = known->translation;
  }
  return result;
}

void append(Placed& result, const aiMesh& part, const aiMatrix4x4& transform,
            const Eigen::Matrix4d& exact, const std::string& path) {
  Mesh& mesh = result.mesh;
  if (mesh.vertex_count() + part.mNumVertices > 0xfffffffe) {
    throw Error(path + ": has more vertices than brindle can number; split it into parts");
  }
  const auto first = static_cast<Index>(mesh.vertex_count());
  const bool identity = transform.IsIdentity();
  for (unsigned v = 0; v < part.mNumVertices; ++v) {
    // An identity must not cost the last bit of a coordinate.
    const aiVector3D p = identity ? part.mVertices[v] : transform * part.mVertices[v];
    mesh.positions.push_back({p.x, p.y, p.z});
    result.positions.push_back(moved(part.mVertices[v], exact));
  }
  // A mirroring transform turns triangles inside out.
  const bool mirrored = transform.Determinant() < 0;
  for (unsigned f = 0; f < part.mNumFaces; ++f) {
    const aiFace& face = part.mFaces[f];
    if (face.mNumIndices != 3) continue;  // points and lines
    for (unsigned c = 0; c < 3; ++c) {
      if (face.mIndices[c] >= part.mNumVertices) {
        throw Error(path + ": triangle " + std::to_string(f) +
                    " has a corner that does not exist; the file is damaged, export it again");
      }
    }
    Triangle t = {first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]};
    if (mirrored) std::swap(t[1], t[2]);
    mesh.triangles.push_back(t);
  }
}

void append(Placed& result, const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent,
            const Eigen::Matrix4d& exact_parent, const GltfNode* known, const std::string& path) {
  const aiMatrix4x4 transform = parent * node.mTransformation;
  const Eigen::Matrix4d exact = exact_parent * in_doubles(node.mTransformation, known);
  const bool alike = known != nullptr && known->children.size() == node.mNumChildren;
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    append(result, *scene.mMeshes[node.mMeshes[m]], transform, exact, path);
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c) {
    append(result, scene, *node.mChildren[c], transform, exact,
           alike ? &known->children[c] : nullptr, path);
  }
}

Mesh about_origin(Placed placed) {
  std::vector<char> used(placed.positions.size(), 0);
  for (const Triangle& triangle : placed.mesh.triangles) {
    for (const Index v : triangle) used[v] = 1;
  }
  placed.mesh.origin = origin_near(placed.positions, used);
  if (!placed.mesh.origin.isZero(0)) {
    placed.mesh.positions = positions_about(placed.mesh.origin, placed.positions);
  }
  return std::move(placed.mesh);
}

Mesh import(const std::string& path, const GltfNode& root) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path, aiProcess_Triangulate);
  if (!scene || !scene->mRootNode) {
    throw Error(path + ": cannot be read: " + printable(importer.GetErrorString()) +
                "; the file may be damaged or truncated, export it again");
  }
  Placed result;
  append(result, *scene, *scene->mRootNode, aiMatrix4x4(), Eigen::Matrix4d::Identity(), &root,
         path);
  return about_origin(std::move(result));
}

}  // namespace

Mesh read_with_assimp(const std::filesystem::path& path, const GltfNode& root) {
  try {
    return import(path.string(), root);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(path.string() + ": cannot be read: " + printable(error.what()));
  }
}

}  // namespace brindle

#else

namespace brindle {

Mesh read_with_assimp(const std::filesystem::path& path, const GltfNode&) {
  throw Error(path.string() + ": this brindle was built without Assimp, which reads '" +
              path.extension().string() +
              "'; convert the file to PLY, OBJ or OFF, or configure with -DBRINDLE_ASSIMP=ON");
}

}  // namespace brindle

#endif
