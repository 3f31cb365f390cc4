# bench: programs that measure, for `make bench`. Each prints its own table.

BENCHES = \
  bench/bigfloat \
  bench/spectrum \
  bench/prove

EXTRA_PROGRAMS += $(BENCHES)
CLEANFILES += $(BENCHES)

# bench/prove runs the program itself.
bench_prove_LDADD =

# These compare with MPFR and FLINT where there are any.
bench_bigfloat_LDADD = $(BIGFLOAT_LIBS) $(ORACLE_LIBS) $(SMOOTHCERT_LIBS)

bench_spectrum_LDADD = $(VERIFY_LIBS)
EXTRA_DIST += bench/twelve.scheme

.PHONY: bench
bench: all
	@for program in $(BENCHES); do \
	  echo "== $$program"; \
	  $(MAKE) -s $(AM_MAKEFLAGS) $$program && SRCDIR=$(srcdir) ./$$program || exit 1; \
	done
