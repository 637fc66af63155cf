#include "render/export/output.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <utility>
#include <vector>

#include "generator/base/error.h"
#include "render/export/durable_file.h"

namespace pomona {
namespace {

namespace fs = std::filesystem;

/// Files written beside their destinations, and what is still to do with them. What is not put into place
/// goes away with this.
class Staging {
 public:
  Staging() = default;
  ~Staging() {
    for (const Staged& file : staged_) ::unlink(file.temporary.c_str());
  }
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;

  void add(const OutputFile& file);
  void put_into_place();

 private:
  struct Staged {
    fs::path temporary, destination;
  };
  std::vector<Staged> staged_;
};

void Staging::add(const OutputFile& file) {
  // Follow a link, so that what it names is replaced and not the link.
  std::error_code ignored;
  const bool is_link = fs::is_symlink(file.path, ignored);
  const fs::path destination = is_link ? fs::weakly_canonical(file.path) : file.path;

  // Take a name that nobody else has, not even another machine that shares the folder.
  for (int n = 0;; ++n) {
    const std::string name = ".pomona-" + std::to_string(::getpid()) + "-" + std::to_string(n) + ".part";
    const fs::path temporary = destination.parent_path() / name;
    Descriptor descriptor = create_file(temporary, file.path);
    if (!descriptor.is_open()) continue;
    staged_.push_back({temporary, destination});
    write_all(descriptor, file.bytes, file.path);
    return bring_to_disk(descriptor, file.path);
  }
}

void Staging::put_into_place() {
  while (!staged_.empty()) {
    const auto [temporary, destination] = staged_.front();
    move_into_place(temporary, destination);
    staged_.erase(staged_.begin());
    sync_folder(destination.has_parent_path() ? destination.parent_path() : fs::path("."));
  }
}

enum class Destination { ordinary, device };

/// Refuses what no file can be put in place of, before anything is written.
Destination checked(const fs::path& path) {
  struct stat about {};
  if (path.filename().empty()) fail_at(ExitStatus::cannot_create, path, "cannot be created", EISDIR);
  if (::stat(path.c_str(), &about) != 0) return Destination::ordinary;
  if (S_ISDIR(about.st_mode)) fail_at(ExitStatus::cannot_create, path, "cannot be created", EISDIR);
  return S_ISREG(about.st_mode) ? Destination::ordinary : Destination::device;
}

void write_to_device(const OutputFile& file) {
  Descriptor descriptor(::open(file.path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!descriptor.is_open()) fail_at(ExitStatus::cannot_create, file.path, "cannot be opened", errno);
  write_all(descriptor, file.bytes, file.path);
  if (!descriptor.close()) fail_at(ExitStatus::io_error, file.path, "cannot be written", errno);
}

}  // namespace

void write_whole(std::span<const OutputFile> files) {
  Staging staging;
  std::vector<const OutputFile*> for_devices;
  for (const OutputFile& file : files) {
    if (checked(file.path) == Destination::device)
      for_devices.push_back(&file);
    else
      staging.add(file);
  }
  for (const OutputFile* file : for_devices) write_to_device(*file);
  staging.put_into_place();
}

void write_whole(const fs::path& path, std::string bytes) {
  const OutputFile file{path, std::move(bytes)};
  write_whole(std::span(&file, 1));
}

}  // namespace pomona
