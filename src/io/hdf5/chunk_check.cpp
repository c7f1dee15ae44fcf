// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "chunk_check.h"

#include <cstdint>

#include <zlib.h>

namespace linelet::io::hdf5 {

namespace {

/** \brief Number of bytes that a zlib stream unpacks to; 0 if it is damaged. */
std::size_t
inflatedSize(const std::vector<unsigned char>& stored)
{
  z_stream stream{};
  if (stored.size() > static_cast<uInt>(-1) || inflateInit(&stream) != Z_OK)
    return 0;
  stream.next_in = const_cast<unsigned char*>(stored.data());
  stream.avail_in = static_cast<uInt>(stored.size());
  std::vector<unsigned char> part(std::size_t{1} << 16);
  std::size_t size = 0;
  int state = Z_OK;
  while (state == Z_OK) {
    stream.next_out = part.data();
    stream.avail_out = static_cast<uInt>(part.size());
    state = inflate(&stream, Z_NO_FLUSH);
    size += part.size() - stream.avail_out;
  }
  inflateEnd(&stream);
  return state == Z_STREAM_END ? size : 0;
}

} // namespace

ChunkCheck::ChunkCheck(const Handle& dataset,
                       std::size_t width,
                       std::size_t value_bytes,
                       const std::string& name)
    : name_(name), width_(width)
{
  const std::string what = "read " + name;
  const Handle create(H5Dget_create_plist(dataset.id()), H5Pclose, what);
  if (H5Pget_layout(create.id()) != H5D_CHUNKED)
    return;
  hsize_t extent[2] = {1, 1};
  const int dimensions = H5Pget_chunk(create.id(), 2, extent);
  if (dimensions < 1 || dimensions > 2 || extent[0] == 0 || extent[1] == 0)
    throw Error("cannot read " + name + ": its chunks are damaged");
  chunk_rows_ = extent[0];
  chunk_width_ = extent[1];
  chunk_bytes_ = chunk_rows_ * chunk_width_ * value_bytes;
  const Handle file(H5Iget_file_id(dataset.id()), H5Fclose, what);
  hsize_t size = 0;
  check(H5Fget_filesize(file.id(), &size), what);
  file_bytes_ = size;
  const int filters = H5Pget_nfilters(create.id());
  for (int k = 0; k < filters; ++k) {
    unsigned flags = 0, configuration = 0;
    std::size_t values = 0;
    const H5Z_filter_t filter = H5Pget_filter2(create.id(),
                                               static_cast<unsigned>(k),
                                               &flags,
                                               &values,
                                               nullptr,
                                               0,
                                               nullptr,
                                               &configuration);
    // Shuffling keeps the size.
    if (filter == H5Z_FILTER_DEFLATE && deflate_ < 0)
      deflate_ = k;
    else if (filter != H5Z_FILTER_SHUFFLE)
      throw Error("cannot read " + name +
                  ": it uses an unsupported filter; rewrite it "
                  "with no other than shuffle and deflate (gzip)");
  }
}

void
ChunkCheck::rows(const Handle& dataset, std::size_t first, std::size_t count)
{
  if (chunk_rows_ == 0 || count == 0)
    return;
  const std::size_t last = (first + count - 1) / chunk_rows_;
  if (checked_.size() <= last)
    checked_.resize(last + 1);
  for (std::size_t number = first / chunk_rows_; number <= last; ++number)
    if (!checked_[number]) {
      for (std::size_t column = 0; column < width_; column += chunk_width_)
        chunk(dataset, number * chunk_rows_, column);
      checked_[number] = true;
    }
}

void
ChunkCheck::chunk(const Handle& dataset, hsize_t row, hsize_t column) const
{
  const std::string what = "read " + name_ + ": it is damaged";
  const hsize_t at[2] = {row, column};
  hsize_t stored = 0;
  check(H5Dget_chunk_storage_size(dataset.id(), at, &stored), what);
  if (stored == 0)
    return; // never written: the library fills it in
  if (stored > file_bytes_)
    throw Error("cannot " + what);
  std::vector<unsigned char> bytes(stored);
  std::uint32_t left_out = 0;
  check(H5Dread_chunk(dataset.id(), H5P_DEFAULT, at, &left_out, bytes.data()), what);
  const bool deflated = deflate_ >= 0 && ((left_out >> deflate_) & 1U) == 0;
  if ((deflated ? inflatedSize(bytes) : bytes.size()) != chunk_bytes_)
    throw Error("cannot " + what);
}

} // namespace linelet::io::hdf5
