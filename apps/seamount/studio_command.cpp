// studio: the server of the browser studio.
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <thread>

#include "app.h"
#include "examples.h"
#include "seamount/base/printable.h"
#include "seamount/io/atomic_file.h"
#include "seamount/server/http.h"
#include "seamount/server/page.h"

extern char** environ;

namespace seamount::app {
namespace {

namespace fs = std::filesystem;

constexpr int kPort = 8421;
constexpr const char* kExampleFolder = "example-data/";
constexpr const char* kBeginning = "island";  // names no data

struct Flags {
  std::string recipe, folder, host = "127.0.0.1", state;
  std::optional<int> port;
  int threads = 0;
  bool no_browser = false, no_cache = false;
};

/// The title of "reef/platform" for people, who see it among its group: "Platform".
std::string title_of(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  if (const size_t slash = name.find('/'); slash != std::string::npos) name.erase(0, slash + 1);
  if (!name.empty()) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

std::vector<server::Example> studio_examples() {
  std::vector<server::Example> examples;
  for (const Example& example : example_files()) {
    if (!has_name(example) || is_catalogue(example)) continue;
    const std::string name(example.file.substr(0, example.file.size() - 5));
    examples.push_back({name, title_of(name), example_about(example)});
  }
  return examples;
}

std::string write_example(const std::string& name, const std::string& folder) {
  const Example& example = find_example(name);
  if (is_catalogue(example)) throw InvalidArgument("example", "'" + name + "' is a catalogue, no recipe");
  return example_text(example, kExampleFolder, [&](const Example& data) {
    const fs::path path = fs::path(folder) / kExampleFolder / data.file;
    const auto* bytes = reinterpret_cast<const uint8_t*>(data.content.data());
    if (!fs::exists(path)) io::write_bytes(path.string(), {bytes, data.content.size()});
  });
}

/// The picture of an example, made when the page of the studio is built or the program is installed.
std::string example_picture(const std::string& page_folder, std::string name) {
  std::replace(name.begin(), name.end(), '/', '_');
  for (const char* ending : {".jpg", ".png"}) {
    fs::path path = fs::path(page_folder) / "examples" / (name + ending);
    std::error_code error;
    if (name.find("..") == std::string::npos && fs::is_regular_file(path, error)) return path.string();
  }
  return "";
}

/// Opens an address in the user's browser, if there is a program for it.
void open_in_browser(const std::string& address) {
  std::string program = "xdg-open", argument = address;
  char* arguments[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  if (posix_spawnp(&child, program.c_str(), nullptr, nullptr, arguments, environ) == 0)
    std::thread([child] { ::waitpid(child, nullptr, 0); }).detach();
}

server::StudioOptions options_of(const Flags& flags, const std::string& page, const recipe::Registry& registry) {
  server::StudioOptions options{.registry = &registry};
  fs::path recipe = flags.recipe.empty() ? fs::path() : fs::absolute(flags.recipe);
  options.folder = !flags.folder.empty() ? flags.folder : recipe.empty() ? "." : recipe.parent_path().string();
  if (!recipe.empty()) options.recipe = fs::weakly_canonical(recipe).string();
  options.state_folder = flags.state.empty() ? server::default_state_folder() : flags.state;
  options.cache_folder = flags.no_cache ? "" : recipe::Cache::default_folder();
  options.threads = flags.threads;
  options.beginning = find_example(kBeginning).content;
  options.examples = studio_examples();
  options.example_text = write_example;
  options.example_picture = [page](const std::string& name) { return example_picture(page, name); };
  return options;
}

std::unique_ptr<server::HttpServer> take_port(server::Studio& studio, const std::string& page, const Flags& flags) {
  if (flags.port)
    return std::make_unique<server::HttpServer>(studio, page, server::HttpOptions{flags.host, *flags.port});
  try {
    return std::make_unique<server::HttpServer>(studio, page, server::HttpOptions{flags.host, kPort});
  } catch (const Error&) {  // another studio has it
    return std::make_unique<server::HttpServer>(studio, page, server::HttpOptions{flags.host, 0});
  }
}

void serve(const Flags& flags, const recipe::Registry& registry) {
  const std::string page = server::find_page();
  server::Studio studio(options_of(flags, page, registry));
  const auto server = take_port(studio, page, flags);
  std::cout << server->address() << "\n" << std::flush;
  if (flags.host != "127.0.0.1" && flags.host != "localhost")
    print_message("seamount: the studio can be reached from other machines; whoever has its address may use it");
  print_message("seamount: the studio runs until Ctrl-C");
  if (!flags.no_browser) open_in_browser(server->address());
  std::thread listening([&] { server->listen(); });
  while (!cancel_flag()) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  server->stop();
  listening.join();
  cancel_flag() = false;  // it was asked to end, and does so as it should
}

}  // namespace

void add_studio_command(Command program, const recipe::Registry& registry) {
  const auto flags = std::make_shared<Flags>();
  Command command = program.add_command("studio", "Open the studio in a browser");
  command.add("recipe", &flags->recipe, "recipe file (JSON) to open; left out: what was left unsaved, or an example");
  command.add("--folder", &flags->folder, "folder that the studio works in; the recipe's, or the present one");
  command.add("--host", &flags->host, "address of this machine to listen at");
  command.add("--port", &flags->port, "port; left out: 8421, or one that is free").between(1, 65535);
  command.add("--state", &flags->state, "folder of what is not saved yet");
  command.add("--threads", &flags->threads, "threads to use; 0: all processors").between(0, 1024);
  command.add_switch("--no-browser", flags->no_browser, "print the address, open no browser");
  command.add_switch("--no-cache", flags->no_cache, "keep no results on disk");
  command.does([flags, &registry] { serve(*flags, registry); });
}

}  // namespace seamount::app
