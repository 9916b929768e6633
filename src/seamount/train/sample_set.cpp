#include "seamount/train/sample_set.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/file_digest.h"
#include "seamount/io/folder_lock.h"

namespace seamount::train {
namespace {

namespace fs = std::filesystem;

std::string manifest_of(const std::string& folder) { return (fs::path(folder) / "manifest.jsonl").string(); }

/// Complete lines of a manifest; a last one without its end is a run that was killed while writing it.
std::vector<std::string> complete_lines(const std::string& path) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(path, error))) return {};
  const std::vector<uint8_t> bytes = io::read_file(path);
  std::vector<std::string> lines;
  for (auto begin = bytes.begin(), end = begin; (end = std::find(begin, bytes.end(), '\n')) != bytes.end();
       begin = end + 1)
    lines.emplace_back(begin, end);
  return lines;
}

/// "000000_height.png" or the like somewhere in the folder, if there is one.
std::optional<std::string> find_sample_file(const SampleSet& set) {
  std::error_code error;
  for (fs::directory_iterator entry(set.folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    const size_t digits = name.find_first_not_of("0123456789");
    if (digits == std::string::npos || digits < 6) continue;
    const std::string ending = name.substr(digits);
    if (std::any_of(set.kinds.begin(), set.kinds.end(),
                    [&](const auto& kind) { return ending == "_" + kind + ".png"; }))
      return name;
  }
  return std::nullopt;
}

class Manifest {
 public:
  explicit Manifest(const SampleSet& set) : path_(manifest_of(set.folder)) {
    lines_ = complete_lines(path_);
    if (lines_.empty()) {
      if (const auto stray = find_sample_file(set))
        throw InvalidArgument("--out", set.folder + " holds samples ('" + *stray +
                                           "') but no manifest.jsonl; choose another folder, or remove them");
      lines_.push_back(set.header);
    }
    check_set_header(set.folder, set.header);
    io::write_atomically(path_, [&](const std::string& temporary) {
      io::FileWriter file(temporary, path_);
      for (const std::string& line : lines_) file.write_raw<char>(line + "\n");
      file.close();
    });
    lines_.erase(lines_.begin());
  }

  const std::string& path() const { return path_; }
  /// Those of samples.
  const std::vector<std::string>& lines() const { return lines_; }

  void append(const std::string& lines) {
    std::FILE* file = std::fopen(path_.c_str(), "ab");
    const bool written =
        file != nullptr && std::fwrite(lines.data(), 1, lines.size(), file) == lines.size() && std::fflush(file) == 0;
    const bool kept = written && fsync(fileno(file)) == 0;
    if (file != nullptr) std::fclose(file);
    if (!kept) throw WriteError(path_, "cannot be written");
  }

 private:
  std::string path_;
  std::vector<std::string> lines_;
};

SampleRecord read_line(const Manifest& manifest, uint64_t index, const SampleSet& set) {
  const auto fail = [&](const std::string& problem) {
    throw IoError(manifest.path(), fmt::format("line {}: {}; take this line and all after it away, and their samples "
                                               "are made again",
                                               index + 2, problem));
  };
  SampleRecord record;
  try {
    record = set.read(manifest.lines()[index]);
  } catch (const Error& error) {
    fail(error.what());
  }
  if (record.index != index) fail(fmt::format("is of sample {}, not of {}", record.index, index));
  return record;
}

/// Whether a file is there; throws if it is not the one that was written.
bool is_present(const std::string& path, const std::string& digest, const RunContext& run) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(path, error))) return false;
  if (io::content_digest(path, run).hex() == digest) return true;
  throw IoError(path, "is not the file that the manifest describes; remove it, and it is made again");
}

/// Reads all lines and files; the samples whose files are missing.
std::vector<uint64_t> find_missing(const Manifest& manifest, const SampleSet& set, const RunContext& run) {
  std::vector<uint8_t> complete(manifest.lines().size());
  RunContext quiet = run;
  quiet.progress = nullptr;
  parallel_blocks(quiet, static_cast<int64_t>(complete.size()), 1, [&](int64_t begin, int64_t) {
    const auto index = static_cast<uint64_t>(begin);
    const SampleRecord record = read_line(manifest, index, set);
    bool all = true;
    for (size_t k = 0; k < set.kinds.size(); ++k)
      all &= is_present(sample_file(set.folder, index, set.kinds[k]), record.digests[k], run);
    complete[index] = all ? 1 : 0;
  });
  std::vector<uint64_t> missing;
  for (size_t i = 0; i < complete.size(); ++i)
    if (complete[i] == 0) missing.push_back(i);
  return missing;
}

/// Samples side by side, each on one thread; their lines.
std::vector<std::string> make_samples(const SampleSet& set, const std::vector<uint64_t>& indices,
                                      const RunContext& run) {
  std::vector<std::string> lines(indices.size());
  RunContext each = run;
  each.progress = nullptr;
  parallel_blocks(each, static_cast<int64_t>(indices.size()), 1, [&](int64_t begin, int64_t) {
    RunContext one = each;
    one.threads = 1;
    lines[static_cast<size_t>(begin)] = set.make(indices[static_cast<size_t>(begin)], one);
  });
  return lines;
}

void make_missing(const SampleSet& set, const Manifest& manifest, const std::vector<uint64_t>& missing,
                  const RunContext& run) {
  const std::vector<std::string> lines = make_samples(set, missing, run);
  for (size_t i = 0; i < missing.size(); ++i) {
    if (lines[i] == manifest.lines()[missing[i]]) continue;
    throw Error(sample_file(set.folder, missing[i], set.kinds.back()) +
                ": this program makes another sample than the one that the manifest describes");
  }
}

}  // namespace

std::string sample_file(const std::string& folder, uint64_t index, const std::string& kind) {
  return (fs::path(folder) / fmt::format("{:06}_{}.png", index, kind)).string();
}

std::optional<std::string> find_set_header(const std::string& folder) {
  const std::vector<std::string> lines = complete_lines(manifest_of(folder));
  return lines.empty() ? std::nullopt : std::optional(lines.front());
}

void check_set_header(const std::string& folder, const std::string& header) {
  const std::optional<std::string> found = find_set_header(folder);
  if (found && *found != header)
    throw InvalidArgument("--out", folder + " holds a set with other parameters, ground or seed: " + *found);
}

SampleSetReport make_sample_set(const SampleSet& set, const RunContext& run) {
  const io::FolderLock lock(set.folder);
  Manifest manifest(set);
  const std::vector<uint64_t> missing = find_missing(manifest, set, run);
  make_missing(set, manifest, missing, run);
  const uint64_t finished = manifest.lines().size();
  SampleSetReport report;
  report.made = missing.size();
  report.present = std::min(finished, set.count) - std::min(report.made, std::min(finished, set.count));
  constexpr uint64_t kBatch = 32;  // lines are kept in order by writing them batch by batch
  for (uint64_t first = finished; first < set.count; first += kBatch) {
    std::vector<uint64_t> indices;
    for (uint64_t i = first; i < std::min(first + kBatch, set.count); ++i) indices.push_back(i);
    std::string text;
    for (const std::string& line : make_samples(set, indices, run)) text += line + "\n";
    manifest.append(text);
    report.made += indices.size();
    run.report(static_cast<double>(first + indices.size()) / static_cast<double>(set.count));
  }
  return report;
}

}  // namespace seamount::train
