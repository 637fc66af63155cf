#include "cli/studio/connection.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <utility>

namespace pomona {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

Connection::Connection(Descriptor socket, std::string head, const ConnectionTimes& times)
    : socket_(std::move(socket)),
      head_(std::move(head)),
      times_(times),
      request_end_(steady_clock::now() + times.request) {}

Connection::~Connection() {
  if (socket_.is_open()) ::shutdown(socket_.number(), SHUT_RDWR);
}

bool Connection::is_ready(short wanted, Moment end) const {
  const auto left = std::chrono::duration_cast<milliseconds>(end - steady_clock::now());
  const milliseconds patience = std::min(times_.idle, left);
  if (patience <= milliseconds(0)) return false;
  pollfd about{socket_.number(), wanted, 0};
  return ::poll(&about, 1, static_cast<int>(patience.count())) > 0;
}

bool Connection::is_readable() const { return given_ < head_.size() || is_ready(POLLIN, request_end_); }

bool Connection::is_writable() {
  if (!reply_end_) reply_end_ = steady_clock::now() + times_.reply;
  return is_ready(POLLOUT, *reply_end_);
}

ssize_t Connection::read(char* bytes, std::size_t size) {
  if (given_ < head_.size()) {
    const std::size_t count = head_.copy(bytes, size, given_);
    given_ += count;
    return static_cast<ssize_t>(count);
  }
  return is_readable() ? ::recv(socket_.number(), bytes, size, MSG_DONTWAIT) : -1;
}

ssize_t Connection::write(const char* bytes, std::size_t size) {
  return is_writable() ? ::send(socket_.number(), bytes, size, MSG_DONTWAIT | MSG_NOSIGNAL) : -1;
}

}  // namespace pomona
