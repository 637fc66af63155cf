#include "bench/own_process.h"

#include <stdexcept>

#include <sys/wait.h>
#include <unistd.h>

#include "bench/exit_status.h"

namespace pomona::bench {

namespace {

/// Sends what `work` returns, and ends the process.
[[noreturn]] void work_and_leave(const std::function<std::string()>& work, int end) {
  const int status = exit_status_of([&] {
    const std::string text = work();
    std::size_t sent = 0;
    while (sent < text.size()) {
      const ssize_t written = write(end, text.data() + sent, text.size() - sent);
      if (written < 0) return 1;
      sent += static_cast<std::size_t>(written);
    }
    return 0;
  });
  _exit(status);
}

std::string all_from(int end) {
  std::string text;
  char buffer[4096];
  for (ssize_t got; (got = read(end, buffer, sizeof buffer)) > 0;) text.append(buffer, static_cast<std::size_t>(got));
  return text;
}

}  // namespace

std::string in_own_process(const std::function<std::string()>& work) {
  // The other process, at the writing end of a pipe.
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    close(ends[0]);
    work_and_leave(work, ends[1]);
  }

  // Read all that it writes until it ends.
  close(ends[1]);
  std::string text = all_from(ends[0]);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (status != 0) throw std::runtime_error("the process that measures failed");
  return text;
}

}  // namespace pomona::bench
