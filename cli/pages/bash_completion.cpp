#include "cli/pages/completion.h"
#include "cli/pages/names_asked_for.h"

namespace pomona {

namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// A branch of "case": sets the possible words, and whether files are offered, too.
std::string branch(const std::string& pattern, const TypedOption& option) {
  const std::string asked = names_asked_for(option.value);
  const std::string words = asked.empty() ? "'" + joined(option.words) + "'" : "$(" + asked + ")";
  return "    " + pattern + ") words=" + words + " files=" + (takes_files(option) ? "yes" : "no") + " ;;\n";
}

/// The value of an option.
std::string values_of(const TypedCommand& command) {
  std::string text;
  for (const TypedOption& option : command.options) {
    if (option.names.empty() || option.value.empty()) continue;
    std::string pattern;
    for (const std::string& name : option.names) pattern += (pattern.empty() ? "'" : "|'") + command.name + "'" + name;
    text += branch(pattern, option);
  }
  return text;
}

std::string names_of(const TypedCommand& command) {
  std::vector<std::string> names;
  for (const TypedOption& option : command.options) names.insert(names.end(), option.names.begin(), option.names.end());
  return joined(names);
}

/// A word that is no option's value: an option, or a positional word.
std::string places_of(const TypedCommand& command) {
  const std::string name = "'" + command.name + "'";
  if (!command.parts.empty()) return "    '" + command.name + " '*) words='" + joined(command.parts) + "' ;;\n";
  const std::string text = "    " + name + "-*) words='" + names_of(command) + "' ;;\n";
  for (const TypedOption& option : command.options) {
    if (option.names.empty()) return text + branch(name + "*", option);
  }
  return text;
}

constexpr const char* begin =
    R"(# What bash completes after "pomona". Made from the program's options by `pomona pages bash`.
_pomona() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command='' words='' files=no i
  # bash takes "--view=top" for three words.
  if [[ $word == = ]]; then word=''; elif [[ $before == = ]]; then before=${COMP_WORDS[COMP_CWORD-2]}; fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case $command${COMP_WORDS[i]} in
)";

constexpr const char* middle = R"(    esac
  done
  case $command$before in
)";

constexpr const char* between_cases = R"(    *) case $command$word in
)";

constexpr const char* end = R"(    esac ;;
  esac
  COMPREPLY=($(compgen -W "$words" -- "$word"))
  [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == *: ]] && compopt -o nospace
  [[ $files == yes ]] && compopt -o default
}
complete -F _pomona pomona
)";

}  // namespace

std::string bash_completion(std::span<const TypedCommand> commands) {
  const TypedCommand& program = commands.front();
  std::vector<std::string> names;
  std::string text = begin;
  for (const TypedCommand& command : commands.subspan(1)) {
    if (!is_part(command)) names.push_back(command.name);
    const bool goes_on = !command.parts.empty();
    text += "      '" + command.name + "') command='" + command.name + (goes_on ? " ' ;;\n" : "'; break ;;\n");
  }
  text += middle;
  for (const TypedCommand& command : commands.subspan(1)) text += values_of(command);
  text += between_cases;
  // Tests subcommands first, because their names begin with their command's.
  for (const TypedCommand& command : commands.subspan(1))
    if (command.parts.empty()) text += places_of(command);
  for (const TypedCommand& command : commands.subspan(1))
    if (!command.parts.empty()) text += places_of(command);
  return text + "    *) words='" + joined(names) + " " + names_of(program) + "' ;;\n" + end;
}

}  // namespace pomona
