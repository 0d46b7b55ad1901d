#include "header_chains.h"

#include <algorithm>

namespace erg::test {
namespace {

void add_included(const Includes& tree, const std::string& file, std::set<std::string>& found) {
  const auto entry = tree.find(file);
  if (entry == tree.end()) return;
  for (const std::string& included : entry->second) {
    if (found.insert(included).second) add_included(tree, included, found);
  }
}

/// Gives each header at most one that includes it to stand behind it, and no two the same: a matching, grown along
/// alternating paths (Kuhn). The more pairs there are the fewer chains.
class Matching {
 public:
  explicit Matching(const Includes& tree) {
    for (const auto& [path, included] : tree) {
      if (!path.ends_with(".h")) continue;
      headers_.push_back(path);
      for (const std::string& lower : included_at_last(tree, path)) users_[lower].push_back(path);
    }
    for (const std::string& header : headers_) {
      std::set<std::string> tried;
      find_next(header, tried);
    }
  }

  std::vector<HeaderChain> chains() const {
    std::map<std::string, std::string> next;
    for (const auto& [upper, lower] : before_) next[lower] = upper;
    std::vector<HeaderChain> all;
    for (const std::string& header : headers_) {
      if (before_.contains(header)) continue;
      HeaderChain chain{header};
      for (auto at = next.find(header); at != next.end(); at = next.find(chain.back())) chain.push_back(at->second);
      all.push_back(std::move(chain));
    }
    return all;
  }

 private:
  bool find_next(const std::string& header, std::set<std::string>& tried) {
    for (const std::string& user : users_[header]) {
      if (!tried.insert(user).second) continue;
      const auto taken = before_.find(user);
      if (taken != before_.end() && !find_next(taken->second, tried)) continue;
      before_[user] = header;
      return true;
    }
    return false;
  }

  std::vector<std::string> headers_;
  std::map<std::string, std::vector<std::string>> users_;  // of a header: those that include it
  std::map<std::string, std::string> before_;              // of a header: the one that stands before it
};

}  // namespace

std::set<std::string> included_at_last(const Includes& tree, const std::string& header) {
  std::set<std::string> found;
  add_included(tree, header, found);
  return found;
}

std::vector<HeaderChain> header_chains(const Includes& tree) { return Matching(tree).chains(); }

}  // namespace erg::test
