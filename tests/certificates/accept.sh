#!/bin/sh
# accept/: the checker verifies what the prover wrote, with its claim and no other; the prover writes the same bytes
# again; and what proves as much in other words is accepted, too.
#
# Where the prover has become better, its certificates change: BLESS=yes puts the new ones in accept/, to be looked at.
set -u
here=$SRCDIR/tests/certificates

scheme_file() { # NAME
  if [ "$1" = loop ]; then echo "$SRCDIR/lib/catalogue/loop.scheme"; else echo "$here/schemes/$1.scheme"; fi
}

check() { # NAME SCHEME VALENCE
  "$SMOOTHCERT_CHECK" --scheme "$(scheme_file "$2")" --valence "$3" --claim c1 "$here/accept/$1.cert" >stdout 2>stderr
  status=$?
  case $status:$(cat stdout) in
    "0:verified: $2 is C1 at valence $3 ("*) echo "PASS accept-$1" ;;
    *) echo "FAIL accept-$1: exit status $status: $(cat stdout stderr | head -n 1)" ;;
  esac
}

refuse() { # NAME SCHEME VALENCE CLAIM STATUS MESSAGE
  "$SMOOTHCERT_CHECK" --scheme "$(scheme_file "$2")" --valence "$3" --claim "$4" "$here/accept/$1.cert" >stdout 2>stderr
  status=$?
  case $status:$(cat stdout)$(cat stderr) in
    "$5:"*"$6"*) echo "PASS accept-$1-not-for-$2-$3-$4" ;;
    *) echo "FAIL accept-$1-not-for-$2-$3-$4: exit status $status: $(cat stdout stderr | head -n 1)" ;;
  esac
}

reproduce() { # NAME SCHEME VALENCE [OPTION...]
  name=$1 valence=$3
  file=$(scheme_file "$2")
  shift 3
  if ! "$SMOOTHCERT" prove "$file" --valence "$valence" "$@" --out "$name" >stdout 2>stderr; then
    echo "FAIL reproduce-$name: $(cat stdout stderr | head -n 1)"
  elif cmp "$name/valence-$valence.cert" "$here/accept/$name.cert" >stdout 2>&1; then
    echo "PASS reproduce-$name"
  elif [ -n "${BLESS:-}" ]; then
    cp "$name/valence-$valence.cert" "$here/accept/$name.cert" && echo "SKIP reproduce-$name: new bytes, accepted without a test"
  else
    echo "FAIL reproduce-$name: $(head -n 1 stdout)"
  fi
}

each() { # TABLE COMMAND...
  table=$1
  shift
  while read -r line; do
    case $line in '' | '#'*) continue ;; esac
    # shellcheck disable=SC2086  # words of the table
    "$@" $line
  done <"$here/accept/$table"
}

{
  each table check
  each harmless check
  each table reproduce
  refuse loop-4 loop 3 c1 1 'valence: expected 3'
  refuse loop-4 loop 40 c1 1 'valence: expected 40'
  refuse loop-4 wide 4 c1 1 'scheme: expected the text of the given scheme'
  refuse loop-4 loop 4 not-c1 2 'cannot check: --claim: not-c1 is not in version 1'
  sed -e '/^#/d' -e 's/ .*//' "$here/accept/table" "$here/accept/harmless" | LC_ALL=C sort >in-table
  (cd "$here/accept" && ls -- *.cert) | sed 's/\.cert$//' | LC_ALL=C sort >on-disk
  if cmp -s in-table on-disk; then
    echo "PASS accept-table"
  else
    echo "FAIL accept-table: names that are not both in a table and a file: $(comm -3 in-table on-disk | tr -d '\t' | tr '\n' ' ')"
  fi
} >results
cat results
! grep -q '^FAIL' results
