#include "seamount/recipe/run_outputs.h"

#include <fmt/format.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>

#include "seamount/base/version.h"
#include "seamount/io/staged_folder.h"
#include "seamount/recipe/output_files.h"

namespace seamount::recipe {
namespace {

namespace fs = std::filesystem;

/// One output into the staged folder; errors get the output's name, and the names that its files will have.
void write_staged(const Recipe& recipe, const Output& output, const io::StagedFolder& staged,
                  const std::function<const Value&(const Source&)>& value, const RowsWriter& by_rows,
                  const RunContext& run) {
  const io::Provenance provenance = provenance_of(recipe);
  try {
    if (by_rows && by_rows(output, staged.path(output.path), provenance, run)) return;
    Values prepared;
    for (const auto& [name, source] : output.prepared) prepared[name] = value(source);
    output.format->write(output.params, {value(output.from), prepared, staged.path(output.path), provenance, run});
  } catch (const Cancelled&) {
    throw;
  } catch (const IoError& error) {
    throw Error(staged.shown(error.what()));
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(fmt::format("output '{}'", output.path), staged.shown(error.what()));
  } catch (const std::exception& error) {
    throw Error(fmt::format("output '{}': {}", output.path, staged.shown(error.what())));
  }
}

/// Names in a folder that fit a name with '*' for digits, 9 before 10; `pattern` and they with the same folders before.
std::vector<std::string> matching_files(const std::string& pattern, const fs::path& folder) {
  std::vector<std::string> found;
  std::error_code none_there;
  for (const auto& entry : fs::directory_iterator(folder, none_there)) {
    const std::string name = (fs::path(pattern).parent_path() / entry.path().filename()).string();
    if (may_be_same_file(pattern, name)) found.push_back(name);
  }
  std::sort(found.begin(), found.end(),
            [](const std::string& a, const std::string& b) { return std::pair(a.size(), a) < std::pair(b.size(), b); });
  return found;
}

/// Names of the files that an output has written, digits known.
std::vector<std::string> files_of(const Output& output, const io::StagedFolder& staged) {
  std::vector<std::string> written;
  for (const std::string& file : output.files) {
    if (file.find('*') == std::string::npos) {
      if (fs::exists(staged.path(file))) written.push_back(file);
    } else {
      const auto found = matching_files(file, fs::path(staged.path(file)).parent_path());
      written.insert(written.end(), found.begin(), found.end());
    }
  }
  return written;
}

/// A line about files of an earlier run that could be taken for this one's, such as tiles beyond its last; or nothing.
std::optional<std::string> strangers(const Output& output, const io::StagedFolder& staged,
                                     const std::vector<std::string>& written) {
  std::vector<std::string> others;
  for (const std::string& file : output.files) {
    if (file.find('*') == std::string::npos) continue;
    for (const std::string& name : matching_files(file, fs::path(staged.final_path(file)).parent_path())) {
      if (std::find(written.begin(), written.end(), name) == written.end()) others.push_back(name);
    }
  }
  if (others.empty()) return std::nullopt;
  return fmt::format("{} files with such names are of an earlier run and not part of it: {}{}", others.size(),
                     others[0], others.size() > 1 ? ", ..." : "");
}

/// What an earlier run wrote beside an output of the same name and this one did not, such as a side-car: it would
/// describe the new file wrongly.
void remove_stale_files(const Output& output, const io::StagedFolder& staged, const std::vector<std::string>& written) {
  for (const std::string& file : output.files) {
    if (file.find('*') != std::string::npos || std::find(written.begin(), written.end(), file) != written.end())
      continue;
    std::error_code none_there;
    fs::remove(staged.final_path(file), none_there);
  }
}

void say(const RunContext& run, const Output& output, const std::string& line, OutputReport& report) {
  report.notes.push_back(line);
  run.say(fmt::format("output '{}': {}", output.path, line));
}

/// Stages and commits. Throws IoError for what cannot be written.
std::vector<OutputReport> write_all(const Recipe& recipe, const std::string& out_folder,
                                    const std::function<const Value&(const Source&)>& value,
                                    const std::function<RunContext(size_t)>& part, const RunContext& run,
                                    const RowsWriter& by_rows) {
  if (recipe.outputs.empty()) return {};
  io::StagedFolder staged(out_folder);
  std::vector<OutputReport> reports(recipe.outputs.size());
  std::vector<std::exception_ptr> failures(recipe.outputs.size());
  std::mutex saying;
  tbb::task_group group;
  for (size_t i = 0; i < recipe.outputs.size(); ++i) {
    group.run([&, i] {
      const Output& output = recipe.outputs[i];
      const auto start = std::chrono::steady_clock::now();
      try {
        run.check_cancelled();
        RunContext own = part(i);
        own.note = [&, i](const std::string& line) {
          const std::lock_guard lock(saying);
          say(run, recipe.outputs[i], staged.shown(line), reports[i]);
        };
        write_staged(recipe, output, staged, value, by_rows, own);
        own.report(1.0);
      } catch (...) {
        failures[i] = std::current_exception();
      }
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      reports[i].format = output.format->name;
      reports[i].seconds = seconds;
    });
  }
  group.wait();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  std::vector<std::vector<std::string>> written(recipe.outputs.size());
  for (size_t i = 0; i < recipe.outputs.size(); ++i) {
    const Output& output = recipe.outputs[i];
    written[i] = files_of(output, staged);
    const bool itself = std::find(written[i].begin(), written[i].end(), output.path) != written[i].end();
    reports[i].path = (fs::path(out_folder) / (itself || written[i].empty() ? output.path : written[i][0])).string();
    for (const std::string& file : written[i]) reports[i].files.push_back((fs::path(out_folder) / file).string());
  }
  staged.commit(run);
  for (size_t i = 0; i < recipe.outputs.size(); ++i) {
    const Output& output = recipe.outputs[i];
    remove_stale_files(output, staged, written[i]);
    if (const auto line = strangers(output, staged, written[i])) say(run, output, *line, reports[i]);
  }
  return reports;
}

}  // namespace

io::Provenance provenance_of(const Recipe& recipe) {
  return {std::string("Seamount ") + kVersion, fs::path(recipe.file).filename().string(), recipe.seed.value};
}

std::vector<OutputReport> write_outputs(const Recipe& recipe, const std::string& out_folder,
                                        const std::function<const Value&(const Source&)>& value,
                                        const std::function<RunContext(size_t)>& part, const RunContext& run,
                                        const RowsWriter& by_rows) {
  try {
    return write_all(recipe, out_folder, value, part, run, by_rows);
  } catch (const IoError& error) {
    throw Error(error.what());  // a failure of the work, not of its input
  }
}

}  // namespace seamount::recipe
