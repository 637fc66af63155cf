// Ink as SVG: for Inkscape and other drawing programs (docs/reference/formats.md).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "generator/cut/section/cross_section.h"
#include "render/marks/mark.h"
#include "render/picture/section_picture.h"
#include "render/strokes/scene_strokes.h"
#include "render/style/look.h"

namespace pomona {

/// The sheet of an .svg: a user unit is a pixel.
struct SvgSheet {
  int width = 0, height = 0;
  double dpi = 0;  ///< pixels per inch: then the drawing has a size in millimetres; 0 = not given
};

/// Hatching or stipple below the strokes, in one ink.
struct SvgMarks {
  std::vector<Mark> marks = {};
  Color ink{0};
};

/// The bytes of an .svg with one layer per instance that has ink, named after it: strokes as filled paths, finer lines
/// below outlines. A user unit is a pixel of the picture that the strokes are for. Same strokes, same bytes.
/// \param provenance for the title, as in ExportOptions. \param plate what stands around the figure: layers above all
/// else, letters as outlines.
std::string write_svg(const Scene& scene, std::span<const SceneStroke> strokes, const SvgSheet& sheet,
                      const std::string& provenance, std::span<const PlateLayer> plate = {},
                      const SvgMarks& marks = {});

/// The bytes of an .svg with a layer "paper" (a picture where it has a grain), a layer "colours" with the faces'
/// colours as paths, grouped by part (section_patches.h), and above it one layer per face with its strokes; above these
/// what a plate adds, as there. A style with marks has a layer "marks" in place of the colours, above a picture of its
/// wash if it asks for one. Exact to the byte, as draw_section() is.
std::string write_section_svg(const CrossSection& section, const Look& look, const InkStyle& ink, const Style& style,
                              const SectionPictureOptions& options, const std::string& provenance);

}  // namespace pomona
