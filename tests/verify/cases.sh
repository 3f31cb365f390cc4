#!/bin/sh
# Schemes of which it is known where they are C1: what is must be proved, what is not must never be.
# With SECONDS_PER_TEST (make check-long) every valence of the lists is tried, not only some.
set -u
LC_ALL=C
export LC_ALL
schemes=$SRCDIR/tests/verify/schemes
every=3..50,1000
some=3..12,17,50,1000
few=3,5,8,50,1000
if [ -n "${SECONDS_PER_TEST:-}" ]; then some=$every few=$every; fi

# Every valence of the list must be proved, and the program must say so by its status.
proved() { # NAME ARGUMENT...
  name=$1
  shift
  "$SMOOTHCERT" prove --out none "$@" >stdout 2>stderr
  status=$?
  if [ $status -eq 0 ] && [ -s stdout ] && ! grep -v -q '^proved: ' stdout; then
    echo "PASS cases-$name"
  else
    echo "FAIL cases-$name: status $status: $(cat stderr stdout | grep -v '^proved: ' | head -n 1)"
  fi
}

# None may be proved; what is not is left undecided or refuted, with status 1 or 2.
not_proved() { # NAME ARGUMENT...
  name=$1
  shift
  "$SMOOTHCERT" prove --out none "$@" >stdout 2>stderr
  status=$?
  if grep -q '^proved: ' stdout; then
    echo "FAIL cases-$name: PROVED, but not C1: $(grep '^proved: ' stdout | head -n 1)"
  elif [ $status -ne 1 ] && [ $status -ne 2 ]; then
    echo "FAIL cases-$name: status $status: $(cat stderr stdout | head -n 1)"
  else
    echo "PASS cases-$name"
  fi
}

# Every valence of the list must be refuted, for this reason, and the program must say so by its status.
refuted() { # NAME REASON ARGUMENT...
  name=$1 reason=$2
  shift 2
  "$SMOOTHCERT" prove --out none "$@" >stdout 2>stderr
  status=$?
  if [ $status -eq 1 ] && [ -s stdout ] && ! grep -v -q "^refuted: .* is not C1 at valence [0-9]*; $reason" stdout; then
    echo "PASS cases-$name"
  else
    echo "FAIL cases-$name: status $status: $(cat stderr stdout | grep -v '^refuted: ' | head -n 1)"
  fi
}

# Every valence of the list must be left undecided, with these words.
undecided() { # NAME WORDS ARGUMENT...
  name=$1 words=$2
  shift 2
  "$SMOOTHCERT" prove --out none "$@" >stdout 2>stderr
  status=$?
  if [ $status -eq 2 ] && [ -s stdout ] && ! grep -v -q "^undecided: .*$words" stdout; then
    echo "PASS cases-$name"
  else
    echo "FAIL cases-$name: status $status: $(cat stderr stdout | head -n 1)"
  fi
}

