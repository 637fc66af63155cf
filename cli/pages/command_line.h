// The command line as declared: the one source of the manual page and of completions.
#pragma once

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own
class App;
}

namespace pomona {

struct TypedOption {
  std::vector<std::string> names;  ///< "-o", "--output"; none for a positional word
  std::string value;               ///< kind of the value: "FILE", "INT"; or of the word: "TEMPLATE". Empty for a flag
  std::vector<std::string> words;  ///< all possible values, if they are few; a word that ends in ':' continues
  std::string limits;              ///< "1 - 64", for numbers
  std::string usual;               ///< default
  std::string help;
  bool needed = false;
  bool repeated = false;
};

struct TypedCommand {
  std::string name;  ///< "cut"; for a subcommand "farm slurm"
  std::string help;
  std::vector<TypedOption> options;
  std::string more;                     ///< last lines of its help: the knives
  std::vector<std::string> parts = {};  ///< last words of its subcommands, one of which must follow
};

/// The program itself, whose options come before any command, then the commands, each before its subcommands.
std::vector<TypedCommand> command_line(const CLI::App& app);

/// Whether it is a subcommand: its name has two words.
bool is_part(const TypedCommand& command);

/// Whether the value may be the name of an existing or new file.
bool takes_files(const TypedOption& option);

}  // namespace pomona
