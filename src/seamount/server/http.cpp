#include "seamount/server/http.h"

#include <fmt/format.h>
#include <httplib.h>

#include <array>
#include <fstream>

#include "seamount/base/printable.h"
#include "seamount/server/access.h"
#include "seamount/server/limited_server.h"
#include "seamount/server/page.h"

namespace seamount::server {
namespace {

constexpr int kThreads = 48;  // streams hold one each, and so do connections that wait for their next request
constexpr int kHeartbeat = 4000;
constexpr size_t kPiece = 1 << 18;

constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; worker-src 'self'; "
    "img-src 'self' blob:; font-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

Asking asking_of(const httplib::Request& request) {
  Asking asking;
  asking.method = request.method;
  asking.path = request.path;
  asking.target_bytes = request.target.size();
  const auto take = [&](const char* name, std::string& value) {
    asking.twice = asking.twice || request.get_header_value_count(name) > 1;
    value = request.get_header_value(name);
  };
  take("Host", asking.host);
  take("Origin", asking.origin);
  take("Authorization", asking.authorization);
  take("Sec-Fetch-Site", asking.fetch_site);
  take("Transfer-Encoding", asking.transfer_encoding);
  take("Content-Encoding", asking.content_encoding);
  take("Content-Length", asking.content_length);
  take("Content-Type", asking.content_type);
  take("Range", asking.range);
  return asking;
}

Request request_of(const httplib::Request& request) {
  Request result{request.method, request.path, {}, request.body};
  for (const auto& [name, value] : request.params) result.query[name] = value;
  return result;
}

/// Bytes as they are: a body would be compressed for every reader again.
void send_bytes(httplib::Response& response, std::shared_ptr<const std::string> bytes, const std::string& type) {
  response.set_content_provider(bytes->size(), type, [bytes](size_t offset, size_t length, httplib::DataSink& sink) {
    return sink.write(bytes->data() + offset, std::min(length, kPiece));
  });
  if (bytes->empty()) response.set_content("", type);
}

void send_file(httplib::Response& response, const std::string& path, const std::string& type) {
  auto file = std::make_shared<std::ifstream>(path, std::ios::binary | std::ios::ate);
  const auto size = static_cast<size_t>(std::max<std::streamoff>(0, file->tellg()));
  if (size == 0) return response.set_content("", type);
  response.set_content_provider(size, type, [file](size_t offset, size_t length, httplib::DataSink& sink) {
    std::vector<char> piece(std::min(length, kPiece));
    file->seekg(static_cast<std::streamoff>(offset));
    file->read(piece.data(), static_cast<std::streamsize>(piece.size()));
    return file->gcount() == static_cast<std::streamsize>(piece.size()) && sink.write(piece.data(), piece.size());
  });
}

void send_stream(httplib::Response& response, const std::shared_ptr<EventHub::Stream>& stream) {
  response.set_chunked_content_provider("application/x-ndjson", [stream](size_t, httplib::DataSink& sink) {
    std::string text = stream->next(kHeartbeat);
    if (stream->closed()) {
      sink.done();
      return true;
    }
    if (text.empty()) text = "{\"event\":\"alive\"}\n";
    return sink.is_writable() && sink.write(text.data(), text.size());
  });
}

void send(httplib::Response& response, Reply reply) {
  response.status = reply.status;
  for (const auto& [name, value] : reply.headers) response.set_header(name, value);
  if (!response.has_header("Cache-Control")) response.set_header("Cache-Control", "no-store");
  if (reply.stream) return send_stream(response, reply.stream);
  if (!reply.file.empty()) return send_file(response, reply.file, reply.type);
  send_bytes(response, std::make_shared<const std::string>(std::move(reply.bytes)), reply.type);
}

void send_refusal(httplib::Response& response, const Refusal& refusal) {
  send(response, {.status = refusal.status, .bytes = recipe::Json{{"error", refusal.message}}.dump()});
}

void send_page(const Page& page, const httplib::Request& request, httplib::Response& response) {
  const Page::File* file = page.find(request.path);
  if (file == nullptr) return send_refusal(response, {404, "there is nothing at that address"});
  const std::string version = "\"" + file->version + "\"";
  response.set_header("ETag", version);
  response.set_header("Cache-Control", "no-cache");
  response.set_header("Vary", "Accept-Encoding");
  if (request.get_header_value("If-None-Match") == version) {
    response.status = 304;
    return;
  }
  const std::string accepts = request.get_header_value("Accept-Encoding");
  const std::string* bytes = &file->bytes;
  for (const auto& [name, packed] : {std::pair("br", &file->brotli), std::pair("gzip", &file->gzip)}) {
    if (packed->empty() || accepts.find(name) == std::string::npos) continue;
    response.set_header("Content-Encoding", name);
    bytes = packed;
    break;
  }
  send_bytes(response, std::make_shared<const std::string>(*bytes), file->type);
}

void add_safety_headers(httplib::Response& response) {
  response.set_header("Content-Security-Policy", kPolicy);
  response.set_header("X-Content-Type-Options", "nosniff");
  response.set_header("Referrer-Policy", "no-referrer");
  response.set_header("Cross-Origin-Opener-Policy", "same-origin");
  response.set_header("Cross-Origin-Resource-Policy", "same-origin");
}

}  // namespace

class HttpServer::Work {
 public:
  Work(Studio& studio, const std::string& page_folder, const HttpOptions& options)
      : studio_(studio), page_(page_folder), host_(options.host) {
    set_limits();
    port_ = options.port;
    if (port_ == 0) {
      port_ = server_.bind_to_any_port(host_);
    } else if (!server_.bind_to_port(host_, port_)) {
      port_ = -1;
    }
    if (port_ <= 0)
      throw Error(options.port == 0 ? fmt::format("{} cannot be listened at", printable(host_))
                                    : fmt::format("port {} of {} is taken; choose another with --port", options.port,
                                                  printable(host_)));
    access_ = std::make_unique<Access>(
        make_token(), std::vector<std::string>{fmt::format("{}:{}", host_, port_), fmt::format("localhost:{}", port_)});
    add_routes();
  }

