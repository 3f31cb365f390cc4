#!/bin/sh
# Proofs for many valences at once: what `prove` says of ranges, what it writes, and that smoothcert-check agrees.
set -u
LC_ALL=C
export LC_ALL

# The last line of a run, and its status.  Nothing may be on stderr.
summary() { # NAME STATUS LINE ARGUMENT...
  name=$1 wanted=$2 line=$3
  shift 3
  "$SMOOTHCERT" prove "$@" >stdout 2>stderr
  status=$?
  if [ $status -ne "$wanted" ]; then
    echo "FAIL ranges-$name: exit status $status instead of $wanted: $(cat stdout stderr | tail -n 1)"
  elif [ -s stderr ]; then
    echo "FAIL ranges-$name: something is on stderr: $(head -n 1 stderr)"
  elif [ "$(tail -n 1 stdout)" != "$line" ]; then
    echo "FAIL ranges-$name: expected '$line', found '$(tail -n 1 stdout)'"
  else
    echo "PASS ranges-$name"
  fi
}

refused() { # NAME MESSAGE ARGUMENT...
  name=$1 message=$2
  shift 2
  "$SMOOTHCERT" prove "$@" --out none >stdout 2>stderr
  status=$?
  if [ $status -eq 64 ] && [ ! -s stdout ] && grep -qF -e "$message" stderr; then
    echo "PASS ranges-$name"
  else
    echo "FAIL ranges-$name: exit status $status: $(cat stdout stderr | head -n 1)"
  fi
}

holds() { # NAME WAS-IT-SO REASON
  if [ "$2" -eq 0 ]; then echo "PASS ranges-$1"; else echo "FAIL ranges-$1: $3"; fi
}

# Every certificate of a directory, which together are to speak of these valences.
verifies() { # NAME SCHEME VALENCES CLAIM DIRECTORY
  "$SMOOTHCERT_CHECK" --scheme "$SRCDIR/lib/catalogue/$2.scheme" --valence "$3" --claim "$4" "$5" >printed 2>complaints
  holds "$1" $? "$(cat printed complaints | grep -v '^verified' | head -n 1)"
}

# ---- the catalogue, for all valences ----

# SCHEME BOXES: `boxes` has no bad number, but what is proved in a few must not need many.
all_valences() {
  summary "all-$1" 0 "$1, in $2 boxes: C1: 3..inf" "$1" --valence all --out "all-$1"
  verifies "all-$1-checked" "$1" all c1 "all-$1"
}

all_valences loop 7
all_valences loop-warren 7
all_valences modified-loop 7
all_valences modified-butterfly 12
all_valences catmull-clark 14
all_valences doo-sabin 9
all_valences midpoint 9
all_valences kobbelt 20
all_valences wave 12

# Block 0 of Catmull-Clark's scheme tends to block 1.
grep -q '^limit ' all-catmull-clark/valence-*..inf.cert
holds limit $? 'no limit in the certificate that speaks of infinity'
! grep -q '^limit ' all-loop/valence-*..inf.cert
holds no-limit $? 'a limit where none is needed'
grep -q '^rise ' all-loop/valence-*..inf.cert && ! grep -q '^rise ' all-modified-butterfly/valence-*..inf.cert
holds rise $? 'a chain belongs where weights do not depend on frequencies, and only there'

# ---- some proved, some refuted ----

summary butterfly 1 'butterfly, in 7 boxes: C1: 4..7; not C1: 3 (jordan), 8..inf (frequency)' butterfly --valence all --out butterfly
verifies butterfly-c1 butterfly 4..7 c1 butterfly
verifies butterfly-not-c1 butterfly 8..inf not-c1 butterfly
"$SMOOTHCERT_CHECK" --scheme "$SRCDIR/lib/catalogue/butterfly.scheme" --valence 4..8 --claim c1 butterfly >printed 2>&1
[ $? -eq 1 ]
holds butterfly-not-8 $? "$(tail -n 1 printed)"

# Where a refutation holds for one reason, it is made for many valences at once.
verified() { # NAME DIRECTORY: all certificates, as its verify.sh says.
  SMOOTHCERT_CHECK=$SMOOTHCERT_CHECK sh "$2/verify.sh" >printed 2>complaints
  holds "$1" $? "$(tail -n 1 printed)"
}

