/* Preloaded: the n-th call of one kind fails, once.
 *
 *   FAILS_WHAT   malloc (calloc and realloc with it), mmap, write, fsync, rename, open or close; of write and close
 * what is no standard stream FAILS_AT     n, from 1; 0: none FAILS_ERRNO  with which errno, 5 (EIO) unless told;
 * malloc and mmap always with ENOMEM FAILS_COUNT  a file: gets the number of calls of the kind, when the program ends
 *
 * What glibc calls inside of itself is not seen.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

static atomic_long calls;

static int is_asked_for(const char* kind) {
  const char* const what = getenv("FAILS_WHAT");
  return what && strcmp(what, kind) == 0;
}
static int fails(const char* kind) {
  if (!is_asked_for(kind)) return 0;
  const char* const at = getenv("FAILS_AT");
  return atomic_fetch_add(&calls, 1) + 1 == (at ? atol(at) : 0);
}
static int with_errno(void) {
  const char* const told = getenv("FAILS_ERRNO");
  errno = told ? atoi(told) : EIO;
  return -1;
}

/* POSIX lets a pointer to an object become one to a function; ISO C does not. */
#define REAL(name)                               \
  static __typeof__(name)* real;                 \
  if (!real) {                                   \
    void* const found = dlsym(RTLD_NEXT, #name); \
    memcpy(&real, &found, sizeof real);          \
  }

/* Of glibc, the plain ones are behind other names. */
extern void* __libc_malloc(size_t size);
extern void* __libc_calloc(size_t count, size_t size);
extern void* __libc_realloc(void* old, size_t size);
static void* no_room(void) {
  errno = ENOMEM;
  return NULL;
}
void* malloc(size_t size) { return fails("malloc") ? no_room() : __libc_malloc(size); }
void* calloc(size_t count, size_t size) { return fails("malloc") ? no_room() : __libc_calloc(count, size); }
void* realloc(void* old, size_t size) { return fails("malloc") ? no_room() : __libc_realloc(old, size); }

static void* no_map(void) {
  errno = ENOMEM;
  return MAP_FAILED;
}
void* mmap(void* at, size_t size, int rights, int flags, int file, off_t from) {
  REAL(mmap)
  return fails("mmap") ? no_map() : real(at, size, rights, flags, file, from);
}
void* mmap64(void* at, size_t size, int rights, int flags, int file, off64_t from) {
  REAL(mmap64)
  return fails("mmap") ? no_map() : real(at, size, rights, flags, file, from);
}

ssize_t write(int file, const void* bytes, size_t count) {
  REAL(write)
  return file > STDERR_FILENO && fails("write") ? with_errno() : real(file, bytes, count);
}
int fsync(int file) {
  REAL(fsync)
  return fails("fsync") ? with_errno() : real(file);
}
int rename(const char* from, const char* to) {
  REAL(rename)
  return fails("rename") ? with_errno() : real(from, to);
}
int close(int file) {
  REAL(close)
  const int ended = real(file);
  return file > STDERR_FILENO && fails("close") ? with_errno() : ended;
}

static mode_t mode_of(int flags, va_list more) { return flags & O_CREAT ? va_arg(more, mode_t) : 0; }
int open(const char* path, int flags, ...) {
  REAL(open)
  va_list more;
  va_start(more, flags);
  const mode_t mode = mode_of(flags, more);
  va_end(more);
  return fails("open") ? with_errno() : real(path, flags, mode);
}
int open64(const char* path, int flags, ...) {
  REAL(open64)
  va_list more;
  va_start(more, flags);
  const mode_t mode = mode_of(flags, more);
  va_end(more);
  return fails("open") ? with_errno() : real(path, flags, mode);
}
int openat(int folder, const char* path, int flags, ...) {
  REAL(openat)
  va_list more;
  va_start(more, flags);
  const mode_t mode = mode_of(flags, more);
  va_end(more);
  return fails("open") ? with_errno() : real(folder, path, flags, mode);
}
int mkstemp(char* name) {
  REAL(mkstemp)
  return fails("open") ? with_errno() : real(name);
}

__attribute__((destructor)) static void count(void) {
  const char* const to = getenv("FAILS_COUNT");
  FILE* const file = to ? fopen(to, "w") : NULL;
  if (!file) return;
  fprintf(file, "%ld\n", atomic_load(&calls));
  fclose(file);
}
