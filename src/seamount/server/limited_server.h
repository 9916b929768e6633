// The HTTP library's server with limits on what stands before a request's body, which the library reads without any: a
// client that sends header lines for ever would fill the memory, and one that sends a byte now and then hold a thread.
#pragma once

#include <httplib.h>

namespace seamount::server {

class LimitedServer : public httplib::Server {
 public:
  static constexpr size_t kMostHeader = 64 * 1024;  ///< bytes of a request's first line and header
  static constexpr int kLongestHeader_s = 20;       ///< from its first byte to its end

 private:
  bool process_and_close_socket(socket_t socket) override;
};

}  // namespace seamount::server
