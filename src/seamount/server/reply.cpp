#include "seamount/server/reply.h"

#include "seamount/server/session.h"

namespace seamount::server {
namespace {

Reply refusal_of(const OutOfDate& error) {
  OrderedJson missed = OrderedJson::array();
  for (const std::string& event : error.missed) missed.push_back(OrderedJson::parse(event));
  return json_reply({{"error", error.what()}, {"missed", missed}}, 409);
}

}  // namespace

Reply json_reply(const OrderedJson& json, int status) { return {.status = status, .bytes = one_line(json)}; }

Reply error_reply(int status, const std::string& message) { return json_reply({{"error", message}}, status); }

Reply guarded(const std::function<Reply()>& handle) {
  try {
    return handle();
  } catch (const OutOfDate& error) {
    return refusal_of(error);
  } catch (const recipe::RecipeError& error) {
    return json_reply({{"error", error.what()}, {"diagnostics", write_diagnostics(error.diagnostics())}}, 422);
  } catch (const InvalidArgument& error) {
    return error_reply(400, error.what());
  } catch (const IncompatibleInputs& error) {
    return error_reply(400, error.what());
  } catch (const WriteError& error) {
    return error_reply(507, error.what());
  } catch (const IoError& error) {
    return error_reply(404, error.what());
  } catch (const std::bad_alloc&) {
    return error_reply(503, "not enough memory");
  } catch (const std::exception& error) {
    return error_reply(500, error.what());
  }
}

}  // namespace seamount::server
