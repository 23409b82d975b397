/* Preloaded: the kernel ends a process that asks for a network or starts another program (SIGSYS).
 *
 * Threads are let be. glibc makes them by clone3, whose flags a filter cannot see: it is told that there is none, and
 * takes clone.
 */
#include <errno.h>
#include <linux/filter.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#define ENDS_FOR(number) \
  BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, (number), 0, 1), BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS)

__attribute__((constructor)) static void be_alone(void) {
  struct sock_filter filter[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, nr)),
      ENDS_FOR(SYS_socket),
      ENDS_FOR(SYS_socketpair),
      ENDS_FOR(SYS_connect),
      ENDS_FOR(SYS_bind),
      ENDS_FOR(SYS_execve),
      ENDS_FOR(SYS_execveat),
#ifdef SYS_fork
      ENDS_FOR(SYS_fork),
      ENDS_FOR(SYS_vfork),
#endif
      ENDS_FOR(SYS_ptrace),
#ifdef SYS_io_uring_setup
      ENDS_FOR(SYS_io_uring_setup),
#endif
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_clone3, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOSYS),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_clone, 0, 3),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, args[0])),
      BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, CLONE_THREAD, 1, 0),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const struct sock_fprog program = {sizeof filter / sizeof *filter, filter};
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) {
    perror("alone");
    _Exit(99);
  }
}
