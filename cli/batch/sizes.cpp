#include "cli/batch/sizes.h"

#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include "generator/base/error.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

std::optional<int> whole_number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || text.front() == '-') return {};
  return value;
}

}  // namespace

Shard parse_shard(const std::string& text) {
  if (text.empty()) return {};
  const std::string hint = "write I/N, with I from 1 to N, as in --shard 3/8";
  const std::size_t slash = text.find('/');
  const auto number = whole_number(std::string_view(text).substr(0, slash));
  const auto count = slash == std::string::npos ? std::nullopt : whole_number(std::string_view(text).substr(slash + 1));
  if (!number || !count) throw Error(ExitStatus::usage, "--shard " + text + " is no share", hint);
  if (*count < 1 || *count > max_shards || *number < 1 || *number > *count)
    throw Error(ExitStatus::usage, "--shard " + text + " is out of range", hint);
  return {*number, *count};
}

std::uint64_t parse_memory(const std::string& text) {
  if (text.empty()) return 0;
  constexpr std::pair<std::string_view, double> units[] = {{"GB", 1e9}, {"MB", 1e6}, {"G", 1e9}, {"M", 1e6}};
  for (const auto& [unit, bytes] : units) {
    if (!text.ends_with(unit)) continue;
    const auto number = parse_number(std::string_view(text).substr(0, text.size() - unit.size()));
    if (number && *number > 0 && *number * bytes <= 1e15) return static_cast<std::uint64_t>(*number * bytes);
  }
  throw Error(ExitStatus::usage, "--memory " + text + " is no size", "write 2GB or 500MB");
}

}  // namespace pomona
