#include "cli/studio/only_studio.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <string>
#include <system_error>

#include "generator/base/error.h"
#include "generator/base/sha256.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

/// The same name for all paths to a file, another one for every user.
std::string name_of(const fs::path& toml) {
  std::error_code failed;
  fs::path whole = fs::weakly_canonical(fs::absolute(toml), failed);
  if (failed) whole = fs::absolute(toml).lexically_normal();
  return "pomona-studio-" + std::to_string(::geteuid()) + "-" + sha256(whole.native()).substr(0, 32);
}

}  // namespace

OnlyStudio::OnlyStudio(const fs::path& toml) : socket_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  // On Linux a socket's name that begins with a zero byte is abstract: it has no file [unix(7)].
  const std::string name = name_of(toml);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::copy(name.begin(), name.end(), address.sun_path + 1);
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  if (!socket_.is_open()) return;  // without abstract sockets there is no lock
  if (::bind(socket_.number(), reinterpret_cast<const sockaddr*>(&address), size) == 0 || errno != EADDRINUSE) return;
  throw Error(ExitStatus::locked, {{{toml.string(), 0, 0, {}},
                                    "is open in another studio",
                                    "go on in its window, or end it with Ctrl-C: edits that are not saved are kept"}});
}

}  // namespace pomona
