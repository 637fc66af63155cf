#include "cli/deliver/watch.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>
#include <thread>
#include <utility>

#include "cli/command.h"
#include "cli/options/files_behind.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

constexpr std::chrono::milliseconds between_looks{200};

/// Time of writing and size of a file; missing files are left out.
using FileState = std::pair<fs::file_time_type, std::uintmax_t>;

std::map<fs::path, FileState> states_of(const std::set<fs::path>& files) {
  std::map<fs::path, FileState> states;
  for (const fs::path& file : files) {
    std::error_code wrong;
    const fs::file_time_type time = fs::last_write_time(file, wrong);
    const std::uintmax_t size = wrong ? 0 : fs::file_size(file, wrong);
    if (!wrong) states[file] = {time, size};
  }
  return states;
}

}  // namespace

ExitStatus made_or_watched(const Telling& telling, std::vector<std::string> written,
                           const std::vector<std::string>& words, const std::function<ExitStatus()>& make) {
  written.push_back(telling.stats);
  check_not_read(written, words);
  if (!telling.watch) return make();
  if (std::find(written.begin(), written.end(), "-") != written.end())
    throw Error(ExitStatus::usage, "--watch: standard output cannot be made anew", "-o FILE");

  std::set<fs::path> files = files_behind(words);
  for (;;) {
    // Take the states before reading, so that changes during the work are found.
    std::map<fs::path, FileState> before = states_of(files);
    run_action(make);
    if (!telling.quiet) std::fprintf(stderr, "watching %zu files; Ctrl-C ends it\n", files.size());
    while (states_of(files) == before) std::this_thread::sleep_for(between_looks);
    // An editor may write in several steps: wait for the last.
    for (std::map<fs::path, FileState> now = states_of(files); now != before; now = states_of(files)) {
      before = std::move(now);
      std::this_thread::sleep_for(between_looks);
    }
    // Keep watching files that an input names no longer: it may name them again.
    files.merge(files_behind(words));
  }
}

}  // namespace pomona
