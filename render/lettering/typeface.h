// Typefaces: letters as outlines, for plates.
#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace pomona {

/// Closed lines, y down; what they turn around, in either direction, is inside.
using Outline = std::vector<std::vector<glm::dvec2>>;

/// One face of the type, read from its file (render/lettering/*.letters). Outlines are not hinted: a line of text is
/// the same at any size, and on any machine.
class Typeface {
 public:
  /// "capitals": capitals, and small capitals in place of small letters. "italic": for labels.
  explicit Typeface(std::string_view name);

  /// Width of a line of text (UTF-8) in ems. `spacing`: added between letters, ems.
  double width(std::string_view text, double spacing = 0) const;

  /// The line's outline, beginning at `start` on its base line. A character that the face lacks leaves a blank.
  Outline outline(std::string_view text, const glm::dvec2& start, double em, double spacing = 0) const;

 private:
  struct Letter {
    double advance = 0;  ///< ems
    Outline outline;     ///< ems
  };
  struct Place {
    const Letter* letter = nullptr;
    double at = 0;  ///< ems from the start
  };
  struct SetLine {
    std::vector<Place> places;
    double width = 0;  ///< ems
  };

  void read_line(std::string_view line);
  SetLine set(std::string_view text, double spacing) const;

  double units_ = 1000;  ///< an em
  std::map<std::uint32_t, Letter> letters_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> kern_;  ///< ems
};

}  // namespace pomona
