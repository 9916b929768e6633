// Threads that live in the background as long as an object. Everything else that runs side by side goes through
// base/parallel.h; these threads wait for work and carry long pieces of it.
#pragma once

#include <functional>
#include <thread>
#include <vector>

namespace seamount {

class Background {
 public:
  /// Starts `count` threads that each call body() once. A body that throws ends the program: that is its owner's
  /// mistake.
  Background(int count, const std::function<void()>& body);

  /// Waits for every body to return; the owner has told them to.
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

 private:
  std::vector<std::thread> threads_;
};

}  // namespace seamount
