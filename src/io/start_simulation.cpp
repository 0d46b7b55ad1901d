#include "io/start_simulation.h"

#include "io/heightmap.h"

namespace erg {

std::optional<HeightPicture> read_picture_of(const ParameterValues& values) {
  const Parameter* wanted = wanted_path(values);
  if (wanted == nullptr) return std::nullopt;
  return read_height_picture(values.text(wanted->key));
}

Simulation start_simulation(const Config& config) {
  const std::optional<HeightPicture> picture = read_picture_of(config.scene);
  const std::optional<HeightPicture> model_picture = read_picture_of(config.parameters);
  return Simulation(config, picture ? &*picture : nullptr, model_picture ? &*model_picture : nullptr);
}

Provenance provenance_of(Simulation& simulation) {
  return provenance_of(simulation.config(), simulation.step_count(), simulation.executor().name(),
                       simulation.executor().threads());
}

}  // namespace erg
