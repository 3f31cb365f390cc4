#!/bin/sh
# smoothcert-check: its arguments, its three exit statuses, and what it says about scheme files.
set -u
LC_ALL=C
export LC_ALL
here=$SRCDIR/tests/certificates
loop=$SRCDIR/lib/catalogue/loop.scheme
good=$here/accept/loop-3.cert

# The exit status must be STATUS and what is said on both outputs must contain MESSAGE; stdout must be empty unless
# the status is 0.
expect() { # NAME STATUS MESSAGE ARGUMENT...
  name=$1 wanted=$2 message=$3
  shift 3
  "$SMOOTHCERT_CHECK" "$@" >stdout 2>stderr
  status=$?
  if [ "$status" -ne "$wanted" ]; then
    echo "FAIL check-$name: exit status $status instead of $wanted: $(cat stdout stderr | head -n 1)"
  elif [ "$wanted" -ne 0 ] && [ -s stdout ]; then
    echo "FAIL check-$name: something is on stdout: $(head -n 1 stdout)"
  else
    case $(cat stdout stderr) in
      *"$message"*) echo "PASS check-$name" ;;
      *) echo "FAIL check-$name: expected '$message', found '$(cat stdout stderr | head -n 1)'" ;;
    esac
  fi
}

arguments() {
  cannot='cannot check: '
  expect help 0 'Usage: smoothcert-check' --help
  expect version 0 'smoothcert-check' --version
  expect nothing 2 "${cannot}no scheme is given"
  expect good 0 'verified: loop is C1 at valence 3 (' --scheme "$loop" --valence 3 --claim c1 "$good"
  expect good-equals-signs 0 'verified: loop is C1 at valence 3 (' --scheme="$loop" --valence=3 --claim=c1 "$good"
  expect good-other-order 0 'verified: loop is C1 at valence 3 (' "$good" --claim c1 --valence 3 --scheme "$loop"
  expect good-dashes 0 'verified: loop is C1 at valence 3 (' --claim c1 --valence 3 --scheme "$loop" -- "$good"
  expect no-scheme 2 "${cannot}no scheme is given" --valence 3 --claim c1 "$good"
  expect no-valence 2 "${cannot}no valence is given" --scheme "$loop" --claim c1 "$good"
  expect no-claim 2 "${cannot}no claim is given" --scheme "$loop" --valence 3 "$good"
  expect no-certificate 2 "${cannot}no certificate is given" --scheme "$loop" --valence 3 --claim c1
  expect two-certificates 2 "$cannot" --scheme "$loop" --valence 3 --claim c1 "$good" "$good"
  expect two-schemes 2 "$cannot" --scheme "$loop" --scheme "$loop" --valence 3 --claim c1 "$good"
  expect two-valences 2 "$cannot" --scheme "$loop" --valence 3 --valence 3 --claim c1 "$good"
  expect two-claims 2 "$cannot" --scheme "$loop" --valence 3 --claim c1 --claim c1 "$good"
  expect unknown-option 2 "$cannot" --scheme "$loop" --valence 3 --claim c1 --quiet "$good"
  expect parameter 2 "$cannot" --scheme "$loop" --valence 3 --claim c1 --set w=1 "$good"
  expect value-missing 2 "$cannot" "$good" --valence 3 --claim c1 --scheme
  for valence in '' 03 +3 -3 3.0 0x3 3,5 ' 3' '3 ' ALL inf 3..inf.. 3.. 3..Inf 2..inf 2 0 3, 5..3 1000000001 4294967299 18446744073709551619 99999999999999999999999; do
    expect "valence-'$valence'" 2 "${cannot}" --scheme "$loop" --valence "$valence" --claim c1 "$good"
  done
  expect claim-not-c1 1 'claim: expected not-c1' --scheme "$loop" --valence 3 --claim not-c1 "$good"
  for claim in '' C1 c1x c not-C1 c2; do
    expect "claim-'$claim'" 2 "${cannot}--claim" --scheme "$loop" --valence 3 --claim "$claim" "$good"
  done
  expect other-valence 1 'valence: expected 4' --scheme "$loop" --valence 4 --claim c1 "$good"
  expect no-such-certificate 2 "$cannot" --scheme "$loop" --valence 3 --claim c1 ./nowhere.cert
  expect no-such-scheme 2 "$cannot" --scheme ./nowhere.scheme --valence 3 --claim c1 "$good"
  mkdir folder
  expect several-valences 1 'valence: expected 3..5' --scheme "$loop" --valence 3..5 --claim c1 "$good"
  expect all-valences 1 'valence: expected 3..inf' --scheme "$loop" --valence all --claim c1 "$good"
  expect folder-for-certificate 1 'no certificate in folder is about valence 3' --scheme "$loop" --valence 3 --claim c1 folder
  expect folder-for-scheme 2 "$cannot" --scheme folder --valence 3 --claim c1 "$good"
  expect exchanged 1 "$loop:1: expected \`smoothcert-certificate\`" --scheme "$good" --valence 3 --claim c1 "$loop"
  expect scheme-for-certificate 1 "$loop:1: expected \`smoothcert-certificate\`" --scheme "$loop" --valence 3 --claim c1 "$loop"
  if [ -c /dev/full ]; then
    for option in --help --version; do
      "$SMOOTHCERT_CHECK" "$option" >/dev/full 2>stderr
      status=$?
      if [ "$status" -eq 2 ]; then echo "PASS check-full-disk$option"; else echo "FAIL check-full-disk$option: exit status $status"; fi
    done
    "$SMOOTHCERT_CHECK" --scheme "$loop" --valence 3 --claim c1 "$good" >/dev/full 2>stderr
    status=$?
    if [ "$status" -eq 2 ]; then echo "PASS check-full-disk"; else echo "FAIL check-full-disk: exit status $status"; fi
  fi
}

