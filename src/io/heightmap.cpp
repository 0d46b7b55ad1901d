#include "io/heightmap.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "core/errors.h"
#include "core/exact_text.h"
#include "core/surface_range.h"
#include "io/png.h"

// The library reads many formats. Each of them is one more way in for a damaged file, and only this one is asked for.
// Linear colours would pull in functions of libm.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_LINEAR
#include <stb/stb_image.h>

namespace erg {
namespace {

// Pictures larger than the largest grid are refused before they are decoded.
constexpr int largest_picture = 2 * largest_side;

}  // namespace

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
  MetadataEntries entries = {{"erg:low_m", exact_text(terrain.metres(low))},
                             {"erg:high_m", exact_text(terrain.metres(high))},
                             {"erg:cell_m", exact_text(terrain.cell_size())}};
  for (auto& entry : metadata(provenance)) entries.push_back(std::move(entry));
  keep_config_beside(path, provenance);
  write_png(path, image, entries);
}

HeightPicture read_height_picture(const std::filesystem::path& path) {
  const auto refuse = [&path](const std::string& problem, const std::string& remedy) {
    throw InputError(path.string(), problem, remedy);
  };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) refuse("the picture cannot be opened", "check the name and the permissions");
  int width = 0;
  int height = 0;
  int channels = 0;
  if (stbi_info_from_file(file.get(), &width, &height, &channels) == 0) {
    refuse("this is no picture that can be read, or it is damaged", "give an 8- or 16-bit grey PNG");
  }
  if (width > largest_picture || height > largest_picture) {
    refuse("the picture has " + std::to_string(width) + " x " + std::to_string(height) + " pixels",
           "give one of at most " + std::to_string(largest_picture) + " on a side");
  }
  // 8-bit pictures come out as 16 bits too, each value times 257.
  const std::unique_ptr<stbi_us, void (*)(void*)> pixels(
      stbi_load_from_file_16(file.get(), &width, &height, &channels, STBI_grey), stbi_image_free);
  if (!pixels) refuse(std::string("the picture is damaged (") + stbi_failure_reason() + ")", "make it anew");
  HeightPicture picture({width, height});
  for (int y = 0; y < height; ++y) {
    const stbi_us* const row = pixels.get() + static_cast<std::ptrdiff_t>(height - 1 - y) * width;
    for (int x = 0; x < width; ++x) picture(x, y) = static_cast<float>(row[x]) / 65535.0f;
  }
  return picture;
}

}  // namespace erg
