#include "models/snow/snow_drift.h"

namespace erg {

bool SnowDrift::holds(const Terrain& terrain) const {
  return stamp_ == terrain.stamp() && fields_stamp_ == terrain.fields_stamp();
}

void SnowDrift::load(const Terrain& terrain) {
  const std::size_t cells = terrain.extent().cells();
  const Grid<float>& bonded = snow_layer(terrain.fields(), SnowLayer::bonded);
  layers_.loose.resize(cells);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    layers_.loose[cell] = loose_slabs(terrain.mobile()[cell], bonded[cell]);
  }
}

StepReport SnowDrift::step(Terrain& terrain, const SnowStep& snow, const WindNow& wind, StepKey key,
                           Executor& executor) {
  if (!holds(terrain)) load(terrain);
  stamp_ = 0;
  std::vector<Field>& fields = terrain.edit_fields();
  layers_.age = snow_layer(fields, SnowLayer::age).cells();
  layers_.landed = snow_layer(fields, SnowLayer::landed).cells();
  layers_.shown_loose = snow_layer(fields, SnowLayer::loose).cells();
  layers_.shown_bonded = snow_layer(fields, SnowLayer::bonded).cells();
  const StepReport report =
      machine_.step(terrain, layers_, snow.law, snow.radii, snow.shadow_fall, wind, key, executor);
  if (snow.shows_strength) write_strength(snow.law, terrain, snow_layer(fields, SnowLayer::strength), executor);
  stamp_ = terrain.stamp();
  fields_stamp_ = terrain.fields_stamp();
  return report;
}

void SnowDrift::write_strength(const SnowLaw& law, const Terrain& terrain, Grid<float>& strength,
                               Executor& executor) const {
  const SnowKernels& kernels = snow_kernels(instructions_);
  const bool noise = law.pattern == StrengthPattern::noise || law.pattern == StrengthPattern::both;
  const std::size_t points = 2 * static_cast<std::size_t>(law.noise_columns + 1) * StrengthLattice::layers;
  executor.parallel_for(terrain.ny(), [&](std::int64_t begin, std::int64_t end) {
    std::vector<float> memory(noise ? points : 0);
    StrengthLattice lattice{.points = noise ? memory.data() : nullptr};
    for (int y = static_cast<int>(begin); y < end; ++y) {
      const std::size_t row = strength.index(0, y);
      kernels.strength(law, {y, terrain.nx(), &terrain.mobile()[row], &layers_.loose[row], &strength[row]}, lattice);
    }
  });
}

}  // namespace erg
