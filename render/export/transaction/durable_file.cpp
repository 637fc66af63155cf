#include "render/export/transaction/durable_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace pomona {

namespace fs = std::filesystem;

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

bool Descriptor::close() { return ::close(std::exchange(number_, -1)) == 0; }

void fail_at(ExitStatus status, const fs::path& path, const std::string& what, int error) {
  const std::string why = std::error_code(error, std::generic_category()).message();
  SourcePlace place;
  place.file = path.string();
  throw Error(status, {Diagnostic{place, what + ": " + why, {}}});
}

Descriptor create_file(const fs::path& path, const fs::path& meant, unsigned mode) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, static_cast<mode_t>(mode)));
  if (!file.is_open() && errno != EEXIST) fail_at(ExitStatus::cannot_create, meant, "cannot be created", errno);
  return file;
}

bool is_still_there(const Descriptor& file, const fs::path& path) {
  struct stat opened {
  }, named{};
  if (::fstat(file.number(), &opened) != 0 || ::stat(path.c_str(), &named) != 0) return false;
  return opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

void write_all(const Descriptor& file, std::string_view bytes, const fs::path& meant) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = ::write(file.number(), bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0)
      fail_at(ExitStatus::io_error, meant, "cannot write its " + std::to_string(bytes.size()) + " bytes", errno);
    done += static_cast<std::size_t>(count);
  }
}

void bring_to_disk(Descriptor& file, const fs::path& meant) {
  if (::fsync(file.number()) != 0 || !file.close()) fail_at(ExitStatus::io_error, meant, "cannot be written", errno);
}

void sync_folder(const fs::path& folder) {
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.is_open()) ::fsync(opened.number());
}

void move_into_place(const fs::path& temporary, const fs::path& destination) {
  if (::rename(temporary.c_str(), destination.c_str()) != 0)
    fail_at(ExitStatus::cannot_create, destination, "cannot be put into place", errno);
}

}  // namespace pomona
