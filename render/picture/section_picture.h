// Pictures of bare cross-sections, drawn on the CPU and exact to the byte.
#pragma once

#include "generator/base/parallel.h"
#include "generator/cut/cross_section.h"
#include "generator/template/ink_style.h"
#include "render/picture/image.h"
#include "render/plate/plate.h"
#include "render/style/look.h"
#include "render/style/style.h"

namespace pomona {

struct SectionPictureOptions {
  int width = 800;
  int height = 600;
  double margin = 0.05;  ///< around all faces and between them, share of the shorter side
  PlateText text = {};   ///< what a plate says
  Threads threads{};
};

/// Every cut face flat and front on (seen from the knife's positive side, +Y upwards, or -Z where the face lies
/// level), several faces in rows, in cut order and at one scale. The same bytes for any number of threads, on any
/// machine. A section without triangles leaves the paper empty. Where the style asks for a plate, the faces make room
/// for what stands around them. \throws Error (usage) for sizes that are not 1 to max_picture_side.
Image draw_section(const CrossSection& section, const Look& look, const InkStyle& ink, const Style& style,
                   const SectionPictureOptions& options = {});

}  // namespace pomona
