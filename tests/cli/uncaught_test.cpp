// Exceptions of a command's other threads, which its own handlers do not catch.
#include <sys/resource.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <new>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>
#include <CLI/CLI.hpp>

#include "cli/command.h"

namespace pomona {
namespace {

int run_thread(const std::function<void()>& body) {
  static std::function<void()> thread_body;
  thread_body = body;
  const Command command = [](CLI::App& app) {
    return DeclaredCommand{app.add_subcommand("start"), [] {
                             std::thread(thread_body).join();
                             return ExitStatus::done;
                           }};
  };
  std::array<char, 7> program{"pomona"};
  std::array<char, 6> word{"start"};
  std::array<char*, 3> words{program.data(), word.data(), nullptr};
  return run({command}, 2, words.data());
}

TEST(Uncaught, LackOfMemoryIsToldAsACommandsOwnIs) {
  EXPECT_EXIT(run_thread([] { throw std::bad_alloc(); }), ::testing::ExitedWithCode(71),
              "error: out of memory\n  hint");
}

/// Takes all memory that the process may still have.
void take_all_memory() {
  static void* volatile taken = nullptr;
  constexpr rlimit none{1, 1};
  setrlimit(RLIMIT_AS, &none);
  for (std::size_t size = std::size_t{1} << 24; size >= 8; size /= 2) {
    do taken = std::malloc(size);
    while (taken != nullptr);
  }
}

TEST(Uncaught, LackOfMemoryIsToldWithoutAnyMemory) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer needs memory of its own";
#endif
  const auto body = [] {
    take_all_memory();
    throw std::bad_alloc();
  };
  EXPECT_EXIT(run_thread(body), ::testing::ExitedWithCode(71), "error: out of memory\n  hint");
}

TEST(Uncaught, AnythingElseIsABug) {
  EXPECT_EXIT(run_thread([] { throw std::logic_error("no such side"); }), ::testing::KilledBySignal(SIGABRT),
              "error: this is a bug in pomona: no such side");
}

}  // namespace
}  // namespace pomona
