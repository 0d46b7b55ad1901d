#include "render/textures.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/errors.h"

namespace erg::render {
namespace {

void set_sampling(GLint filter, bool periodic) {
  const GLint edge = periodic ? GL_REPEAT : GL_CLAMP_TO_EDGE;
  gl11().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  gl11().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  gl11().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, edge);
  gl11().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, edge);
}

GLenum channels_of(int count) { return count == 1 ? GL_RED : GL_RG; }

// A stretch of a line of `count` places, in one or two parts inside of it: first place and length.
std::vector<std::pair<int, int>> stretches(int first, int length, int count, bool periodic) {
  if (!periodic) {
    const int from = std::max(first, 0);
    const int end = std::min(first + length, count);
    return from < end ? std::vector<std::pair<int, int>>{{from, end - from}} : std::vector<std::pair<int, int>>{};
  }
  if (length >= count) return {{0, count}};
  const int from = wrap(first, count);
  if (from + length <= count) return {{from, length}};
  return {{from, count - from}, {0, from + length - count}};
}

}  // namespace

std::vector<TexelRect> inside_of(const TexelRect& rect, Extent extent, bool periodic) {
  std::vector<TexelRect> parts;
  for (const auto& [low, high] : stretches(rect.low, rect.high, extent.ny, periodic)) {
    for (const auto& [left, wide] : stretches(rect.left, rect.wide, extent.nx, periodic)) {
      parts.push_back({left, low, wide, high});
    }
  }
  return parts;
}

void TiledTexture::allocate(Extent extent, bool periodic) {
  if (!texture_) texture_ = GlObject::texture();
  gl11().BindTexture(GL_TEXTURE_2D, texture_.id());
  gl11().TexImage2D(GL_TEXTURE_2D, 0, channels_ == 1 ? GL_R32F : GL_RG32F, extent.nx, extent.ny, 0,
                    channels_of(channels_), GL_FLOAT, nullptr);
  set_sampling(GL_LINEAR, periodic);
  extent_ = extent;
  periodic_ = periodic;
  held_.clear();
}

std::vector<TexelRect> TiledTexture::update(Extent extent, bool periodic, std::span<const float> values) {
  glActiveTexture(GL_TEXTURE0);
  if (extent != extent_ || periodic != periodic_ || !texture_) allocate(extent, periodic);
  gl11().BindTexture(GL_TEXTURE_2D, texture_.id());
  const bool fresh = held_.empty();
  held_.resize(values.size());
  std::vector<TexelRect> changed;
  for (int low = 0; low < extent.ny; low += tile_side) {
    for (int left = 0; left < extent.nx; left += tile_side) {
      const TexelRect tile{left, low, std::min(tile_side, extent.nx - left), std::min(tile_side, extent.ny - low)};
      if (!fresh && !tile_changed(tile, values)) continue;
      take(tile, values);
      const bool goes_on =
          !changed.empty() && changed.back().low == low && changed.back().left + changed.back().wide == left;
      if (goes_on) {
        changed.back().wide += tile.wide;
      } else {
        changed.push_back(tile);
      }
    }
  }
  return changed;
}

bool TiledTexture::tile_changed(const TexelRect& tile, std::span<const float> values) const {
  for (int row = 0; row < tile.high; ++row) {
    const std::size_t start = offset(tile.left, tile.low + row);
    const std::size_t bytes = sizeof(float) * static_cast<std::size_t>(channels_) * static_cast<std::size_t>(tile.wide);
    if (std::memcmp(held_.data() + start, values.data() + start, bytes) != 0) return true;
  }
  return false;
}

void TiledTexture::take(const TexelRect& tile, std::span<const float> values) {
  for (int row = 0; row < tile.high; ++row) {
    const std::size_t start = offset(tile.left, tile.low + row);
    const std::size_t count = static_cast<std::size_t>(channels_) * static_cast<std::size_t>(tile.wide);
    std::copy_n(values.data() + start, count, held_.data() + start);
  }
  gl11().PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl11().PixelStorei(GL_UNPACK_ROW_LENGTH, extent_.nx);
  gl11().TexSubImage2D(GL_TEXTURE_2D, 0, tile.left, tile.low, tile.wide, tile.high, channels_of(channels_), GL_FLOAT,
                       values.data() + offset(tile.left, tile.low));
  gl11().PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  uploaded_texels_ += static_cast<std::int64_t>(tile.wide) * tile.high;
}

void MapTarget::prepare(Extent size, GLint format, bool periodic) {
  if (texture_ && size == size_ && format == format_ && periodic == periodic_) return;
  if (!texture_) {
    texture_ = GlObject::texture();
    frame_ = GlObject::frame_buffer();
  }
  glActiveTexture(GL_TEXTURE0);
  gl11().BindTexture(GL_TEXTURE_2D, texture_.id());
  gl11().TexImage2D(GL_TEXTURE_2D, 0, format, size.nx, size.ny, 0, GL_RGBA, GL_FLOAT, nullptr);
  set_sampling(GL_LINEAR, periodic);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.id(), 0);
  size_ = size;
  format_ = format;
  periodic_ = periodic;
}

void MapTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.id());
  gl11().Viewport(0, 0, size_.nx, size_.ny);
}

void PictureTarget::prepare(int width, int height) {
  if (frame_ && width == width_ && height == height_) {
    glBindFramebuffer(GL_FRAMEBUFFER, frame_.id());
    return;
  }
  GLint largest = 0;
  gl11().GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
  if (width > largest || height > largest) {
    throw InputError("size", std::to_string(width) + " x " + std::to_string(height) + " pixels are too many to draw",
                     "at most " + std::to_string(largest) + " a side, supersampling counted in");
  }
  colour_ = GlObject::render_buffer();
  depth_ = GlObject::render_buffer();
  frame_ = GlObject::frame_buffer();
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.id());
  glBindRenderbuffer(GL_RENDERBUFFER, colour_.id());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_.id());
  glBindRenderbuffer(GL_RENDERBUFFER, depth_.id());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    frame_ = GlObject();
    throw InputError("size", "the driver makes no picture of " + std::to_string(width) + " x " + std::to_string(height),
                     "choose a smaller size or less supersampling");
  }
  width_ = width;
  height_ = height;
}

std::vector<std::uint8_t> PictureTarget::read() const {
  std::vector<std::uint8_t> pixels(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.id());
  gl11().PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl11().ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

void PictureTarget::write(std::span<const std::uint8_t> pixels) const {
  // A render buffer takes no pixels; they go through a texture.
  const GlObject texture = GlObject::texture();
  const GlObject frame = GlObject::frame_buffer();
  gl11().BindTexture(GL_TEXTURE_2D, texture.id());
  gl11().PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl11().TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frame.id());
  glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, frame_.id());
  gl11().Disable(GL_SCISSOR_TEST);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl11().BindTexture(GL_TEXTURE_2D, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.id());
}

int largest_texture() {
  GLint largest = 0;
  gl11().GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  return largest;
}

}  // namespace erg::render
