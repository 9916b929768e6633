// What the studio answers to a request.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "seamount/server/edit_json.h"
#include "seamount/server/event_hub.h"

namespace seamount::server {

struct Reply {
  int status = 200;
  std::string type = "application/json";
  std::string bytes;
  std::vector<std::pair<std::string, std::string>> headers = {};
  std::shared_ptr<EventHub::Stream> stream = nullptr;  ///< instead of bytes: lines, until it is closed
  std::string file = {};                               ///< instead of bytes: a file
};

Reply json_reply(const OrderedJson& json, int status = 200);

/// {"error": message}
Reply error_reply(int status, const std::string& message);

/// Calls handle() and makes a reply of what it throws; never throws but for memory.
Reply guarded(const std::function<Reply()>& handle);

}  // namespace seamount::server
