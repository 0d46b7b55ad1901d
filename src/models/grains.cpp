#include "models/grains.h"

#include <atomic>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include "core/units.h"
#include "models/grain_law.h"
#include "models/grain_paths.h"
#include "wind/shadow.h"

namespace erg {
namespace {

constexpr int slide_passes = 8;  // a sub-step; steeper ground goes on sliding in the next

// Draws of a step are told apart by their sweep: a kind for each sub-step.
enum class DrawKind : std::uint64_t { flight, inflow, reptation, abrasion, slide, creep, bond };
std::uint64_t sweep_of(DrawKind kind, int sub_step) {
  return static_cast<std::uint64_t>(sub_step) * 8 + static_cast<std::uint64_t>(kind);
}

GrainDice dice_of(StepKey key, DrawKind kind, int sub_step, std::uint64_t cell, std::uint64_t draw) {
  return {random_word(key, sweep_of(kind, sub_step), cell, draw)};
}

/// What a flight does to the bed.
struct BedWatch {
  GrainBed* bed;
  void at(const Grain&) {}
  void impact(int u, int v, int grains, float speed) { bed->ask(u, v, grains, speed); }
};

/// The cell that poll `poll` of a sub-step asks: one at random of each `sub_steps` cells in a row; none (-1) for the
/// part of the last block that lies beyond the grid.
std::int64_t polled_cell(std::int64_t poll, int sub_steps, std::int64_t cells, GrainDice& dice) {
  const auto inside = static_cast<std::int64_t>(dice.unit() * static_cast<float>(sub_steps));
  const std::int64_t cell = poll * sub_steps + inside;
  return cell < cells ? cell : -1;
}

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

/// One thread's share of the sums.
struct Share {
  FlightSums flights;
  std::int64_t lifts = 0;
  std::int64_t out = 0;
  std::int64_t cut_off = 0;
  std::int64_t travel_micrometres = 0;

  void book(FlightEnd end, const Grain& grain) {
    travel_micrometres += static_cast<std::int64_t>(grain.along * 1e6f);
    out += end == FlightEnd::left ? 1 : 0;
    cut_off += end == FlightEnd::cut_off ? 1 : 0;
  }
};

}  // namespace

/// Sums of one step; threads add their own.
struct GrainModel::Totals {
  std::atomic<std::int64_t> lifts{0};
  std::atomic<std::int64_t> out{0};
  std::atomic<std::int64_t> in{0};
  std::atomic<std::int64_t> cut_off{0};
  std::atomic<std::int64_t> travel_micrometres{0};
  std::atomic<std::int64_t> grain_steps{0};
  std::atomic<std::int64_t> impacts{0};
  std::atomic<std::int64_t> hop_micrometres{0};
  std::atomic<std::int64_t> angle_microradians{0};
  std::atomic<std::int64_t> splashed{0};

