// A loop over neighbouring lanes that the compiler turns into vectors. For the kernels' files only.
#pragma once

#if defined(__clang__)
#define ERG_LANES_APART _Pragma("clang loop vectorize(assume_safety)")
#else
#define ERG_LANES_APART _Pragma("GCC ivdep")
#endif

/// for (int i = 0; i < count; ++i), whose rounds do not depend on each other. The count is copied first: bytes may
/// alias anything, so the compiler would read a member again.
// NOLINTNEXTLINE(bugprone-macro-parentheses): i is a name
#define ERG_EACH(i, count) ERG_LANES_APART for (int i = 0, end_of_##i = (count); i < end_of_##i; ++i)
