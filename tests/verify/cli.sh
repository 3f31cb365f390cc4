#!/bin/sh
# The program's commands: what they print, where, and with which exit status.
set -u
LC_ALL=C
export LC_ALL
loop=$SRCDIR/lib/catalogue/loop.scheme

# Runs the program; what it prints must contain MESSAGE: on stdout if the status is to be 0 or 2, else on stderr, with
# nothing on stdout.
expect() { # NAME STATUS MESSAGE ARGUMENT...
  name=$1 wanted=$2 message=$3
  shift 3
  "$SMOOTHCERT" "$@" >stdout 2>stderr
  status=$?
  judge
}

judge() {
  if [ "$wanted" -le 2 ]; then where=stdout; else where=stderr; fi
  if [ "$status" -ne "$wanted" ]; then
    echo "FAIL cli-$name: exit status $status instead of $wanted: $(cat stdout stderr | head -n 1)"
  elif [ "$wanted" -gt 2 ] && [ -s stdout ]; then
    echo "FAIL cli-$name: something is on stdout: $(head -n 1 stdout)"
  elif [ "$wanted" -gt 2 ] && [ "$(wc -l <stderr)" -ne 1 ]; then
    echo "FAIL cli-$name: $(wc -l <stderr) lines on stderr, not one"
  elif [ "$wanted" -le 2 ] && [ -s stderr ]; then
    echo "FAIL cli-$name: something is on stderr: $(head -n 1 stderr)"
  else
    case $(cat $where) in
      *"$message"*) echo "PASS cli-$name" ;;
      *) echo "FAIL cli-$name: expected '$message', found '$(head -n 1 $where)'" ;;
    esac
  fi
}

same() { # NAME FILE FILE
  if difference=$(cmp "$2" "$3" 2>&1); then echo "PASS cli-$1"; else echo "FAIL cli-$1: $difference"; fi
}

# A condition that was tested just before.
holds() { # NAME STATUS REASON
  if [ "$2" -eq 0 ]; then echo "PASS cli-$1"; else echo "FAIL cli-$1: $3"; fi
}

# Only these names may be in the directory.
contents() { # NAME DIRECTORY FILE...
  name=$1
  directory=$2
  shift 2
  # shellcheck disable=SC2012  # these names are simple
  found=$(cd "$directory" && ls -A | tr '\n' ' ')
  [ "$found" = "$* " ]
  holds "$name" $? "the directory holds $found"
}

commands() {
  expect no-command 64 'no command given'
  expect unknown-command 64 "unknown command 'proof'" proof
  expect unknown-option 64 '--verbose' --verbose
  expect help 0 'Usage: smoothcert COMMAND' --help
  expect version 0 'certificate format 1' --version
  expect version-name 0 'smoothcert ' --version
  expect prove-help 0 'Usage: smoothcert prove' prove --help
  expect schemes-help 0 'Usage: smoothcert schemes' schemes --help
  expect help-alone 0 'Usage: smoothcert COMMAND' help
  expect help-short 0 'Usage: smoothcert COMMAND' -h
  expect help-of-command 0 'Usage: smoothcert regular' help regular
  expect help-of-command-short 0 'Usage: smoothcert spectrum' spectrum -h
  expect schemes 0 loop schemes
  expect schemes-loop 0 'scheme loop' schemes loop
  same schemes-loop-is-the-file stdout "$loop"
  expect schemes-unknown 65 "'lopp'" schemes lopp
  expect schemes-empty-name 65 "''" schemes ''
  expect schemes-two 64 'one name' schemes loop loop
  expect schemes-option 64 '--all' schemes --all
}

usage_of_prove() {
  expect no-scheme 64 'no scheme given' prove --valence 3
  expect two-schemes 64 'more than one scheme' prove loop loop --valence 3
  expect no-valence 64 'no valences given' prove loop
  expect value-missing 64 '--valence' prove loop --valence
  expect unknown-prove-option 64 '--fast' prove loop --valence 3 --fast
  for list in '' 2 5..4 1000000001 3..1000000001 3,,4 '3,' inf inf..8 3..x 3-5 ' 3' 99999999999999999999; do
    expect "valence-'$list'" 64 "--valence $list: " prove loop --valence "$list" --out none
  done
  for bits in '' 63 0 -64 8193 x 64x 1e3 99999999999999999999; do
    expect "precision-'$bits'" 64 '--precision: expected a number of bits' prove loop --valence 3 --out none --precision "$bits"
  done
  for bits in '' -1 8193 x; do
    expect "max-precision-'$bits'" 64 '--max-precision: expected a number of bits' prove loop --valence 3 --out none --max-precision "$bits"
  done
  for level in '' 0 61 -1 x; do
    expect "max-level-'$level'" 64 '--max-level: expected a number' prove loop --valence 3 --out none --max-level "$level"
  done
  for method in '' thesis Uniform; do
    expect "method-'$method'" 64 "--method: expected 'adaptive' or 'uniform'" prove loop --valence 3 --out none --method "$method"
  done
  expect method-uniform-on-quads 64 '--method uniform is for triangle meshes only' prove catmull-clark --valence 3 --out none --method uniform
  contents bad-usage-leaves-nothing . stderr stdout
}

