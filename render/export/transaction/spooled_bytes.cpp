#include "render/export/transaction/spooled_bytes.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

namespace pomona {

namespace {

namespace fs = std::filesystem;

/// A file without a name. Where the file system does not support this, the file has a name for a moment.
Descriptor nameless_file(const fs::path& folder) {
  Descriptor file(::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600));
  if (file.is_open()) return file;
  std::string name = (folder / ".pomona-spool-XXXXXX").string();
  Descriptor named(::mkostemp(name.data(), O_CLOEXEC));
  if (named.is_open()) ::unlink(name.c_str());
  return named;
}

Descriptor nameless_file_for(const fs::path& meant) {
  const fs::path folder = meant.has_parent_path() ? meant.parent_path() : fs::path(".");
  Descriptor file = nameless_file(folder);
  const int why = errno;
  std::error_code failed;
  if (!file.is_open()) file = nameless_file(fs::temp_directory_path(failed));
  if (!file.is_open()) fail_at(ExitStatus::cannot_create, meant, "cannot be created", why);
  return file;
}

}  // namespace

SpooledBytes::SpooledBytes(fs::path meant) : meant_(std::move(meant)), file_(nameless_file_for(meant_)) {}

void SpooledBytes::append(std::string_view bytes) {
  write_all(file_, bytes, meant_);
  size_ += bytes.size();
}

void SpooledBytes::copy_to(const Descriptor& file) const {
  std::string block(std::min(size_, std::size_t{1} << 20), '\0');
  for (std::size_t done = 0; done < size_;) {
    const ssize_t count = ::pread(file_.number(), block.data(), block.size(), static_cast<off_t>(done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail_at(ExitStatus::io_error, meant_, "cannot be read back", count < 0 ? errno : EIO);
    write_all(file, std::string_view(block).substr(0, static_cast<std::size_t>(count)), meant_);
    done += static_cast<std::size_t>(count);
  }
}

}  // namespace pomona
