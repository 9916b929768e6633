// What the studio answers, without the network: requests in, replies out. The protocol is written down with its types
// in studio/src/api/types.ts.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "seamount/server/dry_ground.h"
#include "seamount/server/event_hub.h"
#include "seamount/server/jobs.h"
#include "seamount/server/reply.h"
#include "seamount/server/request.h"
#include "seamount/server/session.h"
#include "seamount/server/workplace.h"

namespace seamount::server {

/// A recipe that can be begun with.
struct Example {
  std::string name;   ///< "kauai", "reef/platform"
  std::string title;  ///< for people
  std::string about;
};

struct StudioOptions {
  const recipe::Registry* registry = nullptr;
  std::string folder;        ///< that it works in
  std::string recipe;        ///< to open, relative or absolute in the folder; empty: what was left, or nothing
  std::string state_folder;  ///< of journals
  std::string cache_folder;  ///< of results; empty: none
  int threads = 0;
  std::string beginning = {};  ///< the recipe's text to begin with where there is nothing to open; empty: a blank one
  std::vector<Example> examples = {};
  /// Writes the files that an example names into a folder; the recipe's text.
  std::function<std::string(const std::string& name, const std::string& folder)> example_text = {};
  /// A picture file of an example; "" if there is none.
  std::function<std::string(const std::string& name)> example_picture = {};
};

class Studio {
 public:
  /// Throws what reading the recipe throws.
  explicit Studio(StudioOptions options);

  /// Answers any request; never throws but for memory. Errors are replies {"error": ...}.
  Reply answer(const Request& request);

  /// The same for POST /api/upload, whose body may be large.
  Reply upload(const Request& request, const Receive& receive);

  /// Ends all streams.
  void close() { hub_.close(); }

 private:
  using Handler = Reply (Studio::*)(const Request&);
  static const std::map<std::string, Handler>& handlers();

  SessionOptions session_options() const;
  std::shared_ptr<Session> session() const;
  Reply opened(std::unique_ptr<Session> session);

  Reply get_schema(const Request& request);
  Reply get_document(const Request& request);
  Reply get_events(const Request& request);
  Reply get_examples(const Request& request);
  Reply get_files(const Request& request);
  Reply get_download(const Request& request);
  Reply get_example_picture(const std::string& name);
  Reply get_raster(const std::string& key, const recipe::Value& value, const Request& request);
  Reply get_value(const std::string& key, const std::string& what, const Request& request);
  Reply post_edits(const Request& request);
  Reply post_undo(const Request& request);
  Reply post_redo(const Request& request);
  Reply post_text(const Request& request);
  Reply post_check(const Request& request);
  Reply post_want(const Request& request);
  Reply post_open(const Request& request);
  Reply post_save(const Request& request);
  Reply post_export(const Request& request);
  Reply post_cancel(const Request& request);
  Reply post_refresh(const Request& request);

  Reply dispatch(const Request& request);

  const StudioOptions options_;
  const Workplace workplace_;
  const std::string schema_;
  EventHub hub_;
  mutable std::mutex mutex_;  // of session_
  std::shared_ptr<Session> session_;
  std::mutex pictures_;
  std::map<std::string, std::string> small_pictures_;
  DryGround dry_;
  Jobs jobs_{hub_};
};

}  // namespace seamount::server
