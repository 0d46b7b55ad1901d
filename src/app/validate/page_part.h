// A part of a Markdown page: a heading and what stands under it.
#pragma once

#include <string>

namespace erg::app {

/// `page` with the part that has the heading of `part` (its first line) replaced by it: from that heading to the next
/// of the same or a higher level. A part that the page does not have is added at its end.
std::string with_part(const std::string& page, const std::string& part);

}  // namespace erg::app
