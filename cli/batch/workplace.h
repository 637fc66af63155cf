// A batch's folder while runs work on it: locks, and a temporary folder for incomplete items.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "render/export/pov.h"
#include "render/export/transaction/durable_file.h"

namespace pomona {

/// The share of a batch that a run makes: part `number` of `count`, from 1.
struct Shard {
  int number = 1, count = 1;
};

/// All temporary files lie in FOLDER/.pomona: a lock of the folder, which shards share and other runs hold alone; a
/// lock of each shard; and a folder of each shard for its incomplete items. Locks are the kernel's (flock): they end
/// with their process. The next run of the same shard, and a run that holds the folder alone, remove what a killed run
/// has left.
class Workplace {
 public:
  /// Makes the folder if it is missing. \throws Error (locked) if another run makes the same items, (cannot_create) if
  /// the folder cannot be made.
  Workplace(std::filesystem::path folder, const Shard& shard);
  ~Workplace();
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

  /// Makes the folder `item` with these files, replaces an existing one, all or nothing. From any thread.
  /// \throws Error (cannot_create, io_error)
  void put_item(const std::string& item, std::span<const NamedFile> files);

  /// Writes the file `name` of the folder, all or nothing, from the parts that `write` passes on.
  using Writer = std::function<void(std::string_view)>;
  void put_file(const std::string& name, const std::function<void(const Writer&)>& write);

 private:
  std::filesystem::path new_place();
  void make_folders(const std::string& item);

  std::filesystem::path folder_, hidden_, staging_;
  std::string lock_name_;
  std::optional<Descriptor> whole_, own_;
  std::atomic<std::uint64_t> next_ = 0;
};

}  // namespace pomona
