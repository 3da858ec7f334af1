#include "app/lsp/server.h"

#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <set>
#include <vector>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

using nlohmann::json;

/// Numbers of the protocol.
constexpr int kMethodNotFound = -32601, kInvalidParams = -32602;
constexpr int kFullSync = 1;

std::string uriIn(const json& parameters) { return parameters.at("textDocument").at("uri"); }

}  // namespace

int LspServer::run() {
  while (!ended_ && !wire_.broken()) {
    if (!wait()) break;
    while (const auto message = wire_.next()) receive(*message);
    startChecks();
  }
  return shutDown_ && !wire_.broken() ? 0 : 1;
}

/// For the editor or a result; false: the editor is gone.
bool LspServer::wait() {
  std::vector<pollfd> all{{.fd = wire_.in(), .events = POLLIN, .revents = 0}};
  std::vector<Session*> checking;
  for (auto& [root, session] : sessions_) {
    if (session->pack.check.descriptor() < 0) continue;
    checking.push_back(session.get());
    all.push_back({.fd = session->pack.check.descriptor(), .events = POLLIN, .revents = 0});
  }
  if (::poll(all.data(), all.size(), -1) < 0) return errno == EINTR;
  for (std::size_t i = 0; i < checking.size(); ++i)
    if (all[i + 1].revents != 0) takeResults(*checking[i]);
  return all.front().revents == 0 || wire_.fill();
}

void LspServer::takeResults(Session& session) {
  const auto send = [&](const std::string& uri, json diagnostics) {
    wire_.send({{"jsonrpc", "2.0"},
                {"method", "textDocument/publishDiagnostics"},
                {"params", {{"uri", uri}, {"diagnostics", std::move(diagnostics)}}}});
  };
  for (json& message : session.pack.check.take()) {
    const std::string part = message.value("part", "");
    if (part == "programs")
      session.published.showErrors(session.pack, message.at("entries").get<std::set<std::string>>(),
                                   message.at("findings"), utf8_, send);
    if (part == "whole") {
      session.pack.checked();
      session.published.show(session.pack, std::move(message.at("findings")), utf8_, send);
    }
    // Who measures or tests waits for it: findings that stay as they are are not sent again.
    wire_.send({{"jsonrpc", "2.0"},
                {"method", "orris/checked"},
                {"params", {{"uri", uriOfPath(session.pack.root())}, {"part", part}}}});
  }
}

void LspServer::startChecks() {
  for (auto& [root, session] : sessions_)
    if (session->pack.waiting) session->pack.startCheck();
}

void LspServer::receive(const json& message) {
  const json id = message.value("id", json());
  const std::string method = message.contains("method") && message["method"].is_string()
                                 ? message["method"].get<std::string>()
                                 : "";
  if (method.empty()) return;  // an answer to nothing that was asked
  json reply = {{"jsonrpc", "2.0"}, {"id", id}};
  bool known = true;
  try {
    reply["result"] = answer(method, message.value("params", json::object()), known);
  } catch (const json::exception&) {
    // What an editor sends is not trusted to be as the protocol says.
    reply["error"] = {{"code", kInvalidParams}, {"message", "the parameters are not those of " + method}};
    reply.erase("result");
  }
  if (!known) {
    reply["error"] = {{"code", kMethodNotFound}, {"message", "there is no method " + method}};
    reply.erase("result");
  }
  if (!id.is_null()) wire_.send(reply);
}

json LspServer::answer(const std::string& method, const json& parameters, bool& known) {
  struct Row {
    const char* name;
    Method call;
  };
  static constexpr Row kRows[] = {{"initialize", &LspServer::initialize},
                                  {"initialized", &LspServer::nothing},
                                  {"shutdown", &LspServer::shutdown},
                                  {"exit", &LspServer::exit},
                                  {"textDocument/didOpen", &LspServer::opened},
                                  {"textDocument/didChange", &LspServer::changed},
                                  {"textDocument/didClose", &LspServer::closed},
                                  {"textDocument/didSave", &LspServer::nothing},
                                  {"workspace/didChangeWatchedFiles", &LspServer::filesChanged},
                                  {"textDocument/hover", &LspServer::hover},
                                  {"textDocument/definition", &LspServer::definition},
                                  {"textDocument/completion", &LspServer::completion},
                                  {"textDocument/documentSymbol", &LspServer::symbols},
                                  {"textDocument/codeAction", &LspServer::actions}};
  const auto row = std::ranges::find_if(kRows, [&](const Row& one) { return one.name == method; });
  known = row != std::end(kRows);
  return known ? (this->*row->call)(parameters) : json();
}

