// A .glb that every viewer shows, with its fruit's asset for cutting (docs/reference/asset.md, "In glTF").
#pragma once

#include <string>
#include <string_view>

namespace pomona {

/// `glb` with `asset`, the bytes of a .pomona, in a further view of its buffer, which the file's extension
/// POMONA_cuttable names; not required. Places in the asset are those of the glTF's scene.
/// \throws Error (bad_data) for bytes that are no .glb, or exceed the 4 GB of the format.
std::string with_asset(std::string_view glb, std::string_view asset);

}  // namespace pomona
