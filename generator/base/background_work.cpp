#include "generator/base/background_work.h"

#include <utility>

namespace pomona {

void BackgroundWork::begin(std::function<void()> work) {
  finish();
  if (!apart_) return work();
  under_way_ = std::async(std::launch::async, std::move(work));
}

void BackgroundWork::finish() {
  if (under_way_.valid()) under_way_.get();
}

}  // namespace pomona
