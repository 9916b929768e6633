#include "seamount/server/event_hub.h"

#include <algorithm>
#include <chrono>

namespace seamount::server {
namespace {

/// Of a window that does not read: it is closed, and asks for the whole document when it is back.
constexpr size_t kMostLines = 4096;

}  // namespace

std::shared_ptr<EventHub::Stream> EventHub::open(const std::string& window) {
  const std::lock_guard lock(mutex_);
  std::erase_if(streams_, [&](const auto& stream) {
    const bool gone = stream->window() == window || stream->closed();
    if (gone) stream->close();
    return gone;
  });
  if (streams_.size() >= kMostStreams) {
    streams_.front()->close();
    streams_.erase(streams_.begin());
  }
  auto stream = std::make_shared<Stream>(window);
  for (const auto& [name, line] : states_) stream->set_state(name, line);
  if (closed_) stream->close();
  streams_.push_back(stream);
  return stream;
}

void EventHub::publish(std::string line) {
  const std::lock_guard lock(mutex_);
  for (const auto& stream : streams_) stream->add(line);
}

void EventHub::publish_state(const std::string& name, std::string line) {
  const std::lock_guard lock(mutex_);
  for (const auto& stream : streams_) stream->set_state(name, line);
  states_[name] = std::move(line);
}

void EventHub::withdraw_state(const std::string& name, std::string line) {
  const std::lock_guard lock(mutex_);
  states_.erase(name);
  for (const auto& stream : streams_) {
    stream->drop_state(name);
    stream->add(line);
  }
}

void EventHub::forget_states() {
  const std::lock_guard lock(mutex_);
  states_.clear();
}

std::vector<std::string> EventHub::windows() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> names;
  for (const auto& stream : streams_) {
    if (!stream->closed()) names.push_back(stream->window());
  }
  return names;
}

void EventHub::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  for (const auto& stream : streams_) stream->close();
}

void EventHub::Stream::greet(std::string line) {
  const std::lock_guard lock(mutex_);
  lines_.push_front(std::move(line));
  wake_.notify_all();
}

std::string EventHub::Stream::next(int milliseconds) {
  std::unique_lock lock(mutex_);
  wake_.wait_for(lock, std::chrono::milliseconds(milliseconds),
                 [&] { return closed_ || !lines_.empty() || !states_.empty(); });
  std::string text;
  for (const std::string& line : lines_) text += line + "\n";
  for (const auto& [name, line] : states_) text += line + "\n";
  lines_.clear();
  states_.clear();
  return text;
}

bool EventHub::Stream::closed() const {
  const std::lock_guard lock(mutex_);
  return closed_;
}

void EventHub::Stream::add(std::string line) {
  const std::lock_guard lock(mutex_);
  lines_.push_back(std::move(line));
  if (lines_.size() > kMostLines) {
    lines_.clear();
    closed_ = true;
  }
  wake_.notify_all();
}

void EventHub::Stream::set_state(const std::string& name, std::string line) {
  const std::lock_guard lock(mutex_);
  states_[name] = std::move(line);
  wake_.notify_all();
}

void EventHub::Stream::drop_state(const std::string& name) {
  const std::lock_guard lock(mutex_);
  states_.erase(name);
}

void EventHub::Stream::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  wake_.notify_all();
}

}  // namespace seamount::server