answers() {
  expect proved 0 'proved: loop is C1 at valence 3; ' prove loop --valence 3 --out none
  expect proved-list 0 'proved: loop is C1 at valence 9; ' prove loop --valence 9,3..5 --out none
  [ "$(sed 's/;.*//' stdout | tr '\n' ' ')" = 'proved: loop is C1 at valence 3 proved: loop is C1 at valence 4 proved: loop is C1 at valence 5 proved: loop is C1 at valence 9 ' ]
  holds one-line-each $? "found $(sed 's/;.*//' stdout | tr '\n' ' ')"
  expect proved-with-balls 0 'balls of 128 bits' prove loop --valence 7 --precision 128 --out none
  expect proved-with-intervals 0 'double intervals' prove loop --valence 7 --max-precision 0 --out none
  expect proved-adaptively 0 'Jacobian > 0.313, level 0, 5 elements' prove loop --valence 7 --out none --method adaptive
  expect proved-uniformly 0 'uniform level 2, 48 elements (adaptive: level 0, 5 elements)' prove loop --valence 7 --out none --method uniform
  expect proved-uniformly-json 0 '"method":"uniform","level":0,"elements":5,"uniform_level":2,"uniform_elements":48' \
    prove loop --valence 7 --out none --method uniform --json
  expect options-before 0 'proved: loop is C1 at valence 3; ' prove --out none --valence=3 loop
  expect undecided-level 2 'undecided: butterfly at valence 5; ' prove butterfly --valence 5 --max-level 1 --max-precision 64 --out none
  sed 's|centre .*+.*|centre 5/8+10^-100|' "$loop" >tie.scheme
  expect undecided-tie 2 'undecided: loop at valence 3; ' prove tie.scheme --valence 3 --max-precision 128 --out none
  expect undecided-some 2 'proved: loop is C1 at valence 4; ' prove tie.scheme --valence 3,4 --max-precision 128 --out none
  case $(head -n 1 stdout) in undecided:*) true ;; *) false ;; esac
  holds undecided-comes-first $? "found $(head -n 1 stdout)"
  contents out-none . stderr stdout tie.scheme
  rm tie.scheme
}

# The figures are bounds: what is printed must not claim more than is true.  At valence 3 Loop's scheme has the
# eigenvalue 1/8 exactly.
figures() {
  "$SMOOTHCERT" prove loop --valence 3 --out none >stdout 2>stderr
  others=$(sed -n 's/.*others < \([0-9.]*\) .*/\1/p' stdout)
  awk -v x="$others" 'BEGIN { exit !(x > 0.125 && x < 0.126) }'
  holds printed-bound-of-others $? "others < $others, but 1/8 is an eigenvalue"
  "$SMOOTHCERT" prove loop --valence 3..30 --out none --max-precision 0 >stdout 2>stderr
  awk '{ match($0, /L = [0-9.]*/); l = substr($0, RSTART + 4, RLENGTH - 4)
         if (match($0, /others < [0-9.]+/)) { o = substr($0, RSTART + 9, RLENGTH - 9); if (o + 0 > l + 0) exit 1 } }' stdout
  holds printed-others-below-l $? 'others are not smaller than L'
}

