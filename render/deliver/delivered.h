// What a delivery comes to: files as bytes, and what was measured and seen on the way.
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
  bool is_one_of_many = false;  ///< of a folder of maps or ground truth, whose files are counted, not named
};

struct Delivered {
  std::vector<DeliveredFile> files;            ///< in the order of the outputs
  StageClock times;                            ///< lod, bake, style, truth, asset, write
  std::map<std::string, std::int64_t> counts;  ///< texels, triangles of levels
  std::vector<std::string> warnings;

  /// Makes the bytes of a file; the time counts as the stage "write".
  void add(const std::filesystem::path& path, const std::function<std::string()>& make);

  /// What another delivery has, behind what is here.
  void add(Delivered more);
};

/// Called as long stages get on: the stage, how many items are done, and of how many.
using DeliveryProgress = std::function<void(const std::string& stage, std::size_t done, std::size_t total)>;

}  // namespace pomona
