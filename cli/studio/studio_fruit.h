// From the texts in the editor to the pictures of the studio's page, by the program's own reader and engine.
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

/// The fruit to show: the options of `cut` that have sliders.
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
  Order order;  ///< as the command line would give it

  /// The field on the grid, draft or final; solved at its first use.
  const ColorField& field() const;

 private:
  mutable std::once_flag solved_;
  mutable std::unique_ptr<ColorField> field_;
};

/// A section and its place in the drawing.
struct SectionPicture {
  std::string view;  ///< "side": the plane of the axis, +X at the right; "top": across, seen from above
  PictureFrame frame;
  std::vector<std::uint8_t> pixels;
};

/// Grows fruits and keeps the last ones, because a plane that moves asks for the same fruit again. May be called from
/// any thread; one fruit is grown at a time.
class StudioFruits {
 public:
  /// \param file the template, for messages and for the files that it names
  explicit StudioFruits(std::filesystem::path file) : file_(std::move(file)) {}

  /// \throws Error (bad_data) with all errors of the texts
  std::shared_ptr<const StudioFruit> grown(const WantedFruit& wanted);

 private:
  std::filesystem::path file_;
  std::mutex mutex_;
  std::vector<std::shared_ptr<const StudioFruit>> kept_;  ///< the newest last
};

/// \param size pixels along the longer side. \param height of the top view, as a share of the fruit's.
std::vector<SectionPicture> section_pictures(const StudioFruit& fruit, int size, double height);

}  // namespace pomona
