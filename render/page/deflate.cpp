#include "render/page/deflate.h"

#include <algorithm>

#include <zlib.h>

#include "generator/base/error.h"

namespace pomona {

namespace {

/// The number of bytes unpacked at a time, so that memory grows with the content, not with what the file claims.
constexpr std::size_t chunk = std::size_t{1} << 20;

Bytef* bytes_of(std::string_view text) {
  // zlib takes a non-const pointer, but only reads.
  return const_cast<Bytef*>(reinterpret_cast<const Bytef*>(text.data()));
}

}  // namespace

std::string deflated(std::string_view bytes, int effort) {
  z_stream stream{};
  // Differences are small numbers without much order: short blocks with their own codes, and few matches, pack them
  // best.
  if (deflateInit2(&stream, effort, Z_DEFLATED, 15, 7, Z_FILTERED) != Z_OK)
    throw Error(ExitStatus::bug, "zlib does not start");
  std::string packed(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  stream.next_in = bytes_of(bytes);
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const int result = deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  if (result != Z_STREAM_END) throw Error(ExitStatus::bug, "zlib does not finish");
  return packed;
}

std::optional<std::string> inflated(std::string_view packed, std::size_t max) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) throw Error(ExitStatus::bug, "zlib does not start");
  stream.next_in = bytes_of(packed);
  stream.avail_in = static_cast<uInt>(packed.size());
  std::string bytes;
  int result = Z_OK;
  while (result == Z_OK && bytes.size() <= max) {
    const std::size_t before = bytes.size();
    bytes.resize(before + chunk);
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data() + before);
    stream.avail_out = static_cast<uInt>(chunk);
    result = inflate(&stream, Z_NO_FLUSH);
    bytes.resize(before + chunk - stream.avail_out);
    // A stream that stops halfway gives no more output.
    if (result == Z_OK && bytes.size() == before) break;
  }
  const bool whole = result == Z_STREAM_END && stream.avail_in == 0 && bytes.size() <= max;
  inflateEnd(&stream);
  if (!whole) return std::nullopt;
  return bytes;
}

}  // namespace pomona
