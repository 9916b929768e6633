#include "seamount/tiles/rank_messages.h"

#include <chrono>
#include <cstring>
#include <limits>

#include "seamount/base/error.h"

namespace seamount::tiles {
namespace {

constexpr auto kLook = std::chrono::milliseconds(100);  ///< how often who waits looks for the user's wish to stop
constexpr auto kPatience = std::chrono::seconds(30);    ///< with ranks that are still at work after a failure
enum class What : char { take, taken, end, gather, share, failed, stop, done };
constexpr int64_t kNoMore = std::numeric_limits<int64_t>::max() / 2;

}  // namespace

/// What it is, a number (of a counter, a gathering, a sharing; a failure's kind), another, and a text.
struct MessageRanks::Message {
  What what = What::done;
  int64_t number = 0, second = 0;
  std::string text = {};

  std::string bytes() const {
    std::string all(1, static_cast<char>(what));
    all.append(reinterpret_cast<const char*>(&number), sizeof number);
    all.append(reinterpret_cast<const char*>(&second), sizeof second);
    return all + text;
  }
  static Message of(const std::string& bytes) {
    constexpr size_t kHead = 1 + 2 * sizeof(int64_t);
    if (bytes.size() < kHead) return {What::stop, 0, 0, "a message between ranks was damaged"};
    Message made{static_cast<What>(bytes[0])};
    std::memcpy(&made.number, bytes.data() + 1, sizeof made.number);
    std::memcpy(&made.second, bytes.data() + 1 + sizeof made.number, sizeof made.second);
    made.text = bytes.substr(kHead);
    return made;
  }
};

MessageRanks::MessageRanks(std::unique_ptr<RankLink> link, std::function<void()> on_stop,
                           const std::atomic<bool>* cancelled)
    : link_(std::move(link)), on_stop_(std::move(on_stop)), cancelled_(cancelled) {
  link_->start([this](int from, const std::string& message) { arrived(from, Message::of(message)); });
  try {
    meet();
  } catch (...) {
    close();
    throw;
  }
}

MessageRanks::~MessageRanks() { close(); }

/// Who is on which machine.
void MessageRanks::meet() {
  std::string all;
  for (const std::string& machine : gather(link_->machine())) all += machine + "\n";
  all = share(all);
  on_this_machine_ = 0;
  const std::string mine = link_->machine();
  for (size_t begin = 0, end; (end = all.find('\n', begin)) != std::string::npos; begin = end + 1)
    if (all.compare(begin, end - begin, mine) == 0) ++on_this_machine_;
}

int64_t MessageRanks::next(int64_t counter) {
  int64_t& number = counters_[counter];
  return number >= kNoMore ? kNoMore : number++;
}

void MessageRanks::arrived(int from, const Message& message) {
  std::unique_lock lock(mutex_);
  switch (message.what) {
    case What::take:
      link_->send(from, Message{What::taken, message.second, next(message.number)}.bytes());
      break;
    case What::taken:
      taken_[message.number] = message.second;
      break;
    case What::end:
      counters_[message.number] = kNoMore;
      break;
    case What::gather:
      gathered_[message.number][from] = message.text;
      break;
    case What::share:
      shared_[message.number] = message.text;
      break;
    case What::done:
      ++ended_;
      break;
    case What::failed:
    case What::stop: {
      const size_t end = message.text.find('\n');
      const RankFailure failure{static_cast<int>(message.second), message.text.substr(0, end),
                                static_cast<int>(message.number),
                                end == std::string::npos ? "" : message.text.substr(end + 1)};
      lock.unlock();
      stop(failure);
      return;
    }
  }
  changed_.notify_all();
}

/// The first failure counts. At rank 0 it is told to all.
void MessageRanks::stop(const RankFailure& failure) {
  {
    const std::lock_guard lock(mutex_);
    if (failure_) return;
    failure_ = failure;
    if (rank() == 0) {
      for (int other = 1; other < size(); ++other)
        link_->send(other,
                    Message{What::stop, failure.kind, failure.rank, failure.machine + "\n" + failure.text}.bytes());
    }
  }
  changed_.notify_all();
  if (failure.rank != rank() && on_stop_) on_stop_();
}

void MessageRanks::wait(std::unique_lock<std::mutex>& lock, const std::function<bool()>& ready) {
  while (!ready()) {
    if (failure_ || (cancelled_ != nullptr && cancelled_->load())) throw Cancelled();
    changed_.wait_for(lock, kLook);
  }
}

int64_t MessageRanks::take(int64_t counter) {
  std::unique_lock lock(mutex_);
  if (failure_) throw Cancelled();
  if (rank() == 0) return next(counter);
  const int64_t question = questions_++;
  link_->send(0, Message{What::take, counter, question}.bytes());
  wait(lock, [&] { return taken_.contains(question); });
  return taken_.extract(question).mapped();
}

void MessageRanks::end(int64_t counter) {
  const std::lock_guard lock(mutex_);
  if (rank() == 0)
    counters_[counter] = kNoMore;
  else
    link_->send(0, Message{What::end, counter}.bytes());
}

std::vector<std::string> MessageRanks::gather(std::string mine) {
  std::unique_lock lock(mutex_);
  const int64_t number = gatherings_++;
  if (rank() != 0) {
    link_->send(0, Message{What::gather, number, 0, std::move(mine)}.bytes());
    return {};
  }
  auto& all = gathered_[number];
  all[0] = std::move(mine);
  wait(lock, [&] { return static_cast<int>(all.size()) == size(); });
  std::vector<std::string> found;
  for (auto& [rank, text] : all) found.push_back(std::move(text));
  gathered_.erase(number);
  return found;
}

std::string MessageRanks::share(std::string of_first) {
  std::unique_lock lock(mutex_);
  const int64_t number = sharings_++;
  if (rank() == 0) {
    if (failure_) throw Cancelled();
    for (int other = 1; other < size(); ++other) link_->send(other, Message{What::share, number, 0, of_first}.bytes());
    return of_first;
  }
  wait(lock, [&] { return shared_.contains(number); });
  return shared_.extract(number).mapped();
}

void MessageRanks::fail(int kind, const std::string& text) {
  if (failure()) return;
  const RankFailure mine{rank(), link_->machine(), kind, text};
  if (rank() != 0) link_->send(0, Message{What::failed, kind, rank(), mine.machine + "\n" + text}.bytes());
  stop(mine);
}

std::optional<RankFailure> MessageRanks::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

/// False: the others have not come to their end in time.
bool MessageRanks::wait_for_the_end() {
  std::unique_lock lock(mutex_);
  const int others = rank() == 0 ? size() - 1 : 1;
  const auto all = [&] { return ended_ >= others; };
  while (!all() && !failure_) changed_.wait_for(lock, kLook);
  return changed_.wait_for(lock, kPatience, all);
}

void MessageRanks::close() noexcept {
  if (closed_) return;
  closed_ = true;
  try {
    const std::string done = Message{What::done}.bytes();
    if (rank() != 0) link_->send(0, done);
    if (!wait_for_the_end()) link_->abandon();
    for (int other = 1; rank() == 0 && other < size(); ++other) link_->send(other, done);
    link_->close();
  } catch (...) {
    link_->abandon();
  }
}

}  // namespace seamount::tiles
