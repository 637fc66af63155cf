// Recovery: what a killed run has left in a folder is finished or rolled back.
#pragma once

#include <filesystem>

namespace pomona {

/// Recovers every transaction of a dead run that has a journal in the folder. A transaction that was committed is
/// finished in all its folders, or, if that fails, rolled back in all. One that was not committed is removed.
void recover_folder(const std::filesystem::path& folder);

}  // namespace pomona
