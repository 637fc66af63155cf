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

/// Everything temporary lies in FOLDER/.pomona: a lock for the folder, which shards share and other runs have alone; a
/// lock for each shard; and a folder of each shard, in which its items are made. Locks are the kernel's (flock): they
/// end with the process that holds them. What a killed run has left there is removed by the next run of the same shard,
/// and by a run that has the folder alone; but for items set aside, which stay until the batch is whole.
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

  /// Sets a finished item aside, for whoever is to be made by the same recipe. One that is aside already stays.
  void set_aside(const std::string& item, const std::string& recipe);

  bool has_aside() const;

  /// Where the item of this recipe lies aside, if one does.
  std::optional<std::filesystem::path> aside(const std::string& recipe) const;

  /// Puts the item that is aside into its new place, with this record. Returns false if another thread was faster.
  bool put_aside_item(const std::string& recipe, const std::string& item, const NamedFile& record);

  /// Removes an item, whole or not at all, and the folders that it leaves empty.
  void remove_item(const std::string& item);

  /// Removes what nobody has asked for.
  void remove_aside();

  /// Removes a file of the folder, if it is there.
  void remove_file(const std::string& name);

  /// Writes the file `name` of the folder as `write` asks for it, piece by piece; whole or not at all.
  using Writer = std::function<void(std::string_view)>;
  void put_file(const std::string& name, const std::function<void(const Writer&)>& write);

 private:
  std::filesystem::path new_place();
  void make_folders(const std::string& item);
  void remove_empty_folders(const std::string& item);
  void put_file_of(const std::string& item, const std::filesystem::path& made, const NamedFile& file);
  void put_in_place(const std::filesystem::path& made, const std::string& item);

  std::filesystem::path folder_, hidden_, staging_, aside_;
  std::string lock_name_;
  std::optional<Descriptor> whole_, own_;
  std::atomic<std::uint64_t> next_ = 0;
};

}  // namespace pomona
