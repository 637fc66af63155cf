// Cryptomatte: the share of each pixel that each object covers, by hashes of names [Friedman and Jones 2015;
// specification 1.2].
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pomona {

/// The 32-bit hash of a name in files: MurmurHash3 of its bytes, with one bit flipped if the result is not a normal
/// float.
std::uint32_t cryptomatte_hash(const std::string& name);

/// One kind of objects, such as "CryptoObject".
struct Cryptomatte {
  std::string name;
  int width = 0, height = 0;
  std::vector<std::string> names;  ///< names of the objects, by their numbers from 1

  /// Ranks per pixel: number and share of the pixel, the largest share first; of equal ones the smaller number. Unused
  /// ranks have number 0 and share 0.
  int ranks = 2;
  std::vector<std::pair<std::uint16_t, float>> coverage;  ///< per pixel `ranks` entries

  /// Header entries for readers: "cryptomatte/<id>/name" and others, with their values.
  std::vector<std::pair<std::string, std::string>> metadata() const;
};

/// \param numbers of side x side samples a pixel, row by row; 0 where nothing is. There are as many ranks as samples.
Cryptomatte cryptomatte(std::string name, std::vector<std::string> names, const std::vector<std::uint16_t>& numbers,
                        int width, int height, int side);

}  // namespace pomona