LspServer::Session* LspServer::sessionOf(const std::string& uri) {
  const std::string root = packRootOf(pathOfUri(uri));
  if (root.empty()) return nullptr;
  auto& session = sessions_[root];
  if (!session) session.reset(new Session{EditedPack(root, options_), {}});
  return session.get();
}

json LspServer::initialize(const json& parameters) {
  const json encodings = parameters.value(json::json_pointer("/capabilities/general/positionEncodings"),
                                          json::array());
  utf8_ = std::ranges::find(encodings, json("utf-8")) != encodings.end();
  const json capabilities = {
      {"positionEncoding", utf8_ ? "utf-8" : "utf-16"},
      {"textDocumentSync", {{"openClose", true}, {"change", kFullSync}, {"save", true}}},
      {"hoverProvider", true},
      {"definitionProvider", true},
      {"documentSymbolProvider", true},
      {"codeActionProvider", {{"codeActionKinds", {"quickfix"}}}},
      {"completionProvider", {{"triggerCharacters", {"#", "\"", "/", ".", ":", "=", "<", "["}}}}};
  return {{"capabilities", capabilities}, {"serverInfo", {{"name", "orris"}, {"version", ORRIS_VERSION}}}};
}

json LspServer::shutdown(const json&) {
  shutDown_ = true;
  for (auto& [root, session] : sessions_) session->pack.check.stop();
  return nullptr;
}

json LspServer::exit(const json&) {
  ended_ = true;
  return nullptr;
}

json LspServer::nothing(const json&) { return nullptr; }

json LspServer::opened(const json& parameters) {
  Session* session = sessionOf(uriIn(parameters));
  if (session == nullptr) return nullptr;
  const std::string file = session->pack.packPath(pathOfUri(uriIn(parameters)));
  session->pack.edit(file, parameters.at("textDocument").at("text"));
  return nullptr;
}

json LspServer::changed(const json& parameters) {
  Session* session = sessionOf(uriIn(parameters));
  const json& changes = parameters.at("contentChanges");
  if (session == nullptr || changes.empty()) return nullptr;
  session->pack.edit(session->pack.packPath(pathOfUri(uriIn(parameters))), changes.back().at("text"));
  return nullptr;
}

json LspServer::closed(const json& parameters) {
  if (Session* session = sessionOf(uriIn(parameters)))
    session->pack.close(session->pack.packPath(pathOfUri(uriIn(parameters))));
  return nullptr;
}

json LspServer::filesChanged(const json& parameters) {
  for (const json& change : parameters.at("changes")) {
    const std::string path = pathOfUri(change.at("uri").get<std::string>());
    for (auto& [root, session] : sessions_)
      if (const std::string file = session->pack.packPath(path); !file.empty())
        session->pack.changedOnDisk(file);
  }
  return nullptr;
}

std::optional<EditorPlace> LspServer::placeOf(const json& parameters) {
  Session* session = sessionOf(uriIn(parameters));
  if (session == nullptr) return std::nullopt;
  EditorPlace at{.pack = session->pack,
                 .file = session->pack.packPath(pathOfUri(uriIn(parameters))),
                 .line = {},
                 .place = {},
                 .utf8 = utf8_};
  const std::vector<std::string> lines = splitLines(session->pack.text(at.file));
  const auto number = parameters.at("position").at("line").get<std::size_t>();
  if (number < lines.size()) at.line = lines[number];
  at.place.line = int(number);
  at.place.at = bytesOf(at.line, parameters.at("position").at("character").get<std::size_t>(), utf8_);
  return at;
}

json LspServer::hover(const json& parameters) {
  const auto at = placeOf(parameters);
  return at ? hoverAt(*at) : json();
}

json LspServer::definition(const json& parameters) {
  const auto at = placeOf(parameters);
  return at ? definitionsAt(*at) : json();
}

json LspServer::completion(const json& parameters) {
  const auto at = placeOf(parameters);
  return {{"isIncomplete", false}, {"items", at ? completionsAt(*at) : json::array()}};
}

json LspServer::symbols(const json& parameters) {
  Session* session = sessionOf(uriIn(parameters));
  if (session == nullptr) return json::array();
  return symbolsOf(session->pack, session->pack.packPath(pathOfUri(uriIn(parameters))), utf8_);
}

json LspServer::actions(const json& parameters) {
  Session* session = sessionOf(uriIn(parameters));
  if (session == nullptr) return json::array();
  const json& range = parameters.at("range");
  return session->published.actions(session->pack, pathOfUri(uriIn(parameters)),
                                    range.at("start").at("line"), range.at("end").at("line"), utf8_);
}

}  // namespace orris
