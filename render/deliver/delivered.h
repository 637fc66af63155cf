// The result of a delivery: files as bytes, with times, counts and warnings.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "generator/base/stage_clock.h"
#include "render/export/output.h"

namespace pomona {

struct DeliveredFile {
  OutputFile file;
  bool is_one_of_many = false;  ///< it belongs to a folder of maps or ground truth, whose files are counted, not named
};

struct Delivered {
  std::vector<DeliveredFile> files;            ///< in the order of the outputs
  StageClock times;                            ///< lod, bake, style, truth, asset, write
  std::map<std::string, std::int64_t> counts;  ///< texels, triangles of levels
  std::vector<std::string> warnings;

  /// Makes the bytes of a file; the time counts as the stage "write".
  void add(const std::filesystem::path& path, const std::function<std::string()>& make);

  /// Appends another delivery.
  void add(Delivered more);
};

/// Called during long stages, with the stage, the number of items done, and of all items.
using DeliveryProgress = std::function<void(const std::string& stage, std::size_t done, std::size_t total)>;

}  // namespace pomona
