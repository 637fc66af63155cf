#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/exhausted.h"
#include "generator/base/nearest_name.h"
#include "generator/base/printable.h"
#include "generator/base/version.h"

namespace pomona {

namespace {

bool colors_wanted() { return isatty(STDERR_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr; }

/// "error:" in red on a terminal, unless NO_COLOR says otherwise.
void print_error(std::string text) {
  text = printable(text);
  const std::string word = "error:";
  const std::size_t at = text.find(word);
  if (colors_wanted() && at != std::string::npos) text.replace(at, word.size(), "\033[1;31merror:\033[0m");
  std::fprintf(stderr, "%s\n", text.c_str());
}

void print(const Error& error) {
  for (const Diagnostic& diagnostic : error.diagnostics()) print_error(to_string(diagnostic));
}

/// The names of all options a subcommand knows, for "did you mean".
std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// The (sub)command that the first words name, and the number of these words.
struct NamedCommand {
  const CLI::App* app = nullptr;
  std::string words;  ///< "pomona farm slurm"
  int next = 1;       ///< index of the first word that is not part of the name
};

NamedCommand named_command(const CLI::App& app, const std::vector<std::string>& arguments) {
  NamedCommand named{&app, "pomona"};
  for (; named.next < std::ssize(arguments); ++named.next) {
    const std::string& word = arguments[static_cast<std::size_t>(named.next)];
    const std::vector<const CLI::App*> parts = named.app->get_subcommands({});
    const auto part =
        std::find_if(parts.begin(), parts.end(), [&](const CLI::App* p) { return p->get_name() == word; });
    if (part == parts.end()) break;
    named.app = *part;
    named.words += " " + word;
  }
  return named;
}

/// Reports a first word that is no command, or a missing one; CLI11 would only say that a subcommand is missing.
std::optional<std::string> fault_of_command(const NamedCommand& named, const std::vector<std::string>& arguments) {
  std::vector<std::string> known;
  for (const CLI::App* command : named.app->get_subcommands({})) known.push_back(command->get_name());
  if (known.empty()) return {};
  if (named.next == std::ssize(arguments))
    return "error: a subcommand is missing\n  hint: " + named.words + " needs one of " + joined(known, ", ");

  const std::string& word = arguments[static_cast<std::size_t>(named.next)];
  if (word == "--") return "error: a subcommand is missing before --\n  hint: see `" + named.words + " -h`";
  if (word.starts_with("-")) return {};
  const auto near = nearest_name(word, known);
  return "error: there is no command \"" + named.words.substr(std::string("pomona").size()).append(" ").substr(1) +
         word + "\"\n  hint: " + (near ? "did you mean " + *near + "?" : "see `" + named.words + " -h`");
}

/// The subcommand among the words that knows the option, which stands before it.
std::optional<std::string> command_with(const NamedCommand& named, const std::string& option,
                                        const std::vector<std::string>& arguments) {
  for (const CLI::App* command : named.app->get_subcommands({})) {
    const std::vector<std::string> known = option_names(*command);
    const bool is_named = std::find(arguments.begin(), arguments.end(), command->get_name()) != arguments.end();
    if (is_named && std::find(known.begin(), known.end(), option) != known.end()) return command->get_name();
  }
  return {};
}

/// The commands that have an option of this name, by the words that call them: "pomona cut".
std::vector<std::string> commands_having(const CLI::App& app, const std::string& option, const std::string& words) {
  std::vector<std::string> having;
  const std::vector<std::string> known = option_names(app);
  if (std::find(known.begin(), known.end(), option) != known.end()) having.push_back(words);
  for (const CLI::App* part : app.get_subcommands({}))
    for (std::string& each : commands_having(*part, option, words + " " + part->get_name()))
      having.push_back(std::move(each));
  return having;
}

/// What may be meant by an option that the command does not have: one of its own, with another dash; the same of other
/// commands; or a near one.
std::string meant_by(const std::string& option, const std::vector<std::string>& known, const CLI::App& app) {
  if (std::find(known.begin(), known.end(), option) != known.end()) return "did you mean " + option + "? ";
  const std::vector<std::string> having = commands_having(app, option, "pomona");
  if (!having.empty()) return "it is an option of " + joined(having, ", ") + "; ";
  const auto near = nearest_name(option, known);
  return near ? "did you mean " + *near + "? " : "";
}

/// A word such as "-seed" or "-v", which is not read as letters that are options each.
bool is_unknown_short(const std::string& word, const CLI::App& app) {
  if (word.size() < 2 || word[0] != '-' || std::isalpha(static_cast<unsigned char>(word[1])) == 0) return false;
  const std::vector<const CLI::Option*> options = app.get_options();
  return std::none_of(options.begin(), options.end(), [&](const CLI::Option* option) {
    const std::vector<std::string>& letters = option->get_snames();
    return std::find(letters.begin(), letters.end(), word.substr(1, 1)) != letters.end();
  });
}

/// A mistyped option is reported first, because the option that was meant may then count as missing.
std::optional<std::string> fault_of_options(const CLI::App& app, const NamedCommand& named,
                                            const std::vector<std::string>& arguments) {
  const std::vector<std::string> known = option_names(*named.app);
  for (std::size_t i = static_cast<std::size_t>(named.next); i < arguments.size() && arguments[i] != "--"; ++i) {
    const std::string word = arguments[i].substr(0, arguments[i].find('='));
    if (is_unknown_short(word, *named.app))
      return "error: there is no option " + word + "\n  hint: " + meant_by("-" + word, known, app) + "see `" +
             named.words + " -h`";
    if (!word.starts_with("--") || std::find(known.begin(), known.end(), word) != known.end()) continue;
    if (const auto command = command_with(named, word, arguments))
      return "error: " + word + " stands before the command\n  hint: it belongs behind it: `" + named.words + " " +
             *command + " ... " + word + "`";
    return "error: there is no option " + word + "\n  hint: " + meant_by(word, known, app) + "see `" + named.words +
           " -h`";
  }
  return {};
}

/// Errors of the command line with better messages than the parser's.
std::string fault_of(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& arguments) {
  const NamedCommand named = named_command(app, arguments);
  if (const auto fault = fault_of_command(named, arguments)) return *fault;
  if (const auto fault = fault_of_options(app, named, arguments)) return *fault;
  std::string what = error.what();
  const std::size_t too_often = what.find(": At Most 1 required");
  if (too_often != std::string::npos) what = what.substr(0, too_often) + " is given more than once";
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    what = "not expected: " + joined(app.remaining(true), " ");
  return "error: " + what + "\n  hint: see `" + named.words + " -h`";
}

/// The words for the parser: `pomona help cut` becomes `pomona cut -h`, `pomona version` becomes `pomona --version`.
std::vector<std::string> parser_words(int argc, char** argv) {
  std::vector<std::string> words(argv, argv + argc);
  if (words.size() > 1 && words[1] == "help") {
    words.erase(words.begin() + 1);
    words.push_back("-h");
  } else if (words.size() > 1 && words[1] == "version") {
    words[1] = "--version";
  }
  return words;
}

/// Whether all output has been written; a full disk shows only now.
ExitStatus printed(ExitStatus status) {
  std::cout.flush();
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good()) return status;
  const std::string why = errno != 0 ? ": " + std::error_code(errno, std::generic_category()).message() : "";
  print_error("standard output: error: cannot be written" + why);
  return status == ExitStatus::done ? ExitStatus::io_error : status;
}

/// Allocates nothing: there may be no memory for the words of a message, and end_uncaught() may not fail.
ExitStatus tell_lack(std::string_view lack) {
  const std::string_view error = colors_wanted() ? "\033[1;31merror:\033[0m " : "error: ";
  for (const std::string_view part :
       {error, lack,
        std::string_view("\n  hint: a smaller --detail or --size needs less memory, --threads 1 one thread\n")})
    std::fwrite(part.data(), 1, part.size(), stderr);
  return ExitStatus::out_of_memory;
}

void tell_bug(const std::string& what) { print_error("error: this is a bug in pomona: " + what); }

/// For std::terminate: nobody can catch exceptions of TBB's own threads. A lack of memory or threads is reported as
/// that of a command.
[[noreturn]] void end_uncaught() {
  try {
    if (const std::exception_ptr uncaught = std::current_exception()) std::rethrow_exception(uncaught);
  } catch (const std::exception& error) {
    if (const auto lack = exhausted(error)) std::_Exit(static_cast<int>(tell_lack(*lack)));
    tell_bug(error.what());
  } catch (...) {
    tell_bug("an exception of no known kind");
  }
  std::abort();
}

}  // namespace

ExitStatus run_action(const std::function<ExitStatus()>& action) {
  try {
    return action();
  } catch (const Error& error) {
    print(error);
    return error.status();
  } catch (const std::exception& error) {
    if (const auto lack = exhausted(error)) return tell_lack(*lack);
    tell_bug(error.what());
  }
  return ExitStatus::bug;
}

int run(const std::vector<Command>& commands, int argc, char** argv) {
  std::set_terminate(end_uncaught);
  CLI::App app("Grows fruit and vegetables that can be cut anywhere, and fills scenes with them.", "pomona");
  app.set_version_flag("-V,--version", std::string("pomona ") + version);
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.require_subcommand(1);
  std::vector<DeclaredCommand> declared;
  for (const Command command : commands) declared.push_back(command(app));

  const std::vector<std::string> words = parser_words(argc, argv);
  try {
    std::vector<std::string> reversed(words.rbegin(), words.rend());
    if (!reversed.empty()) reversed.pop_back();
    app.parse(std::move(reversed));
  } catch (const CLI::Success& asked_for_text) {
    if (const auto fault = fault_of_command(named_command(app, words), words)) {  // `pomona help bogus`
      print_error(*fault);
      return static_cast<int>(ExitStatus::usage);
    }
    app.exit(asked_for_text);  // -h or --version
    return static_cast<int>(printed(ExitStatus::done));
  } catch (const CLI::ParseError& error) {
    print_error(fault_of(app, error, words));
    return static_cast<int>(ExitStatus::usage);
  }
  for (const DeclaredCommand& command : declared) {
    if (command.subcommand->parsed()) return static_cast<int>(printed(run_action(command.action)));
  }
  return static_cast<int>(ExitStatus::usage);
}

}  // namespace pomona
