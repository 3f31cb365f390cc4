# tests: programs and shell scripts that print PASS, FAIL or SKIP lines; tests/run-tests runs them.
# By layer, lowest first; a test links with its own layer and those below, and no more.

BIGFLOAT_TESTS = \
  tests/bigfloat/t-integer \
  tests/bigfloat/t-ball \
  tests/bigfloat/t-rational \
  tests/bigfloat/t-text \
  tests/bigfloat/t-trig \
  tests/bigfloat/t-fixed-trig \
  tests/bigfloat/t-complex \
  tests/bigfloat/t-batch \
  tests/bigfloat/t-memory \
  tests/bigfloat/t-interval \
  tests/bigfloat/t-grid \
  tests/bigfloat/exhaustive-ball \
  tests/bigfloat/exhaustive-grid \
  tests/bigfloat/exhaustive-interval \
  tests/bigfloat/identities \
  tests/bigfloat/extremes

# These compare with MPFR and FLINT, or skip where there is none.
ORACLE_TESTS = \
  tests/bigfloat/oracle-gmp \
  tests/bigfloat/oracle-mpfr \
  tests/bigfloat/oracle-arb
tests_bigfloat_oracle_gmp_LDADD = $(LINK_ORACLE)
tests_bigfloat_oracle_mpfr_LDADD = $(LINK_ORACLE)
tests_bigfloat_oracle_arb_LDADD = $(LINK_ORACLE)

LIB_TESTS = \
  tests/lib/t-formula \
  tests/lib/t-laurent \
  tests/lib/t-regular \
  tests/lib/t-number_field \
  tests/lib/t-scheme \
  tests/lib/t-scheme_language \
  tests/lib/t-element \
  tests/lib/t-bernstein \
  tests/lib/t-eigen_approx \
  tests/lib/t-schur_approx
tests_lib_t_formula_LDADD = $(LINK_LIB)
tests_lib_t_laurent_LDADD = $(LINK_LIB)
tests_lib_t_regular_LDADD = $(LINK_LIB)
tests_lib_t_number_field_LDADD = $(LINK_LIB)
tests_lib_t_scheme_LDADD = $(LINK_LIB)
tests_lib_t_scheme_language_LDADD = $(LINK_LIB)
tests_lib_t_element_LDADD = $(LINK_LIB)
tests_lib_t_bernstein_LDADD = $(LINK_LIB)
tests_lib_t_eigen_approx_LDADD = $(LINK_LIB)
tests_lib_t_schur_approx_LDADD = $(LINK_LIB)

VERIFY_TESTS = \
  tests/verify/t-sha256 \
  tests/verify/t-tree \
  tests/verify/t-valence_list \
  tests/verify/t-archive \
  tests/verify/t-survey \
  tests/verify/t-certificate \
  tests/verify/t-picture \
  tests/verify/t-prove \
  tests/verify/t-exact \
  tests/verify/t-winding \
  tests/verify/t-consistency \
  tests/verify/t-uniform \
  tests/verify/t-polynomial
tests_verify_t_sha256_LDADD = $(LINK_VERIFY)
tests_verify_t_tree_LDADD = $(LINK_VERIFY)
tests_verify_t_valence_list_LDADD = $(LINK_VERIFY)
tests_verify_t_archive_LDADD = $(LINK_VERIFY)
tests_verify_t_survey_LDADD = $(LINK_VERIFY)
tests_verify_t_certificate_LDADD = $(LINK_VERIFY)
tests_verify_t_picture_LDADD = $(LINK_VERIFY)
tests_verify_t_consistency_LDADD = $(LINK_VERIFY)
tests_verify_t_exact_LDADD = $(LINK_VERIFY)
tests_verify_t_winding_LDADD = $(LINK_VERIFY)
tests_verify_t_prove_LDADD = $(LINK_VERIFY)
tests_verify_t_uniform_LDADD = $(LINK_VERIFY)
tests_verify_t_polynomial_LDADD = $(LINK_VERIFY)

# The checker as a program, judged by the prover.
CERTIFICATE_TESTS = \
  tests/certificates/t-mutate \
  tests/certificates/t-numbers \
  tests/certificates/t-radius
