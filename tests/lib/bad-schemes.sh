#!/bin/sh
# What the program says of malformed scheme files: the place and a fragment of the message, from the two lists
# expected.txt in tests/lib/bad-schemes/ (their first lines explain them).
directory=$SRCDIR/tests/lib/bad-schemes

# check NAME FILE LINE COLUMN FRAGMENT COMMAND...: the command complains of FILE at that place, with exit status 65.
check() {
  name=$1 file=$2 line=$3 column=$4 fragment=$5
  shift 5
  message=$("$SMOOTHCERT" "$@" 2>&1 >/dev/null)
  status=$?
  place=${message#"smoothcert: $file:"}
  case $line in 0) place=0:0:$place ;; esac
  if [ "$status" -ne 65 ]; then
    echo "FAIL bad-scheme-$name: exit status $status: $message"
  elif [ "$line" != - ] && [ "${place%%:*}" != "$line" ]; then
    echo "FAIL bad-scheme-$name: expected line $line: $message"
  elif [ "$column" != - ] && rest=${place#*:} && [ "${rest%%:*}" != "$column" ]; then
    echo "FAIL bad-scheme-$name: expected column $column: $message"
  else
    case $message in
      *"$fragment"*) echo "PASS bad-scheme-$name" ;;
      *) echo "FAIL bad-scheme-$name: expected '$fragment': $message" ;;
    esac
  fi
}

grep -v '^#' "$directory/expected.txt" | while read -r name line column fragment; do
  check "$name" "$directory/$name.scheme" "$line" "$column" "$fragment" prove "$directory/$name.scheme" --valence 5 --out none
done
grep -v '^#' "$directory/at-valence/expected.txt" | while read -r name k line column fragment; do
  check "at-$k-$name" "$directory/at-valence/$name.scheme" "$line" "$column" "$fragment" spectrum "$directory/at-valence/$name.scheme" --valence "$k"
done
