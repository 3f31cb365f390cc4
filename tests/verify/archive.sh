#!/bin/sh
# Directories of certificates: what is in them, going on where a run ended, looking at them, packing them, proving again.
set -u
LC_ALL=C
export LC_ALL
loop=$SRCDIR/lib/catalogue/loop.scheme

holds() { # NAME STATUS REASON
  if [ "$2" -eq 0 ]; then echo "PASS archive-$1"; else echo "FAIL archive-$1: $3"; fi
}

# Runs the program: exit status, and what stdout or stderr must contain.
expect() { # NAME STATUS MESSAGE ARGUMENT...
  name=$1 wanted=$2 message=$3
  shift 3
  "$SMOOTHCERT" "$@" >stdout 2>stderr
  status=$?
  case $status:$(cat stdout stderr) in
    "$wanted:"*"$message"*) echo "PASS archive-$name" ;;
    *) echo "FAIL archive-$name: exit status $status, expected $wanted and '$message', found: $(cat stdout stderr | head -n 2 | tr '\n' ' ')" ;;
  esac
}

same() { # NAME FILE FILE
  difference=$(cmp "$2" "$3" 2>&1)
  holds "$1" $? "$difference"
}

description() {
  expect made 0 proved prove loop --valence 3..6 --out a
  [ "$(ls -A a | tr '\n' ' ')" = 'index journal lock runs scheme.scheme valence-3.cert valence-3.log valence-4.cert valence-4.log valence-5.cert valence-5.log valence-6.cert valence-6.log verify.sh ' ]
  holds contents $? "$(ls -A a | tr '\n' ' ')"
  # shellcheck disable=SC2016  # awk's
  (cd a && awk '{ print $2 }' journal | while read -r f; do sha256sum "$f"; done) >sums
  same journal-is-sha256sum a/journal sums
  grep -q '"command":\["smoothcert","prove","loop","--valence","3..6","--out","a"\]}$' a/runs
  holds runs $? "$(cat a/runs)"
  expect again 0 'by the certificate of an earlier run' prove loop --valence 3..7 --out a
  [ "$(wc -l <a/runs)" -eq 2 ] && [ "$(wc -l <a/journal)" -eq 10 ]
  holds again-journal $? "$(wc -l a/runs a/journal)"
}

script() {
  (cd / && SMOOTHCERT_CHECK=$SMOOTHCERT_CHECK "$OLDPWD/a/verify.sh") >stdout 2>stderr
  status=$?
  [ $status -eq 0 ] && [ "$(tail -n 1 stdout)" = '5 verified, 0 rejected, 0 could not be checked, 0 undecided' ]
  holds verify-script $? "exit status $status: $(tail -n 1 stdout) $(cat stderr)"
  cp -r a bad
  sed 's/^halfplane .*/halfplane 1 0/' bad/valence-5.cert >x
  mv x bad/valence-5.cert
  SMOOTHCERT_CHECK=$SMOOTHCERT_CHECK bad/verify.sh >stdout 2>stderr
  status=$?
  [ $status -eq 1 ] && [ "$(tail -n 1 stdout)" = '4 verified, 1 rejected, 0 could not be checked, 0 undecided' ]
  holds verify-script-rejects $? "exit status $status: $(tail -n 1 stdout)"
  rm bad/valence-4.cert
  SMOOTHCERT_CHECK=$SMOOTHCERT_CHECK bad/verify.sh >stdout 2>stderr
  status=$?
  [ $status -eq 1 ] && [ "$(tail -n 1 stdout)" = '3 verified, 1 rejected, 1 could not be checked, 0 undecided' ]
  holds verify-script-misses $? "exit status $status: $(tail -n 1 stdout)"
  SMOOTHCERT_CHECK=./nothing a/verify.sh >stdout 2>stderr
  status=$?
  [ $status -eq 2 ]
  holds verify-script-without-checker $? "exit status $status"
  expect verify-damage 65 'bad/valence-5.cert: not what was finished' archive verify bad
  grep -q 'bad/valence-4.cert: missing' stdout && grep -q 'bad/index: not what is in' stdout && grep -q 'bad/valence-5.cert: line [0-9]*: ' stdout
  holds verify-damage-lines $? "$(cat stdout)"
  expect pack-damage 65 'damaged' archive pack bad
  # Both are made anew, with the same bytes.
  expect mended 0 'is not the one that was finished' prove loop --valence 3..7 --out bad
  for valence in 4 5; do same "mended-$valence" bad/valence-$valence.cert a/valence-$valence.cert; done
  expect mended-verify 0 'bad: loop: 5 certificates hold' archive verify bad
  # A certificate that is as good as the one that was finished is another one all the same.
  "$SMOOTHCERT" prove loop --valence 6 --precision 128 --out other >stdout 2>&1
  cp other/valence-6.cert bad/
  expect exchanged 0 'certificate for valence 6 is not the one that was finished' prove loop --valence 6 --out bad
  same exchanged-mended bad/valence-6.cert a/valence-6.cert
  rm -rf bad other
}

