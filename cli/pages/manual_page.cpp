#include "cli/pages/manual_page.h"

#include <algorithm>

namespace pomona {

namespace {

/// Escapes text for groff: hyphens as typed, and no line that begins like a request.
std::string escaped(const std::string& text) {
  std::string result = !text.empty() && (text[0] == '.' || text[0] == '\'') ? "\\&" : "";
  for (const char c : text) {
    if (c == '-' || c == '\\') result += c == '-' ? "\\" : "\\e";
    if (c != '\\') result += c;
  }
  return result;
}

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + escaped(text) + "\\fR"; }

/// "-o, --output FILE", as it is typed.
std::string shape_of(const TypedOption& option, std::size_t max_names = 2) {
  std::string shape;
  for (std::size_t i = 0; i < std::min(max_names, option.names.size()); ++i) {
    shape += (shape.empty() ? "" : ", ") + bold(option.names[i]);
  }
  if (!option.value.empty()) shape += (shape.empty() ? "" : " ") + italic(option.value);
  return shape;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string option_entry(const TypedOption& option) {
  std::string text = option.help + ".";
  // Knives come below all options, with their values.
  if (!option.words.empty() && option.value != "KNIFE") text += " One of " + joined(option.words) + ".";
  if (!option.limits.empty()) text += " Within " + option.limits + ".";
  if (!option.usual.empty()) text += " Unless said, " + option.usual + ".";
  if (option.repeated) text += " May be given several times.";
  return ".TP\n" + shape_of(option) + "\n" + escaped(text) + "\n";
}

/// The last lines of a command's help, unchanged.
std::string table(const std::string& text) {
  if (text.empty()) return "";
  std::string lines;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    lines += escaped(text.substr(from, end - from)) + "\n";
    from = end + 1;
  }
  return ".PP\n.nf\n" + lines + ".fi\n";
}

/// The words that are required.
std::string synopsis(const TypedCommand& command) {
  std::string line = bold("pomona") + " " + bold(command.name);
  for (const bool by_place : {true, false}) {
    for (const TypedOption& option : command.options) {
      if (option.needed && option.names.empty() == by_place) line += " " + shape_of(option, 1);
    }
  }
  return ".br\n" + line + " [options]\n";
}

constexpr const char* files_and_more = R"(.SH FILES
.TP
.I share/pomona/templates, share/pomona/scenes, share/pomona/styles
What names stand for, beside the folder that holds the program. Names are looked for there first, then in the
current folder.
.SH ENVIRONMENT
.TP
.B POMONA_GL
The OpenGL to use: device, surfaceless or osmesa. Unless said, the first that works.
.TP
.B NO_COLOR
If set, errors are not coloured.
.SH SEE ALSO
The documents under share/doc/pomona/docs: reference/commands.md says more of every option, and lists the exit statuses;
guides/python.md and guides/blender.md tell how Python and Blender do the same.
)";

}  // namespace

std::string manual_page(std::span<const TypedCommand> commands, const std::string& version) {
  const TypedCommand& program = commands.front();
  std::string page = ".TH POMONA 1 \"\" \"pomona " + version + "\" \"User Commands\"\n";
  page += ".SH NAME\npomona \\- grows fruit and vegetables that can be cut anywhere\n.SH SYNOPSIS\n";
  for (const TypedCommand& command : commands.subspan(1))
    if (command.parts.empty()) page += synopsis(command);
  page += ".SH DESCRIPTION\n" + escaped(program.help) + "\n";
  for (const TypedOption& option : program.options) page += option_entry(option);
  for (const TypedCommand& command : commands.subspan(1)) {
    page += ".SH POMONA " + escaped(command.name) + "\n" + escaped(command.help) + ".\n";
    for (const TypedOption& option : command.options) page += option_entry(option);
    page += table(command.more);
  }
  return page + files_and_more;
}

}  // namespace pomona
