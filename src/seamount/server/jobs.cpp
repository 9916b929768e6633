#include "seamount/server/jobs.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace seamount::server {
namespace {

constexpr size_t kMostRunning = 4;

}  // namespace

struct Jobs::Job {
  std::string name, what;
  std::function<std::vector<std::string>(const RunContext&)> work;
  std::function<uint64_t(const std::string&)> size_of;
  std::atomic<bool> cancelled{false}, over{false};
  mutable std::mutex mutex;  // of what follows
  int percent = 0;
  std::vector<std::string> notes, files;
  std::thread thread;
};

Jobs::Jobs(EventHub& hub) : hub_(hub) {}

Jobs::~Jobs() {
  const std::lock_guard lock(mutex_);
  for (const auto& job : jobs_) job->cancelled = true;
  for (const auto& job : jobs_) job->thread.join();
}

std::string Jobs::begin(const std::string& what, std::function<std::vector<std::string>(const RunContext&)> work,
                        std::function<uint64_t(const std::string& path)> size_of) {
  const std::lock_guard lock(mutex_);
  jobs_.remove_if([](const auto& job) {
    if (job->over) job->thread.join();
    return job->over.load();
  });
  if (jobs_.size() >= kMostRunning) throw Error("four exports run already; wait for one, or cancel it");
  auto job = std::make_unique<Job>();
  job->name = fmt::format("job-{}", ++count_);
  job->what = what;
  job->work = std::move(work);
  job->size_of = std::move(size_of);
  jobs_.push_back(std::move(job));
  Job& begun = *jobs_.back();
  tell(begun, "running", "");
  begun.thread = std::thread([this, &begun] { run(begun); });
  return begun.name;
}

bool Jobs::cancel(const std::string& name) {
  const std::lock_guard lock(mutex_);
  for (const auto& job : jobs_) {
    if (job->name != name || job->over) continue;
    job->cancelled = true;
    return true;
  }
  return false;
}

void Jobs::run(Job& job) {
  RunContext context;
  context.cancelled = &job.cancelled;
  context.progress = [&](double fraction) {
    const int percent = static_cast<int>(100 * fraction);
    {
      const std::lock_guard lock(job.mutex);
      if (percent <= job.percent) return;
      job.percent = percent;
    }
    tell(job, "running", "");
  };
  context.note = [&](const std::string& line) {
    const std::lock_guard lock(job.mutex);
    job.notes.push_back(line);
  };
  std::string state = "done", message;
  try {
    std::vector<std::string> files = job.work(context);
    const std::lock_guard lock(job.mutex);
    job.files = std::move(files);
    job.percent = 100;
  } catch (const Cancelled&) {
    state = "cancelled";
  } catch (const std::bad_alloc&) {
    state = "failed";
    message = "not enough memory";
  } catch (const std::exception& error) {
    state = "failed";
    message = error.what();
  }
  tell(job, state, message);
  job.over = true;
}

void Jobs::tell(const Job& job, const std::string& state, const std::string& message) {
  nlohmann::ordered_json event;
  {
    const std::lock_guard lock(job.mutex);
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const std::string& file : job.files) files.push_back({{"path", file}, {"bytes", job.size_of(file)}});
    event = {{"event", "job"}, {"job", job.name},    {"what", job.what}, {"fraction", job.percent / 100.0},
             {"state", state}, {"message", message}, {"files", files},   {"notes", job.notes}};
  }
  const std::string line = event.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  if (state == "running") {
    hub_.publish_state("job " + job.name, line);
  } else {
    hub_.withdraw_state("job " + job.name, line);
  }
}

}  // namespace seamount::server