# What a run that was killed may leave.
leftovers() {
  cp -r a left
  head -c 100 a/valence-5.cert >left/unfinished-123-valence-5.cert.tmp
  rm left/valence-5.cert left/index
  printf 'abc' >>left/journal
  grep -v valence-6.cert a/journal >x && mv x left/journal && printf '0123  valence-6' >>left/journal
  expect leftovers-verify 65 'left/journal: a line is cut off' archive verify left
  expect leftovers 0 proved prove loop --valence 3..7 --out left
  for f in index scheme.scheme valence-3.cert valence-4.cert valence-5.cert valence-6.cert valence-7.cert; do same "leftovers-$f" left/$f a/$f; done
  [ "$(ls -A left | tr '\n' ' ')" = "$(ls -A a | tr '\n' ' ')" ]
  holds leftovers-contents $? "$(ls -A left | tr '\n' ' ')"
  sort -k 2 -u a/journal >x
  sed 's/^[0-9a-f]*  \(.*log\)/\1/' x >sorted
  sort -k 2 -u left/journal | sed 's/^[0-9a-f]*  \(.*log\)/\1/' >sorted-left
  same leftovers-journal sorted-left sorted
  rm -rf left
}

other_claims() {
  sed 's/^scheme .*/scheme other/' "$loop" >other.scheme
  expect other-scheme 65 'a holds evidence for another scheme' prove other.scheme --valence 3 --out a
  expect other-parameter 0 proved prove modified-loop --set a=7/8 --valence 4 --out parameter
  expect other-parameter-refused 65 'another scheme' prove modified-loop --set a=15/16 --valence 4 --out parameter
  cp -r a nameless
  rm nameless/scheme.scheme
  expect no-scheme 65 'holds certificates but no scheme.scheme' prove loop --valence 3 --out nameless
  expect no-archive 65 'no archive here' archive list .
  expect no-directory 65 'no archive here' archive list nowhere
  rm -rf other.scheme parameter nameless
}

# The second of two runs on one directory is refused; whoever is killed leaves no lock.
two_runs() {
  "$SMOOTHCERT" prove butterfly --valence 100..100000 --out busy >first 2>&1 &
  process=$!
  tries=0
  while [ ! -s first ] && [ $tries -lt 100 ]; do sleep 0.1; tries=$((tries + 1)); done
  expect busy 74 'busy: another run is at work there' prove butterfly --valence 5 --out busy
  expect busy-list 0 'busy: butterfly' archive list busy
  kill -9 $process
  wait $process 2>/dev/null
  expect not-busy-any-more 0 proved prove butterfly --valence 5 --out busy
  expect not-busy-verify 0 'certificates hold' archive verify busy
  rm -rf busy first
}