  void listen() { server_.listen_after_bind(); }
  void stop() {
    studio_.close();
    server_.stop();
  }
  std::string address() const { return fmt::format("http://{}:{}/#{}", host_, port_, access_->token()); }
  const std::string& token() const { return access_->token(); }
  int port() const { return port_; }

 private:
  void set_limits() {
    server_.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    server_.set_tcp_nodelay(true);
    server_.set_keep_alive_max_count(1000000);
    server_.set_keep_alive_timeout(5);
    server_.set_read_timeout(20);
    server_.set_write_timeout(20);
    server_.set_payload_max_length(Access::largest_body("/api/upload"));
  }

  void add_routes() {
    using Answer = httplib::Server::HandlerResponse;
    server_.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      if (const auto refusal = access_->refuse(asking_of(request))) {
        send_refusal(response, *refusal);
        return Answer::Handled;
      }
      return Answer::Unhandled;
    });
    server_.set_post_routing_handler(
        [](const httplib::Request&, httplib::Response& response) { add_safety_headers(response); });
    server_.Get(".*", [this](const httplib::Request& request, httplib::Response& response) {
      if (!request.path.starts_with("/api/")) return send_page(page_, request, response);
      send(response, studio_.answer(request_of(request)));
    });
    server_.Post("/api/upload", [this](const httplib::Request& request, httplib::Response& response,
                                       const httplib::ContentReader& reader) {
      send(response, studio_.upload(request_of(request), [&](const auto& piece) {
        bool going_on = true;
        return reader([&](const char* data, size_t size) { return going_on = piece(data, size); }) && going_on;
      }));
    });
    server_.Post(".*", [this](const httplib::Request& request, httplib::Response& response) {
      send(response, studio_.answer(request_of(request)));
    });
    server_.set_exception_handler([](const httplib::Request&, httplib::Response& response, std::exception_ptr) {
      send_refusal(response, {503, "the request could not be answered: not enough memory, perhaps"});
    });
    server_.set_error_handler([](const httplib::Request&, httplib::Response& response) {
      if (response.body.empty() && response.get_header_value("Content-Type").empty())
        send_refusal(response, {response.status, "the request could not be read"});
    });
  }

  Studio& studio_;
  const Page page_;
  const std::string host_;
  int port_ = 0;
  std::unique_ptr<Access> access_;
  LimitedServer server_;
};

HttpServer::HttpServer(Studio& studio, const std::string& page_folder, const HttpOptions& options)
    : work_(std::make_unique<Work>(studio, page_folder, options)) {}
HttpServer::~HttpServer() = default;
std::string HttpServer::address() const { return work_->address(); }
const std::string& HttpServer::token() const { return work_->token(); }
int HttpServer::port() const { return work_->port(); }
void HttpServer::listen() { work_->listen(); }
void HttpServer::stop() { work_->stop(); }

}  // namespace seamount::server
