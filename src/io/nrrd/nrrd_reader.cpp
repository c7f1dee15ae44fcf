// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "nrrd_reader.h"

#include <array>
#include <vector>

#include "gunzip.h"
#include "io/columns.h"
#include "io/text_scan.h"
#include "nrrd_header.h"

namespace linelet::io {

namespace {

/** \brief The numbers of a volume, in file order. */
std::vector<double>
numbersOf(const Source& source, const NrrdHeader& header)
{
  const std::size_t count = header.numbers(), width = sizeOf(header.type);
  const auto check = [&](std::size_t there) {
    if (there < count)
      source.fail("the header claims " + std::to_string(count) +
                  " numbers, but the file ends after " + std::to_string(there));
  };
  std::vector<double> numbers;
  if (header.encoding == "ascii" || header.encoding == "text" ||
      header.encoding == "txt") {
    check(header.data.size()); // a number takes at least one character
    std::string_view text = header.data;
    numbers.reserve(count);
    for (std::string_view word = takeWord(text, ", \t\r\n");
         !word.empty() && numbers.size() < count;
         word = takeWord(text, ", \t\r\n")) {
      double value = 0;
      if (!parseNumber(word, value))
        source.fail("'" + cleanName(word.substr(0, 40)) + "' is not a number");
      numbers.push_back(value);
    }
    check(numbers.size());
    return numbers;
  }
  std::string unpacked;
  std::string_view bytes = header.data;
  if (header.encoding == "gzip" || header.encoding == "gz") {
    unpacked = gunzip(source, bytes, count * width);
    bytes = unpacked;
  }
  else if (header.encoding != "raw")
    source.fail("encoding '" + cleanName(header.encoding.substr(0, 40)) +
                "' is not read; use raw, ascii or gzip");
  check(bytes.size() / width);
  numbers.resize(count);
  withType(header.type, [&](auto zero) {
    using T = decltype(zero);
    for (std::size_t i = 0; i < count; ++i) {
      const char* at = bytes.data() + i * width;
      numbers[i] = static_cast<double>(
          header.big_endian ? load<T, boost::endian::order::big>(at) : load<T>(at));
    }
  });
  return numbers;
}

/** \brief The tensor of a sample, in the space of the points. */
Eigen::Matrix3d
tensorOf(const NrrdHeader& header, const std::vector<double>& sample)
{
  Eigen::Matrix3d t;
  if (header.kind == SampleKind::Matrix)
    t << sample[0], sample[1], sample[2], sample[3], sample[4], sample[5], sample[6],
        sample[7], sample[8];
  else {
    const double* s =
        sample.data() + (header.kind == SampleKind::MaskedSymmetric ? 1 : 0);
    t << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5];
  }
  const Eigen::Matrix3d symmetric = (t + t.transpose()) / 2;
  return header.frame * symmetric * header.frame.transpose();
}

} // namespace

Cloud
readNrrd(const Source& source)
{
  const NrrdHeader header = readNrrdHeader(source);
  const std::vector<double> numbers = numbersOf(source, header);
  constexpr std::array<const char*, 6> names = {"xx", "xy", "xz", "yy", "yz", "zz"};
  constexpr std::array<std::array<Eigen::Index, 2>, 6> entries = {
      {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
  std::array<std::vector<double>, 3> places;
  std::vector<std::vector<float>> values(header.kind == SampleKind::Number ? 1 : 6);
  std::vector<double> sample(header.components);
  const auto part = [](std::size_t i) { return static_cast<double>(i); };
  for (std::size_t k = 0; k < header.sizes[2]; ++k)
    for (std::size_t j = 0; j < header.sizes[1]; ++j)
      for (std::size_t i = 0; i < header.sizes[0]; ++i) {
        const std::size_t first =
            i * header.steps[0] + j * header.steps[1] + k * header.steps[2];
        for (std::size_t c = 0; c < sample.size(); ++c)
          sample[c] = numbers[first + c * header.component_step];
        if (header.kind == SampleKind::MaskedSymmetric && !(sample[0] >= 0.5))
          continue;
        const Point at =
            header.origin + header.directions * Point(part(i), part(j), part(k));
        for (std::size_t a = 0; a < 3; ++a)
          places[a].push_back(at[static_cast<Eigen::Index>(a)]);
        if (header.kind == SampleKind::Number) {
          values[0].push_back(static_cast<float>(sample[0]));
          continue;
        }
        const Eigen::Matrix3d tensor = tensorOf(header, sample);
        for (std::size_t e = 0; e < entries.size(); ++e)
          values[e].push_back(static_cast<float>(tensor(entries[e][0], entries[e][1])));
      }
  std::vector<Column> columns;
  for (std::size_t a = 0; a < 3; ++a)
    columns.push_back(
        {std::array<const char*, 3>{"x", "y", "z"}[a], std::move(places[a]), {}});
  for (std::size_t v = 0; v < values.size(); ++v)
    columns.push_back(
        {values.size() == 1 ? "value" : names[v], std::move(values[v]), {}});
  Cloud cloud = cloudFromColumns(source, std::move(columns));
  cloud.format = "NRRD, " + header.encoding;
  return cloud;
}

} // namespace linelet::io
