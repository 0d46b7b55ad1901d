#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>

#include "core/errors.h"
#include "render/gl.h"
#include "render/gl_context.h"

namespace erg::render {
namespace {

[[noreturn]] void fail(const std::string& problem) {
  throw InputError("EGL", problem, "install libegl1 and libgl1-mesa-dri, or the driver of the graphics card");
}

EGLDisplay open_display() {
  const auto get_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get_display == nullptr) fail("this EGL is too old to draw without a window");
  const EGLDisplay surfaceless = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (surfaceless != EGL_NO_DISPLAY && eglInitialize(surfaceless, nullptr, nullptr) == EGL_TRUE) return surfaceless;
  // Drivers that are not Mesa's offer their cards as devices instead.
  const auto query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (query_devices != nullptr) query_devices(devices.size(), devices.data(), &count);
  for (EGLint index = 0; index < count; ++index) {
    const EGLDisplay device = get_display(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(index)], nullptr);
    if (device != EGL_NO_DISPLAY && eglInitialize(device, nullptr, nullptr) == EGL_TRUE) return device;
  }
  fail("it finds nothing to draw on");
}

class EglContext final : public GlContext {
 public:
  EglContext() : display_(open_display()) {
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) fail("it has no desktop OpenGL");
    constexpr std::array<EGLint, 5> drawing{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                            EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    if (eglChooseConfig(display_, drawing.data(), &config, 1, &found) != EGL_TRUE || found == 0) config = nullptr;
    constexpr std::array<EGLint, 7> wanted{
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, wanted.data());
    if (context_ == EGL_NO_CONTEXT) fail("it makes no OpenGL 3.3 core context");
    EglContext::make_current();
  }

  ~EglContext() override {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    // The display stays open: it belongs to the process, and another context may be drawing on it.
  }

  void make_current() override {
    eglBindAPI(EGL_OPENGL_API);
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) {
      fail("its context cannot be made current without a surface");
    }
    load_gl([](const char* name) { return eglGetProcAddress(name); });
  }

  std::string kind() const override { return "egl"; }

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<GlContext> make_egl_context() { return std::make_unique<EglContext>(); }

}  // namespace erg::render
