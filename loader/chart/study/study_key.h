// What the numbers of a setting depend on, as a fingerprint.
#pragma once

#include <string>

#include <orris/chart/measure/measure.h>
#include <orris/chart/study/digest.h>
#include <orris/core/files/file_source.h>

namespace orris {

/// What all settings share: pack, world, driver.
Digest studyDigest(const FileSource& pack, const World& world, const gl::DriverInfo& driver);

/// Of one setting: with its options, camera, size, the frames drawn and the reference. Times may be
/// added to what has this key.
std::string settingKey(Digest study, const SettingJob& job, const MeasurePlan& plan);

/// Of a reference drawn from a setting.
std::string referenceKey(Digest study, const SessionRequest& request, const MeasurePlan& plan,
                         int frames);

}  // namespace orris
