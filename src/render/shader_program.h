// Shaders as files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "render/gl.h"

namespace erg::render {

/// The program's folder of shader files (program_folder). Throws InputError when it is not there.
std::filesystem::path shader_folder();

/// A linked program of one vertex and one fragment shader.
class ShaderProgram {
 public:
  ShaderProgram() = default;
  /// Compiles `folder/vertex` and `folder/fragment`. A line `#include "name"` takes in another file of the folder.
  /// The words are defined in both, for their `#ifdef`. Throws InputError with file, line and the driver's message.
  ShaderProgram(const std::filesystem::path& folder, const std::string& vertex, const std::string& fragment,
                const std::vector<std::string>& words = {});
  ~ShaderProgram();
  ShaderProgram(ShaderProgram&& other) noexcept;
  ShaderProgram& operator=(ShaderProgram&& other) noexcept;
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;

  void use() const { glUseProgram(id_); }

  /// Sets a uniform of the program in use. A name that the program does not use is ignored, as OpenGL does.
  void set(const char* name, int value) const { glUniform1i(at(name), value); }
  void set(const char* name, float value) const { glUniform1f(at(name), value); }
  void set(const char* name, double value) const { glUniform1f(at(name), static_cast<float>(value)); }
  void set(const char* name, float x, float y) const { glUniform2f(at(name), x, y); }
  void set(const char* name, int x, int y) const { glUniform2i(at(name), x, y); }
  void set(const char* name, float x, float y, float z) const { glUniform3f(at(name), x, y, z); }
  void set_matrix(const char* name, const float* column_major) const {
    glUniformMatrix4fv(at(name), 1, GL_FALSE, column_major);
  }
  void set_colours(const char* name, const float* rgb, int count) const { glUniform3fv(at(name), count, rgb); }
  /// Binds a texture to a unit and names it to the program.
  void set_texture(const char* name, int unit, GLuint texture) const;

 private:
  GLint at(const char* name) const { return glGetUniformLocation(id_, name); }

  GLuint id_ = 0;
};

}  // namespace erg::render
