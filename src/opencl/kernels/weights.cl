// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// The weighting kernels of linelet::Weighting in float, by the names that the host
// gives their enumerators. The kernel is known at build time, so only one case remains.

INLINE Floats
power(Floats base, int exponent)
{
  Floats result = 1;
  for (; exponent > 0; --exponent)
    result *= base;
  return result;
}

// 2^x for lowest <= x <= 126. CPU drivers call a function for the exponential of a
// vector, and a loop around such a call keeps nothing in registers.
INLINE Floats
powerOfTwo(Floats x, const int lowest)
{
#if WIDTH == 1
  return exp2(x);
#else
  // Integer and fractional part: conversion rounds nonnegative numbers down.
  const Floats above = x - lowest;
  const Ints whole = JOIN(convert_int, WIDTH)(above);
  const Floats rest = above - JOIN(convert_float, WIDTH)(whole);
  // Minimax polynomial of 2^x, 0 <= x <= 1: relative error 7.5e-8.
  Floats p = 1.877576673e-03f;
  p = p * rest + 8.989340095e-03f;
  p = p * rest + 5.582631805e-02f;
  p = p * rest + 2.401536170e-01f;
  p = p * rest + 6.931530732e-01f;
  p = p * rest + 9.999999251e-01f;
  return JOIN(as_float, WIDTH)(JOIN(as_int, WIDTH)(p) + ((whole + lowest) << 23));
#endif
}

// 1 / (exp((x - m) / temperature) + 1), for x from 0 to 2.
INLINE Floats
fermiDirac(Floats x, float m, float temperature)
{
  // All except x is known when the program is built.
  const float scale = M_LOG2E_F / temperature, shift = m * scale;
  Floats exponent = x * scale - shift;
  const bool wide = 2 * scale + fabs(shift) > 126;
  if (wide)
    exponent = clamp(exponent, -126.0f, 126.0f);
  const int lowest = wide ? -127 : -(int)fabs(shift) - 1;
  return 1 / (powerOfTwo(exponent, lowest) + 1);
}

INLINE Floats
bounce(Floats x)
{
  const Floats first = 121.0f / 16 * x * x;
  const Floats second = (363.0f / 40 * x - 99.0f / 10) * x + 17.0f / 5;
  const Floats third = (4356.0f / 361 * x - 35442.0f / 1805) * x + 16061.0f / 1805;
  const Floats last = (54.0f / 5 * x - 513.0f / 25) * x + 268.0f / 25;
  return x < 4.0f / 11 ? first : x < 8.0f / 11 ? second : x < 9.0f / 10 ? third : last;
}

