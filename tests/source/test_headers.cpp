// Every header compiles alone. All go through the compiler in one file (headers_apart.h), in which each sees what it
// includes from src/ and nothing else of Erg. What it takes from other libraries it would see in any case, so that is
// looked up in the text.
#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>

#include "headers_apart.h"
#include "source_tree.h"

namespace erg::test {
namespace {

namespace fs = std::filesystem;

/// What the compiler says against a text; "" when it takes it.
std::string refusal(const std::string& text) {
  const fs::path file = fs::temp_directory_path() / ("erg-headers-" + std::to_string(getpid()) + ".cpp");
  std::ofstream(file) << text;
  const std::string log = file.string() + ".log";
  const int status = std::system((ERG_COMPILE " -fsyntax-only " + file.string() + " > " + log + " 2>&1").c_str());
  const std::string said = status == 0 ? "" : "refused: " + read_text(log).substr(0, 4000);
  fs::remove(file);
  fs::remove(log);
  return said;
}

TEST(Headers, EachNamesWhatItNeedsOfErg) { EXPECT_EQ(refusal(headers_apart(source_tree())), ""); }

SourceFile source(const std::string& text) {
  std::istringstream stream(text);
  return read_source(stream);
}

TEST(Headers, OneThatDoesNotIsSeen) {
  const std::string first = "namespace erg {\nstruct First {\n  int value = 0;\n};\n}\n";
  const std::string uses = "namespace erg {\ninline int value_of(First first) { return first.value; }\n}\n";
  const std::string includes = "#include \"a/first.h\"\n";
  const std::string through =
      "#include \"a/second.h\"\nnamespace erg {\ninline int third(First f) { return value_of(f); }\n}\n";
  const SourceFile whole = source(first);
  EXPECT_EQ(refusal(headers_apart({{"a/first.h", whole}, {"a/second.h", source(includes + uses)}})), "");
  EXPECT_EQ(refusal(headers_apart(
                {{"a/first.h", whole}, {"a/second.h", source(includes + uses)}, {"a/third.h", source(through)}})),
            "");
  const std::string missing = refusal(headers_apart({{"a/first.h", whole}, {"a/second.h", source(uses)}}));
  EXPECT_NE(missing.find("a/second.h:2"), std::string::npos) << missing;
  // A type that is only declared where it is used, and defined elsewhere.
  const std::string declares = "namespace erg {\nstruct First;\nint size_of(const First& first);\n}\n";
  EXPECT_EQ(refusal(headers_apart(
                {{"a/first.h", whole},
                 {"a/second.h", source(declares)},
                 {"a/third.h", source("#include \"a/second.h\"\n" + includes +
                                      "namespace erg {\ninline int third() { return size_of({}); }\n}\n")}})),
            "");
  const std::string incomplete = refusal(headers_apart(
      {{"a/first.h", whole},
       {"a/second.h", source(declares + "namespace erg {\ninline int third(First f) { return size_of(f); }\n}\n")}}));
  EXPECT_NE(incomplete.find("incomplete type"), std::string::npos) << incomplete;
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
    {"std::(bit_cast|endian)", "<bit>"},
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

TEST(Headers, AMissingIncludeOfAnotherLibraryIsSeen) {
  EXPECT_EQ(unnamed("std::vector<int> a; std::int32_t b;", {"<vector>"}), std::vector<std::string>{"std::int32_t"});
  EXPECT_EQ(unnamed("std::unheard_of c;", {"<vector>"}), std::vector<std::string>{"std::unheard_of?"});
  EXPECT_EQ(unnamed("Eigen::Vector3d d;", {"<Eigen/Dense>"}), std::vector<std::string>{});
}

}  // namespace
}  // namespace erg::test
