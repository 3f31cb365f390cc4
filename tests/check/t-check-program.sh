#!/bin/sh
# The independent checker as a program: good certificates of version 0, with one lie each, scheme files, the
# command line (those of version 1: tests/certificates/reject-1.sh). One line for each test, PASS or FAIL; exit status 0 iff none failed.
#
# SMOOTHCERT_CHECK is the program; certificates and schemes lie beside this script.
set -u
LC_ALL=C
export LC_ALL

here=${SRCDIR:+$SRCDIR/tests/check}
here=${here:-$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)}
check=${SMOOTHCERT_CHECK:-./smoothcert-check}
work=$(mktemp -d "${TMPDIR:-/tmp}/check-program.XXXXXX") || exit 1
trap 'rm -rf "$work"' EXIT
failures=0

# answer NAME STATUS PATTERN ARGUMENT...: runs the checker and compares its exit status, and what it says
# (on stdout if the status is 0, else on stderr, with nothing on stdout).
answer() {
  name=$1 expected=$2 pattern=$3
  shift 3
  "$check" "$@" >"$work/out" 2>"$work/err"
  status=$?
  said=$work/err
  [ "$status" = 0 ] && said=$work/out
  if [ "$status" != "$expected" ]; then
    reason="exit status $status, not $expected: $(head -n 1 "$said")"
  elif ! grep -q -e "$pattern" "$said"; then
    reason="no \`$pattern' in: $(head -n 1 "$said")"
  elif [ "$status" != 0 ] && [ -s "$work/out" ]; then
    reason="stdout is not empty"
  else
    echo "PASS $name"
    return
  fi
  echo "FAIL $name: $reason"
  failures=$((failures + 1))
}

sha256() {
  if command -v sha256sum >/dev/null 2>&1; then sha256sum; else shasum -a 256; fi | cut -c 1-64
}

# finish BODY CERT: adds the two last records to the lines of BODY.
finish() {
  { cat "$1" && echo "records $(($(wc -l <"$1")))"; } >"$2"
  hash=$(sha256 <"$2")
  echo "sha256 $hash" >>"$2"
}

scheme=$here/loop.scheme
good=$here/loop-7.cert
lines=$(($(wc -l <"$good") - 2))
head -n "$lines" "$good" >"$work/body"

# loop_7 NAME STATUS PATTERN CERT: the statement is that Loop is C1 at valence 7.
loop_7() { answer "$1" "$2" "$3" --scheme "$scheme" --valence 7 --claim c1 "$4"; }

# lie NAME STATUS PATTERN SED-COMMAND: the good certificate with one line changed, and a true hash.
lie() {
  sed -e "$4" "$work/body" >"$work/lie"
  finish "$work/lie" "$work/lie.cert"
  loop_7 "lie-$1" "$2" "$3" "$work/lie.cert"
}

# Good certificates

loop_7 good-loop-7 0 '^verified: loop is C1 at valence 7 (0.530872450 < L < 0.530872451)$' "$good"
answer good-wide-3 0 '^verified: wide-cos is C1 at valence 3 ' \
  --scheme="$here/wide-cos.scheme" --valence=3 --claim=c1 "$here/wide-cos-3.cert"
lie nothing 0 '^verified' ''
lie larger-powers 0 '^verified' 's/^contraction .*/contraction 2 3 4/'
lie deeper-tree 0 '^verified' 's/^regularity 0/regularity 110000000/'
lie wider-radius 0 '^verified' 's/^radius .*/radius 10000000000/'

# The last good value and the first bad one

lie edge-radius-small-good 0 '^verified' 's/^radius .*/radius 17/'
lie edge-radius-small-bad 1 'Krawczyk' 's/^radius .*/radius 16/'
lie edge-boundary-good 0 '^verified' 's/^radius .*/radius 6232a79f5e87274/'
lie edge-boundary-bad 1 ':31: boundary' 's/^radius .*/radius 6232a79f5e87275/'
lie edge-regularity-good 0 '^verified' 's/^radius .*/radius 66f3191f4d7088a/
s/^boundary .*/boundary 100100/'
lie edge-regularity-bad 1 ':30: regularity' 's/^radius .*/radius 66f3191f4d7088b/
s/^boundary .*/boundary 100100/'
lie edge-eigenvalue-good 0 '^verified' 's/^eigenvalue .*/eigenvalue 87e741c517dba2f7/'
lie edge-eigenvalue-bad 1 'Krawczyk' 's/^eigenvalue .*/eigenvalue 87e741c517dba2f8/'
lie edge-halfplane-good 0 '^verified' 's/^halfplane .*/halfplane 1000000 -120f9d/'
lie edge-halfplane-bad 1 'boundary' 's/^halfplane .*/halfplane 1000000 -120f9e/'
lie edge-halfplane-other-good 0 '^verified' 's/^halfplane .*/halfplane a86a89 1000000/'
lie edge-halfplane-other-bad 1 'boundary' 's/^halfplane .*/halfplane a86a88 1000000/'

