#include "app/cli/notice.h"

#include <iostream>

namespace erg::app {

void print_notice(compute::Executor& executor) {
  // The line of progress, if there is one, is drawn over.
  if (const std::string notice = executor.take_notice(); !notice.empty()) std::cerr << "\rerg: " << notice << "\n";
}

void print_notes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) std::cerr << "note: " << note << "\n";
}

}  // namespace erg::app