CORPUS_SOURCES = \
  tests/certificates/mutations.h tests/certificates/mutations.c \
  tests/certificates/corpus.h tests/certificates/corpus.c
JUDGE_SOURCES = $(CORPUS_SOURCES) tests/certificates/judge.h tests/certificates/judge.c
tests_certificates_t_mutate_SOURCES = tests/certificates/t-mutate.c $(JUDGE_SOURCES)
tests_certificates_t_numbers_SOURCES = tests/certificates/t-numbers.c tests/certificates/numbers.h tests/certificates/numbers.c $(JUDGE_SOURCES)
tests_certificates_t_radius_SOURCES = tests/certificates/t-radius.c $(CORPUS_SOURCES)
tests_certificates_t_mutate_LDADD = $(LINK_VERIFY)
tests_certificates_t_numbers_LDADD = $(LINK_VERIFY)
tests_certificates_t_radius_LDADD = $(LINK_VERIFY)

# Like the checker, its test sees nothing of ours.
CHECK_TESTS = \
  tests/check/t-check-units \
  tests/check/t-check-geometry \
  tests/check/t-check-spectrum \
  tests/check/t-check-winding \
  tests/check/t-check-graded \
  tests/check/t-check-field \
  tests/check/t-check-ranges
tests_check_t_check_units_CPPFLAGS =
tests_check_t_check_units_SOURCES = tests/check/protocol.h tests/check/t-check-units.c
tests_check_t_check_units_LDADD =
tests_check_t_check_geometry_CPPFLAGS =
tests_check_t_check_geometry_SOURCES = tests/check/protocol.h tests/check/t-check-geometry.c
tests_check_t_check_geometry_LDADD =
tests_check_t_check_spectrum_CPPFLAGS =
tests_check_t_check_spectrum_LDADD =
tests_check_t_check_winding_CPPFLAGS =
tests_check_t_check_winding_LDADD =
tests_check_t_check_graded_CPPFLAGS =
tests_check_t_check_graded_LDADD =
tests_check_t_check_field_CPPFLAGS =
tests_check_t_check_field_SOURCES = tests/check/protocol.h tests/check/t-check-field.c
tests_check_t_check_field_LDADD =
tests_check_t_check_ranges_CPPFLAGS =
tests_check_t_check_ranges_LDADD =

# One source, three programs: tests/lib/t-x-interval, -ball and -grid of tests/lib/t-x.c.
GENERIC_TESTS = \
  tests/lib/t-formula_value \
  tests/lib/t-block \
  tests/lib/t-frequencies \
  tests/lib/t-valence_ranges \
  tests/lib/t-affine \
  tests/lib/t-catalogue \
  tests/lib/t-quad \
  tests/lib/t-spectrum \
  tests/lib/t-cover \
  tests/lib/t-monotone \
  tests/lib/t-separation \
  tests/lib/t-limit \
  tests/lib/t-eigenvalues \
  tests/lib/t-eigenvalues_near \
  tests/lib/t-eigenpair \
  tests/lib/t-complex_eigenpair \
  tests/lib/t-eigenpair_affine \
  tests/lib/t-charnet \
  tests/lib/t-charnet_schemes \
  tests/lib/t-charnet_affine \
  tests/lib/t-patch_product \
  tests/lib/t-graded \
  tests/lib/t-ring \
  tests/verify/t-uniform_net \
  tests/verify/t-adaptive

SCRIPT_TESTS = \
  tests/bigfloat/installed.sh \
  tests/verify/pages.sh \
  tests/verify/completion.sh \
  tests/verify/report.sh \
  tests/verify/advice.sh \
  tests/verify/readme.sh \
  tests/lib/bad-schemes.sh \
  tests/lib/man-examples.sh \
  tests/check/t-check-program.sh \
  tests/check/ranges.sh \
  tests/check/reading.sh \
  tests/check/released.sh \
  tests/certificates/accept.sh \
  tests/certificates/reject.sh \
  tests/certificates/reject-1.sh \
  tests/certificates/cut.sh \
  tests/certificates/proofs.sh \
  tests/certificates/usage.sh \
  tests/fuzz/agree.sh \
  tests/verify/cases.sh \
  tests/verify/cli.sh \
  tests/verify/ranges.sh \
  tests/verify/archive.sh \
  tests/verify/regular.sh \
  tests/verify/spectrum.sh \
  tests/faults/durability.sh \
  tests/faults/kill.sh \
  tests/faults/failing.sh

