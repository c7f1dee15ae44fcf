// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Eigen-analysis: cyclic Jacobi, WIDTH tensors per work-item. It keeps the small
// eigenvalues of wire-like tensors better than closed forms do.

#define TURNS 5 // convergence is quadratic
#define FIELDS 18 // floats of a record, in the order of linelet::PointDistributionTensor

typedef struct {
  Floats x, y, z;
} Column;

INLINE void
turn(Floats* u, Floats* v, Floats c, Floats s)
{
  const Floats old = *u;
  *u = c * old - s * *v;
  *v = s * old + c * *v;
}

// Rotates the axes p and q by the angle that makes the entry (p, q) zero; r is the
// third.
INLINE void
rotate(Floats* pp, Floats* qq, Floats* pq, Floats* pr, Floats* qr, Column* p, Column* q)
{
  const Floats zero = 0;
  const Floats difference = *qq - *pp, twice = 2 * *pq;
  const Floats root = sqrt(difference * difference + twice * twice);
  const Floats below = difference + copysign(root, difference);
  const Floats tangent = below != 0 ? twice / below : zero;
  const Floats c = 1 / sqrt(1 + tangent * tangent);
  const Floats s = tangent * c;
  *pp -= tangent * *pq;
  *qq += tangent * *pq;
  *pq = 0;
  turn(pr, qr, c, s);
  turn(&p->x, &q->x, c, s);
  turn(&p->y, &q->y, c, s);
  turn(&p->z, &q->z, c, s);
}

INLINE void
exchangeIf(Ints yes, Floats* a, Floats* b)
{
  const Floats old = *a;
  *a = yes ? *b : old;
  *b = yes ? old : *b;
}

// Puts two eigenvalues in ascending order, together with their axes.
INLINE void
ascending(Floats* a, Floats* b, Column* u, Column* v)
{
  const Ints swapped = MASK_IF(*a > *b);
  exchangeIf(swapped, a, b);
  exchangeIf(swapped, &u->x, &v->x);
  exchangeIf(swapped, &u->y, &v->y);
  exchangeIf(swapped, &u->z, &v->z);
}

// Makes the component of largest magnitude (the first one in a tie) positive.
INLINE void
orient(Column* c)
{
  const Floats ax = fabs(c->x), ay = fabs(c->y), az = fabs(c->z), one = 1;
  Floats largest = ay > ax ? c->y : c->x;
  largest = az > max(ax, ay) ? c->z : largest;
  const Floats sign = copysign(one, largest);
  c->x *= sign;
  c->y *= sign;
  c->z *= sign;
}

// Writes the records of the queries at WIDTH places, each at its query's index.
kernel void
shapes(global const ulong* queries,
       uint count,
       uint index_bits,
       global const float* radii,
       uint stride,
       global const float* components,
       global const uint* counts,
       global float* records)
{
  const uint first = WIDTH * get_global_id(0);
  if (first >= count)
    return;
  Floats t[6];
  for (uint k = 0; k < 6; ++k)
    t[k] = LOAD(components + k * stride + first);
  // In units of the trace, far from the ends of float.
  const Floats trace = t[0] + t[3] + t[5];
  const Floats scale = 1 / trace;
  Floats xx = t[0] * scale, xy = t[1] * scale, xz = t[2] * scale, yy = t[3] * scale,
         yz = t[4] * scale, zz = t[5] * scale;
  Column u = {1, 0, 0}, v = {0, 1, 0}, w = {0, 0, 1};
  for (int k = 0; k < TURNS; ++k) {
    rotate(&xx, &yy, &xy, &xz, &yz, &u, &v);
    rotate(&xx, &zz, &xz, &xy, &yz, &u, &w);
    rotate(&yy, &zz, &yz, &xy, &xz, &v, &w);
  }
  ascending(&xx, &yy, &u, &v);
  ascending(&yy, &zz, &v, &w);
  ascending(&xx, &yy, &u, &v);
  orient(&u);
  orient(&w);
  const Floats l1 = max(xx, 0.0f), l2 = max(yy, 0.0f), l3 = max(zz, 0.0f);
  const Floats inverse = 1 / (l1 + l2 + l3);
  const Floats fields[FIELDS] = {t[0],
                                 t[1],
                                 t[2],
                                 t[3],
                                 t[4],
                                 t[5],
                                 l1 * trace,
                                 l2 * trace,
                                 l3 * trace,
                                 w.x,
                                 w.y,
                                 w.z,
                                 u.x,
                                 u.y,
                                 u.z,
                                 (l3 - l2) * inverse,
                                 2 * (l2 - l1) * inverse,
                                 3 * l1 * inverse};
  float lanes[FIELDS][WIDTH], traces[WIDTH];
  for (uint k = 0; k < FIELDS; ++k)
    STORE(fields[k], lanes[k]);
  STORE(trace, traces);
  for (uint lane = 0; lane < WIDTH && first + lane < count; ++lane) {
    const uint i = (uint)(queries[first + lane] & (((ulong)1 << index_bits) - 1));
    // An extent below float's precision of the radius is rounding.
    const float least = 1e-6f * radii[i];
    const bool known = traces[lane] > least * least;
    global float* record = records + (FIELDS + 1) * i;
    for (uint k = 0; k < FIELDS; ++k)
      record[k] = known ? lanes[k][lane] : NAN;
    record[FIELDS] = as_float(counts[first + lane]);
  }
}
