// What CSS does to the geometry of a drawing. It is not followed, since Inkscape writes attributes instead, but told.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pomona {

/// A selector of a style sheet whose rule moves what it styles, or gives it its shape.
struct SvgStyleRule {
  std::string selector;  ///< its last part, which is about the element itself: "path.cut"
  std::vector<std::string> properties;
};

/// The rules of a style sheet that have to do with geometry. What a mouse does (":hover") counts for nothing.
std::vector<SvgStyleRule> geometry_rules(std::string_view sheet);

/// An element as a style sees it.
struct SvgStyled {
  std::string_view tag, id;
  std::string_view classes;  ///< separated by blanks
  std::string_view style;    ///< its own
};

/// Why the style makes an element's place or shape another than its attributes say; empty if it does not.
std::string style_fault(const SvgStyled& element, const std::vector<SvgStyleRule>& rules);

}  // namespace pomona
