#include "render/export/output.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <system_error>
#include <utility>
#include <vector>

#include "generator/base/error.h"

namespace pomona {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(ExitStatus status, const fs::path& path, const std::string& what, int error) {
  const std::string why = std::error_code(error, std::generic_category()).message();
  SourcePlace place;
  place.file = path.string();
  throw Error(status, {Diagnostic{place, what + ": " + why, {}}});
}

/// A file under way: a descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }

  /// Closing may be the first to tell of a full disk.
  bool close() { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

void write_all(int descriptor, const std::string& bytes, const fs::path& path) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = ::write(descriptor, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0)
      fail(ExitStatus::io_error, path, "cannot write its " + std::to_string(bytes.size()) + " bytes", errno);
    done += static_cast<std::size_t>(count);
  }
}

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
  fs::path temporary;
  int opened = -1;
  for (int n = 0; opened < 0; ++n) {
    temporary =
        destination.parent_path() / (".pomona-" + std::to_string(::getpid()) + "-" + std::to_string(n) + ".part");
    opened = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (opened < 0 && errno != EEXIST) fail(ExitStatus::cannot_create, file.path, "cannot be created", errno);
  }
  Descriptor descriptor(opened);
  staged_.push_back({temporary, destination});
  write_all(descriptor.number(), file.bytes, file.path);
  if (::fsync(descriptor.number()) != 0 || !descriptor.close())
    fail(ExitStatus::io_error, file.path, "cannot be written", errno);
}

void Staging::put_into_place() {
  while (!staged_.empty()) {
    const auto [temporary, destination] = staged_.front();
    if (::rename(temporary.c_str(), destination.c_str()) != 0)
      fail(ExitStatus::cannot_create, destination, "cannot be put into place", errno);
    staged_.erase(staged_.begin());

    // The folder's entry must reach the disk too; a folder that cannot be synced is none of the user's errors.
    const fs::path folder = destination.has_parent_path() ? destination.parent_path() : fs::path(".");
    const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (opened.number() >= 0) ::fsync(opened.number());
  }
}

enum class Destination { ordinary, device };

/// Refuses what no file can be put in place of, before anything is written.
Destination checked(const fs::path& path) {
  struct stat about {};
  if (path.filename().empty()) fail(ExitStatus::cannot_create, path, "cannot be created", EISDIR);
  if (::stat(path.c_str(), &about) != 0) return Destination::ordinary;
  if (S_ISDIR(about.st_mode)) fail(ExitStatus::cannot_create, path, "cannot be created", EISDIR);
  return S_ISREG(about.st_mode) ? Destination::ordinary : Destination::device;
}

void write_to_device(const OutputFile& file) {
  Descriptor descriptor(::open(file.path.c_str(), O_WRONLY | O_CLOEXEC));
  if (descriptor.number() < 0) fail(ExitStatus::cannot_create, file.path, "cannot be opened", errno);
  write_all(descriptor.number(), file.bytes, file.path);
  if (!descriptor.close()) fail(ExitStatus::io_error, file.path, "cannot be written", errno);
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