# Files that tests read.
EXTRA_DIST += \
  tests/lib/catalogue-golden.txt tests/lib/bad-schemes \
  tests/check/loop.scheme tests/check/loop-7.cert tests/check/loop-7-second.cert \
  tests/check/butterfly.scheme tests/check/butterfly-5.cert \
  tests/check/wide-cos.scheme tests/check/wide-cos-3.cert \
  tests/check/ranges \
  tests/certificates/schemes \
  tests/certificates/accept \
  tests/certificates/accept-1 \
  tests/certificates/reject \
  tests/certificates/reject-1 \
  tests/certificates/lies \
  tests/verify/schemes

# The kept inputs of the fuzz targets, without libFuzzer.
FUZZ_TESTS = \
  tests/fuzz/t-fuzz-scheme \
  tests/fuzz/t-fuzz-certificate \
  tests/fuzz/t-fuzz-formula \
  tests/fuzz/t-fuzz-valences
FUZZ_CHECKER_TESTS = \
  tests/fuzz/t-fuzz-check-scheme \
  tests/fuzz/t-fuzz-check-certificate \
  tests/fuzz/t-fuzz-check-arguments

ALL_GENERIC_TESTS = $(GENERIC_TESTS:=-interval) $(GENERIC_TESTS:=-ball) $(GENERIC_TESTS:=-grid)

ALL_FUZZ_TESTS = $(FUZZ_TESTS) $(FUZZ_CHECKER_TESTS)

ALL_TESTS = $(BIGFLOAT_TESTS) $(ORACLE_TESTS) $(LIB_TESTS) $(ALL_GENERIC_TESTS) $(VERIFY_TESTS) \
  $(CERTIFICATE_TESTS) $(CHECK_TESTS) $(ALL_FUZZ_TESTS) $(SCRIPT_TESTS)

# What faults do: a library that is preloaded, where that can be, and what a disk may hold after a crash.
check_PROGRAMS += tests/faults/crash
tests_faults_crash_LDADD =
PRELOADED = tests/faults/preload.so
EXTRA_DIST += tests/faults/preload.c tests/faults/common.sh
CLEANFILES += $(PRELOADED)
$(PRELOADED): tests/faults/preload.c
	$(AM_V_CCLD)$(MKDIR_P) $(@D) && { $(CC) -std=gnu11 -O1 -shared -fPIC -o $@ $< -ldl -lpthread 2>/dev/null || : >$@; }

check_PROGRAMS += $(BIGFLOAT_TESTS) $(ORACLE_TESTS) $(LIB_TESTS) $(VERIFY_TESTS) $(CERTIFICATE_TESTS) \
  $(CHECK_TESTS)
EXTRA_DIST += tests/run-tests $(GENERIC_TESTS:=.c) $(TEST_COMMON) $(SCRIPT_TESTS)
CLEANFILES += $(ALL_GENERIC_TESTS)

# What tests share.
EXTRA_LIBRARIES = libharness.a
CLEANFILES += libharness.a
libharness_a_SOURCES = \
  tests/harness.h tests/harness.c \
  tests/bigfloat/random.h tests/bigfloat/random.c

TEST_COMMON = tests/lib/common.h tests/lib/region.h tests/lib/matrix.h tests/lib/discs.h tests/verify/common.h

# The source of tests/bigfloat/t-x is tests/bigfloat/t-x.c, and it links with this unless told otherwise.
LDADD = libharness.a $(BIGFLOAT_LIBS)
LINK_ORACLE = libharness.a $(BIGFLOAT_LIBS) $(ORACLE_LIBS) $(SMOOTHCERT_LIBS)
LINK_LIB = libharness.a $(LIB_LIBS)
LINK_VERIFY = libharness.a $(VERIFY_LIBS)

