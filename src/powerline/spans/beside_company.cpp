// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/spans/beside_company.h"

#include <cmath>

#include "powerline/line_priors.h"
#include "powerline/pieces/parallel.h"

namespace linelet::powerline {

namespace {

constexpr double company_part = 0.7; // of the length of a wire, beside the other

} // namespace

Offset
offsetFrom(const SpanModel& company, const Piece& piece, const Points& points)
{
  Offset offset;
  double squares = 0;
  for (const Index i : piece.members)
    offset.mean += company.residual(points[i], company.along(points[i]));
  const double n = static_cast<double>(piece.members.size());
  offset.mean /= n;
  for (const Index i : piece.members)
    squares += (company.residual(points[i], company.along(points[i])) - offset.mean)
                   .squaredNorm();
  offset.spread = std::sqrt(squares / 2 / n / n);
  return offset;
}

double
vagueAt(const Offset& offset, double far)
{
  return std::hypot(offset.spread, priors.alike * far);
}

bool
isCompany(const SpanModel& m, const SpanModel& other)
{
  const Parallel parallel = compare(m, other);
  return parallel.overlap >= company_part * m.length() &&
         parallel.distance <= priors.company_reach;
}

} // namespace linelet::powerline
