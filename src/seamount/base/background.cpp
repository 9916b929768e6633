#include "seamount/base/background.h"

namespace seamount {

Background::Background(int count, const std::function<void()>& body) {
  threads_.reserve(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) threads_.emplace_back(body);
}

Background::~Background() {
  for (std::thread& thread : threads_) thread.join();
}

}  // namespace seamount
