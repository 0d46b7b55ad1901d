// The kernels of sintering snow, by name.
#pragma once

#include "transport/snow_bed_kernels.h"
#include "transport/snow_flight_kernels.h"
#include "transport/snow_weather_kernels.h"

namespace erg::snow {

struct Kernels {
#define ERG_KERNEL(family, name) static const KernelOf<Plan> name;
#include "transport/snow_kernels.def"
#undef ERG_KERNEL
};

}  // namespace erg::snow
