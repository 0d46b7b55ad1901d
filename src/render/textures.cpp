#include "render/textures.h"

#include <algorithm>
#include <cstring>

#include "core/errors.h"

namespace erg {
namespace {

void set_sampling(GLint filter, bool periodic) {
  const GLint edge = periodic ? GL_REPEAT : GL_CLAMP_TO_EDGE;
  gl11().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  gl11().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  gl11().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, edge);
  gl11().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, edge);
}

GLenum channels_of(int count) { return count == 1 ? GL_RED : GL_RG; }

}  // namespace

void TiledTexture::clear() {
  extent_ = {};
  held_.clear();
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

bool TiledTexture::update(Extent extent, bool periodic, std::span<const float> values) {
  glActiveTexture(GL_TEXTURE0);
  if (extent != extent_ || periodic != periodic_ || !texture_) allocate(extent, periodic);
  gl11().BindTexture(GL_TEXTURE_2D, texture_.id());
  bool changed = false;
  for (int low = 0; low < extent.ny; low += tile_side) {
    for (int left = 0; left < extent.nx; left += tile_side) {
      const int wide = std::min(tile_side, extent.nx - left);
      const int high = std::min(tile_side, extent.ny - low);
      if (!held_.empty() && !tile_changed(left, low, wide, high, values)) continue;
      upload(left, low, wide, high, values);
      changed = true;
    }
  }
  if (changed) held_.assign(values.begin(), values.end());
  return changed;
}

bool TiledTexture::tile_changed(int left, int low, int wide, int high, std::span<const float> values) const {
  for (int row = 0; row < high; ++row) {
    const std::size_t start = offset(left, low + row);
    const std::size_t bytes = sizeof(float) * static_cast<std::size_t>(channels_) * static_cast<std::size_t>(wide);
    if (std::memcmp(held_.data() + start, values.data() + start, bytes) != 0) return true;
  }
  return false;
}

void TiledTexture::upload(int left, int low, int wide, int high, std::span<const float> values) {
  gl11().PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl11().PixelStorei(GL_UNPACK_ROW_LENGTH, extent_.nx);
  gl11().TexSubImage2D(GL_TEXTURE_2D, 0, left, low, wide, high, channels_of(channels_), GL_FLOAT,
                       values.data() + offset(left, low));
  gl11().PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  uploaded_texels_ += static_cast<std::int64_t>(wide) * high;
}

bool MapTarget::prepare(Extent size, GLint format, bool periodic) {
  if (texture_ && size == size_ && format == format_ && periodic == periodic_) return false;
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
  return true;
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

int largest_texture() {
  GLint largest = 0;
  gl11().GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  return largest;
}

}  // namespace erg
