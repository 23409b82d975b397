/* Preloaded: another machine's processors and clock.
 *
 *   MACHINE_PROCESSORS  how many there are
 *   MACHINE_CLOCK       jumps: each time that it is asked the time of day is another, years before or after, at times
 *                       before 1970 and after 2038. (What measures spans, CLOCK_MONOTONIC, cannot jump.)
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <sys/sysinfo.h>
#include <sys/time.h>
#include <time.h>

#define REAL(name)                               \
  static __typeof__(name)* real;                 \
  if (!real) {                                   \
    void* const found = dlsym(RTLD_NEXT, #name); \
    memcpy(&real, &found, sizeof real);          \
  }

int get_nprocs(void) {
  REAL(get_nprocs)
  const char* const told = getenv("MACHINE_PROCESSORS");
  return told ? atoi(told) : real();
}

static time_t jumped(time_t now) {
  static const long long years[] = {0, 10, -30, 30, -80, 400, 1, -1};
  static atomic_uint asked;
  const unsigned turn = atomic_fetch_add(&asked, 1) % (sizeof years / sizeof *years);
  return getenv("MACHINE_CLOCK") ? now + years[turn] * 31556952 : now;
}

int clock_gettime(clockid_t clock, struct timespec* now) {
  REAL(clock_gettime)
  const int done = real(clock, now);
  if (done == 0 && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE)) now->tv_sec = jumped(now->tv_sec);
  return done;
}
int gettimeofday(struct timeval* restrict now, void* restrict zone) {
  REAL(gettimeofday)
  const int done = real(now, zone);
  if (done == 0) now->tv_sec = jumped(now->tv_sec);
  return done;
}
time_t time(time_t* kept) {
  REAL(time)
  const time_t now = jumped(real(NULL));
  if (kept) *kept = now;
  return now;
}