# The same scheme in other words: comments, blanks, line ends.
equal() { # NAME, reads the file from stdin
  cat >equal.scheme
  expect "equal-$1" 0 'verified: loop is C1 at valence 3 (' --scheme equal.scheme --valence 3 --claim c1 "$good"
}

equal_texts() {
  sed -e 's/#.*//' "$loop" | equal no-comments
  sed -e 's/$/ # note/' "$loop" | equal more-comments
  sed -e 's/ /   /g' -e 's/^/  /' -e 's/$/ /' "$loop" | equal blanks
  tr ' ' '\t' <"$loop" | equal tabs
  awk '{ printf "%s\r\n", $0 }' "$loop" | equal cr-lf
  awk '{ printf "%s\n\n\n", $0 }' "$loop" | equal empty-lines
  awk '{ printf "%s%s", nl, $0; nl = "\n" }' "$loop" | equal no-final-line-feed
}

# NAME.cert: a certificate about NAME.scheme, with the choices of another, by default of the good one.
make_certificate() { # NAME [CHOICES-OF]
  {
    echo 'smoothcert-certificate 0'
    echo "scheme $(wc -l <"$1.scheme" | tr -d ' ')"
    cat "$1.scheme"
    sed -n '/^claim/,/^boundary/p' "${2:-$good}"
  } >"$1.cert"
  echo "records $(wc -l <"$1.cert" | tr -d ' ')" >>"$1.cert"
  digest=$(sha256sum <"$1.cert")
  echo "sha256 ${digest%% *}" >>"$1.cert"
}

# Texts at a limit: understood, so that the certificate is looked at.
fair() { # NAME WEIGHT
  name=$1
  sed -n '3,16p' "$good" | awk -v text="centre $2" 'NR == 12 { print text; next } { print }' >fair.scheme
  make_certificate fair
  expect "scheme-$name" 0 'verified: loop is C1 at valence 3 (' --scheme fair.scheme --valence 3 --claim c1 fair.cert
}

fair_schemes() {
  fair same-weight '0.390625'
  fair nested-64-deep "$(printf '%064d' 0 | tr 0 '(')25/64$(printf '%064d' 0 | tr 0 ')')"
  fair exponent-64 '25/64*1^64'
  fair exponent-64-with-zeros '25/64*1^064'
  fair number-of-16384-bits '25/64 + 0*((2^64)^64)^3*(2^64)^63*2^63'
  fair angles '(pi+2*pi/4-pi/2)/pi*25/64'
  fair sines '25/64*(sin(pi/6) - cos(2*pi/3))*sin(pi*k/6)'
  fair enclosure '25/64 + (cos(pi/5) - cos(pi/5))^2'
  fair enclosed-pi '25/64*(pi^2/pi^2)'
  fair no-blanks '3/8+(3/8+cos(2*pi/k)/4)^2'
  fair minus-in-front '-1+89/64'
  fair minus-square '-2^2+281/64'
  fair left-to-right '25/8/4/2'
  fair negative-exponent '25*2^-6'
  fair zero-exponent '25/64*(k-3)^0'
  fair point-in-front '.390625'
}

