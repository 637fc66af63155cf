// The items of a batch: assets.
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "cli/batch/entry_styles.h"
#include "cli/batch/item_work.h"
#include "generator/batch/batch_plan.h"
#include "generator/order/ordered_fruit.h"

namespace pomona {

/// Templates made ready for their variants when the first of these is wanted: a share of a batch, or what is left of
/// it, may need few of them.
class ReadyTemplates {
 public:
  /// One of them, or why it cannot be made ready.
  struct Ready {
    std::optional<Variation> variation;
    std::string error;
  };

  explicit ReadyTemplates(const std::vector<PlannedTemplate>& templates)
      : templates_(templates), once_(templates.size()), ready_(templates.size()) {}

  /// The fruit, made ready. Any thread may ask; others wait for the one that makes it.
  const Ready& of(std::size_t fruit);

 private:
  const std::vector<PlannedTemplate>& templates_;
  std::vector<std::once_flag> once_;
  std::vector<Ready> ready_;
};

/// All items of one individual are made of it after it has been grown once.
class AssetWork : public ItemWork {
 public:
  /// \param styles of each entry.
  AssetWork(const BatchPlan& plan, std::vector<EntryStyles> styles)
      : plan_(plan), styles_(std::move(styles)), ready_(plan.templates) {}

  std::vector<RecordedEntry> entries() const override;
  std::string recipe(std::size_t entry, std::int64_t number) const override;
  std::uint64_t memory_of_an_item(std::size_t entry) const override;
  void make(std::size_t entry, std::span<const std::int64_t> numbers, const Put& put) override;

 private:
  struct GrownOrNot {
    std::optional<OrderedFruit> grown;
    std::string error;
  };
  GrownOrNot grown(const BatchVariant& which);

  const BatchPlan& plan_;
  std::vector<EntryStyles> styles_;
  ReadyTemplates ready_;
};

}  // namespace pomona