# Ranges of valences are entries like others; nobody follows these here, for they are only heads of certificates.
ranges() {
  cp -r a ranges
  { head -n 16 a/valence-7.cert; } | sed 's/^claim.*/claim c1/' >head
  scheme_lines=$(sed -n 's/^scheme \([0-9]*\)$/\1/p' a/valence-7.cert)
  head -n $((scheme_lines + 2)) a/valence-7.cert >head
  { cat head; printf 'claim c1\nvalence 8 20\ngrid 64\n'; } >ranges/valence-8..20.cert
  { cat head; printf 'claim c1\nvalence 21 inf\ngrid 64\n'; } >ranges/valence-21..inf.cert
  echo '{}' >ranges/valence-9.log
  echo '{}' >ranges/valence-30..40.log
  expect ranges-list 0 'proved     3..inf' archive list ranges
  expect ranges-index 0 proved prove loop --valence 3 --out ranges
  [ "$(sed 's/ [0-9a-f]\{64\} / HASH /' ranges/index | tail -n 3 | tr '\n' ';')" = '7 proved HASH valence-7.cert;8..20 proved HASH valence-8..20.cert;21..inf proved HASH valence-21..inf.cert;' ]
  holds ranges-lines $? "$(cat ranges/index)"
  { cat head; printf 'claim not-c1\nvalence 6 7\ngrid 64\n'; } >ranges/valence-6..7.cert
  expect contradiction 70 'certificates for 6..7 and for 6 contradict each other' prove loop --valence 3 --out ranges
  expect contradiction-verify 70 'contradict each other' archive verify ranges
  expect contradiction-diff 70 'contradict each other' archive diff a ranges
  # A file whose name is not its claim is no evidence.
  mv ranges/valence-6..7.cert ranges/valence-6..8.cert
  expect misnamed 65 'valence-6..8.cert: ' archive verify ranges
  rm -rf ranges head
}

# A damaged certificate of a range, whose place others take: it is announced, moved aside, and speaks of nothing any more.
damaged_ranges() {
  scheme=$SRCDIR/tests/verify/schemes/loop-sixteenth.scheme
  "$SMOOTHCERT" prove "$scheme" --valence all --out whole >stdout 2>&1
  for damage in changed truncated empty renamed; do
    rm -rf broken && cp -r whole broken
    file=valence-80..111.cert
    case $damage in
      changed) sed 's/^claim not-c1/claim c1/' whole/$file >broken/$file ;;
      truncated) head -c 100 whole/$file >broken/$file ;;
      empty) : >broken/$file ;;
      renamed) file=valence-1000..2000.cert; cp whole/valence-62..79.cert broken/$file ;;
    esac
    cp broken/$file before
    expect "range-$damage" 1 "; it is now $file.damaged" prove "$scheme" --valence all --out broken
    [ "$(wc -l <stderr)" -eq 1 ]
    holds "range-$damage-one-message" $? "$(cat stderr)"
    [ ! -e broken/$file ] && cmp -s before broken/$file.damaged
    holds "range-$damage-aside" $? "$(ls broken)"
    expect "range-$damage-verify" 0 'certificates hold' archive verify broken
    # What it claims from 20 on, the checker wants about each valence once.
    rm -rf part && mkdir part && cp broken/valence-[2-9][0-9]*.cert broken/valence-1[0-9][0-9]*.cert part/
    "$SMOOTHCERT_CHECK" --scheme "$scheme" --valence 20..inf --claim not-c1 part >stdout 2>stderr
    holds "range-$damage-checker" $? "$(tail -n 1 stdout) $(cat stderr)"
    expect "range-$damage-again" 1 'not C1' prove "$scheme" --valence all --out broken
    [ ! -s stderr ]
    holds "range-$damage-again-silent" $? "$(cat stderr)"
  done
  # Good ones may speak of a valence twice, too: nobody can say which of them is wanted.
  "$SMOOTHCERT" prove "$scheme" --valence 79 --out single >stdout 2>&1
  cp single/valence-79.cert whole/
  expect range-twice 64 'valence-79.cert and the certificate of 62..79 speak of a valence twice' prove "$scheme" --valence all --out whole
  rm -rf whole broken part single before
}

