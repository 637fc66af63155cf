#include "cli/pages/completion.h"
#include "cli/pages/names_asked_for.h"

namespace pomona {

namespace {

/// Escapes a text for '...'.
std::string quoted(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'' || c == '\\') result += '\\';
    result += c;
  }
  return "'" + result + "'";
}

/// Whether a value follows, and its possible words.
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

/// When a command has been typed: all of its words.
std::string when_typed(const std::string& name) {
  const std::string seen = "__fish_seen_subcommand_from ";
  const std::size_t space = name.find(' ');
  if (space == std::string::npos) return seen + name;
  return seen + name.substr(0, space) + "; and " + seen + name.substr(space + 1);
}

/// The line that offers a command, or a subcommand if its command has been typed without one.
std::string offer(const TypedCommand& command, const std::string& none_yet, const TypedCommand& whole) {
  std::string when = none_yet, word = command.name;
  if (is_part(command)) {
    when = when_typed(whole.name) + "; and not __fish_seen_subcommand_from";
    for (const std::string& part : whole.parts) when += " " + part;
    word = word.substr(word.find(' ') + 1);
  }
  return "complete -c pomona -n " + quoted(when) + " -a " + word + " -d " + quoted(command.help) + "\n";
}

}  // namespace

std::string fish_completion(std::span<const TypedCommand> commands) {
  const std::string none_yet = "__fish_use_subcommand";
  std::string text = "# Made from the program's options by `pomona pages fish`.\ncomplete -c pomona -f\n";
  for (const TypedOption& option : commands.front().options) text += line(none_yet, option);
  const TypedCommand* whole = nullptr;
  for (const TypedCommand& command : commands.subspan(1)) {
    if (!is_part(command)) whole = &command;
    text += offer(command, none_yet, *whole);
    if (!command.parts.empty()) continue;
    for (const TypedOption& option : command.options) text += line(when_typed(command.name), option);
  }
  return text;
}

}  // namespace pomona
