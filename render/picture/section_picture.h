// Pictures of cross-sections, drawn on the CPU; their bytes are reproducible.
#pragma once

#include <optional>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/cut/section/cross_section.h"
#include "generator/template/ink_style.h"
#include "render/image/image.h"
#include "render/picture/section_layout.h"
#include "render/picture/section_parts.h"
#include "render/plate/plate.h"
#include "render/style/look.h"
#include "render/style/style.h"

namespace pomona {

struct SectionPictureOptions {
  int width = 800;
  int height = 600;
  double dpi = 0;             ///< pixels per inch of an .svg on paper; 0 = not given
  double margin = 0.05;       ///< around all faces and between them, as a share of the shorter side
  PlateText text = {};        ///< texts of a plate
  OutsideParts outside = {};  ///< for a plate's labels of parts that appear only as a rim
  Threads threads{};
};

/// The layout of a section's picture.
class SectionSheet {
 public:
  /// \param section must outlive it. \throws Error (usage) for sizes that are not 1 to max_picture_side.
  SectionSheet(const CrossSection& section, const Style& style, const SectionPictureOptions& options);

  const std::vector<PlacedFace>& faces() const { return faces_; }

  /// The parts of a plate around the faces, if the style asks for a plate; else nothing.
  std::vector<PlateLayer> plate_layers() const;

 private:
  const CrossSection& section_;
  OutsideParts outside_;
  int width_, height_;
  std::optional<Plate> plate_;
  std::vector<PlacedFace> faces_;
};

/// The faces on their paper, for a given layout: draw_section() without the parts of a plate.
Image draw_faces(const CrossSection& section, const std::vector<PlacedFace>& faces, const Look& look,
                 const InkStyle& ink, const Style& style, const SectionPictureOptions& options);

/// The same only in paint, whatever the style says about ink and marks.
Image paint_faces(const CrossSection& section, const std::vector<PlacedFace>& faces, const Look& look,
                  const InkStyle& ink, Style style, const SectionPictureOptions& options);

/// Every cut face from the front (from the knife's positive side, with +Y upwards, or -Z for a horizontal face);
/// several faces in rows, in cut order and at one scale. The bytes are the same for any number of threads, on any
/// machine. A section without triangles gives empty paper. If the style asks for a plate, the faces leave room for its
/// parts. \throws Error (usage) for sizes that are not 1 to max_picture_side.
Image draw_section(const CrossSection& section, const Look& look, const InkStyle& ink, const Style& style,
                   const SectionPictureOptions& options = {});

}  // namespace pomona
