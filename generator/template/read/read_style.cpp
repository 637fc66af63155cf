#include "generator/template/read/read_style.h"

#include <string>
#include <vector>

namespace pomona {

namespace {

std::vector<double> read_numbers(const TomlValue& value, std::size_t min, std::size_t max, Within within) {
  std::vector<double> numbers;
  if (!value.is(TomlNode::Kind::array)) {
    value.values();  // notes a fault if the value is no list
    return numbers;
  }
  for (const TomlValue& number : value.values()) numbers.push_back(number.number(0, within));
  if (numbers.size() >= min && numbers.size() <= max) return numbers;
  value.error("has " + std::to_string(numbers.size()) + " numbers, but must have " + std::to_string(min) +
              (min == max ? "" : " to " + std::to_string(max)));
  return {};
}

NoiseKey read_noise_key(const TomlTable& table) {
  NoiseKey key;
  key.color = table.need("color").color();
  key.weights = read_numbers(table.need("weights"), 1, max_noise_bands, {-1, 1});
  const std::vector<double> axis = read_numbers(table.get("axis"), 3, 3, {-1, 1});
  if (axis.size() == 3) key.axis = {axis[0], axis[1], axis[2]};
  if (key.axis == glm::vec3(0)) table.get("axis").error("has no direction", "[1, 0, 0] is from dark to light");
  return key;
}

}  // namespace

NoiseStyle read_noise(const TomlTable& table) {
  NoiseStyle noise;
  noise.base_frequency = table.need("base_frequency").number(0, {0, 1e5});
  const std::vector<double> stretch = read_numbers(table.get("stretch"), 3, 3, {1e-3, 1e3});
  if (stretch.size() == 3) noise.stretch = {stretch[0], stretch[1], stretch[2]};
  noise.sigma = table.get("sigma").number(noise.sigma, {1e-3, 10});
  for (const TomlTable& key : table.get("key").tables(max_noise_keys)) noise.keys.push_back(read_noise_key(key));
  return noise;
}

InkStyle read_ink(const TomlTable& table) {
  InkStyle ink;
  ink.color = table.get("color").color(ink.color);
  ink.width = table.get("width").number(ink.width, {0, 10});
  return ink;
}

}  // namespace pomona
