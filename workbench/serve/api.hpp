// The workbench over HTTP, without the transport: requests in, responses out.
//
// clang-format off
// | request | answer |
// |---|---|
// | GET /api/state | how things stand: recording, model, work under way, last failure |
// | GET /api/effects | the catalogue |
// | POST /api/recording?name=&ts=&u=&y=&… | body: CSV; fits a textbook model; `output=x` models the valve position; `u_before=0` says where u rested before the first row; `load=` measured loads, one on each line, or `all`; `opens=no` says that a higher output closes the valve; with `keep=1` judges the present model instead |
// | POST /api/columns?… | the same body and query; opens nothing, tells what the file holds (column_preview.hpp) |
// | POST /api/example | opens a simulated loop with a sticking valve |
// | GET /api/recording, /api/signals | what is open; its samples, simulated ones too |
// | POST /api/direction | {"opens":"yes"}: a higher output opens the valve; "no": it closes it; "": unknown; of words only |
// | GET /api/valve | the verdict on the valve, `stickband identify --json` in it; "provisional" while only a part was looked at |
// | POST /api/range | {"from","to","what"}: fits or judges a range, s; all of it without one |
// | POST /api/leave_out | {"from","to"}: fits without it; {"manual":true}: without what the file says is in manual; {} takes everything in again |
// | POST /api/split | {"estimation_share","block_s"}: shares the samples out anew, 0 s as usual |
// | POST /api/model | {"output","with":[…]} fits a new start; a model file, always so with `name=`, is taken as it is |
// | GET /api/model, /api/models | the model file; all models so far with their errors |
// | GET /api/simulated?model= | the output of one of them |
// | GET /api/compare | as `stickband compare --json` |
// | POST, GET /api/explain | starts; answers as `stickband explain --json` |
// | POST /api/explain?unasked=1 | the same, unless somebody stopped work on the model |
// | POST, GET /api/preview | {"effect","with":[…]}: fits it, adds nothing; the model with it, its output |
// | POST, GET /api/add | the same; as `stickband add --json`, at once where it was previewed |
// | POST /api/remove | {"effect"}: takes it out again and fits the rest |
// | POST, GET /api/ladder | as `stickband ladder --json` |
// | POST /api/try?then= | {"process":{"gain":…},"valve.stiction":{…}}: errors and output with these values; then=keep takes them, then=refit fits from there all but "hold":{"process":["gain"]} |
// | POST /api/undo, /api/redo, /api/cancel | |
// | POST, GET /api/beside?name=&… | body: CSV; judges every model on it, too |
// | POST /api/together | {"which":0,"fit":true}: fits models to it, too, or only judges again; fits the present one anew |
// | POST /api/dismiss | {"which":0}: no more |
// | GET /api/parts | HTML of the page's sections, as in the report; "places" of the failures of /api/compare by the time of /api/signals, which runs on where recordings are joined |
// | GET, POST /api/session | all of it as a file; brings it back |
// | GET /api/report?language=, /api/csv, /api/commands | the report, English without one; the signals; the command lines |
// clang-format on
//
// What a POST starts goes on after its answer (202 with the state): poll /api/state until
// `job`, for the verdict `verdict_job`, is null. The state's `opening` is a number of the
// recording that is open; any request may name it, `?opening=`, and is refused with 409,
// "kind":"other_open", where another one is open meanwhile. Errors are
// {"schema":1,"error":{"message",…}}: 400 bad input (with file, line, column, expected,
// found, advice), 404 no such address, 405 wrong method, 409 not now. /api/state keeps an
// error of work that went on, with "kind": bad_input, cannot_answer or failed.
#pragma once

#include <map>
#include <string>

#include "workbench/serve/session.hpp"

namespace workbench {

struct ApiRequest {
  std::string method;  ///< "GET", "POST"
  std::string path;    ///< "/api/state", decoded, without the query
  std::map<std::string, std::string> query;
  std::string body;
};

struct ApiResponse {
  int status = 200;
  std::string type;  ///< media type
  std::string body;
  std::string filename;  ///< to be saved under this name; empty: shown
};

/// Stateless but for `session`. Throws nothing but std::bad_alloc. Calls from several
/// threads are fine.
[[nodiscard]] ApiResponse answer(Session& session, const ApiRequest& request);

/// An error in the words of the API.
[[nodiscard]] ApiResponse error_response(int status, const std::string& message);

}  // namespace workbench
