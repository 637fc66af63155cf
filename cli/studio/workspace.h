// The fruit that is being edited: its texts, its files, and what keeps them from being lost.
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
  std::filesystem::path svg;      ///< beside it; empty where the template names no sketch
  std::filesystem::path unsaved;  ///< "kiwi.toml.unsaved": edits that are not saved yet
};

struct WorkspaceState {
  std::uint64_t version = 1;  ///< of the texts; every change has a new one
  FruitTexts texts;
  bool unsaved = false;          ///< the texts differ from the files
  bool recovered = false;        ///< they come from a studio that was ended before it saved
  bool changed_outside = false;  ///< the files have changed since, while there are edits here
};

enum class SaveResult { saved, behind, changed_outside };

/// Texts under an optimistic lock: who changes or saves them names the version he has seen, and is told if there is a
/// newer one. Edits lie on disk beside the template as soon as they are taken. May be called from any thread.
class Workspace {
 public:
  /// \param starting the texts of a fruit whose files are not there yet. Else they are read.
  /// \throws Error (input_missing, bad_data) for files that cannot be read, (cannot_create) for starting texts whose
  /// files are there
  Workspace(WorkspaceFiles files, std::optional<FruitTexts> starting);

  const WorkspaceFiles& files() const { return files_; }

  /// Takes in what another program has written, if nothing was edited here.
  WorkspaceState state();

  /// The new version; nothing if `seen` is not the newest. \throws Error (cannot_create, io_error) if the edit cannot
  /// be kept on disk, (bad_data) if a text is longer than the studio opens: it is not taken then.
  std::optional<std::uint64_t> change(std::uint64_t seen, FruitTexts texts);

  /// Both files appear, or neither. \param over even if another program has changed them.
  SaveResult save(std::uint64_t seen, bool over);

  /// Goes back to the files. False if `seen` is not the newest version.
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
  FruitTexts saved_;  ///< as the files were when they were last read or written here
  bool exists_ = true;
};

/// The files of a template. \throws Error (bad_data) if its sketch leads out of its folder.
WorkspaceFiles workspace_files(const std::filesystem::path& toml, const std::string& text);

}  // namespace pomona
