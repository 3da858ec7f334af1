// The files of a pack that is read more than once while its author may save them.
#pragma once

#include <memory>

#include <orris/core/files/file_source.h>

namespace orris {

/// The files of `source`, each as it was when it was first read, so that all who read it see the same text and it is opened
/// once. Not what lies beside `shaders`, and beyond limits::kSnapshotBytes in all files are read anew each time. Safe to
/// read from several threads and in forked processes: nothing waits.
std::shared_ptr<const FileSource> snapshotOf(std::shared_ptr<const FileSource> source);

}  // namespace orris
