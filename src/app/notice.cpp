#include "app/notice.h"

#include <iostream>

namespace erg {

void print_notice(Executor& executor) {
  // The line of progress, if there is one, is drawn over.
  if (const std::string notice = executor.take_notice(); !notice.empty()) std::cerr << "\rerg: " << notice << "\n";
}

}  // namespace erg
