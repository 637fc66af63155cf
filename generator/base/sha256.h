// SHA-256 (FIPS 180-4), by Nettle, for manifests of files.
#pragma once

#include <string>
#include <string_view>

namespace pomona {

/// 64 hexadecimal digits in lower case, as `sha256sum` prints them.
std::string sha256(std::string_view bytes);

}  // namespace pomona
