#include "generator/template/read/placed_parts.h"

#include <algorithm>

namespace pomona {

namespace {

/// Brings the parts of one placed template.
class PartBringer {
 public:
  PartBringer(Template& fruit, const Template& placed) : fruit_(fruit), placed_(placed) {}

  std::vector<int> bring(const std::string& place, const MergedParts& merged) {
    had_ = fruit_.parts.size();
    for (const std::string& part : placed_.parts) {
      const auto as = merged.find(part);
      const std::string name = as == merged.end() ? place + "." + part : as->second;
      const auto found = std::find(fruit_.parts.begin(), fruit_.parts.end(), name);
      index_.push_back(static_cast<int>(found - fruit_.parts.begin()));
      if (found == fruit_.parts.end()) fruit_.parts.push_back(name);
    }
    bring_materials();
    bring_densities();
    bring_cuts(fruit_.spared, placed_.spared);
    bring_cuts(fruit_.held, placed_.held);
    bring_noise();
    bring_details();
    bring_ripeness();
    bring_browning();
    return index_;
  }

 private:
  int at(int part) const { return index_[static_cast<std::size_t>(part)]; }

  void bring_cuts(std::vector<int>& parts, const std::vector<int>& placed) const {
    for (const int part : placed) parts.push_back(at(part));
    std::sort(parts.begin(), parts.end());
  }

  bool is_new(std::size_t part) const { return static_cast<std::size_t>(index_[part]) >= had_; }

  void bring_materials() {
    if (fruit_.materials.empty() && placed_.materials.empty()) return;
    fruit_.materials.resize(fruit_.parts.size());
    for (std::size_t i = 0; i < placed_.materials.size(); ++i) {
      if (is_new(i)) fruit_.materials[static_cast<std::size_t>(index_[i])] = placed_.materials[i];
    }
  }

  void bring_densities() {
    const bool uniform = fruit_.densities.empty() && placed_.densities.empty() && fruit_.density == placed_.density;
    if (uniform) return;
    fruit_.densities.resize(had_, fruit_.density);
    fruit_.densities.resize(fruit_.parts.size(), placed_.density);
    for (std::size_t i = 0; i < placed_.densities.size(); ++i) {
      if (is_new(i)) fruit_.densities[static_cast<std::size_t>(index_[i])] = placed_.densities[i];
    }
  }

  void bring_noise() {
    if (fruit_.noise.base_frequency == 0 && fruit_.noise.keys.empty()) {
      fruit_.noise = placed_.noise;
      return;
    }
    fruit_.noise.keys.insert(fruit_.noise.keys.end(), placed_.noise.keys.begin(), placed_.noise.keys.end());
  }

  void bring_details() {
    for (DetailSketch detail : placed_.details) {
      for (int& part : detail.parts) part = at(part);
      fruit_.details.push_back(std::move(detail));
    }
  }

  void bring_ripeness() {
    RipenessSketch brought = fruit_.ripeness.declared() ? fruit_.ripeness : placed_.ripeness;
    brought.parts = fruit_.ripeness.parts;
    for (RipenessSketch::Part part : placed_.ripeness.parts) {
      part.part = at(part.part);
      if (static_cast<std::size_t>(part.part) >= had_) brought.parts.push_back(std::move(part));
    }
    fruit_.ripeness = std::move(brought);
  }

  /// Where it browns first is a surface, which only the placed template has.
  void bring_browning() {
    BrowningSketch brought = fruit_.browning;
    if (!fruit_.browning.declared()) {
      brought = placed_.browning;
      brought.near.reset();
    }
    brought.parts = fruit_.browning.parts;
    for (BrowningSketch::Part part : placed_.browning.parts) {
      part.part = at(part.part);
      if (static_cast<std::size_t>(part.part) >= had_) brought.parts.push_back(part);
    }
    fruit_.browning = std::move(brought);
  }

  Template& fruit_;
  const Template& placed_;
  std::size_t had_ = 0;  ///< parts that were there before
  std::vector<int> index_;
};

}  // namespace

std::vector<int> bring_parts(Template& fruit, const Template& placed, const std::string& place,
                             const MergedParts& merged) {
  return PartBringer(fruit, placed).bring(place, merged);
}

}  // namespace pomona
