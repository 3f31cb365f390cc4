# verify: tests, escalation, certificates, archive, reports; the program. Uses lib and bigfloat.

VERIFY_SOURCES = \
  verify/outcome.h verify/outcome.c \
  verify/deadline.h verify/deadline.c \
  verify/buffer.h verify/buffer.c \
  verify/sha256.h verify/sha256.c \
  verify/tree.h verify/tree.c \
  verify/exact_choice.h verify/exact_choice.c \
  verify/choices.h verify/choices.c \
  verify/problem.h verify/problem.c \
  verify/certificate_exact.h verify/certificate_exact.c \
  verify/certificate.h verify/certificate.c \
  verify/uniform_bounds.h verify/uniform_bounds.c \
  verify/findings.h verify/findings.c \
  verify/analysis.h \
  verify/exact_search.h verify/exact_search.c \
  verify/refute.h verify/refute.c \
  verify/escalate.h verify/escalate.c \
  verify/prove_output.h verify/prove_output.c \
  verify/archive.h verify/archive_internal.h verify/archive.c verify/archive_index.c \
  verify/valences.h verify/valences.c \
  verify/workers.h verify/workers.c \
  verify/progress.h verify/progress.c \
  verify/spectrum_list.h verify/spectrum_list.c \
  verify/other_criteria.h verify/other_criteria.c \
  verify/consistency.h verify/consistency.c \
  verify/spectrum_doubles.h verify/spectrum_doubles.c

# Compiled for every kind of number.
VERIFY_GENERIC_SOURCES = \
  verify/adaptive.h verify/adaptive.c \
  verify/uniform_net.h verify/uniform_net.c \
  verify/tests.h verify/uniform.h \
  verify/regular_complex_test.c \
  verify/eigenpair_test.c \
  verify/spectrum_test.c \
  verify/regularity_test.c \
  verify/injectivity_test.c \
  verify/zero_free_test.c \
  verify/fold_test.c \
  verify/real_test.c \
  verify/exact_test.h verify/exact_test.c \
  verify/exact_eigenvector.c \
  verify/block_matrix.h verify/block_matrix.c \
  verify/candidates.h verify/candidates.c \
  verify/gap.h verify/gap.c \
  verify/other_criteria_numbers.h verify/other_criteria_numbers.c \
  verify/uniform_regularity_test.c \
  verify/uniform_isolation_test.c \
  verify/uniform_injectivity_test.c \
  verify/uniform.c \
  verify/spectrum_blocks.h verify/spectrum_blocks.c \
  verify/spectrum_survey.c \
  verify/analysis.c

# Compiled for affine numbers of every kind, too.
VERIFY_AFFINE_SOURCES = \
  verify/adaptive.h verify/adaptive.c \
  verify/tests.h \
  verify/regularity_test.c \
  verify/injectivity_test.c \
  verify/zero_free_test.c

GENERIC_SOURCES += $(VERIFY_GENERIC_SOURCES)
AFFINE_SOURCES += $(VERIFY_AFFINE_SOURCES)

noinst_LIBRARIES += libverify.a
libverify_a_SOURCES = $(VERIFY_SOURCES)

bin_PROGRAMS += smoothcert
smoothcert_SOURCES = \
  verify/command.h \
  verify/command_scheme.h verify/command_scheme.c \
  verify/command_prove.c \
  verify/command_spectrum.c \
  verify/command_regular.c \
  verify/command_schemes.c \
  verify/main.c
smoothcert_LDADD = $(VERIFY_LIBS)

EXTRA_DIST += verify/certificate.md verify/certificate-0.md verify/certificate-valences.md verify/exact.md verify/uniform.md verify/scheme-0.md
