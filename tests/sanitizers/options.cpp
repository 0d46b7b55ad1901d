// What the sanitizers are to know; part of every program built with one, so that it holds however the program is
// started. They look these functions up by name. What the environment says (ASAN_OPTIONS ...) comes on top.

extern "C" {

#if defined(ERG_SANITIZE_ADDRESS)

const char* __asan_default_options() { return "detect_stack_use_after_return=1:detect_leaks=1"; }
const char* __lsan_default_options() { return "print_suppressions=0"; }
const char* __ubsan_default_options() { return "print_stacktrace=1:halt_on_error=1"; }

/// Memory that others hold until the program ends: Mesa its compiled shaders and its screen.
const char* __lsan_default_suppressions() { return "leak:swrast_dri.so\nleak:libOSMesa\n"; }

/// Instead of the system's: libraries stay loaded. Memory is looked for at the program's very end. By then the graphics
/// driver would be unloaded, and what it has kept would be nobody's: held by no variable, allocated by no file that
/// could be named above.
int dlclose(void*) { return 0; }

#elif defined(ERG_SANITIZE_THREAD)

const char* __tsan_default_options() { return "halt_on_error=1:second_deadlock_stack=1"; }

#endif

}  // extern "C"
