#!/bin/sh
# reject-1/: forgeries of version 1, each a good certificate of accept-1/ with one lie, and a right count of records and
# a right hash, so that only the lie is wrong.  The checker must see it, and for the right reason.
#
# A list in reject-1/ has the lines (# begins a comment)
#
#     on NAME                             the forgeries below are made of accept-1/NAME.cert, for its own claim
#     claim SCHEME VALENCE c1|not-c1 [--set NAME=VALUE]...     for this claim instead; `-' for SCHEME: for the scheme whose
#                                         text stands in the forgery
#     NAME STATUS PLACE | WORDS | EDIT    one forgery
#      MORE                               one more line of its edit
#
# STATUS is the checker's: 1 rejected, 2 cannot check; 0 marks the last value that is still good, and edits that are no
# lies.  PLACE is how the line begins that is complained of (_ for a blank; `-': no line, or an empty one; `end': behind the last one).
# WORDS are part of the complaint.  EDIT is a sed script; or `unsealed' and a sed script, where records and hash are
# edited, too, and not made right; or `borrow RECORD... from NAME', lines of another certificate.
#
# usage: reject-1.sh [LIST [FORGERY]]; FORGERY is then left as ./forgery.
set -u
LC_ALL=C
export LC_ALL
here=$SRCDIR/tests/certificates

scheme_file() { # NAME
  if [ -f "$SRCDIR/lib/catalogue/$1.scheme" ]; then echo "$SRCDIR/lib/catalogue/$1.scheme"; else echo "$here/schemes/$1.scheme"; fi
}

# Sets base and claim as the tables of accept-1/ say.
on() { # NAME
  base=$here/accept-1/$1.cert claim=c1
  row=$(grep "^$1 " "$here/accept-1/table")
  if [ -z "$row" ]; then
    claim=not-c1
    row=$(grep "^$1 " "$here/accept-1/refuted") || { echo "FAIL reject-1: there is no certificate $1" && exit 1; }
  fi
  # shellcheck disable=SC2086  # words
  set -- $row
  scheme=$2 valence=$3 settings=
  shift 3
  while [ $# -gt 1 ]; do
    if [ "$1" = --set ]; then settings="$settings --set $2"; fi
    shift 2
  done
}

claim() { # SCHEME VALENCE CLAIM [OPTION...]
  scheme=$1 valence=$2 claim=$3
  shift 3
  settings=$*
}

# Adds the right count of records and the right hash.
seal() { # FILE
  echo "records $(($(wc -l <"$1")))" >>"$1"
  digest=$(sha256sum <"$1")
  echo "sha256 ${digest%% *}" >>"$1"
}

# The records of this certificate, in the places where they are in the other.
borrow() { # RECORD... from NAME
  records=
  while [ "$1" != from ]; do
    records="$records $1 "
    shift
  done
  awk -v records="$records" '
    FNR == 1 { file++ }
    $1 == "records" { exit_at[file] = 1 }
    exit_at[file] { next }
    { wanted = index(records, " " $1 " ") }
    file == 1 { if (wanted) lent[$1] = lent[$1] $0 "\n"; next }
    !wanted { print; next }
    !done[$1]++ { printf "%s", lent[$1] }' "$here/accept-1/$2.cert" "$base"
}

forge() { # EDIT
  case $1 in
    unsealed*) sed -e "${1#unsealed }" "$base" >forgery ;;
    # shellcheck disable=SC2086  # words
    borrow*) borrow ${1#borrow } >forgery && seal forgery ;;
    *) sed -e '/^records /,$d' -e "$1" "$base" >forgery && seal forgery ;;
  esac
}

