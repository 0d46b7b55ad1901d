// OpenGL without a window: contexts that draw into memory.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace erg::render {

/// An OpenGL 3.3 core context of the thread that made it. It is current from its making on, until another is made
/// current.
class GlContext {
 public:
  virtual ~GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Makes this context current and loads its functions.
  virtual void make_current() = 0;
  /// "egl" or "osmesa".
  virtual std::string kind() const = 0;
  /// What draws, in the driver's words: "llvmpipe (LLVM 15.0.6, 256 bits)".
  std::string renderer() const;
  /// True when the processor draws, so that a person at a window should get a coarser picture while moving.
  bool is_software() const;

 protected:
  GlContext() = default;
};

/// True when a driver of this name draws on the processor.
bool draws_in_software(std::string_view renderer);

/// Whether OSMesa can be had: this program was built with it, which Mesa has had until 25.1, and it is installed. It is
/// loaded to find out. Without it EGL draws everything.
bool has_osmesa();
/// Mesa's off-screen rasteriser. Throws InputError that says what to install.
std::unique_ptr<GlContext> make_osmesa_context();

/// EGL without a surface, on a graphics card where there is one. Throws InputError that says what to install.
std::unique_ptr<GlContext> make_egl_context();

/// "auto", "egl", "osmesa": names that are understood, if not all of them can draw.
const std::vector<std::string>& offscreen_kinds();

/// The context of this kind; "auto" is EGL, or OSMesa (has_osmesa) where EGL fails. Throws InputError.
std::unique_ptr<GlContext> make_offscreen_context(std::string_view kind = "auto");

}  // namespace erg::render
