// Instant Meshes' tree of boxes is built by TBB's old tasks. It serves points without triangles,
// and the extracted mesh, neither of which is measured: whoever asks for it is stopped.

#include "bvh.h"

#include <stdexcept>

namespace {

[[noreturn]] void stop() { throw std::logic_error("this build has no tree of boxes"); }

}  // namespace

BVH::BVH(const MatrixXu* F, const MatrixXf* V, const MatrixXf* N, const AABB& /*box*/)
    : mIndices(nullptr), mF(F), mV(V), mN(N), mDiskRadius(0) {
  stop();
}

BVH::~BVH() = default;

void BVH::findKNearest(const Vector3f& /*p*/, const Vector3f& /*N*/, uint32_t /*k*/,
                       Float& /*radius*/, std::vector<std::pair<Float, uint32_t>>& /*result*/,
                       Float /*angleThresh*/, bool /*includeSelf*/) const {
  stop();
}

void BVH::findKNearest(const Vector3f& /*p*/, uint32_t /*k*/, Float& /*radius*/,
                       std::vector<std::pair<Float, uint32_t>>& /*result*/,
                       bool /*includeSelf*/) const {
  stop();
}
