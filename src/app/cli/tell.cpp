#include "app/cli/tell.h"

#include <cstdio>

#include "core/errors.h"
#include "sim/memory.h"

namespace erg::app {

void tell(const std::exception& error) {
  const auto* input = dynamic_cast<const InputError*>(&error);
  if (input == nullptr) return static_cast<void>(std::fprintf(stderr, "erg: %s\n", sim::problem_of(error).c_str()));
  for (const Mistake& mistake : input->mistakes()) std::fprintf(stderr, "%s\n", mistake.text().c_str());
}

}  // namespace erg::app
