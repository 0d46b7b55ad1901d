#include "io/formats/heightmap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>

#include "core/errors.h"
#include "core/number_text.h"
#include "core/surface_range.h"
#include "io/files/file_kind.h"
#include "io/files/given_file.h"
#include "io/formats/png.h"
#include "io/formats/png_reader.h"
#include "sim/memory.h"

namespace erg::io {

using sim::free_memory;
using sim::HeightPicture;
using sim::HeightRange;
using sim::memory_text;
using sim::NoDataRule;
using sim::PictureResampler;

namespace {

namespace fs = std::filesystem;

constexpr const char* colours_to_heights =
    "give heights as greys: of elevation data gdal_translate -of PNG -ot UInt16 -scale LOW HIGH 0 65535 IN OUT.png "
    "makes "
    "them; elevations coded in colours have to be decoded first (gdal_calc.py); only where brightness is height: "
    "magick IN "
    "-colorspace Gray -depth 16 OUT.png";

constexpr const char* low_key = "erg:low_m";
constexpr const char* high_key = "erg:high_m";
constexpr const char* cell_key = "erg:cell_m";

std::optional<double> number_under(const MetadataEntries& entries, const std::string& key) {
  for (const auto& [name, text] : entries) {
    if (name == key) return number_from<double>(text);
  }
  return std::nullopt;
}

/// The picture opened, once it is known to be a PNG that can be read as heights.
PngReader open_picture(const fs::path& path) {
  if (const auto trouble = file_trouble(path, "picture")) throw InputError({*trouble});
  if (const auto kind = file_kind(path)) {
    throw InputError(path.string(), "this is no PNG but " + kind->name, kind->conversion);
  }
  return PngReader(path);
}

/// A picture on its way to heights.
class HeightReading {
 public:
  HeightReading(const fs::path& path, const HeightPictureOptions& options)
      : path_(path), options_(options), reader_(open_picture(path)) {
    check_memory();
    if (options_.grid.cells() == 0) options_.grid = extent();
  }

  HeightPicture read(std::vector<std::string>* notes);
  HeightPictureHeader header() const { return {extent(), number_under(reader_.text(), cell_key)}; }

 private:
  Extent extent() const { return {reader_.width(), reader_.height()}; }
  void check_memory() const;
  void read_row(int row, std::span<const std::uint16_t> samples, PictureResampler& resampler);
  std::optional<HeightRange> metres() const;
  void tell_shape(std::vector<std::string>& notes) const;

