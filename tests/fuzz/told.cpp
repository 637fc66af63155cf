#include "tests/fuzz/told.h"

#include <cstdio>
#include <cstdlib>

#include "generator/base/error.h"

namespace pomona::fuzz {

namespace {

[[noreturn]] void blame(const char* what, const Error& error) {
  std::fprintf(stderr, "%s, status %d:\n%s\n", what, static_cast<int>(error.status()), error.what());
  std::abort();
}

/// True if the diagnostic has a place; for a missing file the file itself is enough.
bool has_place(const Diagnostic& diagnostic, ExitStatus status) {
  const SourcePlace& place = diagnostic.place;
  return !place.file.empty() && (place.line > 0 || !place.element.empty() || status == ExitStatus::input_missing);
}

void judge(const Error& error) {
  if (error.diagnostics().empty()) blame("nothing is told", error);
  for (const Diagnostic& diagnostic : error.diagnostics())
    if (diagnostic.message.size() < 8) blame("too short a message", error);
  for (const char c : to_string(error.diagnostics().front()))
    if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') blame("control characters", error);
}

}  // namespace

int told(const std::function<void()>& read) {
  try {
    read();
  } catch (const Error& error) {
    judge(error);
    if (error.status() != ExitStatus::bad_data && error.status() != ExitStatus::input_missing)
      blame("another status", error);
    for (const Diagnostic& diagnostic : error.diagnostics())
      if (!has_place(diagnostic, error.status())) blame("no place", error);
  }
  return 0;
}

int told_words(const std::function<void()>& read) {
  try {
    read();
  } catch (const Error& error) {
    judge(error);
  }
  return 0;
}

}  // namespace pomona::fuzz
