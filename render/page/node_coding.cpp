#include "render/page/node_coding.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace pomona {

namespace {

constexpr int coarsest_step = 16;

/// Walks all nodes inside in the order of the code, for one channel. `visit(node, guess, stream)` returns the node's
/// value.
class Walk {
 public:
  explicit Walk(const Asset& asset)
      : count_(asset.count),
        stride_{1, static_cast<std::size_t>(count_[0]),
                static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1])},
        winding_(asset.winding),
        value_(asset.winding.size(), 0) {}

  template <typename Visit>
  void run(const Visit& visit) {
    std::fill(value_.begin(), value_.end(), std::uint8_t{0});
    last_ = 0;
    each({0, 0, 0}, coarsest_step, coarsest_step, visit);
    for (int step = coarsest_step / 2; step > 0; step /= 2) {
      for (int odd_count = 1; odd_count <= 3; ++odd_count) {
        for (unsigned odd = 1; odd < 8; ++odd) {
          const std::array<int, 3> first{(odd & 1u) != 0 ? step : 0, (odd & 2u) != 0 ? step : 0,
                                         (odd & 4u) != 0 ? step : 0};
          if (static_cast<int>((odd & 1u) + (odd >> 1 & 1u) + (odd >> 2)) == odd_count)
            each(first, 2 * step, step, visit);
        }
      }
    }
  }

 private:
  /// All nodes from `first` in steps of `every`; odd along the axes where `first` is not 0.
  template <typename Visit>
  void each(const std::array<int, 3>& first, int every, int step, const Visit& visit) {
    for (int z = first[2]; z < count_[2]; z += every) {
      for (int y = first[1]; y < count_[1]; y += every) {
        for (int x = first[0]; x < count_[0]; x += every) {
          const std::size_t node = static_cast<std::size_t>(x) + static_cast<std::size_t>(y) * stride_[1] +
                                   static_cast<std::size_t>(z) * stride_[2];
          if (winding_[node] == 0) continue;
          const Guess guess = guess_at({x, y, z}, node, first, step);
          last_ = value_[node] = visit(node, guess.value, guess.stream);
        }
      }
    }
  }

  struct Guess {
    int value = 0;
    std::size_t stream = 0;
  };

  Guess guess_at(const std::array<int, 3>& place, std::size_t node, const std::array<int, 3>& first, int step) const {
    int sum = 0, weights = 0, alone = 0, alone_count = 0, roughest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (first[axis] == 0) continue;
      const std::size_t away = static_cast<std::size_t>(step) * stride_[axis];
      const bool low = winding_[node - away] != 0;
      const bool high = place[axis] + step < count_[axis] && winding_[node + away] != 0;
      if (low && high) {
        const int a = value_[node - away], b = value_[node + away];
        roughest = std::max(roughest, std::abs(a - b));
        const int weight = std::max(1, 1024 / (1 + (a - b) * (a - b)));
        sum += weight * (a + b);
        weights += 2 * weight;
      } else if (low || high) {
        alone += low ? value_[node - away] : value_[node + away];
        ++alone_count;
      }
    }
    if (weights > 0) {
      const std::size_t stream = roughest <= 1 ? 0 : roughest <= 6 ? 1 : roughest <= 24 ? 2 : 3;
      return {(2 * sum + weights) / (2 * weights), stream};
    }
    return {alone_count > 0 ? (2 * alone + alone_count) / (2 * alone_count) : last_, node_streams - 1};
  }

  std::array<int, 3> count_;
  std::array<std::size_t, 3> stride_;
  const std::vector<std::int8_t>& winding_;
  std::vector<std::uint8_t> value_;
  int last_ = 0;
};

/// Rounds large differences, because they lie beside surfaces, whose own colours matter more there.
class Steps {
 public:
  explicit Steps(int thirds) : thirds_(thirds) {}

  /// Numbers near 0 become small, whatever their sign.
  std::uint8_t symbol_of(int difference) const {
    const int code = code_of(std::abs(difference));
    return static_cast<std::uint8_t>(difference < 0 ? 2 * code - (code > 0 ? 1 : 0) : 2 * code);
  }
  std::uint8_t value_of(int guess, std::uint8_t symbol) const {
    const int size = size_of((symbol + 1) / 2);
    return static_cast<std::uint8_t>(std::clamp(guess + (symbol % 2 != 0 ? -size : size), 0, 255));
  }

 private:
  int size_of(int code) const {
    constexpr int exact = 1;
    return code <= exact     ? code
           : code <= thirds_ ? exact + 3 * (code - exact)
                             : exact + 3 * (thirds_ - exact) + 5 * (code - thirds_);
  }
  int code_of(int size) const {
    int code = 0;
    while (std::abs(size_of(code + 1) - size) < std::abs(size_of(code) - size)) ++code;
    return code;
  }

  int thirds_;
};

}  // namespace

std::vector<std::uint8_t> coded_nodes(const Asset& asset, int thirds) {
  const Steps steps(thirds);
  std::vector<std::uint8_t> lengths, symbols;
  Walk walk(asset);
  for (int channel = 0; channel < 3; ++channel) {
    std::array<std::vector<std::uint8_t>, node_streams> streams;
    walk.run([&](std::size_t node, int guess, std::size_t stream) {
      streams[stream].push_back(steps.symbol_of(asset.node_color[node][channel] - guess));
      return steps.value_of(guess, streams[stream].back());
    });
    for (const std::vector<std::uint8_t>& stream : streams) {
      for (int b = 0; b < 4; ++b) lengths.push_back(static_cast<std::uint8_t>(stream.size() >> (8 * b) & 255));
      symbols.insert(symbols.end(), stream.begin(), stream.end());
    }
  }
  lengths.insert(lengths.end(), symbols.begin(), symbols.end());
  return lengths;
}

std::optional<std::vector<glm::u8vec3>> decoded_nodes(const Asset& asset, std::span<const std::uint8_t> coded,
                                                      int thirds) {
  const Steps steps(thirds);
  // The begin and end of each stream.
  std::array<std::size_t, 3 * node_streams> next{}, end{};
  std::size_t at = node_lengths;
  for (std::size_t i = 0; i < next.size(); ++i) {
    next[i] = at;
    for (std::size_t b = 0; b < 4; ++b) at += std::size_t{coded[4 * i + b]} << (8 * b);
    end[i] = at;
  }
  if (at != coded.size()) return std::nullopt;

  std::vector<glm::u8vec3> color(asset.winding.size(), glm::u8vec3(0));
  Walk walk(asset);
  bool whole = true;
  for (int channel = 0; channel < 3; ++channel) {
    walk.run([&](std::size_t node, int guess, std::size_t stream) {
      const std::size_t i = node_streams * static_cast<std::size_t>(channel) + stream;
      whole = whole && next[i] < end[i];
      return color[node][channel] = whole ? steps.value_of(guess, coded[next[i]++]) : std::uint8_t{0};
    });
  }
  if (!whole) return std::nullopt;
  return color;
}

}  // namespace pomona