  void add(const Share& share) {
    lifts += share.lifts;
    out += share.out;
    cut_off += share.cut_off;
    travel_micrometres += share.travel_micrometres;
    grain_steps += share.flights.grain_steps;
    impacts += share.flights.impacts;
    hop_micrometres += share.flights.hop_micrometres;
    angle_microradians += share.flights.angle_microradians;
    splashed += share.flights.splashed;
  }
};

GrainModel::GrainModel(ParameterValues values) : values_(std::move(values)) {}

double GrainModel::quantum() const { return values_.real("parcel_height") * 1e-3; }

double GrainModel::shadow_fall(double cell_size) const {
  return erg::shadow_fall(values_.real("shadow_angle"), cell_size, quantum());
}

void GrainModel::begin(Terrain& terrain) {
  shelter_.clear();
  for (const FieldInfo& info : grain_fields()) {
    if (find_field(terrain.fields(), info.key) != nullptr) continue;
    const bool plants = info.key == plants_field;
    terrain.edit_fields().push_back(
        {info, plants ? strewn_plants(terrain, values_.integer("plants"), values_.real("plant_diameter"))
                      : Grid<float>(terrain.extent())});
  }
}

void GrainModel::fly_all(const GrainLaw& law, StepKey key, int sub_step, Executor& executor, Totals& totals) {
  const int sub_steps = static_cast<int>(values_.integer("sub_steps"));
  const auto cells = static_cast<std::int64_t>(bed_.cells());
  const FrozenGround ground = bed_.ground();
  Grid<std::int32_t>* const lift_counts = executor.lift_counts();
  executor.for_pieces((cells + sub_steps - 1) / sub_steps, [&](std::int64_t first, std::int64_t last) {
    Share share;
    BedWatch watch{&bed_};
    for (std::int64_t poll = first; poll < last; ++poll) {
      GrainDice dice = dice_of(key, DrawKind::flight, sub_step, static_cast<std::uint64_t>(poll), 0);
      const std::int64_t cell = polled_cell(poll, sub_steps, cells, dice);
      if (cell < 0) continue;
      const int u = static_cast<int>(cell % bed_.width());
      const int v = static_cast<int>(cell / bed_.width());
      Grain grain;
      if (!lift_off(law, ground, u, v, dice, grain)) continue;
      bed_.take(u, v);
      ++share.lifts;
      if (lift_counts != nullptr) ++(*lift_counts)[bed_.terrain_cell(u, v)];
      const FlightEnd end = fly(law, ground, grain, dice, share.flights, watch);
      share.book(end, grain);
      if (end != FlightEnd::left) bed_.give(resting_place(law, ground, grain, dice));
    }
    totals.add(share);
  });
}

// Grains that enter over the upwind edges of an open grid, as if they had just left the ground there.
void GrainModel::let_in(const GrainLaw& law, double inflow, StepKey key, int sub_step, Totals& totals) {
  const FrozenGround ground = bed_.ground();
  BedWatch watch{&bed_};
  Share share;
  const auto enter = [&](int u, int v, std::uint64_t edge) {
    GrainDice dice = dice_of(key, DrawKind::inflow, sub_step, edge, 0);
    const auto count =
        static_cast<int>(inflow / static_cast<double>(values_.integer("sub_steps")) + static_cast<double>(dice.unit()));
    for (int k = 0; k < count; ++k) {
      Grain grain;
      set_off(law, ground, u, v, dice, grain);
      const FlightEnd end = fly(law, ground, grain, dice, share.flights, watch);
      share.book(end, grain);
      if (end != FlightEnd::left) bed_.give(resting_place(law, ground, grain, dice));
    }
    totals.in += count;
  };
  for (int u = 0; u < bed_.width(); ++u) enter(u, 0, static_cast<std::uint64_t>(u));
  if (law.toward_u > 0) {
    for (int v = 1; v < bed_.length(); ++v) enter(0, v, static_cast<std::uint64_t>(bed_.width()) + v);
  }
  totals.add(share);
}

/// Moves grains that impacts knocked loose; one thread's.
struct GrainModel::Hopper {
  const GrainLaw& law;
  FrozenGround ground;
  StepKey key;
  int sub_step;
  GrainBed& bed;
  Totals& totals;
  Share share = {};

