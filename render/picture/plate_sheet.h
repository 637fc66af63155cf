// A plate with several figures of one fruit: whole, cut, its section, a seed; with numbered parts and a legend.
#pragma once

#include <string>
#include <vector>

#include "render/image/image.h"
#include "render/plate/part_map.h"
#include "render/plate/plate.h"
#include "render/style/style.h"

namespace pomona {

/// A figure of a plate.
struct SheetFigure {
  Image picture;                ///< on plain paper of the style's colour, as large as its room
  PartMap parts;                ///< empty = no numbered parts
  double pixels_per_metre = 0;  ///< 0 = without a scale bar
};

/// The layout of a plate.
class PlateSheet {
 public:
  /// \param style its plate gives the margins and letters; without a plate, the defaults are used.
  /// \param part_names all part names that may occur.
  /// \param figures 1 to 4.
  PlateSheet(const Style& style, PlateText text, const std::vector<std::string>& part_names, int figures, int width,
             int height);

  /// The room of each figure, pixels; the figures are in rows of two.
  const std::vector<PlateBox>& rooms() const { return rooms_; }

  /// The plate: figures on the style's paper, each with its letter and its scale; a number at each part, in the figure
  /// that shows it best; the legend, the title and the species. The same figures give the same bytes.
  Image drawn(const std::vector<SheetFigure>& figures) const;

 private:
  /// A part with its number, and the position to which the number points.
  struct Numbered {
    int number = 0;
    std::string name;
    std::size_t figure = 0;
    ShownPart shown;
  };
  std::vector<Numbered> numbered(const std::vector<SheetFigure>& figures) const;
  std::vector<PlateLayer> layers(const std::vector<SheetFigure>& figures) const;
  void add_numbers(const std::vector<Numbered>& parts, const SheetFigure& figure, std::size_t index,
                   std::vector<PlateLayer>& layers) const;
  void add_bar(const SheetFigure& figure, std::size_t index, PlateLayer& letters) const;
  void add_legend(const std::vector<Numbered>& parts, PlateLayer& letters) const;
  void add_title(PlateLayer& letters) const;
  double hair() const;  ///< width of lines, pixels

  Style style_;
  PlateStyle plate_;
  PlateText text_;
  int width_, height_;
  double em_;                     ///< em of letters, pixels
  double column_ = 0;             ///< width of one of the legend's columns, pixels
  int columns_ = 1;               ///< number of the legend's columns
  double legend_ = 0;             ///< its first base line
  double title_ = 0, latin_ = 0;  ///< base lines
  std::vector<PlateBox> rooms_;
};

}  // namespace pomona
