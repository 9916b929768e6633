// convert, info, render: daily chores with files, made as small recipes where that is what they are.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <sstream>

#include "app.h"
#include "seamount/base/printable.h"
#include "seamount/io/private_folder.h"
#include "seamount/io/vector.h"
#include "seamount/recipe/file_info.h"
#include "seamount/recipe/recipe.h"
#include "seamount/recipe/terrain_info.h"

namespace seamount::app {
namespace {

namespace fs = std::filesystem;
using recipe::Json;

struct ChoreFlags : RunFlags {
  std::string in;
  std::vector<std::string> files;
  std::string out;
  std::string as;
  std::string labels;
  std::string like;
  std::string feature;
  std::string layer;
  std::string crs;
  std::string unit;
  std::string coding;
  std::string byte_order;
  std::optional<int> band;
  std::optional<int> size;
  std::optional<double> cell_m, low_m, high_m;
  std::string at, at_lonlat;
  std::vector<std::string> sets;
};

bool is_drawing(const std::string& file) {
  const std::string extension = fs::path(file).extension().string();
  return extension == ".geojson" || extension == ".gpkg" || extension == ".shp" || extension == ".json" ||
         extension == ".svg";
}

/// "name=value" or "group.name=value" of an output format's parameter.
void set_member(Json& output, const std::string& assignment) {
  const size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InvalidArgument("--set", "expected NAME=VALUE, found '" + assignment + "'");
  const Json value = Json::parse(assignment.substr(equals + 1), nullptr, false);
  const std::string name = assignment.substr(0, equals);
  Json* object = &output;
  std::string rest = name;
  for (size_t dot = rest.find('.'); dot != std::string::npos; dot = rest.find('.')) {
    object = &(*object)[rest.substr(0, dot)];
    if (!object->is_object() && !object->is_null())
      throw InvalidArgument("--set", "'" + name.substr(0, name.size() - rest.size() + dot) + "' is given already");
    rest = rest.substr(dot + 1);
  }
  if (object->contains(rest)) throw InvalidArgument("--set", "'" + name + "' is given already");
  (*object)[rest] = value.is_discarded() ? Json(assignment.substr(equals + 1)) : value;
}

/// A flag that has no part in the work is an error, not ignored.
void refuse_flags(const ChoreFlags& flags, bool drawing) {
  const auto refuse = [&](const char* flag, bool given, bool for_drawings) {
    if (given && for_drawings != drawing)
      throw InvalidArgument(flag, std::string("is for ") + (for_drawings ? "areas and lines, " : "terrains, ") +
                                      flags.in + (drawing ? " holds areas and lines" : " holds a terrain"));
  };
  refuse("--feature", !flags.feature.empty(), true);
  refuse("--layer", !flags.layer.empty(), true);
  refuse("--as", !flags.as.empty(), false);
  refuse("--size", flags.size.has_value(), false);
  refuse("--cell", flags.cell_m.has_value(), false);
  refuse("--low", flags.low_m.has_value(), false);
  refuse("--high", flags.high_m.has_value(), false);
  refuse("--unit", !flags.unit.empty(), false);
  refuse("--coding", !flags.coding.empty(), false);
  refuse("--byte-order", !flags.byte_order.empty(), false);
  refuse("--band", flags.band.has_value(), false);
  refuse("--set", !flags.sets.empty(), false);
}

/// Areas and lines as they are; a terrain by importing it and writing one output.
void convert(const ChoreFlags& flags) {
  refuse_flags(flags, is_drawing(flags.in));
  if (is_drawing(flags.in)) {
    if (std::error_code none_there; fs::equivalent(flags.in, flags.out, none_there))
      throw InvalidArgument("out", "would be written over the input " + flags.in);
    const fs::path folder = fs::path(flags.out).parent_path();
    io::PrivateFolder::remove_abandoned(folder.empty() ? "." : folder);
    RunContext run{.cancelled = &cancel_flag()};
    run.note = [](const std::string& line) { std::cerr << "note: " << printable(line) << "\n"; };
    io::write_drawing(
        io::read_drawing(flags.in, {.feature = flags.feature, .layer = flags.layer, .crs = flags.crs}, run), flags.out);
    std::cout << printable(flags.out) << "\n";
    return;
  }
  Json step = {{"id", "file"}, {"op", "terrain.import"}, {"params", {{"file", absolute_file("in", flags.in)}}}};
  if (flags.cell_m) step["params"]["cell_m"] = *flags.cell_m;
  if (flags.low_m) step["params"]["low_m"] = *flags.low_m;
  if (flags.high_m) step["params"]["high_m"] = *flags.high_m;
  if (flags.band) step["params"]["band"] = *flags.band;
  for (const auto& [name, text] :
       {std::pair("crs", flags.crs), {"unit", flags.unit}, {"coding", flags.coding}, {"byte_order", flags.byte_order}})
    if (!text.empty()) step["params"][name] = text;
  const fs::path out(flags.out);
  Json output = {{"from", "file.terrain"}, {"path", out.filename().string()}};
  if (!flags.as.empty()) output["as"] = flags.as;
  if (flags.size) output["size"] = *flags.size;
  for (const std::string& assignment : flags.sets) set_member(output, assignment);
  const Json document = {{"seamount", 1}, {"steps", {step}}, {"outputs", {output}}};
  const FlagNames names = {{"/steps/0/params/cell_m", "--cell"},
                           {"/steps/0/params/low_m", "--low"},
                           {"/steps/0/params/high_m", "--high"},
                           {"/steps/0/params/band", "--band"},
                           {"/steps/0/params/coding", "--coding"},
                           {"/steps/0/params/byte_order", "--byte-order"},
                           {"/outputs/0/path", "out"},
                           {"/outputs/0/as", "--as"},
                           {"/outputs/0/size", "--size"},
                           {"/outputs/0/", "--set "}};
  const recipe::Recipe recipe = parse_made_recipe(document, "convert", names);
  run_and_report(recipe, out.has_parent_path() ? out.parent_path().string() : ".", flags);
}

/// Neighbouring files as one.
void join(const ChoreFlags& flags) {
  Json files = Json::array();
  for (const std::string& file : flags.files) files.push_back(absolute_file("files", file));
  Json step = {{"id", "joined"}, {"op", "terrain.join"}, {"params", {{"files", files}}}};
  for (const auto& [name, text] : {std::pair("crs", flags.crs), {"unit", flags.unit}, {"coding", flags.coding}})
    if (!text.empty()) step["params"][name] = text;
  const fs::path out(flags.out);
  Json output = {{"from", "joined.terrain"}, {"path", out.filename().string()}};
  if (!flags.as.empty()) output["as"] = flags.as;
  for (const std::string& assignment : flags.sets) set_member(output, assignment);
  const Json document = {{"seamount", 1}, {"steps", {step}}, {"outputs", {output}}};
  const FlagNames names = {{"/steps/0/params/files", "files"},
                           {"/steps/0/params/coding", "--coding"},
                           {"/outputs/0/path", "--out"},
                           {"/outputs/0/as", "--as"},
                           {"/outputs/0/", "--set "}};
  const recipe::Recipe recipe = parse_made_recipe(document, "join", names);
  run_and_report(recipe, out.has_parent_path() ? out.parent_path().string() : ".", flags);
}

/// How a file is drawn: a map of contours has a form of its own.
std::string picture_of(const ChoreFlags& flags) {
  if (!is_drawing(flags.in)) return flags.as.empty() ? "perspective" : flags.as;
  if (flags.as.empty() || flags.as == "map" || flags.as == "contours") return "contours";
  throw InvalidArgument("--as", "'" + flags.as + "' draws terrains, " + flags.in +
                                    " holds lines; draw them as contours, or make a terrain of them with "
                                    "contour.reconstruct");
}

/// The parameters of a recipe's first picture of this kind.
Json params_like(const std::string& file, const std::string& picture, const recipe::Registry& registry) {
  const recipe::Recipe recipe = recipe::read_recipe(file, {}, registry, {.cancelled = &cancel_flag()});
  for (const recipe::Step& step : recipe.steps)
    if (step.op->name == "render." + picture) return step.params;
  throw InvalidArgument("--like", file + " makes no picture of the kind '" + picture + "'");
}

/// A picture of a terrain or of contours.
void render(const ChoreFlags& flags, const recipe::Registry& registry) {
  const std::string picture = picture_of(flags);
  Json step = {{"id", "picture"},
               {"op", "render." + picture},
               {"in", {{picture == "contours" ? "contours" : "terrain", {{"file", absolute_file("file", flags.in)}}}}},
               {"params", Json::object()}};
  if (!flags.labels.empty()) step["in"]["labels"] = {{"file", absolute_file("--labels", flags.labels)}};
  Json set = Json::object();
  for (const std::string& assignment : flags.sets) set_member(set, assignment);
  if (flags.like.empty()) {
    step["params"] = std::move(set);
  } else {
    step["params"] = params_like(flags.like, picture, registry);
    step["params"].merge_patch(set);
  }
  const fs::path out(flags.out);
  const Json document = {{"seamount", 1},
                         {"steps", {step}},
                         {"outputs", {{{"from", "picture.image"}, {"path", out.filename().string()}}}}};
  const FlagNames names = {{"/steps/0/op", "--as"}, {"/steps/0/params/", "--set "}, {"/outputs/0/path", "--out"}};
  const recipe::Recipe recipe = parse_made_recipe(document, "render", names);
  run_and_report(recipe, out.has_parent_path() ? out.parent_path().string() : ".", flags);
}

/// "x,y" in metres or degrees.
Vec2 place_of(const char* flag, const std::string& text) {
  std::istringstream in(text);
  Vec2 place;
  char comma = 0, more = 0;
  if (!(in >> place.x >> comma >> place.y) || comma != ',' || in >> more || !std::isfinite(place.x + place.y))
    throw InvalidArgument(flag, "expected two numbers as 'x,y', found '" + text + "'");
  return place;
}

io::FileInfo info_lines(const recipe::Registry& registry, const ChoreFlags& flags) {
  const bool lonlat = !flags.at_lonlat.empty();
  if (flags.at.empty() && !lonlat) {
    if (!flags.labels.empty()) throw InvalidArgument("--labels", "tells the region of a place: give --at as well");
    return recipe::describe_file(flags.in, registry);
  }
  if (lonlat && !flags.at.empty()) throw InvalidArgument("--at-lonlat", "and --at are two places; give one");
  const char* flag = lonlat ? "--at-lonlat" : "--at";
  try {
    return recipe::describe_place(flags.in,
                                  {place_of(flag, lonlat ? flags.at_lonlat : flags.at), lonlat, flags.labels});
  } catch (const InvalidArgument& error) {
    if (error.field() != "at") throw;
    throw InvalidArgument(flag, std::string(error.what()).substr(error.field().size() + 2));
  }
}

void info(const recipe::Registry& registry, const ChoreFlags& flags) {
  const io::FileInfo lines = info_lines(registry, flags);
  if (flags.json) {
    Json object = Json::object();
    for (const auto& [key, value] : lines) object[key] = value;
    std::cout << shown(object) << "\n";
    return;
  }
  size_t width = 0;
  for (const auto& [key, value] : lines) width = std::max(width, key.size());
  for (const auto& [key, value] : lines) fmt::print("{:<{}}  {}\n", key, width, printable(value));
}

}  // namespace

void add_chore_commands(Command program, const recipe::Registry& registry) {
  const auto flags = std::make_shared<ChoreFlags>();

  Command convert_command = program.add_command("convert", "Convert a terrain between file formats");
  convert_command.add("in", &flags->in, "terrain file").required();
  convert_command.add("out", &flags->out, "file to write; its extension is the format").required();
  convert_command.add("--as", &flags->as, "output format, where the extension does not say: unreal, unity, mesh, ...");
  convert_command.add("--feature", &flags->feature, "name of the one feature to convert, of areas and lines");
  convert_command.add("--layer", &flags->layer, "layer to convert of a file of areas and lines that has several");
  convert_command.add("--crs", &flags->crs,
                      "coordinate system of a file that says none or a wrong one: EPSG:32627, local");
  convert_command.add("--unit", &flags->unit, "unit of a terrain's heights, such as feet, where the file does not say");
  convert_command.add("--coding", &flags->coding, "heights held in colours: terrarium or mapbox");
  convert_command.add("--byte-order", &flags->byte_order, "of a raw 16-bit file: little (default) or big");
  convert_command.add("--band", &flags->band, "band of a raster with several").between(1, 1000);
  convert_command.add("--size", &flags->size, "samples a side, for engines");
  convert_command.add("--cell", &flags->cell_m, "cell size in metres, where the file does not say").finite();
  convert_command.add("--low", &flags->low_m, "height of the lowest code of an 8- or 16-bit image, in metres").finite();
  convert_command.add("--high", &flags->high_m, "height of the highest code, in metres").finite();
  convert_command.add("--set", &flags->sets, "a parameter of the output format: NAME=VALUE");
  add_run_flags(convert_command, *flags);
  convert_command.does([=] { convert(*flags); });

  Command join_command = program.add_command("join", "Join neighbouring terrain files, cell by cell");
  join_command.add("files", &flags->files, "files that say where they lie; where they overlap the first counts")
      .required();
  join_command.add("--out", &flags->out, "file to write; its extension is the format").required();
  join_command.add("--as", &flags->as, "output format, where the extension does not say: unreal, unity, mesh, ...");
  join_command.add("--crs", &flags->crs, "coordinate system, where the files say none or a wrong one");
  join_command.add("--unit", &flags->unit, "unit of the heights, where the files do not say");
  join_command.add("--coding", &flags->coding, "heights held in colours: terrarium or mapbox");
  join_command.add("--set", &flags->sets, "a parameter of the output format: NAME=VALUE");
  add_run_flags(join_command, *flags);
  join_command.does([=] { join(*flags); });

  Command info_command = program.add_command("info", "Say what a file is, and the numbers to type into an engine");
  info_command.add("file", &flags->in, "any file that Seamount reads").required();
  info_command.add("--at", &flags->at, "what a raster has at a place, x,y in metres: height, slope");
  info_command.add("--at-lonlat", &flags->at_lonlat, "the same at longitude,latitude in degrees");
  info_command.add("--labels", &flags->labels, "with a place: label map that tells its region");
  info_command.add_switch("--json", flags->json, "as JSON");
  info_command.does([=, &registry] { info(registry, *flags); });

  Command render_command = program.add_command("render", "Draw a terrain or contours");
  render_command.add("file", &flags->in, "file of a terrain or of contours").required();
  render_command.add("--out", &flags->out, "picture to write (.png, .jpg)").required();
  render_command.add("--as", &flags->as, "perspective (default), map, relief or texture; of contours: contours");
  render_command.add("--labels", &flags->labels, "label map that goes with it");
  render_command.add("--like", &flags->like, "a recipe: as its first picture of this kind is seen; --set changes more");
  render_command.add("--set", &flags->sets, "a parameter of the picture: NAME=VALUE");
  add_run_flags(render_command, *flags);
  render_command.does([=, &registry] { render(*flags, registry); });
}

}  // namespace seamount::app
