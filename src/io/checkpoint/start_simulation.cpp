#include "io/checkpoint/start_simulation.h"

#include <algorithm>
#include <cmath>

#include "core/number_text.h"
#include "io/formats/heightmap.h"

namespace erg::io {

using sim::Config;
using sim::HeightRange;
using sim::NoDataRule;
using sim::PictureFit;
using sim::Simulation;

namespace {

bool has_image_scene(const Config& config) { return config.scene.text("kind") == "image"; }

Extent grid_of(const Config& config) {
  return {static_cast<int>(config.grid.integer("nx")), static_cast<int>(config.grid.integer("ny"))};
}

NoDataRule no_data_rule(const std::string& choice) {
  return choice == "lowest" ? NoDataRule::lowest : choice == "around" ? NoDataRule::around : NoDataRule::refuse;
}

HeightPictureOptions scene_options(const Config& config) {
  return {grid_of(config), config.scene.text("image_fit") == "crop" ? PictureFit::crop : PictureFit::stretch,
          no_data_rule(config.scene.text("image_nodata"))};
}

std::string text_of(const HeightRange& range) {
  return format_shortest(range.low) + " to " + format_shortest(range.high) + " m";
}

void tell_heights(const Config& config, const sim::HeightPicture& picture, std::vector<std::string>& notes) {
  const HeightRange used = sim::image_heights(config.scene, picture);
  const std::string name = config.scene.text("image");
  if (config.scene.text("image_role") == "sand" && std::min(used.low, used.high) < 0) {
    notes.push_back(name + ": no sand lies where its height is below 0 m (image_role sand)");
  }
  if (!picture.metres) return;
  if (used.low == picture.metres->low && used.high == picture.metres->high) {
    notes.push_back(name + ": heights in the picture, " + text_of(used));
  } else {
    notes.push_back(name + ": heights in the picture, " + text_of(*picture.metres) +
                    ", give way to image_low and image_high, " + text_of(used));
  }
}

/// Whole arc seconds, written with more digits than anyone types: 30 arc seconds are 0.00833333 degrees.
bool looks_like_degrees(double cell_size) {
  const auto whole = [](double number) { return std::abs(number - std::round(number)) < 1e-3; };
  return cell_size < 1 && whole(cell_size * 3600) && !whole(cell_size * 1e4);
}

void tell_degrees(const Config& config, std::vector<std::string>& notes) {
  const double cell_size = config.grid.real("cell_size");
  if (!looks_like_degrees(cell_size)) return;
  notes.push_back("cell_size is " + format_shortest(cell_size) + " m, and looks like " +
                  format_shortest(std::round(cell_size * 3600)) +
                  " arc seconds in degrees; a degree is 111 km from south to north");
}

}  // namespace

ConfigPictures read_pictures(const Config& config, std::vector<std::string>* notes) {
  ConfigPictures pictures;
  if (has_image_scene(config)) {
    pictures.scene = read_height_picture(config.scene.text("image"), scene_options(config), notes);
    if (notes != nullptr) {
      tell_heights(config, *pictures.scene, *notes);
      tell_degrees(config, *notes);
    }
  }
  if (const Parameter* wanted = wanted_path(config.parameters)) {
    pictures.model = read_height_picture(config.parameters.text(wanted->key), {grid_of(config)}, notes);
  }
  return pictures;
}

void take_grid_from_picture(Config& config) {
  if (!has_image_scene(config) || config.scene.text("image_fit") != "from_file") return;
  const std::string& path = config.scene.text("image");
  const HeightPictureHeader header = read_height_header(path);
  if (header.extent.nx > largest_side || header.extent.ny > largest_side) {
    throw InputError(path,
                     "the picture has " + std::to_string(header.extent.nx) + " x " + std::to_string(header.extent.ny) +
                         " pixels, and a grid at most " + std::to_string(largest_side) + " cells on a side",
                     "take image_fit stretch or crop, and set the grid");
  }
  config.grid.set("nx", std::int64_t{header.extent.nx});
  config.grid.set("ny", std::int64_t{header.extent.ny});
  if (header.cell_size && !check_value(*config.grid.find("cell_size"), *header.cell_size, "")) {
    config.grid.set("cell_size", *header.cell_size);
  }
}

Simulation start_simulation(const Config& config, std::vector<std::string>* notes) {
  Config whole = config;
  take_grid_from_picture(whole);
  const ConfigPictures pictures = read_pictures(whole, notes);
  return Simulation(std::move(whole), pictures.scene ? &*pictures.scene : nullptr,
                    pictures.model ? &*pictures.model : nullptr);
}

Provenance provenance_of(Simulation& simulation) {
  return provenance_of(simulation.config(), simulation.step_count(), simulation.executor().name(),
                       simulation.executor().threads());
}

}  // namespace erg::io
