// From the texts in the editor to what the studio's page shows of them: by the program's own reader and engine.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "cli/studio/fruit_texts.h"
#include "cli/studio/plane_picture.h"
#include "generator/order/ordered_fruit.h"
#include "generator/template/read/read_template.h"

namespace pomona {

/// What of the fruit is to be seen: the options of `cut` that have sliders.
struct WantedFruit {
  FruitTexts texts;
  std::uint64_t seed = 0;
  std::optional<int> folds;
  std::optional<double> ripeness;
  double browning = 0;
  double detail = 1;
  bool draft = true;

  bool operator==(const WantedFruit&) const = default;
};

/// A fruit that has been read and grown.
struct StudioFruit {
  WantedFruit wanted;
  DrawnTemplate drawn;
  OrderedFruit source;
  Order order;  ///< that the command line would give

  /// Of the grid, draft or final; solved when it is first asked for.
  const ColorField& field() const;

 private:
  mutable std::once_flag solved_;
  mutable std::unique_ptr<ColorField> field_;
};

/// A section where the drawing shows it.
struct SectionPicture {
  std::string view;  ///< "side": the plane of the axis, +X at the right; "top": across, seen from above
  PictureFrame frame;
  std::vector<std::uint8_t> pixels;
};

/// Grows what is asked for, and keeps the last ones: a plane that moves asks for the same fruit again. May be called
/// from any thread; one fruit is grown at a time.
class StudioFruits {
 public:
  /// \param file the template, for messages and for what it names beside it
  explicit StudioFruits(std::filesystem::path file) : file_(std::move(file)) {}

  /// \throws Error (bad_data) with all that is wrong in the texts
  std::shared_ptr<const StudioFruit> grown(const WantedFruit& wanted);

 private:
  std::filesystem::path file_;
  std::mutex mutex_;
  std::vector<std::shared_ptr<const StudioFruit>> kept_;  ///< the newest last
};

/// \param size pixels along the longer side. \param height of the top view, as a share of the fruit's.
std::vector<SectionPicture> section_pictures(const StudioFruit& fruit, int size, double height);

}  // namespace pomona
