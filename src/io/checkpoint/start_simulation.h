// From a config to a run, with the files that the config names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/config/provenance.h"
#include "sim/scene.h"
#include "sim/simulation.h"

namespace erg::io {

/// The pictures that a config wants, brought to its grid.
struct ConfigPictures {
  std::optional<sim::HeightPicture> scene;  ///< of an *image* scene
  std::optional<sim::HeightPicture> model;  ///< of the model's own path parameter
};

/// Reads them; `notes`, where given, gets what is worth telling: pictures of another shape, heights that they say
/// themselves, cells without data. Throws InputError as read_height_picture does.
ConfigPictures read_pictures(const sim::Config& config, std::vector<std::string>* notes = nullptr);

/// Where the scene's picture is to give the grid (`image_fit` from_file): sets the grid's sides to the picture's, and
/// its cell size where the picture says one. Does nothing for other configs. Throws InputError as read_height_header
/// does, and for a picture larger than a grid may be.
void take_grid_from_picture(sim::Config& config);

/// The run that the config describes, at step 0, with the pictures that it wants; the grid taken from the picture where
/// that is asked for. Throws InputError.
sim::Simulation start_simulation(const sim::Config& config, std::vector<std::string>* notes = nullptr);

/// Where a file about this run, as it stands, says it comes from.
Provenance provenance_of(sim::Simulation& simulation);

}  // namespace erg::io
