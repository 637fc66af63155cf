// What a client and the studio say to each other, within a time.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include <sys/types.h>

#include "render/export/transaction/durable_file.h"

namespace pomona {

/// How long a client may take. What is done between reading and writing, it does not.
struct ConnectionTimes {
  std::chrono::milliseconds idle{5000};      ///< without a byte from it, or taken by it
  std::chrono::milliseconds request{30000};  ///< to send all
  std::chrono::milliseconds reply{60000};    ///< to take all
};

class Connection {
 public:
  /// \param head what was read of it before, which read() gives again.
  Connection(Descriptor socket, std::string head, const ConnectionTimes& times);
  Connection(Connection&&) = default;
  ~Connection();

  /// Whether something can be read, or written, before the time is over.
  bool is_readable() const;
  bool is_writable();

  /// How many bytes that were; 0 at the end, below 0 where the time is over or the client has gone.
  ssize_t read(char* bytes, std::size_t size);
  ssize_t write(const char* bytes, std::size_t size);

  int number() const { return socket_.number(); }

 private:
  using Moment = std::chrono::steady_clock::time_point;

  bool is_ready(short wanted, Moment end) const;

  Descriptor socket_;
  std::string head_;
  std::size_t given_ = 0;  ///< of the head
  ConnectionTimes times_;
  Moment request_end_;
  std::optional<Moment> reply_end_;  ///< once a reply has begun
};

}  // namespace pomona
