# tests: programs and shell scripts that print PASS, FAIL or SKIP lines; tests/run-tests runs them.
# By layer, lowest first; a test links with its own layer and those below, and no more.

BIGFLOAT_TESTS = \
  tests/bigfloat/t-integer \
  tests/bigfloat/t-ball \
  tests/bigfloat/t-trig \
  tests/bigfloat/t-interval \
  tests/bigfloat/t-grid

# These compare with MPFR and FLINT, or skip where there is none.
ORACLE_TESTS =

LIB_TESTS =

VERIFY_TESTS =

SCRIPT_TESTS =

ALL_TESTS = $(BIGFLOAT_TESTS) $(ORACLE_TESTS) $(LIB_TESTS) $(VERIFY_TESTS) $(SCRIPT_TESTS)

check_PROGRAMS += $(BIGFLOAT_TESTS) $(ORACLE_TESTS) $(LIB_TESTS) $(VERIFY_TESTS)
EXTRA_DIST += tests/run-tests $(SCRIPT_TESTS)

# What tests share.
EXTRA_LIBRARIES = libharness.a
CLEANFILES += libharness.a
libharness_a_SOURCES = \
  tests/harness.h tests/harness.c \
  tests/bigfloat/random.h tests/bigfloat/random.c

# The source of tests/bigfloat/t-x is tests/bigfloat/t-x.c, and it links with this unless told otherwise.
LDADD = libharness.a $(BIGFLOAT_LIBS)
LINK_ORACLE = libharness.a $(BIGFLOAT_LIBS) $(ORACLE_LIBS) $(SMOOTHCERT_LIBS)
LINK_LIB = libharness.a $(LIB_LIBS)
LINK_VERIFY = libharness.a $(VERIFY_LIBS)

# make check TESTS="ball lib" runs only those whose name or folder is named. TESTS itself is not set
# here, for automake would then run them its own way.
RUN_TESTS = SRCDIR=$(srcdir) BUILDDIR=. $(SHELL) $(srcdir)/tests/run-tests --only "$(TESTS)" $(ALL_TESTS)

check-local:
	@$(RUN_TESTS)

# Build what `make check` needs and run nothing.
.PHONY: check-programs check-long
check-programs: all
	@$(MAKE) $(AM_MAKEFLAGS) $(check_PROGRAMS)

# Random tests for longer: each test draws until its time is up.
SECONDS_PER_TEST = 60
check-long: check-programs
	@SECONDS_PER_TEST=$(SECONDS_PER_TEST) TEST_TIMEOUT=0 $(RUN_TESTS)
