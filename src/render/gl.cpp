#include "render/gl.h"

#include <dlfcn.h>

#include <string>
#include <string_view>
#include <utility>

#include "core/errors.h"

namespace erg::render {
namespace {

using AnyFunction = void (*)();

Gl11 functions;
GlLoader current_loader = nullptr;

AnyFunction find_in_libgl(const char* name) {
  static void* const library = dlopen("libGL.so.1", RTLD_LAZY | RTLD_GLOBAL);
  using Find = AnyFunction (*)(const GLubyte*);
  static const auto find =
      library == nullptr ? nullptr : reinterpret_cast<Find>(dlsym(library, "glXGetProcAddressARB"));
  return find == nullptr ? nullptr : find(reinterpret_cast<const GLubyte*>(name));
}

AnyFunction find_function(const char* name) {
  // EGL hands out stubs for functions of GLX too, which only seem to work.
  if (std::string_view(name).substr(0, 3) == "glX") return find_in_libgl(name);
  return current_loader == nullptr ? find_in_libgl(name) : current_loader(name);
}

}  // namespace

// Debian's GLEW asks GLX for every function. This stands in for GLX's own answer, so that contexts without X get
// theirs.
// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" AnyFunction glXGetProcAddressARB(const GLubyte* name) {
  return find_function(reinterpret_cast<const char*>(name));
}

const Gl11& gl11() { return functions; }

void start_plain_drawing() {
  functions.Disable(GL_DEPTH_TEST);
  functions.Disable(GL_BLEND);
  functions.Disable(GL_CULL_FACE);
  functions.Disable(GL_SCISSOR_TEST);
  functions.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void load_gl(GlLoader loader) {
  current_loader = loader;
#define ERG_GL11_LOAD(name) functions.name = reinterpret_cast<decltype(functions.name)>(find_function("gl" #name));
  ERG_GL11_FUNCTIONS(ERG_GL11_LOAD)
#undef ERG_GL11_LOAD
  glewExperimental = GL_TRUE;
  // GLEW also looks for GLX or EGL extensions and fails there without a display, after the functions were loaded: what
  // counts is whether they are there.
  glewInit();
  if (functions.GetString != nullptr && glCreateShader != nullptr && GLEW_VERSION_3_3) return;
  const GLubyte* version = functions.GetString == nullptr ? nullptr : functions.GetString(GL_VERSION);
  throw InputError("OpenGL",
                   "version 3.3 is needed, this driver has " +
                       (version == nullptr ? std::string("none") : std::string(reinterpret_cast<const char*>(version))),
                   "install a newer driver, or libgl1-mesa-dri to draw on the processor");
}

void GlObject::reset() {
  if (id_ != 0) remove_(id_);
  id_ = 0;
}

void GlObject::swap(GlObject& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(remove_, other.remove_);
}

GlObject GlObject::texture() {
  return {[](GLuint* id) { functions.GenTextures(1, id); }, [](GLuint id) { functions.DeleteTextures(1, &id); }};
}
GlObject GlObject::buffer() {
  return {[](GLuint* id) { glGenBuffers(1, id); }, [](GLuint id) { glDeleteBuffers(1, &id); }};
}
GlObject GlObject::vertex_array() {
  return {[](GLuint* id) { glGenVertexArrays(1, id); }, [](GLuint id) { glDeleteVertexArrays(1, &id); }};
}
GlObject GlObject::frame_buffer() {
  return {[](GLuint* id) { glGenFramebuffers(1, id); }, [](GLuint id) { glDeleteFramebuffers(1, &id); }};
}
GlObject GlObject::render_buffer() {
  return {[](GLuint* id) { glGenRenderbuffers(1, id); }, [](GLuint id) { glDeleteRenderbuffers(1, &id); }};
}

}  // namespace erg::render
