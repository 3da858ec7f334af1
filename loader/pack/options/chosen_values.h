// From a load request to the option values in force. Contract: options.csv file.format, profile.*.
#pragma once

#include <string>

#include <orris/pack/options/options.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// Values that differ from their defaults: option file, then profile, then the request's own values.
/// An unknown profile or option, and a value outside its list in the request, are errors.
OptionValues chooseValues(const LoadRequest& request, const OptionSet& options,
                          const std::vector<Profile>& profiles, Diagnostics& diagnostics);

/// The profile with the most values among those whose values are all in force, nullptr for none.
const Profile* detectProfile(const std::vector<Profile>& profiles, const OptionSet& options,
                             const OptionValues& values);

}  // namespace orris
