// SPDX-License-Identifier: MIT
#include "base/process/supervised_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <string>
#include <thread>

#include "base/process/child.hpp"
#include "base/process/confine.hpp"
#include "base/process/process.hpp"

namespace cyl {
namespace {

/// The system allows a keeper a PID namespace, one inside a user namespace, or none.
enum class System { all, user_namespaces, none };

void refuse_namespaces(System system) {
  if (system == System::all) return;
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  const auto refuse = SCMP_ACT_ERRNO(EPERM);
  const int added =
      system == System::none
          ? seccomp_rule_add(filter, refuse, SCMP_SYS(unshare), 0)
          : seccomp_rule_add(filter, refuse, SCMP_SYS(unshare), 1,
                             scmp_arg_cmp{0, SCMP_CMP_EQ, static_cast<scmp_datum_t>(CLONE_NEWPID), 0});
  if (added != 0 || seccomp_load(filter) != 0) throw std::runtime_error("no filter");
  seccomp_release(filter);
}

/// Returns the text of `work` in a process on such a system.
std::string on(System system, const std::function<std::string()>& work) {
  Child child([&] {
    refuse_namespaces(system);
    return work();
  });
  return child.wait() == 0 ? child.bytes() : "the test failed: " + how_it_ended(child.status());
}

std::string ending_of(const std::function<void()>& run) {
  SupervisedProcess kept(run, {});
  const auto& ending = kept.wait();
  return ending ? fmt::format("{}, {} left", how_it_ended(ending->status), ending->left) : "lost";
}

[[noreturn]] void stay() {
  while (true) pause();
}

class SupervisedProcessOn : public testing::TestWithParam<System> {};
std::string system_name(const testing::TestParamInfo<System>& info) {
  constexpr const char* names[] = {"AllAllowed", "UserNamespaces", "NoNamespaces"};
  return names[static_cast<int>(info.param)];
}
INSTANTIATE_TEST_SUITE_P(Systems, SupervisedProcessOn,
                         testing::Values(System::all, System::user_namespaces, System::none), system_name);

TEST_P(SupervisedProcessOn, SaysHowItEnded) {
  EXPECT_EQ(on(GetParam(), [] { return ending_of([] {}); }), "exit code 0, 0 left");
  EXPECT_EQ(on(GetParam(), [] { return ending_of([] { _exit(7); }); }), "exit code 7, 0 left");
  EXPECT_EQ(on(GetParam(), [] { return ending_of([] { throw 1; }); }), "exit code 1, 0 left");
  EXPECT_EQ(on(GetParam(), [] { return ending_of([] { std::abort(); }); }),
            "killed by signal 6 (Aborted), 0 left");
}

TEST_P(SupervisedProcessOn, EndsWhatItLeft) {
  EXPECT_EQ(on(GetParam(),
               [] {
                 return ending_of([] {
                   if (fork() == 0) stay();
                   if (fork() == 0) {
                     setsid();
                     signal(SIGTERM, SIG_IGN);
                     stay();
                   }
                 });
               }),
            "exit code 0, 2 left");
}

TEST_P(SupervisedProcessOn, IsEndedWhenAsked) {
  EXPECT_EQ(on(GetParam(),
               [] {
                 SupervisedProcess kept([] { stay(); }, {});
                 kept.kill_now();
                 return kept.wait() ? how_it_ended(kept.wait()->status) : "lost";
               }),
            "killed by signal 9 (Killed)");
}

TEST_P(SupervisedProcessOn, SaysHowItEndedWhereItIsAskedToEndToo) {
  EXPECT_EQ(on(GetParam(),
               [] {
                 SupervisedProcess kept([] { _exit(7); }, {});
                 for (pollfd end{kept.end(), POLLIN, 0}; poll(&end, 1, -1) < 0;) {
                 }
                 kept.kill_now();
                 return kept.wait() ? how_it_ended(kept.wait()->status) : "lost";
               }),
            "exit code 7");
}

TEST_P(SupervisedProcessOn, HasNoDescriptorButItsOwn) {
  EXPECT_EQ(on(GetParam(),
               [] {
                 const int mine = dup(STDIN_FILENO);
                 SupervisedProcess kept(
                     [&] {
                       int open_ones = 0;
                       for (int i = 0; i < 1024; ++i) open_ones += fcntl(i, F_GETFD) >= 0;
                       _exit(fcntl(mine, F_GETFD) < 0 ? 100 : open_ones);
                     },
                     {.others = {mine}});
                 return how_it_ended(kept.wait()->status);
               }),
            "exit code 4");
}

TEST_P(SupervisedProcessOn, EndsWithItsOwner) {
  EXPECT_EQ(on(GetParam(),
               [] {
                 Child owner(std::function<void(int)>([](int output) {
                   const SupervisedProcess kept([] { stay(); }, {});
                   const pid_t id = kept.id();
                   write_all(output, {reinterpret_cast<const char*>(&id), sizeof id});
                   stay();
                 }));
                 while (owner.bytes().size() < sizeof(pid_t)) owner.advance();
                 pid_t id;
                 std::memcpy(&id, owner.bytes().data(), sizeof id);
                 const bool lived = kill(id, 0) == 0;
                 owner.kill_now();
                 owner.wait();
                 while (kill(id, 0) == 0) usleep(1000);  // endless if the process does not end
                 return std::string(lived ? "lived" : "never lived");
               }),
            "lived");
}

/// How a process ended that sent SIGKILL to `whom`. It sends the signal only after it has proved that it is
/// in another PID namespace than this test: elsewhere the signal would reach every process of the machine.
std::string ending_of_sender(System system, pid_t (*whom)()) {
  const ino_t home = pid_namespace();
  return on(system, [home, whom] {
    return ending_of([home, whom] {
      if (home == 0 || pid_namespace() == 0 || pid_namespace() == home) _exit(100);
      kill(whom(), SIGKILL);
    });
  });
}

TEST_P(SupervisedProcessOn, ReachesNoOtherIfItIsApart) {
  for (pid_t (*const whom)() : {+[] { return pid_t{-1}; }, +[] { return getppid(); }}) {
    const std::string ending = ending_of_sender(GetParam(), whom);
    if (ending == "exit code 100, 0 left")  // then the filter of confine() alone holds it back
      std::cout << "no signal was sent: this system gives the process no PID namespace of its own\n";
    else
      EXPECT_EQ(ending, "exit code 0, 0 left");
  }
}

TEST(SupervisedProcess, AProcessThatIsNotApartSendsNoSignal) {
  EXPECT_EQ(ending_of_sender(
                System::none, +[] { return pid_t{-1}; }),
            "exit code 100, 0 left");
}

TEST(Confine, NamesWhatIsDenied) {
  ASSERT_TRUE(can_confine());
  static std::atomic<int>* denied;
  denied = static_cast<std::atomic<int>*>(
      mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  const auto named = [](const std::function<void()>& act) {
    denied->store(-1);
    const std::string ending = ending_of([&] {
      confine(*denied);
      act();
    });
    return denied->load() < 0 ? ending : system_call_name(denied->load());
  };
  // Signal 0 reaches no process if the filter fails.
  EXPECT_EQ(named([] { kill(-1, 0); }), "kill");
  EXPECT_EQ(named([] { kill(0, 0); }), "kill");
  EXPECT_EQ(named([] { kill(getppid(), 0); }), "kill");
  EXPECT_EQ(named([] { fork(); }), "clone");
  EXPECT_EQ(named([] { execl("/bin/true", "true", nullptr); }), "execve");
  EXPECT_EQ(named([] { std::thread([] {}).join(); }), "exit code 0, 0 left") << "threads are fine";
  EXPECT_EQ(named([] { std::raise(SIGUSR1); }), "killed by signal 10 (User defined signal 1), 0 left");
  munmap(denied, sizeof *denied);
}

TEST(Confine, IsNotPossibleWhereTheKernelRefuses) {
  Child child([]() -> std::string {
    const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
    seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(seccomp), 0);
    seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(prctl), 1,
                     scmp_arg_cmp{0, SCMP_CMP_EQ, PR_SET_SECCOMP, 0});
    if (seccomp_load(filter) != 0) return "no filter";
    return can_confine() ? "yes" : "no";
  });
  EXPECT_EQ(child.wait(), 0);
  EXPECT_EQ(child.bytes(), "no");
}

}  // namespace
}  // namespace cyl
