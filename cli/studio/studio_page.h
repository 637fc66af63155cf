// The studio's page: HTML with its scripts, and the rules that bind it.
#pragma once

#include <string>

namespace pomona {

struct StudioPage {
  std::string html;
  std::string policy;  ///< Content-Security-Policy: only what the page itself holds may run, only its server be asked
};

/// \param title of the fruit. \param token that it shows its server. \param nonce by which the page's own scripts and
/// styles are known
StudioPage studio_page(const std::string& title, const std::string& token, const std::string& nonce);

}  // namespace pomona
