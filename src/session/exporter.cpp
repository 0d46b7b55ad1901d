#include "session/exporter.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <utility>

#include "core/errors.h"
#include "io/checkpoint/checkpoint.h"
#include "io/config/config_file.h"
#include "io/formats/heightmap.h"
#include "io/formats/mesh.h"
#include "io/formats/picture.h"
#include "io/formats/png.h"
#include "io/formats/table.h"
#include "io/formats/vti.h"
#include "kernels/shadow.h"
#include "sim/memory.h"

namespace erg::session {

using io::Provenance;
using io::WriteProgress;
using models::find_model;

namespace {

namespace fs = std::filesystem;

void write_map(const fs::path& path, const RunSnapshot& run, const Provenance& source) {
  io::PictureOptions options;
  options.wind = run.last_wind;
  options.caption = find_model(run.config->model).info.title + ", step " + std::to_string(run.step);
  io::write_run_png(path, io::draw_picture(*run.terrain, options), source);
}

void write_volume(const fs::path& path, const RunSnapshot& run, const Provenance& source) {
  const double fall = find_model(run.config->model).make(run.config->parameters)->shadow_fall(run.terrain->cell_size());
  const Grid<std::uint8_t> shadow = kernels::shadow_map(*run.terrain, run.last_wind.bearing, fall);
  io::write_vti(path, *run.terrain, &shadow, source, {run.flux.get(), run.flux ? std::size_t{1} : 0});
}

/// A format with the function that writes it.
struct Writer {
  ExportFormat format;
  std::function<void(const fs::path&, const RunSnapshot&, const Provenance&, const WriteProgress&)> write;
};

const std::vector<Writer>& writers() {
  static const std::vector<Writer> all{
      {{"png", "Map (PNG)", ".png", "The top view, lit by the sun, with scale bar and wind.", Keeps::nothing, "-map"},
       [](const auto& path, const auto& run, const auto& source, const auto&) { write_map(path, run, source); }},
      {{"png16", "Heightmap (16-bit PNG)", ".png", "Heights as grey, one pixel a cell; low and high in its text.",
        Keeps::nothing, "-heights"},
       [](const auto& path, const auto& run, const auto& source, const auto&) {
         io::write_heightmap(path, *run.terrain, source);
       }},
      {{"vti", "VTK image data", ".vti", "Surface, sand, bedrock, shadow and every field, for ParaView."},
       [](const auto& path, const auto& run, const auto& source, const auto&) { write_volume(path, run, source); }},
      {{"obj", "Mesh (Wavefront OBJ)", ".obj",
        "The surface as triangles in m, z up: text that every 3D program reads."},
       [](const auto& path, const auto& run, const auto& source, const auto& progress) {
         io::write_obj(path, *run.terrain, source, progress);
       }},
      {{"ply", "Mesh (PLY)", ".ply", "The surface as triangles in m, with the thickness of the sand at each point."},
       [](const auto& path, const auto& run, const auto& source, const auto& progress) {
         io::write_ply(path, *run.terrain, source, progress);
       }},
      {{"stl", "Solid (STL)", ".stl", "A closed body with a flat floor, in m, for 3D printing."},
       [](const auto& path, const auto& run, const auto& source, const auto& progress) {
         io::write_stl(path, *run.terrain, source, progress);
       }},
      {{"csv", "Numbers (CSV)", ".csv", "The run's numbers over time, as the plots show them."},
       [](const auto& path, const auto& run, const auto& source, const auto&) {
         write_series(path, *run.series, source);
       }},
      {{"checkpoint", "Checkpoint", ".checkpoint", "The whole run: it goes on from here to the same bits.",
        Keeps::terrain},
       [](const auto& path, const auto& run, const auto&, const auto&) {
         io::write_checkpoint(path, *run.config, run.state());
       }},
      {{"json", "Config (JSON)", ".json", "What the run was set up with; `erg run` takes it.", Keeps::setup},
       [](const auto& path, const auto& run, const auto&, const auto&) { io::write_config(path, *run.config); }}};
  return all;
}

}  // namespace

const std::vector<ExportFormat>& export_formats() {
  static const std::vector<ExportFormat> formats = [] {
    std::vector<ExportFormat> all;
    for (const Writer& writer : writers()) all.push_back(writer.format);
    return all;
  }();
  return formats;
}

Keeps kept_by(const std::string& format) {
  const auto found = std::ranges::find(export_formats(), format, &ExportFormat::key);
  return found == export_formats().end() ? Keeps::nothing : found->keeps;
}

void export_run(const fs::path& path, const std::string& format, const RunSnapshot& run,
                const WriteProgress& progress) {
  std::vector<std::string> keys;
  for (const Writer& writer : writers()) {
    keys.push_back(writer.format.key);
    if (writer.format.key != format) continue;
    return writer.write(path, run, io::provenance_of(*run.config, run.step, run.executor, run.threads), progress);
  }
  throw InputError("export", "unknown format " + quote(format), suggestion(format, keys));
}

Export::Export(fs::path path, std::string format, std::shared_ptr<const Snapshot> snapshot, std::size_t run)
    : path_(std::move(path)), thread_([this, format = std::move(format), snapshot = std::move(snapshot), run] {
        write(format, snapshot->runs.at(run));
      }) {}

Export::~Export() {
  stop_ = true;
  thread_.join();
}

void Export::write(const std::string& format, const RunSnapshot& run) {
  const auto progress = [this](double part) {
    progress_ = part;
    return !stop_;
  };
  try {
    export_run(path_, format, run, progress);
    progress_ = 1;
    state_ = State::done;
  } catch (const io::StoppedWriting&) {
    state_ = State::stopped;
  } catch (const InputError& error) {  // names the file itself
    problem_ = error.what();
    state_ = State::failed;
  } catch (const std::exception& error) {
    problem_ = path_.string() + ": " + sim::problem_of(error);
    state_ = State::failed;
  }
}

}  // namespace erg::session
