#include "render/truth/cryptomatte.h"

#include <murmurhash.h>

#include <algorithm>
#include <cstdio>
#include <map>

#include <nlohmann/json.hpp>

#include "generator/base/json_text.h"

namespace pomona {

namespace {

std::string hexadecimal(std::uint32_t number) {
  char digits[9];
  std::snprintf(digits, sizeof digits, "%08x", number);
  return digits;
}

}  // namespace

std::uint32_t cryptomatte_hash(const std::string& name) {
  std::uint32_t hash = 0;
  lmmh_x86_32(name.data(), static_cast<unsigned>(name.size()), 0, &hash);
  const std::uint32_t exponent = hash >> 23 & 255;
  return exponent == 0 || exponent == 255 ? hash ^ 1u << 23 : hash;
}

std::vector<std::pair<std::string, std::string>> Cryptomatte::metadata() const {
  // The id of the entries is the beginning of the hash of the kind's name.
  std::uint32_t own = 0;
  lmmh_x86_32(name.data(), static_cast<unsigned>(name.size()), 0, &own);
  const std::string key = "cryptomatte/" + hexadecimal(own).substr(0, 7) + "/";
  nlohmann::ordered_json manifest = nlohmann::ordered_json::object();
  for (const std::string& one : names) manifest[one] = hexadecimal(cryptomatte_hash(one));
  return {{key + "name", name},
          {key + "hash", "MurmurHash3_32"},
          {key + "conversion", "uint32_to_float32"},
          {key + "manifest", json_text(manifest)}};
}

Cryptomatte cryptomatte(std::string name, std::vector<std::string> names, const std::vector<std::uint16_t>& numbers,
                        int width, int height, int side) {
  Cryptomatte matte{std::move(name), width, height, std::move(names), side * side, {}};
  matte.coverage.reserve(static_cast<std::size_t>(width) * height * matte.ranks);
  const float share = 1.0f / static_cast<float>(side * side);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::map<std::uint16_t, int> times;
      for (int k = 0; k < side * side; ++k) {
        const std::uint16_t number =
            numbers[static_cast<std::size_t>(y * side + k / side) * (width * side) + (x * side + k % side)];
        if (number != 0) ++times[number];
      }
      std::vector<std::pair<std::uint16_t, int>> ranked(times.begin(), times.end());
      std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
      ranked.resize(static_cast<std::size_t>(matte.ranks), {0, 0});
      for (const auto& [number, count] : ranked) matte.coverage.emplace_back(number, share * static_cast<float>(count));
    }
  }
  return matte;
}

}  // namespace pomona