# Lies about the subject

lie scheme-weight 1 ':10: scheme' 's,^(1\,1) 1/8,(1\,1) 1/9,'
lie scheme-name 1 ':3: scheme' 's/^scheme loop/scheme loops/'
lie scheme-shorter 1 'claim' 's/^scheme 14/scheme 13/'
lie scheme-longer 1 'expected .claim' 's/^scheme 14/scheme 15/'
lie scheme-more 1 ':17: scheme' 's/^scheme 14/scheme 15/
s/^claim/more\
&/'
lie claim 1 ':17: claim' 's/^claim c1/claim not-c1/'
lie valence 1 ':18: valence' 's/^valence 7/valence 6/'
lie version 2 'version 2' 's/^smoothcert-certificate 0/smoothcert-certificate 2/'
lie version-1 1 'expected .stability' 's/^smoothcert-certificate 0/smoothcert-certificate 1/'
answer other-valence 1 ':18: valence' --scheme "$scheme" --valence 8 --claim c1 "$good"
answer other-scheme 1 'scheme' --scheme "$here/wide-cos.scheme" --valence 7 --claim c1 "$good"

# Lies about the choices

lie grid 1 'radius' 's/^grid 64/grid 65/'
lie grid-small 2 'grid' 's/^grid 64/grid 63/'
lie grid-large 2 'grid' 's/^grid 64/grid 8193/'
lie contraction-none 2 'contraction' 's/^contraction .*/contraction 1 0 1/'
lie contraction-large 2 'contraction' 's/^contraction .*/contraction 1 1 11/'
lie contraction-two 1 'contraction' 's/^contraction .*/contraction 1 1/'
lie pivot-0 1 ':21: pivot' 's/^pivot 1/pivot 0/'
lie pivot-2 1 'radius' 's/^pivot 1/pivot 2/'
lie pivot-4 1 ':21: pivot' 's/^pivot 1/pivot 4/'
lie eigenvalue 1 'Krawczyk' 's/^eigenvalue ./eigenvalue 9/'
lie eigenvalue-negative 1 'Krawczyk' 's/^eigenvalue /eigenvalue -/'
lie eigenvalue-zero 1 'eigenvalue' 's/^eigenvalue /eigenvalue 0/'
lie eigenvalue-large 2 'eigenvalue' 's/^eigenvalue /eigenvalue 11111111111111111/'
lie eigenvector 1 'Krawczyk' 's/^eigenvector ./eigenvector 7/'
lie eigenvector-short 1 'eigenvector' 's/^\(eigenvector [^ ]*\) .*/\1/'
lie eigenvector-long 1 'eigenvector' 's/^eigenvector .*/& 1/'
lie radius-0 1 ':24: radius' 's/^radius .*/radius 0/'
lie radius-1 1 'Krawczyk' 's/^radius .*/radius 1/'
lie radius-negative 1 'radius' 's/^radius /radius -/'
lie radius-wide 1 'not decided' 's/^radius .*/radius 1000000000000000/'
lie inverse 1 'Krawczyk' 's/^inverse .*/inverse 0 0 0/'
lie inverse-large 2 'inverse' 's/^inverse /inverse 1000000000000000/'
lie inverse-missing 1 'expected .inverse' '25d'
lie power-0 1 'block 0' 's/^power .*/power 0 0 0 0/'
sed -e '/^records/,$d' -e 's/^power .*/power 9 0/' "$here/wide-cos-3.cert" >"$work/lie"
finish "$work/lie" "$work/lie.cert"
answer lie-power-1 1 'block 1' --scheme "$here/wide-cos.scheme" --valence 3 --claim c1 "$work/lie.cert"
lie power-2 1 'block 2' 's/^power .*/power 9 9 0 0/'
lie power-3 1 'block 3' 's/^power .*/power 9 9 9 0/'
loop_7 lie-second-eigenvalue 1 'block 1 reaches' "$here/loop-7-second.cert"
lie power-large 2 'power' 's/^power ./power 10001/'
lie power-largest 0 '^verified' 's/^power ./power 10000/'
lie power-short 1 'power' 's/^power .*/power 9 9 9/'
lie power-long 1 'power' 's/^power .*/& 0/'
lie halfplane-none 1 'boundary' 's/^halfplane .*/halfplane 0 0/'
lie halfplane-other 1 'boundary' 's/^halfplane .*/halfplane -1 0/'
lie halfplane-large 2 'halfplane' 's/^halfplane .*/halfplane 100000000 0/'
lie regularity-short 1 'too short' 's/^\(regularity .*\)0$/\1/'
lie regularity-long 1 'too long' 's/^regularity .*/&0/'
lie regularity-leaf 1 'regularity' 's/^regularity .*/regularity 0000/'
lie regularity-letter 1 'word' 's/^regularity ./regularity 2/'
lie regularity-deep 2 'depth' "s/^regularity ./regularity $(printf '%061d' 0 | tr 0 1)/"
lie boundary-short 1 'too short' 's/^\(boundary .*\)0$/\1/'
lie boundary-long 1 'too long' 's/^boundary .*/&0/'
lie boundary-leaf 1 'boundary' 's/^boundary .*/boundary 00/'

