// Ranks by messages: what is sent, whatever carries it (MPI; threads, in tests).
//
// Rank 0 has the counters, gathers and shares; the others talk with it alone. A rank that fails tells rank 0, which
// stops all.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "seamount/tiles/ranks.h"

namespace seamount::tiles {

/// Carries messages between ranks: each whole, those from one to another in their order.
class RankLink {
 public:
  using Deliver = std::function<void(int from, std::string message)>;
  virtual ~RankLink() = default;
  virtual int rank() const = 0;
  virtual int size() const = 0;
  /// The name of the machine, for messages.
  virtual std::string machine() const = 0;
  /// From now on `deliver` is called for what arrives, and for what has arrived before, by one thread.
  virtual void start(Deliver deliver) = 0;
  /// Returns at once. May be called from `deliver`.
  virtual void send(int to, std::string message) = 0;
  /// Sends what is left and ends. Nothing is delivered any more.
  virtual void close() = 0;
  /// Ends all ranks' processes, where they cannot be ended in order.
  virtual void abandon() noexcept = 0;
};

/// What ended the ranks' work. `kind` is the caller's: what to do about it.
struct RankFailure {
  int rank = 0;
  std::string machine;
  int kind = 0;
  std::string text;
};

class MessageRanks : public Ranks {
 public:
  /// `on_stop` is called, once and from another thread, when another rank has failed. `cancelled`: the user's wish.
  MessageRanks(std::unique_ptr<RankLink> link, std::function<void()> on_stop, const std::atomic<bool>* cancelled);
  /// As close().
  ~MessageRanks() override;

  int rank() const override { return link_->rank(); }
  int size() const override { return link_->size(); }
  int on_this_machine() const override { return on_this_machine_; }
  int64_t take(int64_t counter) override;
  void end(int64_t counter) override;
  std::vector<std::string> gather(std::string mine) override;
  std::string share(std::string of_first) override;

  /// Tells all ranks that this one has failed; nothing if they know of a failure.
  void fail(int kind, const std::string& text);
  std::optional<RankFailure> failure() const;
  /// Waits until all ranks have come to it, half a minute at most after a failure.
  void close() noexcept;

 private:
  struct Message;
  void arrived(int from, const Message& message);
  void stop(const RankFailure& failure);
  int64_t next(int64_t counter);
  void wait(std::unique_lock<std::mutex>& lock, const std::function<bool()>& ready);
  bool wait_for_the_end();
  void meet();

  std::unique_ptr<RankLink> link_;
  std::function<void()> on_stop_;
  const std::atomic<bool>* cancelled_;
  int on_this_machine_ = 1;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::map<int64_t, int64_t> counters_;                     ///< at rank 0
  std::map<int64_t, int64_t> taken_;                        ///< elsewhere: answers, by the question's number
  std::map<int64_t, std::map<int, std::string>> gathered_;  ///< at rank 0: by the gathering's number and the rank
  std::map<int64_t, std::string> shared_;                   ///< elsewhere
  int64_t questions_ = 0, gatherings_ = 0, sharings_ = 0;
  int ended_ = 0;  ///< ranks that have come to close(); elsewhere than at rank 0: it has
  std::optional<RankFailure> failure_;
  bool closed_ = false;
};

}  // namespace seamount::tiles
