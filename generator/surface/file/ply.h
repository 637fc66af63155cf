// PLY as a format [Turk 1994]: its header, and its values one after another. surface_file.h gives them their meaning.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "generator/surface/file/ply_header.h"

namespace pomona {

std::size_t size_of(PlyType type);

/// Reads the values of a PLY file one after another.
class PlyReader {
 public:
  /// Reads the header and checks its counts against the bytes that follow.
  /// \throws Error (bad_data) with line and column.
  PlyReader(std::string_view bytes, const std::string& file);

  const PlyHeader& header() const { return header_; }

  /// Sets the item whose values come next, for messages.
  void start_item(const PlyElement& element, std::uint64_t index);

  /// The next value, exact. \throws Error where the file ends early or has no number.
  double value(PlyType type);

  /// The length of the next list; at most what the remaining bytes can hold.
  std::uint64_t list_length(const PlyProperty& list);

  void skip(const PlyProperty& property);

  /// The number of bytes that are not read yet, without blanks and zeros at the end.
  std::size_t bytes_left() const;

  /// Fails at the value read last: "vertex 12, byte 345" in binary files, line and column in ascii.
  [[noreturn]] void fail(const std::string& message, const std::string& hint = {}) const;

  /// Fails for the file as a whole.
  [[noreturn]] void fail_whole(const std::string& message, const std::string& hint = {}) const;

  /// Fails at a byte of the header.
  [[noreturn]] void fail_at(std::size_t byte, const std::string& message, const std::string& hint = {}) const;

 private:
  void check_counts() const;
  double binary_value(PlyType type);
  double ascii_value();

  std::string_view bytes_;
  std::string file_;
  PlyHeader header_;
  std::size_t next_ = 0;
  std::size_t last_ = 0;  ///< where the value read last starts
  const PlyElement* element_ = nullptr;
  std::uint64_t index_ = 0;
};

}  // namespace pomona
