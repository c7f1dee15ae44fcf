// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Screen-space normals, one work-item per pixel: what src/screen/normal_kernels.cpp
// does.

// PaddedSamples and settings; the host has the same struct.
typedef struct {
  int width, height, layers, stride, layer, margin;
  int method, rings;
  float limit;
} Picture;

constant int ring_places[6][4][2] = {{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}},
                                     {{2, 2}, {-2, 2}, {-2, -2}, {2, -2}},
                                     {{2, 0}, {0, 2}, {-2, 0}, {0, -2}},
                                     {{3, 3}, {-3, 3}, {-3, -3}, {3, -3}},
                                     {{1, 0}, {0, 1}, {-1, 0}, {0, -1}},
                                     {{3, 0}, {0, 3}, {-3, 0}, {0, -3}}};

static float3
sampleAt(global const float* x, global const float* y, global const float* z, int k)
{
  return (float3)(x[k], y[k], z[k]);
}

static float
squareOf(float3 v)
{
  return (v.x * v.x + v.y * v.y) + v.z * v.z;
}

static float3
crossOf(float3 u, float3 v)
{
  return (float3)(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
}

static float3
unitOf(float3 n)
{
  const float square = squareOf(n);
  return square > 0 ? n * (1 / sqrt(square)) : (float3)(NAN, NAN, NAN);
}

#define ROTATE(app, aqq, apq, apr, aqr, p, q)                                            \
  {                                                                                      \
    const float diff = aqq - app, twice = apq + apq;                                     \
    const float root = sqrt(diff * diff + twice * twice);                                \
    const float below = diff < 0 ? diff - root : diff + root;                            \
    const float tangent = below != 0 ? twice / below : 0;                                \
    const float cosine = 1 / sqrt(tangent * tangent + 1);                                \
    const float sine = tangent * cosine;                                                 \
    app -= tangent * apq;                                                                \
    aqq += tangent * apq;                                                                \
    apq = 0;                                                                             \
    const float pr = apr;                                                                \
    const float3 old = p;                                                                \
    apr = cosine * pr - sine * aqr;                                                      \
    aqr = cosine * aqr + sine * pr;                                                      \
    p = cosine * old - sine * q;                                                         \
    q = cosine * q + sine * old;                                                         \
  }

static float3
smallestDirection(float xx, float xy, float xz, float yy, float yz, float zz)
{
  const float trace = (xx + yy) + zz;
  if (!(trace > 0))
    return (float3)(NAN, NAN, NAN);
  const float scale = 1 / trace;
  xx *= scale;
  xy *= scale;
  xz *= scale;
  yy *= scale;
  yz *= scale;
  zz *= scale;
  float3 u = (float3)(1, 0, 0), v = (float3)(0, 1, 0), w = (float3)(0, 0, 1);
  for (int turn = 0; turn < 4; ++turn) {
    ROTATE(xx, yy, xy, xz, yz, u, v)
    ROTATE(xx, zz, xz, xy, yz, u, w)
    ROTATE(yy, zz, yz, xy, xz, v, w)
  }
  float least = xx;
  float3 n = u;
  if (yy < least) {
    least = yy;
    n = v;
  }
  if (zz < least) {
    least = zz;
    n = w;
  }
  const float most = fmax(fmax(xx, yy), zz);
  return 1 - most - least > 1e-6f ? n : (float3)(NAN, NAN, NAN);
}

// The unit normal of a triangle, 0 where its corners do not count.
static float3
cornerOf(float3 a, float3 b, float3 c, float limit)
{
  const float3 u = a - c, v = b - c, n = crossOf(u, v);
  const float square = squareOf(n);
  return squareOf(u) <= limit && squareOf(v) <= limit && square > 0
             ? n * (1 / sqrt(square))
             : (float3)(0, 0, 0);
}

kernel void
screenNormals(constant Picture* picture,
              global const float* x,
              global const float* y,
              global const float* z,
              global const float* cx,
              global const float* cy,
              global const float* cz,
              global float* normals)
{
  const int pixel = (int)get_global_id(0);
  if (pixel >= picture->width * picture->height)
    return;
  const int stride = picture->stride;
  const int at = (pixel / picture->width + picture->margin) * stride +
                 pixel % picture->width + picture->margin;
  const float3 c = sampleAt(cx, cy, cz, at);
  const float limit = picture->limit;
  float3 n = (float3)(0, 0, 0);
  if (picture->method == 0) { // LD
    n = cornerOf(sampleAt(cx, cy, cz, at + stride), sampleAt(cx, cy, cz, at + 1), c, limit);
    if (n.x == 0 && n.y == 0 && n.z == 0)
      n = cornerOf(
          sampleAt(cx, cy, cz, at - stride), sampleAt(cx, cy, cz, at - 1), c, limit);
    n = unitOf(n);
  }
  else if (picture->method == 3) { // TI
    float xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    for (int k = 0; k < 4 * picture->rings; ++k) {
      const int place =
          at + ring_places[k / 4][k % 4][1] * stride + ring_places[k / 4][k % 4][0];
      for (int layer = 0; layer < picture->layers; ++layer) {
        const float3 d = sampleAt(x, y, z, layer * picture->layer + place) - c;
        const float square = squareOf(d);
        if (!(square > 0 && square <= limit))
          continue;
        const float3 weighted = d * (1 / sqrt(square));
        xx += weighted.x * d.x;
        xy += weighted.x * d.y;
        xz += weighted.x * d.z;
        yy += weighted.y * d.y;
        yz += weighted.y * d.z;
        zz += weighted.z * d.z;
      }
    }
    n = smallestDirection(xx, xy, xz, yy, yz, zz);
  }
  else {
    for (int layer = 0; layer < picture->layers; ++layer)
      for (int ring = 0; ring < picture->rings; ++ring) {
        float3 s[4];
        for (int k = 0; k < 4; ++k)
          s[k] = sampleAt(x,
                          y,
                          z,
                          layer * picture->layer + at + ring_places[ring][k][1] * stride +
                              ring_places[ring][k][0]);
        if (picture->method == 1) { // PD
          bool counts = true;
          for (int k = 0; k < 4; ++k)
            counts = counts && squareOf(s[k] - c) <= limit;
          if (counts)
            n += crossOf(s[0] - s[2], s[1] - s[3]);
        }
        else // PC
          for (int k = 0; k < 4; ++k)
            n += cornerOf(s[k], s[(k + 1) % 4], c, limit);
      }
    n = unitOf(n);
  }
  normals[3 * pixel] = n.x;
  normals[3 * pixel + 1] = n.y;
  normals[3 * pixel + 2] = n.z;
}
