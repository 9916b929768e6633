// The studio on the network: HTTP on the machine's own address, which only the page that it opened may use (access.h).
#pragma once

#include <memory>
#include <string>

#include "seamount/server/studio.h"

namespace seamount::server {

struct HttpOptions {
  std::string host = "127.0.0.1";  ///< an address of this machine
  int port = 0;                    ///< 0: any that is free
};

class HttpServer {
 public:
  /// Takes the port at once. Throws Error if it is taken. `studio` outlives this.
  HttpServer(Studio& studio, const std::string& page_folder, const HttpOptions& options);
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  /// "http://127.0.0.1:8421/#TOKEN": what is opened in a browser.
  std::string address() const;
  const std::string& token() const;
  int port() const;

  /// Answers until stop() is called from another thread.
  void listen();
  void stop();

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace seamount::server
