// The cuts that are compared: variants and knives, and the stages whose results have hashes.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>

namespace pomona {

/// The stages in order; those with a dot are files. Look at the first that differs.
inline constexpr std::array<const char*, 8> verified_stages = {"curves",  "surfaces", "places", "triangles",
                                                               "colours", ".ply",     ".glb",   ".png"};

/// The number of hexadecimal digits of each stage's SHA-256: different results look equal once in 4 000 000 000 times.
constexpr std::size_t hash_digits = 8;
using StageHashes = std::array<std::string, verified_stages.size()>;

/// Planes, half-planes, a prism, a closed knife, and one that follows the skin: all ways of cutting.
inline constexpr std::array<const char*, 6> verified_knives = {"half",         "plane:1,2,3,1cm", "wedges:5",
                                                               "crinkle:30mm", "ball:30mm",       "peel:3mm"};

constexpr std::uint64_t verified_seeds = 10;  ///< number of seeds, from 0, which is as drawn

/// A variant and its knife.
struct VerifiedCut {
  std::string fruit;  ///< a template's name
  std::uint64_t seed = 0;
  std::string knife;

  auto operator<=>(const VerifiedCut&) const = default;
};

/// One seed of ten for each template and knife, always the same.
bool in_the_tenth(const VerifiedCut& cut);

}  // namespace pomona