# Both must be proved at the same valences, with the same eigenvalue, or its conjugate.
same() { # NAME SCHEME SCHEME ARGUMENT...
  name=$1 first=$2 second=$3
  shift 3
  for scheme in "$first" "$second"; do
    "$SMOOTHCERT" prove --out none --json "$scheme" "$@" 2>stderr |
      sed -e 's/.*"valence":\([0-9]*\),"verdict":"\([a-z]*\)".*"modulus_lower":\([0-9.]\{12\}\).*/\1 \2 \3/' >"verdicts-${scheme##*/}"
  done
  if [ -s "verdicts-${first##*/}" ] && cmp -s "verdicts-${first##*/}" "verdicts-${second##*/}"; then
    echo "PASS cases-$name"
  else
    echo "FAIL cases-$name: $(diff "verdicts-${first##*/}" "verdicts-${second##*/}" | tr '\n' ' ' | cut -c 1-200)"
  fi
}

catalogue() {
  for scheme in loop loop-warren modified-loop modified-butterfly catmull-clark doo-sabin; do
    proved $scheme $scheme --valence $every
  done
  for degree in 2 3 4 5; do
    proved midpoint-$degree midpoint --set degree=$degree --valence $some
  done
  for degree in 6 7 8 9; do
    proved midpoint-$degree midpoint --set degree=$degree --valence $few
  done
  proved kobbelt kobbelt --valence $some
  proved kobbelt-tension kobbelt --set w=1/24 --valence 3,5
  proved butterfly butterfly --valence 4..7
  proved wave wave --valence $some
  proved wave-valence wave-valence --valence $some
  proved wave-7 "$schemes/wave-7.scheme" --valence $few
  proved loop-ring loop-ring --valence $some
  proved spiral loop-spiral --valence 3..10
  proved spiral-back loop-spiral --set turn=-1/5 --valence 5
  proved spiral-fast loop-spiral --set turn=1/2 --valence 4..9
  proved intervals loop-ring --set 'l=[0.49999,0.50001]' --set 'l2=[0.2,0.3]' --set 'others=[-1/8,1/8]' --set 'z=[0.2,0.3]' --valence 3..12
}

# It is known where: butterfly 4 to 7 (Zorin), Loop with 1/16 for each neighbour 5 to 19.
not_c1() {
  refuted butterfly-3 'frequency 0 dominates (0.25000000 exactly, in a Jordan block of 3 rows' butterfly --valence 3
  refuted butterfly-8 'frequency 2 dominates (0.46904152, frequency 1 has 0.46241777)' butterfly --valence 8
  refuted butterfly-9 'frequency 2 dominates (0.49729407, frequency 1 has 0.44442936)' butterfly --valence 9
  refuted butterfly-not 'frequency [0-9]* dominates' butterfly --valence 8..14,20,1000
  proved close-eigenvalues "$schemes/two-eigenvalues.scheme" --set e=1/10^12 --valence 5
  proved loop-sixteenth "$schemes/loop-sixteenth.scheme" --valence 5..19
  refuted loop-sixteenth-tie 'blocks 0 and 1 share the largest modulus exactly (0.37500000)' "$schemes/loop-sixteenth.scheme" --valence 4
  refuted loop-sixteenth-minus-one 'block 0 has the eigenvalue -1 exactly' "$schemes/loop-sixteenth.scheme" --valence 26
  refuted loop-sixteenth-not 'frequency 0 dominates' "$schemes/loop-sixteenth.scheme" --valence 3,20..25
  refuted loop-sixteenth-grows 'block 0 has an eigenvalue beyond 1' "$schemes/loop-sixteenth.scheme" --valence 27,100
  refuted loop-ring-l2 'frequency 2 dominates' loop-ring --set l=1/4 --set l2=1/2 --valence 5,8
  refuted loop-ring-real 'block 2 dominates (0.75000000), a real function, and then block 1 (0.50000000)' loop-ring --set l2=3/4 --valence 4
  refuted loop-ring-real-negative 'block 2 dominates (0.75000000), a real function, and then block 1 (0.50000000)' loop-ring --set l2=-3/4 --valence 4
  refuted loop-ring-real-fold 'block 2 dominates (0.80000000), a real function, and then block 0 (0.70000000); the map of both folds' loop-ring --set l2=4/5 --set z=7/10 --valence 4
  refuted loop-ring-real-fold-negative 'block 2 dominates (0.80000000), a real function, and then block 0 (0.70000000); the map of both folds' loop-ring --set l2=-4/5 --set z=-7/10 --set a=1/2 --valence 4
  not_proved loop-ring-real-tie loop-ring --set l2=4/5 --set z=4/5 --valence 4
  not_proved loop-ring-l2-half loop-ring --set l=1/4 --set l2=1/2 --valence 4 --max-precision 512
  refuted doo-sabin-3 'the characteristic map folds' doo-sabin-spectrum --set l=9/10 --set others=1/5 --valence 3
  refuted loop-ring-z 'frequency 0 dominates' loop-ring --set z=3/4 --valence 3,8
  refuted loop-ring-l 'block 1 has the eigenvalue 1 exactly' loop-ring --set l=1 --valence 3,8
  refuted loop-ring-l2-equal 'blocks 1 and 2 share the largest modulus exactly (0.50000000)' loop-ring --set l2=1/2 --valence 5,8,13
  refuted loop-ring-l2-opposite 'blocks 1 and 2 share the largest modulus exactly (0.50000000)' loop-ring --set l2=-1/2 --valence 7,20
  refuted loop-ring-others-equal 'blocks [12] and [23] share the largest modulus exactly (0.50000000)' loop-ring --set others=-1/2 --valence 8,17
  refuted loop-ring-z-equal 'blocks 0 and 1 share the largest modulus exactly (0.50000000)' loop-ring --set z=-1/2 --valence 3,4,5,7
  refuted loop-ring-all-equal 'blocks 1 and 2 share the largest modulus exactly (0.12500000, in Jordan blocks of the same size)' loop-ring --set l=1/8 --set l2=1/8 --set z=1/8 --valence 5,8
  not_proved loop-ring-double-one loop-ring --set z=1 --valence 5 --max-precision 256
  refuted loop-ring-l-above 'block 1 has an eigenvalue beyond 1' loop-ring --set l=9/8 --valence 3,8
  refuted loop-ring-fold 'the characteristic map folds' loop-ring --set l=99/100 --valence 7,20
  not_proved loop-ring-l-negative loop-ring --set l=-1/2 --valence 3,8
  not_proved intervals-not loop-ring --set 'others=[0,1/2]' --valence 7,12
  # One frequency of many, inside or outside of what a range of them can show.
  proved ripple "$schemes/ripple.scheme" --valence 192
  sed 's|m = 53: 1/4|m = 53: 1/2|' "$schemes/ripple.scheme" >hidden.scheme
  not_proved ripple-hidden hidden.scheme --valence 192,2690 --max-precision 256
}

# An eigenvalue as large as L but for a gap: only precision tells.
ties() {
  loop=$schemes/loop-tie.scheme
  quad=$schemes/catmull-clark-tie.scheme
  for digits in 10 50 300; do
    gap=gap=10^-$digits
    proved loop-tie-$digits "$loop" --set $gap --valence 3,5
    proved loop-tie-below-$digits "$loop" --set $gap --set side=-1 --valence 4,7
    proved catmull-clark-tie-$digits "$quad" --set $gap --valence 3,4,5,1000
    proved ring-tie-$digits loop-ring --set l2=1/2-10^-$digits --valence 5
    proved spiral-tie-$digits loop-spiral --set l=3/10 --set turn=4/10 --set others=10^-$digits-1/2 --valence 5
    proved doo-sabin-tie-$digits doo-sabin-spectrum --set others=1/2-10^-$digits --valence 6
  done
  for digits in 10 50 300; do
    gap=gap=-10^-$digits
    refuted loop-beyond-$digits 'frequency 0 dominates' "$loop" --set $gap --valence 3,5
    refuted loop-beyond-below-$digits 'frequency 0 dominates' "$loop" --set $gap --set side=-1 --valence 4,7
    refuted catmull-clark-beyond-$digits 'frequency 0 dominates' "$quad" --set $gap --valence 3,4,5,1000
    refuted ring-beyond-$digits 'frequency 2 dominates' loop-ring --set l2=1/2+10^-$digits --valence 5
    not_proved spiral-beyond-$digits loop-spiral --set l=3/10 --set turn=4/10 --set others=-10^-$digits-1/2 --valence 5
    not_proved doo-sabin-beyond-$digits doo-sabin-spectrum --set others=1/2+10^-$digits --valence 6
  done
  for k in 3 4 5 6 7; do
    refuted loop-tie-$k 'blocks 0 and 1 share the largest modulus exactly' "$loop" --valence $k
    refuted loop-tie-below-$k 'blocks 0 and 1 share the largest modulus exactly' "$loop" --set side=-1 --valence $k
  done
  refuted loop-tie-large 'blocks 0 and 1 share the largest modulus exactly' "$loop" --valence 8,9,12,20,33
  refuted catmull-clark-tie-4 'blocks 0 and 1 share the largest modulus exactly (0.50000000)' "$quad" --valence 4
  # Its field is not one of cosines.
  undecided catmull-clark-tie 'the gap to block 0 is at most 2^-40[0-9]* after 4096 bits: possibly an exact tie' "$quad" --valence 5
  not_proved spiral-tie loop-spiral --set l=3/10 --set turn=4/10 --set others=1/2 --valence 5 --max-precision 512
}

# Doo-Sabin schemes with the double eigenvalue l fold unless 128 l^2 (1 - l) - 7 l - 2 + 9 l cos(2 pi/n) > 0 (Peters and
# Reif 1998).  The roots, to six digits:
folds() {
  for root in 3:0.877287 5:0.947834 6:0.962862 7:0.972315 8:0.978607 10:0.986161 30:0.998437; do
    n=${root%%:*} l=${root#*:}
    proved fold-inside-$n doo-sabin-spectrum --set l=$l-1/10^4 --set others=1/5 --valence $n
    refuted fold-beyond-$n 'the characteristic map folds' doo-sabin-spectrum --set l=$l+1/10^4 --set others=1/5 --valence $n --max-precision 512
    refuted fold-far-beyond-$n 'the characteristic map folds' doo-sabin-spectrum --set l="($l+1)/2" --set others=1/5 --valence $n --max-precision 512
  done
  not_proved fold-spiral loop-spiral --set turn=1/2 --valence 3 --max-precision 256
}

# Characteristic maps that do not wind once, and pairs of eigenvalues of block 0 or k/2 that are not real.  What the numbers are is known
# from matrices of the whole complex.
windings_and_pairs() {
  made=$SRCDIR/tests/certificates/schemes
  refuted winding-triangle 'winding: the characteristic map winds -2 times round the extraordinary point' "$made/winding-triangle.scheme" --valence 3
  refuted winding-negative 'winding: the characteristic map winds -2 times round the extraordinary point; L = -0.5' "$made/winding-negative.scheme" --valence 3
  refuted winding-quad 'winding: the characteristic map winds -[2345] times' "$made/winding-quad.scheme" --valence 3..6
  refuted winding-forward 'winding: the characteristic map winds 4 times' "$made/winding-forward.scheme" --valence 3
  refuted winding-spiral 'winding: the characteristic map winds -[0-9]* times' "$made/winding-spiral.scheme" --valence 3..12,20
  refuted winding-spiral-9 'winding: the characteristic map winds -8 times' "$made/winding-spiral.scheme" --valence 9 --precision 128
  refuted winding-twice 'the characteristic map folds' "$made/winding-spiral.scheme" --set turns=1 --valence 3..6
  proved winding-once "$made/winding-spiral.scheme" --set turns=0 --valence 3..12,20
  refuted pair-cups 'frequency 0 dominates by a complex pair (0.55901699, frequency 1 has 0.50000000)' "$made/pair-cups.scheme" --valence 3..8,100
  refuted pair-cups-above 'frequency 0 dominates by a complex pair (0.50000' "$made/pair-cups.scheme" --set re=2/5 --set im=30001/100000 --valence 3,5
  refuted pair-cups-barely-above 'frequency 0 dominates by a complex pair (0.5000' "$made/pair-cups.scheme" --set re=2/5 --set im=3/10+10^-50 --valence 5
  proved pair-cups-below "$made/pair-cups.scheme" --set re=2/5 --set im=29999/100000 --valence 3..8
  proved pair-cups-barely-below "$made/pair-cups.scheme" --set re=2/5 --set im=3/10-10^-50 --valence 5
  not_proved pair-cups-equal "$made/pair-cups.scheme" --set re=2/5 --set im=3/10 --valence 5 --max-precision 256
  refuted pair-cups-grows 'block 0 has an eigenvalue beyond 1 (1.00603181)' "$made/pair-cups.scheme" --set re=-4/5 --set im=61/100 --valence 3,5
  undecided pair-cups-one 'block 0' "$made/pair-cups.scheme" --set re=-4/5 --set im=3/5 --valence 5 --max-precision 256
  refuted pair-saddles 'frequency [0-9]* dominates by a complex pair (0.55901699' "$made/pair-saddles.scheme" --valence 4,6,8,20
  refuted pair-saddles-above 'frequency 3 dominates by a complex pair (0.50000' "$made/pair-saddles.scheme" --set re=2/5 --set im=30001/100000 --valence 6
  proved pair-saddles-below "$made/pair-saddles.scheme" --set re=2/5 --set im=29999/100000 --valence 4,6,8
  proved pair-saddles-odd "$made/pair-saddles.scheme" --valence 5,7
  refuted pair-saddles-grows 'block [0-9]* has an eigenvalue beyond 1' "$made/pair-saddles.scheme" --set re=1 --valence 4,6
  not_proved pair-saddles-equal "$made/pair-saddles.scheme" --set re=2/5 --set im=3/10 --valence 6 --max-precision 256
}

# The same scheme seen in a mirror, or written down in another way.
mirrors() {
  for kind in triangle quad dual mask; do
    proved twisted-$kind "$schemes/twisted-$kind.scheme" --valence 4..8
    same mirror-$kind "$schemes/twisted-$kind.scheme" "$schemes/mirrored-$kind.scheme" --valence 3..8,12
  done
  # Points of Kobbelt's scheme that the mask takes care of, by a rule for the mirror image of its last one.
  {
    "$SMOOTHCERT" schemes kobbelt
    printf '%s\n' 'rule (3,1)' '(1,0) @ -1 w^2' 'centre -h*w' '(1,0) @ 1 -h*w' '(2,0) @ 1 w^2' '(1,1) @ -1 -h*w' '(1,0) h^2' '(1,1) rest' \
      '(1,2) -h*w' '(1,2) @ -1 -h*w' '(2,0) h^2' '(2,1) h^2' '(2,2) -h*w' '(1,3) @ -1 w^2' '(3,0) -h*w' '(3,1) -h*w' '(3,2) w^2' end
  } >kobbelt-again.scheme
  "$SMOOTHCERT" schemes kobbelt >kobbelt.scheme
  same kobbelt-again kobbelt.scheme kobbelt-again.scheme --valence 3,5,6
}

catalogue
not_c1
ties
folds
windings_and_pairs
mirrors
