// What the parameters of sintering snow say, as a plain struct.
#pragma once

#include "core/binding.h"
#include "models/snow/snow_step.h"

namespace erg::models {

/// The values of the parameters of sintering snow, each under its key and in its unit: their declarations say what they
/// mean.
struct SinteringValues {
  double slab_height = 0;      ///< m
  double time_step = 0;        ///< s
  double roughness = 0;        ///< mm
  double air_density = 0;      ///< kg/m3
  double speed_by_height = 0;  ///< 1/m
  double speed_by_slope = 0;
  double smooth_radius = 0;  ///< m
  double around_radius = 0;  ///< m
  double shadow_angle = 0;   ///< deg
  double hop_factor = 0;
  double clearance = 0;  ///< m
  double rest_loose = 0;
  double rest_hard = 0;
  double rest_ground = 0;
  double ageing = 0;        ///< m/s
  double repose_angle = 0;  ///< deg
  bool obstacles = false;
  double suspension = 0;
  double suspension_wind = 0;  ///< m/s
  double snowfall = 0;         ///< mm/h
  double bonding_time = 0;     ///< h
  double bonding_warmth = 0;   ///< 1/K
  double start_age = 0;        ///< h
  double abrasion = 0;
  double entrainment = 0;    ///< 1/h
  double impact_angle = 0;   ///< deg
  double bonded_spread = 0;  ///< m/s
  double hardening = 0;
  StrengthPattern strength = StrengthPattern::even;
  double contrast = 0;
  double patch_length = 0;     ///< m
  double layer_thickness = 0;  ///< m
};

/// The declarations of all of them.
const Binding<SinteringValues>& sintering_binding();

}  // namespace erg::models
