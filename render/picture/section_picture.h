// Pictures of bare cross-sections, drawn on the CPU and exact to the byte.
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
  double dpi = 0;             ///< pixels per inch of what an .svg is on paper; 0 = unsaid
  double margin = 0.05;       ///< around all faces and between them, share of the shorter side
  PlateText text = {};        ///< what a plate says
  OutsideParts outside = {};  ///< for a plate's labels of what is rim alone
  Threads threads{};
};

/// Where everything goes in the picture of a section.
class SectionSheet {
 public:
  /// \param section must outlive it. \throws Error (usage) for sizes that are not 1 to max_picture_side.
  SectionSheet(const CrossSection& section, const Style& style, const SectionPictureOptions& options);

  const std::vector<PlacedFace>& faces() const { return faces_; }

  /// What stands around the faces where the style asks for a plate; else nothing.
  std::vector<PlateLayer> plate_layers() const;

 private:
  const CrossSection& section_;
  OutsideParts outside_;
  int width_, height_;
  std::optional<Plate> plate_;
  std::vector<PlacedFace> faces_;
};

/// The faces, laid out already, on their paper: draw_section() without what a plate adds.
Image draw_faces(const CrossSection& section, const std::vector<PlacedFace>& faces, const Look& look,
                 const InkStyle& ink, const Style& style, const SectionPictureOptions& options);

/// The same in paint alone, whatever the style says of ink and marks.
Image paint_faces(const CrossSection& section, const std::vector<PlacedFace>& faces, const Look& look,
                  const InkStyle& ink, Style style, const SectionPictureOptions& options);

/// Every cut face flat and front on (seen from the knife's positive side, +Y upwards, or -Z where the face lies
/// level), several faces in rows, in cut order and at one scale. The same bytes for any number of threads, on any
/// machine. A section without triangles leaves the paper empty. Where the style asks for a plate, the faces make room
/// for what stands around them. \throws Error (usage) for sizes that are not 1 to max_picture_side.
Image draw_section(const CrossSection& section, const Look& look, const InkStyle& ink, const Style& style,
                   const SectionPictureOptions& options = {});

}  // namespace pomona
