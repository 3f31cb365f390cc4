#!/bin/sh
# The listing of what one verification passed through (reading): it has what was executed and nothing else, and stays
# within what a careful reader gets through in two evenings.
set -u
LC_ALL=C
export LC_ALL

MOST=6500 # lines that are not blank, for one valence

if ! command -v "${GCC:-gcc}" >/dev/null || ! command -v "${GCOV:-gcov}" >/dev/null; then
  echo 'SKIP reading: there is no gcc with gcov'
  exit 0
fi

pass() { echo "PASS $1"; }
fail() { echo "FAIL $1"; }

lines() { sed -n 's/^reading: \([0-9]*\) lines.*/\1/p' complaints; }

read_proof() { # SCHEME
  sh "$SRCDIR/tests/check/reading" --scheme "$SRCDIR/proofs/$1/scheme.scheme" --valence 3 --claim c1 "$SRCDIR/proofs/$1/valence-3.cert" >listing 2>complaints
}

has() { grep -q -e "$1" listing; }

for scheme in loop kobbelt; do
  read_proof "$scheme"
  status=$?
  if [ $status -ne 0 ]; then fail "reading/$scheme: status $status: $(cat complaints)"; continue; fi
  if [ "$(lines)" -le "$MOST" ]; then pass "reading/$scheme/lines"; else fail "reading/$scheme/lines: $(lines), more than $MOST"; fi
  if has '^static void prove_inclusion(' && has '^struct eigenpair eigenpair_prove(' && has '^/\* ---- decide.c ---- \*/'; then
    pass "reading/$scheme/executed"
  else
    fail "reading/$scheme/executed: something is missing that was executed"
  fi
  if has 'window_prove(' || has '^/\* ---- ties.c' || has '"radius: it is not positive"'; then
    fail "reading/$scheme/left-out: there is something that was not executed"
  else
    pass "reading/$scheme/left-out"
  fi
done

# A mask with negative weights, and not another one, needs a proof of its stability.
if has '^bool stability_holds('; then pass reading/kobbelt/stability; else fail 'reading/kobbelt/stability: not there'; fi
read_proof loop
if has '^bool stability_holds('; then fail 'reading/loop/stability: it is there'; else pass reading/loop/stability; fi

# What is rejected is no proof, and the status says so.
sed 's/^radius .*/radius 0/' "$SRCDIR/proofs/loop/valence-3.cert" >forged
sh "$SRCDIR/tests/check/reading" --scheme "$SRCDIR/proofs/loop/scheme.scheme" --valence 3 --claim c1 forged >listing 2>complaints
if [ $? -eq 1 ]; then pass reading/rejected; else fail "reading/rejected: $(cat complaints)"; fi
