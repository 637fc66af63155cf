#include "cli/batch/run_batch.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "cli/batch/finished_item.h"
#include "cli/batch/make_item.h"
#include "cli/batch/memory_budget.h"
#include "cli/deliver/ending_signals.h"
#include "cli/exhausted.h"
#include "generator/base/error.h"
#include "generator/base/stop_watch.h"

namespace pomona {

namespace {

/// The variants of the shard: every count-th variant of the batch.
class VariantsOfShard {
 public:
  VariantsOfShard(const BatchPlan& plan, const Shard& shard) : shard_(shard), all_(plan.variants()) {}

  std::size_t size() const { return static_cast<std::size_t>((all_ - shard_.number + shard_.count) / shard_.count); }
  /// The number of the i-th one among all variants of the batch.
  std::int64_t operator[](std::size_t i) const {
    return shard_.number - 1 + static_cast<std::int64_t>(i) * shard_.count;
  }

 private:
  Shard shard_;
  std::int64_t all_;
};

std::string path_of(const BatchPlan& plan, const BatchVariant& variant, const BatchItem& item) {
  const PlannedEntry& entry = plan.entries[variant.entry];
  return item_path(entry.wanted.name, entry.items(), item.number);
}

/// Templates that are prepared at their first use: a shard, or the rest of a batch, may need only few of them.
class ReadyTemplates {
 public:
  /// A prepared template, or the reason why it cannot be prepared.
  struct Ready {
    std::optional<Variation> variation;
    std::string error;
  };

  explicit ReadyTemplates(const BatchPlan& plan)
      : plan_(plan), once_(plan.templates.size()), ready_(plan.templates.size()) {}

  /// From any thread; others wait for the thread that prepares it.
  const Ready& of(std::size_t fruit) {
    std::call_once(once_[fruit], [&] {
      try {
        ready_[fruit].variation.emplace(plan_.templates[fruit].fruit);
      } catch (const std::exception& error) {
        if (exhausted(error)) throw;  // the next call tries again
        ready_[fruit].error = reason_of(error);
      }
    });
    return ready_[fruit];
  }

 private:
  const BatchPlan& plan_;
  std::vector<std::once_flag> once_;
  std::vector<Ready> ready_;
};

class Run {
 public:
  Run(const BatchPlan& plan, const std::vector<EntryStyles>& styles, Workplace& workplace, const RunOptions& options,
      Progress& progress)
      : plan_(plan),
        styles_(styles),
        workplace_(workplace),
        progress_(progress),
        check_(options.check),
        budget_(options.memory),
        ready_(plan) {
    const VariantsOfShard variants(plan, options.shard);
    for (std::size_t i = 0; i < variants.size(); ++i)
      tally_.total += plan.entries[variant_at(plan, variants[i]).entry].items_of_a_variant;
  }

