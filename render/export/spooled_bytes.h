// Bytes of a file under way that wait on the disk, so that memory need not hold them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "render/export/durable_file.h"

namespace pomona {

/// They lie in a file without a name: whatever ends the program, nothing is left of it.
class SpooledBytes {
 public:
  /// \param meant the file that they are to become part of: they wait in its folder, where there must be room for it
  /// anyway, or where that cannot be in the folder for temporary files. \throws Error (cannot_create)
  explicit SpooledBytes(std::filesystem::path meant);

  /// \throws Error (io_error)
  void append(std::string_view bytes);

  std::size_t size() const { return size_; }

  /// All of them, from the first on. \throws Error (io_error)
  void copy_to(const Descriptor& file) const;

 private:
  std::filesystem::path meant_;
  Descriptor file_;
  std::size_t size_ = 0;
};

}  // namespace pomona
