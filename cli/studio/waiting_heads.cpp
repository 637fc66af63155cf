#include "cli/studio/waiting_heads.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <utility>
#include <vector>

namespace pomona {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

WaitingHeads::WaitingHeads(const HeadLimits& limits, std::function<void(Descriptor, std::string)> arrived)
    : limits_(limits),
      arrived_(std::move(arrived)),
      wake_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      reader_([this] { read_all(); }) {}

WaitingHeads::~WaitingHeads() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  ::eventfd_write(wake_.number(), 1);
  reader_.join();
}

void WaitingHeads::add(Descriptor socket) {
  {
    const std::lock_guard lock(mutex_);
    new_.push_back({.socket = std::move(socket), .end = steady_clock::now() + limits_.time});
  }
  ::eventfd_write(wake_.number(), 1);
}

/// Waits until something arrives on any connection, or the time of the first one is over.
void WaitingHeads::wait_for_any() {
  std::vector<pollfd> all = {{wake_.number(), POLLIN, 0}};
  for (const Head& head : heads_) all.push_back({head.socket.number(), POLLIN, 0});
  milliseconds patience(-1);
  if (!heads_.empty()) {
    const auto left = std::chrono::duration_cast<milliseconds>(heads_.front().end - steady_clock::now());
    patience = std::max(left, milliseconds(0)) + milliseconds(1);
  }
  ::poll(all.data(), all.size(), static_cast<int>(patience.count()));
  std::uint64_t ignored = 0;
  ::eventfd_read(wake_.number(), &ignored);
}

void WaitingHeads::take_in_new() {
  const std::lock_guard lock(mutex_);
  heads_.splice(heads_.end(), new_);
}

WaitingHeads::Progress WaitingHeads::read_some(Head& head) const {
  std::array<char, 4096> bytes{};
  const ssize_t count = ::recv(head.socket.number(), bytes.data(), bytes.size(), MSG_DONTWAIT);
  if (count < 0) return errno == EAGAIN || errno == EINTR ? Progress::waits : Progress::gone;
  if (count == 0) return Progress::gone;

  // The end of a head may arrive in two parts.
  const std::size_t from = head.text.size() < 3 ? 0 : head.text.size() - 3;
  head.text.append(bytes.data(), static_cast<std::size_t>(count));
  if (head.text.find("\r\n\r\n", from) != std::string::npos) return Progress::arrived;
  return head.text.size() > limits_.bytes ? Progress::gone : Progress::waits;
}

void WaitingHeads::read_all() {
  while (true) {
    {
      const std::lock_guard lock(mutex_);
      if (ended_) return;
    }
    wait_for_any();
    take_in_new();
    const auto now = steady_clock::now();
    for (auto head = heads_.begin(); head != heads_.end();) {
      Progress progress = read_some(*head);
      if (progress == Progress::waits && head->end <= now) progress = Progress::gone;
      if (progress == Progress::arrived) arrived_(std::move(head->socket), std::move(head->text));
      head = progress == Progress::waits ? std::next(head) : heads_.erase(head);
    }
    // All arrived bytes have been read by now, so the connections closed here have no complete head.
    while (heads_.size() > limits_.connections) heads_.pop_front();
  }
}

}  // namespace pomona
