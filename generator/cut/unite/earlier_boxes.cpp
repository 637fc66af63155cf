#include "generator/cut/unite/earlier_boxes.h"

#include <numeric>

#include "generator/mesh/overlapping_boxes.h"

namespace pomona {

EarlierBoxes::EarlierBoxes(std::span<const Box<float>> box, std::span<const int> layer) : begin_(box.size() + 2, 0) {
  std::vector<std::uint32_t> number;
  std::vector<Box<float>> in_layers;
  for (std::uint32_t i = 0; i < box.size(); ++i) {
    if (layer[i] == no_layer) continue;
    number.push_back(i);
    in_layers.push_back(box[i]);
  }
  std::vector<BoxPair> pairs;  // the later one first
  visit_overlapping_boxes(in_layers, [&](std::uint32_t i, std::uint32_t k) {
    const std::uint32_t a = number[i], b = number[k];
    if (layer[a] > layer[b]) pairs.emplace_back(a, b);
    if (layer[a] < layer[b]) pairs.emplace_back(b, a);
    return true;
  });

  // Counting sort: each entry moves to the end of its box's, which is the start of the next.
  for (const auto& [later, earlier] : pairs) ++begin_[later + 2];
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  earlier_.resize(pairs.size());
  for (const auto& [later, earlier] : pairs) earlier_[begin_[later + 1]++] = earlier;
}

std::span<const std::uint32_t> EarlierBoxes::of(std::uint32_t box) const {
  return std::span(earlier_).subspan(begin_[box], begin_[box + 1] - begin_[box]);
}

}  // namespace pomona
