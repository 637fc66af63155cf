// The pieces of a scene in groups, as an outliner shows them: by entry, and inside an entry by fruit.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace pomona {

/// The groups of a piece; unknown ones are empty.
struct PiecePath {
  std::string entry;    ///< entry of the scene: "tomato-wedges"
  std::string variant;  ///< the fruit: "tomato-wedges-3"
};

struct PieceGroup {
  struct Member {
    std::size_t item = 0;               ///< index of a piece, unless
    std::shared_ptr<PieceGroup> group;  ///< the member is a group
  };
  std::string name;
  std::vector<Member> members;  ///< in the order in which they first come
};

/// All pieces: those of an entry are a group, and within it those of one fruit, if there are several. Outside of
/// entries the same holds of fruits. The outermost group has no name.
PieceGroup grouped(std::span<const PiecePath> pieces);

}  // namespace pomona
