#!/bin/sh
# accept/ (version 0) and accept-1/: the checker verifies what the prover wrote, with its claim and no other; the prover writes the same bytes
# again; and what proves as much in other words is accepted, too.
#
# Where the prover has become better, its certificates change: BLESS=yes puts the new ones in accept-1/, to be looked at.
set -u
here=$SRCDIR/tests/certificates

scheme_file() { # NAME
  if [ -f "$SRCDIR/lib/catalogue/$1.scheme" ]; then echo "$SRCDIR/lib/catalogue/$1.scheme"; else echo "$here/schemes/$1.scheme"; fi
}

# The options that are part of the claim.
settings() { # OPTION...
  while [ $# -gt 0 ]; do
    if [ "$1" = --set ]; then printf '%s %s ' "$1" "$2"; fi
    shift 2
  done
}

check() { # CLAIM FOLDER NAME SCHEME VALENCE [OPTION...]
  claim=$1 certificate=$here/$2/$3.cert name=$2-$3 scheme=$4 valence=$5
  shift 5
  # shellcheck disable=SC2046  # words
  "$SMOOTHCERT_CHECK" --scheme "$(scheme_file "$scheme")" $(settings "$@") --valence "$valence" --claim "$claim" "$certificate" >stdout 2>stderr
  status=$?
  case $status:$(cat stdout) in
    "0:verified: $scheme is $(echo "$claim" | sed 's/c1/C1/; s/-/ /') at valence $valence ("*) echo "PASS $name" ;;
    *) echo "FAIL $name: exit status $status: $(cat stdout stderr | head -n 1)" ;;
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
  "$SMOOTHCERT" prove "$file" --valence "$valence" "$@" --out "$name" >stdout 2>stderr
  if [ $? -gt 1 ]; then
    echo "FAIL reproduce-$name: $(cat stdout stderr | head -n 1)"
  elif cmp "$name/valence-$valence.cert" "$here/accept-1/$name.cert" >stdout 2>&1; then
    echo "PASS reproduce-$name"
  elif [ -n "${BLESS:-}" ]; then
    cp "$name/valence-$valence.cert" "$here/accept-1/$name.cert" && echo "SKIP reproduce-$name: new bytes, accepted without a test"
  else
    echo "FAIL reproduce-$name: $(head -n 1 stdout)"
  fi
}

each() { # FOLDER/TABLE COMMAND...
  table=$1
  shift
  while read -r line; do
    case $line in '' | '#'*) continue ;; esac
    # shellcheck disable=SC2086  # words of the table
    "$@" $line
  done <"$here/$table"
}

# Table and files are about the same certificates.
compare() { # FOLDER TABLE...
  folder=$1
  shift
  (cd "$here/$folder" && sed -e '/^#/d' -e 's/ .*//' "$@") | LC_ALL=C sort >in-table
  (cd "$here/$folder" && ls -- *.cert) | sed 's/\.cert$//' | LC_ALL=C sort >on-disk
  if cmp -s in-table on-disk; then
    echo "PASS $folder-table"
  else
    echo "FAIL $folder-table: names that are not both in a table and a file: $(comm -3 in-table on-disk | tr -d '\t' | tr '\n' ' ')"
  fi
}

# Several certificates at once, and settings.
directory() {
  mkdir folder
  for valence in 3 4 12; do cp "$here/accept-1/catmull-clark-$valence.cert" folder/valence-$valence.cert; done
  scheme=$SRCDIR/lib/catalogue/catmull-clark.scheme
  for list in 3..4,12 3,12 4; do
    "$SMOOTHCERT_CHECK" --scheme "$scheme" --valence $list --claim c1 folder >stdout 2>stderr
    status=$?
    case $status:$(tail -n 1 stdout) in
      "0:verified: catmull-clark is C1 at valence ${list##*[,.]} ("*) echo "PASS directory-$list" ;;
      *) echo "FAIL directory-$list: exit status $status: $(cat stdout stderr | head -n 1)" ;;
    esac
  done
  "$SMOOTHCERT_CHECK" --scheme "$scheme" --valence 3..5 --claim c1 folder >stdout 2>stderr
  status=$?
  if [ $status -eq 1 ] && grep -q 'no certificate in folder is about valence 5$' stderr && [ ! -s stdout ]; then echo "PASS directory-missing"; else echo "FAIL directory-missing: exit status $status"; fi
}

{
  each accept/table check c1 accept
  each accept/harmless check c1 accept
  each accept-1/table check c1 accept-1
  each accept-1/table reproduce
  each accept-1/refuted check not-c1 accept-1
  each accept-1/refuted reproduce
  refuse loop-4 loop 3 c1 1 'valence: expected 3'
  refuse loop-4 loop 40 c1 1 'valence: expected 40'
  refuse loop-4 wide 4 c1 1 'scheme: expected the text of the given scheme'
  refuse loop-4 loop 4 not-c1 1 'claim: expected not-c1'
  compare accept table harmless
  compare accept-1 table refuted
  directory
} >results
cat results
! grep -q '^FAIL' results