# A change of a header of ours shows as a change of its library.
GENERIC_TEST_NEEDS = $(TEST_COMMON) libharness.a libbigfloat.a libscheme.a libverify.a $(GENERIC_LIBS)
BUILD_GENERIC_TEST = $(AM_V_CCLD)$(MKDIR_P) $(@D) && $(CC) $(DEFS) $(AM_CPPFLAGS) $(CPPFLAGS) \
  $(AM_CFLAGS) $(CFLAGS) $(LDFLAGS) -o $@ $<
tests/lib/%: LINK_GENERIC_TEST = $(LINK_LIB)
tests/verify/%: LINK_GENERIC_TEST = $(LINK_VERIFY)
tests/%-interval: tests/%.c $(GENERIC_TEST_NEEDS)
	$(BUILD_GENERIC_TEST) -DNUMBER_INTERVAL $(LINK_GENERIC_TEST)
tests/%-ball: tests/%.c $(GENERIC_TEST_NEEDS)
	$(BUILD_GENERIC_TEST) -DNUMBER_BALL $(LINK_GENERIC_TEST)
tests/%-grid: tests/%.c $(GENERIC_TEST_NEEDS)
	$(BUILD_GENERIC_TEST) -DNUMBER_GRID $(LINK_GENERIC_TEST)

# make check TESTS="ball lib" runs only those whose name or folder is named. TESTS itself is not set
# here, for automake would then run them its own way.
RUN_TESTS = SRCDIR=$(srcdir) BUILDDIR=. $(SHELL) $(srcdir)/tests/run-tests --only "$(TESTS)" $(ALL_TESTS)

check-local: $(ALL_GENERIC_TESTS) $(ALL_FUZZ_TESTS) $(PRELOADED)
	@$(RUN_TESTS)

# Build what `make check` needs and run nothing.
.PHONY: check-programs check-long
check-programs: all
	@$(MAKE) $(AM_MAKEFLAGS) $(check_PROGRAMS) $(ALL_GENERIC_TESTS) $(ALL_FUZZ_TESTS)
	@$(MAKE) $(AM_MAKEFLAGS) $(check_PROGRAMS) $(ALL_GENERIC_TESTS) $(PRELOADED)

# Random tests for longer: each test draws until its time is up.
SECONDS_PER_TEST = 60
check-long: check-programs
	@SECONDS_PER_TEST=$(SECONDS_PER_TEST) TEST_TIMEOUT=0 $(RUN_TESTS)

# All faults: every allocation fails in turn, and many more kills. Some minutes.
.PHONY: check-faults
check-faults: check-programs
	@FAULTS_KILLS=1000 FAULTS_SEED=$$$$ FAULTS_MALLOCS=1 FAULTS_EVERY=3 TEST_TIMEOUT=0 SRCDIR=$(srcdir) BUILDDIR=. \
	  $(SHELL) $(srcdir)/tests/run-tests --only faults $(ALL_TESTS)

# Does every rounding constant of bigfloat/ matter to some test? Some minutes.
MUTATIONS = tests/bigfloat/mutations tests/bigfloat/mutations-directed
EXTRA_DIST += tests/bigfloat/mutate-constants $(MUTATIONS)
.PHONY: mutate-constants
mutate-constants:
	@CC='$(CC)' CFLAGS=-O1 ORACLES='-DHAVE_CONFIG_H -I$(abs_builddir) $(ORACLE_LIBS)' \
	  $(SHELL) $(srcdir)/tests/bigfloat/mutate-constants $(srcdir)