# Directories of earlier versions of the program: without journal, with certificates of format 0.
old_archives() {
  cp -r a old
  rm old/journal old/runs old/lock old/verify.sh
  expect old-layout-verify 0 'old: loop: 5 certificates hold' archive verify old
  expect old-layout 0 'by the certificate of an earlier run' prove loop --valence 3..7 --out old
  for valence in 3 7; do same "old-layout-$valence" old/valence-$valence.cert a/valence-$valence.cert; done
  expect old-layout-mended 0 'old: loop: 5 certificates hold' archive verify old
  [ "$(wc -l <old/journal)" -eq 10 ]
  holds old-layout-journal $? "$(wc -l <old/journal) lines"
  rm -rf old
  "$SMOOTHCERT" prove loop --valence 7 --out old >stdout 2>&1
  for valence in 3 4 5; do cp "$SRCDIR/tests/certificates/accept/loop-$valence.cert" old/valence-$valence.cert; done
  rm old/index
  "$SMOOTHCERT" prove loop --valence 7 --out old >stdout 2>&1
  expect old-format-verify 0 'old: loop: 1 certificates hold, 3 of an old format are left to smoothcert-check' archive verify old
  SMOOTHCERT_CHECK=$SMOOTHCERT_CHECK old/verify.sh >stdout 2>&1
  [ "$(tail -n 1 stdout)" = '4 verified, 0 rejected, 0 could not be checked, 0 undecided' ]
  holds old-format-script $? "$(tail -n 1 stdout)"
  expect old-format-diff 1 'valence 3: proved (format 0, grid 2^-64); proved (format 1, grid 2^-64); other choices' archive diff old a
  expect old-format-list 0 'format     1 and older, from 0' archive list old
  expect old-format-anew 0 proved prove loop --valence 3..7 --out old
  same old-format-anew-bytes old/valence-3.cert a/valence-3.cert
  rm -rf old
}

looking() {
  expect list 0 'proved     3..7' archive list a
  expect list-json 0 '"scheme":"loop","directory":"a","proved":"3..7","refuted":"","undecided":""' archive list a --json
  expect verify 0 'a: loop: 5 certificates hold' archive verify a
  expect verify-json 0 '{"scheme":"loop","hold":5,"old":0,"troubles":0,"directory":"a"}' archive verify a --json
  "$SMOOTHCERT" prove loop --valence 3..4,6..8 --precision 128 --out b >stdout 2>&1
  "$SMOOTHCERT" prove loop --valence 5 --max-level 1 --precision 64 --time-limit 0.000001 --out b >stdout 2>&1
  cp a/valence-7.cert b/
  expect diff 1 'valence 3: proved (format 1, grid 2^-64); proved (format 1, grid 2^-128); other choices' archive diff a b
  grep -qx 'valence 8: nothing; proved (format 1, grid 2^-128)' stdout && grep -qx 'valence 5: proved (format 1, grid 2^-64); undecided' stdout
  holds diff-lines $? "$(cat stdout)"
  expect diff-same 0 '5 the same, 0 different, 0 only in a, 0 only in a' archive diff a a
  "$SMOOTHCERT" prove catmull-clark --valence 3 --out c >stdout 2>&1
  expect diff-schemes 1 'different schemes' archive diff a c
  expect show-directory 0 'a/valence-6.cert: loop is C1 at valence 6' show a
  expect show 0 'L = 0.53087245046468334 +/- ' show a/valence-7.cert
  expect show-json 0 '"scheme":"loop","valence":"7","claim":"c1","format":1,"grid":64,"eigenvalue":"0.53087' show a/valence-7.cert --json
  expect show-refuted 0 'butterfly is not C1 at valence 8' show "$SRCDIR/tests/certificates/accept-1/butterfly-8.cert"
  expect show-complex 0 'complex form' show "$SRCDIR/tests/certificates/accept-1/loop-spiral-5.cert"
  expect show-fold 0 'the Jacobian is negative on element' show "$SRCDIR/tests/certificates/accept-1/doo-sabin-fold-3.cert"
  expect show-winding 0 'it winds -4 times round the extraordinary point' show "$SRCDIR/tests/certificates/accept-1/winding-quad-5.cert"
  expect show-pair 0 'of block 0 (complex form, order 6)' show "$SRCDIR/tests/certificates/accept-1/pair-cups-5.cert"
  expect show-old 0 'claims that loop is C1 at valence 3' show "$SRCDIR/tests/certificates/accept/loop-3.cert"
  sed 's/^valence 7/valence 8/' a/valence-7.cert >lie.cert
  expect show-lie 65 'lie.cert: claims that loop is C1 at valence 8' show lie.cert
  grep -q 'followed        no: line' stdout
  holds show-lie-followed $? "$(tail -n 1 stdout)"
  expect show-scheme 65 'this is not a certificate' show "$loop"
  expect show-missing 74 'nothing.cert' show nothing.cert
  rm -rf b c
}

