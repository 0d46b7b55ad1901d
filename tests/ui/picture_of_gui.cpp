#include "picture_of_gui.h"

#include "render/gl_context.h"
#include "render/textures.h"
#include "ui/window/gui_renderer.h"

namespace erg::test {

using picture::RgbImage;
using render::gl11;

RgbImage picture_of_gui(const ui::Gui& gui, ImVec2 size) {
  const std::unique_ptr<render::GlContext> context =
      render::make_offscreen_context(render::has_osmesa() ? "osmesa" : "egl");
  ui::GuiRenderer renderer;
  render::PictureTarget target;
  const int width = static_cast<int>(size.x);
  const int height = static_cast<int>(size.y);
  target.prepare(width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, target.frame());
  const ImVec4& ground = gui.theme().ground;
  gl11().ClearColor(ground.x, ground.y, ground.z, 1);
  gl11().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  renderer.draw(gui, target.frame());
  const std::vector<std::uint8_t> drawn = target.read();
  RgbImage image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint8_t* const from = drawn.data() + 4 * ((height - 1 - y) * width + x);
      std::copy_n(from, 3, image.pixel(x, y));
    }
  }
  return image;
}

}  // namespace erg::test
