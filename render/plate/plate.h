// A botanical plate: the texts and lines around a figure.
#pragma once

#include <string>
#include <vector>

#include "render/image/image.h"
#include "render/lettering/typeface.h"
#include "render/plate/labels.h"
#include "render/style/style.h"

namespace pomona {

struct PlateText {
  std::string title;  ///< "Tomato"
  std::string latin;  ///< "Solanum lycopersicum"; may be empty
};

/// An outline on the paper around a figure, to be filled.
struct PlateMark {
  Outline outline;   ///< pixels, y down
  std::string text;  ///< text of a line of letters; else empty
};

/// Marks of one colour. Overlaps count once.
struct PlateLayer {
  std::string name;  ///< "halos", "lines", "letters"
  Color color{0};
  double opacity = 1;
  std::vector<PlateMark> marks;
};

/// Adds the line from a name to its part, a dot at its end, and a border around both.
/// \param hair width of lines, pixels
void add_leader(const glm::dvec2& from, const glm::dvec2& tip, double hair, PlateLayer& halos, PlateLayer& lines);

/// The layout of a plate.
class Plate {
 public:
  /// \param part_names all names that may become labels; they decide the width of the columns beside the figure
  /// \param style a style with a plate
  Plate(const Style& style, PlateText text, const std::vector<std::string>& part_names, int width, int height);

  /// The room of the figure.
  const PlateBox& figure() const { return figure_; }

  /// The labels of all parts that are visible enough in the drawn figure.
  std::vector<Label> labels(const PartMap& map) const;

  /// A round length, 1, 2 or 5 times a power of ten metres, at this scale.
  struct ScaleBar {
    double metres = 0;
    std::string text;  ///< "2 cm"
    glm::dvec2 start{0};
    double length = 0;  ///< pixels
  };
  ScaleBar scale_bar(double pixels_per_metre) const;

  /// The layers of letters, lines and the bar, in the order in which they are drawn onto a finished picture.
  /// \param pixels_per_metre 0 = no bar
  std::vector<PlateLayer> layers(const PartMap& map, double pixels_per_metre) const;

 private:
  void add_labels(const PartMap& map, PlateLayer& halos, PlateLayer& lines, PlateLayer& letters) const;
  void add_scale_bar(double pixels_per_metre, PlateLayer& letters) const;
  void add_title(PlateLayer& letters) const;
  double hair() const;  ///< width of lines

  PlateStyle style_;
  Color paper_;
  PlateText text_;
  int width_, height_;
  double em_;   ///< em of labels, pixels
  double gap_;  ///< between figure and columns
  PlateBox figure_;
  double bar_height_, title_height_, latin_height_;  ///< base lines
};

/// Draws the layers onto a picture.
void draw(const std::vector<PlateLayer>& layers, Image& image);

}  // namespace pomona