INLINE Floats
weightOf(const int kernel_number, float first, float second, Floats x)
{
  const Floats zero = 0, one = 1;
  const Floats y = 1 - x;
  const Ints rising = x < 0.5f;
  Floats w = 0;
  switch (kernel_number) {
  case KERNEL_Const:
    return one;
  case KERNEL_LinearInverse:
    return min(0.1f / x, 1.0f);
  case KERNEL_QuadraticInverse:
    return min(0.01f / (x * x), 1.0f);
  case KERNEL_CubicInverse:
    return min(0.001f / (x * x * x), 1.0f);
  case KERNEL_InverseDistance:
    return x > 0 ? 1 / x : zero;
  case KERNEL_InverseSquaredDistance:
    return x > 0 ? 1 / (x * x) : zero;
  case KERNEL_FermiDirac1:
  case KERNEL_FermiDirac2:
  case KERNEL_FermiDirac3:
  case KERNEL_FermiDirac:
    return fermiDirac(x, first, second);
  case KERNEL_Step:
    return x <= first ? one : zero;
  case KERNEL_Linear:
  case KERNEL_CsRbf1:
    w = y;
    break;
  case KERNEL_Quadratic:
    w = 1 - x * x;
    break;
  case KERNEL_Cubic:
    w = 1 - x * x * x;
    break;
  case KERNEL_Sph3: {
    const Floats a = 2 * x;
    w = a < 1 ? 1 - 1.5f * a * a + 0.75f * a * a * a : 0.25f * power(2 - a, 3);
    break;
  }
  case KERNEL_Sph4: {
    const Floats b = 2.5f * x;
    w = power(2.5f - b, 4) - 5 * power(max(1.5f - b, 0.0f), 4) +
        10 * power(max(0.5f - b, 0.0f), 4);
    break;
  }
  case KERNEL_Sph5: {
    const Floats c = 3 * x;
    w = power(3 - c, 5) - 6 * power(max(2 - c, 0.0f), 5) +
        15 * power(max(1 - c, 0.0f), 5);
    break;
  }
  case KERNEL_Epanechnikov:
    w = 0.75f * (1 - x * x);
    break;
  case KERNEL_EaseBounce:
    w = 1 - (rising ? (1 - bounce(1 - 2 * x)) / 2 : (1 + bounce(2 * x - 1)) / 2);
    break;
  case KERNEL_EaseCircular:
    w = 1 - (rising ? (1 - sqrt(max(1 - 4 * x * x, 0.0f))) / 2
                    : (sqrt(max((3 - 2 * x) * (2 * x - 1), 0.0f)) + 1) / 2);
    break;
  case KERNEL_EaseElastic: {
    const Floats swing = 0.5f * sin(13 * M_PI_F * x);
    w = 1 - (rising ? swing * exp2(10 * (2 * x - 1))
                    : 1 - swing * exp2(-10 * (2 * x - 1)));
    break;
  }
  case KERNEL_EaseExponential:
    w = 1 - (rising ? exp2(20 * x - 10) / 2 : 1 - exp2(10 - 20 * x) / 2);
    w = x == 0 ? one : w;
    break;
  case KERNEL_EaseSine:
    w = (1 + cos(M_PI_F * x)) / 2;
    break;
  case KERNEL_EaseCubic:
    w = 1 - (rising ? 4 * x * x * x : power(2 * x - 2, 3) / 2 + 1);
    break;
  case KERNEL_EaseQuadratic:
    w = 1 - (rising ? 2 * x * x : (4 - 2 * x) * x - 1);
    break;
  case KERNEL_EaseQuintic:
    w = 1 - (rising ? 16 * power(x, 5) : power(2 * x - 2, 5) / 2 + 1);
    break;
  case KERNEL_CsRbf2:
    w = power(y, 3) * (3 * x + 1);
    break;
  case KERNEL_CsRbf3:
    w = power(y, 5) * ((8 * x + 5) * x + 1);
    break;
  case KERNEL_CsRbf4:
    w = y * y;
    break;
  case KERNEL_CsRbf5:
    w = power(y, 4) * (4 * x + 1);
    break;
  case KERNEL_CsRbf6:
    w = power(y, 6) * ((35 * x + 18) * x + 3);
    break;
  case KERNEL_CsRbf7:
    w = power(y, 8) * (((32 * x + 25) * x + 8) * x + 1);
    break;
  case KERNEL_CsRbf8:
    w = power(y, 3);
    break;
  case KERNEL_CsRbf9:
    w = power(y, 3) * (5 * x + 1);
    break;
  case KERNEL_CsRbf10:
    w = power(y, 7) * ((16 * x + 7) * x + 1);
    break;
  default:
    return NAN;
  }
  return x < 1 ? max(w, 0.0f) : zero;
}

// Evaluates a weighting at many places (a multiple of WIDTH of them), so that it can be
// tested by itself.
kernel void
weights(int kernel_number, float first, float second, global const float* x, global float* w)
{
  const uint i = WIDTH * get_global_id(0);
  const Floats values = weightOf(kernel_number, first, second, LOAD(x + i));
#if WIDTH == 1
  w[i] = values;
#else
  JOIN(vstore, WIDTH)(values, 0, w + i);
#endif
}
