#!/bin/sh
# Prover and checker read the same scheme files: of the kept inputs of their fuzz targets both accept the same ones.
set -u
LC_ALL=C
export LC_ALL

# "accepted NAME" or "refused NAME" for all inputs, by one of the two readers.
ask() { # TARGET
  "$BUILDDIR/tests/fuzz/t-fuzz-$1" "$SRCDIR"/tests/fuzz/inputs/check-scheme/* "$SRCDIR"/tests/fuzz/inputs/scheme/* 2>complaints
}

ask scheme >prover
ask check-scheme >checker
if ! [ -s prover ] || ! grep -q '^accepted' prover; then
  echo "FAIL fuzz-agree: $(head -n 1 complaints)"
elif cmp -s prover checker; then
  echo "PASS fuzz-agree"
else
  echo "FAIL fuzz-agree: $(diff prover checker | grep '^[<>]' | head -n 1)"
fi
cmp -s prover checker
