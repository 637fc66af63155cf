#include "cli/studio/loopback_server.h"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include <httplib.h>

#include "cli/studio/connection.h"
#include "cli/studio/waiting_heads.h"
#include "generator/base/error.h"
#include "generator/base/parallel.h"
#include "generator/base/stop_watch.h"

namespace pomona {

namespace {

constexpr std::size_t longest_path = 100;
constexpr int max_requests = 32;  // in parallel: each has a thread while it is answered

/// Compares all letters, so that the time tells nothing about the token.
bool is_token(std::string_view given, std::string_view token) {
  unsigned different = given.size() == token.size() ? 0 : 1;
  for (std::size_t i = 0; i < token.size(); ++i)
    different |= static_cast<unsigned>(i < given.size() ? given[i] ^ token[i] : 1);
  return different == 0;
}

WebReply refused(int status, const std::string& message, const std::string& hint = {}) {
  const auto quoted = [](const std::string& text) {
    return "\"" + text + "\"";
  };  // only for our own texts, which have no quotes
  return {status, "application/json",
          "{\"errors\":[{\"message\":" + quoted(message) + ",\"hint\":" + quoted(hint) + "}]}"};
}

/// A connection as the library's stream.
class ConnectionStream final : public httplib::Stream {
 public:
  explicit ConnectionStream(Connection& connection) : connection_(connection) {}
  bool is_readable() const override { return connection_.is_readable(); }
  bool is_writable() const override { return connection_.is_writable(); }
  ssize_t read(char* bytes, std::size_t size) override { return connection_.read(bytes, size); }
  ssize_t write(const char* bytes, std::size_t size) override { return connection_.write(bytes, size); }
  void get_remote_ip_and_port(std::string& ip, int& port) const override { ip = "127.0.0.1", port = 0; }
  void get_local_ip_and_port(std::string& ip, int& port) const override { ip = "127.0.0.1", port = 0; }
  socket_t socket() const override { return connection_.number(); }

 private:
  Connection& connection_;
};

/// A queue that runs each task at once, on the accepting thread.
class AtOnce final : public httplib::TaskQueue {
 public:
  void enqueue(std::function<void()> task) override { task(); }
  void shutdown() override {}
};

/// One of some places, while it lives.
class TakenPlace {
 public:
  explicit TakenPlace(std::atomic<int>& left) : left_(left), is_there_(left.fetch_sub(1) > 0) {}
  ~TakenPlace() { left_.fetch_add(1); }
  TakenPlace(const TakenPlace&) = delete;
  TakenPlace& operator=(const TakenPlace&) = delete;
  bool is_there() const { return is_there_; }

 private:
  std::atomic<int>& left_;
  bool is_there_;
};

/// Connections wait for their heads without a thread of their own; complete ones are answered in parallel.
class HeadsFirst final : public httplib::Server {
 public:
  explicit HeadsFirst(std::chrono::seconds idle) : idle_(idle) {}

  void serve() {
    // If the system gives few threads, the library would wait forever for the others. One thread listens, one reads
    // heads.
    const int threads = std::max(1, threads_given(max_requests) - 2);
    bodies_.store(std::max(1, threads / 2));
    httplib::ThreadPool answering(static_cast<std::size_t>(threads));
    {
      WaitingHeads heads({}, [&](Descriptor socket, std::string head) {
        auto connection =
            std::make_shared<Connection>(std::move(socket), std::move(head), ConnectionTimes{.idle = idle_});
        answering.enqueue([this, connection] {
          ConnectionStream stream(*connection);
          bool closed = false;
          process_request(stream, true, closed, nullptr);
        });
      });
      heads_ = &heads;
      ::listen(svr_sock_, SOMAXCONN);  // the library's own backlog is five
      new_task_queue = [] { return new AtOnce; };
      listen_after_bind();
    }
    answering.shutdown();
  }

  /// How many more bodies may arrive at a time: those that come slowly leave half of the threads to others.
  std::atomic<int>& bodies() { return bodies_; }

 private:
  bool process_and_close_socket(socket_t socket) override {
    heads_->add(Descriptor(socket));
    return true;
  }

  std::chrono::seconds idle_;
  std::atomic<int> bodies_ = 1;
  WaitingHeads* heads_ = nullptr;
};

}  // namespace

struct LoopbackServer::Listener {
  LoopbackOptions options;
  std::function<WebReply(const WebRequest&)> handler;
  HeadsFirst server;
  int port = -1;
  std::string host;

  Listener(LoopbackOptions wanted, std::function<WebReply(const WebRequest&)> answers)
      : options(std::move(wanted)), handler(std::move(answers)), server(std::chrono::seconds(options.idle_seconds)) {}

