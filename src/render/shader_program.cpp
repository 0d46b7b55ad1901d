#include "render/shader_program.h"

#include <fstream>
#include <regex>
#include <sstream>
#include <utility>
#include <vector>

#include "core/errors.h"
#include "process/program_files.h"

namespace erg::render {
namespace {

namespace fs = std::filesystem;

// A shader's text with its includes taken in, and where each of its lines is from. (`#line` would say so to the driver,
// but Mesa forgets the file in some of its messages.)
struct Source {
  struct Line {
    fs::path file;
    std::size_t number;
  };
  std::string text;
  std::vector<Line> lines;
};

void append_file(Source& source, const fs::path& path, const std::string& asked_at) {
  std::ifstream file(path);
  if (!file) {
    throw InputError(asked_at, "there is no shader file " + path.string(),
                     "install the program with its shaders/ folder");
  }
  std::string line;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    constexpr std::string_view include = "#include \"";
    if (line.rfind(include, 0) == 0) {
      const std::string name = line.substr(include.size(), line.rfind('"') - include.size());
      append_file(source, path.parent_path() / name, path.string() + ":" + std::to_string(number));
    } else {
      source.text += line + "\n";
      source.lines.push_back({path, number});
    }
  }
}

// One line of a compiler's log, `0:12(5): error: ...` (Mesa) or `0(12) : error ...` (others), as a mistake.
Mistake as_mistake(const std::string& line, const Source& source, const fs::path& whole) {
  static const std::regex form("^\\d+[:(](\\d+)[^:]*:\\s*(.*)$");
  std::smatch parts;
  if (!std::regex_match(line, parts, form)) return {whole.string(), line, ""};
  const std::size_t row = std::stoul(parts[1]);
  if (row == 0 || row > source.lines.size()) return {whole.string(), line, ""};
  const Source::Line& from = source.lines[row - 1];
  return {from.file.string() + ":" + std::to_string(from.number), parts[2], ""};
}

[[noreturn]] void report(const std::string& log, const Source& source, const fs::path& whole) {
  std::vector<Mistake> mistakes;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) mistakes.push_back(as_mistake(line, source, whole));
  }
  if (mistakes.empty()) mistakes.push_back({whole.string(), "the driver refused it and says no more", ""});
  throw InputError(std::move(mistakes));
}

// Defines words right after the line `#version`, which has to be the first.
void define(Source& source, const std::vector<std::string>& words) {
  const std::size_t second = source.text.find('\n') + 1;
  std::string text;
  for (const std::string& word : words) text += "#define " + word + "\n";
  source.text.insert(second, text);
  source.lines.insert(source.lines.begin() + 1, words.size(), source.lines.front());
}

GLuint compile(GLenum type, const fs::path& path, const std::vector<std::string>& words) {
  Source source;
  append_file(source, path, path.string());
  if (!words.empty()) define(source, words);
  const GLuint shader = glCreateShader(type);
  const char* const text = source.text.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint done = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done == GL_TRUE) return shader;
  std::string log(8192, '\0');
  GLsizei length = 0;
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
  glDeleteShader(shader);
  log.resize(static_cast<std::size_t>(length));
  report(log, source, path);
}

}  // namespace

fs::path shader_folder() {
  const fs::path folder = process::program_folder("shaders");
  std::error_code failed;
  if (fs::is_directory(folder, failed)) return folder;
  throw InputError(folder.string(), "the folder of the shaders is not there",
                   "install the program with `cmake --install`");
}

ShaderProgram::ShaderProgram(const fs::path& folder, const std::string& vertex, const std::string& fragment,
                             const std::vector<std::string>& words) {
  const GLuint first = compile(GL_VERTEX_SHADER, folder / vertex, words);
  GLuint second = 0;
  try {
    second = compile(GL_FRAGMENT_SHADER, folder / fragment, words);
  } catch (...) {
    glDeleteShader(first);
    throw;
  }
  id_ = glCreateProgram();
  for (const GLuint shader : {first, second}) {
    glAttachShader(id_, shader);
    glDeleteShader(shader);
  }
  glLinkProgram(id_);
  GLint done = GL_FALSE;
  glGetProgramiv(id_, GL_LINK_STATUS, &done);
  if (done == GL_TRUE) return;
  std::string log(8192, '\0');
  GLsizei length = 0;
  glGetProgramInfoLog(id_, static_cast<GLsizei>(log.size()), &length, log.data());
  glDeleteProgram(std::exchange(id_, 0));
  log.resize(static_cast<std::size_t>(length));
  report(log, {}, folder / fragment);
}

ShaderProgram::~ShaderProgram() {
  if (id_ != 0) glDeleteProgram(id_);
}

ShaderProgram::ShaderProgram(ShaderProgram&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

ShaderProgram& ShaderProgram::operator=(ShaderProgram&& other) noexcept {
  std::swap(id_, other.id_);
  return *this;
}

void ShaderProgram::set_texture(const char* name, int unit, GLuint texture) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl11().BindTexture(GL_TEXTURE_2D, texture);
  set(name, unit);
}

}  // namespace erg::render
