// Which machine instructions vector code may use.
#pragma once

#include <string>

namespace erg::compute {

/// The variable of the environment that forces an InstructionSet.
inline constexpr const char* instructions_variable = "ERG_INSTRUCTIONS";

/// Which machine instructions the vector paths may use. All give the same bits.
enum class InstructionSet { portable, avx2, avx512 };
/// The best that this processor has.
InstructionSet best_instruction_set();
/// "portable", "avx2", "avx512".
std::string to_string(InstructionSet set);
/// The set of this name. Throws InputError, at `place`, for an unknown name and for a set that this processor lacks.
InstructionSet find_instruction_set(const std::string& name, const std::string& place);
/// The set that the variable ERG_INSTRUCTIONS of the environment asks for, for tests and reports; the best one where it
/// asks for none. Throws InputError as find_instruction_set.
InstructionSet wanted_instruction_set();

}  // namespace erg::compute
