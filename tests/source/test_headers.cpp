// Every header compiles alone. To parse the standard library once and not 170 times, all headers go through the
// compiler in one file, each with what it includes from src/ in a namespace of its own, where it sees no other's names.
// What it takes from other libraries it would see in any case, so that is looked up in the text.
#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>

#include "source_tree.h"

namespace erg::test {
namespace {

namespace fs = std::filesystem;

// Appends a header after what it includes from src/, each file once; notes the macros that it leaves behind.
void expand(const std::string& path, std::set<std::string>& taken, std::string& text, std::set<std::string>& macros) {
  static const std::regex define("^\\s*#define\\s+(\\w+).*");
  if (!taken.insert(path).second) return;
  const SourceFile& file = source_tree().at(path);
  for (const std::string& included : file.own) expand(included, taken, text, macros);
  text += "#line 1 \"" + path + "\"\n";
  for (const std::string& line : file.lines) {
    std::smatch name;
    if (std::regex_match(line, name, define)) macros.insert(name[1]);
    const bool leave_out = line.rfind("#include ", 0) == 0 || line.rfind("#pragma once", 0) == 0;
    text += (leave_out ? "" : line) + "\n";
  }
}

std::string all_headers_apart(const std::vector<std::string>& paths) {
  std::set<std::string> foreign;
  std::string text;
  for (const std::string& path : paths) {
    std::set<std::string> taken;
    std::set<std::string> macros;
    text += "namespace alone_" + std::regex_replace(path, std::regex("[^a-z0-9]"), "_") + " {\n";
    expand(path, taken, text, macros);
    text += "}\n";
    for (const std::string& macro : macros) text += "#undef " + macro + "\n";
    for (const std::string& one : taken) {
      foreign.insert(source_tree().at(one).foreign.begin(), source_tree().at(one).foreign.end());
    }
  }
  std::string first;
  for (const std::string& header : foreign) first += "#include " + header + "\n";
  return first + text;
}

TEST(Headers, EachNamesWhatItNeedsOfErg) {
  const fs::path file = fs::temp_directory_path() / ("erg-headers-" + std::to_string(getpid()) + ".cpp");
  std::ofstream(file) << all_headers_apart(headers());
  const std::string log = file.string() + ".log";
  const int status = std::system((ERG_COMPILE " -fsyntax-only " + file.string() + " > " + log + " 2>&1").c_str());
  EXPECT_EQ(status, 0) << read_text(log).substr(0, 4000);
  fs::remove(file);
  fs::remove(log);
}

// What headers use of other libraries, and which header has it.
struct Origin {
  const char* name;    // regular expression
  const char* header;  // regular expression
};
constexpr Origin origins[] = {
    {"std::(string|to_string|char_traits)", "<string>"},
    {"std::string_view", "<string_view>"},
    {"std::(vector)", "<vector>"},
    {"(std::)?u?int(8|16|32|64)_t|INT(32|64)_MAX", "<cstdint>"},
    {"std::(size_t|ptrdiff_t|byte)", "<cstddef>"},
    {"std::filesystem::\\w+", "<filesystem>"},
    {"std::(unique_ptr|shared_ptr|weak_ptr|make_unique|make_shared)", "<memory>"},
    {"std::(optional|nullopt)", "<optional>"},
    {"std::function", "<functional>"},
    {"std::span", "<span>"},
    {"std::array", "<array>"},
    {"std::(move|exchange|pair|forward)", "<utility>"},
    {"std::(deque)", "<deque>"},
    {"std::(map)", "<map>"},
    {"std::(set)", "<set>"},
    {"std::(mutex|unique_lock|lock_guard|scoped_lock)", "<mutex>"},
    {"std::condition_variable", "<condition_variable>"},
    {"std::(atomic|atomic_ref|memory_order_\\w+)", "<atomic>"},
    {"std::thread", "<thread>"},
    {"std::future", "<future>"},
    {"std::(variant|monostate|get_if|visit)", "<variant>"},
    {"std::runtime_error", "<stdexcept>"},
    {"std::exception", "<exception>"},
    {"std::numeric_limits", "<limits>"},
    {"std::mem(cpy|cmp|set)", "<cstring>"},
    {"std::numbers::\\w+", "<numbers>"},
    {"std::bit_cast", "<bit>"},
    {"std::align_val_t", "<new>"},
    {"std::(time_t|time)", "<ctime>"},
    {"std::chrono::\\w+", "<chrono>"},
    {"std::(sqrt|tan|ceil|floor|abs|round)", "<cmath>"},
    {"std::(min|max|clamp|fill|sort)", "<algorithm>"},
    {"std::(conditional_t|is_same_v)", "<type_traits>"},
    {"std::complex", "<complex>"},
    {"std::(ofstream|ifstream)", "<fstream>"},
    {"assert", "<cassert>"},
    {"CLI::\\w+", "<CLI/CLI.hpp>"},
    {"nlohmann::\\w+", "<nlohmann/json.*>"},
    {"Eigen::\\w+", "<Eigen/.*>"},
    {"GL(uint|int|enum|sizei|float)", "<GL/glew.h>"},
    {"Im(Vec|Gui|Draw|Font|Texture|U32)\\w*", "<imgui.h>"},
};

// The header's text without comments and texts in quotes.
std::string code_of(const SourceFile& file) {
  static const std::regex not_code("\"(\\\\.|[^\"\\\\])*\"|//.*");
  std::string code;
  for (const std::string& line : file.lines) {
    if (line.rfind("#include ", 0) != 0) code += std::regex_replace(line, not_code, "") + "\n";
  }
  return code;
}

std::set<std::string> foreign_of(const std::string& path, std::set<std::string>& taken) {
  if (!taken.insert(path).second) return {};
  const SourceFile& file = source_tree().at(path);
  std::set<std::string> found(file.foreign.begin(), file.foreign.end());
  for (const std::string& included : file.own) found.merge(foreign_of(included, taken));
  return found;
}

// The names that a header uses of other libraries without including what has them; "?" after those nobody knows.
std::vector<std::string> unnamed(const std::string& code, const std::set<std::string>& foreign) {
  static const std::regex use(
      "\\b(std::(?:filesystem::|chrono::|numbers::)?\\w+|CLI::\\w+|nlohmann::\\w+|Eigen::\\w+|"
      "u?int(?:8|16|32|64)_t|INT(?:32|64)_MAX|GL(?:uint|int|enum|sizei|float)\\b|assert(?=\\()|"
      "Im(?:Vec|Gui|Draw|Font|Texture|U32)\\w*)");
  std::set<std::string> names;
  for (std::sregex_iterator at(code.begin(), code.end(), use), end; at != end; ++at) names.insert((*at)[1]);
  std::vector<std::string> missing;
  for (const std::string& name : names) {
    const Origin* origin = nullptr;
    for (const Origin& one : origins) {
      if (std::regex_match(name, std::regex(one.name))) origin = &one;
    }
    if (origin == nullptr) {
      missing.push_back(name + "?");
      continue;
    }
    const std::regex wanted(origin->header);
    bool there = false;
    for (const std::string& header : foreign) there = there || std::regex_match(header, wanted);
    if (!there) missing.push_back(name);
  }
  return missing;
}

TEST(Headers, EachNamesWhatItNeedsOfOtherLibraries) {
  for (const std::string& path : headers()) {
    std::set<std::string> taken;
    const std::set<std::string> foreign = foreign_of(path, taken);
    for (const std::string& name : unnamed(code_of(source_tree().at(path)), foreign)) {
      ADD_FAILURE() << path << " uses " << name
                    << (name.back() == '?' ? ": the table of this test does not know where that is from"
                                           : " and includes no header that has it");
    }
  }
}

TEST(Headers, AMissingIncludeIsSeen) {
  EXPECT_EQ(unnamed("std::vector<int> a; std::int32_t b;", {"<vector>"}), std::vector<std::string>{"std::int32_t"});
  EXPECT_EQ(unnamed("std::unheard_of c;", {"<vector>"}), std::vector<std::string>{"std::unheard_of?"});
  EXPECT_EQ(unnamed("Eigen::Vector3d d;", {"<Eigen/Dense>"}), std::vector<std::string>{});
  // Each header stands in a namespace of its own, so one that forgets an include finds nothing of another's.
  const std::string text = all_headers_apart({"core/grid.h", "core/terrain.h"});
  EXPECT_LT(text.find("namespace alone_core_grid_h {"), text.find("class Grid"));
  EXPECT_NE(text.find("class Grid", text.find("namespace alone_core_terrain_h {")), std::string::npos);
}

}  // namespace
}  // namespace erg::test
