#include "models/snow_sintering.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "core/constants.h"
#include "core/units.h"
#include "models/model.h"
#include "transport/snow_step.h"
#include "wind/shadow.h"

namespace erg {
namespace {

constexpr double wind_height = 10;  // m
constexpr double seconds_per_hour = 3600;
constexpr double loose_density = 250;  // kg/m3, of snow that the wind has packed

constexpr std::uint64_t strength_every = 16;  // steps: the layer is for people only

constexpr const char* ours = "our own";
constexpr const char* tuned = "our own, fitted on pictures";

Parameters wind_parameters() {
  return {real_parameter("roughness", "Roughness length", "mm", 0.24, 0.001, 100,
                         "Of the snow: friction velocity = 0.4 U / ln(10 m / z0).", "Pomeroy & Gray 1990"),
          real_parameter("air_density", "Density of air", "kg/m3", 1.3, 0.1, 3, "Of the air that drives the flux."),
          real_parameter("speed_by_height", "Speed-up by height", "1/m", 3, 0, 100,
                         "How much faster the wind is for each metre that the smoothed surface stands over its "
                         "surroundings.",
                         tuned),
          real_parameter("speed_by_slope", "Speed-up by slope", "", 4, 0, 100,
                         "How much faster the wind is for a slope (rise over run, at most 0.1) that rises along it.",
                         tuned),
          real_parameter("smooth_radius", "Smoothing", "m", 0.3, 0, 100,
                         "Half width of the boxes that smooth the surface.", tuned),
          real_parameter("around_radius", "Surroundings", "m", 1, 0.001, 1000,
                         "Half width of the square over which heights are compared.", tuned),
          real_parameter("shadow_angle", "Shadow angle", "deg", 15, 1, 80,
                         "Angle of the shadow line; nothing lifts in the shadow, and what reaches it stays.",
                         "Werner 1995")};
}

Parameters loose_parameters() {
  return {
      real_parameter("hop_factor", "Length of hops", "", 10, 0.1, 1000,
                     "A hop in heights of saltation, 0.0844 u*^1.27 m.",
                     "height: Pomeroy & Male 1992; factor: our own"),
      real_parameter("clearance", "Clearance", "m", 0.1, 0, 10,
                     "A slab flies at the height over the smoothed surface that it left from; ground higher by more "
                     "than this ends the hop.",
                     tuned),
      real_parameter("rest_loose", "Rest on loose snow", "", 0.6, 0, 1, "Chance that a slab stays on loose snow.",
                     "Werner 1995"),
      real_parameter("rest_hard", "Rest on hard snow", "", 0.02, 0, 1, "Chance that a slab stays on bonded snow.",
                     tuned),
      real_parameter("rest_ground", "Rest on bare ground", "", 0.02, 0, 1, "Chance that a slab stays on bare ground.",
                     ours),
      real_parameter("ageing", "Ageing of the threshold", "m/s", 0.9, 0, 10,
                     "Growth of the wind that lifts loose snow with the logarithm of the hours since it landed.",
                     "form: Li & Pomeroy 1997; applied to each cell: our own"),
      real_parameter("repose_angle", "Angle of repose", "deg", 38, 1, 80,
                     "Loose snow slides down steeper slopes; bonded snow never."),
      boolean_parameter("obstacles", "Obstacles stop slabs", true,
                        "A flying slab drops before bedrock that stands too steeply; off, slabs cross."),
      real_parameter("suspension", "Carried off", "", 0.02, 0, 1,
                     "Chance that a hop carries a slab away for good, times (wind / suspension_wind)^2 - 1.", ours),
      real_parameter("suspension_wind", "Carried off from", "m/s", 15, 0.1, 1000,
                     "Wind from which on snow is carried off.", ours),
      real_parameter("snowfall", "Snowfall", "mm/h", 0, 0, heaviest_snowfall,
                     "Snow that falls all the time, as it lies; that of the wind's seasons comes on top. It comes to "
                     "rest on the lowest of nine cells.",
                     ours)};
}

Parameters bonded_parameters() {
  return {
      real_parameter("bonding_time", "Bonding time", "h", 12, 0.01, 1e6,
                     "Mean time in which loose snow bonds at -10 deg C.", tuned),
      real_parameter("bonding_warmth", "Bonding by warmth", "1/K", 0.08, 0, 1,
                     "The bonding time falls as exp(-0.08 (T + 10)).", "viscosity of snow; form our own"),
      at_start(real_parameter("start_age", "Age at the start", "h", 0, 0, 1e7,
                              "Calm hours that the snow has lain and bonded before the first step.")),
      real_parameter("abrasion", "Abrasion", "", 5, 0, 1000, "Scale of the chance that an impact frees bonded snow.",
                     tuned),
      real_parameter("entrainment", "Lifting of bonded snow", "1/h", 0.05, 0, 1000,
                     "Rate at which the wind alone lifts bonded snow an hour old, times (wind / its threshold)^2 - 1: "
                     "what starts the drift where no snow is loose.",
                     ours),
      real_parameter("impact_angle", "Angle of impact", "deg", 11, 0, 90,
                     "At which slabs come down on level ground; only the part of the speed into the surface counts.",
                     tuned),
      real_parameter("bonded_spread", "Threshold of bonded snow", "m/s", 1.97, 0, 50,
                     "How much more wind than loose snow an hour old abrasion needs.",
                     "spread of the thresholds in Li & Pomeroy 1997"),
      real_parameter("hardening", "Hardening", "", 0.18, 0, 2, "Strength grows with this power of the age in hours.",
                     "Filhol & Sturm 2015, after sintering experiments"),
      choice_parameter("strength", "Strength varies", "noise", {"even", "noise", "layers", "both"},
                       "noise: from place to place and with depth; layers: with depth alone, as sheets that lie on the "
                       "ground one over the other; both; even: nowhere.",
                       ours),
      real_parameter("contrast", "Contrast of strength", "", 2.6, 1, 20,
                     "The weakest snow is so many times weaker than the mean, the strongest stronger.", tuned),
      real_parameter("patch_length", "Length of patches", "m", 0.4, 0.001, 1000, "Of the noise of strength, in plan.",
                     tuned),
      real_parameter("layer_thickness", "Thickness of layers", "m", 0.03, 0.0001, 100,
                     "Of the layers of strength, and of the noise in depth.", tuned)};
}

Parameters snow_sintering_parameters() {
  Parameters parameters{at_start(real_parameter("slab_height", "Slab height", "m", 0.005, 0.0001, 1,
                                                "Height of one slab: the smallest amount of snow that moves.", ours)),
                        real_parameter("time_step", "Time step", "s", 60, 0.1, 86400, "Real time of one step.", ours)};
  for (const Parameters& part : {wind_parameters(), loose_parameters(), bonded_parameters()}) {
    parameters.insert(parameters.end(), part.begin(), part.end());
  }
  return parameters;
}

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

double bonding_hours(const ParameterValues& values, double temperature) {
  return values.real("bonding_time") * std::exp(-values.real("bonding_warmth") * (temperature + 10));
}

double friction(const ParameterValues& values) {
  return karman / std::log(wind_height / (values.real("roughness") / 1000));
}

double hop_metres(const ParameterValues& values, double wind) {
  return values.real("hop_factor") * 0.0844 * std::pow(friction(values) * wind, 1.27);
}

template <typename Function>
void fill(OctaveTable& table, const Function& function) {
  for (int k = 0; k <= 8 * OctaveTable::octaves; ++k) {
    const double x = std::ldexp(1 + (k % 8) / 8.0, OctaveTable::lowest_octave + k / 8);
    table.values[k] = static_cast<float>(function(x));
  }
}

std::vector<std::string> explain_sintering(const ParameterValues& values, double cell_size) {
  char loose_snow[160], hop[160];
  std::snprintf(loose_snow, sizeof loose_snow,
                "at -10 deg C loose snow an hour old lifts from %.1f m/s on; bonding takes %.1f h", mean_threshold(-10),
                bonding_hours(values, -10));
  std::snprintf(hop, sizeof hop, "a hop in a wind of 10 m/s: %.2f m, %.1f cells", hop_metres(values, 10),
                hop_metres(values, 10) / cell_size);
  return {loose_snow, hop};
}

class SnowSintering : public Model {
 public:
  explicit SnowSintering(ParameterValues values) : values_(std::move(values)) {}

