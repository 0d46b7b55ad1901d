// The OpenGL functions that the renderer calls, whatever context gives them.
//
// GLEW loads everything after OpenGL 1.1; the functions of 1.1 it leaves to the linker, and which library the linker
// finds first (libGL, libOSMesa) would then decide for every context of the program. So these too are loaded from the
// context that is current: call them as `gl11().Clear(...)`.
#pragma once

#include <GL/glew.h>

namespace erg::render {

#define ERG_GL11_FUNCTIONS(use)                                                                                 \
  use(BindTexture) use(Clear) use(ClearColor) use(DeleteTextures) use(DepthFunc) use(DepthMask) use(Disable)    \
      use(DrawArrays) use(Enable) use(Finish) use(GenTextures) use(GetIntegerv) use(GetString) use(PixelStorei) \
          use(PolygonMode) use(PolygonOffset) use(ReadPixels) use(Scissor) use(TexImage2D) use(TexParameteri)   \
              use(TexSubImage2D) use(Viewport)

/// The functions of OpenGL 1.1 by their names without "gl".
struct Gl11 {
// NOLINTNEXTLINE(bugprone-macro-parentheses): a name in brackets declares nothing
#define ERG_GL11_MEMBER(name) decltype(&::gl##name) name = nullptr;
  ERG_GL11_FUNCTIONS(ERG_GL11_MEMBER)
#undef ERG_GL11_MEMBER
};

/// The functions of the context whose functions were loaded last.
const Gl11& gl11();

/// The state from which every drawing starts: filled triangles, no depth, no blending, no scissors.
void start_plain_drawing();

/// Finds a function of the current context by its name; null when there is none.
using GlLoader = void (*(*)(const char* name))();

/// Loads all functions of the current context through `loader` (null: through GLX, as a window has it). Throws
/// InputError when the context gives less than OpenGL 3.3.
void load_gl(GlLoader loader = nullptr);

/// A texture, buffer, vertex array or frame buffer of the current context, deleted with its owner. That context must
/// be current then.
class GlObject {
 public:
  using Maker = void (*)(GLuint*);
  using Remover = void (*)(GLuint);

  GlObject() = default;
  ~GlObject() { reset(); }
  GlObject(GlObject&& other) noexcept { swap(other); }
  GlObject& operator=(GlObject&& other) noexcept {
    swap(other);
    return *this;
  }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;

  static GlObject texture();
  static GlObject buffer();
  static GlObject vertex_array();
  static GlObject frame_buffer();
  static GlObject render_buffer();

  GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  GlObject(Maker make, Remover remove) : remove_(remove) { make(&id_); }
  void reset();
  void swap(GlObject& other) noexcept;

  GLuint id_ = 0;
  Remover remove_ = nullptr;
};

}  // namespace erg::render
