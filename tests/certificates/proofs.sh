#!/bin/sh
# The archives of proofs/ say what proofs/README says, and smoothcert-check accepts them; claims beyond that it does not.
proofs=$SRCDIR/proofs

# verifies NAME VALENCES CLAIM
verifies() {
  if "$SMOOTHCERT_CHECK" --scheme "$proofs/$1/scheme.scheme" --valence "$2" --claim "$3" "$proofs/$1" >printed 2>&1; then
    echo "PASS proofs-$1-$2"
  else
    echo "FAIL proofs-$1-$2: $(tail -n 1 printed)"
  fi
}

rejects() {
  "$SMOOTHCERT_CHECK" --scheme "$proofs/$1/scheme.scheme" --valence "$2" --claim "$3" "$proofs/$1" >printed 2>&1
  if [ $? -eq 1 ]; then
    echo "PASS proofs-not-$1-$2"
  else
    echo "FAIL proofs-not-$1-$2: $(tail -n 1 printed)"
  fi
}

for name in loop loop-warren modified-loop modified-butterfly catmull-clark doo-sabin kobbelt midpoint-2 midpoint-3 midpoint-4 \
  midpoint-5 midpoint-6 midpoint-7 midpoint-8 midpoint-9 wave-7; do
  verifies $name all c1
done
verifies butterfly 4..7 c1
verifies butterfly 3,8..inf not-c1
verifies loop-sixteenth 5..19 c1
verifies loop-sixteenth 3,4,20..inf not-c1
verifies smooth-grows 4..14 c1
verifies smooth-grows 3,15..inf not-c1
rejects loop-sixteenth 5..20 c1
rejects smooth-grows 3..14 c1
rejects loop-sixteenth 19..inf not-c1
rejects butterfly all c1
rejects loop all not-c1
