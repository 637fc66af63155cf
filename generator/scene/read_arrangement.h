// Where pieces lie, as scene files spell it.
#pragma once

#include "generator/scene/settle/piece_arrangement.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// The table `where` of an entry; what is wrong is noted in the document.
PieceArrangement read_arrangement(const TomlTable& table);

}  // namespace pomona
