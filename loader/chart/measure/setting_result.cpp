#include <orris/chart/measure/setting_result.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include <orris/chart/study/json_number.h>

namespace orris {
namespace {

using nlohmann::json;

double toNumber(const json& value) {
  return value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
}

json toJson(const Interval& interval) {
  return {jsonNumber(interval.low), jsonNumber(interval.high)};
}

Interval toInterval(const json& value) { return {toNumber(value.at(0)), toNumber(value.at(1))}; }

json toJson(const ErrorSummary& error) {
  json accumulated = json::array();
  for (const AccumulatedError& run : error.accumulated) {
    accumulated.push_back({{"frames", run.frames},
                           {"error", jsonNumber(run.error)},
                           {"interval", toJson(run.interval)}});
  }
  return {{"frames", error.frames},
          {"signedBias", jsonNumber(error.signedBias)},
          {"bias", jsonNumber(error.bias)},
          {"biasInterval", toJson(error.biasInterval)},
          {"noise", jsonNumber(error.noise)},
          {"accumulated", std::move(accumulated)},
          {"relMse", jsonNumber(error.relMse)},
          {"relMseMedian", jsonNumber(error.relMseMedian)},
          {"relMseTrimmed", jsonNumber(error.relMseTrimmed)},
          {"notFinite", error.notFinite}};
}

ErrorSummary toError(const json& value) {
  ErrorSummary error;
  error.frames = value.at("frames").get<int>();
  error.signedBias = toNumber(value.at("signedBias"));
  error.bias = toNumber(value.at("bias"));
  error.biasInterval = toInterval(value.at("biasInterval"));
  error.noise = toNumber(value.at("noise"));
  for (const json& run : value.at("accumulated")) {
    error.accumulated.push_back(
        {run.at("frames").get<int>(), toNumber(run.at("error")), toInterval(run.at("interval"))});
  }
  if (error.accumulated.empty()) error.accumulated.push_back({});
  error.relMse = toNumber(value.at("relMse"));
  error.relMseMedian = toNumber(value.at("relMseMedian"));
  error.relMseTrimmed = toNumber(value.at("relMseTrimmed"));
  error.notFinite = value.at("notFinite").get<std::size_t>();
  return error;
}

}  // namespace

std::string writeResult(const SettingResult& result) {
  json pairs = json::array(), passes = json::array();
  for (const TimePair& pair : result.pairs) pairs.push_back({pair.own, pair.baseline});
  for (const PassTimes& pass : result.passes)
    passes.push_back({{"name", pass.name}, {"times", pass.times}});
  const json text = {
      {"setting", result.label}, {"key", result.key},
      {"chosen", result.chosen}, {"error", result.error ? toJson(*result.error) : json(nullptr)},
      {"ssim", result.ssim},     {"pairs", std::move(pairs)},
      {"frames", result.frames}, {"passes", std::move(passes)}};
  return text.dump(1) + "\n";
}

std::optional<SettingResult> parseResult(const std::string& text) {
  const json value = json::parse(text, nullptr, false);
  try {
    SettingResult result;
    result.label = value.at("setting").get<std::string>();
    result.key = value.at("key").get<std::string>();
    result.chosen = value.at("chosen").get<std::string>();
    if (!value.at("error").is_null()) result.error = toError(value.at("error"));
    result.ssim = value.at("ssim").get<double>();
    for (const json& pair : value.at("pairs"))
      result.pairs.push_back({pair.at(0).get<double>(), pair.at(1).get<double>()});
    result.frames = value.at("frames").get<std::vector<double>>();
    for (const json& pass : value.at("passes")) {
      result.passes.push_back(
          {pass.at("name").get<std::string>(), pass.at("times").get<std::vector<double>>()});
    }
    return result;
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

}  // namespace orris
