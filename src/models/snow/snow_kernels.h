// The kernels of sintering snow, by name.
#pragma once

#include "models/snow/snow_bed_kernels.h"
#include "models/snow/snow_flight_kernels.h"
#include "models/snow/snow_weather_kernels.h"

namespace erg::models::snow {

struct Kernels {
#define ERG_KERNEL(family, name) static const compute::KernelOf<Plan> name;
#include "models/snow/snow_kernels.def"
#undef ERG_KERNEL
};

}  // namespace erg::models::snow