archives() {
  expect archive 0 '; evidence/valence-5.cert' prove loop --valence 3,5 --out evidence
  contents archive-contents evidence index journal lock runs scheme.scheme valence-3.cert valence-3.log valence-5.cert valence-5.log verify.sh
  sed -e 's/#.*//' -e 's/^ *//' -e 's/  */ /g' -e 's/ *$//' -e '/^$/d' "$loop" >canonical
  same archive-scheme evidence/scheme.scheme canonical
  "$SMOOTHCERT_CHECK" --scheme evidence/scheme.scheme --valence 5 --claim c1 evidence/valence-5.cert >stdout 2>stderr
  holds archive-is-checked $? "$(cat stderr)"
  cp evidence/valence-5.cert before
  expect archive-again 0 'proved' prove loop --valence 5,6 --out evidence
  same archive-same-bytes evidence/valence-5.cert before
  contents archive-grows evidence index journal lock runs scheme.scheme valence-3.cert valence-3.log valence-5.cert valence-5.log valence-6.cert valence-6.log verify.sh

  expect default-archive 0 '; smoothcert-loop/valence-4.cert' prove loop --valence 4
  expect default-archive-of-settings 0 '; smoothcert-modified-loop,a=7_8/valence-4.cert' prove modified-loop --set a=7/8 --valence 4
  expect by-file 0 '; by-file/valence-4.cert' prove "$loop" --valence 4 --out by-file
  same by-file-same-certificate by-file/valence-4.cert smoothcert-loop/valence-4.cert
  same by-file-same-scheme by-file/scheme.scheme smoothcert-loop/scheme.scheme
  sed -e 's/#.*//' -e 's/ /  /g' "$loop" | awk '{ printf "%s\r\n\n", $0 }' >respaced.scheme
  expect by-respaced-file 0 'proved' prove ./respaced.scheme --valence 4 --out by-file
  same by-respaced-file-same-certificate by-file/valence-4.cert smoothcert-loop/valence-4.cert

  sed 's/^scheme .*/scheme other/' "$loop" >other.scheme
  expect other-scheme 65 'evidence holds evidence for another scheme' prove other.scheme --valence 3 --out evidence
  contents other-scheme-changes-nothing evidence index journal lock runs scheme.scheme valence-3.cert valence-3.log valence-5.cert valence-5.log valence-6.cert valence-6.log verify.sh
  cp evidence/valence-3.cert before
  expect undecided-archive 2 'undecided' prove butterfly --valence 5,7 --max-level 1 --max-precision 0 --out undecided
  [ -s undecided/valence-5.log ] && [ ! -e undecided/valence-5.cert ]
  holds undecided-leaves-no-certificate $? 'a certificate, or no log'

  [ "$(sed 's/ [0-9a-f]\{64\} / HASH /' evidence/index | tr '\n' ';')" = '3 proved HASH valence-3.cert;5 proved HASH valence-5.cert;6 proved HASH valence-6.cert;' ]
  holds index $? "$(head -n 1 evidence/index)"
  [ "$(sed -n 's/^5 proved \([^ ]*\) .*/\1/p' evidence/index)" = "$(sha256sum evidence/valence-5.cert | sed 's/ .*//')" ]
  holds index-digest $? "$(grep '^5' evidence/index)"
  [ "$(sed 's/ [0-9a-f]\{64\} .*//' undecided/index | tr '\n' ';')" = '5 undecided;7 proved;' ]
  holds index-undecided $? "$(head -n 1 undecided/index)"

  # A proof that is there already says nothing of the uniform method: it is done again, with the same certificate.
  cp evidence/valence-5.cert before
  expect archive-uniform 0 'uniform level 3' prove loop --valence 5 --out evidence --method uniform
  same archive-uniform-same-bytes evidence/valence-5.cert before
  grep -q '"test":"both methods","level":0,"elements":[0-9]*,"uniform_level":3,"uniform_elements":192,' evidence/valence-5.log
  holds archive-uniform-log $? "$(tail -n 1 evidence/valence-5.log)"

  # Every line of a log is an object by itself.
  [ "$(grep -c '^{"valence":3,.*}$' evidence/valence-3.log)" = "$(wc -l <evidence/valence-3.log | tr -d ' ')" ]
  holds log-lines $? "$(head -n 1 evidence/valence-3.log)"
  rm -rf evidence by-file smoothcert-loop smoothcert-modified-loop,a=7_8 undecided canonical before respaced.scheme other.scheme
}

