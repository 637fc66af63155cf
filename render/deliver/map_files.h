// The maps of textures as files of their own, for engines that read no glTF.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "render/export/output.h"
#include "render/texture/bake.h"

namespace pomona {

/// For each solid NAME.color.png, and where it has maps NAME.normal.png, NAME.orm.png, NAME.thickness.png and
/// NAME.part.png; and parts.json, which says what the parts' numbers stand for. \param folder need not be there yet.
std::vector<OutputFile> map_files(std::span<const BakedSolid> baked, const std::filesystem::path& folder);

}  // namespace pomona
