#include "generator/surface/file/ply_names.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <system_error>
#include <utility>

namespace pomona {

namespace {

std::optional<std::pair<std::size_t, std::string>> name_in(std::string_view comment, std::string_view what) {
  if (!comment.starts_with(what)) return {};
  comment.remove_prefix(what.size());
  std::size_t index = 0;
  const auto [end, status] = std::from_chars(comment.data(), comment.data() + comment.size(), index);
  if (status != std::errc() || static_cast<double>(index) >= max_ply_names) return {};
  comment.remove_prefix(static_cast<std::size_t>(end - comment.data()));
  if (!comment.empty() && comment.front() != ' ') return {};
  if (!comment.empty()) comment.remove_prefix(1);
  return std::pair(index, std::string(comment));
}

}  // namespace

std::vector<std::string> ply_names(const std::vector<std::string>& comments, std::string_view what,
                                   std::initializer_list<const std::vector<std::int32_t>*> used) {
  std::vector<std::string> names;
  for (const std::string& comment : comments) {
    const auto named = name_in(comment, what);
    if (!named) continue;
    if (names.size() <= named->first) names.resize(named->first + 1);
    names[named->first] = named->second;
  }
  for (const std::vector<std::int32_t>* indices : used)
    for (const std::int32_t index : *indices) names.resize(std::max(names.size(), static_cast<std::size_t>(index) + 1));
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i].empty()) names[i] = std::string(what) + std::to_string(i);
  return names;
}

}  // namespace pomona
