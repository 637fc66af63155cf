// The section as PLY (docs/reference/formats.md).
#pragma once

#include <string>

#include "generator/cut/section/cross_section.h"

namespace pomona {

/// The bytes of a binary little-endian PLY: float x y z, uchar red green blue, float r g b (linear), uchar
/// interior, int part; faces with int cut; part names as comments.
std::string write_section(const CrossSection& section);

}  // namespace pomona
