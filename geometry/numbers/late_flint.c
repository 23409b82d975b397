/* FLINT, with Arb and Calcium, loaded when the first of its functions is called. Loading looks up ten thousand names,
   which is a tenth of the time of a sheet, and most sheets need none of it.

   Each name that the program uses is defined here as a jump through a slot. At first a slot leads to the search for
   its function, which then takes its place. names.inc, made by the build, lists them: LATE(arb_add) ... */
#include <dlfcn.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <unistd.h>

struct slot {
  _Atomic(void*) function;
  const char* name;
};

static pthread_once_t once = PTHREAD_ONCE_INIT;
static _Atomic(void*) library = 0;

/* As the command line does with what cannot be read: one sentence, exit 3. No C++ may pass through here. */
static void give_up(void) {
  fprintf(stderr, "epure: %s\n", dlerror());
  fflush(stderr);
  _exit(3);
}

static void load(void) {
  void* found = dlopen(EPURE_FLINT, RTLD_LAZY | RTLD_LOCAL | RTLD_DEEPBIND);
  if (!found) give_up();
  atomic_store(&library, found);
}

__attribute__((visibility("hidden"), used)) void* epure_find_late(struct slot* slot) {
  pthread_once(&once, load);
  void* function = dlsym(atomic_load(&library), slot->name);
  if (!function) give_up();
  atomic_store(&slot->function, function);
  return function;
}

/* What a thread has kept; nothing, where FLINT was not loaded. */
void flint_cleanup(void) {
  void* loaded = atomic_load(&library);
  if (!loaded) return;
  void (*cleanup)(void) = 0;
  *(void**)&cleanup = dlsym(loaded, "flint_cleanup");
  if (cleanup) cleanup();
}

/* All registers that hold arguments are kept over the search; %r11 holds the slot. */
__asm__(
    ".text\n"
    ".type epure_late, @function\n"
    "epure_late:\n"
    "  push %rdi\n  push %rsi\n  push %rdx\n  push %rcx\n  push %r8\n  push %r9\n  push %rax\n"
    "  sub $128, %rsp\n"
    "  movups %xmm0, (%rsp)\n  movups %xmm1, 16(%rsp)\n  movups %xmm2, 32(%rsp)\n  movups %xmm3, 48(%rsp)\n"
    "  movups %xmm4, 64(%rsp)\n  movups %xmm5, 80(%rsp)\n  movups %xmm6, 96(%rsp)\n  movups %xmm7, 112(%rsp)\n"
    "  mov %r11, %rdi\n"
    "  call epure_find_late\n"
    "  mov %rax, %r11\n"
    "  movups (%rsp), %xmm0\n  movups 16(%rsp), %xmm1\n  movups 32(%rsp), %xmm2\n  movups 48(%rsp), %xmm3\n"
    "  movups 64(%rsp), %xmm4\n  movups 80(%rsp), %xmm5\n  movups 96(%rsp), %xmm6\n  movups 112(%rsp), %xmm7\n"
    "  add $128, %rsp\n"
    "  pop %rax\n  pop %r9\n  pop %r8\n  pop %rcx\n  pop %rdx\n  pop %rsi\n  pop %rdi\n"
    "  jmp *%r11\n"
    ".size epure_late, . - epure_late\n");

#define LATE(name)                                        \
  __asm__(".globl " #name                                 \
          "\n"                                            \
          ".type " #name ", @function\n" #name            \
          ":\n"                                           \
          "  jmp *1f(%rip)\n"                             \
          "0: lea 1f(%rip), %r11\n"                       \
          "  jmp epure_late\n"                            \
          ".size " #name ", . - " #name                   \
          "\n"                                            \
          ".section .data.rel,\"aw\"\n"                   \
          ".balign 8\n"                                   \
          "1: .quad 0b\n"                                 \
          "  .quad 2f\n"                                  \
          ".section .rodata.str1.1,\"aMS\",@progbits,1\n" \
          "2: .asciz \"" #name                            \
          "\"\n"                                          \
          ".text\n");
#include "names.inc"