# Whatever takes long, the time limit and an interrupt are heeded: Kobbelt's scheme has very many blocks here, a
# midpoint scheme of high degree has large ones.
patience() {
  if command -v timeout >/dev/null 2>&1; then
    # Beyond 10^8 doubles know no u = cos(pi/k) but 1, so that no smaller box can be found by it.
    timeout -s KILL 60 "$SMOOTHCERT" prove loop --valence 1000000000..inf --out none >stdout 2>stderr
    status=$? wanted=2 message='undecided: loop at valences 1000000001..inf; ' name=range-that-cannot-be-halved
    judge
    # One valence that stands out, and only that, must not leave narrow boxes behind for ever.
    sed 's|(1,0) *spectrum.*|(1,0) spectrum cases(m = 0: a; m = 1: l; 2*m = k and k = 500: 3/5; else: others)|' "$SRCDIR/lib/catalogue/loop-ring.scheme" >narrow.scheme
    timeout -s KILL 60 "$SMOOTHCERT" prove narrow.scheme --valence 3..10000 --out none >stdout 2>stderr
    status=$? wanted=1 message='C1: 3..499, 501..10000; not C1: 500 (real)' name=boxes-grow-again
    judge
    [ "$(wc -l <stdout)" -lt 400 ]
    holds boxes-are-few $? "$(tail -n 1 stdout)"
    rm narrow.scheme
    timeout -s KILL 60 "$SMOOTHCERT" prove kobbelt --valence 1000000000 --time-limit 1 --out none >stdout 2>stderr
    status=$? wanted=2 message='undecided: kobbelt at valence 1000000000; ' name=time-limit
    judge
    # One square of a matrix of this size takes longer than that, with balls.
    timeout -s KILL 30 "$SMOOTHCERT" prove midpoint --set degree=40 --valence 5 --precision 1024 --time-limit 1 --out none >stdout 2>stderr
    status=$? wanted=2 message='no time left' name=time-limit-one-matrix
    judge
    timeout -s INT -k 60 1 "$SMOOTHCERT" prove kobbelt --valence 1000000000 --out none >stdout 2>stderr
    status=$?
    [ ! -s stdout ] && grep -q 'interrupted' stderr
    holds interrupt $? "status $status: $(cat stdout stderr | head -n 1)"
    timeout -s INT -k 60 1 "$SMOOTHCERT" prove loop --valence 3..100000 --each --out none >stdout 2>stderr
    grep -q 'interrupted' stderr
    holds interrupt-between-valences $? "$(tail -n 1 stdout)"
  fi
}

bad_places() {
  echo file >file
  expect out-is-a-file 74 'file' prove loop --valence 3 --out file
  expect out-below-a-file 74 'file/below' prove loop --valence 3 --out file/below
  expect out-several-deep 0 'several/levels//deep/valence-3.cert' prove loop --valence 3 --out several/levels//deep
  rm -rf several
  mkdir sealed
  chmod a-w sealed
  if (: >sealed/try) 2>/dev/null; then
    rm -f sealed/try
    echo 'SKIP cli-out-unwritable: this user may write everywhere'
  else
    expect out-unwritable 74 'sealed/below' prove loop --valence 3 --out sealed/below
    expect out-unwritable-itself 74 'sealed' prove loop --valence 3 --out sealed
  fi
  chmod u+w sealed
  rm -rf sealed file
  # A name in the archive is taken by a directory: nothing can be stored there.
  "$SMOOTHCERT" prove loop --valence 4 --out taken >stdout 2>stderr
  mkdir taken/valence-3.cert
  expect certificate-cannot-be-stored 74 'taken' prove loop --valence 3 --out taken
  contents certificate-cannot-be-stored-leaves-no-rest taken index journal lock runs scheme.scheme valence-3.cert valence-4.cert valence-4.log verify.sh
  rm -rf taken
  if [ -c /dev/full ]; then
    for arguments in --help --version schemes 'schemes loop' 'schemes --help' 'prove --help' 'prove loop --valence 3,4 --out none'; do
      name="full-disk-$arguments"
      # shellcheck disable=SC2086  # several arguments
      "$SMOOTHCERT" $arguments >/dev/full 2>stderr
      status=$?
      [ "$status" -eq 74 ] && grep -q 'standard output' stderr
      holds "$name" $? "exit status $status: $(head -n 1 stderr)"
    done
  fi
}

