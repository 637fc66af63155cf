// Exceptions of a command's other threads, which its own handlers do not catch.
#include <array>
#include <csignal>
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

TEST(Uncaught, AnythingElseIsABug) {
  EXPECT_EXIT(run_thread([] { throw std::logic_error("no such side"); }), ::testing::KilledBySignal(SIGABRT),
              "error: this is a bug in pomona: no such side");
}

}  // namespace
}  // namespace pomona
