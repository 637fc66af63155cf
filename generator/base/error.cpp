#include "generator/base/error.h"

#include <utility>

#include "generator/base/printable.h"

namespace pomona {

std::string to_string(const Diagnostic& diagnostic) {
  std::string text;
  const SourcePlace& place = diagnostic.place;
  if (!place.file.empty()) {
    text += printable_line(place.file);
    if (!place.element.empty()) {
      text += ":" + printable_line(place.element);
    } else if (place.line > 0) {
      text += ":" + std::to_string(place.line) + ":" + std::to_string(place.column);
    }
    text += ": ";
  }
  text += "error: " + printable_line(diagnostic.message);
  if (!diagnostic.hint.empty()) text += "\n  hint: " + printable_line(diagnostic.hint);
  return text;
}

namespace {

std::string joined(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (!text.empty()) text += "\n";
    text += to_string(diagnostic);
  }
  return text;
}

}  // namespace

Error::Error(ExitStatus status, std::vector<Diagnostic> diagnostics)
    : std::runtime_error(joined(diagnostics)), status_(status), diagnostics_(std::move(diagnostics)) {}

Error::Error(ExitStatus status, std::string message, std::string hint)
    : Error(status, std::vector<Diagnostic>{{{}, std::move(message), std::move(hint)}}) {}

Error told_of(const Error& error, const std::string& file) {
  std::vector<Diagnostic> diagnostics = error.diagnostics();
  for (Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.place.file.empty()) diagnostic.place.file = file;
  }
  return {error.status(), std::move(diagnostics)};
}

}  // namespace pomona
