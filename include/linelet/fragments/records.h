// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <linelet/fragments/pieces.h>
#include <linelet/fragments/plan.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC fragments {

/** \brief The file with the results of the points that a fragment owns. */
std::string
resultPath(const std::string& folder, std::size_t number);

/** \brief Writes a record for every point that \a fragment owns.
 * \param[in] records of \a bytes each, for its points from \a first to at least the
 * last that it owns
 * \param[in] first no later than the first point that it owns
 * \throws io::FileError */
void
writeRecords(const std::string& path,
             const Fragment& fragment,
             const void* records,
             std::size_t bytes,
             std::size_t first = 0);

/** \brief The records of the points of one input, from all fragments, in its order. */
class RecordStream {
public:
  /** \param[in] usable fragments; others have no records
   * \throws io::FileError where a result is missing or damaged */
  RecordStream(const Plan& plan,
               const std::string& folder,
               std::size_t input,
               std::size_t bytes,
               const std::vector<bool>& usable);

  /** \brief Copies the records of the next \a count points to \a records; those of
   * points that no fragment owns (without coordinates, or left out) are unchanged.
   * \throws io::FileError */
  void
  next(std::size_t count, void* records);

private:
  struct Part {
    std::string path;
    std::uint64_t places_at, records_at; ///< bytes in the file
    std::uint64_t count, taken = 0;
    std::vector<std::uint32_t> places; ///< of the next ones
    std::size_t used = 0;              ///< of these
  };

  void
  take(Part& part, std::size_t count, char* records);

  std::vector<Part> parts_;
  std::size_t bytes_, first_ = 0;
};

} // namespace fragments
} // namespace linelet
