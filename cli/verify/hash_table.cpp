#include "cli/verify/hash_table.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <utility>
#include <vector>

#include "generator/base/error.h"
#include "generator/base/first_bytes.h"

namespace pomona {

namespace {

constexpr std::size_t largest_hash_table = 16 << 20;  // bytes; the published one has a hundred thousand

std::vector<std::string_view> words_in(std::string_view line) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string_view::npos) return words;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find(' '), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

bool is_hash(std::string_view word) {
  return word.size() == hash_digits && word.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// A compared seed, which has one digit.
std::optional<std::uint64_t> seed_in(std::string_view word) {
  static_assert(verified_seeds == 10);
  if (word.size() != 1 || word[0] < '0' || word[0] > '9') return {};
  return static_cast<std::uint64_t>(word[0] - '0');
}

bool is_verified_knife(std::string_view word) {
  return std::find(verified_knives.begin(), verified_knives.end(), word) != verified_knives.end();
}

/// Nothing for a line that is not of such a table.
std::optional<std::pair<VerifiedCut, StageHashes>> hash_line(std::string_view line) {
  const std::vector<std::string_view> words = words_in(line);
  if (words.size() != 3 + verified_stages.size()) return {};
  const std::optional<std::uint64_t> seed = seed_in(words[1]);
  if (!seed || !is_verified_knife(words[2]) || !std::all_of(words.begin() + 3, words.end(), is_hash)) return {};
  StageHashes hashes;
  std::copy(words.begin() + 3, words.end(), hashes.begin());
  return std::pair{VerifiedCut{std::string(words[0]), *seed, std::string(words[2])}, hashes};
}

}  // namespace

std::string write_hash_table(const HashTable& table) {
  std::string text = "# What `pomona verify` compares with; `make verify-table` makes it anew.\n# TEMPLATE SEED KNIFE";
  for (const char* stage : verified_stages) text += std::string(" ") + stage;
  text += "\n";
  for (const auto& [cut, hashes] : table) {
    text += cut.fruit + " " + std::to_string(cut.seed) + " " + cut.knife;
    for (const std::string& hash : hashes) text += " " + hash;
    text += "\n";
  }
  return text;
}

HashTable parse_hash_table(std::string_view text, const std::string& file) {
  HashTable table;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty() || line.starts_with("#")) continue;
    auto read = hash_line(line);
    if (!read)
      throw Error(ExitStatus::bad_data,
                  {{{file, number, 1, {}},
                    "is no line of hashes: a template, a seed and a knife that are compared, and a hash for each stage",
                    {}}});
    if (!table.insert(std::move(*read)).second)
      throw Error(ExitStatus::bad_data, {{{file, number, 1, {}}, "is a cut that an earlier line has", {}}});
  }
  if (table.empty())
    throw Error(ExitStatus::bad_data,
                {{{file, 1, 1, {}}, "holds no hashes", "`pomona verify -o FILE` writes a table"}});
  return table;
}

HashTable read_hash_table(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text = first_bytes(stream, largest_hash_table + 1);
  if (!stream.is_open() || stream.bad())
    throw Error(ExitStatus::input_missing, {{{file.string(), 0, 0, {}}, "cannot be read", {}}});
  if (text.size() > largest_hash_table)
    throw Error(ExitStatus::bad_data, {{{file.string(), 0, 0, {}}, "is too large for a table of hashes", {}}});
  return parse_hash_table(text, file.string());
}

}  // namespace pomona
