#include "render/export/transaction/journal.h"

#include <utility>

#include <nlohmann/json.hpp>

namespace pomona {

namespace {

using nlohmann::json;

/// Whether the name stays in its folder.
bool is_plain_name(const std::string& name) {
  return !name.empty() && name != "." && name != ".." && name.find('/') == std::string::npos;
}

/// \throws json::exception where a field is missing or has another type
std::optional<Journal> journal_of(const json& fields) {
  Journal journal;
  journal.leader = fields.at("leader").get<std::string>();
  for (const json& follower : fields.at("followers")) journal.followers.emplace_back(follower.get<std::string>());
  for (const json& entry : fields.at("entries")) {
    journal.entries.push_back({entry.at("name"), entry.at("inode"), entry.at("replaces")});
    if (!is_plain_name(journal.entries.back().name)) return {};
  }
  return journal;
}

}  // namespace

std::string journal_bytes(const Journal& journal) {
  json followers = json::array(), entries = json::array();
  for (const std::filesystem::path& follower : journal.followers) followers.push_back(follower.native());
  for (const JournalEntry& entry : journal.entries)
    entries.push_back({{"name", entry.name}, {"inode", entry.inode}, {"replaces", entry.replaces}});
  const json fields{{"leader", journal.leader.native()}, {"followers", followers}, {"entries", entries}};
  std::string bytes;
  json::to_cbor(fields, bytes);
  return bytes;
}

std::optional<Journal> parse_journal(std::string_view bytes) {
  // Strict: nothing may be missing, and nothing may follow.
  json fields = json::from_cbor(bytes, true, false);
  const bool is_rolled_back = fields.is_discarded() && bytes.ends_with(rollback_mark);
  if (is_rolled_back) {
    bytes.remove_suffix(rollback_mark.size());
    fields = json::from_cbor(bytes, true, false);
  }
  if (fields.is_discarded()) return {};
  try {
    std::optional<Journal> journal = journal_of(fields);
    if (journal) journal->is_rolled_back = is_rolled_back;
    return journal;
  } catch (const json::exception&) {
    return {};
  }
}

}  // namespace pomona
