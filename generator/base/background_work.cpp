#include "generator/base/background_work.h"

#include <system_error>

namespace pomona {

void BackgroundWork::begin(std::function<void()> work) {
  finish();
  if (!apart_) return work();
  try {
    under_way_ = std::async(std::launch::async, work);
  } catch (const std::system_error&) {
    work();  // the system gives no further thread
  }
}

void BackgroundWork::finish() {
  if (under_way_.valid()) under_way_.get();
}

}  // namespace pomona
