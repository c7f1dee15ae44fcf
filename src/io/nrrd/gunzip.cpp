// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gunzip.h"

#include <algorithm>

#ifdef LINELET_HAS_ZLIB
#include <zlib.h>
#endif

namespace linelet::io {

#ifdef LINELET_HAS_ZLIB

std::string
gunzip(const Source& source, std::string_view packed, std::size_t size)
{
  // One byte of deflate expands to at most 1032.
  if (size / 1032 > packed.size())
    source.fail("the header claims more numbers than " + std::to_string(packed.size()) +
                " packed bytes can hold");
  std::string bytes(size, '\0');
  z_stream stream{};
  constexpr int gzip_window = 15 + 16;
  if (inflateInit2(&stream, gzip_window) != Z_OK)
    source.fail("zlib cannot be used");
  std::size_t read = 0, made = 0;
  int state = Z_OK;
  while (state == Z_OK && made < size) {
    constexpr std::size_t most = 1U << 30; // zlib counts in 32 bits
    const std::size_t in = std::min(most, packed.size() - read);
    const std::size_t out = std::min(most, size - made);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + read));
    stream.avail_in = static_cast<uInt>(in);
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data() + made);
    stream.avail_out = static_cast<uInt>(out);
    state = inflate(&stream, Z_NO_FLUSH);
    read += in - stream.avail_in;
    made += out - stream.avail_out;
  }
  inflateEnd(&stream);
  if (state != Z_OK && state != Z_STREAM_END && state != Z_BUF_ERROR)
    source.fail("its packed data are damaged");
  bytes.resize(made);
  return bytes;
}

#else

std::string
gunzip(const Source& source, std::string_view, std::size_t)
{
  source.fail("is packed by gzip, and this linelet was built without zlib");
}

#endif

} // namespace linelet::io
