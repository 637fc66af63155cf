// A folder that holds a batch as it was, made ready for the batch as it is now.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/batch/item_work.h"
#include "cli/batch/workplace.h"

namespace pomona {

struct UpdateReport {
  std::int64_t kept = 0;                   ///< items that are as they are to be, wherever they now belong
  std::int64_t changed = 0;                ///< items that are to be made anew
  std::int64_t removed = 0;                ///< items that nobody asks for any more
  std::vector<std::string> first_removed;  ///< at most twenty
};

/// Items that the work makes by the same recipe stay, or are set aside where they belong elsewhere; all others are
/// removed, and batch.json becomes that of the work. A run that is then made as usual takes what is aside. Whenever it
/// is stopped, the folder holds items of its batch.json alone.
/// \param there the folder's batch.json. \param wanted the work's.
/// \throws Error (bad_data) if `there` is no record; (cannot_create, io_error)
UpdateReport update_folder(const ItemWork& work, const std::string& there, const std::string& wanted,
                           Workplace& workplace);

/// "kept 5 items, makes 2 anew, removed 1 that is no longer asked for: cut/005"
std::string told(const UpdateReport& report);

}  // namespace pomona
