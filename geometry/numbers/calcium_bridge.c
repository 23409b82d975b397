#include "geometry/numbers/calcium_bridge.h"

#include <stdlib.h>

struct epure_calcium_context {
  ca_ctx_t calcium;
  slong products_left;
};

struct epure_calcium_number {
  ca_t value;
};

static void* allocate(size_t size) {
  void* memory = malloc(size);
  if (!memory) abort(); /* as GMP and FLINT do */
  return memory;
}

epure_calcium_context* epure_calcium_open(slong products) {
  epure_calcium_context* context = allocate(sizeof *context);
  ca_ctx_init(context->calcium);
  /* Of a root that is algebraic Calcium would find the polynomial over the rational numbers, up to degree 120, in
     minutes. Up to 30 it takes some milliseconds; beyond, the root is left as it stands, which most proofs do with.
   */
  ca_ctx_set_option(context->calcium, CA_OPT_QQBAR_DEG_LIMIT, 30);
  context->products_left = products;
  return context;
}

void epure_calcium_close(epure_calcium_context* context) {
  ca_ctx_clear(context->calcium);
  free(context);
}

epure_calcium_number* epure_calcium_new(epure_calcium_context* context) {
  epure_calcium_number* x = allocate(sizeof *x);
  ca_init(x->value, context->calcium);
  return x;
}

void epure_calcium_free(epure_calcium_number* x, epure_calcium_context* context) {
  ca_clear(x->value, context->calcium);
  free(x);
}

void epure_calcium_set(epure_calcium_number* result, const epure_calcium_number* x, epure_calcium_context* context) {
  ca_set(result->value, x->value, context->calcium);
}

void epure_calcium_set_rational(epure_calcium_number* result, mpq_srcptr value, epure_calcium_context* context) {
  fmpq_t fraction;
  fmpq_init(fraction);
  fmpq_set_mpq(fraction, value);
  ca_set_fmpq(result->value, fraction, context->calcium);
  fmpq_clear(fraction);
}

void epure_calcium_set_pi(epure_calcium_number* result, epure_calcium_context* context) {
  ca_pi(result->value, context->calcium);
}

/* (z + 1/z)/2 with z = exp(i pi half_turns): all cosines and sines of one direction then live in one field. */
void epure_calcium_set_cosine(epure_calcium_number* result, mpq_srcptr half_turns, epure_calcium_context* context) {
  ca_ctx_struct* ctx = context->calcium;
  fmpq_t fraction;
  ca_t z, inverse;
  fmpq_init(fraction);
  ca_init(z, ctx);
  ca_init(inverse, ctx);
  fmpq_set_mpq(fraction, half_turns);
  ca_pi_i(z, ctx);
  ca_mul_fmpq(z, z, fraction, ctx);
  ca_neg(inverse, z, ctx);
  ca_exp(z, z, ctx);
  ca_exp(inverse, inverse, ctx);
  ca_add(result->value, z, inverse, ctx);
  ca_div_ui(result->value, result->value, 2, ctx);
  ca_clear(inverse, ctx);
  ca_clear(z, ctx);
  fmpq_clear(fraction);
}

void epure_calcium_add(epure_calcium_number* result, const epure_calcium_number* a, const epure_calcium_number* b,
                       epure_calcium_context* context) {
  ca_add(result->value, a->value, b->value, context->calcium);
}

void epure_calcium_subtract(epure_calcium_number* result, const epure_calcium_number* a,
                            const epure_calcium_number* b, epure_calcium_context* context) {
  ca_sub(result->value, a->value, b->value, context->calcium);
}

void epure_calcium_multiply(epure_calcium_number* result, const epure_calcium_number* a,
                            const epure_calcium_number* b, epure_calcium_context* context) {
  ca_mul(result->value, a->value, b->value, context->calcium);
}

void epure_calcium_divide(epure_calcium_number* result, const epure_calcium_number* a, const epure_calcium_number* b,
                          epure_calcium_context* context) {
  ca_div(result->value, a->value, b->value, context->calcium);
}

void epure_calcium_negate(epure_calcium_number* result, const epure_calcium_number* x,
                          epure_calcium_context* context) {
  ca_neg(result->value, x->value, context->calcium);
}

void epure_calcium_root(epure_calcium_number* result, const epure_calcium_number* x, epure_calcium_context* context) {
  ca_sqrt(result->value, x->value, context->calcium);
}

slong epure_calcium_terms(const epure_calcium_number* x, epure_calcium_context* context) {
  if (!ca_is_generic_elem(x->value, context->calcium)) return 1;
  return fmpz_mpoly_q_numref(CA_MPOLY_Q(x->value))->length + fmpz_mpoly_q_denref(CA_MPOLY_Q(x->value))->length;
}

int epure_calcium_spend(slong products, epure_calcium_context* context) {
  const int is_enough = products <= context->products_left;
  context->products_left = is_enough ? context->products_left - products : 0;
  return is_enough;
}

epure_calcium_truth epure_calcium_is_zero(const epure_calcium_number* x, epure_calcium_context* context) {
  switch (ca_check_is_zero(x->value, context->calcium)) {
    case T_TRUE:
      return EPURE_CALCIUM_YES;
    case T_FALSE:
      return EPURE_CALCIUM_NO;
    default:
      return EPURE_CALCIUM_UNKNOWN;
  }
}

void epure_calcium_enclose(arb_t result, const epure_calcium_number* x, slong bits, epure_calcium_context* context) {
  acb_t ball;
  acb_init(ball);
  ca_get_acb(ball, x->value, bits, context->calcium);
  arb_set(result, acb_realref(ball));
  acb_clear(ball);
}

#if __FLINT_VERSION < 3 /* FLINT 3 has Calcium's number no more */
const char* epure_calcium_version(void) { return calcium_version(); }
#endif
