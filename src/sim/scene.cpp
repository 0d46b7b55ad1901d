#include "sim/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "core/random.h"

namespace erg::sim {
namespace {

// Scenes are drawn before the first step, with draws of their own.
constexpr std::uint64_t before_the_first_step = std::numeric_limits<std::uint64_t>::max();
enum Draw : std::uint64_t { draw_rounding, draw_scatter, draw_noise };

// A smooth rise from -1 to 1 while t goes from 0 to 1.
double ramp(double t) { return -std::cos(std::numbers::pi * t); }

// One wave, -1 in the trough (phase 0) to 1 at the crest (phase `rise`) and back; a mean of 0. rise 0.5 is a sine.
double wave(double phase, double rise) {
  const double place = phase - std::floor(phase);
  return place < rise ? ramp(place / rise) : -ramp((place - rise) / (1 - rise));
}

// A smooth bump: 1 in the middle, 0 at distance 1 and beyond.
double bump(double distance) { return std::abs(distance) < 1 ? 0.5 * (1 - ramp(std::abs(distance))) : 0; }

// A rectangle in shares of the grid.
struct Rectangle {
  double west, south, east, north;
  bool holds(double x, double y) const { return x >= west && x < east && y >= south && y < north; }
};
constexpr std::array<Rectangle, 3> three_rocks = {
    {{0.20, 0.60, 0.28, 0.78}, {0.42, 0.22, 0.52, 0.34}, {0.68, 0.50, 0.74, 0.74}}};

class SceneBuilder {
 public:
  SceneBuilder(const Config& config, double quantum)
      : scene_(config.scene),
        key_{static_cast<std::uint64_t>(config.run.integer("seed")), before_the_first_step},
        terrain_({static_cast<int>(config.grid.integer("nx")), static_cast<int>(config.grid.integer("ny"))},
                 config.grid.real("cell_size"), quantum,
                 config.grid.text("boundary") == "open" ? Boundary::open : Boundary::torus) {
    if (terrain_.boundary() == Boundary::open) terrain_.set_inflow(config.grid.real("inflow"));
  }

  Terrain build(const HeightPicture* picture) {
    const std::string& kind = scene_.text("kind");
    if (kind == "image") {
      image(picture);
    } else {
      lay_cover(scene_.real("sand"));
      shape(kind);
    }
    terrain_.open_ledger();
    return std::move(terrain_);
  }

 private:
  void shape(const std::string& kind) {
    if (kind == "random") return scatter();
    if (kind == "ripples") return sand_waves(0.5);
    if (kind == "transverse") return sand_waves(0.75);  // gentle on the west side, steep on the east
    if (kind == "rocks") return rocks();
    if (kind == "uneven") return uneven();
    if (kind == "cone") return cone();
    if (kind == "hump") return bedrock_shape([this](int x, int y) { return hump(x, y); });
    if (kind == "dune") return bedrock_shape([this](int x, int y) { return dune(x, y); });
    if (kind == "valley") return bedrock_shape([this](int x, int) { return valley(x); });
  }

  // Distances of a cell's centre from the middle of the grid, in cells.
  double east_of_middle(int x) const { return x + 0.5 - 0.5 * terrain_.nx(); }
  double north_of_middle(int y) const { return y + 0.5 - 0.5 * terrain_.ny(); }
  double share_of_radius(int x, int y) const {
    return std::hypot(east_of_middle(x), north_of_middle(y)) / scene_.real("radius");
  }

  std::int32_t quanta(double metres, const char* key) const {
    constexpr double most = 1e9;  // bedrock and sand together must fit 32 bits
    const double count = metres / terrain_.quantum();
    if (std::abs(count) <= most) return static_cast<std::int32_t>(std::lround(count));
    throw InputError(std::string("scene.") + key, "the ground would be more than a thousand million slabs high",
                     "choose a smaller height or a larger slab");
  }

