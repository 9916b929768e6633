#include "seamount/recipe/run_outputs.h"

#include <fmt/format.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <mutex>

#include "seamount/base/version.h"
#include "seamount/io/staged_folder.h"

namespace seamount::recipe {
namespace {

namespace fs = std::filesystem;

/// One output into the staged folder; errors get the output's name, and the names that its files will have.
void write_staged(const Recipe& recipe, const Output& output, const io::StagedFolder& staged,
                  const std::function<const Value&(const Source&)>& value, const RunContext& run) {
  Values prepared;
  for (const auto& [name, source] : output.prepared) prepared[name] = value(source);
  const io::Provenance provenance{std::string("Seamount ") + kVersion, fs::path(recipe.file).filename().string(),
                                  recipe.seed.value};
  try {
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

/// Stages and commits. Throws IoError for what cannot be written.
std::vector<OutputReport> write_all(const Recipe& recipe, const std::string& out_folder,
                                    const std::function<const Value&(const Source&)>& value,
                                    const std::function<RunContext(size_t)>& part, const RunContext& run) {
  if (recipe.outputs.empty()) return {};
  io::StagedFolder staged(out_folder);
  std::vector<OutputReport> reports(recipe.outputs.size());
  std::vector<std::vector<std::string>> notes(recipe.outputs.size());
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
          notes[i].push_back(staged.shown(line));
          run.say(fmt::format("output '{}': {}", output.path, notes[i].back()));
        };
        write_staged(recipe, output, staged, value, own);
        own.report(1.0);
      } catch (...) {
        failures[i] = std::current_exception();
      }
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      reports[i] = {(fs::path(out_folder) / output.path).string(), output.format->name, seconds, notes[i]};
    });
  }
  group.wait();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  std::vector<std::vector<std::string>> written(recipe.outputs.size());
  for (size_t i = 0; i < recipe.outputs.size(); ++i) {
    for (const std::string& file : recipe.outputs[i].files) {
      if (fs::exists(staged.path(file))) written[i].push_back(file);
    }
  }
  staged.commit(run);
  for (size_t i = 0; i < recipe.outputs.size(); ++i) remove_stale_files(recipe.outputs[i], staged, written[i]);
  return reports;
}

}  // namespace

std::vector<OutputReport> write_outputs(const Recipe& recipe, const std::string& out_folder,
                                        const std::function<const Value&(const Source&)>& value,
                                        const std::function<RunContext(size_t)>& part, const RunContext& run) {
  try {
    return write_all(recipe, out_folder, value, part, run);
  } catch (const IoError& error) {
    throw Error(error.what());  // a failure of the work, not of its input
  }
}

}  // namespace seamount::recipe
