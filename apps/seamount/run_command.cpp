#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app.h"
#include "seamount/base/printable.h"
#include "seamount/io/image_file.h"
#include "seamount/ops/render/contact_sheet.h"
#include "seamount/recipe/kinds.h"
#include "sweep.h"

namespace seamount::app {
namespace {

struct Flags : RunFlags {
  std::string file;
  std::string out = "out";
  std::vector<std::string> sets;
  std::vector<std::string> sweeps;
  bool sheet = false;
  std::optional<int> size;
};

/// The outputs that are pictures, by their paths below the output folder.
std::vector<std::string> pictures_of(const recipe::Recipe& recipe) {
  std::vector<std::string> paths;
  for (const recipe::Output& output : recipe.outputs) {
    const auto step = std::find_if(recipe.steps.begin(), recipe.steps.end(),
                                   [&](const recipe::Step& one) { return one.id == output.from.step; });
    if (step == recipe.steps.end()) continue;
    const recipe::Port* port = step->op->find_out(output.from.port);
    const std::string extension = std::filesystem::path(output.path).extension().string();
    const bool readable = extension == ".png" || extension == ".jpg" || extension == ".jpeg";
    if (port != nullptr && port->kind == &recipe::kinds::Image::kind() && readable) paths.push_back(output.path);
  }
  return paths;
}

std::string run_folder(const Flags& flags, size_t run) { return fmt::format("{}/{:04}", flags.out, run + 1); }

/// sheet.png: of each run the same picture, its values under it. Of several pictures a sheet each: sheet_view.png.
void write_sheets(const Flags& flags, const Sweep& sweep, const std::vector<std::string>& pictures) {
  for (const std::string& picture : pictures) {
    std::vector<render::SheetCell> cells;
    for (size_t k = 0; k < sweep.runs.size(); ++k)
      cells.push_back({io::read_image(run_folder(flags, k) + "/" + picture), sweep.runs[k].caption});
    std::string name = picture.substr(0, picture.rfind('.'));
    std::replace(name.begin(), name.end(), '/', '_');
    const std::string path = flags.out + (pictures.size() == 1 ? "/sheet.png" : "/sheet_" + name + ".png");
    io::write_png(render::contact_sheet(cells, sweep.columns), path);
    fmt::print("{}\n", printable(path));
  }
}

void run_sweep(const Flags& flags, const std::function<recipe::Recipe(const std::vector<std::string>&)>& read,
               tiles::Ranks* ranks) {
  if (flags.out.empty()) throw InvalidArgument("--out", "a folder name is needed");
  const Sweep sweep = parse_sweeps(flags.sweeps);
  std::vector<recipe::Recipe> runs;  // all are checked before the first begins
  for (const SweepRun& run : sweep.runs) {
    std::vector<std::string> sets = flags.sets;
    sets.insert(sets.end(), run.sets.begin(), run.sets.end());
    runs.push_back(read(sets));
  }
  const std::vector<std::string> pictures = pictures_of(runs.front());
  if (flags.sheet && pictures.empty())
    throw InvalidArgument("--sheet",
                          "the recipe has no output that is a picture: add one \"as\": \"perspective\" or \"map\"");
  const bool first = ranks == nullptr || ranks->first();
  for (size_t k = 0; k < runs.size(); ++k) {
    if (first) print_message(fmt::format("{:04}: {}", k + 1, sweep.runs[k].caption));
    run_and_report(runs[k], run_folder(flags, k), flags, ranks);
  }
  if (flags.sheet && first) write_sheets(flags, sweep, pictures);
}

}  // namespace

void add_run_command(Command program, const recipe::Registry& registry) {
  const auto flags = std::make_shared<Flags>();
  Command command = program.add_command("run", "Run a recipe and write its outputs");
  command.add("recipe", &flags->file, "recipe file (JSON)").required();
  command.add("--out", &flags->out, "folder for the outputs");
  command.add(
      "--set", &flags->sets,
      "change a value: steps.isle.params.relief=0.5, outputs.0.width_px=640, variables.age=0.3, domain.cell_m=5");
  command.add("--sweep", &flags->sweeps,
              "run once for each value, into folders 0001, 0002, ... of --out: frames of an animation, variants. "
              "steps.worn.params.years=0:100000:11 (FROM:TO:COUNT), seed=1,2,3; several: all combinations");
  command.add_switch("--sheet", flags->sheet, "write the pictures of a sweep side by side too, as sheet.png in --out");
  command.add("--size", &flags->size, "cells along the longer side: a quick preview, or more detail").between(1, 65536);
  command.add("--tiles", &flags->tiles, "run in tiles of so many cells along a side: worlds larger than memory")
      .between(1, 65536);
  command
      .add("--memory", &flags->memory_gb,
           "gigabytes that a step which looks at everything may take with --tiles; half of the machine's if left out")
      .finite();
  add_run_flags(command, *flags);
  command.does([flags, &registry] {
    if (flags->memory_gb && flags->tiles == 0) throw InvalidArgument("--memory", "is for a run with --tiles");
    if (flags->memory_gb && !(*flags->memory_gb > 0)) throw InvalidArgument("--memory", "is not above 0");
    const auto read = [&](const std::vector<std::string>& sets) {
      return recipe::read_recipe(flags->file,
                                 {.sets = sets, .seed = flags->seed, .size = flags->size, .tiled = flags->tiles > 0},
                                 registry, {.cancelled = &cancel_flag()});
    };
    if (flags->sheet && flags->sweeps.empty()) throw InvalidArgument("--sheet", "is for the pictures of a --sweep");
    run_as_ranks(*flags, [&](tiles::Ranks* ranks) {
      if (ranks != nullptr) tiles::by_first(*ranks, [&] { read(flags->sets); });  // what is wrong is said by rank 0
      if (!flags->sweeps.empty()) return run_sweep(*flags, read, ranks);
      run_and_report(read(flags->sets), flags->out, *flags, ranks);
    });
  });
}

}  // namespace seamount::app
