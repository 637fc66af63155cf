// Reads arrangements of pieces from scene files.
#pragma once

#include "generator/scene/settle/piece_arrangement.h"
#include "generator/template/read/toml_document.h"

namespace pomona {

/// The table `where` of an entry. Errors are noted in the document.
PieceArrangement read_arrangement(const TomlTable& table);

}  // namespace pomona
