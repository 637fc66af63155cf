#include "cli/batch/asset_work.h"

#include "cli/batch/make_item.h"
#include "cli/exhausted.h"
#include "generator/batch/item_record.h"

namespace pomona {

const ReadyTemplates::Ready& ReadyTemplates::of(std::size_t fruit) {
  std::call_once(once_[fruit], [&] {
    try {
      ready_[fruit].variation.emplace(templates_[fruit].fruit);
    } catch (const std::exception& error) {
      if (exhausted(error)) throw;  // the next one tries again
      ready_[fruit].error = reason_of(error);
    }
  });
  return ready_[fruit];
}

std::vector<RecordedEntry> AssetWork::entries() const {
  std::vector<RecordedEntry> entries;
  for (const PlannedEntry& entry : plan_.entries)
    entries.push_back({entry.wanted.name, entry.items(), entry.items_of_a_variant});
  return entries;
}

std::string AssetWork::recipe(std::size_t entry, std::int64_t number) const {
  const PlannedItem planned = item_at(plan_, entry, number);
  return item_recipe(plan_, planned.variant, planned.item);
}

std::uint64_t AssetWork::memory_of_an_item(std::size_t entry) const {
  return pomona::memory_of_an_item(plan_.entries[entry]);
}

AssetWork::GrownOrNot AssetWork::grown(const BatchVariant& which) {
  const ReadyTemplates::Ready& ready = ready_.of(which.fruit);
  if (!ready.variation) return {{}, ready.error};
  try {
    return {grown_variant(plan_, *ready.variation, which), {}};
  } catch (const std::exception& failure) {
    if (exhausted(failure)) throw;
    return {{}, reason_of(failure)};
  }
}

void AssetWork::make(std::size_t entry, std::span<const std::int64_t> numbers, const Put& put) {
  const BatchVariant which = item_at(plan_, entry, numbers.front()).variant;
  const GrownOrNot fruit = grown(which);
  for (const std::int64_t number : numbers)
    put(make_item(plan_, which, fruit.grown ? &*fruit.grown : nullptr, fruit.error, item_at(plan_, entry, number).item,
                  styles_[entry]));
}

}  // namespace pomona
