// Which kernel a name means, for the device and for its emulation in tests.
#pragma once

#include "cuda/device_calls.h"
#include "cuda/flight_kernels.h"
#include "cuda/grain_kernels.h"
#include "cuda/layout_kernels.h"
#include "cuda/shadow_kernel.h"
#include "cuda/slide_kernels.h"
#include "cuda/snow_bed_kernels.h"
#include "cuda/snow_flight_kernels.h"
#include "cuda/snow_weather_kernels.h"

namespace erg::ERG_KERNEL_SPACE {

using KernelFunction = void (*)(DevicePlan);
using LayerKernelFunction = void (*)(LayerPlan);
using GrainKernelFunction = void (*)(GrainPlan);
using SnowKernelFunction = void (*)(SnowPlan);

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

inline LayerKernelFunction kernel_of(LayerKernel kernel) {
  return kernel == LayerKernel::lay ? lay_layer : stage_layer;
}

inline GrainKernelFunction kernel_of(GrainKernel kernel) {
  switch (kernel) {
    case GrainKernel::freeze:
      return grain_freeze;
    case GrainKernel::shadow:
      return grain_shadow;
    case GrainKernel::rim:
      return grain_rim;
    case GrainKernel::fly:
      return grain_fly;
    case GrainKernel::let_in:
      return grain_let_in;
    case GrainKernel::hand_out:
      return grain_hand_out;
    case GrainKernel::settle_accounts:
      return grain_settle_accounts;
    case GrainKernel::slide:
      return grain_slide;
    case GrainKernel::creep:
      return grain_creep;
    case GrainKernel::bond:
      return grain_bond;
  }
  return nullptr;
}

inline SnowKernelFunction kernel_of(SnowKernel kernel) {
  switch (kernel) {
    case SnowKernel::measure:
      return snow_measure;
    case SnowKernel::sum_heights:
      return snow_sum_heights;
    case SnowKernel::sum_columns:
      return snow_sum_columns;
    case SnowKernel::sum_rows:
      return snow_sum_rows;
    case SnowKernel::average_rows:
      return snow_average_rows;
    case SnowKernel::shadow:
      return snow_cast_shadow;
    case SnowKernel::weather:
      return snow_make_weather;
    case SnowKernel::find_walls:
      return snow_find_walls;
    case SnowKernel::find_runs:
      return snow_find_runs;
    case SnowKernel::fly:
      return snow_fly;
    case SnowKernel::bring_down:
      return snow_bring_down;
    case SnowKernel::store:
      return snow_store;
    case SnowKernel::slide:
      return snow_slide;
    case SnowKernel::fall:
      return snow_fall;
    case SnowKernel::rest:
      return snow_rest;
    case SnowKernel::show_strength:
      return snow_show_strength;
  }
  return nullptr;
}

}  // namespace erg::ERG_KERNEL_SPACE
