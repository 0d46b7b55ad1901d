#include "showers.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "models/slab/slab_model.h"
#include "rain_kernels.h"

namespace erg {

using compute::Executor;
using models::CoverField;
using models::SlabModel;

namespace rain {

#define ERG_KERNEL(family, name) \
  constinit const compute::KernelOf<Plan> Kernels::name = compute::make_kernel<Plan, family::name>(#family "_" #name);
#include "rain_kernels.def"
#undef ERG_KERNEL

}  // namespace rain
namespace {

constexpr models::SlabFamily family{};

/// What its parameters say.
struct ShowerValues : models::SlabValues {
  double shower_chance = 0;  ///< a step
  double shower_radius = 0;  ///< m
  double drying_steps = 1;
};

Binding<ShowerValues> showers_binding() {
  const Binding<ShowerValues>::Entries own{{&ShowerValues::shower_chance,
                                            {.key = "shower_chance",
                                             .label = "Chance of a shower",
                                             .default_value = 0.1,
                                             .minimum = 0,
                                             .maximum = 1,
                                             .meaning = "Chance that a shower falls in a step, anywhere on the grid."}},
                                           {&ShowerValues::shower_radius,
                                            {.key = "shower_radius",
                                             .label = "Radius of a shower",
                                             .unit = "m",
                                             .default_value = 20.0,
                                             .minimum = 0,
                                             .maximum = 10000,
                                             .meaning = "Of the ground it wets."}},
                                           {&ShowerValues::drying_steps,
                                            {.key = "drying_steps",
                                             .label = "Steps to dry",
                                             .unit = "steps",
                                             .default_value = 20.0,
                                             .minimum = 1,
                                             .maximum = 10000,
                                             .meaning = "Steps after which wet ground is dry again.",
                                             .source = "Wiggs, Baird & Atherton 2004"}}};
  return Binding<ShowerValues>(models::slab_binding(family), own);
}

std::vector<FieldInfo> showers_fields() {
  return {{"moisture", "Moisture", "", 0, 255, "vegetation", "How wet the ground is: 0 dry, 255 wet through."}};
}

class Showers : public SlabModel {
 public:
  explicit Showers(const ShowerValues& values) : SlabModel(family, values), values_(values) {}

  void begin(Terrain& terrain) override {
    SlabModel::begin(terrain);
    if (!terrain.fields().empty()) return;  // a run that is resumed
    terrain.edit_fields().push_back({showers_fields().front(), Grid<float>(terrain.extent())});
  }

  models::StepReport step(Terrain& terrain, const forcing::Forcing& wind, StepKey key, Executor& executor) override {
    let_it_rain(terrain, key, executor);
    models::SlabLaw law = SlabModel::law(terrain);
    law.cover = &cover_;
    return models::move_slabs(executor, terrain, law, wind, key);
  }

 private:
  rain::Plan plan(const Terrain& terrain, StepKey key) const {
    rain::Plan plan;
    plan.nx = terrain.nx();
    plan.ny = terrain.ny();
    plan.torus = terrain.boundary() == Boundary::torus;
    plan.drying = static_cast<std::int32_t>(std::ceil(255 / values_.drying_steps));
    plan.x = static_cast<std::int32_t>(random_below(key, 0, 0, 0, static_cast<std::uint32_t>(plan.nx)));
    plan.y = static_cast<std::int32_t>(random_below(key, 0, 1, 0, static_cast<std::uint32_t>(plan.ny)));
    if (random_unit(key, 0, 2, 0) < values_.shower_chance) {
      plan.radius = static_cast<std::int32_t>(values_.shower_radius / terrain.cell_size());
    }
    return plan;
  }

  /// The moisture of this step, in the terrain's layer and as what holds slabs.
  void let_it_rain(Terrain& terrain, StepKey key, Executor& executor) {
    rain::Plan plan = this->plan(terrain, key);
    std::vector<std::int32_t> moisture(terrain.extent().cells());
    executor.on_backend(terrain, [&](compute::Backend& backend) {
      const std::span<const float> before = std::as_const(terrain).fields().front().values.cells();
      compute::Buffer<std::int32_t> cells(backend, moisture.size());
      backend.send_each(cells, [&](std::size_t cell) { return static_cast<std::int32_t>(before[cell]); });
      plan.moisture = cells.data();
      backend.launch(rain::Kernels::wet, static_cast<std::int64_t>(moisture.size()), plan);
      moisture = backend.fetch(cells.data(), cells.size());
    });
    CoverField& cover = cover_.edit();
    if (cover.extent() != terrain.extent()) cover = CoverField(terrain.extent());
    std::ranges::copy(moisture, terrain.edit_fields().front().values.cells().begin());
    for (std::size_t cell = 0; cell < moisture.size(); ++cell) cover[cell] = static_cast<std::uint8_t>(moisture[cell]);
  }

  ShowerValues values_;
  models::Cover cover_;
};

}  // namespace

models::ModelType showers() {
  return models::ModelOf<ShowerValues>{
      .info = {.key = "showers",
               .title = "Showers",
               .citation =
                   "Werner 1995 on ground that dries as in Wiggs, G. F. S., Baird, A. J. & Atherton, R. J. (2004). "
                   "The dynamic effects of moisture on the entrainment and transport of sand by wind. "
                   "Geomorphology 59, 13-30.",
               .produces = "dunes with patches that stand still for a while",
               .limitations = "how deep rain soaks in, run-off, the sun, salt",
               .step = models::slab_step,
               .strength_label = models::slab_strength},
      .parameters = showers_binding(),
      .fields = showers_fields(),
      .working_bytes = 6,  // bytes a cell: moisture on its way, the cover, here and with the executor
      .make = [](const ShowerValues& values) { return std::make_unique<Showers>(values); },
      .explain = [](const ShowerValues& values, double cell_size) { return models::explain_slabs(values, cell_size); },
      .step_scale = models::slab_step_scale};
}

}  // namespace erg