  [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const {
    throw InputError(path_.string(), problem, remedy);
  }
  static std::string place(std::size_t column, int row) {
    return "column " + std::to_string(column + 1) + ", row " + std::to_string(row + 1) + " from the top";
  }

  fs::path path_;
  HeightPictureOptions options_;
  PngReader reader_;
  std::vector<float> values_;
  std::vector<std::uint8_t> missing_;
};

std::string sides(Extent extent) { return std::to_string(extent.nx) + " x " + std::to_string(extent.ny); }

void HeightReading::check_memory() const {
  const std::uint64_t held = reader_.held_bytes();
  if (!reader_.interlaced() || held <= free_memory()) return;
  refuse("the picture is interlaced and has to be held whole: that needs " + memory_text(held) + " of memory, and " +
             memory_text(free_memory()) + " are free",
         "write it without interlacing: magick IN -interlace none OUT.png");
}

void HeightReading::read_row(int row, std::span<const std::uint16_t> samples, PictureResampler& resampler) {
  const auto channels = static_cast<std::size_t>(reader_.channels());
  const bool opacity = reader_.has_opacity();
  bool any_missing = false;
  for (std::size_t x = 0; x < values_.size(); ++x) {
    const std::uint16_t* const pixel = samples.data() + x * channels;
    const bool without = opacity && pixel[channels - 1] != 65535;
    if (without && options_.no_data == NoDataRule::refuse) {
      refuse("the picture has transparent pixels, the first in " + place(x, row) + ": nothing was measured there",
             "say what lies there with \"image_nodata\": \"lowest\" or \"around\" (a scene's picture), or fill them");
    }
    if (!without && channels >= 3 && (pixel[0] != pixel[1] || pixel[0] != pixel[2])) {
      refuse(std::string("the picture has colours") + (reader_.colours() == PngColours::palette ? " (a palette)" : "") +
                 ", the first in " + place(x, row) + ", and these are no heights",
             colours_to_heights);
    }
    missing_[x] = without ? 1 : 0;
    any_missing = any_missing || without;
    values_[x] = static_cast<float>(pixel[0]) / 65535.0f;
  }
  const std::span<const std::uint8_t> missing = any_missing ? missing_ : std::span<const std::uint8_t>();
  resampler.add_row(reader_.height() - 1 - row, values_, missing);
}

/// What the picture says of its heights, where it does and they can be heights.
std::optional<HeightRange> HeightReading::metres() const {
  const MetadataEntries entries = reader_.text();
  const auto low = number_under(entries, low_key);
  const auto high = number_under(entries, high_key);
  if (!low || !high || !(*low <= *high)) return std::nullopt;
  return HeightRange{*low, *high};
}

void HeightReading::tell_shape(std::vector<std::string>& notes) const {
  const Extent grid = options_.grid;
  constexpr double alike = 1.01;  // sides are whole numbers
  const double stretched =
      static_cast<double>(reader_.width()) * grid.ny / (static_cast<double>(reader_.height()) * grid.nx);
  if (std::max(stretched, 1 / stretched) < alike) return;
  const std::string both =
      path_.string() + " has " + sides(extent()) + " pixels and the grid " + sides(grid) + " cells: ";
  notes.push_back(both + (options_.fit == sim::PictureFit::crop
                              ? "its middle is taken (image_fit crop)"
                              : "it is stretched to another shape; a scene's image_fit may be crop or from_file"));
}

HeightPicture HeightReading::read(std::vector<std::string>* notes) {
  values_.resize(static_cast<std::size_t>(reader_.width()));
  missing_.resize(values_.size());
  PictureResampler resampler(extent(), options_.grid, options_.fit);
  reader_.read_rows([&](int row, std::span<const std::uint16_t> samples) { read_row(row, samples, resampler); });
  const double without = resampler.share_missing();
  if (without == 1) refuse("no pixel of the picture has data: all are transparent", "give one that has");
  if (notes != nullptr) {
    tell_shape(*notes);
    if (without > 0) {
      char percent[16];
      std::snprintf(percent, sizeof percent, "%.2g%%", 100 * without);
      notes->push_back(path_.string() + ": " + percent + " of the cells have no data (transparent pixels); " +
                       (options_.no_data == NoDataRule::around ? "heights around them are carried on there"
                                                               : "they are at the lowest height") +
                       " (image_nodata)");
    }
  }
  HeightPicture picture(resampler.take(options_.no_data));
  picture.metres = metres();
  return picture;
}

}  // namespace

HeightPicture read_height_picture(const fs::path& path, const HeightPictureOptions& options,
                                  std::vector<std::string>* notes) {
  return HeightReading(path, options).read(notes);
}

HeightPictureHeader read_height_header(const fs::path& path) { return HeightReading(path, {}).header(); }

void write_heightmap(const std::filesystem::path& path, const Terrain& terrain, const Provenance& provenance) {
  const auto [low, high] = surface_range(terrain);
  GreyImage image{terrain.nx(), terrain.ny(), {}};
  image.pixels.reserve(terrain.extent().cells());
  const double scale = high > low ? 65535.0 / (static_cast<double>(high) - low) : 0.0;
  for (int y = terrain.ny() - 1; y >= 0; --y) {
    for (int x = 0; x < terrain.nx(); ++x) {
      image.pixels.push_back(static_cast<std::uint16_t>(std::lround((terrain.height(x, y) - low) * scale)));
    }
  }
  MetadataEntries entries = {{low_key, format_shortest(terrain.metres(low))},
                             {high_key, format_shortest(terrain.metres(high))},
                             {cell_key, format_shortest(terrain.cell_size())}};
  for (auto& entry : metadata_of_file(path, provenance)) entries.push_back(std::move(entry));
  write_png(path, image, entries);
}

}  // namespace erg::io
