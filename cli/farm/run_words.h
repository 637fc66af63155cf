// Starts another program by its words, never through a shell.
#pragma once

#include <string>
#include <vector>

namespace pomona {

struct ProgramOutcome {
  int status = 0;  ///< as in a shell: 128 and the signal's number if it was killed
  std::string out, err;
};

/// Finds the first word on the PATH, starts it with the others, and waits. It reads nothing.
/// \throws Error (helper_missing) if there is no such program.
ProgramOutcome run_words(const std::vector<std::string>& words);

}  // namespace pomona
