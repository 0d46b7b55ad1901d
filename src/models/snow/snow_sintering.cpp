#include "models/snow/snow_sintering.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "core/constants.h"
#include "core/units.h"
#include "kernels/shadow.h"
#include "models/model.h"
#include "models/snow/sintering_values.h"
#include "models/snow/snow_solver.h"
#include "models/snow/snow_step.h"
#include "models/snow/snow_step_random.h"

namespace erg::models {

using compute::Executor;
using forcing::Forcing;

namespace {

constexpr double wind_height = 10;  // m
constexpr double seconds_per_hour = 3600;
constexpr double loose_density = 250;  // kg/m3, of snow that the wind has packed

constexpr std::uint64_t strength_every = 16;  // steps: the layer is for people only

std::vector<FieldInfo> snow_sintering_fields() {
  return {{"loose", "loose snow", "slabs", 0, 100, "cividis", "Slabs on top that have not bonded."},
          {"bonded", "bonded snow", "slabs", 0, 1000, "cividis", "Slabs that have bonded."},
          {"age", "age of bonded snow", "h", 0, 240, "batlow", "Mean time since the bonded snow came to rest."},
          {"landed", "last landing", "h", -240, 240, "batlow", "When a slab last came down here, since the beginning."},
          {"strength", "strength", "", 0, 3, "batlow",
           "Of the uppermost bonded snow; 1 is the mean. Written every 16 steps."}};
}

/// Li & Pomeroy 1997: mean threshold of dry snow at 10 m, m/s.
double mean_threshold(double temperature) { return 9.43 + 0.18 * temperature + 0.0033 * temperature * temperature; }

double bonding_hours(const SinteringValues& values, double temperature) {
  return values.bonding_time * std::exp(-values.bonding_warmth * (temperature + 10));
}

double friction(const SinteringValues& values) { return karman / std::log(wind_height / (values.roughness / 1000)); }

double hop_metres(const SinteringValues& values, double wind) {
  return values.hop_factor * 0.0844 * std::pow(friction(values) * wind, 1.27);
}

template <typename Function>
void fill(OctaveTable& table, const Function& function) {
  for (int k = 0; k <= 8 * OctaveTable::octaves; ++k) {
    const double x = std::ldexp(1 + (k % 8) / 8.0, OctaveTable::lowest_octave + k / 8);
    table.values[k] = static_cast<float>(function(x));
  }
}

std::vector<std::string> explain_sintering(const SinteringValues& values, double cell_size) {
  char loose_snow[160], hop[160];
  std::snprintf(loose_snow, sizeof loose_snow,
                "at -10 °C loose snow an hour old lifts from %.1f m/s on; bonding takes %.1f h", mean_threshold(-10),
                bonding_hours(values, -10));
  std::snprintf(hop, sizeof hop, "a hop in a wind of 10 m/s: %.2f m, %.1f cells", hop_metres(values, 10),
                hop_metres(values, 10) / cell_size);
  return {loose_snow, hop};
}

class SnowSintering : public Model {
 public:
  explicit SnowSintering(const SinteringValues& values) : values_(values) {}

  double quantum() const override { return values_.slab_height; }
  double shadow_fall(double cell_size) const override {
    return erg::kernels::shadow_fall(values_.shadow_angle, cell_size, quantum());
  }
  void prepare(const InitContext& context) override {
    seed_ = context.seed;
    first_temperature_ = context.weather.temperature;
  }
  void begin(Terrain& terrain) override;
  StepReport step(Terrain& terrain, const Forcing& wind, StepKey key, Executor& executor) override;

 private:
  void prepare_law(const Terrain& terrain);
  void update_law(const Forcing& wind, StepKey key);
  static int cells(double metres, double cell_size) {
    return std::clamp(static_cast<int>(std::lround(metres / cell_size)), 0, 200);
  }

