// A plate with several figures of one fruit: whole, cut, its section, a seed; their parts numbered, and a legend.
#pragma once

#include <string>
#include <vector>

#include "render/image/image.h"
#include "render/plate/part_map.h"
#include "render/plate/plate.h"
#include "render/style/style.h"

namespace pomona {

/// A picture of a figure on bare paper of the style's colour, as large as its room.
struct SheetFigure {
  Image picture;
  PartMap parts;                ///< empty where none are to be numbered
  double pixels_per_metre = 0;  ///< 0 = without a bar
};

/// A sheet before anything is drawn: how large each figure is to be.
class PlateSheet {
 public:
  /// \param style whose plate says margins and letters; one without a plate has the usual ones.
  /// \param part_names all that may come to be named. \param figures 1 to 4.
  PlateSheet(const Style& style, PlateText text, const std::vector<std::string>& part_names, int figures, int width,
             int height);

  /// Where each figure goes, in pixels: in rows of two.
  const std::vector<PlateBox>& rooms() const { return rooms_; }

  /// The sheet: figures on the style's paper, each with its letter and its scale; numbers at parts, each part numbered
  /// where it shows best; the legend, the title and the species. The same bytes for the same figures.
  Image drawn(const std::vector<SheetFigure>& figures) const;

 private:
  /// A part with its number, and where it is pointed at.
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
  double em_;                     ///< of letters, pixels
  double column_ = 0;             ///< width of one of the legend's columns, pixels
  int columns_ = 1;               ///< of the legend
  double legend_ = 0;             ///< its first base line
  double title_ = 0, latin_ = 0;  ///< base lines
  std::vector<PlateBox> rooms_;
};

}  // namespace pomona
