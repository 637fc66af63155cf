// The table of hashes that every machine must reproduce.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "cli/verify/verified_cut.h"

namespace pomona {

using HashTable = std::map<VerifiedCut, StageHashes>;

/// A line "TEMPLATE SEED KNIFE HASH ..." for each cut, sorted, after an explaining comment.
std::string write_hash_table(const HashTable& table);

/// \param file for messages. \throws Error (bad_data) with the line, for a text that is not such a table or is too
/// large.
HashTable parse_hash_table(std::string_view text, const std::string& file);

/// \throws Error (input_missing) if it cannot be read.
HashTable read_hash_table(const std::filesystem::path& file);

}  // namespace pomona
