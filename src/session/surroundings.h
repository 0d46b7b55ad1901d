// What the program asks of the system that it runs on.
#pragma once

#include <ctime>
#include <filesystem>
#include <string>

namespace erg::session {

/// A moment on the local clock, in a form of strftime: "%H:%M:%S".
std::string local_time(const char* form, std::time_t moment = std::time(nullptr));

/// The value of an environment variable that holds an absolute path; empty when there is none.
std::filesystem::path path_from_environment(const char* name);

}  // namespace erg::session
