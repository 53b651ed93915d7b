#include "brindle/files/assimp_file.h"

#include <string>

#include "brindle/error.h"

#ifdef BRINDLE_HAS_ASSIMP

#include <exception>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

namespace brindle {
namespace {

void append(Mesh& mesh, const aiMesh& part, const aiMatrix4x4& transform, const std::string& path) {
  if (mesh.vertex_count() + part.mNumVertices > 0xfffffffe) {
    throw Error(path + ": has more vertices than brindle can number; split it into parts");
  }
  const auto first = static_cast<Index>(mesh.vertex_count());
  const bool identity = transform.IsIdentity();
  for (unsigned v = 0; v < part.mNumVertices; ++v) {
    // An identity must not cost the last bit of a coordinate.
    const aiVector3D p = identity ? part.mVertices[v] : transform * part.mVertices[v];
    mesh.positions.push_back({p.x, p.y, p.z});
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

void append(Mesh& mesh, const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent,
            const std::string& path) {
  const aiMatrix4x4 transform = parent * node.mTransformation;
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    append(mesh, *scene.mMeshes[node.mMeshes[m]], transform, path);
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c) {
    append(mesh, scene, *node.mChildren[c], transform, path);
  }
}

Mesh import(const std::string& path) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path, aiProcess_Triangulate);
  if (!scene || !scene->mRootNode) {
    throw Error(path + ": cannot be read: " + importer.GetErrorString() +
                "; the file may be damaged or truncated, export it again");
  }
  Mesh mesh;
  append(mesh, *scene, *scene->mRootNode, aiMatrix4x4(), path);
  return mesh;
}

}  // namespace

Mesh read_with_assimp(const std::filesystem::path& path) {
  try {
    return import(path.string());
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(path.string() + ": cannot be read: " + error.what());
  }
}

}  // namespace brindle

#else

namespace brindle {

Mesh read_with_assimp(const std::filesystem::path& path) {
  throw Error(path.string() + ": this brindle was built without Assimp, which reads '" +
              path.extension().string() +
              "'; convert the file to PLY, OBJ or OFF, or configure with -DBRINDLE_ASSIMP=ON");
}

}  // namespace brindle

#endif
