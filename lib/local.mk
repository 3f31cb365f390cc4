# lib: schemes, formulas, Laurent polynomials, sector nets, spectra, characteristic nets. Uses bigfloat.

LIB_SOURCES = \
  lib/diagnostic.h lib/diagnostic.c \
  lib/growing.h \
  lib/stop.h lib/stop.c \
  lib/stride.h \
  lib/lattice.h \
  lib/laurent.h lib/laurent.c \
  lib/exact_value.h lib/exact_value.c \
  lib/formula.h lib/formula.c lib/formula_form.c lib/formula_read.c \
  lib/exact_range.h lib/exact_range.c \
  lib/text.h lib/text.c \
  lib/mesh.h lib/mesh.c \
  lib/power.h lib/power.c \
  lib/regular.h lib/regular.c \
  lib/comparison.h lib/comparison.c \
  lib/decomposition.h lib/decomposition.c \
  lib/stability.h lib/stability.c \
  lib/regular_refutation.h lib/regular_refutation.c \
  lib/number_field.h lib/number_field.c \
  lib/field_polynomial.h lib/field_polynomial.c \
  lib/field_matrix.h lib/field_matrix.c \
  lib/scheme.h lib/scheme.c \
  lib/scheme_reader.h lib/scheme_lines.c lib/scheme_definitions.c lib/scheme_mask.c lib/scheme_rule.c lib/scheme_symmetry.c \
  lib/scheme_compose.c lib/scheme_text.c lib/scheme_read.c \
  lib/scheme_range.h lib/scheme_range.c \
  lib/laurent_value.h lib/laurent_value.c \
  lib/centre_weights.h lib/centre_weights.c \
  lib/resting_centre.h lib/resting_centre.c \
  lib/graded_scheme.h lib/graded_scheme.c \
  lib/arc.h lib/arc.c \
  lib/catalogue.h \
  lib/element.h lib/element.c \
  lib/bernstein.h lib/bernstein.c \
  lib/influence.h lib/influence.c \
  lib/ring.h lib/ring.c \
  lib/eigen_approx.h lib/eigen_approx.c \
  lib/schur_approx.h lib/schur_approx.c \
  lib/components.h lib/components.c \
  lib/eigenpair_choice.h lib/eigenpair_choice.c \
  lib/cover_list.h lib/cover_list.c \
  lib/monotone_list.h lib/monotone_list.c \
  lib/range_choices.h lib/range_choices.c \
  lib/graded_choice.h lib/graded_choice.c

# Compiled for every kind of number.
LIB_GENERIC_SOURCES = \
  lib/matrix_row.h \
  lib/formula_value.h lib/formula_value.c \
  lib/formula_range.h lib/formula_range.c \
  lib/sector.h lib/sector.c \
  lib/step.h lib/step.c \
  lib/subdivision.h lib/subdivision.c \
  lib/block.h lib/block.c \
  lib/spectrum.h lib/spectrum.c \
  lib/cover.h lib/cover.c \
  lib/complex_matrix.h lib/complex_matrix.c \
  lib/eigenbasis.h lib/eigenbasis.c \
  lib/eigenvalues.h lib/eigenvalues.c \
  lib/eigenpair.h lib/eigenpair.c \
  lib/eigenpair_slope.h lib/eigenpair_slope.c \
  lib/eigenpair_affine.h lib/eigenpair_affine.c \
  lib/monotone.h lib/monotone.c \
  lib/rise.h lib/rise.c \
  lib/span.h lib/span.c \
  lib/separation.h lib/separation.c \
  lib/limit.h lib/limit.c \
  lib/charnet.h lib/charnet.c \
  lib/patch.h lib/patch.c \
  lib/patch_product.h lib/patch_product.c

# Compiled for jets of every kind of number, too.
LIB_JET_SOURCES = \
  lib/formula_range.h \
  lib/sector.h lib/sector.c \
  lib/step.h lib/step.c \
  lib/subdivision.h lib/subdivision.c \
  lib/block.h lib/block.c \
  lib/block_slope.h lib/block_slope.c

# Compiled for affine numbers of every kind, too.
LIB_AFFINE_SOURCES = \
  lib/formula_range.h \
  lib/sector.h lib/sector.c \
  lib/step.h lib/step.c \
  lib/subdivision.h lib/subdivision.c \
  lib/block.h lib/block.c \
  lib/reciprocal.h lib/reciprocal.c \
  lib/block_affine.h lib/block_affine.c \
  lib/charnet.h lib/charnet.c \
  lib/graded_net.h lib/graded_net.c \
  lib/graded.h lib/graded.c lib/graded_sector.c \
  lib/patch.h lib/patch.c \
  lib/patch_product.h lib/patch_product.c
# Compiled for exact numbers of a field of cosines, too.
LIB_COSINES_SOURCES = \
  lib/formula_value.h lib/formula_value.c \
  lib/formula_range.h lib/formula_range.c \
  lib/sector.h lib/sector.c \
  lib/step.h lib/step.c \
  lib/subdivision.h lib/subdivision.c \
  lib/block.h lib/block.c \
  lib/exact_block.h lib/exact_block.c

# One file for each scheme. They are part of the program and are installed as examples, too.
CATALOGUE = \
  lib/catalogue/loop.scheme \
  lib/catalogue/loop-warren.scheme \
  lib/catalogue/modified-loop.scheme \
  lib/catalogue/loop-ring.scheme \
  lib/catalogue/loop-spiral.scheme \
  lib/catalogue/butterfly.scheme \
  lib/catalogue/modified-butterfly.scheme \
  lib/catalogue/catmull-clark.scheme \
  lib/catalogue/catmull-clark-weights.scheme \
  lib/catalogue/doo-sabin.scheme \
  lib/catalogue/doo-sabin-spectrum.scheme \
  lib/catalogue/midpoint.scheme \
  lib/catalogue/wave.scheme \
  lib/catalogue/wave-valence.scheme \
  lib/catalogue/kobbelt.scheme

GENERIC_SOURCES += $(LIB_GENERIC_SOURCES)
JET_SOURCES += $(LIB_JET_SOURCES)
AFFINE_SOURCES += $(LIB_AFFINE_SOURCES)
COSINES_SOURCES += $(LIB_COSINES_SOURCES)

noinst_LIBRARIES += libscheme.a
libscheme_a_SOURCES = $(LIB_SOURCES)
nodist_libscheme_a_SOURCES = lib/catalogue.c

schemesdir = $(pkgdatadir)/schemes
dist_schemes_DATA = $(CATALOGUE)

lib/catalogue.c: $(CATALOGUE) lib/embed-catalogue lib/local.mk
	$(AM_V_GEN)$(MKDIR_P) lib && \
	(cd $(srcdir) && $(SHELL) lib/embed-catalogue $(CATALOGUE)) >$@.tmp && mv $@.tmp $@

EXTRA_DIST += lib/scheme.md lib/stability.md lib/ring.md lib/regular_refutation.md lib/eigenvalues.md lib/embed-catalogue
CLEANFILES += lib/catalogue.c lib/catalogue.c.tmp
