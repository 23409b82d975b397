/* The functions of the Calcium library that Calcium (calcium.h) is made of. Calcium's own headers are not valid C++,
   so only calcium_bridge.c includes them. Every function is safe to call with any number of the given context. */
#ifndef EPURE_GEOMETRY_NUMBERS_CALCIUM_BRIDGE_H
#define EPURE_GEOMETRY_NUMBERS_CALCIUM_BRIDGE_H

#include "geometry/numbers/flint.h"

#include <gmp.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct epure_calcium_context epure_calcium_context;
typedef struct epure_calcium_number epure_calcium_number;

/* Calcium's own truth_t has true as 0. */
typedef enum { EPURE_CALCIUM_NO, EPURE_CALCIUM_YES, EPURE_CALCIUM_UNKNOWN } epure_calcium_truth;

/* With so many products of terms to spend. */
epure_calcium_context* epure_calcium_open(slong products);
void epure_calcium_close(epure_calcium_context* context);

/* A new number, 0. To be freed before its context is closed. */
epure_calcium_number* epure_calcium_new(epure_calcium_context* context);
void epure_calcium_free(epure_calcium_number* x, epure_calcium_context* context);

void epure_calcium_set(epure_calcium_number* result, const epure_calcium_number* x, epure_calcium_context* context);
void epure_calcium_set_rational(epure_calcium_number* result, mpq_srcptr value, epure_calcium_context* context);
void epure_calcium_set_pi(epure_calcium_number* result, epure_calcium_context* context);
/* cos(pi * half_turns), made from the root of unity exp(i pi half_turns). */
void epure_calcium_set_cosine(epure_calcium_number* result, mpq_srcptr half_turns, epure_calcium_context* context);

void epure_calcium_add(epure_calcium_number* result, const epure_calcium_number* a, const epure_calcium_number* b,
                       epure_calcium_context* context);
void epure_calcium_subtract(epure_calcium_number* result, const epure_calcium_number* a,
                            const epure_calcium_number* b, epure_calcium_context* context);
void epure_calcium_multiply(epure_calcium_number* result, const epure_calcium_number* a,
                            const epure_calcium_number* b, epure_calcium_context* context);
/* b must be proved nonzero before. */
void epure_calcium_divide(epure_calcium_number* result, const epure_calcium_number* a, const epure_calcium_number* b,
                          epure_calcium_context* context);
void epure_calcium_negate(epure_calcium_number* result, const epure_calcium_number* x,
                          epure_calcium_context* context);
void epure_calcium_root(epure_calcium_number* result, const epure_calcium_number* x, epure_calcium_context* context);

/* How large the number is: the terms of its numerator and denominator, as polynomials in what is not rational. 1 of a
   rational number and of an element of a number field, whatever its degree. */
slong epure_calcium_terms(const epure_calcium_number* x, epure_calcium_context* context);

/* Takes so many products of terms from what is left. 0 when there are not so many, and none is left then. */
int epure_calcium_spend(slong products, epure_calcium_context* context);

epure_calcium_truth epure_calcium_is_zero(const epure_calcium_number* x, epure_calcium_context* context);
/* A ball around the real part. */
void epure_calcium_enclose(arb_t result, const epure_calcium_number* x, slong bits, epure_calcium_context* context);

const char* epure_calcium_version(void);

#ifdef __cplusplus
}
#endif

#endif