  // Calls edit(x, y, cell) for every cell.
  template <typename Edit>
  void each_cell(const Edit& edit) {
    std::size_t cell = 0;
    for (int y = 0; y < terrain_.ny(); ++y) {
      for (int x = 0; x < terrain_.nx(); ++x) edit(x, y, cell++);
    }
  }

  // An even cover; a mean that is no whole number is met by rounding each cell at random.
  void lay_cover(double mean) {
    Grid<std::int32_t>& mobile = terrain_.edit_mobile();
    const double whole = std::floor(mean);
    each_cell([&](int, int, std::size_t cell) {
      const bool up = random_unit(key_, draw_rounding, cell, 0) < mean - whole;
      mobile[cell] = static_cast<std::int32_t>(whole) + (up ? 1 : 0);
    });
  }

  // One slab more or less in each cell that has sand.
  void scatter() {
    Grid<std::int32_t>& mobile = terrain_.edit_mobile();
    each_cell([&](int, int, std::size_t cell) {
      if (mobile[cell] > 0) mobile[cell] += random_below(key_, draw_scatter, cell, 0, 2) == 0 ? -1 : 1;
    });
  }

  // The wavelength that fits the width a whole number of times on a torus.
  double fitted_wavelength() const {
    const double wanted = scene_.real("wavelength");
    if (terrain_.boundary() == Boundary::open) return wanted;
    return terrain_.nx() / std::max(1.0, std::round(terrain_.nx() / wanted));
  }

  // Waves across x in the sand, no deeper than there is sand.
  void sand_waves(double rise) {
    const double wanted = 0.5 * quanta(scene_.real("height"), "height");
    const double amplitude = std::min(wanted, std::floor(scene_.real("sand")));
    const double wavelength = fitted_wavelength();
    Grid<std::int32_t>& mobile = terrain_.edit_mobile();
    each_cell([&](int x, int, std::size_t cell) {
      const double change = amplitude * wave((x + 0.5) / wavelength, rise);
      mobile[cell] += static_cast<std::int32_t>(std::lround(change));
    });
  }

  // Bedrock of `height` times a share in [0, 1], under the cover.
  void bedrock_shape(const std::function<double(int, int)>& share) {
    const std::int32_t height = quanta(scene_.real("height"), "height");
    Grid<std::int32_t>& bedrock = terrain_.edit_bedrock();
    each_cell([&](int x, int y, std::size_t cell) {
      bedrock[cell] = static_cast<std::int32_t>(std::lround(height * share(x, y)));
    });
  }

  // A Gaussian with its foot (a hundredth of the height) at the radius.
  double hump(int x, int y) const {
    const double distance = 3 * share_of_radius(x, y);
    return std::exp(-0.5 * distance * distance);
  }

  // Gentle on the west side, steep on the east, rounded off to the north and south.
  double dune(int x, int y) const {
    constexpr double crest = 1.0 / 3;
    const double along = east_of_middle(x) / scene_.real("radius");
    const double from_crest = along < crest ? (crest - along) / (1 + crest) : (along - crest) / (1 - crest);
    return bump(from_crest) * bump(north_of_middle(y) / scene_.real("radius"));
  }

  double valley(int x) const { return 0.5 + 0.5 * wave(east_of_middle(x) / fitted_wavelength(), 0.5); }

  void rocks() {
    const std::int32_t height = quanta(scene_.real("height"), "height");
    Grid<std::int32_t>& bedrock = terrain_.edit_bedrock();
    Grid<std::int32_t>& mobile = terrain_.edit_mobile();
    each_cell([&](int x, int y, std::size_t cell) {
      const double east = (x + 0.5) / terrain_.nx();
      const double north = (y + 0.5) / terrain_.ny();
      for (const Rectangle& rock : three_rocks) {
        if (!rock.holds(east, north)) continue;
        bedrock[cell] = height;
        mobile[cell] = 0;
      }
    });
  }

