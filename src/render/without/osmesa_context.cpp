// Where OSMesa is not installed (Mesa 25.1 dropped it): EGL draws everything.
#include "core/errors.h"
#include "render/gl_context.h"

namespace erg::render {

bool has_osmesa() { return false; }

std::unique_ptr<GlContext> make_osmesa_context() {
  throw InputError("OSMesa", "this program was built without it",
                   "draw with EGL (--context egl), or install libosmesa6-dev and build anew");
}

}  // namespace erg::render
