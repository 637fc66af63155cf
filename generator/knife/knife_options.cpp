#include "generator/knife/knife_options.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/units.h"

namespace pomona {

namespace {

/// "a=1, b=2 and c=3".
std::string listed(std::span<const std::string> options) {
  std::string list;
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (i > 0) list += i + 1 == options.size() ? " and " : ", ";
    list += options[i];
  }
  return list;
}

bool names(const std::string& example, std::string_view name) {
  return example.size() > name.size() && example.starts_with(name) && example[name.size()] == '=';
}

std::string_view without_blanks_around(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

std::vector<std::string_view> split_at_commas(std::string_view text) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t comma = text.find(',');
    parts.push_back(without_blanks_around(text.substr(0, comma)));
    if (comma == std::string_view::npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

KnifeOptions::KnifeOptions(std::span<const std::string_view> words, std::span<const std::string> known) {
  for (const std::string_view word : words) {
    const std::size_t equals = word.find('=');
    if (equals != std::string_view::npos) {
      options_.push_back({word.substr(0, equals), {word.substr(equals + 1)}});
    } else if (!options_.empty()) {
      options_.back().values.push_back(word);
    } else {
      throw BadKnife("has \"" + std::string(word) + "\" where an option such as at=0,4cm,0 should be");
    }
  }
  check(known);
}

void KnifeOptions::check(std::span<const std::string> known) const {
  for (const Option& option : options_) {
    const auto is_meant = [&](const std::string& example) { return names(example, option.name); };
    if (std::none_of(known.begin(), known.end(), is_meant)) {
      throw BadKnife("has no option \"" + std::string(option.name) + "\"", "it has " + listed(known));
    }
    if (find(option.name) != &option) throw BadKnife("says " + std::string(option.name) + " twice");
  }
}

const KnifeOptions::Option* KnifeOptions::find(std::string_view name) const {
  const auto found =
      std::find_if(options_.begin(), options_.end(), [&](const Option& option) { return option.name == name; });
  return found == options_.end() ? nullptr : &*found;
}

std::optional<double> KnifeOptions::length(std::string_view name, double max) const {
  const Option* option = find(name);
  if (!option) return std::nullopt;
  const std::optional<double> value =
      option->values.size() == 1 ? parse_length(option->values[0]) : std::optional<double>();
  if (!value || !(*value > 0) || *value > max) {
    throw BadKnife("needs a length above 0 and up to " + std::to_string(static_cast<int>(max)) + "m for " +
                   std::string(name));
  }
  return *value;
}

std::optional<int> KnifeOptions::axis(std::string_view name) const {
  const Option* option = find(name);
  if (!option) return std::nullopt;
  constexpr std::string_view axes = "xyz";
  const std::string_view value = option->values.size() == 1 ? option->values[0] : std::string_view();
  const std::size_t found = value.size() == 1 ? axes.find(value) : std::string_view::npos;
  if (found == std::string_view::npos) throw BadKnife("needs x, y or z for " + std::string(name));
  return static_cast<int>(found);
}

template <typename Parse>
std::optional<glm::dvec3> KnifeOptions::triple(std::string_view name, const Parse& parse,
                                               const std::string& example) const {
  const Option* option = find(name);
  if (!option) return std::nullopt;
  glm::dvec3 values(0);
  for (int i = 0; i < 3; ++i) {
    const std::optional<double> value =
        option->values.size() == 3 ? parse(option->values[static_cast<std::size_t>(i)]) : std::optional<double>();
    if (!value || std::fabs(*value) > 100) throw BadKnife("needs three values from -100 to 100, such as " + example);
    values[i] = *value;
  }
  return values;
}

std::optional<glm::dvec3> KnifeOptions::place(std::string_view name) const {
  return triple(name, parse_length, std::string(name) + "=0,4cm,0");
}

std::optional<glm::dvec3> KnifeOptions::direction(std::string_view name) const {
  const std::optional<glm::dvec3> way = triple(name, parse_number, std::string(name) + "=0,1,0");
  if (way && !(glm::length(*way) > 1e-6)) throw BadKnife("has an axis of length zero");
  return way ? glm::normalize(*way) : way;
}

}  // namespace pomona
