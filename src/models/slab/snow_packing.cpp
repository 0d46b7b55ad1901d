#include "models/slab/snow_packing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "core/units.h"
#include "models/slab/slab_model.h"
#include "models/slab/snow_density.h"

namespace erg::models {
namespace {

constexpr SlabFamily packing_family{.timed_by_flux = false};  // else Werner's

/// Fitted: snow at -20 °C, Alta and tundra, is frozen after 98 days, as in print.
constexpr double fitted_rate = 0.0247;
constexpr double metamorphism = 0.04;  // 1/K, Anderson 1976

enum PackingField : std::size_t { resistance, density };

struct PackingValues : SlabValues {
  std::string fresh_density;
  std::string snow_class;
  double packing_rate = 0;  ///< 1/day
};

Binding<PackingValues> snow_packing_binding() {
  const Binding<PackingValues>::Entries own{
      {&PackingValues::fresh_density,
       {.key = "fresh_density",
        .label = "Fresh density",
        .default_value = "alta",
        .choices = {"alta", "hedstrom_pomeroy"},
        .meaning = "How dense fresh snow is at a temperature.",
        .source = "Anderson 1976; Hedstrom & Pomeroy 1998"}},
      {&PackingValues::snow_class,
       {.key = "snow_class",
        .label = "Snow class",
        .default_value = "tundra",
        .choices = {"alpine", "maritime", "prairie", "tundra", "taiga", "lowest"},
        .meaning = "How snow settles over the days; lowest: on each day the class of least "
                   "density (taiga, which never settles, left out).",
        .source = "Sturm et al. 2010"}},
      {&PackingValues::packing_rate,
       {.key = "packing_rate",
        .label = "Packing rate",
        .unit = "1/day",
        .default_value = fitted_rate,
        .minimum = 0,
        .maximum = 1,
        .meaning = "Growth of resistance on the first day at 0 °C. Fitted: with the other "
                   "defaults all is frozen after 98 days at -20 °C, as in print."}}};
  return Binding<PackingValues>(slab_binding(packing_family), own);
}

std::vector<FieldInfo> snow_packing_fields() {
  return {{"resistance", "resistance", "", 0, 1, "cividis", "Resistance to the wind; from 1 on the snow is frozen."},
          {"density", "snow density", "kg/m3", 0, 600, "cividis",
           "Resistance as a density: 1 is the highest of the snow class."}};
}

const SnowClass& snow_class(const PackingValues& values, double day) {
  const std::string& key = values.snow_class;
  const SnowClass* chosen = nullptr;
  for (const SnowClass& one : snow_classes()) {
    if (one.key == key) return one;
    const bool settles = one.by_day > 0;
    if (settles && (chosen == nullptr || one.density(0, day) < chosen->density(0, day))) chosen = &one;
  }
  return *chosen;
}

double start_resistance(const PackingValues& values, double temperature) {
  const double fresh =
      values.fresh_density == "alta" ? fresh_density_alta(temperature) : fresh_density_hedstrom_pomeroy(temperature);
  return std::min(1.0, fresh / snow_class(values, 0).most);
}

/// Growth of the resistance on a day (0 is the first).
double daily_growth(const PackingValues& values, double temperature, double day) {
  if (values.snow_class == "taiga") return 0;
  return values.packing_rate * std::exp(metamorphism * temperature) * std::exp(-snow_class(values, day).by_day * day);
}

/// Days until all is frozen at a temperature that does not change; 0: never.
int days_to_freeze(const PackingValues& values, double temperature) {
  constexpr int longest = 10000;
  double r = start_resistance(values, temperature);
  for (int day = 0; day < longest; ++day) {
    r += daily_growth(values, temperature, day);
    if (r >= 1) return day + 1;
  }
  return 0;
}

std::vector<std::string> explain_packing(const PackingValues& values, double cell_size) {
  std::vector<std::string> lines = explain_slabs(values, cell_size);
  std::string days = "days to freeze:";
  for (const double temperature : {-20.0, -15.0, -10.0, -5.0, 0.0}) {
    char text[40];
    const int count = days_to_freeze(values, temperature);
    std::snprintf(text, sizeof text, " %s at %g °C%s", count > 0 ? std::to_string(count).c_str() : "never", temperature,
                  temperature < 0 ? "," : "");
    days += text;
  }
  lines.push_back(days);
  return lines;
}

class SnowPacking : public SlabModel {
 public:
  explicit SnowPacking(const PackingValues& values) : SlabModel(packing_family, values), values_(values) {}

