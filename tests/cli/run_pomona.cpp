#include "tests/cli/run_pomona.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace fs = std::filesystem;

namespace pomona::testing {

namespace {

/// For /bin/sh: wrapped in single quotes.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace

Outcome run_pomona(const std::vector<std::string>& words, const fs::path& folder) {
  const TemporaryFolder caught;
  std::string line = "cd " + quoted(folder.string()) + " && " + quoted(POMONA_PROGRAM);
  for (const std::string& word : words) line += " " + quoted(word);
  line += " > " + quoted(caught / "out") + " 2> " + quoted(caught / "err") + " < /dev/null";
  const int result = std::system(line.c_str());

  Outcome outcome;
  outcome.status = WIFEXITED(result) ? WEXITSTATUS(result) : 128 + WTERMSIG(result);
  outcome.out = bytes_of(caught / "out");
  outcome.err = bytes_of(caught / "err");
  return outcome;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace pomona::testing
