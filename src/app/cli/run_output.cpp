#include "app/cli/run_output.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "app/cli/output_folder.h"
#include "io/checkpoint/checkpoint.h"
#include "io/checkpoint/start_simulation.h"
#include "io/formats/heightmap.h"
#include "io/formats/mesh.h"
#include "io/formats/picture.h"
#include "io/formats/vti.h"
#include "kernels/shadow.h"

namespace erg::app {

using io::Provenance;
using io::provenance_of;
using io::TableFile;

namespace {

namespace fs = std::filesystem;

constexpr const char* height_ending = "-height.png";

std::vector<std::string> table_columns() {
  std::vector<std::string> keys;
  for (const io::RunNumber& number : io::run_numbers()) keys.push_back(number.key);
  return keys;
}

}  // namespace

const std::vector<std::string>& usual_formats() {
  static const std::vector<std::string> formats{"png", "png16", "vti", "csv", "checkpoint"};
  return formats;
}

const std::vector<std::string>& output_formats() {
  static const std::vector<std::string> formats = [] {
    std::vector<std::string> all = usual_formats();
    all.insert(all.end(), {"obj", "ply", "stl"});
    return all;
  }();
  return formats;
}

RunOutput::RunOutput(fs::path folder, std::string name, std::vector<std::string> formats, sim::Simulation& simulation)
    : folder_(std::move(folder)),
      name_(std::move(name)),
      formats_(std::move(formats)),
      simulation_(simulation),
      meter_(simulation.totals(), simulation.step_count()) {
  make_folder(folder_);
  try_files();
  if (!wants("csv")) return;
  const fs::path path = folder_ / (name_ + ".csv");
  const std::int64_t step = simulation_.step_count();
  table_ = std::make_unique<TableFile>(
      step > 0 ? TableFile::resume(path, table_columns(), provenance_of(simulation_), static_cast<double>(step) + 1)
               : TableFile(path, table_columns(), provenance_of(simulation_)));
  files_.push_back(path);
}

bool RunOutput::wants(const std::string& format) const {
  return std::find(formats_.begin(), formats_.end(), format) != formats_.end();
}

/// Those of the last step, whose names are the longest; and a checkpoint, which every run may come to need.
void RunOutput::try_files() const {
  const std::int64_t last = std::max(simulation_.config().run.integer("steps"), simulation_.step_count());
  std::vector<fs::path> files{numbered(last, ".checkpoint")};
  for (const std::string& format : formats_) {
    if (format != "csv") files.push_back(numbered(last, format == "png16" ? height_ending : "." + format));
  }
  if (wants("csv")) files.push_back(folder_ / (name_ + ".csv"));
  for (const fs::path& file : files) try_output(file.string(), file);
}

fs::path RunOutput::numbered(std::int64_t step, const std::string& ending) const {
  char number[32];
  std::snprintf(number, sizeof number, "-%06lld", static_cast<long long>(step));
  return folder_ / (name_ + number + ending);
}

void RunOutput::add_row() {
  if (table_ == nullptr) return;
  if (table_->last() == static_cast<double>(simulation_.step_count())) {
    // On resuming the row of this step is there, with what was counted up to it.
    meter_.glance(simulation_);
    return;
  }
  table_->add(meter_.take(simulation_));
}

void RunOutput::glance() {
  if (table_ != nullptr) meter_.glance(simulation_);
}

void RunOutput::write_state() {
  // First, since a run goes on from it whatever becomes of the others.
  if (wants("checkpoint")) write_state_checkpoint();
  const Terrain& terrain = simulation_.terrain();
  const Provenance source = provenance_of(simulation_);
  if (wants("png")) {
    io::PictureOptions options;
    options.wind = simulation_.last_wind();
    options.caption = simulation_.model_type().info.title + ", step " + std::to_string(source.step);
    const fs::path path = numbered(".png");
    io::write_run_png(path, io::draw_picture(terrain, options), source);
    files_.push_back(path);
  }
  if (wants("png16")) {
    const fs::path path = numbered(height_ending);
    io::write_heightmap(path, terrain, source);
    files_.push_back(path);
  }
  if (wants("vti")) {
    const Grid<std::uint8_t> shadow = kernels::shadow_map(terrain, simulation_.last_wind().bearing,
                                                          simulation_.model().shadow_fall(terrain.cell_size()));
    const fs::path path = numbered(".vti");
    std::vector<Field> more;
    if (simulation_.flux() != nullptr) more.push_back(simulation_.flux()->mean());
    io::write_vti(path, terrain, &shadow, source, more);
    files_.push_back(path);
  }
  write_meshes(source);
}

void RunOutput::write_meshes(const Provenance& source) {
  const auto write = [&](const std::string& format, const auto& writer) {
    if (!wants(format)) return;
    const fs::path path = numbered("." + format);
    writer(path, simulation_.terrain(), source, io::WriteProgress{});
    files_.push_back(path);
  };
  write("obj", io::write_obj);
  write("ply", io::write_ply);
  write("stl", io::write_stl);
}

fs::path RunOutput::write_state_checkpoint() {
  fs::path path = numbered(".checkpoint");
  if (path == last_checkpoint_) return path;
  io::write_checkpoint(path, simulation_.config(), simulation_.state());
  files_.push_back(path);
  last_checkpoint_ = path;
  return path;
}

}  // namespace erg::app
