/* The functions of FLINT (and of Calcium beside FLINT 2) that RationalFunction (rational_function.h) is made of:
   quotients of polynomials with whole coefficients in a few indeterminates, always in lowest terms. Their headers are
   not all valid C++, so only rational_function_bridge.c includes them. */
#ifndef EPURE_GEOMETRY_NUMBERS_RATIONAL_FUNCTION_BRIDGE_H
#define EPURE_GEOMETRY_NUMBERS_RATIONAL_FUNCTION_BRIDGE_H

#include "geometry/numbers/flint.h"

#include <gmp.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How many indeterminates there are. */
#define EPURE_FUNCTION_VARIABLES 4

/* What all functions share: written once, only read afterwards. */
typedef struct epure_function_ring epure_function_ring;
typedef struct epure_function epure_function;

epure_function_ring* epure_function_open(void);

/* A new function, 0. */
epure_function* epure_function_new(const epure_function_ring* ring);
void epure_function_free(epure_function* x, const epure_function_ring* ring);

void epure_function_set(epure_function* result, const epure_function* x, const epure_function_ring* ring);
void epure_function_set_rational(epure_function* result, mpq_srcptr value, const epure_function_ring* ring);
/* The indeterminate of this number, from 0. */
void epure_function_set_variable(epure_function* result, int variable, const epure_function_ring* ring);

void epure_function_add(epure_function* result, const epure_function* a, const epure_function* b,
                        const epure_function_ring* ring);
void epure_function_multiply(epure_function* result, const epure_function* a, const epure_function* b,
                             const epure_function_ring* ring);
/* b is not zero. */
void epure_function_divide(epure_function* result, const epure_function* a, const epure_function* b,
                           const epure_function_ring* ring);
void epure_function_negate(epure_function* result, const epure_function* x, const epure_function_ring* ring);

int epure_function_is_zero(const epure_function* x, const epure_function_ring* ring);
/* Whether x is the square of a rational function, which is then written to the result, with either sign. */
int epure_function_root(epure_function* result, const epure_function* x, const epure_function_ring* ring);

/* Its terms, each counted as often as its coefficient has words. */
slong epure_function_size(const epure_function* x, const epure_function_ring* ring);

/* A ball around the value where the indeterminates are `at`; without bounds where the denominator may vanish. */
void epure_function_enclose(arb_t result, const epure_function* x, arb_srcptr at, slong bits,
                            const epure_function_ring* ring);

#ifdef __cplusplus
}
#endif

#endif
