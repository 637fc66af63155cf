#include "python/binding/work.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "generator/base/stopping.h"

namespace pomona {

namespace {

struct ProgressReport {
  std::string stage;
  std::size_t done = 0, total = 0;
};

/// How far work is, told by one thread to another. Of reports that come faster than they are heard, the last counts.
class Message {
 public:
  void report(const std::string& stage, std::size_t done, std::size_t total) {
    const std::lock_guard lock(mutex_);
    latest_ = {stage, done, total};
    changed_.notify_one();
  }

  void end() {
    const std::lock_guard lock(mutex_);
    over_ = true;
    changed_.notify_one();
  }

  /// Waits for a report, for the end, or for as long as a person does not notice. \param over set at the end.
  std::optional<ProgressReport> wait(bool& over) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, std::chrono::milliseconds(50), [&] { return over_ || latest_; });
    over = over_;
    return std::exchange(latest_, std::nullopt);
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<ProgressReport> latest_;
  bool over_ = false;
};

/// Hears signals, and tells Python. \throws py::error_already_set
void attend(const py::object& progress, const std::optional<ProgressReport>& report) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (report && !progress.is_none()) progress(report->stage, report->done, report->total);
}

void warn(const std::vector<std::string>& warnings) {
  if (!warnings.empty()) py::module_::import("pomona._telling").attr("warn")(warnings);
}

/// Until the work is over. What Python throws in the meantime stops it: so `progress` is called again and again while
/// long work has nothing new to report.
std::exception_ptr watch(Message& message, const py::object& progress, std::atomic<bool>& stop) {
  std::exception_ptr thrown;
  std::optional<ProgressReport> report;
  for (bool over = false; !over;) {
    {
      const py::gil_scoped_release others_may_run;
      if (std::optional<ProgressReport> news = message.wait(over)) report = std::move(news);
    }
    if (thrown) continue;
    try {
      attend(progress, report);
    } catch (...) {
      thrown = std::current_exception();
      stop = true;
    }
  }
  return thrown;
}

}  // namespace

void run_work(const py::object& progress, const std::function<void(Telltale&)>& work) {
  Message message;
  Telltale telltale;
  const bool is_heard = !progress.is_none();
  telltale.progress = [&](const std::string& stage, std::size_t done, std::size_t total) {
    end_if_stopped();
    if (is_heard) message.report(stage, done, total);
  };
  std::atomic<bool> stop = false;
  std::exception_ptr failure;
  std::thread worker([&] {
    try {
      const HeededStop heeded(&stop);
      work(telltale);
    } catch (...) {
      failure = std::current_exception();
    }
    message.end();
  });
  const std::exception_ptr thrown = watch(message, progress, stop);
  {
    const py::gil_scoped_release others_may_run;
    worker.join();
  }
  if (thrown) std::rethrow_exception(thrown);
  if (failure) std::rethrow_exception(failure);
  warn(telltale.warnings);
}

}  // namespace pomona
