// Errors that a user can act on: a place, a message, and a hint.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace pomona {

/// The exit status of the process (docs/reference/commands.md lists them; the numbers are those of sysexits.h).
enum class ExitStatus : int {
  done = 0,
  some_items_failed = 1,
  usage = 64,
  bad_data = 65,
  input_missing = 66,
  helper_missing = 69,
  bug = 70,
  out_of_memory = 71,
  cannot_create = 73,
  io_error = 74,
  locked = 75,
};

/// A place in an input: line and column of a text file (from 1), or, in a binary file, the element and
/// the byte offset, spelt out in `element` ("vertex 12, byte 345"). Line 0 means the file as a whole.
struct SourcePlace {
  std::string file;
  int line = 0;
  int column = 0;
  std::string element;
};

/// One thing that is wrong, with a hint where one helps.
struct Diagnostic {
  SourcePlace place;
  std::string message;
  std::string hint;
};

/// "templates/x.toml:12:9: error: surface "skin": ...", and the hint on a second line.
std::string to_string(const Diagnostic& diagnostic);

/// Thrown for everything a user can cause. All diagnostics of one input travel together.
class Error : public std::runtime_error {
 public:
  Error(ExitStatus status, std::vector<Diagnostic> diagnostics);
  Error(ExitStatus status, std::string message, std::string hint = {});

  ExitStatus status() const { return status_; }
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  ExitStatus status_;
  std::vector<Diagnostic> diagnostics_;
};

/// The same error with this file as its place, where a diagnostic names no file. For faults that are found long after
/// the file was read.
Error told_of(const Error& error, const std::string& file);

}  // namespace pomona
