# bench: programs that measure, for `make bench`. Each prints its own table.

BENCHES = \
  bench/bigfloat \
  bench/spectrum \
  bench/prove \
  bench/check

EXTRA_PROGRAMS += $(BENCHES)
CLEANFILES += $(BENCHES)

# These run the programs themselves.
bench_prove_LDADD =
bench_check_LDADD =

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
