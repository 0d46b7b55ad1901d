#include "models/grains/grains.h"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include "core/units.h"
#include "kernels/shadow.h"
#include "models/grains/grain_bed_cell.h"
#include "models/grains/grain_law.h"
#include "models/grains/plant_wakes.h"
#include "models/grains/trajectory_watch.h"

namespace erg::models {

using forcing::Forcing;
using forcing::WindFrame;

namespace {

std::vector<FieldInfo> grain_fields() {
  return {{plants_field, "Plants", "", 0, 1, "vegetation",
           "Share of the cell that plants cover: they shelter it and what "
           "lies behind."},
          {bonded_field, "Bonded grains", "parcels", 0, 40, "cividis",
           "Grains of the cell that have bonded and can be "
           "freed by impacts only."}};
}

// Discs of cover around points that fill the plane evenly: Roberts' R2 sequence.
Grid<float> strewn_plants(const Terrain& terrain, std::int64_t plants, double diameter) {
  constexpr double plastic = 1.32471795724474602596;
  Grid<float> cover(terrain.extent());
  const double radius = std::max(0.5, 0.5 * diameter / terrain.cell_size());
  const int reach = static_cast<int>(std::ceil(radius)) + 1;
  for (std::int64_t plant = 0; plant < plants; ++plant) {
    const double x = std::fmod(0.5 + static_cast<double>(plant) / plastic, 1.0) * terrain.nx();
    const double y = std::fmod(0.5 + static_cast<double>(plant) / (plastic * plastic), 1.0) * terrain.ny();
    for (int row = static_cast<int>(y) - reach; row <= static_cast<int>(y) + reach; ++row) {
      for (int column = static_cast<int>(x) - reach; column <= static_cast<int>(x) + reach; ++column) {
        if (std::hypot(column + 0.5 - x, row + 0.5 - y) > radius) continue;
        const bool inside = column >= 0 && column < terrain.nx() && row >= 0 && row < terrain.ny();
        if (!inside && terrain.boundary() == Boundary::open) continue;
        cover(wrap(column, terrain.nx()), wrap(row, terrain.ny())) = 1;
      }
    }
  }
  return cover;
}

}  // namespace

GrainModel::GrainModel(const GrainValues& values) : values_(values) {}

double GrainModel::quantum() const { return values_.parcel_height * 1e-3; }

double GrainModel::shadow_fall(double cell_size) const {
  return erg::kernels::shadow_fall(values_.shadow_angle, cell_size, quantum());
}

void GrainModel::begin(Terrain& terrain) {
  shelter_.reset();
  for (const FieldInfo& info : grain_fields()) {
    if (find_field(terrain.fields(), info.key) != nullptr) continue;
    const bool plants = info.key == plants_field;
    terrain.edit_fields().push_back({info, plants ? strewn_plants(terrain, values_.plants, values_.plant_diameter)
                                                  : Grid<float>(terrain.extent())});
  }
}

// Flies some grains of the last sub-step once more, over the ground that they saw, and keeps their ways.
void GrainModel::trace_trajectories(const Terrain& terrain, const WindFrame& frame, const GrainStepLaw& law,
                                    StepKey key, const SurfaceSnapshot& ground) {
  const auto cells = static_cast<std::int64_t>(terrain.extent().cells());
  const GrainMoment last{key, law.sub_steps - 1, law.sub_steps};
  const std::int64_t polls = polls_of(last, cells);
  TrajectoryWatch watch(terrain, frame, ground.base);
  FlightCounters unused;
  int kept = 0;
  // In strides of the golden section, which visit the grid evenly whatever the number wanted.
  const auto stride = static_cast<std::int64_t>(static_cast<double>(polls) / std::numbers::phi) | 1;
  for (std::int64_t k = 0; k < polls && kept < trajectories_wanted_; ++k) {
    const std::int64_t poll = k * stride % polls;
    GrainDice dice = last.dice(GrainDraw::flight, poll, 0);
    const std::int64_t cell = polled_cell(last, poll, cells, dice);
    Grain grain;
    if (cell < 0 || !lift_off(law.grain, ground, static_cast<int>(cell % ground.width),
                              static_cast<int>(cell / ground.width), dice, grain)) {
      continue;
    }
    watch.start();
    fly(law.grain, ground, grain, dice, unused, watch);
    ++kept;
  }
  trajectories_ = watch.take_trajectories();
}

/// What plants leave of the wind, worked out anew only where they or the wind's bearing have changed.
std::shared_ptr<const std::vector<float>> GrainModel::shelter(const Terrain& terrain, const WindFrame& frame,
                                                              double bearing) {
  const bool same_fields = shelter_ != nullptr && shelter_fields_ == terrain.fields_stamp();
  shelter_fields_ = terrain.fields_stamp();
  if (same_fields && bearing == shelter_bearing_) return shelter_;
  const Grid<float>& plants = find_field(terrain.fields(), plants_field)->values;
  if (shelter_ == nullptr || bearing != shelter_bearing_ || plants != shelter_plants_) {
    shelter_ = std::make_shared<const std::vector<float>>(plant_shelter(values_, terrain, plants, frame));
    shelter_bearing_ = bearing;
    shelter_plants_ = plants;
  }
  return shelter_;
}

GrainStepLaw GrainModel::step_law(const Terrain& terrain, const WindFrame& frame, const Forcing& wind) {
  GrainStepLaw law;
  law.grain = grain_law(values_, wind, frame, terrain.cell_size());
  law.sub_steps = static_cast<int>(values_.sub_steps);
  law.shadow_fall = shadow_fall(terrain.cell_size());
  law.repose = ReposeSteps::of_angle(values_.repose_angle, terrain.cell_size(), terrain.quantum());
  law.abrasion = values_.abrasion;
  law.settling = values_.settling;
  if (values_.bonding_time > 0) law.bonding = 1 - std::exp(-1 / values_.bonding_time);
  law.shelter = shelter(terrain, frame, wind.bearing);
  return law;
}

StepReport GrainModel::step(Terrain& terrain, const Forcing& wind, StepKey key, compute::Executor& executor) {
  const WindFrame frame = forcing::wind_frame(terrain.extent(), wind.bearing);
  const GrainStepLaw law = step_law(terrain, frame, wind);
  GroundLook look;
  if (trajectories_wanted_ > 0) {
    look = [&](const SurfaceSnapshot& ground) { trace_trajectories(terrain, frame, law, key, ground); };
  }
  trajectories_.clear();
  const GrainReport report = fly_grains(executor, terrain, law, wind, key, look);
  flights_ = report.flights;
  lifts_ = report.step.lifts;
  cut_off_ += report.cut_off;
  return report.step;
}

std::vector<Diagnostic> GrainModel::diagnostics() const {
  const double impacts = flights_.impacts > 0 ? static_cast<double>(flights_.impacts) : 1;
  const double lifts = lifts_ > 0 ? static_cast<double>(lifts_) : 1;
  return {
      {"hop", "Mean leap from ground to ground", "m", static_cast<double>(flights_.hop_micrometres) * 1e-6 / impacts},
      {"flight", "Mean way of a grain until it rests", "m",
       static_cast<double>(flights_.hop_micrometres) * 1e-6 / lifts},
      {"impact_angle", "Impact angle", "deg",
       degrees(static_cast<double>(flights_.angle_microradians) * 1e-6 / impacts)},
      {"impacts_a_flight", "Impacts a flight", "", static_cast<double>(flights_.impacts) / lifts},
      {"splash_an_impact", "Grains loosened by an impact", "", static_cast<double>(flights_.splashed) / impacts},
      {"grain_steps", "Time steps of all grains", "", static_cast<double>(flights_.grain_steps)},
      {"cut_off", "Flights cut off so far", "", static_cast<double>(cut_off_)}};
}

namespace {

std::vector<std::string> explain_grains(const GrainValues& values, double cell_size) {
  const double diameter = values.diameter * 1e-3;
  const double parcel = values.parcel_height * 1e-3;
  constexpr double packing = 0.6;
  const double grain = std::numbers::pi / 6 * diameter * diameter * diameter;
  const int critical = critical_step(values.repose_angle, cell_size, parcel);
  char lines[3][200];
  std::snprintf(lines[0], sizeof lines[0], "a parcel of %g mm on a cell of %g m is about %.0f grains",
                values.parcel_height, cell_size, packing * cell_size * cell_size * parcel / grain);
  std::snprintf(lines[1], sizeof lines[1],
                "grains lift from a friction velocity of %.3f m/s on (%.1f m/s at a height of %g m)",
                lifting_threshold(values, diameter),
                profile_speed(values, lifting_threshold(values, diameter), values.wind_height), values.wind_height);
  std::snprintf(lines[2], sizeof lines[2], "repose %g°: a step of %d parcel%s (%.1f°) stands, a larger one slides",
                values.repose_angle, critical, critical == 1 ? "" : "s",
                degrees(std::atan(critical * parcel / cell_size)));
  return {lines[0], lines[1], lines[2]};
}

}  // namespace

ModelType grains() {
  return ModelOf<GrainValues>{
      .info = {.key = "grains",
               .title = "Wang & Hu 2012",
               .citation =
                   "Wang, N. & Hu, B.-G. (2012). Real-time simulation of aeolian sand movement and sand ripple "
                   "evolution: a method based on the physics of blown sand. Journal of Computer Science and "
                   "Technology 27, 135-146; after the accounts of Szabo (2019, ch. 3) and Cimbura (2022, sec. 4.3 "
                   "and 5.11). Wind in the saltation layer after Bagnold (1941), splash ours.",
               .produces = "ripples of sand and snow, about a decimetre long, on flat ground, over dunes, round plants",
               .limitations =
                   "turbulence, speed-up of the wind over a hill, sorting of grains by size, time in seconds",
               .step = "one step polls as many grains as the grid has cells",
               .strength_label = "wind speed at wind_height, m/s (or friction velocity, m/s: see strength_is)",
               .start = {.cell_size = 0.01, .strength = 10, .sand = 200},
               .painted = {plants_field},
               .moves_grains = true},
      .parameters = grain_binding(),
      .fields = grain_fields(),
      .working_bytes = 64,  // the frozen ground, counts and sums of GrainBed, shelter behind plants
      .make = [](const GrainValues& values) { return std::make_unique<GrainModel>(values); },
      .explain = explain_grains};
}

}  // namespace erg::models
