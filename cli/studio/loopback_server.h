// A server that only this machine's browser may talk to. The library behind it is known to loopback_server.cpp alone.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>

namespace pomona {

struct WebRequest {
  std::string method;  ///< "GET" or "POST"
  std::string path;    ///< "/api/look"
  std::map<std::string, std::string> query;
  std::string body;  ///< of POST: JSON
};

struct WebReply {
  int status = 200;
  std::string type = "application/json";
  std::string body;
};

struct LoopbackOptions {
  std::string token;  ///< every request shows it: in the address of "/", else in the header X-Pomona-Token
  std::string page_policy = "default-src 'none'";  ///< Content-Security-Policy of every reply
  std::size_t max_body_bytes = std::size_t{32} << 20;
  int max_body_seconds = 20;  ///< for a body to arrive
  int idle_seconds = 5;       ///< a connection on which nothing arrives, or goes out, is closed
};

/// Answers on a free port of 127.0.0.1 and nowhere else. What lacks the token, names another host, comes from another
/// origin, is no GET or POST of JSON, has a body beyond the limits, or none of a known length, is refused before the
/// handler sees it, in words; so are paths longer than a hundred letters. Requests are handled side by side, once
/// their heads have arrived (waiting_heads.h); what takes longer than its time is closed.
class LoopbackServer {
 public:
  /// \throws Error (cannot_create) if there is no free port.
  LoopbackServer(LoopbackOptions options, std::function<WebReply(const WebRequest&)> handler);
  ~LoopbackServer();
  LoopbackServer(const LoopbackServer&) = delete;
  LoopbackServer& operator=(const LoopbackServer&) = delete;

  int port() const;

  /// Until stop() is called, from another thread.
  void serve();
  void stop();

 private:
  struct Listener;
  std::unique_ptr<Listener> listener_;
};

/// 128 bits from the system, as 32 hexadecimal digits. \throws Error (io_error) if it has none.
std::string random_token();

}  // namespace pomona
