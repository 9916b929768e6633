#include "seamount/tiles/spread_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>

#include "seamount/base/error.h"
#include "seamount/tiles/spread.h"

namespace seamount::tiles {
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
namespace {

/// The failure to write `file` as one of the output that it is for.
[[noreturn]] void rethrow_as(const recipe::Output& output, const std::string& file, const std::string& shown) {
  try {
    throw;
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    std::string text = error.what();
    for (size_t at; (at = text.find(file)) != std::string::npos;) text.replace(at, file.size(), shown);
    throw Error(text.starts_with(shown) ? text : fmt::format("output '{}': {}", output.path, text));
  }
}

}  // namespace

SpreadOutputs::SpreadOutputs(Ranks& ranks, const std::string& parent, const std::string& out_folder,
                             const std::vector<const recipe::Output*>& outputs, const Write& write,
                             const RunContext& run) {
  if (ranks.first()) folder_.emplace(parent);
  const fs::path folder = ranks.share(folder_ ? folder_->path().string() : "");
  for (size_t i = 0; i < outputs.size(); ++i) files_[outputs[i]] = (folder / fmt::format("{}.tif", i)).string();
  std::vector<double> took(outputs.size(), 0.0);
  spread(ranks, run, static_cast<int>(outputs.size()), 1, [&](int i, const RunContext& own) {
    const recipe::Output& output = *outputs[static_cast<size_t>(i)];
    const std::string& file = files_.at(&output);
    const auto start = Clock::now();
    try {
      write(output, file, own);
    } catch (...) {
      rethrow_as(output, file, (fs::path(out_folder) / output.path).string());
    }
    took[static_cast<size_t>(i)] = std::chrono::duration<double>(Clock::now() - start).count();
    return true;
  });
  for (const std::string& of_rank :
       ranks.gather({reinterpret_cast<const char*>(took.data()), took.size() * sizeof(double)})) {
    std::memcpy(took.data(), of_rank.data(), std::min(of_rank.size(), took.size() * sizeof(double)));
    for (size_t i = 0; i < outputs.size(); ++i) seconds_[outputs[i]] += took[i];
  }
}

double SpreadOutputs::seconds(const recipe::Output& output) const {
  const auto found = seconds_.find(&output);
  return found != seconds_.end() ? found->second : 0.0;
}

bool SpreadOutputs::move_to(const recipe::Output& output, const std::string& path) const {
  const auto found = files_.find(&output);
  if (found == files_.end()) return false;
  std::error_code error;
  fs::rename(found->second, path, error);
  if (error == std::errc::cross_device_link) {
    error.clear();
    fs::copy_file(found->second, path, error);
  }
  if (error) throw WriteError(path, "cannot be written: " + error.message());
  return true;
}

}  // namespace seamount::tiles
