// The entries on a graphics card of all kernels that the models list.
#pragma once

#include "compute/kernel.h"

namespace erg::sim {

/// The __global__ function of a kernel; null for one that no model lists, and where Erg was built without CUDA.
const void* cuda_entry(const compute::Kernel& kernel);

}  // namespace erg::sim
