#include "render/gl_context.h"

#include "core/errors.h"
#include "render/gl.h"

namespace erg::render {

std::string GlContext::renderer() const {
  const GLubyte* const text = gl11().GetString(GL_RENDERER);
  return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

bool draws_in_software(std::string_view renderer) {
  for (const char* const software : {"llvmpipe", "softpipe", "swrast", "Software"}) {
    if (renderer.find(software) != std::string_view::npos) return true;
  }
  return false;
}

bool GlContext::is_software() const { return draws_in_software(renderer()); }

const std::vector<std::string>& offscreen_kinds() {
  static const std::vector<std::string> kinds{"auto", "egl", "osmesa"};
  return kinds;
}

std::unique_ptr<GlContext> make_offscreen_context(std::string_view kind) {
  if (kind == "egl") return make_egl_context();
  if (kind == "osmesa") return make_osmesa_context();
  if (kind != "auto") {
    throw InputError("context", "there is no kind " + quote(kind), suggestion(kind, offscreen_kinds()));
  }
  try {
    return make_egl_context();
  } catch (const InputError& egl_failed) {
    if (!has_osmesa()) throw;
    try {
      return make_osmesa_context();
    } catch (const InputError& osmesa_failed) {
      std::vector<Mistake> both = egl_failed.mistakes();
      both.insert(both.end(), osmesa_failed.mistakes().begin(), osmesa_failed.mistakes().end());
      throw InputError(std::move(both));
    }
  }
}

}  // namespace erg::render
