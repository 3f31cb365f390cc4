#!/bin/sh
# The completions, sourced by bash and asked as it would ask them.
set -u
if ! command -v bash >/dev/null; then
  echo "SKIP completion: there is no bash"
  exit 0
fi
if ! bash -c 'read -r _ < <(echo)' 2>/dev/null; then
  echo "SKIP completion: bash has no /dev/fd here"
  exit 0
fi
exec bash -s <<'SCRIPT'
compopt() { :; } # a builtin that works while bash completes only
# shellcheck source=/dev/null
source "$SRCDIR/completion/smoothcert"
source "$SRCDIR/completion/smoothcert-check"

# offers NAME FUNCTION "EXPECTED..." WORD...  all of these are among the answers for the last word
offers() {
  local name=$1 function=$2 expected=$3 word
  shift 3
  COMP_WORDS=("$@")
  COMP_CWORD=$(($# - 1))
  COMPREPLY=()
  $function
  for word in $expected; do
    if [[ " ${COMPREPLY[*]} " != *" $word "* ]]; then
      echo "FAIL completion-$name: '$word' is not among '${COMPREPLY[*]}'"
      return
    fi
  done
  echo "PASS completion-$name"
}

# exactly NAME FUNCTION "EXPECTED" WORD...
exactly() {
  local name=$1 expected=$3 answer
  answer=$(offers "$@")
  offers "$@" >said
  if [[ $answer == PASS* && "${COMPREPLY[*]}" == "$expected" ]]; then
    echo "PASS completion-$name"
  else
    echo "FAIL completion-$name: '${COMPREPLY[*]}' instead of '$expected'"
  fi
}

touch mine.scheme
mkdir evidence
offers commands _smoothcert "prove spectrum regular schemes help --help" "$SMOOTHCERT" ""
exactly command _smoothcert "spectrum" "$SMOOTHCERT" sp
offers options _smoothcert "--valence --set --method --precision --jobs --out --json --help" "$SMOOTHCERT" prove loop --
exactly option _smoothcert "--digits" "$SMOOTHCERT" spectrum loop --di
offers schemes _smoothcert "$("$SMOOTHCERT" schemes | tr '\n' ' ') mine.scheme" "$SMOOTHCERT" prove ""
exactly scheme _smoothcert "kobbelt" "$SMOOTHCERT" schemes ko
exactly parameter _smoothcert "degree=" "$SMOOTHCERT" prove midpoint --set ""
exactly method _smoothcert "uniform" "$SMOOTHCERT" prove loop --method u
exactly directory _smoothcert "evidence" "$SMOOTHCERT" prove loop --out ev
exactly archive _smoothcert "list verify diff pack" "$SMOOTHCERT" archive ""
exactly number _smoothcert "" "$SMOOTHCERT" prove loop --valence ""
exactly help _smoothcert "regular" "$SMOOTHCERT" help regu
offers check-options _smoothcert_check "--scheme --set --valence --claim --help --version" "$SMOOTHCERT_CHECK" --
exactly check-claim _smoothcert_check "c1 not-c1" "$SMOOTHCERT_CHECK" --claim ""
exactly check-file _smoothcert_check "mine.scheme" "$SMOOTHCERT_CHECK" --scheme mi
SCRIPT
