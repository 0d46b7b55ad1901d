#include "app/run_output.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "analysis/morphometry.h"
#include "analysis/spectrum.h"
#include "io/checkpoint.h"
#include "io/config_file.h"
#include "io/heightmap.h"
#include "io/picture.h"
#include "io/vti.h"
#include "wind/shadow.h"

namespace erg {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> table_columns{"step",       "wind_bearing",  "wind_strength", "max_slabs",
                                             "mean_slabs", "sd_slabs",      "bare_fraction", "shadow_fraction",
                                             "wavelength", "crest_bearing", "mass_now",      "mass_in",
                                             "mass_out",   "lifts",         "polls",         "flux"};

void make_folder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (!failed && fs::is_directory(folder)) return;
  throw InputError("--out " + folder.string(), "cannot make this folder" + (failed ? ": " + failed.message() : ""),
                   "give a folder that can be written");
}

}  // namespace

const std::vector<std::string>& output_formats() {
  static const std::vector<std::string> formats{"png", "png16", "vti", "csv", "checkpoint"};
  return formats;
}

RunOutput::RunOutput(fs::path folder, std::string name, std::vector<std::string> formats, Simulation& simulation)
    : folder_(std::move(folder)),
      name_(std::move(name)),
      formats_(std::move(formats)),
      simulation_(simulation),
      last_totals_(simulation.totals()),
      last_row_step_(simulation.step_count()) {
  make_folder(folder_);
  if (!wants("csv")) return;
  const fs::path path = folder_ / (name_ + ".csv");
  const std::int64_t step = simulation_.step_count();
  table_ = std::make_unique<TableFile>(
      step > 0 ? TableFile::resume(path, table_columns, provenance(), static_cast<double>(step))
               : TableFile(path, table_columns, provenance()));
  files_.push_back(path);
}

bool RunOutput::wants(const std::string& format) const {
  return std::find(formats_.begin(), formats_.end(), format) != formats_.end();
}

Provenance RunOutput::provenance() {
  const Config& config = simulation_.config();
  const int threads = simulation_.executor().threads();
  return {.config = config_text(config),
          .seed = static_cast<std::uint64_t>(config.run.integer("seed")),
          .step = simulation_.step_count(),
          .model = config.model,
          .version = ERG_VERSION,
          .executor =
              simulation_.executor().name() + ", " + std::to_string(threads) + (threads == 1 ? " thread" : " threads")};
}

fs::path RunOutput::numbered(const std::string& ending) const {
  char step[32];
  std::snprintf(step, sizeof step, "-%06lld", static_cast<long long>(simulation_.step_count()));
  return folder_ / (name_ + step + ending);
}

void RunOutput::add_row() {
  if (table_ == nullptr) return;
  const Terrain& terrain = simulation_.terrain();
  const WindNow wind = simulation_.last_wind();
  const Morphometry shape = measure(terrain);
  const double shadow =
      shadow_fraction(shadow_map(terrain, wind.bearing, simulation_.model().shadow_fall(terrain.cell_size())));
  const SpectrumNumbers spectrum = measure_spectrum(coarse_surface(terrain, Layer::surface));
  const StepReport& totals = simulation_.totals();
  const std::int64_t steps = simulation_.step_count() - last_row_step_;
  const auto cell_steps = static_cast<double>(terrain.extent().cells()) * static_cast<double>(steps);
  const std::array<double, 16> row{static_cast<double>(simulation_.step_count()),
                                   wind.bearing,
                                   wind.strength,
                                   static_cast<double>(shape.max_slabs),
                                   shape.mean_slabs,
                                   shape.sd_slabs,
                                   shape.bare_fraction,
                                   shadow,
                                   spectrum.wavelength,
                                   spectrum.crest_bearing,
                                   static_cast<double>(terrain.total_mobile()),
                                   static_cast<double>(terrain.ledger().in),
                                   static_cast<double>(terrain.ledger().out),
                                   static_cast<double>(totals.lifts - last_totals_.lifts),
                                   static_cast<double>(totals.polls - last_totals_.polls),
                                   cell_steps > 0 ? (totals.travel - last_totals_.travel) / cell_steps : 0};
  table_->add(row);
  last_totals_ = totals;
  last_row_step_ = simulation_.step_count();
}

void RunOutput::write_state() {
  const Terrain& terrain = simulation_.terrain();
  const Provenance source = provenance();
  if (wants("png")) {
    PictureOptions options;
    options.wind = simulation_.last_wind();
    options.caption = simulation_.model_type().info.title + ", step " + std::to_string(source.step);
    const fs::path path = numbered(".png");
    write_png(path, draw_picture(terrain, options), metadata(source));
    files_.push_back(path);
  }
  if (wants("png16")) {
    const fs::path path = numbered("-height.png");
    write_heightmap(path, terrain, source);
    files_.push_back(path);
  }
  if (wants("vti")) {
    const Grid<std::uint8_t> shadow =
        shadow_map(terrain, simulation_.last_wind().bearing, simulation_.model().shadow_fall(terrain.cell_size()));
    const fs::path path = numbered(".vti");
    write_vti(path, terrain, &shadow, source);
    files_.push_back(path);
  }
  if (wants("checkpoint")) write_state_checkpoint();
}

fs::path RunOutput::write_state_checkpoint() {
  fs::path path = numbered(".checkpoint");
  write_checkpoint(path, simulation_.config(), simulation_.state());
  files_.push_back(path);
  return path;
}

}  // namespace erg
