// Checked system calls for durable writing: files and folders that are on the disk when a call returns.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "generator/base/error.h"

namespace pomona {

/// An open file. It closes itself.
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

  /// Returns false if closing fails: a full disk may be noticed only then.
  bool close();

 private:
  int number_;
};

/// Always throws an Error: "PATH: error: WHAT: No space left on device".
/// \param error an errno.
[[noreturn]] void fail_at(ExitStatus status, const std::filesystem::path& path, const std::string& what, int error);

/// Makes a new file and opens it for writing. The result is not open, with errno EEXIST, if there is a file of this
/// name. \param meant the path in messages. \param mode permissions, reduced by the process's umask. \throws Error
/// (cannot_create)
Descriptor create_file(const std::filesystem::path& path, const std::filesystem::path& meant, unsigned mode = 0666);

/// Whether the path still names the file that was opened. Another run may remove the file after it was opened and
/// before it is locked: at its own end, or because it takes it for that of a dead run.
bool is_still_there(const Descriptor& file, const std::filesystem::path& path);

/// \throws Error (io_error)
void write_all(const Descriptor& file, std::string_view bytes, const std::filesystem::path& meant);

/// Waits until the file is on the disk, and closes it. \throws Error (io_error)
void bring_to_disk(Descriptor& file, const std::filesystem::path& meant);

/// Brings the names in a folder to the disk. Not every folder can be synced; that is not reported as an error.
void sync_folder(const std::filesystem::path& folder);

/// \throws Error (cannot_create)
void move_into_place(const std::filesystem::path& temporary, const std::filesystem::path& destination);

}  // namespace pomona
