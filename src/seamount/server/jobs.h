// Long work that a window asked for, one thread each: exports. Their progress are events.
#pragma once

#include <atomic>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/server/event_hub.h"

namespace seamount::server {

class Jobs {
 public:
  explicit Jobs(EventHub& hub);
  /// Cancels all and waits for them.
  ~Jobs();
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;

  /// Begins `work`, which returns the paths (as a window may fetch them) that it wrote. The job's name. Throws Error
  /// where too many run already.
  std::string begin(const std::string& what, std::function<std::vector<std::string>(const RunContext&)> work,
                    std::function<uint64_t(const std::string& path)> size_of);

  /// False: there is no such job.
  bool cancel(const std::string& job);

 private:
  struct Job;
  void run(Job& job);
  void tell(const Job& job, const std::string& state, const std::string& message);

  EventHub& hub_;
  std::mutex mutex_;
  std::list<std::unique_ptr<Job>> jobs_;
  int count_ = 0;
};

}  // namespace seamount::server
