# verify/check: the independent checker. It shares no file with the rest and sees none (no -I, no
# config.h), and this compiles it, too:  cc -O2 -o smoothcert-check verify/check/*.c

CHECK_SOURCES = \
  verify/check/answer.h verify/check/answer.c \
  verify/check/scratch.h verify/check/scratch.c \
  verify/check/integer.h verify/check/integer.c \
  verify/check/span.h \
  verify/check/rational.h verify/check/rational.c \
  verify/check/grid.h verify/check/grid.c \
  verify/check/trig.c \
  verify/check/affine.h verify/check/affine.c \
  verify/check/sha256.h verify/check/sha256.c \
  verify/check/text.h verify/check/text.c \
  verify/check/formula.h verify/check/formula.c \
  verify/check/value.h verify/check/value.c \
  verify/check/evaluate.c \
  verify/check/mask.h verify/check/mask.c \
  verify/check/symmetry.c \
  verify/check/scheme.h verify/check/scheme.c \
  verify/check/field.h verify/check/field.c \
  verify/check/certificate.h verify/check/certificate.c \
  verify/check/regular.h verify/check/regular.c \
  verify/check/stability.c \
  verify/check/valence.h verify/check/valence.c \
  verify/check/sector.h verify/check/sector.c \
  verify/check/eigenpair.h verify/check/eigenpair.c \
  verify/check/spectrum.h verify/check/spectrum.c \
  verify/check/laurent.h verify/check/laurent.c \
  verify/check/limit.c \
  verify/check/valences.h verify/check/valences.c \
  verify/check/element.h verify/check/element.c \
  verify/check/spline.h verify/check/spline.c \
  verify/check/influence.c \
  verify/check/characteristic.h verify/check/characteristic.c \
  verify/check/decide.c \
  verify/check/window.c \
  verify/check/graded.h verify/check/graded_net.c \
  verify/check/graded.c \
  verify/check/exact_formula.h verify/check/exact_formula.c \
  verify/check/exact_block.c \
  verify/check/polynomial.h verify/check/polynomial.c \
  verify/check/ties.h verify/check/ties.c \
  verify/check/check.h verify/check/check.c \
  verify/check/claim.h verify/check/claim.c \
  verify/check/main.c

bin_PROGRAMS += smoothcert-check
smoothcert_check_SOURCES = $(CHECK_SOURCES)
smoothcert_check_CPPFLAGS =
smoothcert_check_LDADD =
EXTRA_DIST += verify/check/README
