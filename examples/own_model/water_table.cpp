#include "water_table.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

#include "models/slab/slab_model.h"

namespace erg {

using compute::Executor;
using models::cover_of;
using models::CoverField;
using models::SlabModel;

namespace {

// Werner's; but the ground's wetness is renewed once a step, so a cell gives no more than one slab in each.
constexpr models::SlabFamily family{.polling = "nonrepeated"};

/// What its parameters say.
struct WaterTableValues : models::SlabValues {
  double water_table = 0;  ///< m
  double fringe = 0;       ///< m
};

Binding<WaterTableValues> water_table_binding() {
  const Binding<WaterTableValues>::Entries own{
      {&WaterTableValues::water_table,
       {.key = "water_table",
        .label = "Water table",
        .unit = "m",
        .default_value = 0.5,
        .minimum = 0,
        .maximum = 1000,
        .meaning = "Height above level 0 up to which the ground is wet through.",
        .source = "Stokes 1968"}},
      {&WaterTableValues::fringe,
       {.key = "fringe",
        .label = "Capillary fringe",
        .unit = "m",
        .default_value = 0.3,
        .minimum = 0,
        .maximum = 10,
        .meaning = "Height above the water table over which the ground dries to the top."}}};
  return Binding<WaterTableValues>(models::slab_binding(family), own);
}

class WaterTable : public SlabModel {
 public:
  explicit WaterTable(const WaterTableValues& values) : SlabModel(family, values), values_(values) {}

  models::StepReport step(Terrain& terrain, const forcing::Forcing& wind, StepKey key, Executor& executor) override {
    executor.sync_to_host(terrain);
    wet_the_ground(terrain, executor);
    models::SlabLaw law = SlabModel::law(terrain);
    law.cover = &cover_;
    return models::move_slabs(executor, terrain, law, wind, key);
  }

  std::vector<models::Diagnostic> diagnostics() const override {
    const CoverField& cover = *cover_;
    const auto wet = std::count(cover.cells().begin(), cover.cells().end(), cover_of(1));
    return {{"wet_share", "wet ground", "", cover.empty() ? 0 : static_cast<double>(wet) / cover.size()}};
  }

 private:
  /// How firmly water holds each cell: 1 at the water table and below, 0 above the fringe.
  void wet_the_ground(const Terrain& terrain, Executor& executor) {
    CoverField& cover = cover_.edit();
    if (cover.extent() != terrain.extent()) cover = CoverField(terrain.extent());
    const double table = values_.water_table;
    const double fringe = std::max(values_.fringe, 1e-6);
    executor.parallel_for(static_cast<std::int64_t>(cover.size()), [&](std::int64_t begin, std::int64_t end) {
      for (auto cell = static_cast<std::size_t>(begin); cell < static_cast<std::size_t>(end); ++cell) {
        const double height = terrain.metres(terrain.bedrock()[cell] + terrain.mobile()[cell]);
        cover[cell] = cover_of(static_cast<float>(std::clamp((table + fringe - height) / fringe, 0.0, 1.0)));
      }
    });
  }

  WaterTableValues values_;
  models::Cover cover_;
};

std::vector<std::string> explain(const WaterTableValues& values, double cell_size) {
  std::vector<std::string> lines = models::explain_slabs(values, cell_size);
  char line[80];
  std::snprintf(line, sizeof line, "water table %g m: %.1f slabs above level 0", values.water_table,
                values.water_table / values.slab_height);
  lines.push_back(line);
  return lines;
}

}  // namespace

models::ModelType water_table() {
  return models::ModelOf<WaterTableValues>{
      .info = {.key = "water_table",
               .title = "Water table",
               .citation =
                   "Werner 1995 over a water table as in Stokes, W. L. (1968). Multiple parallel-truncation bedding "
                   "planes. Journal of Sedimentary Petrology 38, 510-515.",
               .produces = "dunes between level wet flats",
               .limitations = "a table that rises under dunes, rain, evaporation, salt",
               .step = models::slab_step,
               .strength_label = models::slab_strength},
      .parameters = water_table_binding(),
      .working_bytes = 2,  // bytes a cell: the cover, here and with the executor
      .make = [](const WaterTableValues& values) { return std::make_unique<WaterTable>(values); },
      .explain = explain,
      .step_scale = models::slab_step_scale};
}

}  // namespace erg
