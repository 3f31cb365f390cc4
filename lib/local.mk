# lib: schemes, formulas, Laurent polynomials, sector nets, spectra, characteristic nets. Uses bigfloat.

LIB_SOURCES = \
  lib/diagnostic.h lib/diagnostic.c \
  lib/lattice.h \
  lib/laurent.h lib/laurent.c \
  lib/regular.h lib/regular.c \
  lib/exact_value.h lib/exact_value.c \
  lib/formula.h lib/formula.c \
  lib/text.h lib/text.c \
  lib/scheme.h lib/scheme.c \
  lib/catalogue.h \
  lib/element.h lib/element.c \
  lib/ring.h lib/ring.c \
  lib/eigen_approx.h lib/eigen_approx.c \
  lib/eigenpair_choice.h lib/eigenpair_choice.c

# Compiled for every kind of number.
LIB_GENERIC_SOURCES = \
  lib/formula_value.h lib/formula_value.c \
  lib/sector.h lib/sector.c \
  lib/block.h lib/block.c \
  lib/spectrum.h lib/spectrum.c \
  lib/eigenpair.h lib/eigenpair.c \
  lib/charnet.h lib/charnet.c

# One file for each scheme. They are part of the program and are installed as examples, too.
CATALOGUE = \
  lib/catalogue/loop.scheme

GENERIC_SOURCES += $(LIB_GENERIC_SOURCES)

noinst_LIBRARIES += libscheme.a
libscheme_a_SOURCES = $(LIB_SOURCES)
nodist_libscheme_a_SOURCES = lib/catalogue.c

schemesdir = $(pkgdatadir)/schemes
dist_schemes_DATA = $(CATALOGUE)

lib/catalogue.c: $(CATALOGUE) lib/embed-catalogue lib/local.mk
	$(AM_V_GEN)$(MKDIR_P) lib && \
	(cd $(srcdir) && $(SHELL) lib/embed-catalogue $(CATALOGUE)) >$@.tmp && mv $@.tmp $@

EXTRA_DIST += lib/scheme.md lib/embed-catalogue
CLEANFILES += lib/catalogue.c lib/catalogue.c.tmp
