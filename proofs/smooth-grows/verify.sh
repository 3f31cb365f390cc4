#!/bin/sh
# Checks every certificate of this directory with smoothcert-check alone: what the index claims, for the scheme in
# scheme.scheme.  SMOOTHCERT_CHECK names the program if it is not on PATH.
# Exit status: 0 all verified, 1 a certificate was rejected, 2 one cannot be checked, or there is none.
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd) || exit 2
check=${SMOOTHCERT_CHECK:-smoothcert-check}
verified=0 rejected=0 unchecked=0 undecided=0
[ -r "$here/index" ] || { echo "$here/index is missing: 'smoothcert archive verify' says more" >&2; exit 2; }
while read -r valences verdict digest file; do
  case $verdict in
    proved) claim=c1 ;;
    refuted) claim=not-c1 ;;
    *) echo "undecided: valence $valences"; undecided=$((undecided + 1)); continue ;;
  esac
  "$check" --scheme "$here/scheme.scheme" --valence "$valences" --claim "$claim" "$here/$file" </dev/null
  case $? in
    0) verified=$((verified + 1)) ;;
    1) rejected=$((rejected + 1)) ;;
    *) unchecked=$((unchecked + 1)) ;;
  esac
done <"$here/index"
echo "$verified verified, $rejected rejected, $unchecked could not be checked, $undecided undecided"
[ "$rejected" -eq 0 ] || exit 1
[ "$unchecked" -eq 0 ] && [ "$verified" -gt 0 ] || exit 2
