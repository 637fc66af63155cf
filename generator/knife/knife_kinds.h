// The table of all knives: the name, the ways to write it, and one line of help.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/knife/knife.h"

namespace pomona {

/// One kind of knife as users write it: NAME, or NAME:VALUE, or NAME:VALUE,OPTION=...
struct KnifeKind {
  std::string name;                  ///< "core"
  std::vector<std::string> written;  ///< every way to write it, without options: "core:18mm"
  std::vector<std::string> options;  ///< an example of each: "depth=4cm"
  std::string help;                  ///< one line: along which surface it cuts

  /// Reads what follows the colon. Relative paths start from `folder`.
  /// \throws BadKnife (knife_options.h); those that read files also what read_stroke.h says.
  KnifeCut (*read)(const KnifeKind& kind, std::string_view value, const std::filesystem::path& folder);

  bool takes_value() const { return written.front() != name; }
};

/// All kinds of knives, simple ones first.
const std::vector<KnifeKind>& knife_kinds();

/// The drawing that a knife's text names, "cut #2.svg" of "stroke:cut #2.svg#wave,scale=2mm"; none for other knives.
std::optional<std::string> drawing_of_knife(std::string_view text);

/// How one kind is written, with its options: "core:18mm [,axis=0,1,0] [,depth=4cm]".
std::string written_with_options(const KnifeKind& kind);

/// All ways to write a knife, for hints: "half, across, plane:NX,NY,NZ,D, ...".
std::string known_knives();

/// The table as lines of text for a terminal, each ending in a line break: how a knife is written, what it does,
/// options.
std::string knife_help();

}  // namespace pomona
