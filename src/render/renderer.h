// Draws a view of a terrain: the one picture maker for the window, the command line and the tests.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "picture/image.h"
#include "render/camera.h"
#include "render/look.h"
#include "render/quality.h"
#include "render/shader_program.h"
#include "render/terrain_view.h"

namespace erg::render {

/// How large a picture is, and how carefully it is drawn.
struct PictureSize {
  int width = 1920;     ///< pixels
  int height = 1080;    ///< pixels
  int supersample = 2;  ///< drawn so many times larger each way, then averaged in linear light
};

/// A picture with what belongs to it.
struct Picture {
  picture::RgbaImage image;
  std::optional<ValueScale> scale;  ///< of the values shown; none for materials
  std::vector<std::string> notes;   ///< what a person should know: values that are no numbers, blocks of cells
  std::int64_t triangles = 0;

  /// Without opacity, over white where nothing is.
  picture::RgbImage opaque() const;
};

/// Lives with one OpenGL context, which must be current whenever it is used and when it goes.
class Renderer {
 public:
  /// Compiles the shaders of a folder. Throws InputError with file, line and message.
  explicit Renderer(const std::filesystem::path& shaders = shader_folder());
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// How much work goes into the pictures to come; at first all there is.
  void set_quality(const RenderQuality& quality);

  /// Draws into memory. Throws InputError for a look or size that cannot be.
  Picture draw(const TerrainView& view, const Look& look, const picture::Camera& camera, const PictureSize& size);

  /// Draws the terrain (no writing) into the lower left of a frame buffer of the context: 0 is the window's. Returns
  /// what a person should know.
  std::vector<std::string> draw_into(unsigned frame_buffer, const TerrainView& view, const Look& look,
                                     const picture::Camera& camera, int width, int height);

  /// The block of terrain of a view, for cameras.
  static TerrainBox box_of(const TerrainView& view, const Look& look);

  /// The point of the terrain of the last drawing that is seen at a place of the picture.
  std::optional<Eigen::Vector3d> terrain_under(const picture::Camera& camera, PicturePoint point, double aspect) const;
  /// Height of the terrain of the last drawing, m; for keep_above.
  double ground_height(double east, double north) const;

  /// Texels uploaded since the beginning.
  std::int64_t uploaded_texels() const;
  /// Texels of the smooth surface computed since the beginning.
  std::int64_t computed_texels() const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace erg::render
