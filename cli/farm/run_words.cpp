#include "cli/farm/run_words.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "generator/base/error.h"
#include "render/export/transaction/durable_file.h"

extern char** environ;

namespace pomona {

namespace {

constexpr std::size_t longest_answer = std::size_t{64} << 20;  // bytes

[[noreturn]] void fail(const std::string& program, int error) {
  throw Error(ExitStatus::helper_missing, program + " cannot be started: " + std::strerror(error),
              error == ENOENT ? "it is not on the PATH of this machine" : "");
}

/// A file in memory for a program's output: it is never full, so nobody has to read meanwhile.
Descriptor caught(const std::string& program) {
  Descriptor file(memfd_create("pomona", MFD_CLOEXEC));
  if (!file.is_open()) fail(program, errno);
  return file;
}

std::string content_of(const Descriptor& file) {
  std::string text;
  char part[1 << 14];
  for (ssize_t n = 0; text.size() < longest_answer; text.append(part, static_cast<std::size_t>(n))) {
    n = ::pread(file.number(), part, sizeof part, static_cast<off_t>(text.size()));
    if (n <= 0) break;
  }
  return text;
}

int status_of(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

ProgramOutcome run_words(const std::vector<std::string>& words) {
  // The words as C strings.
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const Descriptor out = caught(words.front()), err = caught(words.front());

  // Standard input is empty; the outputs are caught.
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, out.number(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err.number(), STDERR_FILENO);
  pid_t child = 0;
  const int error = posix_spawnp(&child, words.front().c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) fail(words.front(), error);

  // Waits for the result.
  ProgramOutcome outcome;
  outcome.status = status_of(child);
  outcome.out = content_of(out);
  outcome.err = content_of(err);
  return outcome;
}

}  // namespace pomona
