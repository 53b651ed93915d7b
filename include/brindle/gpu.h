/// Solvers and frames on OpenGL's device, and buffers for shaders of your own (docs/gpu.md).
#pragma once

#include "brindle/gpu_animator.h"
#include "brindle/gpu_solver.h"
#include "brindle/headless_context.h"
#include "brindle/pattern_buffers.h"
