// Which kernel a name means, for the device and for its emulation in tests.
#pragma once

#include "cuda/device_calls.h"
#include "cuda/flight_kernels.h"
#include "cuda/layout_kernels.h"
#include "cuda/shadow_kernel.h"
#include "cuda/slide_kernels.h"

namespace erg::ERG_KERNEL_SPACE {

using KernelFunction = void (*)(DevicePlan);

inline KernelFunction kernel_of(DeviceKernel kernel) {
  switch (kernel) {
    case DeviceKernel::lay_surface:
      return lay_surface;
    case DeviceKernel::lay_bedrock:
      return lay_bedrock;
    case DeviceKernel::lay_cover:
      return lay_cover;
    case DeviceKernel::show_surface:
      return show_surface;
    case DeviceKernel::stage_surface:
      return stage_surface;
    case DeviceKernel::stage_bedrock:
      return stage_bedrock;
    case DeviceKernel::count_heights:
      return count_heights;
    case DeviceKernel::fill_hop_table:
      return fill_hop_table;
    case DeviceKernel::cast_shadow:
      return cast_shadow;
    case DeviceKernel::let_in:
      return let_in;
    case DeviceKernel::lift:
      return lift;
    case DeviceKernel::carry:
      return carry;
    case DeviceKernel::slide_tiles:
      return slide_tiles;
    case DeviceKernel::slide_row_seams:
      return slide_row_seams;
    case DeviceKernel::slide_column_seams:
      return slide_column_seams;
    case DeviceKernel::slide_corners:
      return slide_corners;
  }
  return nullptr;
}

}  // namespace erg::ERG_KERNEL_SPACE
