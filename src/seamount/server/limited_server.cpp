#include "seamount/server/limited_server.h"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <string>

namespace seamount::server {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kLookForStop_ms = 200;

/// One client's connection. The library reads first lines and headers byte by byte, bodies in pieces.
class Connection : public httplib::Stream {
 public:
  Connection(socket_t socket, int read_ms, int write_ms) : socket_(socket), read_ms_(read_ms), write_ms_(write_ms) {}
  ~Connection() override {
    ::shutdown(socket_, SHUT_RDWR);
    ::close(socket_);
  }

  /// Whether something can be read within so long.
  bool wait(int milliseconds) const { return begin_ < end_ || ready(POLLIN, milliseconds); }

  void begin_request() {
    header_bytes_ = 0;
    header_ends_ = Clock::now() + std::chrono::seconds(LimitedServer::kLongestHeader_s);
  }

  /// A header went beyond its limits: what follows is not looked at.
  bool cut_off() const { return cut_off_; }

  bool is_readable() const override { return wait(0); }
  bool is_writable() const override { return ready(POLLOUT, write_ms_); }

  ssize_t read(char* to, size_t size) override {
    if (size == 1 && (++header_bytes_ > LimitedServer::kMostHeader || Clock::now() > header_ends_)) cut_off_ = true;
    if (cut_off_) return -1;
    if (begin_ == end_) {
      if (!ready(POLLIN, read_ms_)) return -1;
      if (size >= buffer_.size()) return receive(to, size);
      const ssize_t got = receive(buffer_.data(), buffer_.size());
      if (got <= 0) return got;
      begin_ = 0;
      end_ = static_cast<size_t>(got);
    }
    const size_t taken = std::min(size, end_ - begin_);
    std::memcpy(to, buffer_.data() + begin_, taken);
    begin_ += taken;
    return static_cast<ssize_t>(taken);
  }

  ssize_t write(const char* from, size_t size) override {
    if (!is_writable()) return -1;
    ssize_t sent = 0;
    do {
      sent = ::send(socket_, from, size, MSG_NOSIGNAL);
    } while (sent < 0 && errno == EINTR);
    return sent;
  }

  void get_remote_ip_and_port(std::string& ip, int& port) const override { name(::getpeername, ip, port); }
  void get_local_ip_and_port(std::string& ip, int& port) const override { name(::getsockname, ip, port); }
  socket_t socket() const override { return socket_; }

 private:
  bool ready(short what, int milliseconds) const {
    pollfd asked{socket_, what, 0};
    int answer = 0;
    do {
      answer = ::poll(&asked, 1, milliseconds);
    } while (answer < 0 && errno == EINTR);
    return answer > 0 && (asked.revents & (what | POLLHUP | POLLERR)) != 0;
  }

  ssize_t receive(char* to, size_t size) const {
    ssize_t got = 0;
    do {
      got = ::recv(socket_, to, size, 0);
    } while (got < 0 && errno == EINTR);
    return got;
  }

  template <class Ask>
  void name(Ask ask, std::string& ip, int& port) const {
    sockaddr_storage address{};
    socklen_t length = sizeof(address);
    std::array<char, INET6_ADDRSTRLEN> text{};
    if (ask(socket_, reinterpret_cast<sockaddr*>(&address), &length) != 0) return;
    const void* numbers = nullptr;
    if (address.ss_family == AF_INET6) {
      const auto* six = reinterpret_cast<const sockaddr_in6*>(&address);
      numbers = &six->sin6_addr;
      port = ntohs(six->sin6_port);
    } else {
      const auto* four = reinterpret_cast<const sockaddr_in*>(&address);
      numbers = &four->sin_addr;
      port = ntohs(four->sin_port);
    }
    if (::inet_ntop(address.ss_family, numbers, text.data(), text.size()) != nullptr) ip = text.data();
  }

  socket_t socket_;
  int read_ms_, write_ms_;
  std::array<char, 16 * 1024> buffer_;
  size_t begin_ = 0, end_ = 0;  // what of the buffer is not read yet
  size_t header_bytes_ = 0;
  bool cut_off_ = false;
  Clock::time_point header_ends_;
};

}  // namespace

bool LimitedServer::process_and_close_socket(socket_t socket) {
  Connection connection(socket, static_cast<int>(1000 * read_timeout_sec_),
                        static_cast<int>(1000 * write_timeout_sec_));
  const auto comes = [&] {
    for (int waited = 0; waited < 1000 * keep_alive_timeout_sec_; waited += kLookForStop_ms) {
      if (svr_sock_ == INVALID_SOCKET) return false;
      if (connection.wait(kLookForStop_ms)) return true;
    }
    return false;
  };
  bool good = false;
  for (size_t left = keep_alive_max_count_; left > 0 && comes(); --left) {
    connection.begin_request();
    bool closed = false;
    good = process_request(connection, left == 1, closed, nullptr);
    if (!good || closed || connection.cut_off()) break;
  }
  return good;
}

}  // namespace seamount::server