  void cone() {
    const std::int32_t height = quanta(scene_.real("height"), "height");
    Grid<std::int32_t>& mobile = terrain_.edit_mobile();
    each_cell([&](int x, int y, std::size_t cell) {
      mobile[cell] += static_cast<std::int32_t>(std::lround(height * std::max(0.0, 1 - share_of_radius(x, y))));
    });
  }

  // Random values on a lattice of about one point per `spacing`, joined smoothly; the lattice closes over the edges.
  double lattice_noise(double x, double y, double spacing, std::uint64_t octave) const {
    const int columns = std::max(1, static_cast<int>(std::lround(terrain_.nx() / spacing)));
    const int rows = std::max(1, static_cast<int>(std::lround(terrain_.ny() / spacing)));
    const double u = x * columns / terrain_.nx();
    const double v = y * rows / terrain_.ny();
    const auto smooth = [](double t) { return t * t * t * (t * (6 * t - 15) + 10); };
    const double right = smooth(u - std::floor(u));
    const double up = smooth(v - std::floor(v));
    const auto value = [&](int dx, int dy) {
      const int column = wrap(static_cast<int>(std::floor(u)) + dx, columns);
      const int row = wrap(static_cast<int>(std::floor(v)) + dy, rows);
      return random_unit(key_, draw_noise, static_cast<std::uint64_t>(row) * columns + column, octave);
    };
    const double below = value(0, 0) + (value(1, 0) - value(0, 0)) * right;
    const double above = value(0, 1) + (value(1, 1) - value(0, 1)) * right;
    return below + (above - below) * up;
  }

  // Three octaves of noise, stretched so that it spans `height` exactly. Crests are about a wavelength apart: two
  // lattice points.
  void uneven() {
    const double spacing = 0.5 * scene_.real("wavelength");
    Grid<float> noise(terrain_.extent());
    each_cell([&](int x, int y, std::size_t cell) {
      double sum = 0;
      for (int octave = 0; octave < 3; ++octave) {
        const double part = std::ldexp(1.0, -octave);
        sum += part * lattice_noise(x + 0.5, y + 0.5, spacing * part, static_cast<std::uint64_t>(octave));
      }
      noise[cell] = static_cast<float>(sum);
    });
    const auto ends = std::minmax_element(noise.cells().begin(), noise.cells().end());
    const float low = *ends.first;
    const double range = *ends.second > low ? *ends.second - low : 1.0;
    bedrock_shape([&](int x, int y) { return (noise(x, y) - low) / range; });
  }

  void image(const HeightPicture* picture) {
    if (picture == nullptr || picture->empty()) {
      throw InputError("scene.image", "the image scene has no picture", "name a grey PNG");
    }
    const std::string& role = scene_.text("image_role");
    if (role != "sand") lay_cover(scene_.real("sand"));
    const HeightRange range = image_heights(scene_, *picture);
    Grid<float> resampled;
    const Grid<float>& shade = on_grid(*picture, terrain_.extent(), resampled);
    Grid<std::int32_t>& bedrock = terrain_.edit_bedrock();
    Grid<std::int32_t>& mobile = terrain_.edit_mobile();
    each_cell([&](int, int, std::size_t cell) {
      const std::int32_t height = quanta(range.low + (range.high - range.low) * shade[cell], "image_high");
      if (role == "sand") {
        mobile[cell] = std::max(0, height);
      } else {
        bedrock[cell] = role == "both" ? height - mobile[cell] : height;
      }
    });
  }

  const ParameterValues& scene_;
  StepKey key_;
  Terrain terrain_;
};

}  // namespace

HeightRange image_heights(const ParameterValues& scene, const HeightPicture& picture) {
  if (picture.metres && !scene.is_set("image_low") && !scene.is_set("image_high")) return *picture.metres;
  return {scene.real("image_low"), scene.real("image_high")};
}

Terrain build_scene(const Config& config, double quantum, const HeightPicture* picture) {
  return SceneBuilder(config, quantum).build(picture);
}

}  // namespace erg::sim
