// How files .k read as GLSL 4.30: stands before their text. core/subset.h and compute/subset.h say the same for C++.
#define u32 uint
#define i32 int
#define ERG_CELL_RULE
#define ERG_ON_DEVICE
#define ERG_CONST(type, name, value) const type name = value
#define GIVEN(at, type, name) layout(std430, binding = at) restrict readonly buffer name##_block { type name; }
#define BUFFER(at, type, name) layout(std430, binding = at) restrict buffer name##_block { type name[]; }
#define INOUT(type) inout type
#define KERNEL(name) void name()
#define THREAD int(gl_GlobalInvocationID.x)
#define EACH_ITEM(item, count) \
  for (int item = THREAD; item < (count); item += int(gl_NumWorkGroups.x * gl_WorkGroupSize.x))
#define ATOMIC_ADD(place, value) atomicAdd(place, value)
#define ATOMIC_EXCHANGE(place, value) atomicExchange(place, value)
#define ATOMIC_READ(place) (place)
#define ATOMIC_RAISE(place, value) if ((place) < (value)) atomicMax(place, value)
layout(local_size_x = 256) in;
