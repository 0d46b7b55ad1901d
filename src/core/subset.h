// How the files .k read as C++ and as CUDA: rules of cells and kernels, written in a subset of C++ that a compiler of
// OpenGL's shaders (GLSL 4.30) takes too (CONTRIBUTING.md, "Kernels"). compute/subset.glsl says the same for GLSL.
#pragma once

#include <cstdint>

#include "core/cell_rule.h"

/// A constant.
#define ERG_CONST(type, name, value) inline constexpr type name = value

namespace erg {

using u32 = std::uint32_t;
using i32 = std::int32_t;

/// The upper 32 bits of the product, which has 64.
ERG_CELL_RULE u32 high_product(u32 a, u32 b) {
  return static_cast<u32>((static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b)) >> 32);
}

}  // namespace erg
