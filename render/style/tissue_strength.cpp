#include "render/style/tissue_strength.h"

namespace pomona {

double tissue_strength(Tissue tissue) {
  switch (tissue) {
    case Tissue::flesh:
      return 2e5;
    case Tissue::gel:
      return 2e3;
    case Tissue::pith:
      return 3e5;
    case Tissue::skin:
      return 2e6;
    case Tissue::leaf:
      return 1e6;
    case Tissue::seed:
      return 3e6;
    case Tissue::shell:
      return 2e7;
    case Tissue::mineral:
      break;
  }
  return 1e6;
}

}  // namespace pomona