classified() { # NAME LINE SCHEME ARGUMENT...
  name=$1 line=$2
  shift 2
  summary "$name" 1 "$line" "$@" --valence all --out "refuted-$name"
  verified "$name-checked" "refuted-$name"
}

own=$SRCDIR/tests/verify/schemes
classified sixteenth 'loop-sixteenth, in 27 boxes: C1: 5..19; not C1: 3, 20..25 (frequency 0), 4 (tie), 26..inf (not-C0)' "$own/loop-sixteenth.scheme"
classified quad-eighth 'quad-eighth, in 17 boxes: C1: 3..9; not C1: 10..12 (frequency 0), 13..inf (not-C0)' "$own/quad-eighth.scheme"
classified smooth-grows 'smooth-grows, in 21 boxes: C1: 4..14; not C1: 3, 15..18 (frequency 0), 19..inf (not-C0)' "$own/smooth-grows.scheme"
classified steps-grow 'steps-grow, in 44 boxes: C1: 3..15; not C1: 16..18 (frequency 0), 19..inf (not-C0)' "$own/steps-grow.scheme"
classified two-turns 'two-turns, in 10 boxes: C1: 3; not C1: 4 (real), 5..inf (frequency)' "$own/two-turns.scheme"
classified heavy 'centre-powers, in 2 boxes: not C1: 3..inf (frequency 0)' "$own/centre-powers.scheme" --set a=31/25
classified heavy-negative 'centre-powers, in 2 boxes: not C1: 3..inf (frequency 0)' "$own/centre-powers.scheme" --set a=-1/2
classified beyond 'centre-powers, in 2 boxes: not C1: 3..inf (not-C0)' "$own/centre-powers.scheme" --set a=3/2
classified beyond-negative 'centre-powers, in 2 boxes: not C1: 3..inf (not-C0)' "$own/centre-powers.scheme" --set a=-1
classified squares 'centre-powers, in 16 boxes: C1: 5..11; not C1: 3..4, 12 (frequency 0), 13..inf (not-C0)' "$own/centre-powers.scheme" --set a=1 --set c=-1/100
classified squares-positive 'centre-powers, in 6 boxes: not C1: 3..inf (not-C0)' "$own/centre-powers.scheme" --set a=-1 --set b=1/2 --set c=1/10
classified folds 'doo-sabin-spectrum, in 24 boxes: C1: 4, 38..inf; not C1: 3, 5..37 (fold)' doo-sabin-spectrum --set l=999/1000
grep -q '^form graded$' refuted-sixteenth/valence-*..inf.cert && grep -q '^degree 2$' refuted-squares/valence-*..inf.cert
holds graded $? 'a centre that grows has no graded certificate'
grep -q '^frequency 2$' refuted-two-turns/valence-*..inf.cert && grep -q '^reason fold$' refuted-folds/valence-*..*.cert
holds one-frequency $? 'no certificate of one frequency, or of a fold, for many valences'

# Each range says of each of its valences what is found there alone.
each() { # the verdict of every valence up to 150 that lines speak of
  sed -n 's/^\(proved\|refuted\): .* at valences* \([0-9]*\)\(\.\.\)*\([0-9a-z]*\);.*/\1 \2 \4/p' |
    awk '{ last = $3 == "" ? $2 : $3 == "inf" || $3 > 150 ? 150 : $3; for (k = $2; k <= last; k++) print k, $1 }'
}
alike() { # NAME SCHEME ARGUMENT...
  name=$1
  shift
  "$SMOOTHCERT" prove "$@" --valence all --out none 2>/dev/null | each >ranges
  "$SMOOTHCERT" prove "$@" --valence 3..150 --each --out none 2>/dev/null | each >singles
  cmp -s ranges singles && [ "$(wc -l <singles)" -eq 148 ]
  holds "$name" $? "$(diff ranges singles | head -n 2 | tail -n 1)"
}
alike sixteenth-alike "$own/loop-sixteenth.scheme"
alike quad-eighth-alike "$own/quad-eighth.scheme"
alike smooth-grows-alike "$own/smooth-grows.scheme"
alike steps-grow-alike "$own/steps-grow.scheme"
alike two-turns-alike "$own/two-turns.scheme"
alike squares-alike "$own/centre-powers.scheme" --set a=1 --set c=-1/100
alike folds-alike doo-sabin-spectrum --set l=999/1000