  /// Why a request is refused before it is read to its end; nothing if it is not.
  std::optional<WebReply> fault_of(const httplib::Request& request) const {
    if (request.get_header_value_count("Host") != 1 || request.get_header_value("Host") != host)
      return refused(421, "this server answers to http://" + host + " alone");
    const std::size_t origins = request.get_header_value_count("Origin");
    if (origins > 1 || (origins == 1 && request.get_header_value("Origin") != "http://" + host))
      return refused(403, "no other page may talk to this server");
    if (request.path.size() > longest_path) return refused(414, "there is no such path");
    if (request.method != "GET" && request.method != "POST") return refused(405, "only GET and POST are known here");
    const std::string given =
        request.path == "/" ? request.get_param_value("token") : request.get_header_value("X-Pomona-Token");
    if (!is_token(given, options.token))
      return refused(403, "the token is missing or wrong", "open the whole address that `pomona studio` printed");
    return request.method == "POST" ? fault_of_body(request) : std::nullopt;
  }

  std::optional<WebReply> fault_of_body(const httplib::Request& request) const {
    const std::string type = request.get_header_value("Content-Type");
    if (type != "application/json" && !type.starts_with("application/json;"))
      return refused(415, "what is sent here is JSON", "Content-Type: application/json");
    if (request.has_header("Transfer-Encoding") || request.has_header("Content-Encoding"))
      return refused(411, "bodies are sent plain, with their length");
    const std::string length = request.get_header_value("Content-Length");
    if (length.empty() || length.size() > 15 || length.find_first_not_of("0123456789") != std::string::npos)
      return refused(411, "a body states its length");
    if (std::stoull(length) > options.max_body_bytes)
      return refused(413, "that is more than " + std::to_string(options.max_body_bytes >> 20) + " MiB",
                     "link pictures instead of embedding them");
    return {};
  }

  static void send(WebReply reply, httplib::Response& response) {
    response.status = reply.status;
    response.set_content(std::move(reply.body), reply.type);
  }

  WebRequest known(const httplib::Request& request) const {
    WebRequest known{request.method, request.path, {}, {}};
    for (const auto& [name, value] : request.params) known.query.emplace(name, value);
    return known;
  }

  /// A body must arrive within its time: the library's own limit starts anew with every byte.
  void post(const httplib::Request& request, httplib::Response& response, const httplib::ContentReader& read) {
    WebRequest wanted = known(request);
    bool has_room = false, whole = false;
    const StopWatch watch;
    {
      const TakenPlace place(server.bodies());
      has_room = place.is_there();
      whole = has_room && read([&](const char* data, std::size_t size) {
                wanted.body.append(data, size);
                return wanted.body.size() <= options.max_body_bytes &&
                       watch.milliseconds() < 1000.0 * options.max_body_seconds;
              });
    }
    if (!has_room) return send(refused(503, "too many bodies arrive at once", "try again"), response);
    send(whole ? handler(wanted) : refused(408, "the body did not arrive in time"), response);
  }

  void set_up() {
    using Answer = httplib::Server::HandlerResponse;
    // One request per connection: the rest of a refused request can then not be taken for the next one.
    server.set_payload_max_length(options.max_body_bytes);
    server.set_tcp_nodelay(true);
    server.set_default_headers({{"Content-Security-Policy", options.page_policy},
                                {"X-Content-Type-Options", "nosniff"},
                                {"X-Frame-Options", "DENY"},
                                {"Referrer-Policy", "no-referrer"},
                                {"Cross-Origin-Resource-Policy", "same-origin"},
                                {"Cross-Origin-Opener-Policy", "same-origin"},
                                {"Cache-Control", "no-store"}});
    server.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      if (std::optional<WebReply> fault = fault_of(request)) {
        send(std::move(*fault), response);
        return Answer::Handled;
      }
      if (request.method == "POST") return Answer::Unhandled;
      send(handler(known(request)), response);
      return Answer::Handled;
    });
    server.Post("/.*", [this](const httplib::Request& request, httplib::Response& response,
                              const httplib::ContentReader& read) { post(request, response, read); });
  }
};

LoopbackServer::LoopbackServer(LoopbackOptions options, std::function<WebReply(const WebRequest&)> handler)
    : listener_(std::make_unique<Listener>(std::move(options), std::move(handler))) {
  listener_->set_up();
  listener_->port = listener_->server.bind_to_any_port("127.0.0.1");
  if (listener_->port <= 0) throw Error(ExitStatus::cannot_create, "there is no free port on 127.0.0.1");
  listener_->host = "127.0.0.1:" + std::to_string(listener_->port);
}

LoopbackServer::~LoopbackServer() = default;

int LoopbackServer::port() const { return listener_->port; }

void LoopbackServer::serve() { listener_->server.serve(); }

void LoopbackServer::stop() { listener_->server.stop(); }

std::string random_token() {
  std::array<std::uint8_t, 16> bytes{};
  if (::getentropy(bytes.data(), bytes.size()) != 0)
    throw Error(ExitStatus::io_error, "the system has no random numbers for a token");
  constexpr std::string_view digits = "0123456789abcdef";
  std::string token;
  for (const std::uint8_t byte : bytes) token += {digits[byte >> 4], digits[byte & 15u]};
  return token;
}

}  // namespace pomona