# Lies about the form

lie blank-twice 1 'blank' 's/^grid /grid  /'
lie blank-last 1 'blank' 's/^grid .*/& /'
lie number-form 1 'grid' 's/^grid /grid 0/'
lie line-twice 1 'expected' 's/^pivot .*/&\
&/'
lie line-missing 1 'expected .pivot' '/^pivot/d'
lie line-empty 1 'expected .pivot' 's/^pivot.*//'
cp "$good" "$work/more.cert" && echo >>"$work/more.cert"
loop_7 lie-more 1 'end of the file' "$work/more.cert"
sed 's/^sha256 ./sha256 x/' "$good" >"$work/hash.cert"
loop_7 lie-hash 1 'sha256' "$work/hash.cert"
sed 's/^halfplane ./halfplane 3/' "$good" >"$work/hash.cert"
loop_7 lie-without-hash 1 'sha256' "$work/hash.cert"
sed 's/^records .*/records 30/' "$good" >"$work/records.cert"
loop_7 lie-records-hash 1 'records' "$work/records.cert"
sed '/^sha256/d' "$work/records.cert" >"$work/lie"
hash=$(sha256 <"$work/lie")
echo "sha256 $hash" | cat "$work/lie" - >"$work/records.cert"
loop_7 lie-records 1 'records' "$work/records.cert"
size=$(($(wc -c <"$good")))
while [ "$size" -gt 0 ]; do
  size=$((size * 9 / 10))
  head -c "$size" "$good" >"$work/part.cert"
  "$check" --scheme "$scheme" --valence 7 --claim c1 "$work/part.cert" >/dev/null 2>&1
  [ $? = 1 ] || break
done
if [ "$size" = 0 ]; then echo "PASS lie-truncated"; else
  echo "FAIL lie-truncated: $size bytes are not rejected"
  failures=$((failures + 1))
fi

# Scheme files. The certificate is about the changed text, so that the text itself decides.

# language NAME STATUS PATTERN SED-COMMAND
language() {
  sed -e "$4" "$scheme" >"$work/scheme"
  sed -e 's/#.*//' -e 's/[ 	][ 	]*/ /g' -e 's/^ //' -e 's/ $//' -e '/^$/d' "$work/scheme" >"$work/text"
  {
    echo "smoothcert-certificate 0"
    echo "scheme $(($(wc -l <"$work/text")))"
    cat "$work/text"
    sed -n '/^claim/,$p' "$work/body"
  } >"$work/lie"
  finish "$work/lie" "$work/lie.cert"
  answer "scheme-$1" "$2" "$3" --scheme "$work/scheme" --valence 7 --claim c1 "$work/lie.cert"
}

