// The journal of a transaction in one folder: a later run can finish the transaction with it, or roll it back.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pomona {

/// One file of the transaction.
struct JournalEntry {
  std::string name;         ///< name of the destination, without its folder
  std::uint64_t inode = 0;  ///< inode of the new file: it identifies the file after it was renamed
  bool replaces = false;    ///< there was a file of this name before
};

/// A transaction that writes into several folders has a journal in each. One folder leads: the transaction is committed
/// as soon as the leader's journal is complete on the disk.
struct Journal {
  std::filesystem::path leader;                  ///< absolute path of the leader's journal; empty in that journal
  std::vector<std::filesystem::path> followers;  ///< absolute paths of the other journals; only in the leader's journal
  std::vector<JournalEntry> entries;             ///< the files in this folder
  bool is_rolled_back = false;                   ///< a renaming failed: the old files come back
};

/// The bytes of a journal, as CBOR (RFC 8949), which allows any bytes in names.
std::string journal_bytes(const Journal& journal);

/// Appended to the leader's journal, in one write, when the transaction is rolled back.
inline constexpr std::string_view rollback_mark = "rollback";

/// Nothing if the journal is incomplete: then its run was stopped before the commit.
std::optional<Journal> parse_journal(std::string_view bytes);

}  // namespace pomona
