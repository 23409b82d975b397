#include "geometry/numbers/rational_function_bridge.h"

#include <stdlib.h>

struct epure_function_ring {
  fmpz_mpoly_ctx_t polynomials;
};

struct epure_function {
  fmpz_mpoly_q_t value;
};

static void* allocate_or_abort(size_t size) {
  void* memory = malloc(size);
  if (!memory) abort(); /* as GMP and FLINT do */
  return memory;
}

epure_function_ring* epure_function_open(void) {
  epure_function_ring* ring = allocate_or_abort(sizeof *ring);
  fmpz_mpoly_ctx_init(ring->polynomials, EPURE_FUNCTION_VARIABLES, ORD_LEX);
  return ring;
}

epure_function* epure_function_new(const epure_function_ring* ring) {
  epure_function* x = allocate_or_abort(sizeof *x);
  fmpz_mpoly_q_init(x->value, ring->polynomials);
  return x;
}

void epure_function_free(epure_function* x, const epure_function_ring* ring) {
  fmpz_mpoly_q_clear(x->value, ring->polynomials);
  free(x);
}

void epure_function_set(epure_function* result, const epure_function* x, const epure_function_ring* ring) {
  fmpz_mpoly_q_set(result->value, x->value, ring->polynomials);
}

void epure_function_set_rational(epure_function* result, mpq_srcptr value, const epure_function_ring* ring) {
  fmpq_t fraction;
  fmpq_init(fraction);
  fmpq_set_mpq(fraction, value);
  fmpz_mpoly_q_set_fmpq(result->value, fraction, ring->polynomials);
  fmpq_clear(fraction);
}

void epure_function_set_variable(epure_function* result, int variable, const epure_function_ring* ring) {
  fmpz_mpoly_q_gen(result->value, variable, ring->polynomials);
}

void epure_function_add(epure_function* result, const epure_function* a, const epure_function* b,
                        const epure_function_ring* ring) {
  fmpz_mpoly_q_add(result->value, a->value, b->value, ring->polynomials);
}

void epure_function_multiply(epure_function* result, const epure_function* a, const epure_function* b,
                             const epure_function_ring* ring) {
  fmpz_mpoly_q_mul(result->value, a->value, b->value, ring->polynomials);
}

void epure_function_divide(epure_function* result, const epure_function* a, const epure_function* b,
                           const epure_function_ring* ring) {
  fmpz_mpoly_q_div(result->value, a->value, b->value, ring->polynomials);
}

void epure_function_negate(epure_function* result, const epure_function* x, const epure_function_ring* ring) {
  fmpz_mpoly_q_neg(result->value, x->value, ring->polynomials);
}

int epure_function_is_zero(const epure_function* x, const epure_function_ring* ring) {
  return fmpz_mpoly_q_is_zero(x->value, ring->polynomials);
}

/* In lowest terms numerator and denominator have no factor in common, so each must be a square. */
int epure_function_root(epure_function* result, const epure_function* x, const epure_function_ring* ring) {
  return fmpz_mpoly_sqrt(fmpz_mpoly_q_numref(result->value), fmpz_mpoly_q_numref(x->value), ring->polynomials) &&
         fmpz_mpoly_sqrt(fmpz_mpoly_q_denref(result->value), fmpz_mpoly_q_denref(x->value), ring->polynomials);
}

static slong size_of(const fmpz_mpoly_t p, const epure_function_ring* ring) {
  const slong bits = fmpz_mpoly_max_bits(p); /* negative when a coefficient is */
  return fmpz_mpoly_length(p, ring->polynomials) * (1 + (bits < 0 ? -bits : bits) / FLINT_BITS);
}

slong epure_function_size(const epure_function* x, const epure_function_ring* ring) {
  return size_of(fmpz_mpoly_q_numref(x->value), ring) + size_of(fmpz_mpoly_q_denref(x->value), ring);
}

static void enclose_polynomial(arb_t result, const fmpz_mpoly_t p, arb_srcptr at, slong bits,
                               const epure_function_ring* ring) {
  ulong exponents[EPURE_FUNCTION_VARIABLES];
  fmpz_t coefficient;
  arb_t term, power;
  fmpz_init(coefficient);
  arb_init(term);
  arb_init(power);
  arb_zero(result);
  for (slong i = 0; i < fmpz_mpoly_length(p, ring->polynomials); ++i) {
    fmpz_mpoly_get_term_coeff_fmpz(coefficient, p, i, ring->polynomials);
    fmpz_mpoly_get_term_exp_ui(exponents, p, i, ring->polynomials);
    arb_set_fmpz(term, coefficient);
    for (int k = 0; k < EPURE_FUNCTION_VARIABLES; ++k) {
      if (exponents[k] == 0) continue;
      arb_pow_ui(power, at + k, exponents[k], bits);
      arb_mul(term, term, power, bits);
    }
    arb_add(result, result, term, bits);
  }
  arb_clear(power);
  arb_clear(term);
  fmpz_clear(coefficient);
}

void epure_function_enclose(arb_t result, const epure_function* x, arb_srcptr at, slong bits,
                            const epure_function_ring* ring) {
  arb_t denominator;
  arb_init(denominator);
  enclose_polynomial(result, fmpz_mpoly_q_numref(x->value), at, bits, ring);
  enclose_polynomial(denominator, fmpz_mpoly_q_denref(x->value), at, bits, ring);
  arb_div(result, result, denominator, bits);
  arb_clear(denominator);
}
