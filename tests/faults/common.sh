# common.sh: what the tests of faults share.  Needs SMOOTHCERT, BUILDDIR and $suite, a name; goes to a directory of its own.
# shellcheck shell=sh disable=SC2154
LC_ALL=C
export LC_ALL
preload=$BUILDDIR/tests/faults/preload.so

holds() { # NAME STATUS REASON
  if [ "$2" -eq 0 ]; then echo "PASS $suite-$1"; else echo "FAIL $suite-$1: $3"; fi
}

# Neither every system can preload, nor does every program let it happen (one built with sanitizers, say).
can_preload() {
  [ -s "$preload" ] || return 1
  rm -f probe
  FAULTS_COUNT=probe LD_PRELOAD=$preload "$SMOOTHCERT" --version >/dev/null 2>&1
  grep -q '^malloc [1-9]' probe 2>/dev/null
}

# The program, with faults as the environment says.
faulty() { # [NAME=VALUE...] ARGUMENT...: the former begin with FAULTS_
  environment=
  while :; do
    case $1 in FAULTS_*) environment="$environment $1" && shift ;; *) break ;; esac
  done
  # shellcheck disable=SC2086  # words
  env $environment LD_PRELOAD="$preload" "$SMOOTHCERT" "$@"
}

# Are these files of the directory what an undisturbed run makes?  Says which is not.
compare_with() { # REFERENCE DIRECTORY
  for f in "$1"/valence-*.cert "$1/index" "$1/scheme.scheme" "$1/verify.sh"; do
    cmp -s "$f" "$2/${f##*/}" || { echo "${f##*/} is not as in an undisturbed run"; return 1; }
  done
  for f in "$2"/*; do
    case $f in */unfinished-*) echo "${f##*/} is left"; return 1 ;; esac
  done
}

# Whatever there is under a final name is complete; and what was reported is there.
nothing_torn_or_lost() { # REFERENCE DIRECTORY STDOUT
  for f in "$2"/valence-*.cert "$2/scheme.scheme" "$2/verify.sh" "$2/index"; do
    case $f in */index) [ -e "$f" ] && ! cmp -s "$f" "$1/index" && [ "$(wc -l <"$f")" -lt 1 ] && { echo 'a torn index'; return 1; }; continue ;; esac
    [ ! -e "$f" ] || cmp -s "$f" "$1/${f##*/}" || { echo "${f##*/} is torn"; return 1; }
  done
  for f in "$2"/valence-*.log "$2/runs"; do
    [ ! -e "$f" ] || [ "$(tail -c 2 "$f")" = '}' ] || { echo "${f##*/} is torn"; return 1; }
  done
  sed -n 's|^[a-z]*: .*; \([^;]*\.cert\)$|\1|p' "$3" >reported
  while read -r f; do
    [ -e "$f" ] && grep -q "  ${f##*/}\$" "$2/journal" || { echo "$f was reported and is lost"; return 1; }
  done <reported
}

mkdir work && cd work || exit 1
