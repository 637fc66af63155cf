#include "cli/batch/workplace.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>
#include <utility>

namespace fs = std::filesystem;

namespace pomona {

namespace {

[[noreturn]] void refuse_busy(const fs::path& folder) {
  throw Error(ExitStatus::locked, {{{folder.string(), 0, 0, {}},
                                    "another run is at work on it",
                                    "wait for it, or give every run a --shard of its own"}});
}

void make_folder(const fs::path& path) {
  if (::mkdir(path.c_str(), 0777) == 0) return sync_folder(path.has_parent_path() ? path.parent_path() : ".");
  const int error = errno;
  std::error_code ignored;
  if (error != EEXIST || !fs::is_directory(path, ignored))
    fail_at(ExitStatus::cannot_create, path, "cannot be created", error == EEXIST ? ENOTDIR : error);
}

/// Makes the lock file if it is missing, and locks it. \param kind LOCK_SH or LOCK_EX.
/// \throws Error (locked) if another run holds it longer than the moment in which `pomona farm status` tests it.
Descriptor locked(const fs::path& path, const fs::path& folder, int kind) {
  constexpr auto moment = std::chrono::milliseconds(20);
  for (int times_busy = 0;;) {
    make_folder(path.parent_path());
    Descriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
    if (!file.is_open() && errno == ENOENT) continue;  // its folder has just been removed
    if (!file.is_open()) fail_at(ExitStatus::cannot_create, path, "cannot be created", errno);
    if (::flock(file.number(), kind | LOCK_NB) != 0) {
      if (errno != EWOULDBLOCK && errno != EINTR) fail_at(ExitStatus::io_error, path, "cannot be locked", errno);
      if (errno == EINTR) continue;
      if (++times_busy > 5) refuse_busy(folder);
      std::this_thread::sleep_for(moment);
    } else if (is_still_there(file, path)) {
      return file;
    }
  }
}

/// The path without a slash at its end.
fs::path without_slash(fs::path folder) { return folder.has_filename() ? folder : folder.parent_path(); }

}  // namespace

Workplace::Workplace(fs::path folder, const Shard& shard)
    : folder_(without_slash(std::move(folder))), hidden_(folder_ / ".pomona"), aside_(hidden_ / "aside") {
  const std::string part = std::to_string(shard.number) + "-of-" + std::to_string(shard.count);
  lock_name_ = part + ".lock";
  staging_ = hidden_ / part;
  make_folder(folder_);

  // Shards share the folder; a whole batch and a merge have it alone.
  whole_.emplace(locked(hidden_ / "lock", folder_, shard.count > 1 ? LOCK_SH : LOCK_EX));
  own_.emplace(locked(hidden_ / lock_name_, folder_, LOCK_EX));

  // Remove what killed runs have left.
  std::error_code failed;
  fs::remove_all(staging_, failed);
  if (shard.count == 1) {
    for (const fs::directory_entry& entry : fs::directory_iterator(hidden_, failed))
      if (entry.is_directory(failed) && entry.path() != aside_) fs::remove_all(entry.path(), failed);
  }
  make_folder(staging_);
}

Workplace::~Workplace() {
  // The last run removes everything; a lock on a removed file is not valid (is_still_there).
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
  ::unlink((hidden_ / lock_name_).c_str());
  if (has_aside()) return;
  if (::flock(whole_->number(), LOCK_EX | LOCK_NB) == 0) fs::remove_all(hidden_, ignored);
}

fs::path Workplace::new_place() { return staging_ / std::to_string(next_++); }

void Workplace::make_folders(const std::string& item) {
  for (std::size_t slash = item.find('/'); slash != std::string::npos; slash = item.find('/', slash + 1))
    make_folder(folder_ / item.substr(0, slash));
}

void Workplace::remove_empty_folders(const std::string& item) {
  for (std::size_t slash = item.rfind('/'); slash != std::string::npos && slash > 0; slash = item.rfind('/', slash - 1))
    if (::rmdir((folder_ / item.substr(0, slash)).c_str()) != 0) return;  // another item is in it
}

void Workplace::put_file_of(const std::string& item, const fs::path& made, const NamedFile& file) {
  const fs::path meant = folder_ / item / file.name;
  Descriptor opened = create_file(made / file.name, meant);
  if (!opened.is_open()) fail_at(ExitStatus::cannot_create, meant, "cannot be created", EEXIST);
  write_all(opened, file.bytes, meant);
  bring_to_disk(opened, meant);
}

/// Moves an item into its place, which is cleared of a failed or incomplete one first.
void Workplace::put_in_place(const fs::path& made, const std::string& item) {
  const fs::path place = folder_ / item;
  sync_folder(made);
  make_folders(item);
  std::error_code failed;
  fs::remove_all(place, failed);
  move_into_place(made, place);
  sync_folder(place.parent_path());
}

void Workplace::put_item(const std::string& item, std::span<const NamedFile> files) {
  // All of it, down to the disk, where nobody looks.
  const fs::path made = new_place();
  make_folder(made);
  for (const NamedFile& file : files) put_file_of(item, made, file);
  put_in_place(made, item);
}

void Workplace::set_aside(const std::string& item, const std::string& recipe) {
  make_folder(aside_);
  if (aside(recipe)) return remove_item(item);
  move_into_place(folder_ / item, aside_ / recipe);
  sync_folder(aside_);
  remove_empty_folders(item);
}

bool Workplace::has_aside() const {
  std::error_code failed;
  return fs::exists(aside_, failed);
}

std::optional<fs::path> Workplace::aside(const std::string& recipe) const {
  std::error_code failed;
  if (recipe.empty() || !fs::is_directory(aside_ / recipe, failed)) return {};
  return aside_ / recipe;
}

bool Workplace::put_aside_item(const std::string& recipe, const std::string& item, const NamedFile& record) {
  const fs::path made = new_place();
  if (::rename((aside_ / recipe).c_str(), made.c_str()) != 0) return false;
  std::error_code failed;
  fs::remove(made / record.name, failed);
  put_file_of(item, made, record);
  put_in_place(made, item);
  return true;
}

void Workplace::remove_item(const std::string& item) {
  const fs::path gone = new_place();
  move_into_place(folder_ / item, gone);
  std::error_code ignored;
  fs::remove_all(gone, ignored);
  remove_empty_folders(item);
}

void Workplace::remove_aside() {
  if (!has_aside()) return;
  std::error_code failed;
  fs::remove_all(aside_, failed);
  if (failed) fail_at(ExitStatus::io_error, aside_, "cannot be removed", failed.value());
}

void Workplace::remove_file(const std::string& name) {
  if (::unlink((folder_ / name).c_str()) != 0 && errno != ENOENT)
    fail_at(ExitStatus::cannot_create, folder_ / name, "cannot be removed", errno);
  sync_folder(folder_);
}

void Workplace::put_file(const std::string& name, const std::function<void(const Writer&)>& write) {
  const fs::path made = new_place(), place = folder_ / name;
  Descriptor opened = create_file(made, place);
  if (!opened.is_open()) fail_at(ExitStatus::cannot_create, place, "cannot be created", EEXIST);

  // A quarter of a megabyte at a time.
  constexpr std::size_t enough = std::size_t{1} << 18;
  std::string waiting;
  write([&](std::string_view bytes) {
    waiting += bytes;
    if (waiting.size() < enough) return;
    write_all(opened, waiting, place);
    waiting.clear();
  });
  write_all(opened, waiting, place);
  bring_to_disk(opened, place);
  move_into_place(made, place);
  sync_folder(folder_);
}

}  // namespace pomona
