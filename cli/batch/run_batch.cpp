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
#include "cli/batch/memory_budget.h"
#include "cli/deliver/ending_signals.h"
#include "cli/exhausted.h"
#include "generator/base/error.h"
#include "generator/base/stop_watch.h"
#include "generator/batch/item_record.h"

namespace pomona {

namespace {

/// The items of one variant.
struct VariantItems {
  std::size_t entry = 0;
  std::int64_t first = 0, end = 0;  ///< numbers of its items
};

/// The shard's variants: every count-th of all.
class VariantsOfShard {
 public:
  VariantsOfShard(const std::vector<RecordedEntry>& entries, const Shard& shard) : entries_(entries), shard_(shard) {
    for (const RecordedEntry& entry : entries) all_ += entry.items / entry.items_of_a_variant;
  }

  std::size_t size() const { return static_cast<std::size_t>((all_ - shard_.number + shard_.count) / shard_.count); }
  VariantItems operator[](std::size_t i) const {
    std::int64_t index = shard_.number - 1 + static_cast<std::int64_t>(i) * shard_.count;
    for (std::size_t entry = 0;; ++entry) {
      const std::int64_t of_each = entries_[entry].items_of_a_variant, variants = entries_[entry].items / of_each;
      if (index < variants) return {entry, index * of_each, (index + 1) * of_each};
      index -= variants;
    }
  }

 private:
  const std::vector<RecordedEntry>& entries_;
  Shard shard_;
  std::int64_t all_ = 0;
};

class Run {
 public:
  Run(ItemWork& work, Workplace& workplace, const RunOptions& options, Progress& progress)
      : work_(work),
        entries_(work.entries()),
        workplace_(workplace),
        progress_(progress),
        check_(options.check),
        has_aside_(workplace.has_aside()),
        budget_(options.memory) {
    const VariantsOfShard variants(entries_, options.shard);
    for (std::size_t i = 0; i < variants.size(); ++i) tally_.total += entries_[variants[i].entry].items_of_a_variant;
  }

  RunReport all(const RunOptions& options) {
    const VariantsOfShard variants(entries_, options.shard);
    tell();
    parallel_for(variants.size(), options.threads, [&](std::size_t i) { make_variant(variants[i]); });
    signals_.forget();  // what they ask for is done: no further item was begun
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
  /// All items of one variant that are not there yet. What cannot be written ends the run, and nothing else is begun.
  void make_variant(const VariantItems& variant) {
    if (stopped_ || interrupted_) return;
    if (signals_.any()) {
      interrupted_ = true;
      return;
    }
    try {
      const std::vector<std::int64_t> missing = without_finished(variant);
      if (!missing.empty()) make_items(variant.entry, missing);
    } catch (...) {
      stopped_ = true;
      throw;
    }
  }

  std::vector<std::int64_t> without_finished(const VariantItems& variant) {
    std::vector<std::int64_t> missing;
    for (std::int64_t number = variant.first; number < variant.end; ++number) {
      const auto found = finished_item(workplace_.folder(), path_of(entries_[variant.entry], number), check_);
      const bool is_there = found && found->facts.error.empty();
      if (!is_there && !taken_from_aside(variant.entry, number)) missing.push_back(number);
    }
    const std::lock_guard lock(mutex_);
    tally_.found += variant.end - variant.first - std::ssize(missing);
    return missing;
  }

  /// Puts the item that an update has set aside into its place, if it is whole.
  bool taken_from_aside(std::size_t entry, std::int64_t number) {
    if (!has_aside_) return false;
    const std::string recipe = work_.recipe(entry, number);
    const auto aside = workplace_.aside(recipe);
    if (!aside) return false;
    const auto found = finished_item_at(*aside, check_);
    if (!found || !found->facts.error.empty()) return false;
    const RecordedEntry& place = entries_[entry];
    return workplace_.put_aside_item(recipe, path_of(place, number),
                                     {"item.json", moved_record(found->record, place.name, place.items, number)});
  }

  void make_items(std::size_t entry, std::span<const std::int64_t> numbers) {
    const MemoryBudget::Loan memory(budget_, work_.memory_of_an_item(entry));
    std::size_t done = 0;
    try {
      work_.make(entry, numbers, [&](const MadeItem& made) {
        workplace_.put_item(made.item, made.files);
        note({entry, numbers[done++]}, made);
      });
    } catch (const std::exception& failure) {
      const std::optional<std::string_view> lack = exhausted(failure);
      if (!lack) throw;
      note_lack(entry, numbers.subspan(done), std::string(*lack));
    }
  }

  /// What memory or threads did not suffice for is no item that failed: it stays missing, and the next run tries it.
  void note_lack(std::size_t entry, std::span<const std::int64_t> numbers, const std::string& lack) {
    {
      const std::lock_guard lock(mutex_);
      left_ += numbers.size();
      lack_ = lack;
    }
    for (const std::int64_t number : numbers) progress_.error(path_of(entries_[entry], number) + ": error: " + lack);
  }

  void note(std::pair<std::size_t, std::int64_t> place, const MadeItem& made) {
    {
      const std::lock_guard lock(mutex_);
      ++tally_.made;
      if (!made.error.empty()) {
        ++tally_.failed;
        failed_.push_back({place, {made.item, made.error}});
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

  ItemWork& work_;
  std::vector<RecordedEntry> entries_;
  Workplace& workplace_;
  Progress& progress_;
  HeldSignals signals_;
  FileCheck check_;
  bool has_aside_;
  MemoryBudget budget_;
  StopWatch watch_;
  std::atomic<bool> stopped_ = false, interrupted_ = false;

  std::mutex mutex_;
  Tally tally_;
  std::size_t left_ = 0;  // items that lack memory or threads
  std::string lack_;
  std::vector<std::pair<std::pair<std::size_t, std::int64_t>, FailedItem>> failed_;
};

}  // namespace

RunReport run_batch(ItemWork& work, Workplace& workplace, const RunOptions& options, Progress& progress) {
  return Run(work, workplace, options, progress).all(options);
}

bool has_any_item(const ItemWork& work, const std::filesystem::path& folder, const Shard& shard) {
  const std::vector<RecordedEntry> entries = work.entries();
  const VariantsOfShard variants(entries, shard);
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const VariantItems variant = variants[i];
    for (std::int64_t number = variant.first; number < variant.end; ++number) {
      std::error_code ignored;
      if (std::filesystem::exists(folder / path_of(entries[variant.entry], number), ignored)) return true;
    }
  }
  return false;
}

}  // namespace pomona
