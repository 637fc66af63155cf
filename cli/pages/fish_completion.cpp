#include "cli/pages/completion.h"
#include "cli/pages/names_asked_for.h"

namespace pomona {

namespace {

/// For within '...'.
std::string quoted(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'' || c == '\\') result += '\\';
    result += c;
  }
  return "'" + result + "'";
}

/// Whether a value follows, and what it may be.
std::string value_of(const TypedOption& option) {
  std::string text = takes_files(option) ? " -F" : " -f";
  if (!option.value.empty() && !option.names.empty()) text += " -r";
  std::string words;
  for (const std::string& word : option.words) words += (words.empty() ? "" : " ") + word;
  if (const std::string asked = names_asked_for(option.value); !asked.empty()) words = "(" + asked + ")";
  return words.empty() ? text : text + " -a " + quoted(words);
}

std::string line(const std::string& when, const TypedOption& option) {
  std::string text = "complete -c pomona -n " + quoted(when);
  for (const std::string& name : option.names) {
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  return text + value_of(option) + " -d " + quoted(option.help) + "\n";
}

}  // namespace

std::string fish_completion(std::span<const TypedCommand> commands) {
  const std::string none_yet = "__fish_use_subcommand";
  std::string text = "# Made from the program's options by `pomona pages fish`.\ncomplete -c pomona -f\n";
  for (const TypedOption& option : commands.front().options) text += line(none_yet, option);
  for (const TypedCommand& command : commands.subspan(1)) {
    text += "complete -c pomona -n " + none_yet + " -a " + command.name + " -d " + quoted(command.help) + "\n";
    for (const TypedOption& option : command.options) {
      text += line("__fish_seen_subcommand_from " + command.name, option);
    }
  }
  return text;
}

}  // namespace pomona
