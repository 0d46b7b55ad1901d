// Kernels in files .k are shaders of OpenGL too: each is given to glslangValidator as GLSL 4.30.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include "source_tree.h"

namespace erg::test {
namespace {

namespace fs = std::filesystem;

/// The text of a file below src/ with the files that it includes, each once.
std::string expanded(const std::string& path, std::set<std::string>& taken) {
  std::string all;
  if (!taken.insert(path).second) return all;
  std::istringstream text(read_text(source_root() / "src" / path));
  static const std::regex include("#include \"(.*)\"");
  std::smatch match;
  for (std::string line; std::getline(text, line);) {
    if (std::regex_match(line, match, include)) {
      all += expanded(match[1], taken);
    } else if (line != "#pragma once") {
      all += line + "\n";
    }
  }
  return all;
}

/// A file with kernels as a shader reads it, before its main().
std::string shader_text(const std::string& path) {
  std::set<std::string> taken;
  return "#version 430\n" + read_text(source_root() / "src/compute/subset.glsl") +
         expanded("core/high_product.k", taken) + expanded(path, taken);
}

/// All that a pattern's first group matches.
std::vector<std::string> found(const std::string& text, const char* pattern) {
  const std::regex wanted(pattern);
  std::vector<std::string> all;
  for (auto at = std::sregex_iterator(text.begin(), text.end(), wanted); at != std::sregex_iterator(); ++at) {
    all.push_back((*at)[1]);
  }
  return all;
}

/// Every kernel in a file .k by name, with its file.
std::map<std::string, std::string> kernels() {
  std::map<std::string, std::string> all;
  for (const auto& [path, includes] : source_tree()) {
    if (!path.ends_with(".k")) continue;
    for (const std::string& name : found(read_text(source_root() / "src" / path), R"(\nKERNEL\((\w+)\))")) {
      EXPECT_TRUE(all.emplace(name, path).second) << name << " in " << path << " and " << all[name];
    }
  }
  return all;
}

bool has_validator() { return std::system("command -v glslangValidator > /dev/null") == 0; }

/// What the compiler of shaders says against a text; "" where it takes it.
std::string refusal(const std::string& text) {
  std::string folder = (fs::temp_directory_path() / "erg-shader-XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) throw std::runtime_error("cannot make " + folder);
  const std::string file = folder + "/kernel.comp";
  std::ofstream(file) << text;
  const std::string log = folder + "/log";
  // -G: for OpenGL, which also checks where buffers are bound and how structs lie in them.
  const int status = std::system(("glslangValidator -G -o /dev/null '" + file + "' > '" + log + "' 2>&1").c_str());
  const std::string said = status == 0 ? "" : "refused: " + read_text(log).substr(0, 2000);
  fs::remove_all(folder);
  return said;
}

TEST(Subset, EachKernelIsAShader) {
  if (!has_validator()) GTEST_SKIP() << "needs glslangValidator (apt-get install glslang-tools)";
  for (const auto& [name, path] : kernels()) {
    EXPECT_EQ(refusal(shader_text(path) + "void main() { " + name + "(); }\n"), "") << name << " in " << path;
  }
}

TEST(Subset, WhatIsNoShaderIsSeen) {
  if (!has_validator()) GTEST_SKIP() << "needs glslangValidator (apt-get install glslang-tools)";
  const std::string text = shader_text("models/slab/ground.k");
  EXPECT_EQ(refusal(text + "KERNEL(fine) { EACH_ITEM(cell, cells()) before[cell] = bed_word(cell); }\n"
                           "void main() { fine(); }\n"),
            "");
  for (const std::string part :
       {"KERNEL(wrong) { u32* first = before; }", "KERNEL(wrong) { u64 word = 1; }", "KERNEL(wrong) { i32 cell = 0u; }",
        "KERNEL(wrong) { u32 first = before[0] ? 1u : 0u; }", "KERNEL(wrong) { i32 input = 0; }",
        "BUFFER(3, u64, dark); KERNEL(wrong) {}"}) {
    EXPECT_NE(refusal(text + part + "\nvoid main() { wrong(); }\n"), "") << part;
  }
}

TEST(Subset, EveryKernelOfSlabsIsInIt) {
  const std::map<std::string, std::string> written = kernels();
  const std::vector<std::string> listed =
      found(read_text(source_root() / "src/models/slab/slab_kernels.def"), R"(ERG_KERNEL\(slab, (\w+)\))");
  ASSERT_GT(listed.size(), 10U);
  EXPECT_EQ(listed.size(), written.size());
  for (const std::string& name : listed) EXPECT_TRUE(written.contains(name)) << name;
}

// OpenGL 4.3 promises a shader eight buffers, and places to bind them.
TEST(Subset, NoKernelHasMoreThanEightBuffers) {
  for (const auto& [name, path] : kernels()) {
    std::set<std::string> taken;
    const std::vector<std::string> places = found(expanded(path, taken), R"((?:GIVEN|BUFFER)\((\d+), )");
    EXPECT_GE(places.size(), 3U) << path;
    for (const std::string& place : places) EXPECT_LT(std::stoi(place), 8) << path;
    EXPECT_EQ(std::set(places.begin(), places.end()).size(), places.size()) << path << ": two buffers in one place";
  }
}

// A compiler of shaders takes truth values in a buffer; how they lie there is its own affair.
TEST(Subset, BuffersHoldWordsOf32Bits) {
  std::set<std::string> structs;
  for (const auto& [name, path] : kernels()) {
    std::set<std::string> taken;
    const std::string text = expanded(path, taken);
    for (const std::string& type : found(text, R"((?:GIVEN|BUFFER)\(\d+, (\w+),)")) {
      if (type == "u32" || type == "i32") continue;
      const std::size_t begin = text.find("\nstruct " + type + " {");
      ASSERT_NE(begin, std::string::npos) << type << " in " << path;
      for (const std::string& member : found(text.substr(begin, text.find("\n};", begin) - begin), R"(\n  (\w+) )")) {
        EXPECT_TRUE(member == "u32" || member == "i32" || member == "Wide") << type << ": " << member;
      }
      structs.insert(type);
    }
  }
  EXPECT_EQ(structs, (std::set<std::string>{"Aloft", "Given"}));
}

// What compilers of shaders take, and cards get wrong.
TEST(Subset, NoKernelReturnsHalfWayNorMultipliesInTheLanguagesOwnWay) {
  int bodies = 0;
  for (const auto& [path, includes] : source_tree()) {
    if (!path.ends_with(".k")) continue;
    const std::string text = read_text(source_root() / "src" / path);
    for (const char* word : {"umulExtended", "imulExtended", "long", "float", "double", "static_cast"}) {
      EXPECT_FALSE(std::regex_search(text, std::regex("\n[^/\n]*\\b" + std::string(word) + "\\b")))
          << path << ": " << word;
    }
    bool in_kernel = false;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("KERNEL(")) {
        in_kernel = true;
        ++bodies;
      }
      EXPECT_FALSE(in_kernel && line.find("return") != std::string::npos) << path << ": " << line;
      if (line == "}") in_kernel = false;
    }
  }
  EXPECT_GT(bodies, 10);
}

}  // namespace
}  // namespace erg::test
