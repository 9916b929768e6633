#include "seamount/recipe/result_store.h"

#include <algorithm>

namespace seamount::recipe {

const Result* ResultStore::find(const Digest& key) const {
  const auto found = results_.find(key);
  return found == results_.end() ? nullptr : &found->second;
}

void ResultStore::keep(Result& result, Values values) {
  let_go(result);
  for (const auto& [port, value] : values) result.bytes += value.bytes();
  bytes_ += result.bytes;
  result.values = std::move(values);
  touch(result);
}

void ResultStore::let_go(Result& result) {
  bytes_ -= result.bytes;
  result.bytes = 0;
  result.values.reset();
}

void ResultStore::shrink(const Keys& in_use) {
  if (bytes_ <= limit_bytes_) return;
  std::vector<Result*> idle;
  for (auto& [key, result] : results_) {
    if (result.values && !in_use.contains(key)) idle.push_back(&result);
  }
  std::sort(idle.begin(), idle.end(), [](const Result* a, const Result* b) { return a->used < b->used; });
  for (Result* result : idle) {
    if (bytes_ <= limit_bytes_) break;
    let_go(*result);
  }
}

void ResultStore::forget_all_but(const Keys& keys) {
  std::erase_if(results_, [&](const auto& item) {
    return !item.second.running && !item.second.values && !keys.contains(item.first);
  });
}

void ResultStore::forget_failures() {
  for (auto& [key, result] : results_) result.failure = nullptr;
}

}  // namespace seamount::recipe
