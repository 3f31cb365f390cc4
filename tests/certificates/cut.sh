#!/bin/sh
# Certificates that end too early, at every line and every few bytes, with and without a right hash; and one that is
# too large.
set -u
LC_ALL=C
export LC_ALL
here=$SRCDIR/tests/certificates
scheme=$SRCDIR/lib/catalogue/loop.scheme
good=$here/accept/loop-3.cert

# Appends the right count of records and the right hash.
seal() { # FILE
  echo "records $(wc -l <"$1" | tr -d ' ')" >>"$1"
  digest=$(sha256sum <"$1")
  echo "sha256 ${digest%% *}" >>"$1"
}

check() { # FILE
  "$SMOOTHCERT_CHECK" --scheme "$scheme" --valence 3 --claim c1 "$1" >stdout 2>stderr
  status=$?
}

report() { # NAME, reads complaints from ./complaints
  if [ -s complaints ]; then
    echo "FAIL $1: $(head -n 1 complaints)"
  else
    echo "PASS $1"
  fi
}

lines=$(wc -l <"$good" | tr -d ' ')
bytes=$(wc -c <"$good" | tr -d ' ')

n=0
while [ "$n" -lt "$lines" ]; do
  head -n "$n" "$good" >part
  check part
  case $status:$(cat stderr) in
    "1:rejected: part:$((n + 1)): the file ends too early") ;;
    *) echo "$n lines: exit status $status: $(cat stdout stderr)" ;;
  esac
  n=$((n + 1))
done >complaints
report cut-at-every-line

n=1
while [ "$n" -lt "$((lines - 2))" ]; do
  head -n "$n" "$good" >part
  seal part
  check part
  case $status:$(cat stderr) in
    "1:rejected: part:"*": expected "* | "1:rejected: part:3: scheme: "* | "1:rejected: part:"*": the file ends too early") ;;
    *) echo "$n lines: exit status $status: $(cat stdout stderr)" ;;
  esac
  n=$((n + 1))
done >complaints
report cut-at-every-line-and-sealed

n=0
while [ "$n" -lt "$bytes" ]; do
  head -c "$n" "$good" >part
  check part
  [ "$status" -eq 1 ] && [ ! -s stdout ] || echo "$n bytes: exit status $status: $(cat stdout stderr)"
  n=$((n + 5))
done >complaints
report cut-at-bytes

head -c $((bytes - 1)) "$good" >part
check part
: >complaints
[ "$status" -eq 1 ] || echo "exit status $status" >complaints
report cut-of-the-last-line-feed

# Words of trees of more than a million letters together: cannot check.
: >complaints
sed '/^regularity/,$d' "$good" >large
awk 'BEGIN { s = "0000000000"; while (length(s) < 600000) s = s s; s = substr(s, 1, 600000); print "regularity " s; print "boundary " s }' >>large
seal large
check large
case $status:$(cat stderr) in
  '2:cannot check: large:'*'expected at most 1000000 elements') ;;
  *) echo "exit status $status: $(cat stdout stderr)" >complaints ;;
esac
report too-many-letters

# A file that never ends.
: >complaints
check /dev/zero
[ "$status" -eq 2 ] || echo "exit status $status: $(cat stdout stderr)" >complaints
report endless-file
