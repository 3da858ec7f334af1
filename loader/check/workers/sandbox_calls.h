// System calls that a worker has no use for, refused by the kernel: seccomp.
#pragma once

#include <orris/check/workers/sandbox_files.h>

namespace orris {

/// Whether this kernel and processor take filters of system calls.
bool canRefuseCalls();

/// Refuses, from now on and in every thread to come, what makes sockets, starts programs or processes, looks
/// at other processes, changes owners and modes of files, types into a terminal or changes the system; they
/// fail with EPERM. A process may become one of `programs`, but start none beside itself.
void refuseCalls(Programs programs);

}  // namespace orris
