// What a command tells while it works, and its files when they are made.
#pragma once

#include <string>
#include <vector>

#include "cli/deliver/progress.h"
#include "cli/deliver/stage_times.h"
#include "cli/options/telling.h"
#include "generator/order/order.h"
#include "generator/order/ordered_fruit.h"
#include "render/deliver/delivered.h"

namespace pomona {

struct CommandReport {
  explicit CommandReport(const Telling& telling) : progress(telling.quiet) {}

  /// Printed at once, and part of the answer to --json.
  void warn(const std::vector<std::string>& more);

  /// How long the fruit took to grow, and of how many triangles its surfaces are.
  void add(const OrderedFruit& fruit);

  /// What was measured on the way to these files; their warnings are printed. The files are written by write_files().
  void add(Delivered more);

  /// For work that tells how far it is. The report must outlive it.
  DeliveryProgress told_progress();

  Progress progress;
  StageTimes times;
  std::vector<std::string> warnings;
  std::vector<DeliveredFile> files;  ///< all that the command has made
};

/// Puts all files on disk together, then --stats, and says what was written.
/// \throws Error as write_whole(), and (usage) where --stats names one of the files.
void write_files(CommandReport& report, const Order& order, const Telling& telling);

}  // namespace pomona
