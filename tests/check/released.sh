#!/bin/sh
# No number is used after its memory has been given back.  The checker is built with every number, however short, in
# memory of its own (SHORT_LIMBS 0; tests/fuzz/checker.c, where each allocation is one of malloc's and a release frees
# it), with the address sanitizer, and is given the good certificates: accept-1/ and ranges/.
set -u
LC_ALL=C
export LC_ALL
certificates=$SRCDIR/tests/certificates

cc=${GCC:-gcc}
sanitize='-fsanitize=address,undefined -fno-sanitize-recover=all'
echo 'int main(void) { return 0; }' >try.c
# shellcheck disable=SC2086  # two flags
if ! $cc $sanitize -o try try.c 2>/dev/null; then
  echo 'SKIP released: there is no address sanitizer'
  exit 0
fi
ASAN_OPTIONS=detect_leaks=0
export ASAN_OPTIONS

mkdir source
cp "$SRCDIR"/verify/check/*.[ch] source
rm source/scratch.c
sed -i -e 's/SHORT_LIMBS = 2/SHORT_LIMBS = 0/' -e 's/here\[SHORT_LIMBS\]/here[2]/' source/integer.h
grep -q 'SHORT_LIMBS = 0' source/integer.h && grep -q 'here\[2\]' source/integer.h || { echo 'FAIL released: integer.h has changed' && exit 1; }
for file in source/*.c "$SRCDIR/tests/fuzz/checker.c"; do
  echo "$file"
# shellcheck disable=SC2086
done | xargs -n 8 -P 2 $cc $sanitize -O1 -g -w -I"$SRCDIR" -c || { echo 'FAIL released: it does not compile' && exit 1; }
# shellcheck disable=SC2086
$cc $sanitize -o checker ./*.o || { echo 'FAIL released: it does not link' && exit 1; }

# The scheme of this name, or (-) the one that stands in the certificate.
scheme_file() { # NAME CERTIFICATE
  if [ "$1" = - ]; then
    sed -n '3,/^claim /p' "$2" | sed '/^claim /d' >own.scheme
    echo own.scheme
  elif [ -f "$SRCDIR/lib/catalogue/$1.scheme" ]; then
    echo "$SRCDIR/lib/catalogue/$1.scheme"
  elif [ -f "$certificates/schemes/$1.scheme" ]; then
    echo "$certificates/schemes/$1.scheme"
  else
    echo "$SRCDIR/tests/verify/schemes/$1.scheme"
  fi
}

# The options that are part of the claim.
settings() { # OPTION...
  while [ $# -gt 0 ]; do
    if [ "$1" = --set ]; then printf '%s %s ' "$1" "$2"; fi
    shift 2
  done
}

verify() { # CLAIM FOLDER NAME SCHEME VALENCES [OPTION...]
  claim=$1 certificate=$2/$3.cert name=$3 scheme=$(scheme_file "$4" "$2/$3.cert") valences=$5
  shift 5
  # shellcheck disable=SC2046  # words
  if ./checker --scheme "$scheme" $(settings "$@") --valence "$valences" --claim "$claim" "$certificate" >stdout 2>stderr; then
    echo "PASS released/$name"
  else
    echo "FAIL released/$name: $(grep -m 1 -e ERROR -e 'runtime error' -e '^rejected' -e '^cannot' stderr)"
  fi
}

all() { # CLAIM FOLDER TABLE
  while read -r line; do
    case $line in '' | '#'*) continue ;; esac
    # shellcheck disable=SC2086  # words of the table
    verify "$1" "$2" $line
  done <"$2/$3"
}

{
  all c1 "$certificates/accept-1" table
  all not-c1 "$certificates/accept-1" refuted
  all c1 "$SRCDIR/tests/check/ranges" table
  all not-c1 "$SRCDIR/tests/check/ranges" refuted
} >results
cat results
! grep -q '^FAIL' results
