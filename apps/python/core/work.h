// Long work of the library as a call from Python: without the interpreter's lock, with progress, stopped by Ctrl-C.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "seamount/base/run_context.h"

namespace seamount::python {

namespace py = pybind11;

/// Within its life Ctrl-C sets a flag, besides what Python does with it. Only the main thread of Python listens, and
/// only if Python itself handles the signal.
class Interruptible {
 public:
  explicit Interruptible(std::atomic<bool>& flag);
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  std::atomic<bool>* outer_ = nullptr;
  bool listens_ = false;
};

/// One call. Made, run and destroyed with the lock held.
class Work {
 public:
  /// `progress`: called with the finished fraction, at most once for each per cent; None: nobody is.
  Work(int threads, py::object progress);

  const RunContext& context() const { return context_; }

  /// Calls function() without the lock and returns what it does. An exception of the progress function stops the work
  /// and is raised, so is KeyboardInterrupt.
  template <class Function>
  auto run(Function&& function) {
    try {
      auto made = without_lock(std::forward<Function>(function));
      raise_failure();
      return made;
    } catch (const Cancelled&) {
      raise_failure();
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      throw;
    }
  }

  /// Lines that the user should know although the work went on.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  template <class Function>
  auto without_lock(Function&& function) {
    const Interruptible interruptible(cancelled_);
    const py::gil_scoped_release released;
    return function();
  }
  void report(double fraction);
  void raise_failure();

  py::object progress_;
  std::atomic<bool> cancelled_{false};
  std::mutex reporting_, saying_;
  double reported_ = -1.0;
  std::optional<py::error_already_set> failure_;
  std::vector<std::string> notes_;
  RunContext context_;
};

}  // namespace seamount::python
