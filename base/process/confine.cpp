// SPDX-License-Identifier: MIT
#include "base/process/confine.hpp"

#include <asm/ioctls.h>
#include <fcntl.h>
#include <linux/sched.h>
#include <linux/sockios.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>

#include "base/process/child.hpp"

namespace cyl {
namespace {

std::atomic<int>* denied_call = nullptr;

void on_denied(int, siginfo_t* info, void*) {
  denied_call->store(info->si_syscall);
  _exit(denied_code);
}

/// A system call, and the comparison of one of its arguments.
struct Rule {
  int call;
  unsigned argument;
  scmp_compare how;
  scmp_datum_t with, masked = 0;
};

/// Denies calls, some of them only for certain arguments. A denied call runs on_denied().
bool add_rules(scmp_filter_ctx filter) {
  const auto self = static_cast<scmp_datum_t>(getpid());
  bool added = true;
  const auto deny = [&](int call) { added = added && seccomp_rule_add(filter, SCMP_ACT_TRAP, call, 0) == 0; };
  const auto deny_where = [&](const Rule& rule) {
    const scmp_arg_cmp when{rule.argument, rule.how, rule.with, rule.masked};
    added = added && seccomp_rule_add_array(filter, SCMP_ACT_TRAP, rule.call, 1, &when) == 0;
  };
  for (const int call :
       {SCMP_SYS(fork), SCMP_SYS(vfork), SCMP_SYS(execve), SCMP_SYS(execveat), SCMP_SYS(ptrace),
        SCMP_SYS(tkill), SCMP_SYS(pidfd_send_signal), SCMP_SYS(pidfd_getfd), SCMP_SYS(process_vm_writev)})
    deny(call);
  for (const Rule& rule : {
           Rule{SCMP_SYS(clone), 0, SCMP_CMP_MASKED_EQ, CLONE_THREAD, 0},
           Rule{SCMP_SYS(kill), 0, SCMP_CMP_NE, self},
           Rule{SCMP_SYS(tgkill), 0, SCMP_CMP_NE, self},
           Rule{SCMP_SYS(rt_sigqueueinfo), 0, SCMP_CMP_NE, self},
           Rule{SCMP_SYS(rt_tgsigqueueinfo), 0, SCMP_CMP_NE, self},
           Rule{SCMP_SYS(prlimit64), 0, SCMP_CMP_NE, 0},
           Rule{SCMP_SYS(prctl), 0, SCMP_CMP_EQ, PR_SET_PDEATHSIG},
           // These set the process that receives the signal of a ready input, and the signal.
           Rule{SCMP_SYS(fcntl), 1, SCMP_CMP_EQ, F_SETOWN},
           Rule{SCMP_SYS(fcntl), 1, SCMP_CMP_EQ, F_SETOWN_EX},
           Rule{SCMP_SYS(fcntl), 1, SCMP_CMP_EQ, F_SETSIG},
           Rule{SCMP_SYS(ioctl), 1, SCMP_CMP_EQ, FIOSETOWN},
           Rule{SCMP_SYS(ioctl), 1, SCMP_CMP_EQ, SIOCSPGRP},
       })
    deny_where(rule);
  // The flags of clone3 are in memory, which a filter cannot read. The C library calls clone instead.
  return added && seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0) == 0 &&
         seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(io_uring_setup), 0) == 0;
}

}  // namespace

bool confine(std::atomic<int>& denied) {
  denied_call = &denied;
  struct sigaction handler {};
  handler.sa_sigaction = on_denied;
  handler.sa_flags = SA_SIGINFO;
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  const bool held =
      filter && sigaction(SIGSYS, &handler, nullptr) == 0 && add_rules(filter) && seccomp_load(filter) == 0;
  if (filter) seccomp_release(filter);
  return held;
}

bool can_confine() {
  static std::atomic<int> denied{-1};
  Child child([]() -> std::string { return confine(denied) ? "yes" : ""; });
  child.wait();
  return child.bytes() == "yes";
}

std::string system_call_name(int number) {
  char* name = seccomp_syscall_resolve_num_arch(SCMP_ARCH_NATIVE, number);
  const std::string text = name ? name : "call " + std::to_string(number);
  std::free(name);
  return text;
}

}  // namespace cyl