language same 0 '^verified' ''
language layout 0 '^verified' 's/^mesh triangle/ mesh	triangle  # a comment/'
language formula 0 '^verified' 's,^  (0\,0).*,  ( 0 \, 0 )  (1+1/4)*.5^1,'
language sum 2 'sum to 1' 's,^  (0\,0)  5/8,  (0\,0)  5/9,'
language rotation 2 'invariant' 's,^mask symmetric,mask,
s,^  (0\,0).*,  (0\,0) 1,
s,^  (1\,0).*,  (1\,0) 1,
s,^  (1\,1).*,  (1\,1) 1,
s,^  (2\,0).*,  (0\,1) 1,'
language twice 2 'no weight yet' 's,^  (1\,1) ,  (0\,2) ,'
language far 2 ':15:3: ' 's,^  (2\,0) ,  (9\,0) ,'
language mask-k 2 ':12:14: ' 's,^  (0\,0)  5/8,  (0\,0)  5/8+k,'
language mask-real 2 'exactly rational' 's,^  (0\,0)  5/8,  (0\,0)  cos(pi/5),'
language rest-none 2 'rest' 's/rest/1/'
language rest-twice 2 'rest' 's/^  centre .*/  centre rest/'
language zero 2 'division by zero' 's,^  centre .*,  centre 1/(2-2),'
language mesh 2 'triangle' 's/^mesh triangle/mesh hexagon/'
language dilation 2 'dilation' 's/^dilation 2/dilation 3/'
language vertices 2 'interior' 's/^vertices interior/vertices boundary/'
language name 2 'name' 's/^scheme loop/scheme Loop/'
language junk 2 'end of the line' 's/^mesh triangle/mesh triangle 1/'
language order 2 'expected .mesh' '/^mesh/d'
language unended 2 'end of the file' '$d'
language more 2 'end of the line' '$s/.*/&\
end/'
language point 2 'a scheme of version 0' 's/(1,0)  rest/(1,1)  rest/'

# Each thing that version 0 does not know, alone
other() { language "beyond-$1" 2 'a scheme of version 0' "$2"; }
other quads 's/^mesh triangle/mesh quad/
s,^  (0\,0).*,  (0\,0) 9/16,
s,^  (1\,1).*,  (1\,1) 1/4,
s,^  (2\,0).*,  (2\,0) 3/32\
  (2\,1) 1/16\
  (2\,2) 1/64,'
other name 's/^mask/let w = 1\
&/'
other function 's,^  centre .*,  centre min(5/8\, 3/4),'
other lopsided 's/^mask symmetric/mask/
s,^  (0\,0).*,  (0\,0) 5/8,
s,^  (1\,0).*,  (1\,0) 3/8\
  (0\,1) 3/8\
  (-1\,1) 3/8\
  (-1\,0) 3/8\
  (0\,-1) 3/8\
  (1\,-1) 3/8,
s,^  (1\,1).*,  (1\,1) 1/16\
  (-1\,2) 1/16\
  (-2\,1) 1/16\
  (-1\,-1) 1/16\
  (1\,-2) 1/16\
  (2\,-1) 1/16\
  (2\,1) 1/16\
  (-1\,3) 1/16\
  (-3\,2) 1/16\
  (-2\,-1) 1/16\
  (1\,-3) 1/16\
  (3\,-2) 1/16,
s,^  (2\,0).*,  (2\,0) 1/16\
  (0\,2) 1/16\
  (-2\,2) 1/16\
  (-2\,0) 1/16\
  (0\,-2) 1/16\
  (2\,-2) 1/16,'
other rules '$s/.*/&\
rule (1,0)\
centre 3\/8\
(1,0) rest\
(1,0) @ 1 1\/8\
(1,0) @ -1 1\/8\
end/'
other point 's/^rule centre/rule (1,0)/'
other condition 's/^rule centre/& when k > 2/'
other source 's/^  all.*/&\
all (2,0) 0/'
other no-centre 's,^  centre .*,  all (2\,0) 5/8,'
other farther 's/(1,0)  rest/(2,0)  rest/'

# Not the scheme that the eigenpair, the powers or the trees belong to.
language other-centre 1 'power' 's,^  centre .*,  centre 1,'
language other-mask 1 'contraction' 's,^  (0\,0)  5/8,  (0\,0)  1/4,
s,^  (2\,0)  1/16,  (2\,0)  1/8,'

# Butterfly: its masks for derivatives have negative weights, and one step does not contract.

# butterfly NAME STATUS PATTERN SED-COMMAND
butterfly() {
  sed -e '/^records/,$d' -e "$4" "$here/butterfly-5.cert" >"$work/lie"
  finish "$work/lie" "$work/lie.cert"
  answer "butterfly-$1" "$2" "$3" --scheme "$here/butterfly.scheme" --valence 5 --claim c1 "$work/lie.cert"
}

butterfly negative 1 'stability: 1024/1024 is not proved for q_0' ''
butterfly contraction-12 1 'power 1 of 2 a_12' 's/^contraction .*/contraction 1 2 2/'
butterfly contraction-13 1 'power 1 of 2 a_13' 's/^contraction .*/contraction 2 1 2/'
butterfly contraction-23 1 'power 1 of 2 a_23' 's/^contraction .*/contraction 2 2 1/'

# The box spline with each of three directions thrice: the edge rule reaches behind the centre.