# Texts that are no schemes, or none of version 0, in a certificate that repeats them: cannot check, and where.
bad() { # NAME LINE:COLUMN MESSAGE, reads the canonical text from stdin
  cat >bad.scheme
  make_certificate bad
  expect "scheme-$1" 2 "cannot check: ${2:+bad.scheme:$2}" --scheme bad.scheme --valence 3 --claim c1 bad.cert
  case $(cat stderr) in
    *"$3"*) ;;
    *) echo "FAIL check-scheme-$1: expected '$3', found '$(head -n 1 stderr)'" ;;
  esac
}

# Loop's scheme with line N replaced.
with() { # N TEXT
  sed -n '3,16p' "$good" | awk -v n="$1" -v text="$2" 'NR == n { print text; next } { print }'
}

# shellcheck disable=SC2016  # backquotes of messages
bad_schemes() {
  sed -n '3,15p' "$good" | bad without-end 14:1 'end of the file'
  printf 'scheme s\nmesh quad\ndilation 2\nvertices interior\ncompose\nrefine\nsmooth 1/4, 1/2centre 1 - 3/k, 2/k\nend\n' | bad word-in-number 7:16 'expected'
  with 1 'scheme Loop' | bad name-upper-case 1:8 'expected a name'
  with 1 'scheme' | bad no-name 1: 'expected a name'
  with 1 "scheme l$(printf '%064d' 0)" | bad long-name 1: 'expected a name'
  with 1 'scheme loop two' | bad two-names 1:13 'expected the end of the line'
  with 2 'mesh quad' | bad quads 5: 'sum to 1 in each class'
  with 2 'mesh pentagon' | bad pentagons 2:6 'triangle'
  with 3 'dilation 3' | bad ternary 3:10 'expected `2`'
  with 3 'dilation 22' | bad dilation-22 3:11 'expected the end of the line'
  with 4 'vertices boundary' | bad boundary 4:10 'interior'
  with 5 'mask asymmetric' | bad asymmetric 5:6 'expected the end of the line'
  with 5 'mask' | bad one-entry-for-six 5: 'sum to 1 in each class'
  with 6 '(0,0) 1/2' | bad weights-that-do-not-sum-to-1 5: 'sum to 1 in each class'
  with 7 '(1,0) 3/8 + 1/1000000000000000000000000000000' | bad sum-off-by-very-little 5: 'sum to 1 in each class'
  with 6 '(0,0) 5/8 + cos(pi/5) - cos(pi/5)' | bad irrational-mask 6:7 'exactly rational'
  with 6 '(0,0) pi/8' | bad angle-in-the-mask 6:7 'exactly rational'
  with 6 '(0,0) 5/8 + 0*k' | bad valence-in-the-mask 6: 'expected a number'
  with 9 '(1,0) 0' | bad point-named-twice 9:1 'no weight yet'
  with 9 '(9,0) 0' | bad point-too-far 9:1 'distance of at most 8'
  with 9 '(-8,-1) 0' | bad point-too-far-across 9:1 'distance of at most 8'
  with 9 '(002,0) 1/16' | bad three-digits 9: 'one or two digits'
  with 9 '(2;0) 1/16' | bad point-with-semicolon 9:3 'expected `,`'
  with 9 '(2,0)' | bad point-without-weight 9:6 'expected a number'
  with 12 'centre rest' | bad two-rests 13:11 'exactly one'
  with 13 'all (1,0) 1' | bad no-rest 13:11 'exactly one'
  with 13 'all (1,1) rest' | bad other-points '' 'a scheme of version 0'
  with 13 'all (1,0) rest rest' | bad rest-and-more 13:16 'expected the end of the line'
  with 14 'end end' | bad end-and-more 14:5 'expected the end of the line'
  with 14 "end
rule centre
centre 1
all (1,0) rest
end" | bad more-after-the-rule '' 'a scheme of version 0'
  with 12 'centre 1/(k-3)' | bad division-by-zero 12: 'division by zero'
  with 12 'centre 1/(cos(2*pi/7)-cos(2*pi/7))' | bad division-by-enclosure-of-zero 12: 'division by an enclosure of zero'
  with 12 'centre (k-3)^-1' | bad inverse-of-zero 12: 'division by zero'
  with 12 'centre cos(1)' | bad cosine-of-one 12: 'multiple of pi'
  with 12 'centre cos(k)' | bad cosine-of-k 12: 'multiple of pi'
  with 12 'centre cos(pi^2)' | bad cosine-of-pi-squared 12: 'multiple of pi'
  with 12 'centre sin(cos(pi/5))' | bad sine-of-cosine 12: 'multiple of pi'
  with 12 'centre 2^3^2' | bad tower-of-powers 12:11 'expected the end of the line'
  with 12 'centre 2^65' | bad exponent-65 '' 'a scheme of version 0'
  with 12 'centre 2^k' | bad exponent-k '' 'a scheme of version 0'
  with 12 'centre 1.' | bad point-behind-number 12: 'expected a digit'
  with 12 'centre 1.5.2' | bad two-points 12: 'expected the end of the line'
  with 12 'centre 1e5' | bad floating-point-number 12: 'expected the end of the line'
  with 12 'centre 1/-2' | bad minus-behind-slash 12: 'expected a number'
  with 12 'centre --1' | bad two-minuses 12: 'expected a number'
  with 12 'centre (1' | bad unclosed 12: ')'
  with 12 'centre n/8' | bad unknown-letter 12: 'expected a number'
  with 12 'centre tan(pi/8)' | bad unknown-function 12: 'expected a number'
  with 12 "centre $(printf '%065d' 0 | tr 0 '(')1$(printf '%065d' 0 | tr 0 ')')" | bad nested-65-deep 12: 'at most 64'
  with 12 'centre (((((2^64)^64)^64)^64)^64)/k' | bad enormous-number '' ''
  with 12 'centre 3/8 + 0*((2^64)^64)^4' | bad number-of-16385-bits '' ''
  # Invariant under rotation, but not under reflection, and the other way round; all sums are 1.
  {
    with 5 mask | sed -n 1,5p
    echo '(0,0) 5/8'
    for p in 1,0 0,1 -1,1 -1,0 0,-1 1,-1; do echo "($p) 3/8"; done
    for p in 1,1 -1,2 -2,1 -1,-1 1,-2 2,-1; do echo "($p) 1/8"; done
    for p in 2,0 0,2 -2,2 -2,0 0,-2 2,-2; do echo "($p) 1/16"; done
    for p in 4,2 -2,6 -6,4 -4,-2 2,-6 6,-4; do echo "($p) 1/100"; done
    for p in 2,4 -4,6 -6,2 -2,-4 4,-6 6,-2; do echo "($p) -1/100"; done
    with 5 mask | sed -n 10,14p
  } >chiral
  bad mirror-asymmetric '' 'a scheme of version 0' <chiral
  {
    with 5 mask | sed -n 1,5p
    echo '(0,0) 5/8'
    for p in 1,0 0,1 -1,0 0,-1; do echo "($p) 3/8"; done
    for p in -1,1 1,-1; do echo "($p) 7/16"; done
    for p in 1,1 -1,-1; do echo "($p) 1/16"; done
    for p in -1,2 -2,1 1,-2 2,-1; do echo "($p) 1/8"; done
    for p in 2,0 0,2 -2,2 -2,0 0,-2 2,-2; do echo "($p) 1/16"; done
    with 5 mask | sed -n 10,14p
  } >stretched
  bad rotation-asymmetric 5: '(-j, i+j)' <stretched
}

# A mask that reaches behind the extraordinary vertex: a scheme, but none that can be checked.
behind() {
  sed -e '/^#/d' -e 's/^ *//' "$here/schemes/behind.scheme" >behind.scheme
  make_certificate behind "$here/accept/wide-3.cert"
  expect mask-reaches-behind 2 'cannot check: a rule uses a point opposite to its sector' --scheme behind.scheme --valence 3 --claim c1 behind.cert
}

{
  arguments
  equal_texts
  fair_schemes
  bad_schemes
  behind
} >results
cat results
! grep -q '^FAIL' results
