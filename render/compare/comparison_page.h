// A page that shows how two pictures differ.
#pragma once

#include <string>

#include "render/compare/comparison.h"

namespace pomona {

struct ComparedPictures {
  std::string title;
  std::string reference_name, result_name;
  const TransparentImage& reference;
  const TransparentImage& result;
};

/// HTML that needs no other file: reference, result and FLIP's map side by side, the figures, and the limits. The
/// pointer over the result shows the reference in its place.
std::string comparison_page(const ComparedPictures& pictures, const Comparison& comparison, const Tolerance& tolerance);

}  // namespace pomona
