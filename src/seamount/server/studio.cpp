#include "seamount/server/studio.h"

#include <fmt/format.h>

#include <filesystem>

#include "seamount/base/version.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/image_file.h"
#include "seamount/recipe/file_info.h"
#include "seamount/recipe/kinds.h"
#include "seamount/server/edit_json.h"
#include "seamount/server/reply.h"
#include "seamount/server/request.h"
#include "seamount/server/schema_json.h"
#include "seamount/server/value_bytes.h"

namespace seamount::server {
namespace {

constexpr size_t kMostFiles = 500;
constexpr size_t kMostInstances = 20000;
constexpr int kExampleColumns = 480;
const std::vector<std::pair<std::string, std::string>> kForEver = {
    {"Cache-Control", "private, max-age=31536000, immutable"}};
constexpr const char* kBlank =
    R"({"seamount": 1, "domain": {"width_m": 10240, "height_m": 10240, "cell_m": 20}, "seed": 0, "steps": []})";

}  // namespace

Studio::Studio(StudioOptions options)
    : options_(std::move(options)), workplace_(options_.folder), schema_(schema_json(*options_.registry).dump()) {
  const SessionOptions session = session_options();
  if (!options_.recipe.empty()) {
    session_ = Session::open_file(options_.recipe, session, hub_);
  } else {
    session_ = Session::resume_unsaved(session, hub_);
    const std::string beginning = options_.beginning.empty() ? kBlank : options_.beginning;
    if (session_ == nullptr) session_ = Session::open_text(beginning, session, hub_);
  }
}

SessionOptions Studio::session_options() const {
  return {.registry = options_.registry,
          .state_folder = options_.state_folder,
          .folder = workplace_.folder(),
          .threads = options_.threads,
          .cache_folder = options_.cache_folder};
}

const std::map<std::string, Studio::Handler>& Studio::handlers() {
  static const std::map<std::string, Handler> kHandlers = {
      {"GET /api/schema", &Studio::get_schema},     {"GET /api/document", &Studio::get_document},
      {"GET /api/events", &Studio::get_events},     {"GET /api/examples", &Studio::get_examples},
      {"GET /api/files", &Studio::get_files},       {"GET /api/download", &Studio::get_download},
      {"POST /api/edits", &Studio::post_edits},     {"POST /api/undo", &Studio::post_undo},
      {"POST /api/redo", &Studio::post_redo},       {"POST /api/text", &Studio::post_text},
      {"POST /api/check", &Studio::post_check},     {"POST /api/want", &Studio::post_want},
      {"POST /api/open", &Studio::post_open},       {"POST /api/save", &Studio::post_save},
      {"POST /api/export", &Studio::post_export},   {"POST /api/cancel", &Studio::post_cancel},
      {"POST /api/refresh", &Studio::post_refresh},
  };
  return kHandlers;
}

Reply Studio::answer(const Request& request) {
  return guarded([&] { return dispatch(request); });
}

Reply Studio::dispatch(const Request& request) {
  const auto found = handlers().find(request.method + " " + request.path);
  if (found != handlers().end()) return (this->*found->second)(request);
  const std::string values = "/api/values/", examples = "/api/examples/", picture = "/picture";
  if (request.method == "GET" && request.path.starts_with(values)) {
    const std::string rest = request.path.substr(values.size());
    if (const size_t slash = rest.find('/'); slash != std::string::npos)
      return get_value(rest.substr(0, slash), rest.substr(slash + 1), request);
  }
  if (request.method == "GET" && request.path.starts_with(examples) && request.path.ends_with(picture) &&
      request.path.size() > examples.size() + picture.size())
    return get_example_picture(
        request.path.substr(examples.size(), request.path.size() - examples.size() - picture.size()));
  return error_reply(404, "there is nothing at " + request.path);
}

std::shared_ptr<Session> Studio::session() const {
  const std::lock_guard lock(mutex_);
  return session_;
}

Reply Studio::get_schema(const Request&) { return {.bytes = schema_}; }

Reply Studio::get_document(const Request&) { return json_reply(session()->document_json()); }

Reply Studio::get_events(const Request& request) {
  const std::string window = query_text(request, "window");
  if (window.size() > 64) throw InvalidArgument("window", "is longer than 64 bytes");
  Reply reply{.type = "application/x-ndjson"};
  reply.stream = hub_.open(window);
  reply.stream->greet(one_line({{"event", "hello"}, {"version", kVersion}, {"revision", session()->revision()}}));
  return reply;
}

Reply Studio::get_examples(const Request&) {
  OrderedJson list = OrderedJson::array();
  for (const Example& example : options_.examples) {
    const size_t slash = example.name.find('/');
    list.push_back({{"name", example.name},
                    {"title", example.title},
                    {"about", example.about},
                    {"group", slash == std::string::npos ? "" : example.name.substr(0, slash)},
                    {"picture", !options_.example_picture(example.name).empty()}});
  }
  return json_reply({{"examples", list}});
}

Reply Studio::get_example_picture(const std::string& name) {
  const std::string file = options_.example_picture(name);
  if (file.empty()) return error_reply(404, "there is no picture of " + name);
  const std::lock_guard lock(pictures_);
  std::string& small = small_pictures_[name];
  if (small.empty()) {
    const auto bytes = picture_bytes(recipe::Value::of<recipe::kinds::Image>(io::read_image(file)), kExampleColumns);
    small.assign(bytes.begin(), bytes.end());
  }
  return {.type = "image/png", .bytes = small, .headers = {{"Cache-Control", "private, max-age=86400"}}};
}

Reply Studio::get_files(const Request&) {
  std::vector<std::string> endings = {".json"};
  for (const recipe::Kind* kind : options_.registry->kinds())
    endings.insert(endings.end(), kind->reads.begin(), kind->reads.end());
  OrderedJson list = OrderedJson::array();
  for (const FileEntry& file : workplace_.list(endings, kMostFiles))
    list.push_back({{"path", file.path}, {"bytes", file.bytes}, {"modified", file.modified}});
  return json_reply({{"folder", workplace_.folder()}, {"files", list}});
}

Reply Studio::get_download(const Request& request) {
  const std::string path = workplace_.resolve(query_text(request, "path"));
  io::check_readable(path);
  return {.type = "application/octet-stream", .headers = {{"Content-Disposition", "attachment"}}, .file = path};
}

Reply Studio::get_raster(const std::string& key, const recipe::Value& value, const Request& request) {
  RasterWindow window{.level = whole_number(request, "level", 0),
                      .x = whole_number(request, "x", 0),
                      .y = whole_number(request, "y", 0)};
  if (request.query.contains("columns")) window.columns = whole_number(request, "columns", 0);
  if (request.query.contains("rows")) window.rows = whole_number(request, "rows", 0);
  RasterBytes raster = raster_bytes(value, window);
  if (whole_number(request, "dry", 0) != 0) {
    if (const auto dry = dry_.bytes(key, value, window)) {
      raster.bytes += *dry;
      raster.type += " dry";
    }
  }
  Reply reply{.type = "application/octet-stream", .bytes = std::move(raster.bytes), .headers = kForEver};
  reply.headers.emplace_back("X-Raster", fmt::format("{} {} {}", raster.columns, raster.rows, raster.type));
  return reply;
}

Reply Studio::get_value(const std::string& key, const std::string& what, const Request& request) {
  const auto value = session()->value(key);
  if (!value) return error_reply(404, "that result is gone");
  if (what == "raster") return get_raster(key, *value, request);
  if (what == "picture") {
    const auto bytes = picture_bytes(*value, 4096);
    return {.type = "image/png", .bytes = std::string(bytes.begin(), bytes.end()), .headers = kForEver};
  }
  if (what == "shapes") return {.bytes = shapes_json(*value), .headers = kForEver};
  if (what == "things") return {.bytes = things_json(*value, kMostInstances), .headers = kForEver};
  if (what == "json") return {.bytes = report_json(*value), .headers = kForEver};
  return error_reply(404, "there is nothing at " + request.path);
}

Reply Studio::post_edits(const Request& request) {
  const Body body(request.body);
  return {.bytes = session()->edit(body.asker(), read_edits(body.list("edits")), body.text_or("gesture", ""),
                                   body.text_or("label", ""), body.flag("ends"))};
}

Reply Studio::post_undo(const Request& request) {
  std::string event = session()->undo(Body(request.body).asker());
  return event.empty() ? error_reply(404, "there is nothing to undo") : Reply{.bytes = std::move(event)};
}

Reply Studio::post_redo(const Request& request) {
  std::string event = session()->redo(Body(request.body).asker());
  return event.empty() ? error_reply(404, "there is nothing to redo") : Reply{.bytes = std::move(event)};
}

Reply Studio::post_text(const Request& request) {
  const Body body(request.body);
  return {.bytes = session()->replace_text(body.asker(), body.text("text"))};
}

Reply Studio::post_check(const Request& request) {
  return json_reply({{"diagnostics", write_diagnostics(session()->check(Body(request.body).text("text")))}});
}

Reply Studio::post_want(const Request& request) {
  const Body body(request.body);
  static const std::map<std::string, recipe::Quality> kQualities = {
      {"coarse", recipe::Quality::coarse},
      {"full", recipe::Quality::full},
      {"coarse_then_full", recipe::Quality::coarse_then_full}};
  const auto quality = kQualities.find(body.text_or("quality", "coarse_then_full"));
  if (quality == kQualities.end()) throw InvalidArgument("quality", "is coarse, full or coarse_then_full");
  std::vector<std::string> sources;
  for (const OrderedJson& source : body.list("sources")) {
    if (!source.is_string() || sources.size() > 1000) throw InvalidArgument("sources", "is no list of \"step.port\"");
    sources.push_back(source.get<std::string>());
  }
  session()->want(body.window(), sources, quality->second);
  return json_reply(OrderedJson::object());
}

Reply Studio::opened(std::unique_ptr<Session> session) {
  const std::shared_ptr<Session> next = std::move(session);
  std::shared_ptr<Session> before;
  {
    const std::lock_guard lock(mutex_);
    before = std::exchange(session_, next);
  }
  before->retire();
  hub_.forget_states();
  OrderedJson document = next->document_json();
  hub_.publish(one_line({{"event", "opened"}, {"file", document["file"]}, {"revision", document["revision"]}}));
  return json_reply(document);
}

Reply Studio::post_open(const Request& request) {
  const Body body(request.body);
  const SessionOptions options = session_options();
  if (body.has("path")) {
    const std::string path = workplace_.resolve(body.text("path"));
    if (session()->file() == path) return json_reply(session()->document_json());
    return opened(Session::open_file(path, options, hub_));
  }
  if (body.has("example"))
    return opened(Session::open_text(options_.example_text(body.text("example"), workplace_.folder()), options, hub_));
  OrderedJson blank = OrderedJson::parse(kBlank);
  OrderedJson& domain = blank["domain"];
  domain["width_m"] = body.number_or("width_m", domain["width_m"].get<double>());
  domain["height_m"] = body.number_or("height_m", domain["width_m"].get<double>());
  domain["cell_m"] = body.number_or("cell_m", domain["cell_m"].get<double>());
  return opened(Session::open_text(blank.dump(), options, hub_));
}

Reply Studio::post_save(const Request& request) {
  const Body body(request.body);
  std::string path = session()->file();
  if (body.has("path")) {
    std::string name = body.text("path");
    if (!name.empty() && io::extension_of(name) != ".json") name += ".json";
    path = workplace_.resolve(name);
  }
  if (path.empty()) throw InvalidArgument("path", "is missing: the document has no file yet");
  const auto before = session();
  if (std::filesystem::path(path).parent_path() != before->document_folder()) opened(before->save_elsewhere(path));
  return {.bytes = session()->save(body.asker(), path)};
}

Reply Studio::post_export(const Request& request) {
  const Body body(request.body);
  const std::string name = body.text_or("folder", "export");
  const std::string folder = workplace_.resolve(name);
  const auto session = this->session();
  const auto document = std::make_shared<const recipe::Document>(session->with_outputs(body.list("outputs")));
  if (document->json().value("outputs", OrderedJson()).empty()) throw InvalidArgument("outputs", "is empty");
  const auto size_of = [this](const std::string& path) -> uint64_t {
    std::error_code error;
    const auto bytes = std::filesystem::file_size(std::filesystem::path(workplace_.folder()) / path, error);
    return error ? 0 : bytes;
  };
  const auto work = [this, session, document, folder](const RunContext& run) {
    std::vector<std::string> files;
    for (const auto& output : session->engine().write_outputs(*document, folder, run).outputs) {
      for (const std::string& file : output.files.empty() ? std::vector{output.path} : output.files)
        files.push_back(std::filesystem::absolute(file).lexically_relative(workplace_.folder()).generic_string());
    }
    return files;
  };
  return json_reply({{"job", jobs_.begin("Export to " + name, work, size_of)}});
}

Reply Studio::post_cancel(const Request& request) {
  const Body body(request.body);
  if (!body.has("job")) {
    session()->cancel();
  } else if (!jobs_.cancel(body.text("job"))) {
    return error_reply(404, "there is no such job");
  }
  return json_reply(OrderedJson::object());
}

Reply Studio::post_refresh(const Request&) {
  session()->refresh();
  return json_reply(OrderedJson::object());
}

Reply Studio::upload(const Request& request, const Receive& receive) {
  return guarded([&] {
    const std::string name = query_text(request, "name");
    const std::string file = session()->file();
    const std::filesystem::path near = file.empty()
                                           ? std::filesystem::path("unsaved.json")
                                           : std::filesystem::path(file).lexically_relative(workplace_.folder());
    const std::string folder = (near.parent_path() / (near.stem().string() + ".files")).generic_string();
    const std::string kept = workplace_.keep(folder, name, receive);
    const std::string path = (std::filesystem::path(workplace_.folder()) / kept).string();
    OrderedJson info = OrderedJson::object();
    std::string kind;
    try {
      kind = recipe::kind_of_file(path, *options_.registry).name;
      for (const auto& [what, text] : recipe::describe_file(path, *options_.registry)) {
        if (what != "file") info[what] = text;
      }
    } catch (const Error& error) {
      info["problem"] = error.what();
    }
    const auto beside = std::filesystem::path(kept).lexically_relative(near.parent_path());
    return json_reply(
        {{"file", near.parent_path().empty() ? kept : beside.generic_string()}, {"kind", kind}, {"info", info}});
  });
}

}  // namespace seamount::server
