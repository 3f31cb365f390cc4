# bench: programs that measure, for `make bench`. Each prints its own table.

BENCHES =

EXTRA_PROGRAMS += $(BENCHES)
CLEANFILES += $(BENCHES)

.PHONY: bench
bench: all
	@for program in $(BENCHES); do \
	  echo "== $$program"; \
	  $(MAKE) -s $(AM_MAKEFLAGS) $$program && ./$$program || exit 1; \
	done
