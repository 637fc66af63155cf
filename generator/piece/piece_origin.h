// The origin of a piece: everything that `pomona cut` needs to make it again.
#pragma once

#include <string>
#include <vector>

#include "generator/base/random.h"
#include "generator/compose/grow.h"

namespace pomona {

struct PieceOrigin {
  // The fruit that was grown.
  std::string source = {};   ///< the template's name or path, as an argument of `pomona cut`; empty = not known
  VariantKey key = {};       ///< key of the variant
  GrowOptions growing = {};  ///< options with which the variant was grown

  // How it was cut.
  std::vector<std::string> knives = {};  ///< knives in their order, as the user wrote them; none = a whole fruit
  bool coarse = false;                   ///< cut with `coarse_cut`, as in scenes, instead of the default options
  int number = 0;                        ///< number of the piece in the order of cutting, from 1; 0 = not known
  int pieces = 0;                        ///< number of all pieces of the cut, with crumbs

  // The fruit and the scene to which it belongs.
  std::string fruit = {};    ///< the template's own name: "tomato"
  std::string entry = {};    ///< entry of the scene: "tomato-wedges"; empty outside scenes
  std::string variant = {};  ///< name of the individual fruit: "tomato-wedges-3"
};

/// A template's name or path as it was written, for PieceOrigin::source. Of an absolute path, which means nothing on
/// another machine, only the file's name.
std::string source_word(const std::string& name_or_path);

/// The knives, separated by spaces.
std::string knives_text(const PieceOrigin& origin);

}  // namespace pomona
