#include <orris/check/compile/link_errors.h>

#include <algorithm>
#include <set>
#include <string_view>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

/// `'name' is vec2 in the vertex stage` -> name
std::string_view quotedName(std::string_view message) {
  const std::size_t end = message.find('\'', 1);
  return message.starts_with('\'') && end != std::string_view::npos ? message.substr(1, end - 1)
                                                                    : std::string_view();
}

bool namesAnyOf(const Diagnostic& linkError, const std::set<std::string_view>& names) {
  // glslang's notes: `vertex stage: " vec2 uv"`, `Block: Data`.
  return std::any_of(linkError.notes.begin(), linkError.notes.end(), [&](std::string_view note) {
    while (!note.empty() && !isWordCharacter(note.back())) note.remove_suffix(1);
    std::size_t begin = note.size();
    while (begin > 0 && isWordCharacter(note[begin - 1])) --begin;
    return names.contains(note.substr(begin));
  });
}

/// "Input block `Data' is not an output of the previous stage" -> Data
std::string_view backquotedName(std::string_view message) {
  const std::size_t begin = message.find('`'), end = message.find('\'', begin + 1);
  return begin == message.npos || end == message.npos ? std::string_view()
                                                      : message.substr(begin + 1, end - begin - 1);
}

const std::string& entryFileOf(const Diagnostic& d) {
  return d.includedFrom.empty() ? d.at.file : d.includedFrom.back().file;
}

}  // namespace

void dropRepeatedLinkErrors(Diagnostics& diagnostics) {
  std::set<std::string_view> names;
  std::set<std::string_view> missing, limited;
  std::set<std::pair<std::string, int>> overlaps;
  for (const Diagnostic& d : diagnostics) {
    if (d.id == "varying-type" || d.id == "varying-interpolation" || d.id == "uniform-conflict")
      names.insert(quotedName(d.message));
    if (d.id == "output-overlap") overlaps.emplace(d.at.file, d.at.line);
    if (d.id == "varying-missing") missing.insert(quotedName(d.message));
    if (d.id == "target-limit" && d.at.line > 0) limited.insert(entryFileOf(d));
  }
  std::set<std::pair<std::string, int>> explained;  // places that an error about a varying names
  for (const Diagnostic& d : diagnostics) {
    if (d.id != "glsl-compile" || d.message.find("undeclared identifier") == d.message.npos) continue;
    for (const RelatedPlace& place : d.related) explained.emplace(place.at.file, place.at.line);
  }
  const auto repeated = [&](const Diagnostic& d) {
    if (d.id == "varying-missing" || d.id == "varying-unread")
      return explained.contains({d.at.file, d.at.line});
    if (d.id == "glsl-link")
      return d.message.find("must match") != std::string::npos && namesAnyOf(d, names);
    if (d.id == "driver-log") return d.at.line == 0 && missing.contains(backquotedName(d.message));
    if (d.id == "target-limit") return d.at.line == 0 && limited.contains(d.at.file);
    return d.id == "glsl-compile" && overlaps.contains({d.at.file, d.at.line}) &&
           d.message.find("overlapping use of location") != std::string::npos;
  };
  // The names point into the diagnostics: find first, remove then.
  Diagnostics kept;
  for (const Diagnostic& d : diagnostics) {
    if (!repeated(d)) kept.push_back(d);
  }
  diagnostics = std::move(kept);
}

}  // namespace orris
