#include "generator/base/background_work.h"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>

namespace pomona {
namespace {

TEST(BackgroundWork, IsDoneInTheOrderInWhichItWasBegunAndNeverTwoAtOnce) {
  for (const int threads : {1, 2, 8}) {
    std::vector<int> done, expected;
    std::atomic<int> at_once = 0;
    {
      BackgroundWork work({threads});
      for (int i = 0; i < 50; ++i) {
        expected.push_back(i);
        work.begin([&, i] {
          EXPECT_EQ(++at_once, 1);
          done.push_back(i);
          --at_once;
        });
      }
    }
    EXPECT_EQ(done, expected) << threads << " threads: what is under way is waited for at the end";
  }
}

TEST(BackgroundWork, TellsWhatWentWrongAndBeginsNothingAfterIt) {
  for (const int threads : {1, 2}) {
    BackgroundWork work({threads});
    const auto fail_and_go_on = [&] {
      work.begin([] { throw std::runtime_error("full"); });
      work.begin([] { FAIL() << "the work before has failed"; });
    };
    EXPECT_THROW(fail_and_go_on(), std::runtime_error);
    EXPECT_NO_THROW(work.finish()) << "it is told once";
  }
}

}  // namespace
}  // namespace pomona
