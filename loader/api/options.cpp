// Options and profiles of a pack through the C interface.
#include <algorithm>
#include <iterator>

#include <orris/api/renderer.h>

namespace orris::api {
namespace {

const Option& optionAt(const ShaderPack& pack, std::uint32_t index) {
  const auto& all = pack.options.all();
  if (index >= all.size())
    fail(ORRIS_ERROR_NOT_FOUND,
         "option " + std::to_string(index) + " of " + std::to_string(all.size()));
  return std::next(all.begin(), index)->second;
}

const Option& optionNamed(const ShaderPack& pack, const std::string& name) {
  if (const Option* option = pack.options.find(name)) return *option;
  std::string text = "the pack has no option " + name;
  if (const std::string hint = missingOptionHint(pack.options, name); !hint.empty())
    text += "; " + hint;
  fail(ORRIS_ERROR_NOT_FOUND, text);
}

void checkAllowed(const Option& option, const std::string& value) {
  const auto& values = option.values;
  if (std::find(values.begin(), values.end(), value) != values.end()) return;
  std::string allowed;
  for (const std::string& one : values) allowed += (allowed.empty() ? "" : ", ") + one;
  fail(ORRIS_ERROR_ARGUMENT, "\"" + value + "\" is no value of " + option.name + ": " + allowed);
}

/// The value in force, as an element of the option, which lives as long as the pack.
const char* valueOf(const ShaderPack& pack, const Option& option) {
  const auto chosen = pack.values.find(option.name);
  return chosen == pack.values.end() ? option.defaultValue.c_str() : chosen->second.c_str();
}

}  // namespace
}  // namespace orris::api

using namespace orris::api;

OrrisStatus orris_renderer_option_count(OrrisRenderer* handle, uint32_t* out) {
  return guarded([&] {
    const OrrisRenderer& renderer = live(handle);
    refuseNull(out, "out");
    *out = static_cast<uint32_t>(renderer.session->asked().options.all().size());
  });
}

OrrisStatus orris_renderer_option(OrrisRenderer* handle, uint32_t index, OrrisOption* out) {
  return guarded([&] {
    const orris::ShaderPack& pack = live(handle).session->asked();
    sized(out, "option");
    const orris::Option& option = optionAt(pack, index);
    out->name = option.name.c_str();
    out->value = valueOf(pack, option);
    out->default_value = option.defaultValue.c_str();
    out->comment = option.comment.c_str();
    out->is_boolean = option.isBoolean ? 1 : 0;
    out->value_count = static_cast<uint32_t>(option.values.size());
  });
}

OrrisStatus orris_renderer_option_value(OrrisRenderer* handle, uint32_t index, uint32_t value,
                                        const char** out) {
  return guarded([&] {
    const orris::ShaderPack& pack = live(handle).session->asked();
    refuseNull(out, "out");
    const orris::Option& option = optionAt(pack, index);
    if (value >= option.values.size())
      fail(ORRIS_ERROR_NOT_FOUND,
           option.name + " has " + std::to_string(option.values.size()) + " values");
    *out = option.values[value].c_str();
  });
}

OrrisStatus orris_renderer_set_option(OrrisRenderer* handle, const char* name, const char* value) {
  return guarded([&] {
    OrrisRenderer& renderer = live(handle);
    refuseNull(name, "name");
    refuseNull(value, "value");
    checkAllowed(optionNamed(renderer.session->asked(), name), value);
    const Current current(*renderer.context);
    orris::Diagnostics diagnostics;
    // Copies: what was handed in may be the pack's own.
    const std::string chosen = name, text = value;
    finishLoad(renderer, renderer.session->setOption(chosen, text, diagnostics), diagnostics);
  });
}

OrrisStatus orris_renderer_profile_count(OrrisRenderer* handle, uint32_t* out) {
  return guarded([&] {
    const OrrisRenderer& renderer = live(handle);
    refuseNull(out, "out");
    *out = static_cast<uint32_t>(renderer.session->asked().properties.profiles.size());
  });
}

OrrisStatus orris_renderer_profile_name(OrrisRenderer* handle, uint32_t index, const char** out) {
  return guarded([&] {
    const auto& profiles = live(handle).session->asked().properties.profiles;
    refuseNull(out, "out");
    if (index >= profiles.size())
      fail(ORRIS_ERROR_NOT_FOUND,
           "profile " + std::to_string(index) + " of " + std::to_string(profiles.size()));
    *out = profiles[index].name.c_str();
  });
}

OrrisStatus orris_renderer_profile(OrrisRenderer* handle, const char** out) {
  return guarded([&] {
    OrrisRenderer& renderer = live(handle);
    refuseNull(out, "out");
    renderer.profile = renderer.session->asked().currentProfile();
    *out = renderer.profile.c_str();
  });
}

OrrisStatus orris_renderer_set_profile(OrrisRenderer* handle, const char* name) {
  return guarded([&] {
    OrrisRenderer& renderer = live(handle);
    refuseNull(name, "name");
    const std::string chosen = name;
    const auto& profiles = renderer.session->asked().properties.profiles;
    if (std::none_of(profiles.begin(), profiles.end(),
                     [&](const orris::Profile& profile) { return profile.name == chosen; }))
      fail(ORRIS_ERROR_NOT_FOUND, "the pack has no profile " + chosen);
    const Current current(*renderer.context);
    orris::Diagnostics diagnostics;
    finishLoad(renderer, renderer.session->setProfile(chosen, diagnostics), diagnostics);
  });
}
