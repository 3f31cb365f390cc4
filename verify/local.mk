# verify: tests, escalation, certificates, archive, reports; the program. Uses lib and bigfloat.

VERIFY_SOURCES = \
  verify/outcome.h verify/outcome.c \
  verify/deadline.h verify/deadline.c \
  verify/buffer.h verify/buffer.c \
  verify/sha256.h verify/sha256.c \
  verify/tree.h verify/tree.c \
  verify/valence_range.h verify/valence_range.c \
  verify/exact_choice.h verify/exact_choice.c \
  verify/window_choice.h verify/window_choice.c \
  verify/choices.h verify/choices.c \
  verify/picture.h verify/picture.c \
  verify/problem.h verify/problem.c \
  verify/certificate_exact.h verify/certificate_exact.c \
  verify/certificate.h verify/certificate.c verify/certificate_read.c \
  verify/uniform_bounds.h verify/uniform_bounds.c \
  verify/findings.h verify/findings.c \
  verify/analysis.h \
  verify/exact_search.h verify/exact_search.c \
  verify/refute.h verify/refute.c \
  verify/refute_range.h verify/refute_range.c \
  verify/escalate.h verify/escalate.c \
  verify/partition.h verify/partition.c \
  verify/classification.h verify/classification.c \
  verify/json.h verify/json.c \
  verify/advice.h verify/advice.c \
  verify/prove_output.h verify/prove_output.c \
  verify/statement.h verify/statement.c \
  verify/durable.h verify/durable.c \
  verify/journal.h verify/journal.c \
  verify/archive_run.h verify/archive_run.c \
  verify/archive.h verify/archive_index.h verify/archive.c verify/archive_index.c verify/archive_open.c \
  verify/archive_view.h verify/archive_view.c \
  verify/tar.h verify/tar.c \
  verify/examine.h verify/examine.c \
  verify/rerun_report.h verify/rerun_report.c \
  verify/valence_list.h verify/valence_list.c \
  verify/workers.h verify/workers.c \
  verify/keeper.h verify/keeper.c \
  verify/progress.h verify/progress.c \
  verify/spectrum_list.h verify/spectrum_list.c \
  verify/spectrum_doubles.h verify/spectrum_doubles.c \
  verify/other_criteria.h verify/other_criteria.c \
  verify/consistency.h verify/consistency.c \
  verify/svg.h verify/svg.c \
  verify/plot.h verify/plot.c \
  verify/report.h verify/report_read.c \
  verify/report_map.c verify/report_curve.c verify/report_spectrum.c verify/report_valences.c \
  verify/report_page.c

# Compiled for every kind of number.
VERIFY_GENERIC_SOURCES = \
  verify/adaptive.h verify/adaptive.c \
  verify/uniform_net.h verify/uniform_net.c \
  verify/tests.h verify/uniform.h \
  verify/regular_complex_test.c \
  verify/eigenpair_test.c \
  verify/spectrum_test.c \
  verify/range_spectrum.h verify/range_spectrum.c \
  verify/regularity_test.c \
  verify/injectivity_test.c \
  verify/zero_free_test.c \
  verify/fold_test.c \
  verify/winding_test.c \
  verify/analysis_pair.c \
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
  verify/uniform_range.h verify/uniform_range.c \
  verify/spectrum_blocks.h verify/spectrum_blocks.c \
  verify/spectrum_survey.c \
  verify/picture_take.c \
  verify/analysis_tests.c \
  verify/analysis.c

# Compiled for affine numbers of every kind, too.
VERIFY_AFFINE_SOURCES = \
  verify/adaptive.h verify/adaptive.c \
  verify/tests.h \
  verify/regularity_test.c \
  verify/injectivity_test.c \
  verify/zero_free_test.c \
  verify/fold_test.c \
  verify/regular_complex_test.c \
  verify/analysis_pair.c \
  verify/range_tests.c \
  verify/range_eigenpair_test.c \
  verify/range_spectrum_test.c \
  verify/window_test.c \
  verify/graded_test.c \
  verify/analysis.c

GENERIC_SOURCES += $(VERIFY_GENERIC_SOURCES)
AFFINE_SOURCES += $(VERIFY_AFFINE_SOURCES)

noinst_LIBRARIES += libverify.a
libverify_a_SOURCES = $(VERIFY_SOURCES)

bin_PROGRAMS += smoothcert
smoothcert_SOURCES = \
  verify/command.h \
  verify/command_scheme.h verify/command_scheme.c \
  verify/prove_options.h verify/prove_options.c \
  verify/prove_run.h verify/prove_decide.c verify/prove_keep.c \
  verify/command_prove.c \
  verify/command_spectrum.c \
  verify/command_regular.c \
  verify/command_schemes.c \
  verify/command_certificates.h verify/command_certificates.c \
  verify/command_out.h verify/command_out.c \
  verify/command_show.c \
  verify/command_rerun.c \
  verify/command_archive.h verify/command_archive.c verify/command_archive_verify.c verify/command_archive_diff.c verify/command_archive_pack.c \
  verify/command_report.c \
  verify/main.c
smoothcert_LDADD = $(VERIFY_LIBS)

EXTRA_DIST += verify/certificate.md verify/certificate-0.md verify/certificate-valences.md verify/exact.md verify/uniform.md verify/scheme-0.md
