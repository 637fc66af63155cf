// The fruit that is edited: its texts, its files, and the copy of unsaved edits on disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include "cli/studio/fruit_texts.h"

namespace pomona {

struct WorkspaceFiles {
  std::filesystem::path toml;
  std::filesystem::path svg;      ///< beside it; empty if the template names no sketch
  std::filesystem::path unsaved;  ///< "kiwi.toml.unsaved": edits that are not saved yet
};

struct WorkspaceState {
  std::uint64_t version = 1;  ///< of the texts; every change makes a new one
  FruitTexts texts;
  bool unsaved = false;          ///< the texts differ from the files
  bool recovered = false;        ///< they come from a studio that ended before it saved
  bool changed_outside = false;  ///< another program has changed the files while there are unsaved edits
};

enum class SaveResult { saved, behind, changed_outside };

/// Texts under an optimistic lock: a client that changes or saves them names the version it has seen, and is told if
/// there is a newer one. Edits are written to disk beside the template at once. May be called from any thread.
class Workspace {
 public:
  /// \param starting the texts of a new fruit, without files yet. Else the files are read.
  /// \throws Error (input_missing, bad_data) for files that cannot be read, (cannot_create) for starting texts whose
  /// files exist
  Workspace(WorkspaceFiles files, std::optional<FruitTexts> starting);

  const WorkspaceFiles& files() const { return files_; }

  /// The state; if nothing is edited, it reads what another program has written.
  WorkspaceState state();

  /// The new version; nothing if `seen` is not the newest. \throws Error (cannot_create, io_error) if the edit cannot
  /// be written to disk, (bad_data) if a text is longer than the studio opens; then the edit is refused.
  std::optional<std::uint64_t> change(std::uint64_t seen, FruitTexts texts);

  /// Writes both files, or neither. \param over overwrites changes by another program.
  SaveResult save(std::uint64_t seen, bool over);

  /// Returns to the files. False if `seen` is not the newest version.
  bool revert(std::uint64_t seen);

 private:
  FruitTexts on_disk() const;
  void recover();
  void keep_unsaved() const;
  void forget_unsaved() const;
  void take_in();

  WorkspaceFiles files_;
  std::mutex mutex_;
  WorkspaceState state_;
  FruitTexts saved_;  ///< the files as last read or written here
  bool exists_ = true;
};

/// The files of a template. \throws Error (bad_data) if its sketch leads out of its folder.
WorkspaceFiles workspace_files(const std::filesystem::path& toml, const std::string& text);

}  // namespace pomona