# MUTANTS thousand random mutants of certificates, with the checker built for it with sanitizers (SANITIZE; empty: without
# them, some times as fast); SMOOTHCERT_SEED chooses others, MUTATE="winding tie" those with such words in their names.
# Before that, of the same certificates, each number by itself (tests/certificates/numbers.h).
MUTANTS = 100
MUTATE =
SANITIZE = -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all
.PHONY: mutate
mutate: all tests/certificates/t-mutate tests/certificates/t-numbers
	@$(MKDIR_P) mutate
	@$(CC) $(SANITIZE) -o mutate/smoothcert-check $(srcdir)/verify/check/*.c
	@cd mutate && SRCDIR=$(abs_srcdir) && SMOOTHCERT_CHECK=$(abs_builddir)/mutate/smoothcert-check && \
	  SMOOTHCERT_SEED=$${SMOOTHCERT_SEED:-$$(date +%s)} && export SRCDIR SMOOTHCERT_CHECK SMOOTHCERT_SEED && \
	  $(abs_builddir)/tests/certificates/t-numbers --all $(MUTATE) && \
	  SMOOTHCERT_ROUNDS=$(MUTANTS) $(abs_builddir)/tests/certificates/t-mutate $(MUTATE)

# Does the corpus notice when a check of the checker is left out?  DISABLE="FILE:LINE ..." tries only these.
EXTRA_DIST += tests/check/disable-checks tests/check/disable-checks.edits tests/check/disable-checks.survivors \
  tests/check/left-out.awk tests/check/left-out.c tests/check/left-out.h \
  tests/check/reading tests/check/passed.awk tests/check/declared.awk
.PHONY: disable-checks
disable-checks: all
	@CC='$(CC)' SRCDIR=$(abs_srcdir) BUILDDIR=$(abs_builddir) \
	  $(SHELL) $(srcdir)/tests/check/disable-checks $(DISABLE)

# Fuzz targets: tests/fuzz/fuzz.h.  Those of the checker see it with other names for exit and fopen, and with memory
# that sanitizers can watch (tests/fuzz/checker.c).
FUZZ_FILES = tests/fuzz/fuzz.h tests/fuzz/result.c tests/fuzz/replay.c
FUZZ_CHECKER_FILES = tests/fuzz/checker.h tests/fuzz/checker.c
FUZZ_RENAMED = -Dexit=checker_exit -Dfopen=checker_fopen
FUZZ_CC = $(CC) $(AM_CFLAGS) $(CFLAGS) -I$(srcdir) -D_POSIX_C_SOURCE=200809L
EXTRA_DIST += tests/fuzz/fuzz.sh tests/fuzz/inputs $(FUZZ_FILES) $(FUZZ_CHECKER_FILES) \
  $(ALL_FUZZ_TESTS:tests/fuzz/t-fuzz-%=tests/fuzz/%.c)
CLEANFILES += $(ALL_FUZZ_TESTS) $(FUZZ_CHECKER_TESTS:=.o) tests/fuzz/checker.a

$(FUZZ_TESTS): tests/fuzz/t-fuzz-%: tests/fuzz/%.c $(FUZZ_FILES) libverify.a libscheme.a libbigfloat.a
	$(AM_V_CCLD)$(MKDIR_P) $(@D) && $(FUZZ_CC) -I$(top_builddir) -o $@ $< $(srcdir)/tests/fuzz/result.c $(srcdir)/tests/fuzz/replay.c $(VERIFY_LIBS)

tests/fuzz/checker.a: $(FUZZ_CHECKER_FILES) $(CHECK_SOURCES)
	$(AM_V_AR)rm -rf tests/fuzz/checker $@ && $(MKDIR_P) tests/fuzz/checker
	@for file in $(filter-out %/main.c %/scratch.c,$(filter verify/check/%.c $(srcdir)/verify/check/%.c,$^)); do \
	  $(FUZZ_CC) $(FUZZ_RENAMED) -c -o tests/fuzz/checker/$$(basename $$file .c).o $$file || exit 1; \
	done
	@$(FUZZ_CC) -c -o tests/fuzz/checker/memory.o $(srcdir)/tests/fuzz/checker.c
	@$(AR) cr $@ tests/fuzz/checker/*.o

$(FUZZ_CHECKER_TESTS): tests/fuzz/t-fuzz-%: tests/fuzz/%.c $(FUZZ_FILES) tests/fuzz/checker.a
	$(AM_V_CCLD)$(FUZZ_CC) $(FUZZ_RENAMED) -c -o $@.o $<
	@$(FUZZ_CC) -o $@ $@.o $(srcdir)/tests/fuzz/result.c $(srcdir)/tests/fuzz/replay.c tests/fuzz/checker.a

# Each parser for so many seconds with libFuzzer (clang).
SECONDS = 60
.PHONY: fuzz
fuzz:
	@$(SHELL) $(srcdir)/tests/fuzz/fuzz.sh $(srcdir) $(SECONDS) $(FUZZ_TARGETS)

clean-local:
	rm -rf mutate fuzz disable-checks tests/fuzz/checker
