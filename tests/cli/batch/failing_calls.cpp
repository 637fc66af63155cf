// A library for LD_PRELOAD: makes the n-th call that changes a folder's files fail, or kills the process there, to test
// what a batch leaves behind.
//
//   POMONA_FAIL_FOLDER   calls on this folder, a whole path, and what lies below are counted
//   POMONA_FAIL_CALL     only these: open, mkdir, write, fsync, close, rename, link, unlink, rmdir; "any" is all
//   POMONA_FAIL_AT       the number of the call, from 1; 0 = none
//   POMONA_FAIL_WITH     "kill", or an errno: then this call and all later ones fail
//   POMONA_FAIL_ONCE     "1": only this call fails
//   POMONA_FAIL_COUNT    a file that the number of calls is written to at the end
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

struct Plan {
  std::string folder = variable("POMONA_FAIL_FOLDER"), call = variable("POMONA_FAIL_CALL"),
              with = variable("POMONA_FAIL_WITH"), count = variable("POMONA_FAIL_COUNT");
  bool once = variable("POMONA_FAIL_ONCE") == "1";
  long at = std::atol(variable("POMONA_FAIL_AT").c_str());
  std::atomic<long> calls = 0;

  ~Plan() {
    if (count.empty()) return;
    if (std::FILE* file = std::fopen(count.c_str(), "w")) {
      std::fprintf(file, "%ld\n", calls.load());
      std::fclose(file);
    }
  }
};

Plan& plan() {
  static Plan only;
  return only;
}

/// True if this call must fail; errno is the reason.
bool fails(const char* call, std::string path) {
  Plan& p = plan();
  char here[PATH_MAX];
  if (!path.empty() && path[0] != '/' && getcwd(here, sizeof here) != nullptr) path = std::string(here) + "/" + path;
  if (p.folder.empty() || path.compare(0, p.folder.size(), p.folder) != 0) return false;
  if (p.call != "any" && p.call != call) return false;
  const long number = ++p.calls;
  if (p.at == 0 || number < p.at || (p.once && number > p.at)) return false;
  if (p.with == "kill") raise(SIGKILL);
  errno = std::atoi(p.with.c_str());
  return true;
}

std::string path_of(int descriptor) {
  char path[PATH_MAX];
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  const ssize_t length = readlink(link.c_str(), path, sizeof path);
  return length > 0 ? std::string(path, static_cast<std::size_t>(length)) : std::string();
}

template <typename Function>
Function real(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

/// The path of a file given relative to a folder; only whether it lies below the counted folder matters.
std::string path_at(int folder, const char* path) {
  return path[0] == '/' || folder == AT_FDCWD ? std::string(path) : path_of(folder) + "/" + path;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list list;
  va_start(list, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? static_cast<mode_t>(va_arg(list, int)) : 0;
  va_end(list);
  if ((flags & O_CREAT) != 0 && fails("open", path)) return -1;
  return real<int (*)(const char*, int, ...)>("open")(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list list;
  va_start(list, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? static_cast<mode_t>(va_arg(list, int)) : 0;
  va_end(list);
  return open(path, flags, mode);
}

int mkdir(const char* path, mode_t mode) {
  if (fails("mkdir", path)) return -1;
  return real<int (*)(const char*, mode_t)>("mkdir")(path, mode);
}

// A full disk first writes what fits.
ssize_t write(int descriptor, const void* bytes, size_t count) {
  const auto really = real<ssize_t (*)(int, const void*, size_t)>("write");
  if (fails("write", path_of(descriptor))) {
    const int error = errno;
    const ssize_t half = really(descriptor, bytes, count / 2);
    errno = error;
    return half < 0 ? half : -1;
  }
  return really(descriptor, bytes, count);
}

int fsync(int descriptor) {
  if (fails("fsync", path_of(descriptor))) return -1;
  return real<int (*)(int)>("fsync")(descriptor);
}

int close(int descriptor) {
  const bool failed = fails("close", path_of(descriptor));
  const int error = errno;
  const int result = real<int (*)(int)>("close")(descriptor);
  errno = failed ? error : errno;
  return failed ? -1 : result;
}

int rename(const char* from, const char* to) {
  if (fails("rename", to)) return -1;
  return real<int (*)(const char*, const char*)>("rename")(from, to);
}

int link(const char* from, const char* to) {
  if (fails("link", to)) return -1;
  return real<int (*)(const char*, const char*)>("link")(from, to);
}

int unlink(const char* path) {
  if (fails("unlink", path)) return -1;
  return real<int (*)(const char*)>("unlink")(path);
}

int unlinkat(int folder, const char* path, int flags) {
  if (fails((flags & AT_REMOVEDIR) != 0 ? "rmdir" : "unlink", path_at(folder, path))) return -1;
  return real<int (*)(int, const char*, int)>("unlinkat")(folder, path, flags);
}

int rmdir(const char* path) {
  if (fails("rmdir", path)) return -1;
  return real<int (*)(const char*)>("rmdir")(path);
}

}  // extern "C"
