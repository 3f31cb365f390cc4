#!/bin/sh
# The number layer as others get it: installed, found by pkg-config, and used by the example program.  Every header stands
# on its own, and no global symbol has a name that is not the library's.
set -u
LC_ALL=C
export LC_ALL

setting() { # VARIABLE of the Makefile
  sed -n "s/^$1 = //p" "$BUILDDIR/Makefile" | head -n 1
}
compile() { # ARGUMENT...: as the library was compiled
  # shellcheck disable=SC2046  # lists of words
  $(setting CC) $(setting CFLAGS) $(setting LDFLAGS) "$@"
}
holds() { # NAME STATUS FILE-WITH-THE-REASON
  if [ "$2" -eq 0 ]; then echo "PASS installed-$1"; else echo "FAIL installed-$1: $(head -n 1 "$3")"; fi
}

root=$PWD/root
(cd "$BUILDDIR" && unset MAKEFLAGS MFLAGS MAKELEVEL && make install prefix=/usr exec_prefix=/usr DESTDIR="$root") >log 2>&1
holds install $? log

# pkg-config's answer, or where there is none, the lines that it would read.
pc=$root/usr/lib/pkgconfig/bigfloat.pc
ask() { # WHAT
  if command -v pkg-config >/dev/null; then
    PKG_CONFIG_LIBDIR=${pc%/*} PKG_CONFIG_SYSROOT_DIR=$root pkg-config "--$1" \
      --define-variable=includedir=/usr/include --define-variable=libdir=/usr/lib bigfloat
  else
    sed -n "s/^$2: //p" "$pc" | sed "s|[$]{includedir}|$root/usr/include|; s|[$]{libdir}|$root/usr/lib|"
  fi
}
grep -q '^Cflags: .*-frounding-math' "$pc" 2>log
holds pkg-config $? log

# shellcheck disable=SC2046  # lists of words
compile -std=c11 -Wall -Wextra -Werror -o example "$root/usr/share/doc/smoothcert/examples/example.c" $(ask cflags Cflags) $(ask libs Libs) 2>log &&
  ./example >log 2>&1 && grep -q '^ 128 bits: -0.8273960599468213681411651 ' log && grep -qx 'proved: negative' log
holds example $? log

for header in "$root"/usr/include/bigfloat/*.h; do
  name=$(basename "$header")
  before= && case $name in number.h | jet.h | number_jet.h) before='#define NUMBER_BALL' ;; esac
  printf '%s\n#include <bigfloat/%s>\nint alone;\n' "$before" "$name" >alone.c
  # shellcheck disable=SC2046  # lists of words
  compile -std=c11 -Wall -Wextra -Werror -c alone.c $(ask cflags Cflags) 2>log
  holds "$name" $? log
done

if ! command -v nm >/dev/null; then
  echo "SKIP installed-symbols: there is no nm"
else
  families='limb|integer|rational|ball|complex_ball|fraction|trig_pi|interval|grid|cosines'
  nm -g "$root/usr/lib/libbigfloat.a" | awk 'NF == 3 && $2 ~ /^[A-TV-Z]$/ { print $3 }' | sort -u >symbols
  [ "$(wc -l <symbols)" -gt 100 ] && ! grep -Ev "^(__.*|($families)_[a-z0-9_]+)\$" symbols >log
  holds symbols $? log
fi