  void prepare(const InitContext& context) override { first_temperature_ = context.weather.temperature; }

  void begin(Terrain& terrain) override {
    SlabModel::begin(terrain);
    if (!terrain.fields().empty()) return;
    std::vector<Field>& fields = terrain.edit_fields();
    for (FieldInfo& info : snow_packing_fields()) fields.push_back({std::move(info), Grid<float>(terrain.extent())});
    const double start = start_resistance(values_, first_temperature_);
    fields[resistance].values.fill(static_cast<float>(start));
    fields[density].values.fill(static_cast<float>(start * snow_class(values_, 0).most));
  }

  StepReport step(Terrain& terrain, const forcing::Forcing& wind, StepKey key, compute::Executor& executor) override {
    SlabLaw law = SlabModel::law(terrain);
    law.cover = &cover(terrain);
    StepReport report = move_slabs(executor, terrain, law, wind, key);
    const double day = static_cast<double>(key.step);
    const double least = pack(terrain, daily_growth(values_, wind.temperature, day), snow_class(values_, day).most);
    report.finished = least >= 1;
    if (report.finished) report.why_finished = "all snow was frozen on day " + std::to_string(key.step + 1);
    return report;
  }

 private:
  /// The resistance as executors use it, read anew where it changed.
  const Cover& cover(const Terrain& terrain) {
    if (fields_stamp_ == terrain.fields_stamp()) return cover_;
    const Grid<float>& held = terrain.fields()[resistance].values;
    CoverField& made = cover_.edit();
    made = CoverField(terrain.extent());
    for (std::size_t cell = 0; cell < made.size(); ++cell) made[cell] = cover_of(std::clamp(held[cell], 0.0f, 1.0f));
    fields_stamp_ = terrain.fields_stamp();
    return cover_;
  }

  /// A day's growth; the least resistance there is then.
  static double pack(Terrain& terrain, double growth, double most) {
    std::vector<Field>& fields = terrain.edit_fields();
    float least = std::numeric_limits<float>::max();
    for (std::size_t cell = 0; cell < terrain.extent().cells(); ++cell) {
      float& r = fields[resistance].values[cell];
      r = std::min(1.0f, r + static_cast<float>(growth));
      fields[density].values[cell] = r * static_cast<float>(most);
      least = std::min(least, r);
    }
    return least;
  }

  PackingValues values_;
  double first_temperature_ = -10;
  Cover cover_;
  std::uint64_t fields_stamp_ = 0;  // of the fields that it was made from
};

}  // namespace

ModelType snow_packing() {
  return ModelOf<PackingValues>{
      .info =
          {.key = "snow_packing",
           .title = "Snow packing",
           .citation = "after Cimbura, V. (2022), sections 4.8 and 5.12, with the growth of resistance repaired (as "
                       "printed it is 0 at -20 °C)",
           .produces = "snow ripples that freeze day by day",
           .limitations = "melting, snowfall, layers, sunshine; bedforms carved into hard snow (see snow_sintering)",
           .step = "a day; polls as many cells as the grid has",
           .strength_label = slab_strength,
           .material = Material::snow,
           .channels = {"temperature"},
           // Snow that freezes soon would leave little to measure.
           .bench_scenes = {{.name = "dunes", .steps = 20, .settings = {"temperature=-60"}},
                            {.name = "oblique wind", .steps = 20, .oblique = true, .settings = {"temperature=-60"}}}},
      .parameters = snow_packing_binding(),
      .fields = snow_packing_fields(),
      .working_bytes = 5,  // the cover, here and with the executor, with room
      .make = [](const PackingValues& values) { return std::make_unique<SnowPacking>(values); },
      .explain = explain_packing,
      .step_scale =
          [](const PackingValues& values, double cell_size, double strength) {
            return StepScale{seconds_a_day, slab_flux(values, cell_size, strength)};
          }};
}

}  // namespace erg::models
