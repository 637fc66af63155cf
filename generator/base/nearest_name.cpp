#include "generator/base/nearest_name.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pomona {

namespace {

/// The distance of Damerau and Levenshtein, in which two letters that have changed places are one mistake; two rows
/// back are kept.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1), before(row.size()), two_before(row.size());
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    two_before.swap(before);
    before.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({before[j] + 1, row[j - 1] + 1, before[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], two_before[j - 2] + 1);
    }
  }
  return row.back();
}

/// Capitals of ASCII as small letters.
std::string in_small_letters(std::string word) {
  for (char& letter : word) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return word;
}

}  // namespace

std::optional<std::string> nearest_name(const std::string& name, const std::vector<std::string>& known) {
  // Long words may differ more; beyond a third of the word a guess would only confuse.
  constexpr std::size_t longest = 64;
  if (name.size() > longest) return std::nullopt;
  std::size_t best = std::max<std::size_t>(1, (name.size() + 1) / 3) + 1;
  std::size_t best_longer = 0;  // of equally near ones the one of the most similar length: letters change places often
  std::optional<std::string> nearest;
  const std::string small = in_small_letters(name);
  for (const std::string& candidate : known) {
    // Each letter that one has more is a mistake.
    const auto [shorter, longer] = std::minmax({small.size(), candidate.size()});
    if (longer - shorter >= best) continue;
    const std::size_t distance = edit_distance(small, in_small_letters(candidate));
    if (std::pair(distance, longer - shorter) < std::pair(best, best_longer)) {
      best = distance;
      best_longer = longer - shorter;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string name_hint(const std::string& name, std::vector<std::string> known) {
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  if (known.empty()) return {};
  if (const auto near = nearest_name(name, known)) return "did you mean \"" + *near + "\"?";
  std::string all;
  for (const std::string& each : known) all += (all.empty() ? "" : ", ") + each;
  return "known here: " + all;
}

}  // namespace pomona
