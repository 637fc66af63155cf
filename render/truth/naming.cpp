#include "render/truth/naming.h"

#include <map>
#include <utility>

#include "generator/base/error.h"

namespace pomona {

namespace {

constexpr std::size_t max_numbers = 65535;

/// The number of a key in a list; adds `entry` if the key is new.
template <typename Key, typename Entry>
std::uint16_t numbered(std::map<Key, std::uint16_t>& known, const Key& key, std::vector<Entry>& list, Entry entry) {
  const auto [place, is_new] = known.try_emplace(key, static_cast<std::uint16_t>(list.size() + 1));
  if (is_new) list.push_back(std::move(entry));
  return place->second;
}

void refuse_large_organs(const Solid& solid) {
  for (const Organ& organ : solid.organs) {
    if (static_cast<std::size_t>(organ.instance) <= max_numbers) continue;
    throw Error(ExitStatus::usage,
                "--aov: \"" + solid.name + "\" has an organ of the number " + std::to_string(organ.instance),
                "ids have 16 bits: at most 65535");
  }
}

}  // namespace

TruthNaming truth_naming(const Scene& scene) {
  if (scene.instances.size() > max_numbers || scene.solids.size() > max_numbers) {
    throw Error(ExitStatus::usage, "--aov: the scene has " + std::to_string(scene.instances.size()) + " pieces",
                "ids have 16 bits: at most 65535");
  }
  TruthNaming names;
  std::map<std::string, std::uint16_t> species, fruits;
  std::map<std::pair<std::uint16_t, std::string>, std::uint16_t> parts;
  for (const Solid& solid : scene.solids) {
    refuse_large_organs(solid);
    // Solids without a template use their own name.
    const std::string& kind = solid.origin.fruit.empty() ? solid.name : solid.origin.fruit;
    const std::string& fruit = solid.origin.variant.empty() ? solid.name : solid.origin.variant;
    const std::uint16_t of_kind = numbered(species, kind, names.species, {kind});
    names.fruit_of_solid.push_back(numbered(fruits, fruit, names.fruits, {fruit, of_kind}));

    std::vector<std::uint16_t>& own = names.parts_of_solid.emplace_back();
    for (const std::string& part : solid.look->part_names)
      own.push_back(numbered(parts, {of_kind, part}, names.parts, {part, of_kind}));
  }
  return names;
}

}  // namespace pomona
