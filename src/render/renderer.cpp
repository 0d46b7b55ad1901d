#include "render/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/errors.h"
#include "core/surface_range.h"
#include "core/units.h"
#include "render/overlays.h"
#include "render/scene_painter.h"
#include "render/terrain_maps.h"
#include "render/textures.h"

namespace erg::render {

using picture::Camera;
using picture::over;
using picture::RgbaImage;
using picture::RgbImage;

namespace {

constexpr double clearance = 0.02;  // of the terrain's shorter side: how far the camera keeps from the ground

// sRGB bytes to linear light.
const std::array<float, 256>& linear_table() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> made{};
    for (std::size_t value = 0; value < made.size(); ++value) {
      const double part = static_cast<double>(value) / 255;
      made[value] = static_cast<float>(part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4));
    }
    return made;
  }();
  return table;
}

std::uint8_t to_byte(double linear) {
  const double part = linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0, 1.0) * 255));
}

// One pixel of the result: the mean of a square of drawn pixels, colours weighed by opacity.
void mean_pixel(const std::uint8_t* first, std::size_t row_bytes, int side, std::uint8_t* to) {
  std::array<double, 3> light{};
  double opacity = 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const std::uint8_t* const from =
          first + static_cast<std::size_t>(y) * row_bytes + 4 * static_cast<std::size_t>(x);
      const double share = from[3] / 255.0;
      opacity += share;
      for (std::size_t part = 0; part < 3; ++part) light[part] += share * linear_table()[from[part]];
    }
  }
  for (std::size_t part = 0; part < 3; ++part) to[part] = opacity > 0 ? to_byte(light[part] / opacity) : 0;
  to[3] = static_cast<std::uint8_t>(std::lround(255 * opacity / (side * side)));
}

// Drawn pixels (rows from below) to a picture (rows from above), averaged.
RgbaImage shrink(const std::vector<std::uint8_t>& drawn, const PictureSize& size) {
  RgbaImage image{size.width, size.height, {}};
  const auto width = static_cast<std::size_t>(size.width);
  image.pixels.resize(4 * width * static_cast<std::size_t>(size.height));
  const auto side = static_cast<std::size_t>(size.supersample);
  const std::size_t row_bytes = 4 * width * side;
  for (std::size_t y = 0; y < static_cast<std::size_t>(size.height); ++y) {
    const std::uint8_t* const row = drawn.data() + (static_cast<std::size_t>(size.height) - 1 - y) * side * row_bytes;
    std::uint8_t* const to = image.pixels.data() + 4 * y * width;
    if (side == 1) {
      std::copy_n(row, row_bytes, to);
      continue;
    }
    for (std::size_t x = 0; x < width; ++x) mean_pixel(row + 4 * x * side, row_bytes, size.supersample, to + 4 * x);
  }
  return image;
}

void check_size(const PictureSize& size) {
  constexpr int largest = 16384;
  const bool good = size.width >= 1 && size.height >= 1 && size.width <= largest && size.height <= largest;
  if (!good) {
    throw InputError("size", std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels",
                     "expected 1 to " + std::to_string(largest) + " each way");
  }
  if (size.supersample < 1 || size.supersample > 4) {
    throw InputError("supersample", "is " + std::to_string(size.supersample), "expected 1 to 4");
  }
}

// A picture in which nothing can be shown: the colour of missing values.
Picture empty_picture(const PictureSize& size) {
  Picture picture;
  picture.image = {size.width, size.height, {}};
  for (int pixel = 0; pixel < size.width * size.height; ++pixel) {
    picture.image.pixels.insert(picture.image.pixels.end(), {255, 0, 238, 255});
  }
  picture.notes.emplace_back("there is no terrain to draw");
  return picture;
}

void take_opaque(RgbaImage& image, const RgbImage& plain) {
  for (std::size_t pixel = 0; pixel < image.pixels.size() / 4; ++pixel) {
    std::copy_n(plain.pixels.data() + 3 * pixel, 3, image.pixels.data() + 4 * pixel);
    image.pixels[4 * pixel + 3] = 255;
  }
}

void lay_on_white(RgbaImage& image) { take_opaque(image, over(image, {1, 1, 1})); }

void write_over(RgbaImage& image, const Overlay& overlay) {
  RgbImage plain = over(image, {1, 1, 1});
  draw_overlay(plain, overlay);
  take_opaque(image, plain);
}

bool is_empty(const TerrainView& view) { return view.terrain == nullptr || view.terrain->extent().cells() == 0; }

}  // namespace

// What lives on the graphics card.
struct Renderer::Work {
  explicit Work(const std::filesystem::path& shaders) : maps(shaders), painter(shaders) {}

  void paint(PaintRequest request, unsigned frame_buffer);