  double quantum() const override { return values_.real("slab_height"); }
  double shadow_fall(double cell_size) const override {
    return erg::shadow_fall(values_.real("shadow_angle"), cell_size, quantum());
  }
  void prepare(const Beginning& beginning) override {
    seed_ = beginning.seed;
    first_temperature_ = beginning.temperature;
  }
  void begin(Terrain& terrain) override;
  StepReport step(Terrain& terrain, const WindNow& wind, StepKey key, Executor& executor) override;

 private:
  void prepare_law(const Terrain& terrain);
  void update_law(const WindNow& wind, StepKey key);
  int cells(const char* key, double cell_size) const {
    return std::clamp(static_cast<int>(std::lround(values_.real(key) / cell_size)), 0, 200);
  }

  ParameterValues values_;
  std::uint64_t seed_ = 0;
  double first_temperature_ = -10;
  SnowLaw law_;
};

void SnowSintering::begin(Terrain& terrain) {
  prepare_law(terrain);
  if (!terrain.fields().empty()) return;
  std::vector<Field>& fields = terrain.edit_fields();
  for (FieldInfo& info : snow_sintering_fields()) fields.push_back({std::move(info), Grid<float>(terrain.extent())});
  const double hours = values_.real("start_age");
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
  const auto real = [this](const char* key) { return static_cast<float>(values_.real(key)); };
  law_ = {};
  law_.speed_by_height = static_cast<float>(values_.real("speed_by_height") * quantum());
  law_.speed_by_slope = real("speed_by_slope");
  law_.friction = static_cast<float>(friction(values_));
  law_.hop_cells = static_cast<float>(values_.real("hop_factor") / cell_size);
  law_.clearance_16 = static_cast<int>(std::min(16 * values_.real("clearance") / quantum() + 0.5, 2.0 * highest_over));
  law_.rest_loose = real("rest_loose");
  law_.rest_hard = real("rest_hard");
  law_.rest_ground = real("rest_ground");
  const double saltation = 0.68 * values_.real("air_density") / earth_gravity / loose_density;
  law_.lift_scale =
      static_cast<float>(saltation * values_.real("time_step") * values_.real("rest_loose") / (quantum() * cell_size));
  law_.standing = standing_step(values_.real("repose_angle"), cell_size, quantum());
  law_.wall = values_.boolean("obstacles") ? law_.standing : std::numeric_limits<int>::max();
  law_.abrasion = real("abrasion");
  law_.entrainment = static_cast<float>(values_.real("entrainment") * values_.real("time_step") / seconds_per_hour);
  law_.sine = static_cast<float>(std::sin(radians(values_.real("impact_angle"))));
  law_.cosine = static_cast<float>(std::cos(radians(values_.real("impact_angle"))));
  law_.slope_scale = static_cast<float>(quantum() / cell_size);
  law_.step_hours = static_cast<float>(values_.real("time_step") / seconds_per_hour);
  const std::string& pattern = values_.text("strength");
  law_.pattern = pattern == "noise"    ? StrengthPattern::noise
                 : pattern == "layers" ? StrengthPattern::layers
                 : pattern == "both"   ? StrengthPattern::both
                                       : StrengthPattern::even;
  law_.noise_word = mix64(seed_ ^ 0x73746167u);
  law_.noise_columns =
      std::max(1, static_cast<int>(std::lround(terrain.nx() * cell_size / values_.real("patch_length"))));
  law_.noise_rows = std::max(1, static_cast<int>(std::lround(terrain.ny() * cell_size / values_.real("patch_length"))));
  law_.noise_by_column = static_cast<float>(law_.noise_columns) / static_cast<float>(terrain.nx());
  law_.noise_by_row = static_cast<float>(law_.noise_rows) / static_cast<float>(terrain.ny());
  law_.noise_by_slab = static_cast<float>(quantum() / values_.real("layer_thickness"));
  for (int k = 0; k <= 256; ++k) {
    law_.strength_table[k] = static_cast<float>(std::pow(values_.real("contrast"), k / 128.0 - 1));
  }
  fill(law_.age_threshold, [this](double hours) { return values_.real("ageing") * std::log(hours); });
  fill(law_.hop, [](double friction_velocity) { return 0.0844 * std::pow(friction_velocity, 1.27); });
  fill(law_.hardening, [this](double hours) { return std::pow(hours, values_.real("hardening")); });
}

/// What a step's weather changes.
void SnowSintering::update_law(const WindNow& wind, StepKey key) {
  law_.wind = static_cast<float>(wind.strength);
  law_.threshold = static_cast<float>(mean_threshold(wind.temperature));
  const double excess = wind.strength / values_.real("suspension_wind");
  law_.suspension = static_cast<float>(std::clamp(values_.real("suspension") * (excess * excess - 1), 0.0, 1.0));
  law_.bonded_threshold = law_.threshold + static_cast<float>(values_.real("bonded_spread"));
  law_.bonding = static_cast<float>(
      std::min(1.0, static_cast<double>(law_.step_hours) / bonding_hours(values_, wind.temperature)));
  law_.now = static_cast<float>(static_cast<double>(key.step + 1) * values_.real("time_step") / seconds_per_hour);
  const double fall = (values_.real("snowfall") + wind.snowfall) / 1000;  // m/h
  law_.snowfall = static_cast<float>(fall * static_cast<double>(law_.step_hours) / quantum());
}

StepReport SnowSintering::step(Terrain& terrain, const WindNow& wind, StepKey key, Executor& executor) {
  update_law(wind, key);
  const double cell_size = terrain.cell_size();
  const SnowRadii radii{cells("smooth_radius", cell_size), std::max(1, cells("around_radius", cell_size))};
  const bool shows_strength = (key.step + 1) % strength_every == 0;
  return executor.drift_snow(terrain, {law_, radii, shadow_fall(cell_size), shows_strength}, wind, key);
}

}  // namespace

ModelType snow_sintering() {
  return {{.key = "snow_sintering",
           .title = "Sintering snow",
           .citation = "our own, on Filhol & Sturm (2015), JGR Earth Surface 120, 1645-1669, and Li & Pomeroy (1997), "
                       "JGR Atmospheres 102, 21955-21967",
           .makes = "snow waves, snow barchans, sastrugi, flat crust",
           .leaves_out = "melting, air flow, ripples of single grains, clouds of suspended snow",
           .step = "time_step seconds",
           .strength_label = "wind at 10 m, m/s",
           .material = Material::snow,
           .start = {.cell_size = 0.1, .strength = 11, .sand = 6},
           .asks_temperature = true,
           .asks_snowfall = true},
          snow_sintering_parameters(),
          snow_sintering_fields(),
          29,  // planes and polls of SnowSolver
          [](const ParameterValues& values) { return std::make_unique<SnowSintering>(values); },
          explain_sintering,
          [](const ParameterValues& values, double, double) {
            return StepScale{values.real("time_step"), 0};
          }};
}

}  // namespace erg
