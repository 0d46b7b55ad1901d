// How kernels in files .k read as C++ and as CUDA: as members of their plan, a plain struct that a launch hands over by
// value (compute/kernel.h). What they share with rules of cells says core/subset.h; compute/subset.glsl says the same
// for GLSL.
#pragma once

#include "compute/kernel.h"
#include "core/subset.h"

// NOLINTBEGIN(bugprone-macro-parentheses): types and names
/// Numbers of a launch, a struct of 32-bit members: for OpenGL a small buffer.
#define GIVEN(at, type, name) type name = {}
/// An array in the back end's memory. `at`: where OpenGL binds it.
#define BUFFER(at, type, name) type* name = nullptr
/// A parameter that a function changes; never an element of a buffer.
#define INOUT(type) type&
/// A kernel: its items are those of EACH_ITEM.
#define KERNEL(name) ERG_ON_DEVICE void name(compute::Items items)
// NOLINTEND(bugprone-macro-parentheses)

/// A number of the thread, to spread threads by.
#define THREAD items.first

// Atomics on an element of a buffer; the first two return what was there before.
#define ATOMIC_ADD(place, value) compute::atomic_add(&(place), value)
#define ATOMIC_EXCHANGE(place, value) compute::atomic_exchange(&(place), value)
/// What others may change at the same time.
#define ATOMIC_READ(place) compute::atomic_read(&(place))
/// Raises a bound that many threads share.
#define ATOMIC_RAISE(place, value) compute::raise(&(place), value)
