// A transaction: files in one or several folders that come into place together, or not at all.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "render/export/transaction/participant.h"
#include "render/export/transaction/spooled_bytes.h"

namespace pomona {

/// Writes each file beside its destination first. commit() renames them all. What a killed run leaves is recovered by
/// the next transaction in one of the folders (recovery.h).
class Transaction {
 public:
  Transaction() = default;
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  /// Removes what was not committed.
  ~Transaction();

  /// Writes the bytes, and then `rest` if there is one, down to the disk. A file that will replace another gets its
  /// permissions.
  /// \param destination no link. \param meant what messages call it.
  /// \throws Error (cannot_create, io_error), (usage) if the destination was added before.
  void add(const std::filesystem::path& destination, const std::filesystem::path& meant, std::string_view bytes,
           const SpooledBytes* rest = nullptr);

  /// Puts all files into place. If one cannot be, all destinations are as they were. \throws Error (cannot_create,
  /// io_error)
  void commit();

 private:
  Participant& participant_for(const std::filesystem::path& folder, const std::filesystem::path& meant);
  std::size_t file_count() const;
  void keep_backups() const;
  void write_journals();
  void roll_back_all(bool has_journals);

  std::vector<Participant> participants_;  ///< the first one leads
};

}  // namespace pomona
