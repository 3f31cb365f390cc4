#!/bin/sh
# reject/: the checker must see every lie, and for the right reason: exit status, line and words of reject/table.
set -u
here=$SRCDIR/tests/certificates

scheme_file() { # NAME
  if [ "$1" = loop ]; then echo "$SRCDIR/lib/catalogue/loop.scheme"; else echo "$here/schemes/$1.scheme"; fi
}

# What the checker must say first about a file, by its exit status.
answer() { # STATUS
  if [ "$1" -eq 1 ]; then echo rejected; else echo 'cannot check'; fi
}

try() { # NAME SCHEME VALENCE CLAIM STATUS LINE MESSAGE
  certificate=$here/reject/$1.cert
  "$SMOOTHCERT_CHECK" --scheme "$(scheme_file "$2")" --valence "$3" --claim "$4" "$certificate" >stdout 2>stderr
  status=$?
  said=$(head -n 1 stderr)
  if [ "$status" -eq 0 ]; then
    echo "FAIL reject-$1: VERIFIED: $(cat stdout)"
  elif [ "$status" -ne "$5" ]; then
    echo "FAIL reject-$1: exit status $status instead of $5: $said"
  elif [ -s stdout ]; then
    echo "FAIL reject-$1: it is not verified, but something is on stdout: $(head -n 1 stdout)"
  else
    case $said in
      "$(answer "$5"): $certificate:$6: "*"$7"*) echo "PASS reject-$1" ;;
      *) echo "FAIL reject-$1: expected line $6 and '$7', found '$said'" ;;
    esac
  fi
}

while read -r name scheme valence claim status line message; do
  case $name in '' | '#'*) continue ;; esac
  try "$name" "$scheme" "$valence" "$claim" "$status" "$line" "$message"
done <"$here/reject/table" >results
cat results

# Files and table are about the same forgeries.
sed -e '/^#/d' -e '/^$/d' -e 's/ .*//' "$here/reject/table" | LC_ALL=C sort >in-table
(cd "$here/reject" && ls -- *.cert) | sed 's/\.cert$//' | LC_ALL=C sort >on-disk
if cmp -s in-table on-disk; then
  echo "PASS reject-table"
else
  echo "FAIL reject-table: names that are not both in the table and a file: $(comm -3 in-table on-disk | tr -d '\t' | tr '\n' ' ')"
fi
! grep -q '^FAIL' results
