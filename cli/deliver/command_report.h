// The messages of a command, and the files that it makes.
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

  /// Prints warnings at once; --json includes them.
  void warn(const std::vector<std::string>& more);

  /// Adds the times of growing the fruit and the number of triangles of its surfaces.
  void add(const OrderedFruit& fruit);

  /// Adds files with their times and counts, and prints their warnings. write_files() writes them.
  void add(Delivered more);

  /// A progress callback for long work. The report must outlive it.
  DeliveryProgress told_progress();

  Progress progress;
  StageTimes times;
  std::vector<std::string> warnings;
  std::vector<DeliveredFile> files;  ///< all files of the command
};

/// Writes all files as one transaction, then --stats, and prints what was written.
/// \throws Error as write_whole(), and (usage) if --stats names one of the files.
void write_files(CommandReport& report, const Order& order, const Telling& telling);

}  // namespace pomona
