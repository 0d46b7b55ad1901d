// What is said to the user where something is refused.
#pragma once

#include <string>

#include "core/errors.h"

namespace erg {

/// The text of the InputError that `call` throws; "no error" when it throws none.
template <typename Call>
std::string message(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace erg
