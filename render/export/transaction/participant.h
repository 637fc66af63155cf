// One folder that takes part in a transaction: its journal, and the hidden files that wait beside their destinations.
#pragma once

#include <filesystem>
#include <optional>

#include "render/export/transaction/durable_file.h"
#include "render/export/transaction/journal.h"

namespace pomona {

/// New files wait in the folder of their destinations; their names begin as the name of the journal does. The run that
/// writes them locks the journal (flock). So a journal that another run can lock is that of a dead run.
struct Participant {
  std::filesystem::path journal_path;  ///< FOLDER/.pomona-PROCESS-NUMBER.journal
  Descriptor journal_file;             ///< locked
  Journal journal{};                   ///< the journal of this run, or of a dead run
  bool is_complete = false;            ///< the dead run's journal was written to its end

  std::filesystem::path folder() const { return journal_path.parent_path(); }
  std::filesystem::path destination(std::size_t n) const { return folder() / journal.entries[n].name; }
  std::filesystem::path pending(std::size_t n) const;  ///< the new file n, until it is renamed
  std::filesystem::path backup(std::size_t n) const;   ///< the file that file n replaces
};

/// Makes a new, empty journal in a folder, and locks it.
/// \param meant what messages call the folder's file.
/// \throws Error (cannot_create)
Participant new_participant(const std::filesystem::path& folder, const std::filesystem::path& meant);

/// The participant of a dead run, locked now by this run. Nothing if the journal is gone or its run lives, or if
/// another user could have written it: a forged journal could rename our files.
std::optional<Participant> dead_participant(const std::filesystem::path& journal_path);

/// The journals in a folder, of living and of dead runs, sorted.
std::vector<std::filesystem::path> journals_in(const std::filesystem::path& folder);

/// Renames all files that still wait. Returns the first destination that cannot be replaced, with errno; nothing if all
/// are in place.
std::optional<std::filesystem::path> roll_forward(const Participant& participant);

/// Brings the old files back. Returns false if one cannot be brought back; then it can be tried again.
bool roll_back(const Participant& participant);

/// Removes the pending files and the backups, and the journal last.
void remove_hidden_files(const Participant& participant);

}  // namespace pomona
