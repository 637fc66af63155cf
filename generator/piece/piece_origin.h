// Where a piece comes from: all that `pomona cut` must be told to make it again.
#pragma once

#include <string>
#include <vector>

#include "generator/base/random.h"
#include "generator/piece/grow.h"

namespace pomona {

struct PieceOrigin {
  // What was grown.
  std::string source = {};   ///< the template as `pomona cut` is told it, a name or a path; empty: nobody has said
  VariantKey key = {};       ///< of the variant
  GrowOptions growing = {};  ///< how the variant strays from the template

  // How it was cut.
  std::vector<std::string> knives = {};  ///< one after another, as they were written; none leave the fruit whole
  bool coarse = false;                   ///< by `coarse_cut`, as scenes are, instead of the default
  int number = 0;                        ///< of the piece in the order in which it was cut, from 1; 0: nobody has said
  int pieces = 0;                        ///< that the cut left, crumbs too

  // Where it belongs.
  std::string fruit = {};    ///< the template's own name: "tomato"
  std::string entry = {};    ///< of the scene: "tomato-wedges"; empty outside scenes
  std::string variant = {};  ///< "tomato-wedges-3"; what pieces of one fruit have in common
};

/// A template's name or path as it was written, for PieceOrigin::source; of a path from the root, which means nothing
/// elsewhere, the file's name alone.
std::string source_word(const std::string& name_or_path);

/// The knives, parted by spaces.
std::string knives_text(const PieceOrigin& origin);

}  // namespace pomona
