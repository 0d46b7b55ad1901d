// Which headers may be compiled in one go and each still count as compiled alone.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace erg::test {

/// For each file, what it includes itself.
using Includes = std::map<std::string, std::vector<std::string>>;

/// All that a header includes, over any number of others; without itself.
std::set<std::string> included_at_last(const Includes& tree, const std::string& header);

/// Headers in which each includes the one before it, at last. Compiled one after the other in one file, each still
/// stands alone: the first has nothing before it, and what stands before any other is what it includes itself.
using HeaderChain = std::vector<std::string>;

/// Chains that hold each header (.h) of the tree once, as few as there can be.
std::vector<HeaderChain> header_chains(const Includes& tree);

}  // namespace erg::test
