#!/bin/sh
# A loss of power at any moment: what was reported is not lost, what is there is complete, and the same command goes on.  Killing
# cannot show that, for the system writes what a killed program has left: so its operations are recorded, and crash.c makes
# from the record what a disk might hold.  Each fsync of the program is needed: without any one of them it notices.
set -u
suite=durability
. "$SRCDIR/tests/faults/common.sh"
crash=$BUILDDIR/tests/faults/crash
: "${FAULTS_EVERY:=100}"

new_directory() {
  faulty "$@" FAULTS_RECORD=record prove loop --valence 3..4 --out t/d >output 2>stderr
}

# Certificates are there already, and get others; one is added.
old_directory() {
  new_directory "$@" && faulty "$@" FAULTS_RECORD=record prove loop --valence 3..5 --precision 128 --out t/d >>output 2>stderr
}

# Somebody was killed between making the directories.
half_made_directory() {
  FAULTS_KILL=2 LD_PRELOAD=$preload FAULTS_RECORD=record "$SMOOTHCERT" prove loop --valence 3..4 --out t/d >output 2>stderr
  [ -d t ] && [ ! -d t/d ] && new_directory "$@"
}

states() { # SCENARIO COMMAND
  rm -rf t record
  $1
  holds "$1-runs" $? "$(cat stderr)"
  result=$("$crash" record output t/d "$FAULTS_EVERY" "$2" 2>stderr)
  holds "$1-states" $? "$result $(cat stderr)"
}

# How many there are depends on how the answers came in groups: the run that makes no Nth ends the test.
each_fsync() { # SCENARIO
  n=0
  unnoticed=
  while :; do
    n=$((n + 1))
    rm -rf t record
    $1 FAULTS_SWALLOW=$n FAULTS_COUNT=count
    [ "$(sed -n 's/^fsync //p' count)" -ge $n ] || break
    "$crash" record output t/d >result 2>stderr
    [ $? -eq 1 ] || unnoticed="$unnoticed $n"
  done
  [ $n -gt 10 ] && [ -z "$unnoticed" ]
  holds "$1-each-fsync-is-needed" $? "of $((n - 1)) fsyncs these are not noticed when they are missing:$unnoticed"
}

{
  if can_preload; then
    "$SMOOTHCERT" prove loop --valence 3..4 --out reference >stdout 2>&1
    # shellcheck disable=SC2016  # the shell of crash.c
    states new_directory '"$SMOOTHCERT" prove loop --valence 3..4 --out t/d >stdout 2>&1 && cmp reference/index t/d/index &&
      cmp reference/valence-3.cert t/d/valence-3.cert && cmp reference/valence-4.cert t/d/valence-4.cert && [ -z "$(ls t/d | grep unfinished)" ]'
    # shellcheck disable=SC2016
    states old_directory '"$SMOOTHCERT" prove loop --valence 3..5 --out t/d >stdout 2>&1 && "$SMOOTHCERT" archive verify t/d >stdout 2>&1'
    states half_made_directory true 2>killed
    each_fsync new_directory
  else
    echo 'SKIP durability: nothing can be preloaded here'
  fi
} >../results
cat ../results
! grep -q '^FAIL' ../results
