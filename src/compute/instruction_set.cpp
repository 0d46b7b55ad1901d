#include "compute/instruction_set.h"

#include <cstdlib>
#include <vector>

#include "core/errors.h"

namespace erg::compute {

InstructionSet best_instruction_set() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq")) {
    return InstructionSet::avx512;
  }
  if (__builtin_cpu_supports("avx2")) return InstructionSet::avx2;
#endif
  return InstructionSet::portable;
}

std::string to_string(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512:
      return "avx512";
    case InstructionSet::avx2:
      return "avx2";
    case InstructionSet::portable:
      break;
  }
  return "portable";
}

InstructionSet find_instruction_set(const std::string& name, const std::string& place) {
  std::vector<std::string> names;
  for (const InstructionSet set : {InstructionSet::portable, InstructionSet::avx2, InstructionSet::avx512}) {
    names.push_back(to_string(set));
    if (names.back() != name) continue;
    if (set <= best_instruction_set()) return set;
    throw InputError(place, "this processor has no " + name,
                     "the best that it has is " + to_string(best_instruction_set()));
  }
  throw InputError(place, "unknown instructions " + quote(name), suggestion(name, names));
}

InstructionSet wanted_instruction_set() {
  const char* const name = std::getenv(instructions_variable);
  return name == nullptr || *name == '\0' ? best_instruction_set() : find_instruction_set(name, instructions_variable);
}

}  // namespace erg::compute