cat >"$work/box.scheme" <<'EOF'
scheme box
mesh triangle
dilation 2
vertices interior
mask symmetric
(0,0) 7/16
(1,0) 39/128
(1,1) 9/64
(2,0) 3/32
(2,1) 3/128
(3,0) 1/128
end
rule centre
centre 1/3
all (1,0) rest
end
EOF
{
  echo "smoothcert-certificate 0"
  echo "scheme 16"
  cat "$work/box.scheme"
  sed -n -e '/^records/,$d' -e '/^claim/,$p' "$here/butterfly-5.cert"
} >"$work/lie"
finish "$work/lie" "$work/lie.cert"
answer box-opposite 2 'opposite' --scheme "$work/box.scheme" --valence 5 --claim c1 "$work/lie.cert"

# The command line

answer usage-none 2 'scheme'
answer usage-no-claim 2 'claim' --scheme "$scheme" --valence 7 "$good"
answer usage-no-valence 2 'valence' --scheme "$scheme" --claim c1 "$good"
answer usage-no-scheme 2 'scheme' --valence 7 --claim c1 "$good"
answer usage-no-certificate 2 'certificate' --scheme "$scheme" --valence 7 --claim c1
answer usage-two-certificates 2 'twice' --scheme "$scheme" --valence 7 --claim c1 "$good" "$good"
answer usage-two-claims 2 'twice' --scheme "$scheme" --valence 7 --claim c1 --claim c1 "$good"
answer usage-unknown 2 'unknown' --quick
answer usage-no-value 2 'value' --scheme
answer usage-list 2 'valence' --scheme "$scheme" --valence 3,7 --claim c1 "$good"
answer usage-range 1 ':18: valence: expected 3..7' --scheme "$scheme" --valence 3..7 --claim c1 "$good"
answer usage-range-of-one 0 '^verified' --scheme "$scheme" --valence 7,7..7 --claim c1 "$good"
answer usage-range-backward 2 'valence' --scheme "$scheme" --valence 7..3 --claim c1 "$good"
answer usage-range-of-inf 2 'valence' --scheme "$scheme" --valence inf..inf --claim c1 "$good"
answer usage-all 1 'valence: expected 3..inf' --scheme "$scheme" --valence all --claim c1 "$good"
answer usage-small 2 'valence' --scheme "$scheme" --valence 2 --claim c1 "$good"
answer usage-large 2 'valence' --scheme "$scheme" --valence 99999999999999999999 --claim c1 "$good"
answer usage-not-c1 1 'expected not-c1' --scheme "$scheme" --valence 7 --claim not-c1 "$good"
answer usage-claim 2 'claim' --scheme "$scheme" --valence 7 --claim c2 "$good"
answer usage-set 2 'set' --scheme "$scheme" --set w=1/16 --valence 7 --claim c1 "$good"
answer usage-set-alone 2 'expected NAME=VALUE' --scheme "$scheme" --set w --valence 7 --claim c1 "$good"
answer usage-help 0 'Usage' --help
answer usage-version 0 'smoothcert-check' --version
answer usage-end 0 '^verified' --scheme "$scheme" --valence 7 --claim c1 -- "$good"
answer file-missing 2 'opened' --scheme "$scheme" --valence 7 --claim c1 "$work/none"
mkdir "$work/empty"
answer file-folder 1 'empty is about valence 7' --scheme "$scheme" --valence 7 --claim c1 "$work/empty"
answer file-scheme-missing 2 'opened' --scheme "$work/none" --valence 7 --claim c1 "$good"
if [ -c /dev/zero ]; then
  answer file-endless 2 'bytes' --scheme "$scheme" --valence 7 --claim c1 /dev/zero
fi
if [ -c /dev/full ]; then
  "$check" --scheme "$scheme" --valence 7 --claim c1 "$good" >/dev/full 2>"$work/err"
  if [ $? = 2 ]; then echo "PASS output-full"; else
    echo "FAIL output-full: the exit status is not 2"
    failures=$((failures + 1))
  fi
fi

# The page for readers lists every file once.
folder=$SRCDIR/verify/check
(cd "$folder" && ls -- *.c *.h) | LC_ALL=C sort >"$work/files"
grep '^    ' "$folder/README" | tr ' ' '\n' | grep '^[a-z0-9_]*[.][ch]$' | LC_ALL=C sort >"$work/listed"
if cmp -s "$work/files" "$work/listed"; then echo "PASS readme-files"; else
  echo "FAIL readme-files: $(diff "$work/files" "$work/listed" | grep '^[<>]' | tr '\n' ' ')"
  failures=$((failures + 1))
fi

[ "$failures" = 0 ]
