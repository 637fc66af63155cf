// A batch in shards, as shell commands for many machines.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pomona {

/// All paths are absolute, and mean the same on every machine.
struct FarmJob {
  std::filesystem::path program;   ///< pomona
  std::filesystem::path batch;     ///< the file of the batch or data set
  std::string makes = "batch";     ///< the command that makes it: "batch" or "data"
  std::filesystem::path output;    ///< the batch's folder
  std::filesystem::path works_in;  ///< the folder from which the batch names templates
  int tasks = 1;                   ///< shards
  std::string memory;              ///< for --memory; none if empty
};

/// The command that makes one shard, for a shell.
/// \param share,threads text that the shell expands: "\"$I/64\"".
std::string shard_command(const FarmJob& job, const std::string& share, const std::string& threads);

/// The command that joins all shards.
std::string merge_command_line(const FarmJob& job);

/// One line for each shard, to be run anywhere and in any order.
/// \param threads as above.
/// \throws Error (usage) if a path has a line break, which no list of lines can hold.
std::vector<std::string> shard_lines(const FarmJob& job, const std::string& threads);

}  // namespace pomona
