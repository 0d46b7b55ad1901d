// What the declared parameters of the grain model mean in numbers for one wind: the tables that the rules of a grain
// read.
#pragma once

#include "forcing/wind_frame.h"
#include "forcing/wind_schedule.h"
#include "models/grains/grain_cell.h"
#include "models/grains/grain_values.h"

namespace erg::models {

/// The friction velocity (m/s) from which the wind lifts grains of this diameter (m): Shao & Lu 2000, eq. 24, times the
/// ratio of the threshold under impacts to that of the air alone.
double lifting_threshold(const GrainValues& values, double diameter);

/// The friction velocity (m/s) of a wind of this strength, as `strength_is` says. Above the threshold the profile is
/// the one that flying grains leave (Bagnold's focus): log profiles of all winds meet at the focus height.
double friction_velocity(const GrainValues& values, double strength);

/// Wind speed (m/s) at a height (m) over open ground under this friction velocity.
double profile_speed(const GrainValues& values, double friction_velocity, double height);

/// Mean way (m) on level ground of a grain that an impact of 1 m/s knocks loose under this friction velocity (m/s):
/// linear in it above the threshold of the median grain, up to ten times that. Fitted so that ripples of young beds
/// lengthen with the wind as Andreotti, Claudin & Pouliquen (2006) measured, who found lengths linear in the friction
/// velocity.
double reptation(const GrainValues& values, double friction_velocity);

/// The law for one wind on a grid with cells of this size (m).
GrainLaw grain_law(const GrainValues& values, const forcing::Forcing& wind, const forcing::WindFrame& frame,
                   double cell_size);

}  // namespace erg::models
