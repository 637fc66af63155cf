// A thread for OpenGL: a driver may take tens of milliseconds to move a context from one thread to another.
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <thread>

#include "render/diffusion/ready_queue.h"
#include "render/gl/context.h"

namespace pomona {

/// A context, and the one thread on which it is used. Any thread may ask for work there.
class GlThread {
 public:
  explicit GlThread(std::unique_ptr<GlContext> context);
  /// Ends when all work is done.
  ~GlThread();
  GlThread(const GlThread&) = delete;
  GlThread& operator=(const GlThread&) = delete;

  const GlContext& context() const { return *context_; }

  /// Starts work after what was started before. The future waits for its end, and throws what it throws.
  std::future<void> start(std::function<void(const CurrentGl&)> body);

 private:
  struct Work {
    std::function<void(const CurrentGl&)> body;
    std::promise<void> done;
  };

  void serve();

  std::unique_ptr<GlContext> context_;
  ReadyQueue<Work> work_;
  std::thread thread_;  // the last member: it uses the others
};

}  // namespace pomona
