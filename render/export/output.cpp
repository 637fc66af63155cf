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
#include "render/export/durable_file.h"
#include "render/export/set_folder.h"

namespace pomona {
namespace {

namespace fs = std::filesystem;

/// What a path leads to, links followed, so that what a link names is replaced and not the link, even if it names
/// nothing yet.
fs::path followed(const fs::path& path) {
  constexpr int most_links = 40;  // as many as Linux follows
  fs::path found = path;
  std::error_code failed;
  for (int n = 0; fs::is_symlink(found, failed); ++n) {
    if (n == most_links) fail_at(ExitStatus::cannot_create, path, "cannot be created", ELOOP);
    const fs::path names = fs::read_symlink(found, failed);
    if (failed) fail_at(ExitStatus::cannot_create, path, "cannot be created", failed.value());
    found = names.is_absolute() ? names : found.parent_path() / names;
  }
  return found;
}

/// Files on their way into place, folder by folder. What is not put into place goes away with this.
class FileSet {
 public:
  void add(const OutputFile& file) {
    const fs::path destination = followed(file.path);
    const fs::path folder = destination.has_parent_path() ? destination.parent_path() : fs::path(".");
    SetFolder& own = folder_for(folder, file.path);
    const std::string name = destination.filename().native();
    if (own.has(name)) {
      throw Error(ExitStatus::usage, {{{file.path.string(), 0, 0, {}},
                                       "two files of this run would be this one",
                                       "give one of them a name or a folder of its own"}});
    }
    own.add(name, file.bytes, file.rest.get());
    ++size_;
  }

  void put_into_place() {
    // A renaming is all or nothing by itself; several need a record, by which a later run finishes what a kill cuts
    // off.
    const bool recorded = size_ > 1;
    if (recorded) record();
    try {
      for (SetFolder& folder : folders_) folder.put_into_place();
    } catch (const Error&) {
      for (SetFolder& folder : folders_) folder.undo(recorded);
      throw;
    }
    // The first folder leads: it goes last.
    while (!folders_.empty()) {
      folders_.back().settle();
      folders_.pop_back();
    }
  }

 private:
  SetFolder& folder_for(const fs::path& folder, const fs::path& meant) {
    for (SetFolder& known : folders_) {
      std::error_code failed;
      if (fs::equivalent(known.folder(), folder, failed)) return known;
    }
    return folders_.emplace_back(folder, meant);
  }

  void record() {
    for (SetFolder& folder : folders_) folder.keep_old();
    const fs::path leader = fs::absolute(folders_.front().record_path());
    std::vector<fs::path> followers;
    for (std::size_t i = 1; i < folders_.size(); ++i) {
      folders_[i].write_record(leader, {});
      followers.push_back(fs::absolute(folders_[i].record_path()));
    }
    folders_.front().write_record({}, followers);
  }

  std::vector<SetFolder> folders_;
  std::size_t size_ = 0;
};

/// While this lives, a reader that leaves its pipe is an error like others and no end without a word.
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

/// Refuses what no file can be put in place of, before anything is written.
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

/// Programs write there for those who read on.
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
  FileSet set;
  std::vector<const OutputFile*> for_devices;
  for (const OutputFile& file : files) {
    if (is_standard_output(file) || checked(file.path) == Destination::device)
      for_devices.push_back(&file);
    else
      set.add(file);
  }
  for (const OutputFile* file : for_devices) write_to_device(*file);
  set.put_into_place();
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
