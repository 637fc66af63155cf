#include "render/diffusion/gl_thread.h"

#include <exception>
#include <optional>
#include <utility>
#include <vector>

namespace pomona {

GlThread::GlThread(std::unique_ptr<GlContext> context) : context_(std::move(context)), thread_([this] { serve(); }) {}

GlThread::~GlThread() {
  work_.close();
  thread_.join();
}

std::future<void> GlThread::start(std::function<void(const CurrentGl&)> body) {
  Work work{std::move(body), {}};
  std::future<void> done = work.done.get_future();
  work_.put(std::move(work));
  return done;
}

void GlThread::serve() {
  std::optional<CurrentGl> gl;
  std::exception_ptr failure;
  try {
    gl.emplace(*context_);
  } catch (...) {
    failure = std::current_exception();
  }
  for (std::vector<Work> next = work_.take(); !next.empty(); next = work_.take()) {
    for (Work& work : next) {
      try {
        if (failure) std::rethrow_exception(failure);
        work.body(*gl);
        work.done.set_value();
      } catch (...) {
        work.done.set_exception(std::current_exception());
      }
    }
  }
}

}  // namespace pomona
