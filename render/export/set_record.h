// What one folder must remember of files that come into place together, so that a later run can finish or undo it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pomona {

/// One of the files. Number n of a set waits under the name "STEM-n.part"; what it replaces is kept as "STEM-n.old".
struct SetMember {
  std::string name;         ///< of the destination, within the folder
  std::uint64_t inode = 0;  ///< of the new file: after a renaming it still tells whose the destination is
  bool replaces = false;    ///< there was a file of this name
};

/// A folder's share of a set. Of several folders one leads: the set counts as decided once its record is whole.
struct SetRecord {
  std::filesystem::path leader;                  ///< the leading folder's record, absolute; empty: it is this one
  std::vector<std::filesystem::path> followers;  ///< the other folders' records, absolute
  std::vector<SetMember> members;
  bool undone = false;  ///< something failed: what was there before is to come back
};

/// The bytes of a record; `undo_mark` may be appended to them later, in one write.
std::string record_bytes(const SetRecord& record);
inline constexpr std::string_view undo_mark{"undo\0", 5};

/// Nothing if the bytes are no whole record: its writer was stopped before anything was decided.
std::optional<SetRecord> parse_record(std::string_view bytes);

}  // namespace pomona
