// All headers of src/ in one text for the compiler, so that each is compiled as if it stood alone and the standard
// library is parsed once.
#pragma once

#include <string>

#include "source_tree.h"

namespace erg::test {

/// The text, beginning with the headers of other libraries (whose names all of it sees). A header stands in a namespace
/// inside those of what it includes from src/, in which it sees their names and no other's; headers that include the
/// same share these namespaces, so that nothing is parsed more often than it has to be.
std::string headers_apart(const std::map<std::string, SourceFile>& tree);

}  // namespace erg::test
