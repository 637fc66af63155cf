// A server for a browser on this machine only. Only loopback_server.cpp knows the HTTP library.
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
  int max_body_seconds = 20;  ///< until a body has arrived
  int idle_seconds = 5;       ///< a connection without a byte received or sent for so long is closed
};

/// Answers on a free port of 127.0.0.1 only. It refuses, before the handler sees it and with a reason, a request
/// without the token, for another host, from another origin, other than GET or POST of JSON, with a body beyond the
/// limits or of unknown length, or with a path of more than a hundred letters. Requests are handled in parallel, once
/// their heads have arrived (waiting_heads.h); those that exceed their time are closed.
class LoopbackServer {
 public:
  /// \throws Error (cannot_create) without a free port.
  LoopbackServer(LoopbackOptions options, std::function<WebReply(const WebRequest&)> handler);
  ~LoopbackServer();
  LoopbackServer(const LoopbackServer&) = delete;
  LoopbackServer& operator=(const LoopbackServer&) = delete;

  int port() const;

  /// Runs until another thread calls stop().
  void serve();
  void stop();

 private:
  struct Listener;
  std::unique_ptr<Listener> listener_;
};

/// 128 bits from the system, as 32 hexadecimal digits. \throws Error (io_error) if it has none.
std::string random_token();

}  // namespace pomona