  TerrainMaps maps;
  ScenePainter painter;
  PictureTarget target;
  PictureTarget coarse;  // for fewer pixels than the picture has
  RenderQuality quality;
};

void Renderer::Work::paint(PaintRequest request, unsigned frame_buffer) {
  const int width = request.width, height = request.height;
  if (quality.coarseness > 1) {
    request.width = std::max(1, width / quality.coarseness);
    request.height = std::max(1, height / quality.coarseness);
    coarse.prepare(request.width, request.height);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, quality.coarseness > 1 ? coarse.frame() : frame_buffer);
  gl11().Viewport(0, 0, request.width, request.height);
  painter.paint(request);
  if (quality.coarseness == 1) return;
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, frame_buffer);
  glBlitFramebuffer(0, 0, request.width, request.height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_buffer);
  gl11().Viewport(0, 0, width, height);
}

RgbImage Picture::opaque() const { return over(image, {1, 1, 1}); }

Renderer::Renderer(const std::filesystem::path& shaders) : work_(std::make_unique<Work>(shaders)) {}
Renderer::~Renderer() = default;

void Renderer::set_quality(const RenderQuality& quality) { work_->quality = quality; }

TerrainBox Renderer::box_of(const TerrainView& view, const Look& look) {
  if (is_empty(view)) return {};
  const Terrain& terrain = *view.terrain;
  const SurfaceRange range = surface_range(terrain);
  return {terrain.nx() * terrain.cell_size(), terrain.ny() * terrain.cell_size(),
          terrain.metres(range.low) * look.exaggeration, terrain.metres(range.high) * look.exaggeration};
}

Picture Renderer::draw(const TerrainView& view, const Look& look, const Camera& camera, const PictureSize& size) {
  check_size(size);
  if (is_empty(view)) return empty_picture(size);
  check_look(look, view);
  work_->target.prepare(size.width * size.supersample, size.height * size.supersample);
  Picture picture;
  picture.notes = draw_into(work_->target.frame(), view, look, camera, size.width * size.supersample,
                            size.height * size.supersample);
  picture.triangles = work_->painter.triangles();
  picture.image = shrink(work_->target.read(), size);
  if (!look.transparent) lay_on_white(picture.image);
  if (!look.is_material()) picture.scale = work_->maps.scale();
  if (look.legend && !look.transparent) {
    Overlay overlay{.scale = picture.scale,
                    .contours = look.contours,
                    .contour_unit = picture.scale ? picture.scale->unit : "m",
                    .wind = view.wind,
                    .pixel_size = {},
                    .camera_bearing = camera.bearing};
    if (camera.orthographic && camera.altitude == 90) {
      overlay.pixel_size = 2 * camera.distance * std::tan(radians(0.5 * camera.opening)) / size.height;
    }
    write_over(picture.image, overlay);
  }
  return picture;
}

std::vector<std::string> Renderer::draw_into(unsigned frame_buffer, const TerrainView& view, const Look& look,
                                             const Camera& camera, int width, int height) {
  std::vector<std::string> notes;
  work_->maps.update({view, look, work_->quality, camera, height}, notes);
  Camera above = camera;
  const TerrainBox box = work_->maps.box();
  const double keep = std::min(clearance * std::min(box.east, box.north), 2 * work_->maps.cell_side());
  const bool over_terrain =
      look.copies > 0 ||
      Eigen::AlignedBox2d(Eigen::Vector2d(0, 0), Eigen::Vector2d(box.east, box.north)).contains(eye(camera).head<2>());
  if (!camera.orthographic && over_terrain) {
    keep_above(
        above, [this](double east, double north) { return ground_height(east, north); }, keep);
  }
  work_->paint({view, look, above, work_->maps, work_->quality, width, height}, frame_buffer);
  return notes;
}

std::optional<Eigen::Vector3d> Renderer::terrain_under(const Camera& camera, PicturePoint point, double aspect) const {
  const Sight line = sight(camera, point, aspect);
  const TerrainBox box = work_->maps.box();
  const double reach = 2 * camera.distance + box.east + box.north;
  const double step = 0.5 * work_->maps.cell_side();
  for (double way = 0; way < reach; way += step) {
    const Eigen::Vector3d place = line.from + way * line.direction;
    const bool inside = place.x() >= 0 && place.y() >= 0 && place.x() <= box.east && place.y() <= box.north;
    if (inside && place.z() <= ground_height(place.x(), place.y())) return place;
    if (place.z() < box.low && line.direction.z() <= 0) break;
  }
  return std::nullopt;
}

double Renderer::ground_height(double east, double north) const { return work_->maps.height_at(east, north); }

std::int64_t Renderer::uploaded_texels() const { return work_->maps.uploaded_texels(); }

std::int64_t Renderer::computed_texels() const { return work_->maps.computed_texels(); }

}  // namespace erg::render
