#include "generator/text/svg_style.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "generator/base/small_ending.h"
#include "generator/text/svg_shapes.h"

namespace pomona {

namespace {

constexpr std::string_view blanks = " \t\r\n\f";

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

std::string without_comments(std::string_view sheet) {
  std::string text;
  while (true) {
    const std::size_t begin = sheet.find("/*");
    text += sheet.substr(0, begin);
    if (begin == std::string_view::npos) return text;
    const std::size_t end = sheet.find("*/", begin + 2);
    if (end == std::string_view::npos) return text;
    sheet.remove_prefix(end + 2);
    text += ' ';
  }
}

/// Calls `use` with each part between the separators.
template <typename Use>
void for_each_part(std::string_view text, std::string_view separators, const Use& use) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(separators), text.size());
    if (const std::string_view part = without_blanks(text.substr(0, end)); !part.empty()) use(part);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

bool moves(std::string_view property) {
  constexpr std::string_view names[] = {"transform", "transform-origin", "transform-box", "translate", "rotate",
                                        "scale",     "offset-path"};
  return std::find(std::begin(names), std::end(names), property) != std::end(names);
}

bool shapes(std::string_view property, std::string_view tag) {
  if (tag == "path") return property == "d";
  if (tag == "image" || tag == "use") tag = "rect";
  const auto lengths = lengths_of(tag);
  return std::find(lengths.begin(), lengths.end(), property) != lengths.end();
}

bool is_of_geometry(std::string_view property) {
  constexpr std::array tags{"path", "rect", "circle", "ellipse"};
  return moves(property) ||
         std::any_of(tags.begin(), tags.end(), [&](const char* tag) { return shapes(property, tag); });
}

/// The properties of "a: b; c: d" that have to do with geometry, and say something.
std::vector<std::string> geometry_properties(std::string_view declarations) {
  std::vector<std::string> found;
  for_each_part(declarations, ";", [&](std::string_view declaration) {
    const std::size_t colon = declaration.find(':');
    if (colon == std::string_view::npos) return;
    const std::string property = in_small_letters(std::string(without_blanks(declaration.substr(0, colon))));
    const std::string value = in_small_letters(std::string(without_blanks(declaration.substr(colon + 1))));
    if (value != "none" && value != "auto" && is_of_geometry(property)) found.push_back(property);
  });
  return found;
}

/// A selector's last part, without what it says of states and attributes; empty if it is for what a mouse does.
std::string_view own_part(std::string_view selector) {
  for (const std::string_view state : {":hover", ":active", ":focus", ":target", ":visited"})
    if (selector.find(state) != std::string_view::npos) return {};
  selector = selector.substr(0, selector.find_first_of(":["));
  const std::size_t before = without_blanks(selector).find_last_of(" \t\r\n\f>+~|");
  selector = without_blanks(selector);
  if (before != std::string_view::npos) selector.remove_prefix(before + 1);
  return selector.empty() ? "*" : selector;
}

bool is_among(std::string_view name, std::string_view names) {
  bool found = false;
  for_each_part(names, blanks, [&](std::string_view one) { found = found || one == name; });
  return found;
}

/// \param selector "*", "path", ".cut", "#skin", or several of these in one.
bool is_meant(const SvgStyled& element, std::string_view selector) {
  const std::string_view tag = selector.substr(0, selector.find_first_of(".#"));
  if (!tag.empty() && tag != "*" && tag != element.tag) return false;
  selector.remove_prefix(tag.size());
  while (!selector.empty()) {
    const bool is_class = selector.front() == '.';
    const std::string_view name = selector.substr(1, selector.find_first_of(".#", 1) - 1);
    if (is_class ? !is_among(name, element.classes) : name != element.id) return false;
    selector.remove_prefix(1 + name.size());
  }
  return true;
}

/// What the properties do to an element of this kind.
std::string fault_of(const std::vector<std::string>& properties, std::string_view tag) {
  if (std::any_of(properties.begin(), properties.end(), moves)) return "is moved by its style (CSS)";
  const auto is_shape = [&](const std::string& property) { return shapes(property, tag); };
  return std::any_of(properties.begin(), properties.end(), is_shape) ? "has its shape from its style (CSS)" : "";
}

}  // namespace

std::vector<SvgStyleRule> geometry_rules(std::string_view sheet) {
  const std::string text = without_comments(sheet);
  std::vector<SvgStyleRule> rules;
  std::size_t begin = 0;  // behind the brace or semicolon before
  for (std::size_t at = text.find_first_of("{};"); at != std::string::npos; at = text.find_first_of("{};", at + 1)) {
    const std::string_view selectors = std::string_view(text).substr(begin, at - begin);
    begin = at + 1;
    const std::size_t end = text[at] == '{' ? text.find_first_of("{}", at + 1) : std::string::npos;
    if (end == std::string::npos || text[end] == '{') continue;  // "@media ... {" holds rules, no declarations
    const std::vector<std::string> properties =
        geometry_properties(std::string_view(text).substr(at + 1, end - at - 1));
    if (properties.empty()) continue;
    for_each_part(selectors, ",", [&](std::string_view selector) {
      if (const std::string_view own = own_part(selector); !own.empty())
        rules.push_back({std::string(own), properties});
    });
  }
  return rules;
}

std::string style_fault(const SvgStyled& element, const std::vector<SvgStyleRule>& rules) {
  const std::string own = fault_of(geometry_properties(element.style), element.tag);
  if (!own.empty()) return own;
  for (const SvgStyleRule& rule : rules) {
    const std::string fault = fault_of(rule.properties, element.tag);
    if (!fault.empty() && is_meant(element, rule.selector)) return fault;
  }
  return {};
}

}  // namespace pomona
