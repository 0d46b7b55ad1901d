// Textures that hold the terrain, and targets to draw into.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/grid.h"
#include "render/gl.h"

namespace erg::render {

/// A part of a texture or grid.
struct TexelRect {
  int left = 0;
  int low = 0;
  int wide = 0;
  int high = 0;

  bool operator==(const TexelRect&) const = default;
};

/// The parts of a grid that a rectangle covers. On a torus what reaches over an edge comes in again on the other side;
/// otherwise it is cut off.
std::vector<TexelRect> inside_of(const TexelRect& rect, Extent extent, bool periodic);

/// A float texture of one or two channels, one texel a cell. An update uploads only tiles in which something changed.
class TiledTexture {
 public:
  static constexpr int tile_side = 64;  ///< texels

  explicit TiledTexture(int channels) : channels_(channels) {}

  /// Brings the texture to these values (row by row from the south, channels interleaved). Returns the tiles that
  /// changed, neighbours in a row as one.
  std::vector<TexelRect> update(Extent extent, bool periodic, std::span<const float> values);
  GLuint id() const { return texture_.id(); }
  Extent extent() const { return extent_; }
  /// The first channel of a texel.
  float value(int x, int y) const { return held_[offset(x, y)]; }
  /// Texels uploaded since the beginning.
  std::int64_t uploaded_texels() const { return uploaded_texels_; }

 private:
  void allocate(Extent extent, bool periodic);
  bool tile_changed(const TexelRect& tile, std::span<const float> values) const;
  void take(const TexelRect& tile, std::span<const float> values);
  std::size_t offset(int x, int y) const {
    return static_cast<std::size_t>(channels_) *
           (static_cast<std::size_t>(y) * static_cast<std::size_t>(extent_.nx) + static_cast<std::size_t>(x));
  }

  int channels_;
  GlObject texture_;
  Extent extent_;
  bool periodic_ = true;
  std::vector<float> held_;
  std::int64_t uploaded_texels_ = 0;
};

/// A texture that can be drawn into.
class MapTarget {
 public:
  /// Makes a texture of this size and format when it is not so already.
  void prepare(Extent size, GLint format, bool periodic);
  /// Directs drawing into it.
  void bind() const;
  GLuint id() const { return texture_.id(); }
  Extent size() const { return size_; }

 private:
  GlObject texture_;
  GlObject frame_;
  Extent size_;
  GLint format_ = 0;
  bool periodic_ = true;
};

/// A picture with depth to draw into.
class PictureTarget {
 public:
  /// Throws InputError when the driver makes no picture of this size.
  void prepare(int width, int height);
  GLuint frame() const { return frame_.id(); }
  /// Red, green, blue, opacity, rows from below.
  std::vector<std::uint8_t> read() const;
  /// Puts such pixels in, of the size that it was prepared for.
  void write(std::span<const std::uint8_t> pixels) const;

 private:
  GlObject colour_;
  GlObject depth_;
  GlObject frame_;
  int width_ = 0;
  int height_ = 0;
};

/// The longest side that a texture may have.
int largest_texture();

}  // namespace erg::render
