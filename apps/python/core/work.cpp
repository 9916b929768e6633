#include "work.h"

#include <csignal>

namespace seamount::python {
namespace {

/// The flag of the innermost call that listens, and what Python does with the signal.
std::atomic<std::atomic<bool>*> listening{nullptr};
struct sigaction pythons = {};

void on_interrupt(int signal, siginfo_t* info, void* context) {
  if (std::atomic<bool>* flag = listening.load()) flag->store(true);
  if ((pythons.sa_flags & SA_SIGINFO) != 0)
    pythons.sa_sigaction(signal, info, context);
  else
    pythons.sa_handler(signal);
}

bool is_ours(const struct sigaction& action) {
  return (action.sa_flags & SA_SIGINFO) != 0 && action.sa_sigaction == on_interrupt;
}

bool in_main_thread() {
  static const auto main = py::module_::import("threading").attr("main_thread")().attr("ident").cast<unsigned long>();
  return PyThread_get_thread_ident() == main;
}

}  // namespace

Interruptible::Interruptible(std::atomic<bool>& flag) {
  if (!in_main_thread()) return;
  struct sigaction now = {};
  sigaction(SIGINT, nullptr, &now);
  if (!is_ours(now)) {
    const bool handled = (now.sa_flags & SA_SIGINFO) != 0 || (now.sa_handler != SIG_IGN && now.sa_handler != SIG_DFL);
    if (!handled) return;
    pythons = now;
    now.sa_flags |= SA_SIGINFO;
    now.sa_sigaction = on_interrupt;
    sigaction(SIGINT, &now, nullptr);
  }
  outer_ = listening.exchange(&flag);
  listens_ = true;
}

Interruptible::~Interruptible() {
  if (!listens_) return;
  listening.store(outer_);
  if (outer_ != nullptr) return;
  struct sigaction now = {};
  sigaction(SIGINT, nullptr, &now);
  if (is_ours(now)) sigaction(SIGINT, &pythons, nullptr);  // else somebody set another meanwhile
}

Work::Work(int threads, py::object progress) : progress_(std::move(progress)) {
  constexpr int kMostThreads = 1024;
  if (threads < 0 || threads > kMostThreads)
    throw InvalidArgument("threads", std::to_string(threads) + " is outside [0, " + std::to_string(kMostThreads) + "]");
  context_.threads = threads;
  context_.cancelled = &cancelled_;
  context_.note = [this](const std::string& line) {
    const std::lock_guard lock(saying_);
    notes_.push_back(line);
  };
  if (!progress_.is_none()) context_.progress = [this](double fraction) { report(fraction); };
}

void Work::report(double fraction) {
  constexpr double kStep = 0.01;
  const std::lock_guard lock(reporting_);  // never waited for with the interpreter's lock held
  const bool worth_telling = fraction >= reported_ + kStep || (fraction >= 1.0 && reported_ < 1.0);
  if (cancelled_.load() || !worth_telling) return;
  reported_ = fraction;
  const py::gil_scoped_acquire acquired;
  try {
    progress_(fraction);
  } catch (py::error_already_set& error) {
    failure_ = error;
    cancelled_ = true;
  }
}

void Work::raise_failure() {
  if (!failure_) return;
  const py::error_already_set failure = *failure_;
  failure_.reset();
  throw failure;
}

}  // namespace seamount::python