# Where the checker must have found a fault, and what it must have said.
compare() { # NAME STATUS PLACE WORDS
  answer=$(case $2 in 0) echo verified ;; 1) echo rejected ;; *) echo 'cannot check' ;; esac)
  said=$(head -n 1 said)
  place=${said#"$answer: forgery:"}
  line=${place%%:*}
  case $line in '' | *[!0-9]*) line= ;; esac
  found=$(sed -n "$line{p;q;}" forgery)
  [ "${line:-0}" -gt "$(($(wc -l <forgery)))" ] && found=end
  [ -z "$line" ] || [ -z "$found" ] && found=-
  if [ "$status" -ne "$2" ] || [ "${said%%:*}" != "$answer" ]; then
    echo "FAIL $1: exit status $status instead of $2: $said"
  elif [ "$2" != 0 ] && [ -s stdout ]; then
    echo "FAIL $1: it is not verified, but something is on stdout: $(head -n 1 stdout)"
  else
    case "$found|$said" in
      "$3"*"|"*"$4"*) echo "PASS $1" ;;
      *) echo "FAIL $1: expected the line of '$3' and '$4', found '$said' ($found)" ;;
    esac
  fi
}

try() { # NAME STATUS PLACE WORDS EDIT
  forge "$5"
  file=./text.scheme
  if [ "$scheme" = - ]; then
    sed -n -e '1,2d' -e '/^claim /q' -e p forgery >text.scheme
  else
    file=$(scheme_file "$scheme")
  fi
  # shellcheck disable=SC2086  # words
  "$SMOOTHCERT_CHECK" --scheme "$file" $settings --valence "$valence" --claim "$claim" forgery >stdout 2>stderr
  status=$?
  cat stderr stdout >said
  compare "$1" "$2" "$3" "$4"
}

# The forgery whose first line has been read, once its last line is known.
finish() {
  [ -n "$head" ] || return
  words=${head#*| }
  # shellcheck disable=SC2086  # three words
  set -- ${head%% | *}
  if [ -z "${only:-}" ] || [ "$only" = "$1" ]; then
    try "$1" "$2" "$(echo "$3" | tr _ ' ')" "${words%% | *}" "${words#* | }$edit"
  fi
  head=
}

run_list() { # FILE
  head='' edit=
  while IFS= read -r text; do
    case $text in
      '#'* | '') ;;
      ' '*)
        edit="$edit
${text# }"
        ;;
      'on '* | 'claim '*)
        finish
        # shellcheck disable=SC2086  # a function and its arguments
        $text
        ;;
      *)
        finish
        head=$text edit=
        ;;
    esac
  done <"$1"
  finish
}

# A directory must have each valence that is claimed, once; names of files do not matter.
archive() {
  mkdir archive
  for valence in 3 4 12; do cp "$here/accept-1/catmull-clark-$valence.cert" "archive/valence-$valence.cert"; done
  archive_try archive-nothing 0 'C1 at valence 12' 3..4,12
  archive_try archive-valence-dropped 1 'no certificate in archive is about valence 5' 3..5
  mv archive/valence-3.cert forgery && mv archive/valence-4.cert archive/valence-3.cert && mv forgery archive/valence-4.cert
  archive_try archive-files-exchanged 0 'C1 at valence 4' 3..4
  cp archive/valence-4.cert archive/valence-3.cert
  archive_try archive-file-twice 1 'are about valence 3' 3..4
}

archive_try() { # NAME STATUS WORDS VALENCES
  "$SMOOTHCERT_CHECK" --scheme "$(scheme_file catmull-clark)" --valence "$4" --claim c1 archive >stdout 2>stderr
  status=$?
  case $status:$(cat stdout stderr) in
    "$2:"*"$3"*) echo "PASS $1" ;;
    *) echo "FAIL $1: exit status $status: $(cat stdout stderr)" ;;
  esac
}

only=${2:-}
for list in "$here"/reject-1/${1:-*}; do
  run_list "$list"
done >results
[ $# -gt 0 ] || archive >>results
cat results
[ -z "$only" ] || exit 0

# No name twice.
twice=$(sed -e 's/^[A-Z]* //' -e 's/:.*//' results | sort | uniq -d | tr '\n' ' ')
if [ -n "$twice" ]; then echo "FAIL reject-1-names: there are two of $twice"; else echo "PASS reject-1-names"; fi
[ -z "$twice" ] && ! grep -q '^FAIL' results
