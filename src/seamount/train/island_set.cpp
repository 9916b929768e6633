#include "seamount/train/island_set.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/painted_labels.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/file_digest.h"
#include "seamount/io/folder_lock.h"
#include "seamount/io/image_file.h"
#include "seamount/io/raster.h"

namespace seamount::train {
namespace {

namespace fs = std::filesystem;

std::string file_of(const std::string& folder, uint64_t index, const char* what) {
  return (fs::path(folder) / fmt::format("{:06}_{}.png", index, what)).string();
}

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

/// "000000_labels.png" or "000000_height.png" somewhere in the folder, if there is one.
std::optional<std::string> find_sample_file(const std::string& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    const size_t digits = name.find_first_not_of("0123456789");
    if (digits != std::string::npos && digits >= 6 &&
        (name.substr(digits) == "_labels.png" || name.substr(digits) == "_height.png"))
      return name;
  }
  return std::nullopt;
}

class Manifest {
 public:
  Manifest(const std::string& folder, const std::string& header) : path_(manifest_of(folder)) {
    lines_ = complete_lines(path_);
    if (lines_.empty()) {
      if (const auto stray = find_sample_file(folder))
        throw InvalidArgument("--out", folder + " holds samples ('" + *stray +
                                           "') but no manifest.jsonl; choose another folder, or remove them");
      lines_.push_back(header);
    }
    check_set_header(folder, header);
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

SampleRecord read_line(const Manifest& manifest, uint64_t index, const IslandSetOptions& options) {
  const auto fail = [&](const std::string& problem) {
    throw IoError(manifest.path(), fmt::format("line {}: {}; take this line and all after it away, and their samples "
                                               "are made again",
                                               index + 2, problem));
  };
  SampleRecord record;
  try {
    record = options.read(manifest.lines()[index]);
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
std::vector<SampleRecord> find_missing(const Manifest& manifest, const IslandSetOptions& options,
                                       const RunContext& run) {
  std::vector<SampleRecord> records(manifest.lines().size());
  std::vector<uint8_t> complete(records.size());
  RunContext quiet = run;
  quiet.progress = nullptr;
  parallel_blocks(quiet, static_cast<int64_t>(records.size()), 1, [&](int64_t begin, int64_t) {
    const auto index = static_cast<uint64_t>(begin);
    const SampleRecord record = read_line(manifest, index, options);
    const bool labels = is_present(file_of(options.folder, index, "labels"), record.files.labels_digest, run);
    const bool height = is_present(file_of(options.folder, index, "height"), record.files.height_digest, run);
    complete[index] = labels && height ? 1 : 0;
    records[index] = record;
  });
  std::vector<SampleRecord> missing;
  for (size_t i = 0; i < records.size(); ++i)
    if (complete[i] == 0) missing.push_back(records[i]);
  return missing;
}

struct Made {
  IslandSample sample;
  SampleFiles files;
};

/// Samples side by side, each on one thread.
std::vector<Made> make_samples(const IslandSetParams& params, const IslandSetOptions& options,
                               const std::vector<uint64_t>& indices, const RunContext& run) {
  std::vector<Made> made(indices.size());
  RunContext each = run;
  each.progress = nullptr;
  parallel_blocks(each, static_cast<int64_t>(indices.size()), 1, [&](int64_t begin, int64_t) {
    const auto i = static_cast<size_t>(begin);
    made[i].sample = draw_island_sample(params, indices[i], options.seed);
    RunContext one = each;
    one.threads = 1;
    made[i].files = make_island_files(params, made[i].sample, options.seed, options.folder, one);
  });
  return made;
}

void make_missing(const IslandSetParams& params, const IslandSetOptions& options,
                  const std::vector<SampleRecord>& missing, const RunContext& run) {
  std::vector<uint64_t> indices;
  indices.reserve(missing.size());
  for (const SampleRecord& record : missing) indices.push_back(record.index);
  const std::vector<Made> made = make_samples(params, options, indices, run);
  for (size_t i = 0; i < missing.size(); ++i) {
    if (made[i].files == missing[i].files) continue;
    throw Error(file_of(options.folder, missing[i].index, "height") +
                ": this program makes another sample than the one that the manifest describes");
  }
}

}  // namespace

std::optional<std::string> find_set_header(const std::string& folder) {
  const std::vector<std::string> lines = complete_lines(manifest_of(folder));
  return lines.empty() ? std::nullopt : std::optional(lines.front());
}

void check_set_header(const std::string& folder, const std::string& header) {
  const std::optional<std::string> found = find_set_header(folder);
  if (found && *found != header)
    throw InvalidArgument("--out", folder + " holds a set with other parameters or another seed: " + *found);
}

SampleFiles make_island_files(const IslandSetParams& params, IslandSample& sample, Seed seed, const std::string& folder,
                              const RunContext& run) {
  IslandPair pair = make_island_pair(params, sample, seed, run);
  for (float& z : pair.terrain.cells())
    z = std::clamp(z, static_cast<float>(params.low_m), static_cast<float>(params.high_m));
  const std::string labels = file_of(folder, sample.index, "labels"), height = file_of(folder, sample.index, "height");
  io::write_png(geom::encode_labels(pair.labels, sample.subsidence), labels);
  io::write_heights(pair.terrain, height,
                    {.range = io::HeightRange{params.low_m, params.high_m}, .sidecar = false, .provenance = {}});
  return {io::content_digest(labels).hex(), io::content_digest(height).hex()};
}

IslandSetReport make_island_set(const IslandSetParams& params, const IslandSetOptions& options, const RunContext& run) {
  check_params(params);
  const io::FolderLock lock(options.folder);
  Manifest manifest(options.folder, options.header);
  const std::vector<SampleRecord> missing = find_missing(manifest, options, run);
  make_missing(params, options, missing, run);
  const uint64_t finished = manifest.lines().size();
  IslandSetReport report;
  report.made = missing.size();
  report.present = std::min(finished, options.count) - std::min(report.made, std::min(finished, options.count));
  constexpr uint64_t kBatch = 32;  // lines are kept in order by writing them batch by batch
  for (uint64_t first = finished; first < options.count; first += kBatch) {
    std::vector<uint64_t> indices;
    for (uint64_t i = first; i < std::min(first + kBatch, options.count); ++i) indices.push_back(i);
    std::string text;
    for (const Made& made : make_samples(params, options, indices, run))
      text += options.write(made.sample, made.files) + "\n";
    manifest.append(text);
    report.made += indices.size();
    run.report(static_cast<double>(first + indices.size()) / static_cast<double>(options.count));
  }
  return report;
}

}  // namespace seamount::train
