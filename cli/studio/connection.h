// A connection of a client to the studio, with time limits.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include <sys/types.h>

#include "render/export/transaction/durable_file.h"

namespace pomona {

/// How long a client may take. The studio's own work between reading and writing does not count.
struct ConnectionTimes {
  std::chrono::milliseconds idle{5000};      ///< without a byte received or sent
  std::chrono::milliseconds request{30000};  ///< for the whole request
  std::chrono::milliseconds reply{60000};    ///< for the whole reply
};

class Connection {
 public:
  /// \param head the bytes that were read before; read() returns them first.
  Connection(Descriptor socket, std::string head, const ConnectionTimes& times);
  Connection(Connection&&) = default;
  ~Connection();

  /// True if something can be read, or written, before the time is over.
  bool is_readable() const;
  bool is_writable();

  /// The number of bytes; 0 at the end, negative if the time is over or the client has gone.
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
