// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "report_image.h"

#include <algorithm>

namespace linelet::powerline::report {

namespace {

using Bytes = std::vector<std::uint8_t>;

void
bigEndian(Bytes& out, std::uint32_t value)
{
  for (int shift = 24; shift >= 0; shift -= 8)
    out.push_back(static_cast<std::uint8_t>(value >> shift));
}

std::uint32_t
crc(const std::uint8_t* begin, const std::uint8_t* end)
{
  std::uint32_t value = 0xffffffffU;
  for (; begin != end; ++begin) {
    value ^= *begin;
    for (int bit = 0; bit < 8; ++bit)
      value = (value >> 1) ^ ((value & 1) != 0 ? 0xedb88320U : 0);
  }
  return ~value;
}

void
addChunk(Bytes& png, std::string_view kind, const Bytes& data)
{
  bigEndian(png, static_cast<std::uint32_t>(data.size()));
  const std::size_t begin = png.size();
  png.insert(png.end(), kind.begin(), kind.end());
  png.insert(png.end(), data.begin(), data.end());
  bigEndian(png, crc(png.data() + begin, png.data() + png.size()));
}

/** A zlib stream of stored blocks: the pictures are small, and no library is needed. */
Bytes
stored(const Bytes& data)
{
  Bytes out = {0x78, 0x01};
  std::uint32_t low = 1, high = 0; // Adler-32
  for (const std::uint8_t byte : data) {
    low = (low + byte) % 65521;
    high = (high + low) % 65521;
  }
  for (std::size_t at = 0; at < data.size();) {
    const std::size_t size = std::min<std::size_t>(65535, data.size() - at);
    out.push_back(at + size == data.size() ? 1 : 0);
    for (const std::size_t half : {size, ~size}) {
      out.push_back(static_cast<std::uint8_t>(half & 0xff));
      out.push_back(static_cast<std::uint8_t>((half >> 8) & 0xff));
    }
    out.insert(out.end(),
               data.begin() + static_cast<std::ptrdiff_t>(at),
               data.begin() + static_cast<std::ptrdiff_t>(at + size));
    at += size;
  }
  bigEndian(out, high << 16 | low);
  return out;
}

} // namespace

std::string
base64(const std::vector<std::uint8_t>& data)
{
  static constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve(data.size() * 4 / 3 + 4);
  for (std::size_t i = 0; i < data.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, data.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (k < left ? data[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      out += k <= left ? letters[(word >> (18 - 6 * k)) & 63] : '=';
  }
  return out;
}

std::string
pngBase64(std::size_t width,
          std::size_t height,
          const std::vector<std::uint8_t>& pixels,
          const std::vector<std::array<std::uint8_t, 3>>& palette)
{
  Bytes png = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  Bytes header;
  bigEndian(header, static_cast<std::uint32_t>(width));
  bigEndian(header, static_cast<std::uint32_t>(height));
  header.insert(header.end(), {8, 3, 0, 0, 0}); // 8 bits, palette
  addChunk(png, "IHDR", header);
  Bytes colors;
  for (const auto& color : palette)
    colors.insert(colors.end(), color.begin(), color.end());
  addChunk(png, "PLTE", colors);
  Bytes rows;
  for (std::size_t row = 0; row < height; ++row) {
    rows.push_back(0); // no filter
    const auto begin = pixels.begin() + static_cast<std::ptrdiff_t>(row * width);
    rows.insert(rows.end(), begin, begin + static_cast<std::ptrdiff_t>(width));
  }
  addChunk(png, "IDAT", stored(rows));
  addChunk(png, "IEND", {});
  return base64(png);
}

} // namespace linelet::powerline::report
