#!/bin/sh
# SIGKILL at every operation of the program, and at random moments: nothing that was reported is lost, nothing is half-written under
# its final name, and in the end all is as if nobody had been killed.
#
# FAULTS_KILLS=N: so many random moments (make check-faults: 1,000); FAULTS_SEED: other ones.
set -u
suite='kill'
. "$SRCDIR/tests/faults/common.sh"
: "${FAULTS_KILLS:=10}" "${FAULTS_SEED:=1}"

finish_and_compare() { # NAME DIRECTORY VALENCES
  "$SMOOTHCERT" prove loop --valence "$3" --out "$2" >stdout 2>stderr || { echo "FAIL kill-$1: the next run ends with $?: $(cat stderr)"; return 1; }
  difference=$(compare_with reference "$2") || { echo "FAIL kill-$1: $difference"; return 1; }
}

each_operation() {
  rm -rf reference
  "$SMOOTHCERT" prove loop --valence 3..5 --out reference >stdout 2>&1
  n=0
  while :; do
    n=$((n + 1))
    rm -rf d
    faulty FAULTS_KILL=$n prove loop --valence 3..5 --out d >output 2>stderr
    status=$?
    difference=$(nothing_torn_or_lost reference d output) || { echo "FAIL kill-before-operation-$n: $difference"; return; }
    finish_and_compare "before-operation-$n" d 3..5 || return
    [ $status -ne 0 ] || break
    [ $status -eq 137 ] || { echo "FAIL kill-before-operation-$n: exit status $status"; return; }
  done
  [ $n -gt 30 ]
  holds each-operation $? "there were only $n"
}

# Several kills in one directory, then the next one.
random_moments() {
  valences=3..30
  rm -rf reference d
  "$SMOOTHCERT" prove loop --valence $valences --out reference >stdout 2>&1
  awk -v seed="$FAULTS_SEED" -v n="$FAULTS_KILLS" 'BEGIN { srand(seed); for (i = 0; i < n; i++) printf "%.4f\n", rand() * rand() * 0.12 + 0.001 }' >delays
  killed=0
  while read -r delay; do
    "$SMOOTHCERT" prove loop --valence $valences --jobs $((killed % 2 + 1)) --out d >output 2>stderr &
    process=$!
    sleep "$delay"
    kill -9 $process
    wait $process
    status=$?
    killed=$((killed + 1))
    difference=$(nothing_torn_or_lost reference d output) || { echo "FAIL kill-after-$delay-s: $difference (FAULTS_SEED=$FAULTS_SEED)"; return; }
    if [ $status -eq 0 ] || [ $((killed % 7)) -eq 0 ]; then
      finish_and_compare "after-$delay-s" d $valences || return
      rm -rf d
    fi
  done <delays
  holds "random-moments" 0
}

{
  if can_preload; then
    each_operation
  else
    echo 'SKIP kill-each-operation: nothing can be preloaded here'
  fi
  if sleep 0.001 2>/dev/null; then
    random_moments 2>messages
  else
    echo 'SKIP kill-random-moments: sleep knows no fractions of seconds here'
  fi
} >../results
cat ../results
! grep -q '^FAIL' ../results
