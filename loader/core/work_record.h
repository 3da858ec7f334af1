// What a process is about to do, in memory that the process which watches over it reads: when a driver dies
// or does not come back, nothing else can say where.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace orris {

/// One piece of work and where it is now. The texts come from a process that may have been taken over.
struct WorkNote {
  std::uint64_t pieces = 0;  ///< begun so far; a limit of time is that of one piece
  bool idle = true;          ///< none is being worked on
  int frame = -1;            ///< that is being drawn, -1: none
  bool exact = true;         ///< the driver had finished all steps before this one
  std::string doing;         ///< "compiling", "drawing"
  std::string name;          ///< of a program or step, "" unknown
  std::string file;          ///< of the pack, "" unknown

  /// "while drawing frame 3, in composite1": to be put behind a comma or verb; "" when nothing is known.
  std::string where() const;
};

/// Shares the notes of this process with the processes that it forks while the record lives. One at a time.
class WorkRecord {
 public:
  WorkRecord();
  ~WorkRecord();
  WorkRecord(const WorkRecord&) = delete;
  WorkRecord& operator=(const WorkRecord&) = delete;
  WorkNote read() const;
};

// Each costs some nanoseconds; without a record they do nothing.

/// A piece of work begins, such as the compilation of a program.
void noteWork(std::string_view doing, std::string_view name, std::string_view file);
/// A frame begins.
void noteFrame(int frame);
/// A step of the frame begins; `exact` as in WorkNote.
void noteStep(std::string_view name, std::string_view file, bool exact);
/// Nothing is being worked on, as when a window waits for its user.
void noteIdle();
/// Whether a record lives.
bool workIsNoted();

}  // namespace orris
