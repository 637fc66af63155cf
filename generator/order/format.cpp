#include "generator/order/format.h"

#include <algorithm>

#include "generator/base/small_ending.h"

namespace pomona {

namespace {

bool is_one_of(Format format, const std::vector<Format>& formats) {
  return std::find(formats.begin(), formats.end(), format) != formats.end();
}

}  // namespace

const std::vector<std::string>& format_names() {
  static const std::vector<std::string> names = {"ply", "glb",  "usda", "obj",    "stl", "pov", "png",
                                                 "svg", "json", "html", "pomona", "xml", "urdf"};
  return names;
}

const std::string& name_of(Format format) { return format_names()[static_cast<std::size_t>(format)]; }

std::optional<Format> format_called(std::string_view ending) {
  const std::string lower = in_small_letters(std::string(ending));
  const std::vector<std::string>& names = format_names();
  const auto found = std::find(names.begin(), names.end(), lower);
  if (found == names.end()) return std::nullopt;
  return static_cast<Format>(found - names.begin());
}

std::string endings_of(const std::vector<Format>& formats) {
  std::string list;
  for (std::size_t i = 0; i < format_names().size(); ++i) {
    const auto format = static_cast<Format>(i);
    if (is_one_of(format, formats)) list += (list.empty() ? "." : " .") + name_of(format);
  }
  return list;
}

bool any_is(const std::vector<Output>& outputs, const std::vector<Format>& formats) {
  return std::any_of(outputs.begin(), outputs.end(),
                     [&](const Output& output) { return is_one_of(output.format, formats); });
}

bool all_are(const std::vector<Output>& outputs, const std::vector<Format>& formats) {
  return std::all_of(outputs.begin(), outputs.end(),
                     [&](const Output& output) { return is_one_of(output.format, formats); });
}

}  // namespace pomona
