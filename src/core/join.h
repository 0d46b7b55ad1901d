// Lists of words in messages and tables.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace erg {

/// The words one after another with `between` between each two: "torus, open".
std::string join(std::span<const std::string> words, std::string_view between);

}  // namespace erg
