// The colours of nodes as differences from a guess. They are nine tenths of an asset, and smooth except at surfaces.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "render/page/asset.h"

namespace pomona {

/// Differences of smooth and of rough places have separate streams, because each packs better by itself.
constexpr std::size_t node_streams = 4;

/// Bytes before the streams: the length of each in four bytes, red first.
constexpr std::size_t node_lengths = 3 * node_streams * 4;

/// Differences of 0 and 1 are exact, then every third stands for those beside it, up to this code; from there on every
/// fifth. 86 leaves no fifths.
constexpr int all_thirds = 86, thirds_of_first_format = 8;

/// One byte a channel and node that is inside (winding not 0), all of red first. Nodes go from coarse to fine: those
/// whose coordinates are all multiples of 16 in order, then, as the step halves to 1, those with one odd coordinate in
/// steps, those with two, those with three. The guess is a mean of the neighbours a step away along odd coordinates,
/// which are known by then: a pair counts the less the more its two differ, since then a surface passes between them.
/// By the largest of these differences (1, 6, 24 or more) a node belongs to a stream; without a pair to the last. Large
/// differences from the guess are rounded, so that values come back within 1 of 255, or 2 where there are fifths.
std::vector<std::uint8_t> coded_nodes(const Asset& asset, int thirds = all_thirds);

/// The opposite; `coded` has node_lengths + 3 bytes for each node that is inside. Nothing if its streams do not fit.
std::optional<std::vector<glm::u8vec3>> decoded_nodes(const Asset& asset, std::span<const std::uint8_t> coded,
                                                      int thirds = all_thirds);

}  // namespace pomona
