#include <dlfcn.h>

#include <array>
#include <type_traits>
#include <vector>

#include "core/errors.h"
#include "render/gl.h"
#include "render/gl_context.h"

// osmesa.h is written for Mesa's own gl.h; GLEW undefines these two at its end.
#define GLAPI extern
#ifndef GLAPIENTRY
#define GLAPIENTRY
#endif
#include <GL/osmesa.h>

namespace erg::render {
namespace {

// Pictures are drawn into frame buffer objects; the context's own buffer only has to exist.
constexpr int buffer_side = 16;

/// OSMesa, taken when it is first asked for: with the compiler that it brings, it is most of what a start would load.
struct Osmesa {
  decltype(&::OSMesaCreateContextAttribs) create = nullptr;
  decltype(&::OSMesaDestroyContext) destroy = nullptr;
  decltype(&::OSMesaMakeCurrent) make_current = nullptr;
  decltype(&::OSMesaGetProcAddress) find = nullptr;
};

Osmesa load() {
  Osmesa all;
  void* const library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return all;
  const auto take = [library](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
    return function != nullptr;
  };
  const bool whole = take(all.destroy, "OSMesaDestroyContext") && take(all.make_current, "OSMesaMakeCurrent") &&
                     take(all.find, "OSMesaGetProcAddress") && take(all.create, "OSMesaCreateContextAttribs");
  return whole ? all : Osmesa{};
}

const Osmesa& osmesa() {
  static const Osmesa all = load();
  return all;
}

class OsmesaContext final : public GlContext {
 public:
  OsmesaContext() : buffer_(4 * buffer_side * buffer_side) {
    constexpr std::array<int, 13> wanted{OSMESA_FORMAT,
                                         OSMESA_RGBA,
                                         OSMESA_DEPTH_BITS,
                                         24,
                                         OSMESA_PROFILE,
                                         OSMESA_CORE_PROFILE,
                                         OSMESA_CONTEXT_MAJOR_VERSION,
                                         3,
                                         OSMESA_CONTEXT_MINOR_VERSION,
                                         3,
                                         0,
                                         0,
                                         0};
    if (!has_osmesa()) throw InputError("OSMesa", "it is not installed", "install libosmesa6, or draw with EGL");
    context_ = osmesa().create(wanted.data(), nullptr);
    if (context_ == nullptr) {
      throw InputError("OSMesa", "it makes no OpenGL 3.3 core context", "install libosmesa6 (Mesa 22 or newer)");
    }
    OsmesaContext::make_current();
  }

  ~OsmesaContext() override { osmesa().destroy(context_); }

  void make_current() override {
    if (osmesa().make_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, buffer_side, buffer_side) != GL_TRUE) {
      throw InputError("OSMesa", "its context cannot be made current", "install libosmesa6 (Mesa 22 or newer)");
    }
    load_gl([](const char* name) { return osmesa().find(name); });
  }

  std::string kind() const override { return "osmesa"; }

 private:
  std::vector<unsigned char> buffer_;
  OSMesaContext context_ = nullptr;
};

}  // namespace

bool has_osmesa() { return osmesa().create != nullptr; }

std::unique_ptr<GlContext> make_osmesa_context() { return std::make_unique<OsmesaContext>(); }

}  // namespace erg::render
