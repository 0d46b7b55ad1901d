#include "io/start_simulation.h"

#include "io/heightmap.h"

namespace erg {

std::optional<HeightPicture> read_scene_picture(const Config& config) {
  if (config.scene.text("kind") != "image") return std::nullopt;
  return read_height_picture(config.scene.text("image"));
}

Simulation start_simulation(const Config& config) {
  const std::optional<HeightPicture> picture = read_scene_picture(config);
  return Simulation(config, picture ? &*picture : nullptr);
}

Provenance provenance_of(Simulation& simulation) {
  return provenance_of(simulation.config(), simulation.step_count(), simulation.executor().name(),
                       simulation.executor().threads());
}

}  // namespace erg
