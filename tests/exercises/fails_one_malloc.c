/* Preloaded: the n-th call of malloc fails, once. n is FAILS_AT. Of glibc, the plain malloc is behind another name.
 */
#include <errno.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdlib.h>

extern void* __libc_malloc(size_t size);

void* malloc(size_t size) {
  static atomic_long calls;
  const char* const at = getenv("FAILS_AT");
  if (at && atomic_fetch_add(&calls, 1) + 1 == atol(at)) {
    errno = ENOMEM;
    return NULL;
  }
  return __libc_malloc(size);
}
