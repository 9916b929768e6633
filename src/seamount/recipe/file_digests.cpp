#include "seamount/recipe/file_digests.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>

#include "seamount/recipe/file_values.h"

namespace seamount::recipe {
namespace {

using Clock = std::chrono::system_clock;

/// What the file system says of some files: it changes whenever one of them does.
struct Signature {
  std::string text;
  Clock::time_point newest;  ///< last change of one of them

  void add(const std::string& path) {
    struct stat now {};
    if (stat(path.c_str(), &now) != 0) {
      text += "absent;";
      return;
    }
    const auto nanoseconds = std::chrono::seconds(now.st_ctim.tv_sec) + std::chrono::nanoseconds(now.st_ctim.tv_nsec);
    newest = std::max(newest, Clock::time_point(std::chrono::duration_cast<Clock::duration>(nanoseconds)));
    text += fmt::format("{} {} {} {} {} {};", now.st_dev, now.st_ino, now.st_size, now.st_mtim.tv_sec,
                        now.st_mtim.tv_nsec, nanoseconds.count());
  }
};

Signature signature_of(const std::string& path) {
  Signature signature;
  signature.add(path);
  for (const std::string& companion : companions_of(path)) signature.add(companion);
  return signature;
}

/// Two changes closer together than this may have the same time: file systems count in ticks.
constexpr auto kTick = std::chrono::milliseconds(50);

}  // namespace

Digest FileDigests::of(const std::string& path) {
  const Signature before = signature_of(path);
  {
    const std::lock_guard lock(mutex_);
    const auto found = known_.find(path);
    if (found != known_.end() && found->second.signature == before.text) return found->second.digest;
  }
  const bool settled = Clock::now() - before.newest > kTick;
  const Digest digest = file_digest(path);
  if (settled && signature_of(path).text == before.text) {
    const std::lock_guard lock(mutex_);
    known_[path] = {before.text, digest};
  }
  return digest;
}

}  // namespace seamount::recipe
