// What the studio tells its windows: a stream of lines for each, one JSON object a line.
//
// Two sorts of events: those that every window must see, in order (changes of the document), and states, of which only
// the newest of each name matters (progress, results). A window that reads slowly misses states, never changes.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace seamount::server {

class EventHub {
 public:
  class Stream;

  /// The most windows at once; each holds a thread of the server.
  static constexpr size_t kMostStreams = 8;

  /// Opens the stream of a window, with the newest state of each name in it. An earlier stream of the same window is
  /// closed, and the one opened longest ago where there are too many.
  std::shared_ptr<Stream> open(const std::string& window);

  /// For all windows, in order.
  void publish(std::string line);
  /// In place of what was last said under this name.
  void publish_state(const std::string& name, std::string line);
  /// Says it to all, and forgets the state of this name.
  void withdraw_state(const std::string& name, std::string line);

  /// Forgets all states: what they were of is over.
  void forget_states();

  /// Windows that listen.
  std::vector<std::string> windows() const;

  /// Closes all streams, now and from now on.
  void close();

 private:
  mutable std::mutex mutex_;
  std::vector<std::shared_ptr<Stream>> streams_;  // the newest last
  std::map<std::string, std::string> states_;
  bool closed_ = false;
};

class EventHub::Stream {
 public:
  explicit Stream(std::string window) : window_(std::move(window)) {}

  /// A line before all others.
  void greet(std::string line);

  /// Waits for lines, `milliseconds` at most; "" after that time without any.
  std::string next(int milliseconds);
  bool closed() const;
  const std::string& window() const { return window_; }

 private:
  friend class EventHub;
  void add(std::string line);
  void set_state(const std::string& name, std::string line);
  void drop_state(const std::string& name);
  void close();

  const std::string window_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<std::string> lines_;
  std::map<std::string, std::string> states_;
  bool closed_ = false;
};

}  // namespace seamount::server
