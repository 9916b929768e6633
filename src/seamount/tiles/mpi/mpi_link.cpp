// Messages between ranks by MPI: a part of the program of its own, which is loaded when it was started by mpirun.
//
// One thread makes all calls of MPI, from its start to its end; between messages it sleeps, since a rank that waits
// shall not take a processor from those that work.
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <deque>
#include <list>
#include <mutex>
#include <thread>
#include <utility>

#include "seamount/tiles/rank_messages.h"

namespace seamount::tiles {
namespace {

using std::chrono::microseconds;

constexpr int kPart = 1, kLast = 2;                    ///< tags: more of a message follows, or not
constexpr size_t kMostBytes = size_t{1} << 30;         ///< of one part
constexpr microseconds kShortest{50}, kLongest{1000};  ///< naps

class MpiLink : public RankLink {
 public:
  MpiLink() : thread_([this] { run(); }) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return begun_; });
  }
  ~MpiLink() override { close(); }

  int rank() const override { return rank_; }
  int size() const override { return size_; }
  std::string machine() const override { return machine_; }

  void start(Deliver deliver) override {
    const std::lock_guard lock(mutex_);
    deliver_ = std::move(deliver);
    changed_.notify_all();
  }
  void send(int to, std::string message) override {
    const std::lock_guard lock(mutex_);
    waiting_.push_back({to, std::move(message)});
    changed_.notify_all();
  }
  void close() override {
    {
      const std::lock_guard lock(mutex_);
      closing_ = true;
      changed_.notify_all();
    }
    if (thread_.joinable()) thread_.join();
  }
  void abandon() noexcept override { std::_Exit(1); }  // mpirun ends the others

 private:
  struct Outgoing {
    int to;
    std::string message;
    std::vector<MPI_Request> requests = {};
  };

  void begin() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    char name[MPI_MAX_PROCESSOR_NAME + 1] = {};
    int length = 0;
    MPI_Get_processor_name(name, &length);
    const std::lock_guard lock(mutex_);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    machine_.assign(name, static_cast<size_t>(length));
    parts_.resize(static_cast<size_t>(size_));
    begun_ = true;
    changed_.notify_all();
  }

  void run() {
    begin();
    microseconds nap = kShortest;
    for (;;) {
      const bool sent = send_waiting(), received = receive();
      nap = sent || received ? kShortest : std::min(2 * nap, kLongest);
      std::unique_lock lock(mutex_);
      if (closing_ && waiting_.empty() && under_way_.empty()) break;
      if (!sent && !received && waiting_.empty()) changed_.wait_for(lock, nap);
    }
    MPI_Finalize();
  }

  /// True if something is under way.
  bool send_waiting() {
    std::deque<Outgoing> fresh;
    {
      const std::lock_guard lock(mutex_);
      fresh.swap(waiting_);
    }
    for (Outgoing& one : fresh) begin_to_send(under_way_.emplace_back(std::move(one)));
    under_way_.remove_if([](Outgoing& one) {
      int all = 0;
      MPI_Testall(static_cast<int>(one.requests.size()), one.requests.data(), &all, MPI_STATUSES_IGNORE);
      return all != 0;
    });
    return !under_way_.empty();
  }

  static void begin_to_send(Outgoing& one) {
    for (size_t from = 0; from == 0 || from < one.message.size(); from += kMostBytes) {
      const size_t bytes = std::min(kMostBytes, one.message.size() - from);
      const int tag = from + bytes < one.message.size() ? kPart : kLast;
      MPI_Isend(one.message.data() + from, static_cast<int>(bytes), MPI_BYTE, one.to, tag, MPI_COMM_WORLD,
                &one.requests.emplace_back());
    }
  }

  /// True if something has come.
  bool receive() {
    Deliver deliver;
    {
      const std::lock_guard lock(mutex_);
      deliver = deliver_;
    }
    int there = 0;
    MPI_Status status;
    if (deliver) MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
    if (there == 0) return false;
    int bytes = 0;
    MPI_Get_count(&status, MPI_BYTE, &bytes);
    std::string& message = parts_[static_cast<size_t>(status.MPI_SOURCE)];
    const size_t before = message.size();
    message.resize(before + static_cast<size_t>(bytes));
    MPI_Recv(message.data() + before, bytes, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    if (status.MPI_TAG == kLast) deliver(status.MPI_SOURCE, std::exchange(message, {}));
    return true;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool begun_ = false, closing_ = false;
  Deliver deliver_;
  std::deque<Outgoing> waiting_;
  int rank_ = 0, size_ = 1;
  std::string machine_;
  // The thread's own.
  std::list<Outgoing> under_way_;
  std::vector<std::string> parts_;  ///< by rank: what has come of a message
  std::thread thread_;
};

}  // namespace
}  // namespace seamount::tiles

/// The caller owns it.
extern "C" seamount::tiles::RankLink* seamount_open_ranks() { return new seamount::tiles::MpiLink(); }
