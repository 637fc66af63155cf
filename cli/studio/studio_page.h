// The studio's page: HTML with its scripts, and its content security policy.
#pragma once

#include <string>

namespace pomona {

struct StudioPage {
  std::string html;
  std::string
      policy;  ///< Content-Security-Policy: only the page's own scripts may run, and only its server may be asked
};

/// \param title of the fruit. \param token that the page sends to its server. \param nonce that marks the page's own
/// scripts and styles
StudioPage studio_page(const std::string& title, const std::string& token, const std::string& nonce);

}  // namespace pomona
