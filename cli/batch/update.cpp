#include "cli/batch/update.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "cli/batch/finished_item.h"
#include "generator/batch/batch_record.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

constexpr std::size_t max_named = 20;

/// The recipes of all items. Of each only 64 bits: ten million of them take 80 MB.
class Recipes {
 public:
  explicit Recipes(const ItemWork& work) {
    const std::vector<RecordedEntry> entries = work.entries();
    for (std::size_t entry = 0; entry < entries.size(); ++entry)
      for (std::int64_t number = 0; number < entries[entry].items; ++number)
        known_.push_back(short_form(work.recipe(entry, number)));
    std::sort(known_.begin(), known_.end());
  }

  bool contains(const std::string& recipe) const {
    return recipe.size() == 64 && std::binary_search(known_.begin(), known_.end(), short_form(recipe));
  }

 private:
  static std::uint64_t short_form(const std::string& recipe) { return std::stoull(recipe.substr(0, 16), nullptr, 16); }

  std::vector<std::uint64_t> known_;
};

bool is_recipe(const std::string& text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

class Update {
 public:
  Update(const ItemWork& work, Workplace& workplace)
      : work_(work), entries_(work.entries()), workplace_(workplace), asked_(work) {}

  void settle(const std::string& entry, std::int64_t items, std::int64_t number) {
    const std::string path = item_path(entry, items, number);
    std::error_code failed;
    if (!fs::exists(workplace_.folder() / path, failed)) return;
    const auto found = finished_item(workplace_.folder(), path);
    const std::string recipe = found && is_recipe(found->facts.recipe) ? found->facts.recipe : std::string();
    const auto wanted = wanted_there(entry, number);
    if (wanted && wanted->path == path && wanted->recipe == recipe) {
      ++report_.kept;
    } else if (asked_.contains(recipe)) {
      workplace_.set_aside(path, recipe);
      ++report_.kept;
    } else {
      workplace_.remove_item(path);
      wanted ? ++report_.changed : ++report_.removed;
      if (!wanted && report_.first_removed.size() < max_named) report_.first_removed.push_back(path);
    }
  }

  const UpdateReport& report() const { return report_; }

 private:
  struct Wanted {
    std::string path, recipe;
  };

  /// What is to lie where an item of this entry and number lay; nothing if there is to be none.
  std::optional<Wanted> wanted_there(const std::string& name, std::int64_t number) const {
    for (std::size_t i = 0; i < entries_.size(); ++i)
      if (entries_[i].name == name && number < entries_[i].items)
        return Wanted{path_of(entries_[i], number), work_.recipe(i, number)};
    return {};
  }

  const ItemWork& work_;
  std::vector<RecordedEntry> entries_;
  Workplace& workplace_;
  Recipes asked_;
  UpdateReport report_;
};

}  // namespace

UpdateReport update_folder(const ItemWork& work, const std::string& there, const std::string& wanted,
                           Workplace& workplace) {
  const RecordedBatch old_batch = parse_batch_record(there, (workplace.folder() / "batch.json").string());
  Update update(work, workplace);
  for (const RecordedEntry& entry : old_batch.entries)
    for (std::int64_t number = 0; number < entry.items; ++number) update.settle(entry.name, entry.items, number);

  // Only now does the folder hold the new batch, and nothing of it yet but what is the same.
  for (const char* of_the_old : {"manifest.json", "index.html"}) workplace.remove_file(of_the_old);
  workplace.put_file("batch.json", [&](const Workplace::Writer& write) { write(wanted); });
  return update.report();
}

std::string told(const UpdateReport& report) {
  std::string text = "kept " + std::to_string(report.kept) + " items";
  if (report.changed > 0) text += ", makes " + std::to_string(report.changed) + " anew";
  if (report.removed == 0) return text;
  text += ", removed " + std::to_string(report.removed) + " that the batch no longer asks for:";
  for (const std::string& item : report.first_removed) text += " " + item;
  return report.removed > static_cast<std::int64_t>(report.first_removed.size()) ? text + " ..." : text;
}

}  // namespace pomona
