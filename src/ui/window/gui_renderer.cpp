#include "ui/window/gui_renderer.h"

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace erg::ui {

using render::Gl11;
using render::gl11;
using render::GlObject;

namespace {

constexpr const char* vertex_shader = R"(#version 330 core
uniform vec2 size;
layout(location = 0) in vec2 place;
layout(location = 1) in vec2 texel;
layout(location = 2) in vec4 colour;
out vec2 at;
out vec4 tint;
void main() {
  at = texel;
  tint = colour;
  gl_Position = vec4(2.0 * place.x / size.x - 1.0, 1.0 - 2.0 * place.y / size.y, 0.0, 1.0);
}
)";

constexpr const char* fragment_shader = R"(#version 330 core
uniform sampler2D image;
in vec2 at;
in vec4 tint;
out vec4 result;
void main() { result = tint * texture(image, at); }
)";

GLuint compile(GLenum kind, const char* text) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint good = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good == GL_TRUE) return shader;
  std::array<char, 512> words{};
  glGetShaderInfoLog(shader, words.size(), nullptr, words.data());
  throw std::runtime_error("the interface's shader does not compile: " + std::string(words.data()));
}

GlObject make_texture(int width, int height, const void* pixels) {
  GlObject texture = GlObject::texture();
  const Gl11& gl = gl11();
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  return texture;
}

ImTextureID as_id(GLuint texture) { return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture)); }
GLuint as_texture(ImTextureID id) { return static_cast<GLuint>(reinterpret_cast<std::intptr_t>(id)); }

}  // namespace

GuiRenderer::GuiRenderer()
    : program_(glCreateProgram()),
      vertex_array_(GlObject::vertex_array()),
      vertices_(GlObject::buffer()),
      indices_(GlObject::buffer()) {
  for (const GLuint shader : {compile(GL_VERTEX_SHADER, vertex_shader), compile(GL_FRAGMENT_SHADER, fragment_shader)}) {
    glAttachShader(program_, shader);
    glDeleteShader(shader);
  }
  glLinkProgram(program_);
  place_of_size_ = glGetUniformLocation(program_, "size");
  glBindVertexArray(vertex_array_.id());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  const auto attribute = [](GLuint place, GLint count, GLenum type, GLboolean normalised, std::size_t offset) {
    glEnableVertexAttribArray(place);
    glVertexAttribPointer(place, count, type, normalised, sizeof(ImDrawVert), reinterpret_cast<const void*>(offset));
  };
  attribute(0, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, pos));
  attribute(1, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, uv));
  attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(ImDrawVert, col));
  glBindVertexArray(0);
}

GuiRenderer::~GuiRenderer() { glDeleteProgram(program_); }

void GuiRenderer::upload_fonts(int version) {
  if (version == font_version_) return;
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
  font_ = make_texture(width, height, pixels);
  // The texture has it. What it was made from, a quarter as large, stays for another renderer: the atlas would be
  // packed anew without the fonts, and the letters lie elsewhere in it.
  ImGui::MemFree(atlas.TexPixelsRGBA32);
  atlas.TexPixelsRGBA32 = nullptr;
  font_version_ = version;
}

ImTextureID GuiRenderer::add_texture(const picture::RgbaImage& image) {
  textures_.push_back(make_texture(image.width, image.height, image.pixels.data()));
  return as_id(textures_.back().id());
}

void GuiRenderer::set_state(const ImDrawData& data) const {
  const Gl11& gl = gl11();
  gl.Viewport(0, 0, static_cast<int>(data.DisplaySize.x), static_cast<int>(data.DisplaySize.y));
  gl.Disable(GL_DEPTH_TEST);
  gl.Disable(GL_CULL_FACE);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  gl.Enable(GL_BLEND);
  // Opacity adds up, so that a transparent frame buffer stays right.
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl.Enable(GL_SCISSOR_TEST);
  glUseProgram(program_);
  glUniform2f(place_of_size_, data.DisplaySize.x, data.DisplaySize.y);
  glUniform1i(glGetUniformLocation(program_, "image"), 0);
  glActiveTexture(GL_TEXTURE0);
  glBindVertexArray(vertex_array_.id());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
}

void GuiRenderer::draw(const Gui& gui, unsigned frame_buffer) {
  const ImDrawData& data = *ImGui::GetDrawData();
  upload_fonts(gui.font_version());
  glBindFramebuffer(GL_FRAMEBUFFER, frame_buffer);
  set_state(data);
  const Gl11& gl = gl11();
  for (int index = 0; index < data.CmdListsCount; ++index) {
    const ImDrawList& list = *data.CmdLists[index];
    glBufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data, GL_STREAM_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data, GL_STREAM_DRAW);
    for (const ImDrawCmd& command : list.CmdBuffer) {
      if (command.UserCallback != nullptr) continue;  // nothing of ours uses callbacks
      const ImVec4& clip = command.ClipRect;
      if (clip.z <= clip.x || clip.w <= clip.y) continue;
      gl.Scissor(static_cast<int>(clip.x), static_cast<int>(data.DisplaySize.y - clip.w),
                 static_cast<int>(clip.z - clip.x), static_cast<int>(clip.w - clip.y));
      const ImTextureID texture = command.GetTexID();
      gl.BindTexture(GL_TEXTURE_2D, texture == nullptr ? font_.id() : as_texture(texture));
      glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                               sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                               reinterpret_cast<const void*>(command.IdxOffset * sizeof(ImDrawIdx)),
                               static_cast<GLint>(command.VtxOffset));
    }
  }
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_BLEND);
  glBindVertexArray(0);
}

}  // namespace erg::ui
