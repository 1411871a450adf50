#include "workbench/serve/server.hpp"

#include <httplib.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "workbench/serve/api.hpp"
#include "workbench/serve/assets.hpp"
#include "workbench/serve/origin.hpp"

namespace workbench {
namespace {

constexpr const char* kHost = "127.0.0.1";
// A connection keeps its thread while it is open, and a browser opens six.
constexpr std::size_t kThreads = 32;
constexpr int kKeepAlive_s = 5;  // longer than the page waits between two questions
constexpr std::size_t kMostOnOneConnection = 100000;
constexpr int kPatience_s = 5;
// Of a body in pieces that is too long this much is read on and thrown away, for the
// client hears the reason only at its end.
constexpr std::size_t kMostReadBytes = std::size_t{4} << 30;

// uPlot sets styles of elements; scripts come from files only.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; "
    "img-src 'self' data:; connect-src 'self'; frame-ancestors 'none'; base-uri 'none'; "
    "form-action 'none'";

// As it is: the library would compress a whole body so thoroughly that a second goes by.
void send_plain(std::string_view content, const std::string& type,
                httplib::Response& response, std::shared_ptr<const std::string> owner) {
  response.set_content_provider(
      content.size(), type,
      [content, owner = std::move(owner)](std::size_t from, std::size_t length,
                                          httplib::DataSink& sink) {
        return sink.write(content.data() + from, length);
      });
}

void send(const ApiResponse& from, httplib::Response& to) {
  to.status = from.status;
  if (from.status >= 400) {
    to.set_content(from.body, from.type);
  } else {
    const auto body = std::make_shared<const std::string>(from.body);
    send_plain(*body, from.type, to, body);
  }
  if (from.filename.empty()) return;
  std::string name = from.filename;
  for (char& c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte > 0x7E || c == '"' || c == '\\') c = '_';
  }
  to.set_header("Content-Disposition", "attachment; filename=\"" + name + '"');
}

ApiRequest request_of(const httplib::Request& request) {
  ApiRequest out{request.method, request.path, {}, {}};
  for (const auto& [key, value] : request.params) out.query.emplace(key, value);
  return out;
}

void serve_file(const httplib::Request& request, httplib::Response& response) {
  const std::optional<Asset> asset = find_asset(request.path);
  if (!asset) {
    return send(error_response(404, "no file of this page has that name; open /"),
                response);
  }
  send_plain(asset->content, std::string(asset->type), response, nullptr);
}

ApiResponse too_long() {
  return error_response(413,
                        "expected at most " + std::to_string(kMostBodyBytes >> 20) +
                            " MiB, found more; give the file to `stickband serve FILE`");
}

// What the library itself refuses has no body yet.
void explain_refusal(const httplib::Request&, httplib::Response& response) {
  if (!response.body.empty()) return;
  const int status = response.status;
  if (status == 413) return send(too_long(), response);
  const std::string message = status == 404 || status == 405
                                  ? "this address takes GET and POST only"
                                  : "expected an HTTP request, found something else";
  send(error_response(status, message), response);
}

// Unlike the library's own options these leave no way for two programs to share a port.
void own_the_port(int socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

void set_limits(httplib::Server& http) {
  http.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
  http.set_socket_options(own_the_port);
  http.set_payload_max_length(kMostBodyBytes);
  http.set_keep_alive_timeout(kKeepAlive_s);
  http.set_keep_alive_max_count(kMostOnOneConnection);
  http.set_read_timeout(kPatience_s);
  http.set_write_timeout(kPatience_s);
  http.set_tcp_nodelay(true);
  http.set_default_headers({{"Cache-Control", "no-store"},
                            {"Content-Security-Policy", kPolicy},
                            {"Cross-Origin-Resource-Policy", "same-origin"},
                            {"Referrer-Policy", "no-referrer"},
                            {"X-Content-Type-Options", "nosniff"}});
}

// Nothing more comes in on the connections to this port, or else the library would wait
// for what browsers ask next.
void end_connections(int port) {
  const auto is_ours = [port](int socket) {
    sockaddr_in own = {};
    socklen_t size = sizeof own;
    return getsockname(socket, reinterpret_cast<sockaddr*>(&own), &size) == 0 &&
           own.sin_family == AF_INET && ntohs(own.sin_port) == port;
  };
  std::error_code ignored;
  for (const auto& entry :
       std::filesystem::directory_iterator("/proc/self/fd", ignored)) {
    const int socket = std::atoi(entry.path().filename().c_str());
    if (is_ours(socket)) shutdown(socket, SHUT_RD);
  }
}

// Answers what comes with a body, which is read here, for the library takes some types of
// content for forms.
void answer_body(Session& session, const httplib::Request& request,
                 httplib::Response& response, const httplib::ContentReader& read) {
  if (request.is_multipart_form_data()) {
    return send(error_response(415, "send the file itself as body, not as a form"),
                response);
  }
  ApiRequest out = request_of(request);
  // Without a length there is no body.
  const bool empty =
      !request.has_header("Content-Length") && !request.has_header("Transfer-Encoding");
  // Without a length the body would be copied as it grows; what is not used of this
  // costs no memory.
  if (request.has_header("Transfer-Encoding")) out.body.reserve(kMostBodyBytes);
  std::size_t length = 0;
  const bool complete =
      empty || read([&out, &length](const char* data, std::size_t size) {
        length += size;
        if (length > kMostBodyBytes) {
          out.body = {};
        } else {
          out.body.append(data, size);
        }
        return length <= kMostReadBytes;
      });
  if (length > kMostBodyBytes) {
    response.set_header("Connection", "close");
    return send(too_long(), response);
  }
  if (complete) send(answer(session, out), response);
}

}  // namespace

struct PageServer::Transport {
  httplib::Server http;
  std::atomic<bool> ended = false;
};

PageServer::PageServer(Session& session, std::optional<int> port)
    : transport_(std::make_unique<Transport>()) {
  httplib::Server& http = transport_->http;
  set_limits(http);
  http.set_pre_routing_handler(
      [this](const httplib::Request& request, httplib::Response& response) {
        const std::string host = request.get_header_value("Host");
        const std::string origin = request.get_header_value("Origin");
        const std::optional<std::string> why = refusal({host, origin}, port_);
        if (!why) return httplib::Server::HandlerResponse::Unhandled;
        send(error_response(403, *why), response);
        response.set_header("Connection", "close");
        return httplib::Server::HandlerResponse::Handled;
      });
  http.set_error_handler(explain_refusal);
  http.Get("/api/.*",
           [&session](const httplib::Request& request, httplib::Response& response) {
             send(answer(session, request_of(request)), response);
           });
  http.Post("/api/.*",
            [&session](const httplib::Request& request, httplib::Response& response,
                       const httplib::ContentReader& read) {
              answer_body(session, request, response, read);
            });
  http.Get(".*", serve_file);
  take_port(port);
}

void PageServer::take_port(std::optional<int> port) {
  httplib::Server& http = transport_->http;
  const auto bound = [&http](int number) { return http.bind_to_port(kHost, number); };
  if (!port) {
    for (int i = 0; i < kUsualPorts && port_ == 0; ++i) {
      if (bound(kUsualPort + i)) port_ = kUsualPort + i;
    }
    if (port_ == 0) {
      throw PortError("ports " + std::to_string(kUsualPort) + " to " +
                      std::to_string(kUsualPort + kUsualPorts - 1) +
                      " are in use; give another one with --port, or --port 0");
    }
  } else if (*port == 0) {
    port_ = http.bind_to_any_port(kHost);
    if (port_ <= 0) throw PortError("no port of 127.0.0.1 is free");
  } else if (errno = 0; bound(*port)) {
    port_ = *port;
  } else {
    throw PortError("cannot take port " + std::to_string(*port) + ": " +
                    (errno != 0 ? std::strerror(errno) : "it is in use") +
                    "; give another --port, or leave it out");
  }
}

PageServer::~PageServer() = default;

bool PageServer::run() {
  return transport_->http.listen_after_bind() || transport_->ended;
}

void PageServer::stop() {
  transport_->ended = true;
  // The library's stop does nothing before it listens.
  while (!transport_->http.is_running()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  transport_->http.stop();
  end_connections(port_);
}

}  // namespace workbench
