// The calls by which files come down to the disk, each checked: what write_whole() and batches are made of.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "generator/base/error.h"

namespace pomona {

/// A file under way: a descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  ~Descriptor();
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor& operator=(Descriptor&& other) noexcept;

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }

  /// Closing may be the first to tell of a full disk.
  bool close();

 private:
  int number_;
};

/// Throws, always: "PATH: error: WHAT: No space left on device".
/// \param error an errno.
[[noreturn]] void fail_at(ExitStatus status, const std::filesystem::path& path, const std::string& what, int error);

/// A new file, open for writing; not open, with errno EEXIST, if there is one of this name.
/// \param meant what messages call it. \param mode permissions, less the process's mask.
/// \throws Error (cannot_create)
Descriptor create_file(const std::filesystem::path& path, const std::filesystem::path& meant, unsigned mode = 0666);

/// Whether the name still leads to the file that was opened: another run may have removed it between its opening and
/// its locking, having finished, or having taken it for a dead run's.
bool is_still_there(const Descriptor& file, const std::filesystem::path& path);

/// \throws Error (io_error)
void write_all(const Descriptor& file, std::string_view bytes, const std::filesystem::path& meant);

/// Waits until the disk has it all, and closes. \throws Error (io_error)
void bring_to_disk(Descriptor& file, const std::filesystem::path& meant);

/// The folder's entries must reach the disk, too; a folder that cannot be synced is none of the user's errors.
void sync_folder(const std::filesystem::path& folder);

/// \throws Error (cannot_create)
void move_into_place(const std::filesystem::path& temporary, const std::filesystem::path& destination);

}  // namespace pomona
