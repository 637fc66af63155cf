#include "generator/base/marked_text.h"

namespace pomona {

std::string filled(std::string_view text, const std::vector<std::pair<std::string_view, std::string>>& marks) {
  std::string result;
  while (!text.empty()) {
    std::size_t at = text.size();
    const std::pair<std::string_view, std::string>* next = nullptr;
    for (const auto& mark : marks) {
      if (const std::size_t found = text.find(mark.first); found < at) {
        at = found;
        next = &mark;
      }
    }
    result += text.substr(0, at);
    if (next == nullptr) break;
    result += next->second;
    text.remove_prefix(at + next->first.size());
  }
  return result;
}

}  // namespace pomona