rerunning() {
  expect rerun 0 'still proved: loop is C1 at valence 7; grid 64 -> 256, L +/- 7.2e-15 -> 2.' rerun a/valence-7.cert --precision 256
  grep -q 'tighter: L' stdout
  holds rerun-tighter $? "$(cat stdout)"
  expect rerun-own-precision 0 'grid 64 -> 64' rerun a/valence-7.cert
  expect rerun-directory 0 'still proved: loop is C1 at valence 6' rerun a
  [ "$(wc -l <stdout)" -eq 5 ]
  holds rerun-directory-lines $? "$(wc -l <stdout) lines"
  expect rerun-refuted 1 'still refuted: butterfly is not C1 at valence 8' rerun "$SRCDIR/tests/certificates/accept-1/butterfly-8.cert"
  expect rerun-old 0 'proved anew: loop is C1 at valence 3' rerun "$SRCDIR/tests/certificates/accept/loop-3.cert"
  expect rerun-json 0 '"tighter":{"eigenvalue":true,' rerun a/valence-5.cert --precision 128 --json
  expect rerun-lie 65 'lie.cert: this certificate does not prove what it states' rerun lie.cert
  # Re-hashed, with choices that prove nothing: what holds is found anew, and the certificate blamed.
  rehash() { sed '$d' "$1" >body; { cat body; echo "sha256 $(sha256sum body | sed 's/ .*//')"; } >lie.cert; }
  sed 's/^halfplane .*/halfplane -1 0/' a/valence-7.cert >x
  rehash x
  expect rerun-wrong-choices 65 'proved anew: loop is C1 at valence 7 (its own choices do not prove it)' rerun lie.cert
  sed -e 's/^claim c1/claim not-c1/' -e 's/^form/reason fold\nfrequency 1\nform/' a/valence-7.cert >x
  rehash x
  expect rerun-false-claim 65 'does not prove what it states' rerun lie.cert
  expect rerun-out 0 'grid 64 -> 128' rerun a --precision 128 --out finer
  expect rerun-out-verify 0 'finer: loop: 5 certificates hold' archive verify finer
  expect rerun-out-other-scheme 65 'another scheme' rerun a/valence-3.cert "$SRCDIR/tests/certificates/accept-1/butterfly-8.cert" --out finer
  expect rerun-nothing 64 'no certificate given' rerun
  expect rerun-precision 64 '--precision' rerun a --precision 63
  expect rerun-help 0 'Usage: smoothcert rerun' rerun --help
  expect show-help 0 'Usage: smoothcert show' show --help
  expect archive-help 0 'Usage: smoothcert archive' archive --help
  rm -rf finer lie.cert body x
}

packing() {
  "$SMOOTHCERT" archive pack a >a.tar 2>stderr
  holds pack $? "$(cat stderr)"
  expect pack-out 0 '' archive pack a --out b.tar
  same pack-same-bytes a.tar b.tar
  mkdir unpacked && tar -C unpacked -xf a.tar 2>stderr
  holds unpack $? "$(cat stderr)"
  expect unpacked-verify 0 'loop: 5 certificates hold' archive verify unpacked/smoothcert-loop
  SMOOTHCERT_CHECK=$SMOOTHCERT_CHECK unpacked/smoothcert-loop/verify.sh >stdout 2>&1
  holds unpacked-script $? "$(tail -n 1 stdout)"
  # Without logs it does not matter when and how often somebody has worked there.
  "$SMOOTHCERT" prove loop --valence 7,3..6 --out again >stdout 2>&1
  "$SMOOTHCERT" archive pack a --without-logs >a.tar
  "$SMOOTHCERT" archive pack again --without-logs >b.tar
  same pack-without-logs a.tar b.tar
  expect pack-two 64 'one directory' archive pack a a
  expect pack-nowhere 74 'no/b.tar' archive pack a --out no/b.tar
  if [ -c /dev/full ]; then
    "$SMOOTHCERT" archive pack a >/dev/full 2>stderr
    status=$?
    [ $status -eq 74 ]
    holds pack-full $? "exit status $status"
  fi
  expect part-missing 64 'expected list, verify, diff or pack' archive
  expect part-unknown 64 "found 'check'" archive check a
  expect diff-one 64 'two directories' archive diff a
  rm -rf unpacked again a.tar b.tar
}

mkdir work && cd work || exit 1
{
  description
  script
  leftovers
  other_claims
  two_runs
  ranges
  damaged_ranges
  old_archives
  looking
  rerunning
  packing
} >../results
cat ../results
! grep -q '^FAIL' ../results
