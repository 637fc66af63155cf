// The [ripeness] and [browning] of a template file, and the colours of its [variation].
#pragma once

#include "generator/template/browning_sketch.h"
#include "generator/template/color_variation.h"
#include "generator/template/ripeness_sketch.h"
#include "generator/template/template.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// `fruit` has its parts and surfaces already: they are what the tables speak of.
RipenessSketch read_ripeness(const TomlTable& table, const Template& fruit);
BrowningSketch read_browning(const TomlTable& table, const Template& fruit);

/// `color` and `ripeness` of [variation]; the other keys there are read_variation.h's.
ColorVariation read_color_variation(const TomlTable& table, const Template& fruit);

}  // namespace pomona
