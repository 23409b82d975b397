/* FLINT, Arb and Calcium. FLINT 3 holds the others; beside FLINT 2 they are libraries of their own, with headers
   elsewhere. This is the only file that includes any of them (and CMakeLists.txt links them). */
#ifndef EPURE_GEOMETRY_NUMBERS_FLINT_H
#define EPURE_GEOMETRY_NUMBERS_FLINT_H

#if __has_include(<flint/arb.h>)
#include <flint/acb.h>
#include <flint/acb_calc.h>
#include <flint/acb_elliptic.h>
#include <flint/acb_modular.h>
#include <flint/arb.h>
#include <flint/arb_fmpz_poly.h>
#include <flint/arb_mat.h>
#include <flint/arf.h>
#include <flint/flint.h>
#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>
#ifndef __cplusplus /* no valid C++: for calcium_bridge.c and rational_function_bridge.c alone */
#include <flint/ca.h>
#include <flint/fmpz_mpoly_q.h>
#endif
#else
#include <acb.h>
#include <acb_calc.h>
#include <acb_elliptic.h>
#include <acb_modular.h>
#include <arb.h>
#include <arb_fmpz_poly.h>
#include <arb_mat.h>
#include <arf.h>
#include <flint/flint.h>
#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>
#ifndef __cplusplus
#include <calcium/ca.h>
#include <calcium/fmpz_mpoly_q.h>
#endif
#endif

#endif
