// Numbers as text that loses nothing.
#pragma once

#include <string>

namespace erg {

/// As few digits as read back as the same number: "0.1", "-2", "1e-06".
std::string exact_text(double value);

}  // namespace erg