# What is said of them: with the factor of the scaled eigenvalue, and found anew.
"$SMOOTHCERT" show refuted-sixteenth/valence-112..inf.cert >printed 2>complaints
grep -q 'L = (-0.95.*) (k/16)$' printed && grep -q '^  growth ' printed && grep -q 'followed  *yes' printed
holds show-growth $? "$(head -n 1 printed complaints)"
"$SMOOTHCERT" rerun refuted-sixteenth/valence-112..inf.cert refuted-two-turns/valence-30..inf.cert refuted-folds/valence-33..35.cert refuted-heavy/valence-4..inf.cert >printed 2>complaints
[ "$(grep -c '^still refuted: .* L +/- ' printed)" -eq 4 ]
holds rerun-refutations $? "$(cat printed complaints)"
"$SMOOTHCERT" prove "$own/loop-sixteenth.scheme" --valence all --out none --json 2>/dev/null | tail -n 1 >printed
grep -qF '{"valences":[20,25],"reason":"frequency 0"},{"valences":[26,26],"reason":"modulus-one"},{"valences":[27,null],"reason":"not-c0"}' printed
holds json-reasons $? "$(cat printed)"

# ---- what may be asked ----

summary parts 0 'loop, in 3 boxes: C1: 3, 8..inf' loop --valence 3,8..inf --out none
summary finite 0 'loop, in 7 boxes: C1: 3..200000' loop --valence 3..200000 --out none
refused backwards "--valence inf..8: " loop --valence inf..8
refused each '--each examines at most' loop --valence 3..200000 --each
refused each-of-all '--each examines at most' loop --valence all --each
refused asymmetric 'mirror-symmetric' loop-spiral --valence all
refused too-large "'inf'" loop --valence 3..1000000001

# ---- JSON ----

"$SMOOTHCERT" prove loop --valence all --out none --json >printed 2>complaints
holds json-status $? "$(head -n 1 complaints)"
tail -n 1 printed | grep -qxF '{"scheme":"loop","boxes":7,"c1":[[3,null]],"not_c1":[],"undecided":[]}'
holds json-summary $? "$(tail -n 1 printed)"
grep -q '"valences":\[16,null\],"verdict":"proved"' printed
holds json-box $? "$(tail -n 2 printed | cut -c 1-100 | head -n 1)"

# ---- going on, and what others wrote ----

cp all-loop/valence-16..inf.cert before 2>/dev/null
summary again 0 'loop, in 7 boxes: C1: 3..inf' loop --valence all --out all-loop
cmp -s before all-loop/valence-16..inf.cert
holds again-same $? 'the certificate was written anew'
sed 's/^valence 16 inf$/valence 15 inf/' before >all-loop/valence-16..inf.cert
"$SMOOTHCERT" prove loop --valence all --out all-loop >stdout 2>stderr && grep -q 'made anew' stderr && cmp -s before all-loop/valence-16..inf.cert
holds mended $? "$(tail -n 1 stderr)"
verifies mended-checked loop all c1 all-loop

# Certificates that are there already stay, and boxes fill the gaps: each valence is spoken of once.
"$SMOOTHCERT" prove loop --valence 9..12,30 --out gaps >stdout 2>stderr
summary gaps 0 'loop, in 12 boxes: C1: 3..inf' loop --valence all --out gaps
verifies gaps-checked loop all c1 gaps
"$SMOOTHCERT" prove loop --valence 9..inf --out all-loop >stdout 2>stderr
verifies middle-of-a-box loop all c1 all-loop
"$SMOOTHCERT" prove loop --valence 6,7 --out all-loop >stdout 2>stderr
[ "$(cut -d ';' -f 1 stdout)" = 'proved: loop is C1 at valences 6..7' ]
holds told-once $? "$(cat stdout)"

# What cannot be used (other methods, other precisions) is not doubled; by default it has another place.
ls all-loop >before-conflict
for options in '--valence 7 --precision 128' '--valence all --method uniform'; do
  # shellcheck disable=SC2086
  "$SMOOTHCERT" prove loop $options --out all-loop >stdout 2>stderr
  [ $? -eq 64 ] && grep -q 'cannot use valence-6..7.cert' stderr
  holds "conflict-${options##* }" $? "$(tail -n 1 stderr)"
