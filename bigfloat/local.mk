# bigfloat: numbers, from limbs to text. Uses libc and libm only.

BIGFLOAT_SOURCES = \
  bigfloat/truth.h \
  \
  bigfloat/limb.h bigfloat/limb_row.h \
  bigfloat/limb.c \
  bigfloat/limb_mul.c \
  bigfloat/limb_div.c \
  bigfloat/limb_sqrt.c \
  \
  bigfloat/integer.h bigfloat/integer_internal.h \
  bigfloat/integer.c \
  bigfloat/integer_mul.c \
  bigfloat/integer_div.c \
  bigfloat/integer_text.c \
  \
  bigfloat/rational.h \
  bigfloat/rational.c \
  bigfloat/rational_text.c \
  \
  bigfloat/number_common.h bigfloat/number_array.h \
  bigfloat/cosines.h bigfloat/cosines.c \
  \
  bigfloat/ball.h bigfloat/ball_internal.h bigfloat/ball_fixed.h \
  bigfloat/ball.c \
  bigfloat/ball_add.c \
  bigfloat/ball_mul.c \
  bigfloat/ball_dot_even.c \
  bigfloat/ball_dot.c \
  bigfloat/ball_div.c \
  bigfloat/ball_compare.c \
  bigfloat/ball_sets.c \
  bigfloat/ball_convert.c \
  bigfloat/fraction.h \
  bigfloat/fraction.c \
  bigfloat/fraction_pi_series.c bigfloat/fraction_pi.c \
  bigfloat/fraction_series.c \
  bigfloat/fraction_cos.c \
  bigfloat/fraction_angle.c \
  bigfloat/fraction_atan.c \
  bigfloat/ball_pi.c \
  bigfloat/ball_atan.c \
  bigfloat/ball_trig.c \
  bigfloat/trig_pi.h bigfloat/trig_pi.c \
  bigfloat/ball_text.c \
  \
  bigfloat/complex_ball.h \
  bigfloat/complex_ball.c \
  \
  bigfloat/interval.h \
  bigfloat/interval.c \
  bigfloat/interval_batch.h \
  bigfloat/interval_batch.c \
  bigfloat/interval_self_test.c \
  \
  bigfloat/grid.h bigfloat/grid_internal.h \
  bigfloat/grid.c \
  bigfloat/grid_mul.c \
  bigfloat/grid_div.c \
  bigfloat/grid_trig.c \
  bigfloat/grid_compare.c \
  bigfloat/grid_text.c \
  \
  bigfloat/number.h bigfloat/jet.h bigfloat/number_jet.h bigfloat/affine.h bigfloat/number_affine.h

EXTRA_DIST += bigfloat/errors.md bigfloat/errors-trig.md

lib_LIBRARIES += libbigfloat.a
libbigfloat_a_SOURCES = $(BIGFLOAT_SOURCES)

# What a program outside needs of it: <bigfloat/ball.h> and its like, and the flags to compile with.
nobase_include_HEADERS = \
  bigfloat/truth.h \
  bigfloat/integer.h bigfloat/rational.h \
  bigfloat/number_common.h bigfloat/number_array.h \
  bigfloat/ball.h bigfloat/complex_ball.h \
  bigfloat/interval.h bigfloat/interval_batch.h \
  bigfloat/grid.h \
  bigfloat/number.h bigfloat/jet.h bigfloat/number_jet.h
pkgconfigdir = $(libdir)/pkgconfig
pkgconfig_DATA = bigfloat/bigfloat.pc
examplesdir = $(docdir)/examples
dist_examples_DATA = bigfloat/example.c
