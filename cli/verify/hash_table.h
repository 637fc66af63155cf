// The table of hashes that every machine is to arrive at.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "cli/verify/verified_cut.h"

namespace pomona {

using HashTable = std::map<VerifiedCut, StageHashes>;

/// A line "TEMPLATE SEED KNIFE HASH ..." for each cut, sorted, after a comment that says what they are.
std::string write_hash_table(const HashTable& table);

/// \param file for messages. \throws Error (bad_data) with the line, for what is not such a table, or one larger than
/// tables are.
HashTable parse_hash_table(std::string_view text, const std::string& file);

/// \throws Error (input_missing) where it cannot be read.
HashTable read_hash_table(const std::filesystem::path& file);

}  // namespace pomona
