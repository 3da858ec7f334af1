#include <orris/core/work_record.h>

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <new>

namespace orris {
namespace {

using SharedText = std::array<char, 256>;

// Lives in memory of two processes: no pointers, no locks that a dead process could hold.
struct SharedNote {
  std::atomic<std::uint64_t> pieces{0};
  std::atomic<bool> idle{true};
  std::atomic<int> frame{-1};
  std::atomic<bool> exact{true};
  SharedText doing{}, name{}, file{};
};
static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

SharedNote* shared = nullptr;

void put(SharedText& to, std::string_view text) {
  const std::size_t size = std::min(text.size(), to.size() - 1);
  std::copy_n(text.begin(), size, to.begin());
  to[size] = '\0';
}

// The other process may be writing: a text of two steps is a wrong text, never one that has no end.
std::string get(const SharedText& text) {
  return {text.data(), strnlen(text.data(), text.size() - 1)};
}

void begin(std::string_view doing, std::string_view name, std::string_view file, int frame) {
  if (!shared) return;
  put(shared->doing, doing);
  put(shared->name, name);
  put(shared->file, file);
  shared->frame = frame;
  shared->exact = true;
  shared->idle = false;
  ++shared->pieces;
}

}  // namespace

std::string WorkNote::where() const {
  if (doing.empty()) return "";
  if (frame < 0) return "while " + doing + (name.empty() ? "" : " " + name);
  std::string text = "while " + doing + " frame " + std::to_string(frame + 1);
  if (name.empty()) return text;
  return text + (exact ? ", in " : ", in the passes up to ") + name;
}

WorkRecord::WorkRecord() {
  void* memory = ::mmap(nullptr, sizeof(SharedNote), PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  shared = memory == MAP_FAILED ? nullptr : new (memory) SharedNote();
}

WorkRecord::~WorkRecord() {
  if (shared) ::munmap(shared, sizeof *shared);
  shared = nullptr;
}

WorkNote WorkRecord::read() const {
  WorkNote note;
  if (!shared) return note;
  note.pieces = shared->pieces;
  note.idle = shared->idle;
  note.frame = shared->frame;
  note.exact = shared->exact;
  note.doing = get(shared->doing);
  note.name = get(shared->name);
  note.file = get(shared->file);
  return note;
}

void noteWork(std::string_view doing, std::string_view name, std::string_view file) {
  begin(doing, name, file, -1);
}

void noteFrame(int frame) { begin("drawing", "", "", frame); }

void noteStep(std::string_view name, std::string_view file, bool exact) {
  if (!shared) return;
  put(shared->name, name);
  put(shared->file, file);
  shared->exact = exact;
}

void noteIdle() {
  if (shared) shared->idle = true;
}

bool workIsNoted() { return shared != nullptr; }

}  // namespace orris
