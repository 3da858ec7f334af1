// The Language Server Protocol over standard input and output: edits in, findings and answers out.
#pragma once

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "app/lsp/edited_pack.h"
#include "app/lsp/features.h"
#include "app/lsp/published.h"
#include "app/lsp/wire.h"

namespace orris {

class LspServer {
 public:
  LspServer(LspWire& wire, ValidateOptions options) : wire_(wire), options_(std::move(options)) {}
  /// Until the editor says so or hangs up. The exit status of the protocol: 0 after "shutdown", else 1.
  int run();

 private:
  using json = nlohmann::json;
  /// An answer, or with an id that is null nothing.
  using Method = json (LspServer::*)(const json& parameters);
  struct Session {
    EditedPack pack;
    Published published;
  };

  bool wait();
  void receive(const json& message);
  json answer(const std::string& method, const json& parameters, bool& known);
  void takeResults(Session& session);
  void startChecks();
  /// nullptr for files of no pack.
  Session* sessionOf(const std::string& uri);
  std::optional<EditorPlace> placeOf(const json& parameters);

  json initialize(const json& parameters);
  json shutdown(const json& parameters);
  json exit(const json& parameters);
  json opened(const json& parameters);
  json changed(const json& parameters);
  json closed(const json& parameters);
  json filesChanged(const json& parameters);
  json nothing(const json& parameters);
  json hover(const json& parameters);
  json definition(const json& parameters);
  json completion(const json& parameters);
  json symbols(const json& parameters);
  json actions(const json& parameters);

  LspWire& wire_;
  ValidateOptions options_;
  std::map<std::string, std::unique_ptr<Session>> sessions_;  ///< by root
  bool utf8_ = false, shutDown_ = false, ended_ = false;
};

}  // namespace orris
