#include "headers_apart.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>
#include <tuple>

namespace erg::test {
namespace {

using Paths = std::set<std::string>;

/// A type that a line at the left margin declares, and whether it says no more of it.
struct Declared {
  std::string type;
  bool forward = false;
};

std::optional<Declared> declared_in(const std::string& line) {
  for (const std::string_view kind : {"struct ", "class "}) {
    if (!line.starts_with(kind)) continue;
    const std::size_t end = line.find_first_of(" :;{", kind.size());
    return Declared{line.substr(kind.size(), end - kind.size()), line.ends_with(";") && line.find('{') == line.npos};
  }
  return std::nullopt;
}

/// The word that a line defines for the preprocessor; "" for other lines.
std::string macro_of(const std::string& line) {
  constexpr std::string_view define = "#define ";
  const std::size_t begin = line.find_first_not_of(' ');
  if (begin == line.npos || !std::string_view(line).substr(begin).starts_with(define)) return "";
  const std::size_t name = begin + define.size();
  return line.substr(name, line.find_first_of(" (", name) - name);
}

class HeadersApart {
 public:
  explicit HeadersApart(const std::map<std::string, SourceFile>& tree) : tree_(tree) {
    for (const auto& [path, file] : tree) {
      if (path.ends_with(".h")) collect(path, closures_[path]);
    }
    for (const auto& [path, closure] : closures_) {
      for (const std::string& one : closure) ++times_[one];
    }
  }

  std::string text() {
    Paths foreign;
    Node root;
    for (const auto& [path, closure] : closures_) {
      for (const std::string& one : closure) foreign.insert(tree_.at(one).foreign.begin(), tree_.at(one).foreign.end());
      if (shares(closure)) insert(root, in_order(closure));
    }
    for (const std::string& header : foreign) text_ += "#include " + header + "\n";
    lay_out(root, "");
    for (const auto& [path, closure] : closures_) {
      if (!shares(closure)) lay_out_in_one(in_order(closure));
    }
    return text_;
  }

 private:
  struct Node {
    std::map<std::string, std::unique_ptr<Node>> inside;
  };

  void collect(const std::string& path, Paths& closure) const {
    if (!closure.insert(path).second) return;
    for (const std::string& included : tree_.at(path).own) collect(included, closure);
  }

  /// What many include comes first, so that many share it; each header behind what it includes itself.
  std::vector<std::string> in_order(const Paths& closure) const {
    std::vector<std::string> order(closure.begin(), closure.end());
    std::ranges::sort(order, {}, [this](const std::string& path) {
      return std::tuple(-times_.at(path), closures_.at(path).size(), path);
    });
    return order;
  }

  /// Not where the names of one namespace would stand in two: a type declared in one header and defined in another, or
  /// a namespace below erg that headers add to.
  bool shares(const Paths& closure) const {
    Paths forward, whole;
    for (const std::string& path : closure) {
      for (const std::string& line : tree_.at(path).lines) {
        if (line.starts_with("namespace erg::")) return false;
        if (const auto declared = declared_in(line)) (declared->forward ? forward : whole).insert(declared->type);
      }
    }
    return std::ranges::none_of(forward, [&whole](const std::string& type) { return whole.contains(type); });
  }

  static void insert(Node& root, const std::vector<std::string>& order) {
    Node* node = &root;
    for (const std::string& path : order) {
      std::unique_ptr<Node>& next = node->inside[path];
      if (next == nullptr) next = std::make_unique<Node>();
      node = next.get();
    }
  }

  void lay_out(const Node& node, const std::string& around) {
    for (const auto& [path, inside] : node.inside) {
      const std::string name = "apart_" + std::to_string(++spaces_);
      text_ += "namespace " + name + " {\nnamespace erg {" + (around.empty() ? "" : "using namespace " + around) +
               (around.empty() ? "" : "::erg;") + "}\n";
      Paths macros;
      append(path, macros);
      lay_out(*inside, (around.empty() ? "" : around + "::") + name);
      end(macros);
    }
  }

  void lay_out_in_one(const std::vector<std::string>& order) {
    text_ += "namespace apart_" + std::to_string(++spaces_) + " {\n";
    Paths macros;
    for (const std::string& path : order) append(path, macros);
    end(macros);
  }

  void append(const std::string& path, Paths& macros) {
    text_ += "#line 1 \"" + path + "\"\n";
    for (const std::string& line : tree_.at(path).lines) {
      if (const std::string macro = macro_of(line); !macro.empty()) macros.insert(macro);
      const bool leave_out = line.starts_with("#include ") || line.starts_with("#pragma once");
      text_ += (leave_out ? "" : line) + "\n";
    }
  }

  void end(const Paths& macros) {
    text_ += "}\n";
    for (const std::string& macro : macros) text_ += "#undef " + macro + "\n";
  }

  const std::map<std::string, SourceFile>& tree_;
  std::map<std::string, Paths> closures_;  // of each header: itself and all that it includes from src/
  std::map<std::string, int> times_;       // how many closures hold it
  std::string text_;
  int spaces_ = 0;
};

}  // namespace

std::string headers_apart(const std::map<std::string, SourceFile>& tree) { return HeadersApart(tree).text(); }

}  // namespace erg::test