  SinteringValues values_;
  std::uint64_t seed_ = 0;
  double first_temperature_ = -10;
  SnowLaw law_;
};

void SnowSintering::begin(Terrain& terrain) {
  prepare_law(terrain);
  if (!terrain.fields().empty()) return;  // snow that grew too high on the way stays what it is
  const auto bedrock = std::ranges::minmax(terrain.bedrock().cells());
  check_snow_height(std::ranges::max(terrain.mobile().cells()), bedrock.max - bedrock.min);
  std::vector<Field>& fields = terrain.edit_fields();
  for (FieldInfo& info : snow_sintering_fields()) fields.push_back({std::move(info), Grid<float>(terrain.extent())});
  const double hours = values_.start_age;
  const double share = 1 - std::exp(-hours / bonding_hours(values_, first_temperature_));
  const auto layer = [&](SnowLayer which) -> Grid<float>& { return snow_layer(fields, which); };
  for (std::size_t cell = 0; cell < terrain.extent().cells(); ++cell) {
    const double hard = std::floor(terrain.mobile()[cell] * share + 0.5);
    layer(SnowLayer::bonded)[cell] = static_cast<float>(hard);
    layer(SnowLayer::loose)[cell] = static_cast<float>(terrain.mobile()[cell] - hard);
    layer(SnowLayer::age)[cell] = hard > 0 ? static_cast<float>(hours) : 0.0f;
    layer(SnowLayer::landed)[cell] = static_cast<float>(-hours);
    const int x = static_cast<int>(cell % static_cast<std::size_t>(terrain.nx()));
    const int y = static_cast<int>(cell / static_cast<std::size_t>(terrain.nx()));
    layer(SnowLayer::strength)[cell] = snow_strength(law_, x, y, static_cast<int>(hard));
  }
}

/// What does not change over the run: tables and scales.
void SnowSintering::prepare_law(const Terrain& terrain) {
  const double cell_size = terrain.cell_size();
  law_ = {};
  law_.speed_by_height = static_cast<float>(values_.speed_by_height * quantum());
  law_.speed_by_slope = static_cast<float>(values_.speed_by_slope);
  law_.friction = static_cast<float>(friction(values_));
  law_.hop_cells = static_cast<float>(values_.hop_factor / cell_size);
  law_.clearance_16 = static_cast<int>(std::min(16 * values_.clearance / quantum() + 0.5, 2.0 * highest_over));
  law_.rest_loose = static_cast<float>(values_.rest_loose);
  law_.rest_hard = static_cast<float>(values_.rest_hard);
  law_.rest_ground = static_cast<float>(values_.rest_ground);
  const double saltation = 0.68 * values_.air_density / earth_gravity / loose_density;
  law_.lift_scale = static_cast<float>(saltation * values_.time_step * values_.rest_loose / (quantum() * cell_size));
  law_.critical_step = critical_step(values_.repose_angle, cell_size, quantum());
  law_.wall = values_.obstacles ? law_.critical_step : std::numeric_limits<int>::max();
  law_.abrasion = static_cast<float>(values_.abrasion);
  law_.entrainment = static_cast<float>(values_.entrainment * values_.time_step / seconds_per_hour);
  law_.sine = static_cast<float>(std::sin(radians(values_.impact_angle)));
  law_.cosine = static_cast<float>(std::cos(radians(values_.impact_angle)));
  law_.slope_scale = static_cast<float>(quantum() / cell_size);
  law_.step_hours = static_cast<float>(values_.time_step / seconds_per_hour);
  law_.pattern = values_.strength;
  law_.noise_word = mix64(seed_ ^ 0x73746167u);
  law_.noise_columns = std::max(1, static_cast<int>(std::lround(terrain.nx() * cell_size / values_.patch_length)));
  law_.noise_rows = std::max(1, static_cast<int>(std::lround(terrain.ny() * cell_size / values_.patch_length)));
  law_.noise_by_column = static_cast<float>(law_.noise_columns) / static_cast<float>(terrain.nx());
  law_.noise_by_row = static_cast<float>(law_.noise_rows) / static_cast<float>(terrain.ny());
  law_.noise_by_slab = static_cast<float>(quantum() / values_.layer_thickness);
  for (int k = 0; k <= 256; ++k) {
    law_.strength_table[k] = static_cast<float>(std::pow(values_.contrast, k / 128.0 - 1));
  }
  fill(law_.age_threshold, [this](double hours) { return values_.ageing * std::log(hours); });
  fill(law_.hop, [](double friction_velocity) { return 0.0844 * std::pow(friction_velocity, 1.27); });
  fill(law_.hardening, [this](double hours) { return std::pow(hours, values_.hardening); });
}

/// What a step's weather changes.
void SnowSintering::update_law(const Forcing& wind, StepKey key) {
  law_.wind = static_cast<float>(wind.strength);
  law_.threshold = static_cast<float>(mean_threshold(wind.temperature));
  const double excess = wind.strength / values_.suspension_wind;
  law_.suspension = static_cast<float>(std::clamp(values_.suspension * (excess * excess - 1), 0.0, 1.0));
  law_.bonded_threshold = law_.threshold + static_cast<float>(values_.bonded_spread);
  law_.bonding = static_cast<float>(
      std::min(1.0, static_cast<double>(law_.step_hours) / bonding_hours(values_, wind.temperature)));
  law_.now = static_cast<float>(static_cast<double>(key.step + 1) * values_.time_step / seconds_per_hour);
  const double fall = (values_.snowfall + wind.snowfall) / 1000;  // m/h
  law_.snowfall = static_cast<float>(fall * static_cast<double>(law_.step_hours) / quantum());
}

StepReport SnowSintering::step(Terrain& terrain, const Forcing& wind, StepKey key, Executor& executor) {
  update_law(wind, key);
  const double cell_size = terrain.cell_size();
  const SnowRadii radii{cells(values_.smooth_radius, cell_size), std::max(1, cells(values_.around_radius, cell_size))};
  const bool shows_strength = (key.step + 1) % strength_every == 0;
  return drift_snow(executor, terrain, {law_, radii, shadow_fall(cell_size), shows_strength}, wind, key);
}

std::vector<BenchScene> bench_scenes() {
  const std::vector<std::string> waves{"grid.cell_size=0.1", "scene.sand=40", "wind.strength=12"};
  return {{.name = "waves", .steps = 120, .settings = waves},
          {.name = "oblique wind", .steps = 120, .oblique = true, .settings = waves},
          {.name = "sastrugi",
           .steps = 160,
           .settings = {"grid.cell_size=0.05", "scene.sand=120", "parameters.slab_height=0.0025",
                        "parameters.time_step=30", "parameters.start_age=60", "wind.strength=22"}}};
}

}  // namespace

ModelType snow_sintering() {
  return ModelOf<SinteringValues>{
      .info = {.key = "snow_sintering",
               .title = "Sintering snow",
               .citation =
                   "our own, on Filhol & Sturm (2015), JGR Earth Surface 120, 1645-1669, and Li & Pomeroy (1997), "
                   "JGR Atmospheres 102, 21955-21967",
               .produces = "snow waves, snow barchans, sastrugi, flat crust",
               .limitations = "melting, air flow, ripples of single grains, clouds of suspended snow",
               .step = "time_step seconds",
               .strength_label = "wind at 10 m, m/s",
               .material = Material::snow,
               .start = {.cell_size = 0.1, .strength = 11, .sand = 6},
               .channels = {"temperature", "snowfall"},
               .bench_scenes = bench_scenes()},
      .parameters = sintering_binding(),
      .fields = snow_sintering_fields(),
      .working_bytes = 29,  // planes and polls of SnowOnProcessor
      .make = [](const SinteringValues& values) { return std::make_unique<SnowSintering>(values); },
      .explain = explain_sintering,
      .step_scale =
          [](const SinteringValues& values, double, double) {
            return StepScale{values.time_step, 0};
          }};
}

}  // namespace erg::models
