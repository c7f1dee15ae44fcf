// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <linelet/io/cloud.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief Class numbers given as text: "7,18"; "none" and "all" give an empty list. */
class ClassList {
public:
  /** \throws std::invalid_argument */
  explicit ClassList(std::string_view text);

  const std::string&
  name() const
  {
    return text_;
  }

  bool
  empty() const
  {
    return numbers_.empty();
  }

  bool
  contains(int number) const;

private:
  std::string text_;
  std::vector<int> numbers_;
};

/** \brief Which points of a classified cloud an analysis may use. Clouds without
 * classes are unaffected. */
struct ClassFilter {
  /// Points of these classes are ignored: by default noise, low and high (ASPRS).
  ClassList ignored{"7,18"};
  /// If it names any, only points of these classes are used, ignored or not.
  ClassList kept{"all"};

  bool
  passes(int number) const;
};

template <class Visit>
void
describe(ClassFilter& s, Visit&& visit)
{
  visit("ignore-classes",
        s.ignored,
        "ignore points of these classes, unless --keep-classes names any; none: ignore "
        "none");
  visit("keep-classes", s.kept, "use only points of these classes");
}

/** \brief The points of a cloud that an analysis may use.
 *
 * Points flagged as withheld count as deleted (LAS specification: not to be included in
 * processing), and noise is part of no surface. Both stay in the cloud, so that a file
 * written from it has them bit for bit; here their coordinates are NaN, which every
 * analysis skips. Overlap, synthetic and key points are used like others. */
class UsablePoints {
public:
  /** \brief The usable points of \a cloud, which must outlive this.
   * \param[out] warnings one sentence for each reason to leave points out */
  explicit UsablePoints(const Cloud& cloud,
                        std::vector<std::string>* warnings = nullptr,
                        const ClassFilter& classes = {});

  /** \brief As many as the cloud has, in its order; NaN where left out. */
  const Points&
  points() const
  {
    return leftOut() == 0 ? cloud_.points : usable_;
  }

  /** \brief How many are flagged as withheld. */
  std::size_t
  withheld() const
  {
    return withheld_;
  }

  /** \brief How many of the others are left out because of their class. */
  std::size_t
  ignored() const
  {
    return ignored_;
  }

  std::size_t
  leftOut() const
  {
    return withheld_ + ignored_;
  }

private:
  void
  leaveOut(std::size_t i);

  const Cloud& cloud_;
  Points usable_; // empty where nothing is left out
  std::size_t withheld_ = 0, ignored_ = 0;
};

} // namespace io
} // namespace linelet
