// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// As many neighbors at a time as the device has lanes for floats (WIDTH, a constant at
// build time): 1 on most GPUs, where work-items themselves are the lanes, 4 to 16 on CPUs.

#ifndef WIDTH
#define WIDTH 1
#endif

// Drivers must see the constants with which these functions are called.
#define INLINE static inline __attribute__((always_inline))

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)

#if WIDTH == 1
typedef float Floats;
typedef int Ints;
#define LOAD(pointer) (*(pointer))
#define STORE(values, pointer) (*(pointer) = (values))
#define ANY(mask) (mask)
#define LANES 0
#define MASK_IF(condition) ((condition) ? -1 : 0)
#else
typedef JOIN(float, WIDTH) Floats;
typedef JOIN(int, WIDTH) Ints;
#define LOAD(pointer) JOIN(vload, WIDTH)(0, pointer)
#define STORE(values, pointer) JOIN(vstore, WIDTH)(values, 0, pointer)
#define ANY(mask) (sumInts(mask) != 0) // any() becomes a branch per lane on CPUs
#if WIDTH == 4
#define LANES (int4)(0, 1, 2, 3)
#elif WIDTH == 8
#define LANES (int8)(0, 1, 2, 3, 4, 5, 6, 7)
#else
#define LANES (int16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15)
#endif
// Comparisons of vectors already give 0 and -1.
#define MASK_IF(condition) (condition)
#endif

// Sum of all lanes.
INLINE float
sumFloats(Floats v)
{
#if WIDTH == 16
  const float8 a = v.lo + v.hi;
  const float4 b = a.lo + a.hi;
#elif WIDTH == 8
  const float4 b = v.lo + v.hi;
#elif WIDTH == 4
  const float4 b = v;
#endif
#if WIDTH == 1
  return v;
#else
  return (b.x + b.y) + (b.z + b.w);
#endif
}

INLINE uint
sumInts(Ints v)
{
#if WIDTH == 16
  const int8 a = v.lo + v.hi;
  const int4 b = a.lo + a.hi;
#elif WIDTH == 8
  const int4 b = v.lo + v.hi;
#elif WIDTH == 4
  const int4 b = v;
#endif
#if WIDTH == 1
  return (uint)v;
#else
  return (uint)((b.x + b.y) + (b.z + b.w));
#endif
}