bad_files() {
  expect no-such-name 65 "there is no scheme 'lopp'" prove lopp --valence 3 --out none
  expect empty-name 65 "''" prove '' --valence 3 --out none
  expect no-such-file 74 './lopp.scheme' prove ./lopp.scheme --valence 3 --out none
  mkdir folder
  expect folder-as-scheme 74 'folder' prove ./folder --valence 3 --out none
  expect folder-as-scheme-without-slash 74 'folder' prove folder --valence 3 --out none
  rmdir folder
  : >empty.scheme
  expect empty-file 65 'empty.scheme:1:1: ' prove empty.scheme --valence 3 --out none
  awk 'BEGIN { for (i = 0; i < 70000; i++) print "#" }' >large.scheme
  expect large-file 65 'large.scheme: ' prove large.scheme --valence 3 --out none
  expect endless-file 74 '/dev/zero' prove /dev/zero --valence 3 --out none
  printf 'scheme loop\nmesh \377\n' >bytes.scheme
  expect not-ascii 65 'bytes.scheme:2:6: ' prove bytes.scheme --valence 3 --out none
  sed 's/^  centre  *3.*/  centre sqrt(0 - 1)/' "$loop" >negative.scheme
  expect told-once 65 'the square root of something negative' prove negative.scheme --valence 3..9 --out none
  rm -f ./*.scheme
}

# Loop's file with the first line that has the pattern replaced: the message names file, line (of the file as it is,
# comments included; another one than the replaced if MESSAGE begins with `-`) and column.
bad_line() { # NAME PATTERN TEXT COLUMN MESSAGE
  number=$(grep -n -- "$2" "$loop" | head -n 1 | sed 's/:.*//')
  awk -v n="$number" -v text="$3" 'NR == n { print text; next } { print }' "$loop" >bad.scheme
  case $5 in -*) number= ;; *) number=$number: ;; esac
  expect "line-$1" 65 "smoothcert: bad.scheme:$number$4" prove bad.scheme --valence 3 --out none
  case $(cat stderr) in
    *"${5#-}"*) ;;
    *) echo "FAIL cli-line-$1: expected '$5', found '$(head -n 1 stderr)'" ;;
  esac
}

bad_lines() {
  bad_line name '^scheme' 'scheme Loop' 8: name
  bad_line mesh '^mesh' 'mesh  square' 7: "'triangle', 'quad' or 'quad-dual'"
  bad_line mesh-quad '^mesh' 'mesh quad' '' '-sum to'
  bad_line dilation '^dilation' 'dilation 3' 10: "'dilation 2'"
  bad_line vertices-reserved '^vertices' 'vertices crease' '' 'reserved for a later version'
  bad_line order '^vertices' 'mask symmetric' 1: "'vertices interior'"
  bad_line sum '(0,0)' '(0,0) 1/2' '' '-sum to'
  bad_line weight-twice '(2,0)' '(1,0) 1/16' '' twice
  bad_line far '(2,0)' '(9,0) 1/16' '' '8 edges'
  bad_line irrational '(2,0)' '(2,0) cos(pi/5)' '' ''
  bad_line valence-in-mask '(2,0)' '(2,0) k/48' '' 'k'
  bad_line no-formula '(2,0)' '(2,0)' '' 'expected'
  bad_line point '(2,0)' '(2;0) 1/16' '' "','"
  bad_line symmetric '^mask' mask '' '-sum'
  bad_line operator '^  centre' '  centre 3/8 + * 2' 16: 'expected'
  bad_line unclosed '^  centre' '  centre (3/8' '' "')'"
  bad_line unknown-name '^  centre' '  centre 3/8 + n' 16: 'unknown word'
  bad_line tower '^  centre' '  centre 2^3^2' 13: 'parentheses'
  bad_line exponent '^  centre' '  centre 2^16384' '' '16384 bits'
  bad_line two-rests '^  centre' '  centre rest' '' '-exactly one'
  bad_line no-rest '^  all' '  all (1,0) 1/2' '' '-rest'
  bad_line other-points '^  all' '  all (0,1) rest' '' 'a point of the sector'
  rm -f bad.scheme
  # The end of the file is a place, too.
  sed '$d' "$loop" >short.scheme
  expect line-end-missing 65 "smoothcert: short.scheme:$(wc -l <"$loop" | tr -d ' '):1: " prove short.scheme --valence 3 --out none
  { cat "$loop"; echo more; } >long.scheme
  expect line-after-the-end 65 "smoothcert: long.scheme:$(($(wc -l <"$loop") + 1)):1: " prove long.scheme --valence 3 --out none
  rm -f short.scheme long.scheme
}

mkdir work && cd work || exit 1
{
  commands
  usage_of_prove
  answers
  figures
  archives
  patience
  bad_places
  bad_files
  bad_lines
} >../results
cat ../results
! grep -q '^FAIL' ../results
