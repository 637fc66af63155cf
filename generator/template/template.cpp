#include "generator/template/template.h"

#include <algorithm>

namespace pomona {

HeightRange drawn_heights(const Template& fruit) {
  HeightRange range;
  bool found = false;
  const auto add = [&](const Curve& curve) {
    for (const glm::dvec2& p : curve.points) {
      range = found ? HeightRange{std::min(range.low, p.y), std::max(range.high, p.y)} : HeightRange{p.y, p.y};
      found = true;
    }
  };
  for (const SurfaceSketch& surface : fruit.surfaces) add(surface.vertical);
  for (const SheetSketch& sheet : fruit.sheets) {
    add(sheet.inner);
    add(sheet.outer);
  }
  return range;
}

int fold_count(const Template& fruit) {
  const auto* folds = std::get_if<FoldSymmetry>(&fruit.symmetry);
  return folds ? static_cast<int>(folds->fold_angles.size()) : 1;
}

std::string words_of(const std::string& name) {
  std::string words = name;
  std::replace(words.begin(), words.end(), '_', ' ');
  std::replace(words.begin(), words.end(), '-', ' ');
  return words;
}

}  // namespace pomona
