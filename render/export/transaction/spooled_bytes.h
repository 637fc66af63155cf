// A spool: bytes of a future file that wait on the disk, so that they need no memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "render/export/transaction/durable_file.h"

namespace pomona {

/// The bytes are in a file without a name. Whatever ends the program, nothing remains of it.
class SpooledBytes {
 public:
  /// \param meant the file of which they become a part. They wait in its folder, which needs room for it in any case;
  /// if that is not possible, in the folder for temporary files. \throws Error (cannot_create)
  explicit SpooledBytes(std::filesystem::path meant);

  /// \throws Error (io_error)
  void append(std::string_view bytes);

  std::size_t size() const { return size_; }

  /// Copies all bytes to a file. \throws Error (io_error)
  void copy_to(const Descriptor& file) const;

 private:
  std::filesystem::path meant_;
  Descriptor file_;
  std::size_t size_ = 0;
};

}  // namespace pomona
