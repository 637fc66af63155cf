// A locale whose numbers have a decimal comma.
#pragma once

#include <clocale>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "tests/base/temporary_folder.h"

namespace pomona {

/// While it lives, the process speaks German, as a program that takes us in may do. Debian has no such locale unless
/// somebody made it, so it is made in a folder of its own.
class GermanLocale {
 public:
  GermanLocale() {
    const std::string made = "localedef -i de_DE -f UTF-8 " + (folder_ / "de_DE.UTF-8");
    EXPECT_EQ(std::system(made.c_str()), 0) << "the package locales has what this needs";
    ::setenv("LOCPATH", folder_.path().c_str(), 1);
    EXPECT_NE(std::setlocale(LC_ALL, "de_DE.UTF-8"), nullptr);
    EXPECT_STREQ(std::localeconv()->decimal_point, ",");
  }
  ~GermanLocale() {
    std::setlocale(LC_ALL, "C");
    ::unsetenv("LOCPATH");
  }
  GermanLocale(const GermanLocale&) = delete;
  GermanLocale& operator=(const GermanLocale&) = delete;

 private:
  TemporaryFolder folder_;
};

}  // namespace pomona