  void operator()(int u, int v, int k, float speed) {
    const auto cell = static_cast<std::uint64_t>(v) * static_cast<std::uint64_t>(ground.width) + u;
    GrainDice dice = dice_of(key, DrawKind::reptation, sub_step, cell, static_cast<std::uint64_t>(k));
    Grain grain;
    const bool stays = reptate(law, ground, u, v, speed, dice, grain);
    share.book(stays ? FlightEnd::rested : FlightEnd::left, grain);
    if (stays) bed.give(resting_place(law, ground, grain, dice));
  }
  void finish() { totals.add(share); }
};

void GrainModel::splash(const GrainLaw& law, StepKey key, int sub_step, Executor& executor, Totals& totals) {
  const FrozenGround ground = bed_.ground();
  bed_.splash(executor, key, sweep_of(DrawKind::abrasion, sub_step), values_.real("abrasion"),
              [&] { return Hopper{law, ground, key, sub_step, bed_, totals}; });
}

// Flies some grains of the sub-step once more, over the ground that they saw, and keeps their ways.
void GrainModel::trace_paths(const Terrain& terrain, const WindFrame& frame, const GrainLaw& law, StepKey key,
                             int sub_step) {
  const int sub_steps = static_cast<int>(values_.integer("sub_steps"));
  const auto cells = static_cast<std::int64_t>(bed_.cells());
  const std::int64_t polls = (cells + sub_steps - 1) / sub_steps;
  const FrozenGround ground = bed_.ground();
  PathWatch watch(terrain, frame, bed_.lowest_height());
  FlightSums unused;
  int kept = 0;
  // In strides of the golden section, which visit the grid evenly whatever the number wanted.
  const auto stride = static_cast<std::int64_t>(static_cast<double>(polls) / std::numbers::phi) | 1;
  for (std::int64_t k = 0; k < polls && kept < paths_wanted_; ++k) {
    const std::int64_t poll = k * stride % polls;
    GrainDice dice = dice_of(key, DrawKind::flight, sub_step, static_cast<std::uint64_t>(poll), 0);
    const std::int64_t cell = polled_cell(poll, sub_steps, cells, dice);
    Grain grain;
    if (cell < 0 || !lift_off(law, ground, static_cast<int>(cell % bed_.width()), static_cast<int>(cell / bed_.width()),
                              dice, grain)) {
      continue;
    }
    watch.start();
    fly(law, ground, grain, dice, unused, watch);
    ++kept;
  }
  paths_ = watch.take_paths();
}

/// What plants leave of the wind, worked out anew only where they or the wind's bearing have changed.
const std::vector<float>& GrainModel::shelter(const Terrain& terrain, const WindFrame& frame, double bearing) {
  const Grid<float>& plants = find_field(terrain.fields(), plants_field)->values;
  if (shelter_.empty() || bearing != shelter_bearing_ || plants != shelter_plants_) {
    shelter_ = plant_shelter(values_, terrain, plants, frame);
    shelter_bearing_ = bearing;
    shelter_plants_ = plants;
  }
  return shelter_;
}

StepReport GrainModel::step(Terrain& terrain, const WindNow& wind, StepKey key, Executor& executor) {
  executor.settle(terrain);
  const WindFrame frame = wind_frame(terrain.extent(), wind.bearing);
  const GrainLaw law = grain_law(values_, wind, frame, terrain.cell_size());
  const StandingSteps standing =
      StandingSteps::of_angle(values_.real("repose_angle"), terrain.cell_size(), terrain.quantum());
  const int sub_steps = static_cast<int>(values_.integer("sub_steps"));
  bed_.load(terrain, frame, shadow_fall(terrain.cell_size()), shelter(terrain, frame, wind.bearing));
  paths_.clear();
  Totals totals;
  for (int sub_step = 0; sub_step < sub_steps; ++sub_step) {
    bed_.freeze(executor);
    fly_all(law, key, sub_step, executor, totals);
    if (terrain.inflow() > 0) let_in(law, terrain.inflow(), key, sub_step, totals);
    if (paths_wanted_ > 0 && sub_step + 1 == sub_steps) trace_paths(terrain, frame, law, key, sub_step);
    splash(law, key, sub_step, executor, totals);
    bed_.settle_accounts(executor);
    bed_.slide(executor, standing, slide_passes, key, sweep_of(DrawKind::slide, sub_step));
  }
  if (values_.real("settling") > 0) bed_.creep(executor, values_.real("settling"), key, sweep_of(DrawKind::creep, 0));
  if (values_.real("bonding_time") > 0) {
    const double share = 1 - std::exp(-1 / values_.real("bonding_time"));
    bed_.bond(executor, share, key, sweep_of(DrawKind::bond, 0));
  }
  bed_.store(terrain);
  return report(terrain, totals);
}

StepReport GrainModel::report(Terrain& terrain, const Totals& totals) {
  StepReport report;
  report.polls = static_cast<std::int64_t>(bed_.cells());
  report.lifts = totals.lifts;
  report.travel = static_cast<double>(totals.travel_micrometres) * 1e-6 / terrain.cell_size();
  report.slabs_in = totals.in;
  report.slabs_out = totals.out;
  terrain.ledger().in += totals.in;
  terrain.ledger().out += totals.out;
  flights_ = {totals.grain_steps, totals.impacts, totals.hop_micrometres, totals.angle_microradians, totals.splashed};
  lifts_ = totals.lifts;
  cut_off_ += totals.cut_off;
  return report;
}

std::vector<Reading> GrainModel::readings() const {
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

std::vector<std::string> explain_grains(const ParameterValues& values, double cell_size) {
  const double diameter = values.real("diameter") * 1e-3;
  const double parcel = values.real("parcel_height") * 1e-3;
  constexpr double packing = 0.6;
  const double grain = std::numbers::pi / 6 * diameter * diameter * diameter;
  const int standing = standing_step(values.real("repose_angle"), cell_size, parcel);
  char lines[3][200];
  std::snprintf(lines[0], sizeof lines[0], "a parcel of %g mm on a cell of %g m is about %.0f grains",
                values.real("parcel_height"), cell_size, packing * cell_size * cell_size * parcel / grain);
  std::snprintf(lines[1], sizeof lines[1],
                "grains lift from a friction velocity of %.3f m/s on (%.1f m/s at a height of %g m)",
                lifting_threshold(values, diameter),
                profile_speed(values, lifting_threshold(values, diameter), values.real("wind_height")),
                values.real("wind_height"));
  std::snprintf(lines[2], sizeof lines[2],
                "repose %g deg: a step of %d parcel%s (%.1f deg) stands, a larger one slides",
                values.real("repose_angle"), standing, standing == 1 ? "" : "s",
                degrees(std::atan(standing * parcel / cell_size)));
  return {lines[0], lines[1], lines[2]};
}

}  // namespace

ModelType grains() {
  return {{.key = "grains",
           .title = "Wang & Hu 2012",
           .citation = "Wang, Z.-S. & Hu, R. (2012), after the accounts of Szabo (2019, ch. 3) and Cimbura (2022, sec. "
                       "4.3 and 5.11); wind in the saltation layer after Bagnold (1941), splash ours.",
           .makes = "ripples of sand and snow, a few centimetres long, on flat ground, over dunes, round plants",
           .leaves_out = "turbulence, speed-up of the wind over a hill, sorting of grains by size, time in seconds",
           .step = "one step polls as many grains as the grid has cells",
           .strength_label = "wind speed at wind_height, m/s (or friction velocity, m/s: see strength_is)"},
          grain_parameters(),
          grain_fields(),
          [](const ParameterValues& values) { return std::make_unique<GrainModel>(values); },
          explain_grains};
}

}  // namespace erg
