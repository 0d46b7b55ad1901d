// Draws ImGui's data with OpenGL 3.3: in the window, and off the screen.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <vector>

#include "picture/image.h"
#include "render/gl.h"
#include "ui/widgets/gui.h"

namespace erg::ui {

/// Lives with one OpenGL context, which must be current whenever it is used and when it goes.
class GuiRenderer {
 public:
  GuiRenderer();
  ~GuiRenderer();
  GuiRenderer(const GuiRenderer&) = delete;
  GuiRenderer& operator=(const GuiRenderer&) = delete;

  /// Draws the last frame of `gui` over what is in the frame buffer. Leaves blending and depth test off.
  void draw(const Gui& gui, unsigned frame_buffer);

  /// A texture for ImGui::Image, kept until this renderer goes.
  ImTextureID add_texture(const picture::RgbaImage& image);

 private:
  void upload_fonts(int version);
  void set_state(const ImDrawData& data) const;

  GLuint program_ = 0;
  GLint place_of_size_ = -1;
  render::GlObject vertex_array_;
  render::GlObject vertices_;
  render::GlObject indices_;
  render::GlObject font_;
  int font_version_ = 0;
  std::vector<render::GlObject> textures_;
};

}  // namespace erg::ui
