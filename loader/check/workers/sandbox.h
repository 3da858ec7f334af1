// What a worker may still do, once it holds a stranger's text or runs a stranger's program in a driver.
#pragma once

#include <string>
#include <vector>

namespace orris {

/// What the kernel of this machine offers.
struct SandboxSupport {
  int landlock = 0;      ///< version of Landlock's interface, 0: none
  bool seccomp = false;  ///< filters of system calls
};
SandboxSupport sandboxSupport();

/// Where a software rasteriser keeps the programs it compiled, made if it is not there: a folder that only
/// shut-in workers read, so that a driver which was taken over can leave nothing for other programs.
/// "" when MESA_SHADER_CACHE_DISABLE says so or no folder can be made. Sets MESA_SHADER_CACHE_DIR.
std::string prepareDriverCache();

/// Closes every open file but the standard streams and `keep`; standard input is empty from now on.
void closeOpenFiles(std::vector<int> keep);

/// Shuts this process in, for good. Call in a forked process with one thread, before a driver is loaded:
/// - no environment but what chooses and tunes a driver; what was there is overwritten in memory
/// - no capability of the superuser but to read what others own
/// - with Landlock: reads of installed libraries, the description of the machine and `readable` places; no
///   file written, made or removed but in /dev/null and `cache`; no TCP, no signal to others
/// - with seccomp: no socket is made, no program or process started, no other process looked at, no owner
///   or mode of a file changed
/// What the kernel lacks is left out. Names and sizes of files stay visible.
void enterSandbox(const std::vector<std::string>& readable, const std::string& cache = "");

/// The same for a process that becomes the installed program that it was forked for. What that program
/// becomes is shut in, too. PATH is kept, to find it by.
void enterSandboxToRunProgram(const std::vector<std::string>& readable);

}  // namespace orris