done
ls all-loop | cmp -s - before-conflict
holds conflict-leaves-all $? "$(ls all-loop | tr '\n' ' ')"
verifies conflict-checked loop all c1 all-loop
"$SMOOTHCERT" prove loop --valence 5 --precision 128 --method uniform >stdout 2>stderr && [ -f smoothcert-loop,uniform,precision=128/valence-5.cert ]
holds other-place $? "$(tail -n 1 stdout)"

# ---- forgeries ----

# A certificate with changes, and with counts and a sum that are right; $? is the answer of the checker.
sign() { # VALENCES EDIT
  sed "$2" before | awk '/^sha256 / { next } /^records / { print "records", NR - 1; next } { print }' >forged
  printf 'sha256 %s\n' "$(sha256sum <forged | cut -d ' ' -f 1)" >>forged
  "$SMOOTHCERT_CHECK" --scheme "$SRCDIR/lib/catalogue/loop.scheme" --valence "$1" --claim c1 forged >printed 2>&1
}

sign 16..inf ''
holds signed $? "$(tail -n 1 printed)"

forged() { # NAME VALENCES EDIT
  sign "$2" "$3"
  [ $? -eq 1 ]
  holds "forged-$1" $? "$(tail -n 1 printed)"
}

forged smaller-valences 15..inf 's/^valence 16 inf$/valence 15 inf/'
forged three-and-more all 's/^valence 16 inf$/valence 3 inf/'
forged another-claim 15..inf ''
forged rho-for-rho_R 16..inf '/^range /s/ .*/ 1/'
forged no-chain 16..inf '/^rise /,/^cover /{/^cover /!d;}'
forged another-end 16..inf '/^cover /s/ 800000000000 / 7fffffffffff /'
forged a-hole 16..inf '0,/^cover /{/^cover /d;}'
forged from-3-on 16..inf 's/^cover 2 inf /cover 3 inf /'

# One valence of a range that is proved already needs no certificate of its own.
"$SMOOTHCERT" prove loop --valence all --out whole >/dev/null
ls whole >before
"$SMOOTHCERT" prove loop --valence 10,1000 --out whole >stdout 2>stderr
ls whole >after
[ "$(grep -c 'by the certificate of an earlier run' stdout)" -eq 2 ] && [ ! -s stderr ] && cmp -s before after
holds within-a-range $? "$(head -n 1 stdout stderr)"
# The reference method steps through ranges, too.
"$SMOOTHCERT" prove loop --valence all --method uniform --out none >stdout 2>stderr
[ $? -eq 0 ] && tail -n 1 stdout | grep -q 'C1: 3..inf; uniform method: nets up to'
holds uniform $? "$(tail -n 1 stdout)"
# Claims that are not made of several valences are not followed: none of their tests would run.
"$SMOOTHCERT" prove butterfly --valence 8 --out eight >/dev/null
for edit in 's/^valence 8$/valence 8 20/' 's/^valence 8$/valence 8 20/;s/^radius .*/&\nrange 1000000000000/'; do
  sed "$edit" eight/valence-8.cert | awk '/^sha256 / { next } /^records / { print "records", NR - 1; next } { print }' >forged
  printf 'sha256 %s\n' "$(sha256sum <forged | cut -d ' ' -f 1)" >>forged
  "$SMOOTHCERT" show forged >stdout 2>&1
  ! grep -q 'followed  *yes' stdout
  holds "claim-of-one-valence-$(wc -l <forged)" $? "$(grep followed stdout)"
done
# Balls, and certificates of ranges proved anew with more bits.
"$SMOOTHCERT" prove loop --valence 16..inf --precision 128 --out none >stdout 2>stderr
tail -n 1 stdout | grep -q '^loop, in 1 box: C1: 16..inf$'
holds balls $? "$(tail -n 1 stdout)"
"$SMOOTHCERT" rerun whole/valence-16..inf.cert --precision 128 >stdout 2>stderr
[ $? -eq 0 ] && grep -q 'still proved: loop is C1 at valences 16..inf; grid 64 -> 128, ' stdout
holds rerun $? "$(cat stdout stderr)"
