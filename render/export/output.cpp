#include "render/export/output.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>
#include <vector>

#include "generator/base/error.h"
#include "render/export/transaction/durable_file.h"
#include "render/export/transaction/transaction.h"

namespace pomona {
namespace {

namespace fs = std::filesystem;

/// The path with links followed, because the file that a link names is replaced, not the link. The file need not exist.
fs::path followed(const fs::path& path) {
  constexpr int max_links = 40;  // as many as Linux follows
  fs::path found = path;
  std::error_code failed;
  for (int n = 0; fs::is_symlink(found, failed); ++n) {
    if (n == max_links) fail_at(ExitStatus::cannot_create, path, "cannot be created", ELOOP);
    const fs::path names = fs::read_symlink(found, failed);
    if (failed) fail_at(ExitStatus::cannot_create, path, "cannot be created", failed.value());
    found = names.is_absolute() ? names : found.parent_path() / names;
  }
  return found;
}

/// While this object exists, a reader that closes its pipe causes an error with a message; SIGPIPE would end the
/// program without one.
class WithoutPipeSignal {
 public:
  WithoutPipeSignal() {
    struct sigaction ignored {};
    ignored.sa_handler = SIG_IGN;
    ::sigaction(SIGPIPE, &ignored, &before_);
  }
  ~WithoutPipeSignal() { ::sigaction(SIGPIPE, &before_, nullptr); }
  WithoutPipeSignal(const WithoutPipeSignal&) = delete;
  WithoutPipeSignal& operator=(const WithoutPipeSignal&) = delete;

 private:
  struct sigaction before_ {};
};

enum class Destination { ordinary, device };

/// The kind of a destination. Throws if no file can be written there, before anything is written.
Destination checked(const fs::path& path) {
  struct stat about {};
  if (path.filename().empty()) fail_at(ExitStatus::cannot_create, path, "cannot be created", EISDIR);
  if (::stat(path.c_str(), &about) != 0) {
    if (errno == ELOOP || errno == ENAMETOOLONG) fail_at(ExitStatus::cannot_create, path, "cannot be created", errno);
    return Destination::ordinary;
  }
  if (S_ISDIR(about.st_mode)) fail_at(ExitStatus::cannot_create, path, "cannot be created", EISDIR);
  return S_ISREG(about.st_mode) ? Destination::ordinary : Destination::device;
}

/// The path "-" means standard output.
bool is_standard_output(const OutputFile& file) { return file.path == "-"; }

void write_all_of(const OutputFile& file, const Descriptor& descriptor, const fs::path& meant) {
  write_all(descriptor, file.bytes, meant);
  if (file.rest) file.rest->copy_to(descriptor);
}

void write_to_device(const OutputFile& file) {
  if (is_standard_output(file)) {
    const Descriptor descriptor(::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0));
    if (!descriptor.is_open()) fail_at(ExitStatus::io_error, "standard output", "cannot be written", errno);
    return write_all_of(file, descriptor, "standard output");
  }
  Descriptor descriptor(::open(file.path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!descriptor.is_open()) fail_at(ExitStatus::cannot_create, file.path, "cannot be opened", errno);
  write_all_of(file, descriptor, file.path);
  if (!descriptor.close()) fail_at(ExitStatus::io_error, file.path, "cannot be written", errno);
}

}  // namespace

std::size_t size_of(const OutputFile& file) { return file.bytes.size() + (file.rest ? file.rest->size() : 0); }

void write_whole(std::span<const OutputFile> files) {
  const WithoutPipeSignal no_signal;
  Transaction transaction;
  std::vector<const OutputFile*> for_devices;
  for (const OutputFile& file : files) {
    if (is_standard_output(file) || checked(file.path) == Destination::device)
      for_devices.push_back(&file);
    else
      transaction.add(followed(file.path), file.path, file.bytes, file.rest.get());
  }
  for (const OutputFile* file : for_devices) write_to_device(*file);
  transaction.commit();
}

bool is_same_file(const fs::path& a, const fs::path& b) {
  const fs::path first = followed(a), second = followed(b);
  const auto folder_of = [](const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
  };
  std::error_code failed;
  return first.filename() == second.filename() && fs::equivalent(folder_of(first), folder_of(second), failed);
}

void write_whole(const fs::path& path, std::string bytes) {
  const OutputFile file{path, std::move(bytes)};
  write_whole(std::span(&file, 1));
}

}  // namespace pomona
