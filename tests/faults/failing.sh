#!/bin/sh
# Calls that fail, each in turn: no wrong verdict, no exit status 0 for work that is lost, one clear message; and the next run, without
# faults, ends as if nothing had been.
#
# FAULTS_MALLOCS=N: every Nth allocation fails in turn (1 in make check-faults).
set -u
suite=failing
. "$SRCDIR/tests/faults/common.sh"
: "${FAULTS_MALLOCS:=997}"

# The lines of a run without times and places.
verdicts() { sed -e 's/;.*//' "$1"; }

judge() { # WHAT
  [ -e output ] && verdicts output | cmp -s -n "$(verdicts output | wc -c)" - expected ||
    { echo "FAIL failing-$1: wrong verdicts: $(head -n 3 output)"; return 1; }
  case $status in
    "$wanted") ! compare_with reference d || return 0 ;;
    71 | 74) [ "$(grep -c '^smoothcert: ' stderr)" -ge 1 ] && return 0 ;;
  esac
  echo "FAIL failing-$1: exit status $status: $(head -n 1 stderr)"
  return 1
}

once() { # WHAT FAILURE
  rm -rf d
  # shellcheck disable=SC2086  # words
  faulty FAULTS_FAIL="$2" FAULTS_COUNT=count prove $arguments --out d >output 2>stderr
  status=$?
  judge "$1" || return 1
  difference=$(nothing_torn_or_lost reference d output) || { echo "FAIL failing-$1: $difference"; return 1; }
  [ "$status" -ne "$wanted" ] || return 0
  # shellcheck disable=SC2086
  "$SMOOTHCERT" prove $arguments --out d >output 2>next-stderr
  [ $? -eq "$wanted" ] && difference=$(compare_with reference d) || { echo "FAIL failing-$1: the next run: $difference $(cat next-stderr)"; return 1; }
}

# From the first call on, until there is none of that number.  What is needed to make work durable must not fail unnoticed, even if
# nothing is missing in the end.
each() { # KIND ERROR STEP
  n=1
  while :; do
    once "$1-$n-$2" "$1:$n:$2" || return
    made=$(sed -n "s/^$1 //p" count)
    [ "${made:-0}" -ge "$n" ] || break
    case $1:$status in
      write:74 | fsync:74 | rename:74 | mkdir:74) ;;
      write:* | fsync:* | rename:* | mkdir:*) echo "FAIL failing-$1-$n-$2: exit status $status, as if nothing had failed"; return ;;
    esac
    n=$((n + $3))
  done
  [ $n -gt 1 ]
  holds "$scenario-$1-$2" $? 'there was no such call'
}

scenario() { # NAME STATUS ARGUMENT...
  scenario=$1 wanted=$2
  shift 2
  arguments=$*
  rm -rf reference
  # shellcheck disable=SC2086
  "$SMOOTHCERT" prove $arguments --out reference >output 2>stderr
  [ $? -eq "$wanted" ]
  holds "$scenario-reference" $? "$(cat stderr)"
  verdicts output >expected
}

# Ranges: the same classification, though perhaps in other boxes, or no memory; nothing that is said is wrong.
classified() { # NAME STATUS ARGUMENT...
  name=$1 wanted=$2 n=1
  shift 2
  "$SMOOTHCERT" prove "$@" --out none >whole 2>stderr
  expected=$(tail -n 1 whole | sed 's/.*: //')
  while :; do
    faulty FAULTS_FAIL="malloc:$n:12" FAULTS_COUNT=count prove "$@" --out none >output 2>stderr
    status=$?
    [ "$(grep '^[a-z]*: ' output | sed 's/: .*//' | sort -u)" = refuted ] || [ ! -s output ] || { echo "FAIL failing-$name-malloc-$n: $(head -n 1 output)"; return; }
    case $status in
      71) [ -s stderr ] || { echo "FAIL failing-$name-malloc-$n: no message"; return; } ;;
      "$wanted") [ "$(tail -n 1 output | sed 's/.*: //')" = "$expected" ] || { echo "FAIL failing-$name-malloc-$n: $(tail -n 1 output)"; return; } ;;
      *) echo "FAIL failing-$name-malloc-$n: exit status $status: $(cat stderr)"; return ;;
    esac
    [ "$(sed -n 's/^malloc //p' count)" -ge "$n" ] || break
    n=$((n + FAULTS_MALLOCS))
  done
  holds "$name-malloc" $((n == 1))
}

# Commands that only look: all of their answer, or an error.  (Where memory is short for a moment, rerun may find other choices.)
reader() { # NAME KIND ERROR STEP ARGUMENT...
  name=$1 kind=$2 error=$3 step=$4
  shift 4
  "$SMOOTHCERT" "$@" >whole 2>stderr
  sed 's/; grid.*//' whole >expected
  n=1
  while :; do
    faulty FAULTS_FAIL="$kind:$n:$error" FAULTS_COUNT=count "$@" >output 2>stderr
    status=$?
    case $status in
      0) sed 's/; grid.*//' output | cmp -s - expected || { echo "FAIL failing-$name-$kind-$n: exit status 0 with another answer"; return; } ;;
      71 | 74) [ -s stderr ] || { echo "FAIL failing-$name-$kind-$n: no message"; return; } ;;
      *) echo "FAIL failing-$name-$kind-$n: exit status $status: $(cat stderr)"; return ;;
    esac
    [ "$(sed -n "s/^$kind //p" count)" -ge "$n" ] || break
    n=$((n + step))
  done
  holds "$name-$kind" 0
}

readers() {
  "$SMOOTHCERT" prove loop --valence 3..4 --out kept >output 2>stderr
  for kind in malloc open; do
    step=1
    [ $kind = open ] || step=$FAULTS_MALLOCS
    reader show $kind 12 "$step" show kept
    reader rerun $kind 12 "$step" rerun kept --precision 128
    reader archive-list $kind 12 "$step" archive list kept
    reader archive-verify $kind 12 "$step" archive verify kept
    reader archive-diff $kind 12 "$step" archive diff kept kept
    reader archive-pack $kind 12 "$step" archive pack kept
  done
}

everything() {
  scenario proved 0 loop --valence 3..4
  for kind in open write fsync rename close mkdir; do each $kind 5 1; done
  each mkdir 30 1 # a read-only file system
  each open 13 9  # no permission
  # A disk that is full from some moment on: ENOSPC.
  n=1
  while [ $n -le 8 ]; do
    once "full-disk-$n" "write:$n+:28" || return
    [ "$status" -eq 74 ] && grep -q 'No space left' stderr || { echo "FAIL failing-full-disk-$n: exit status $status: $(cat stderr)"; return; }
    n=$((n + 1))
  done
  holds full-disk 0
  each malloc 12 "$FAULTS_MALLOCS"
  scenario refuted 1 "$SRCDIR/tests/certificates/schemes/centre-above.scheme" --valence 5
  each malloc 12 "$FAULTS_MALLOCS"
  each fsync 5 1
  classified smooth-grows 1 "$SRCDIR/tests/verify/schemes/smooth-grows.scheme" --valence 200..inf
  readers
}

{
  if can_preload; then
    everything
  else
    echo 'SKIP failing: nothing can be preloaded here'
  fi
} >../results
cat ../results
! grep -q '^FAIL' ../results