  RunReport all(const RunOptions& options) {
    const VariantsOfShard numbers(plan_, options.shard);
    tell();
    parallel_for(numbers.size(), options.threads, [&](std::size_t i) { make_variant(numbers[i]); });
    signals_.forget();  // the request is fulfilled: no further item was begun
    if (interrupted_)
      throw Error(ExitStatus::locked, "interrupted, with " + progress_text(tally_), "--resume goes on from here");
    if (left_ > 0)
      throw Error(ExitStatus::out_of_memory, lack_ + ": " + std::to_string(left_) + " items are not made",
                  "--resume makes them; fewer --threads, or --memory, needs less at once");
    tally_.seconds = watch_.milliseconds() * 1e-3;
    std::sort(failed_.begin(), failed_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    RunReport report{tally_, {}};
    for (auto& [order, failed] : failed_) report.failed.push_back(std::move(failed));
    return report;
  }

 private:
  /// Makes all missing items of one individual. An error while writing ends the run: no further item is begun.
  void make_variant(std::int64_t number) {
    if (stopped_ || interrupted_) return;
    if (signals_.any()) {
      interrupted_ = true;
      return;
    }
    try {
      const BatchVariant which = variant_at(plan_, number);
      const std::vector<BatchItem> missing = without_finished(which, items_of(plan_.entries[which.entry], which));
      if (!missing.empty()) make_items(number, which, missing);
    } catch (...) {
      stopped_ = true;
      throw;
    }
  }

  std::vector<BatchItem> without_finished(const BatchVariant& which, const std::vector<BatchItem>& items) {
    std::vector<BatchItem> missing;
    for (const BatchItem& item : items) {
      const auto found = finished_item(workplace_.folder(), path_of(plan_, which, item), check_);
      if (!found || !found->facts.error.empty()) missing.push_back(item);
    }
    const std::lock_guard lock(mutex_);
    tally_.found += static_cast<std::int64_t>(items.size() - missing.size());
    return missing;
  }

  void make_items(std::int64_t number, const BatchVariant& which, const std::vector<BatchItem>& items) {
    const MemoryBudget::Loan memory(budget_, memory_of_an_item(plan_.entries[which.entry]));
    std::size_t done = 0;
    try {
      const GrownOrNot fruit = grown(which);
      for (; done < items.size(); ++done) {
        const MadeItem made = make_item(plan_, which, fruit.grown ? &*fruit.grown : nullptr, fruit.error, items[done],
                                        styles_[which.entry]);
        workplace_.put_item(made.item, made.files);
        note(number, items[done], made);
      }
    } catch (const std::exception& failure) {
      const std::optional<std::string> lack = exhausted(failure);
      if (!lack) throw;
      note_lack(which, std::span(items).subspan(done), *lack);
    }
  }

  struct GrownOrNot {
    std::optional<OrderedFruit> grown;
    std::string error;
  };

  GrownOrNot grown(const BatchVariant& which) {
    const ReadyTemplates::Ready& ready = ready_.of(which.fruit);
    if (!ready.variation) return {{}, ready.error};
    try {
      return {grown_variant(plan_, *ready.variation, which), {}};
    } catch (const std::exception& failure) {
      if (exhausted(failure)) throw;
      return {{}, reason_of(failure)};
    }
  }

  /// Items that lack memory or threads do not fail: they stay missing, and the next run makes them.
  void note_lack(const BatchVariant& which, std::span<const BatchItem> items, const std::string& lack) {
    {
      const std::lock_guard lock(mutex_);
      left_ += items.size();
      lack_ = lack;
    }
    for (const BatchItem& item : items) progress_.error(path_of(plan_, which, item) + ": error: " + lack);
  }

  void note(std::int64_t variant, const BatchItem& item, const MadeItem& made) {
    {
      const std::lock_guard lock(mutex_);
      ++tally_.made;
      if (!made.error.empty()) {
        ++tally_.failed;
        failed_.push_back({{variant, item.number}, {made.item, made.error}});
      }
    }
    if (!made.error.empty()) progress_.error(made.item + ": error: " + made.error);
    tell();
  }

  void tell() {
    Tally now;
    {
      const std::lock_guard lock(mutex_);
      tally_.seconds = watch_.milliseconds() * 1e-3;
      now = tally_;
    }
    progress_.report_text("batch", static_cast<std::size_t>(now.done()), static_cast<std::size_t>(now.total),
                          progress_text(now));
  }

  const BatchPlan& plan_;
  const std::vector<EntryStyles>& styles_;  // of each entry
  Workplace& workplace_;
  Progress& progress_;
  HeldSignals signals_;
  FileCheck check_;
  MemoryBudget budget_;
  ReadyTemplates ready_;
  StopWatch watch_;
  std::atomic<bool> stopped_ = false, interrupted_ = false;

  std::mutex mutex_;
  Tally tally_;
  std::size_t left_ = 0;  // items that lack memory or threads
  std::string lack_;
  std::vector<std::pair<std::pair<std::int64_t, std::int64_t>, FailedItem>> failed_;
};

}  // namespace

RunReport run_batch(const BatchPlan& plan, const std::vector<EntryStyles>& styles, Workplace& workplace,
                    const RunOptions& options, Progress& progress) {
  return Run(plan, styles, workplace, options, progress).all(options);
}

bool has_any_item(const BatchPlan& plan, const std::filesystem::path& folder, const Shard& shard) {
  const VariantsOfShard variants(plan, shard);
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const BatchVariant variant = variant_at(plan, variants[i]);
    for (const BatchItem& item : items_of(plan.entries[variant.entry], variant)) {
      std::error_code ignored;
      if (std::filesystem::exists(folder / path_of(plan, variant, item), ignored)) return true;
    }
  }
  return false;
}

}  // namespace pomona
