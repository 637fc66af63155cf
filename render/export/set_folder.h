// One folder's share of files that come into place together, and what to do with the shares of runs that are dead.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "render/export/durable_file.h"
#include "render/export/set_record.h"
#include "render/export/spooled_bytes.h"

namespace pomona {

/// Files wait in the folder where they are to be, under hidden names that start as the record's does. The record is
/// locked as long as the run lives: a record that can be locked is one that a dead run has left.
class SetFolder {
 public:
  /// Finishes or undoes what dead runs have left in the folder; then takes a name that nobody else has there.
  /// \throws Error (cannot_create), which calls it `meant`.
  SetFolder(std::filesystem::path folder, const std::filesystem::path& meant);
  SetFolder(SetFolder&&) = default;
  SetFolder& operator=(SetFolder&&) = delete;

  /// Undoes everything that is not settled.
  ~SetFolder();

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path record_path() const { return folder_ / (stem_ + ".set"); }
  std::size_t size() const { return record_.members.size(); }
  /// Whether a file of this name has been added.
  bool has(const std::string& name) const;

  /// Writes these bytes, and the rest if there is one, beside the destination `name`, down to the disk, with the
  /// permissions of what is there. \throws Error (cannot_create, io_error)
  void add(const std::string& name, std::string_view bytes, const SpooledBytes* rest = nullptr);

  /// Keeps what the files replace, each under a second name. \throws Error (cannot_create)
  void keep_old();

  /// Writes the record down to the disk. \throws Error (io_error)
  void write_record(const std::filesystem::path& leader, const std::vector<std::filesystem::path>& followers);

  /// Renames the files. \throws Error (cannot_create) if one cannot be; the earlier ones stay until undo().
  void put_into_place();

  /// Gives back what was there; where that fails, a later run tries again.
  /// \param recorded whether other runs may know the set as decided.
  void undo(bool recorded);

  /// Nothing is left to do: removes what was kept, and the record.
  void settle();

 private:
  std::filesystem::path folder_;
  std::string stem_;
  SetRecord record_;
  Descriptor file_{-1};  ///< the record's, locked
};

}  // namespace pomona
