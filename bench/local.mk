# bench: programs that measure, for `make bench`. Each prints its own table.

BENCHES = \
  bench/bigfloat \
  bench/prove

EXTRA_PROGRAMS += $(BENCHES)
CLEANFILES += $(BENCHES)

# bench/prove runs the program itself.
bench_prove_LDADD =

# These compare with MPFR and FLINT where there are any.
bench_bigfloat_LDADD = $(BIGFLOAT_LIBS) $(ORACLE_LIBS) $(SMOOTHCERT_LIBS)

.PHONY: bench
bench: all
	@for program in $(BENCHES); do \
	  echo "== $$program"; \
	  $(MAKE) -s $(AM_MAKEFLAGS) $$program && ./$$program || exit 1; \
	done
