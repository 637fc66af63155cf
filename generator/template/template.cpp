#include "generator/template/template.h"

namespace pomona {

int fold_count(const Template& fruit) {
  const auto* folds = std::get_if<FoldSymmetry>(&fruit.symmetry);
  return folds ? static_cast<int>(folds->fold_angles.size()) : 1;
}

}  // namespace pomona
