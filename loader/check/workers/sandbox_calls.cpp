#include <orris/check/workers/sandbox_calls.h>

#include <asm/ioctls.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

namespace orris {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr unsigned kProcessor = 0;  // its search for leaks starts a process: no filter
#elif defined(__x86_64__)
constexpr unsigned kProcessor = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned kProcessor = AUDIT_ARCH_AARCH64;
#else
constexpr unsigned kProcessor = 0;  // no filter
#endif

// By number, where the headers of older systems lack the name; these are the same on all processors.
constexpr int kPidfdSendSignal = 424, kIoUringSetup = 425, kOpenTree = 428, kMoveMount = 429,
              kFsopen = 430, kPidfdOpen = 434, kClone3 = 435, kPidfdGetfd = 438,
              kProcessMadvise = 440, kMountSetattr = 442, kFchmodat2 = 452;

constexpr int kRefused[] = {
    // the network, and sockets of other programs
    SYS_socket, SYS_socketpair, SYS_connect, SYS_bind, SYS_listen, SYS_accept, SYS_accept4,
    // programs and processes
    SYS_execve, SYS_execveat,
#if defined(SYS_fork)
    SYS_fork, SYS_vfork,
#endif
    SYS_ptrace, SYS_process_vm_readv, SYS_process_vm_writev, SYS_kill, SYS_tkill,
    SYS_rt_sigqueueinfo, SYS_rt_tgsigqueueinfo, SYS_kcmp, kPidfdSendSignal, kPidfdOpen, kPidfdGetfd,
    kProcessMadvise, SYS_setpgid, SYS_setsid,
    // memory and messages that processes of one user share by number
    SYS_shmget, SYS_shmat, SYS_shmctl, SYS_msgget, SYS_msgsnd, SYS_msgrcv, SYS_semget, SYS_mq_open,
    // what Landlock leaves of files
    SYS_fchmod, SYS_fchmodat, kFchmodat2, SYS_fchown, SYS_fchownat, SYS_truncate, SYS_utimensat,
    SYS_setxattr, SYS_lsetxattr, SYS_fsetxattr, SYS_removexattr, SYS_lremovexattr, SYS_fremovexattr,
    SYS_inotify_init1, SYS_fanotify_init,
#if defined(SYS_chmod)
    SYS_chmod, SYS_chown, SYS_lchown, SYS_utime, SYS_utimes, SYS_futimesat, SYS_inotify_init,
#endif
    // the system
    SYS_mount, SYS_umount2, SYS_pivot_root, SYS_chroot, SYS_unshare, SYS_setns, kOpenTree,
    kMoveMount, kFsopen, kMountSetattr, SYS_reboot, SYS_swapon, SYS_swapoff, SYS_sethostname,
    SYS_init_module, SYS_finit_module, SYS_delete_module, SYS_kexec_load, SYS_acct, SYS_quotactl,
    SYS_syslog, SYS_capset, SYS_setuid, SYS_setgid, SYS_setresuid, SYS_setresgid, SYS_setreuid,
    SYS_setregid, SYS_setgroups,
    // interfaces of the kernel that attacks on it begin with
    SYS_bpf, SYS_perf_event_open, SYS_userfaultfd, kIoUringSetup, SYS_keyctl, SYS_add_key,
    SYS_request_key, SYS_open_by_handle_at, SYS_name_to_handle_at, SYS_personality};

sock_filter loadWord(std::size_t offset) {
  return BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<unsigned>(offset));
}
// The low half of an argument: both processors store it first.
sock_filter loadArgument(std::size_t index) {
  return loadWord(offsetof(seccomp_data, args) + index * sizeof(std::uint64_t));
}
sock_filter answer(unsigned value) { return BPF_STMT(BPF_RET | BPF_K, value); }
sock_filter skipUnlessEqual(unsigned value, unsigned char count) {
  return BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, count);
}
sock_filter skipIfEqual(unsigned value, unsigned char count) {
  return BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, count, 0);
}

constexpr unsigned kAllow = SECCOMP_RET_ALLOW, kEperm = SECCOMP_RET_ERRNO | EPERM,
                   kEnosys = SECCOMP_RET_ERRNO | ENOSYS;

using Filter = std::vector<sock_filter>;

/// Lets `call` through only when its argument is `value`.
void addOnlyFor(Filter& filter, int call, std::size_t argument, unsigned value) {
  filter.insert(filter.end(), {skipUnlessEqual(static_cast<unsigned>(call), 4),
                               loadArgument(argument), skipUnlessEqual(value, 1), answer(kAllow),
                               answer(kEperm)});
}

// What becomes a program, and what careful ones begin with: giving up rights, which fails without need.
constexpr int kOfPrograms[] = {SYS_execve, SYS_execveat, SYS_setuid, SYS_setgid};

bool isRefused(int call, Programs programs) {
  return programs == Programs::Refused || std::ranges::find(kOfPrograms, call) == std::end(kOfPrograms);
}

void addDecisions(Filter& filter, Programs programs) {
  for (const int call : kRefused) {
    if (!isRefused(call, programs)) continue;
    filter.insert(filter.end(), {skipUnlessEqual(static_cast<unsigned>(call), 1), answer(kEperm)});
  }
  // Its flags lie in memory, which a filter cannot read: libraries then use clone().
  filter.insert(filter.end(), {skipUnlessEqual(kClone3, 1), answer(kEnosys)});
  // Threads, but no processes.
  filter.insert(filter.end(), {skipUnlessEqual(SYS_clone, 4), loadArgument(0),
                               BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, CLONE_THREAD, 0, 1),
                               answer(kAllow), answer(kEperm)});
  // Signals to itself, as abort() sends; limits of itself.
  addOnlyFor(filter, SYS_tgkill, 0, static_cast<unsigned>(::getpid()));
  addOnlyFor(filter, SYS_prlimit64, 0, 0);
  // A terminal takes what TIOCSTI and TIOCLINUX put into it for the words of its user.
  filter.insert(filter.end(), {skipUnlessEqual(SYS_ioctl, 4), loadArgument(1), skipIfEqual(TIOCSTI, 1),
                               skipUnlessEqual(TIOCLINUX, 1), answer(kEperm)});
  filter.push_back(answer(kAllow));
}

Filter makeFilter(Programs programs) {
  Filter filter = {loadWord(offsetof(seccomp_data, arch)), skipIfEqual(kProcessor, 1),
                   answer(SECCOMP_RET_KILL_PROCESS), loadWord(offsetof(seccomp_data, nr))};
#if defined(__x86_64__)
  // Calls of the x32 interface have other numbers.
  constexpr unsigned kX32 = 0x40000000;
  filter.insert(filter.end(),
                {BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, kX32, 0, 1), answer(kEperm)});
#endif
  addDecisions(filter, programs);
  return filter;
}

}  // namespace

bool canRefuseCalls() {
  // Asks for a filter at no address: a kernel that has filters says that the address is wrong.
  return kProcessor != 0 && ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, nullptr, 0, 0) != 0 &&
         errno == EFAULT;
}

void refuseCalls(Programs programs) {
  if (!canRefuseCalls()) return;
  Filter filter = makeFilter(programs);
  const sock_fprog program{.len = static_cast<unsigned short>(filter.size()),
                           .filter = filter.data()};
  // Older kernels else slow the process down against side channels, which is for what runs in it to decide.
  ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_SPEC_ALLOW, &program);
}

}  // namespace orris
