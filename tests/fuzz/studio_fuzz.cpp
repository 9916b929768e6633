// Requests to the studio: "METHOD PATH?NAME=VALUE", a line break, the body, in which '@' stands for the newest
// revision. Whatever comes is answered with JSON or refused with a reason, never by a failure of the server; and the
// document stays one that can be read again. What computes or writes results is left out.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#include "seamount/server/studio.h"

namespace {

using namespace seamount;

class Target {
 public:
  Target()
      : folder_((std::filesystem::temp_directory_path() / ("seamount_fuzz_" + std::to_string(::getpid()))).string()) {
    std::filesystem::create_directories(folder_ + "/work");
    server::StudioOptions options{.registry = &recipe::standard_registry(), .folder = folder_ + "/work"};
    options.state_folder = folder_ + "/state";
    options.example_text = [](const std::string&, const std::string&) -> std::string {
      throw InvalidArgument("example", "there is none");
    };
    options.example_picture = [](const std::string&) { return ""; };
    studio_ = std::make_unique<server::Studio>(std::move(options));
  }
  ~Target() {
    studio_.reset();
    std::filesystem::remove_all(folder_);
  }
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

  void ask(const server::Request& request) {
    if (++asked_ % 64 == 0) studio_->answer({"POST", "/api/open", {}, "{\"blank\": true}"});
    const server::Reply reply = studio_->answer(request);
    if (reply.status == 500 || reply.status < 200) std::abort();
    if (reply.type != "application/json") return;
    const recipe::OrderedJson json = recipe::OrderedJson::parse(reply.bytes);
    if (reply.status != 200 && json.at("error").get<std::string>().empty()) std::abort();
  }

  std::string revision() {
    return recipe::OrderedJson::parse(studio_->answer({"GET", "/api/document", {}, ""}).bytes)["revision"].dump();
  }

  void read_again() {
    const auto document = recipe::OrderedJson::parse(studio_->answer({"GET", "/api/document", {}, ""}).bytes);
    recipe::Document(document["text"].get<std::string>(), "again", "");
  }

 private:
  std::string folder_;
  std::unique_ptr<server::Studio> studio_;
  int asked_ = 0;
};

std::string with_revision(const std::string& text, const std::string& revision) {
  std::string result;
  for (const char c : text) result += c == '@' ? revision : std::string(1, c);
  return result;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static Target target;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::string head = text.substr(0, text.find('\n'));
  const size_t blank = head.find(' ');
  if (blank == std::string::npos) return 0;
  std::string path = head.substr(blank + 1);
  server::Request request{head.substr(0, blank), path.substr(0, path.find('?')), {}, ""};
  for (size_t at = path.find('?'); at != std::string::npos; at = path.find('&', at + 1)) {
    const std::string pair = path.substr(at + 1, path.find('&', at + 1) - at - 1);
    request.query[pair.substr(0, pair.find('='))] =
        pair.find('=') == std::string::npos ? "" : pair.substr(pair.find('=') + 1);
  }
  for (const char* left_out : {"/api/want", "/api/export", "/api/save"}) {
    if (request.path == left_out) return 0;
  }
  if (head.size() < text.size()) request.body = with_revision(text.substr(head.size() + 1), target.revision());
  target.ask(request);
  target.read_again();
  return 0;
}
