#!/bin/sh
# The independent checker on certificates for several valences: good ones, good ones with one lie each, and
# folders whose certificates share a claim. One line for each test; exit status 0 iff none failed.
set -u
LC_ALL=C
export LC_ALL

here=$SRCDIR/tests/check/ranges
singles=$SRCDIR/tests/certificates/accept-1
catalogue=$SRCDIR/lib/catalogue
failures=0

# claim NAME STATUS PATTERN SCHEME-FILE VALENCES CERTIFICATE: what the checker says, on stdout if it verifies.
claim() {
  "$SMOOTHCERT_CHECK" --scheme "$4" --valence "$5" --claim "${CLAIM:-c1}" "$6" >stdout 2>stderr
  status=$? said=stderr
  if [ "$status" = 0 ]; then said=stdout; elif [ -s stdout ]; then status="$status with output"; fi
  if [ "$status" = "$2" ] && grep -q -e "$3" "$said"; then
    echo "PASS $1"
  else
    echo "FAIL $1: exit status $status, not $2 with \`$3': $(head -n 1 "$said")"
    failures=$((failures + 1))
  fi
}

# finish BODY CERT: adds the two last records to the lines of BODY.
finish() {
  { cat "$1" && echo "records $(($(wc -l <"$1")))"; } >"$2"
  hash=$(if command -v sha256sum >/dev/null 2>&1; then sha256sum; else shasum -a 256; fi <"$2" | cut -c 1-64)
  echo "sha256 $hash" >>"$2"
}

# lie CERTIFICATE SCHEME VALENCES NAME STATUS PATTERN SED-COMMAND: the certificate with one change, and a true hash.
lie() {
  sed -e '/^records/,$d' -e "$7" "$here/$1.cert" >body
  finish body lie.cert
  claim "$1-$4" "$5" "$6" "$catalogue/$2.scheme" "$3" lie.cert
}

# Beyond all bounds, with `rise`

endless() { lie loop-31-inf loop 31..inf "$@"; }
endless nothing 0 '^verified: loop is C1 at valences 31..inf (0.619792828 <= L <= 0.625083076)$' ''
endless first 1 ':18: valence: expected 31..inf' 's/^valence 31/valence 30/'
endless one-valence 1 ':18: valence: expected 31..inf' 's/^valence 31 inf/valence 31/'
endless last-smaller 1 'valence: expected the first and a greater' 's/^valence 31 inf/valence 31 30/'
endless last-same 1 'valence: expected the first and a greater' 's/^valence 31 inf/valence 31 31/'
endless last-large 2 'number in' 's/^valence 31 inf/valence 31 1000000001/'
endless last-word 1 'decimal' 's/^valence 31 inf/valence 31 info/'
endless last-more 1 'no more values' 's/^valence 31 inf/& 5/'
endless version-0 1 'valence' 's/^smoothcert-certificate 1/smoothcert-certificate 0/'
endless form 1 'form' 's/^form real/form complex/'
endless radius-0 1 'radius' 's/^radius .*/radius 0/'
endless radius-shrunk 1 'radius: the Krawczyk' 's/^radius .*/radius 1/'
endless range-shrunk 1 'range: the Krawczyk' 's/^range .*/range 100000/'
endless range-below-radius 1 'range: it is smaller than the radius' 's/^range .*/range fffff/'
endless range-missing 1 'expected .range' '/^range/d'
endless range-of-rise 1 'range: it is smaller' '/^rise/,/^cover/s/^range .*/range 1/'
endless rise-removed 1 'cover: the other' '/^rise/,/^cover/{
/^cover/!d
}'
endless rise-short 1 'rise: it ends before' 's/^rise a5294a5294b/rise 84210842108/'
endless rise-long-enough 1 'rise: it does not go on' 's/^rise a5294a5294b/rise 84210842109/'
endless rise-backward 1 'rise: it does not go on' 's/^rise 86d2d3b6df6/rise 5f503a89f07/'
endless rise-none 1 'rise: it does not go on' 's/^rise 5f503a89f07/rise 0/'
endless rise-wide 1 'Krawczyk' 's/^rise a5294a5294b/rise 400000000000/'
endless rise-large 2 '2^47' 's/^rise a5294a5294b/rise 800000000001/'
endless rise-negative 2 '2^47' 's/^rise a5294a5294b/rise -1/'
endless block-2 1 'expected .cover' 's/^block 1 1 .*/&\
block 2 2 9/'
endless block-1-missing 1 'expected .block' '/^block 1 1/d'
endless block-0-power 1 'block 0 are not proved' 's/^block 0 0 .*/block 0 0 0/'
endless cover-missing 1 'expected .cover' '/^cover/d'
endless cover-last-missing 1 'cover: it ends too early' '/^cover 2 inf 800000000000/d'
endless cover-hole 1 'cover: the other' '/^cover 2 inf 27bdef7bdef8/d'
endless cover-last-short 1 'cover: it ends too early' 's/^cover 2 inf 800000000000/cover 2 inf 7fffffffffff/'
endless cover-last-beyond 2 '2^47' 's/^cover 2 inf 800000000000/cover 2 inf 800000000001/'
endless cover-backward 1 'cover: it does not go on' 's/^cover 2 inf 27bdef7bdef8/cover 2 inf a5294a5294a/'
endless cover-twice 1 'cover: expected no further' 's/^cover 2 inf 800000000000 .*/&\
&/'
endless cover-standing 1 'cover: it does not go on' 's/^cover 2 inf 27bdef7bdef8 .*/&\
&/'
endless cover-number 1 'cover: ' 's/^cover 2 inf/cover 2 1000/'
endless cover-from-3 1 'cover: expected frequencies from 2' 's/^cover 2 inf/cover 3 inf/'
endless cover-mixed 1 'too early' 's/^cover 2 inf 8/cover 2 500 8/'
endless cover-power 1 'cover: the other' 's/^\(cover 2 inf 27bdef7bdef8\) .*/\1 0/'
endless eigenvalue 1 'Krawczyk' 's/^eigenvalue ./eigenvalue 8/'
endless regularity 1 'regularity: a leaf' 's/^regularity .*/regularity 000/'
endless boundary 1 'boundary: a leaf' 's/^halfplane .*/halfplane 1 -1/'
endless hash 0 '^verified' 's/^contraction .*/contraction 1 2 1/'
CLAIM=not-c1 endless claim 1 'claim' ''
CLAIM=not-c1 endless claim-changed 1 '' 's/^claim c1/claim not-c1/'

# Does it matter which valences it is about?

for k in 30..inf 20..inf 32..inf 31..1000; do
  lie loop-31-inf loop "$k" "relabelled-$k" 1 '' "s/^valence .*/valence $(echo "$k" | sed 's/\.\./ /')/"
done
for k in 9..11 8..10 9..20 9..inf; do
  lie loop-9-10 loop "$k" "relabelled-$k" 1 '' "s/^valence .*/valence $(echo "$k" | sed 's/\.\./ /')/"
done
# One valence in the clothes of several: D would have to be ignored.
sed -e '/^records/,$d' -e 's/^valence 20/valence 20 30/' -e 's/^radius .*/&\
range 40000/' -e '/^block [2-9]/d' -e 's/^halfplane/cover 2 inf 800000000000 5\
&/' "$singles/loop-20.cert" >body
finish body lie.cert
claim single-as-several 1 'Krawczyk' "$catalogue/loop.scheme" 20..30 lie.cert

# Groups of frequencies, without `rise`

groups() { lie loop-20-30 loop 20..30 "$@"; }
groups nothing 0 '^verified: loop is C1 at valences 20..30 ' ''
groups in-one 1 ':33: cover: ' '/^cover [3-9]/d
/^cover 1/d
s/^cover 2 2 .*/cover 2 15 800000000000 9/'
groups gap 1 'cover: expected frequencies from 6' '/^cover 6 6/d'
groups overlap 1 'cover: expected frequencies from 7' 's/^cover 7 7/cover 6 7/'
groups order 1 'cover: expected frequencies from 6' '/^cover 6 6/{
N
s/^\(.*\)\n\(.*\)$/\2\
\1/
}'
groups backward 1 'cover: expected' 's/^cover 6 6/cover 6 5/'
groups end 1 'cover: it ends too early' '/^cover 15 15/d'
groups beyond 0 '^verified' 's/^cover 15 15/cover 15 1000/'
groups beyond-inf 0 '^verified' 's/^cover 15 15/cover 15 inf/'
groups beyond-and-more 1 'cover: expected no further' 's/^cover 15 15 .*/&\
cover 16 16 800000000000 0/'
groups place 1 'cover: the lines' 's/^cover 6 6 4ccccccccccd/cover 6 6 4ccccccccccc/'
groups rounding 0 '^verified' 's/^cover 6 6 4ccccccccccd/cover 6 6 4ccccccccccf/'
groups early 1 'cover: it does not go on' 's/^cover 6 6 4ccccccccccd/cover 6 6 100000000000/'

# Quads; a composition whose centre depends on k

lie catmull-clark-40-60 catmull-clark 40..60 nothing 0 '^verified: catmull-clark is C1 at valences 40..60' ''
lie catmull-clark-40-60 catmull-clark 40..61 more 1 '' 's/^valence 40 60/valence 40 61/'
lie catmull-clark-40-60 catmull-clark 40..60 eigenvector 1 'Krawczyk' 's/^eigenvector ./eigenvector 9/'

# Block 0 that tends to block 1

limit() { lie catmull-clark-160-inf catmull-clark 160..inf "$@"; }
limit nothing 0 '^verified: catmull-clark is C1 at valences 160..inf' ''
lie catmull-clark-160-inf catmull-clark 160..1000 finite 1 'expected .block' 's/^valence 160 inf/valence 160 1000/'
lie catmull-clark-160-inf catmull-clark 150..inf earlier 1 'Krawczyk' 's/^valence 160/valence 150/'
limit power 1 'limit: the other' 's/^limit .*/limit 0/'
limit eigenvalue 1 ':[0-9]*: radius: the Krawczyk' '/^limit/,/^block/s/^eigenvalue a/eigenvalue b/'
limit range 1 'range: it is smaller' '/^limit/,/^block/s/^range .*/range 1/'
limit and-block-0 1 'block: expected .block 1 1' 's/^block 1 1.*/block 0 0 9\
&/'
limit as-block-0 1 'block 0' '/^limit/,/^block/{
/^block/!d
s/^/block 0 0 20\
/
}'
# Loop's centre does not come to rest.
endless limit 1 'limit: a weight of the centre is no polynomial' '/^pivot/,/^block 0/{
/^block 0/!H
}
/^block 0 0/{
s/.*/limit 1/
G
s/\n\n/\
/
}'

# There is no centre.
dual() { lie doo-sabin-18-inf doo-sabin 18..inf "$@"; }
dual nothing 0 '^verified: doo-sabin is C1 at valences 18..inf' ''
dual limit 1 'scheme: there is no centre' '/^pivot/,/^inverse -3d/H
/^block 0 0/{
s/.*/limit 1/
G
s/\n\n/\
/
}'

# Certificates of schemes that stand in them, with choices of their own

# own CERTIFICATE VALENCES NAME STATUS PATTERN SED-COMMAND: the lie is one of the scheme, or of the certificate.
own() {
  sed -e '/^records/,$d' -e "$6" "$here/$1.cert" >edited
  sed -e '1,2d' -e '/^claim /,$d' edited >own.scheme
  sed -e "2s/.*/scheme $(($(wc -l <own.scheme)))/" edited >body
  finish body lie.cert
  claim "$1-$3" "$4" "$5" own.scheme "$2" lie.cert
}
# The largest eigenvalue of block m rises with m at first, where all is as in Loop's scheme otherwise.
own falling-31-inf 31..inf nothing 1 'not proved to be positive and to rise' ''
# 1 + 3/k of the centre: block 0 is ahead of block 1 at all valences, and tends to it.
own centre-rising-160-inf 160..inf nothing 1 'limit: the eigenvalue is not proved to fall behind L' ''
# 1 - 1/100/k: as k comes down from infinity block 0 falls, but less than L, and is ahead at 160.
own centre-slowly-160-inf 160..inf nothing 1 'limit: the eigenvalue is not proved to fall behind L' ''
mask() { own catmull-clark-mask-160-inf 160..inf "$@"; }
mask nothing 0 '^verified: cc is C1 at valences 160..inf' ''
mask centre-moves 1 'limit: the centre does not keep its value' 's,^centre 1 - 7/4/k,& + 1/1000,'
mask grows 1 'limit: a weight of the centre grows with k' 's,^centre 1 - 7/4/k,& + k/1000000000000000,'
mask edges-stay 1 'limit: the centre does not keep its value' 's,^all (1.0) 3/2/k,& + 1/1000,'
mask centre-of-the-mask 2 'the centre has no rule, and the mask does not give it its old value' '/^rule centre/,/^end/d'
mask rule-depends-on-k 1 'scheme: only rules of the centre may depend on k' '/^claim/i\
rule (1,1)\
centre 1/4 + 0*k\
(1,0) 1/4\
(1,0) @ 1 1/4\
(1,1) rest\
end'
mask rule-with-all-sectors 1 'scheme: only rules of the centre may depend on k' '/^claim/i\
rule (1,1)\
centre 1/4\
(1,0) 1/4\
(1,0) @ 1 1/4\
(1,1) rest\
all (1,1) 0\
end'
mask exponents-beyond 1 'limit: a weight of the centre is no polynomial' 's,^centre 1 - 7/4/k,centre 1 - 7/4/k - (1/k)^40*(1/k)^40,'
mask power-beyond 1 'limit: a weight of the centre is no polynomial' 's,^centre 1 - 7/4/k,& + (1/k/k)^40,'
mask quotient-by-a-sum 1 'limit: a weight of the centre is no polynomial' 's,^centre 1 - 7/4/k,centre 1 - 7/4/(k + 1),'
mask case-unknown 1 'limit: a weight of the centre is no polynomial' 's,^centre 1 - 7/4/k,centre 1 - cases(mod(k\, 2) = 0: 7/4/k; else: 7/4/k),'
mask case-known 0 '^verified' 's,^centre 1 - 7/4/k,centre 1 - cases(k > 5: 7/4/k; else: 1),'
mask case-no-polynomial 1 'limit: a weight of the centre is no polynomial' 's,^centre 1 - 7/4/k,centre 1 - cases(k > 5: 7/4*abs(1/k); else: 1),'
mask name-no-polynomial 1 'limit: a weight of the centre is no polynomial' 's,^centre 1 - 7/4/k,centre 1 - w,
/^mask/i\
let w = 7/4*abs(1/k)'
mask parameter-interval 1 'limit: a weight of the centre is no polynomial' 's,^centre 1 - 7/4/k,& + 0*w,
/^mask/i\
parameter w = [0, 1]'
mask no-polynomial 1 'limit: a weight of the centre is no polynomial' 's,^centre 1 - 7/4/k,centre 1 - 7/4*abs(1/k),'
mask weight-for-each-sector 1 'a weight for each sector is for single valences only' '/^claim/i\
rule (1,1)\
centre 1/4\
(1,0) 1/4\
(1,0) @ 1 1/4\
(1,1) rest\
(1,1) @ j 0\
end'

# A mask that has first differences, but not all second ones
blocky() { own doo-sabin-18-inf 18..inf "$@"; }
blocky scheme 1 'contraction: the mask.s symbol is not divisible' 's,9/16,49/64,
s,3/16,7/64,
s,^(3.2\,3.2) 1/16,(3/2\,3/2) 1/64,'

# Refutations at one frequency

# denial CERTIFICATE SCHEME-FILE VALENCES NAME STATUS PATTERN SED-COMMAND
denial() {
  sed -e '/^records/,$d' -e "$7" "$here/$1.cert" >body
  finish body lie.cert
  CLAIM=not-c1 claim "$1-$4" "$5" "$6" "$2" "$3" lie.cert
}
cup() { denial centre-above-3-4 "$SRCDIR/tests/certificates/schemes/centre-above.scheme" 3..4 "$@"; }
cup nothing 0 '^verified: centre-above is not C1 at valences 3..4 (frequency 0: 0.499999999 <= |L| <= 0.500000001)$' ''
cup more 1 'valence: expected' 's/^valence 3 4/valence 3 5/'
cup form 1 'form' 's/^form plain/form real/'
cup block-1 1 'expected .cover' 's/^block 0 0 .*/&\
block 1 1 9/'
cup cover-1-missing 1 'cover: expected frequencies from 1' '/^cover 1 1/d'
cup cover-2-missing 1 'cover: it ends too early' '/^cover 2 2/d'
cup growth 1 'not proved to be larger than 1' 's/^reason frequency/reason not-c0/
/^block/d
/^cover/d
s/^boundary.*/witness 0 -/'
cup fold 1 'frequency' 's/^reason frequency/reason fold/'
cup boundary 1 'boundary: ' 's/^boundary .*/boundary 0/'
cup window 1 'form' 's/^frequency 0/frequency window/'
cup range 1 'range: it is smaller' 's/^range .*/range 1/'
denial centre-above-3-4 "$SRCDIR/tests/certificates/schemes/centre-above.scheme" 3..6 beyond 1 'block 1\|cover' 's/^valence 3 4/valence 3 6/'

# Growing without bound: 1 - k/16 at the centre

graded() { denial centre-grows-64-70 "$SRCDIR/tests/certificates/schemes/centre-grows.scheme" "$@"; }
graded 64..70 nothing 0 '^verified: centre-grows is not C1 at valences 64..70 (frequency 0: 3.33.* <= |L| (64/k)^1 <= 3.47' ''
graded 64..inf wider 1 'radius: the Krawczyk' 's/^valence 64 70/valence 64 inf/'
graded 3..5 elsewhere 1 'radius: the Krawczyk' 's/^valence 64 70/valence 3 5/'
graded 64..70 unit 1 'radius: the Krawczyk' 's/^unit 64/unit 63/'
graded 64..70 unit-0 1 'unit: it is not positive' 's/^unit 64/unit 0/'
graded 64..70 unit-large 2 'number in' 's/^unit 64/unit 1000000001/'
graded 64..70 degree-0 1 'grades: the scaled block grows' 's/^degree 1/degree 0/'
graded 64..70 degree-2 1 'radius: the Krawczyk' 's/^degree 1/degree 2/'
graded 64..70 degree-large 2 'number in' 's/^degree 1/degree 65/'
graded 64..70 grade-small 1 'grades: the scaled block grows' 's/^grades 0 1 1 1/grades 1 0 1 1/'
graded 64..70 grade-other 1 'Krawczyk' 's/^grades 0 1 1 1/grades 0 1 1 0/'
graded 64..70 grade-large 2 'number in' 's/^grades 0 1 1 1/grades 0 1 1 65/'
graded 64..70 grade-missing 1 'grades: expected more' 's/^grades 0 1 1 1/grades 0 1 1/'
graded 64..70 grade-extra 1 'grades: expected no more' 's/^grades 0 1 1 1/& 1/'
graded 64..70 eigenvalue 1 'radius: the Krawczyk' 's/^eigenvalue -3/eigenvalue -4/'
graded 64..70 eigenvalue-positive 1 'radius: the Krawczyk' 's/^eigenvalue -/eigenvalue /'
graded 64..70 witness 1 'witness: it does not' 's/^witness .*/witness 0 -/'
graded 64..70 witness-element 1 'witness: there are' 's/^witness .*/witness 100 -/'
graded 64..70 frequency 1 'form' 's/^frequency 0/frequency 2/'
graded 64..70 reason 1 'form: .graded. is for' 's/^reason not-c0/reason frequency/'
graded 64..70 plain 1 'expected .pivot' 's/^form graded/form plain/'
denial centre-grows-20-22 "$SRCDIR/tests/certificates/schemes/centre-grows.scheme" 20..22 small 1 'not proved to be larger than 1' ''
graded 64 one-valence 1 'form: .graded. is for' 's/^valence 64 70/valence 64/'

# The eigenvalue 1 of constants is no growth, though it is kappa times larger when scaled; this scheme is C1 there.
slow() { CLAIM=not-c1 own centre-slow-64-65 64..65 "$@"; }
slow constants 1 'not proved to be larger than 1' ''
# 1 + k/16 at the centre: L is positive.
rises() { CLAIM=not-c1 own centre-rises-64-70 64..70 "$@"; }
rises nothing 0 '^verified: centre-rises is not C1 at valences 64..70 ' ''
rises sign 1 'Krawczyk' 's/^eigenvalue /&-/'
# Block 2 grows: block 0 is not asked for, but must be one all the same.
spectrum() { CLAIM=not-c1 own spectrum-grows-9-2000 9..2000 "$@"; }
spectrum nothing 0 '^verified: spectrum-grows is not C1 at valences 9..2000 (frequency 2: ' ''
spectrum no-rule-of-the-centre 2 'the centre has no rule, and the mask does not give it its old value' '/^rule centre/,/^end/d'
spectrum both-factors-vary 1 'is not proved to hold at all the valences or at none' 's/when k > 6/when k*k > 36/'
spectrum unbounded 0 '^verified: ' 's,^centre 5/8,centre k*k,'
spectrum no-value 2 'the square root of something that is or may be negative' 's,^centre 5/8,centre sqrt(0-1),'
spectrum no-value-and-unbounded 2 'the square root of something that is or may be negative' 's,^centre 5/8,centre k*k + k^3*sqrt(0-1),'
spectrum perhaps-no-value 1 'the square root of something that is or may be negative' 's,^centre 5/8,centre k*k + sqrt(k - 100) + k*k,'
# What a scheme must be for this
scaled() { CLAIM=not-c1 own sixteenth-112-inf 112..inf "$@"; }
scaled no-rule-of-the-centre 2 'the centre has no rule, and the mask does not give it its old value' '/^rule centre/,/^end/d'
scaled rule-depends-on-k 1 'scheme: only rules of the centre may depend on k' '/^claim/i\
rule (1,0)\
centre 3/8 + 0/k\
(1,0) rest\
(1,0) @ 1 1/8\
(1,0) @ -1 1/8\
end'
scaled rule-with-all-sectors 1 'scheme: only rules of the centre may depend on k' '/^claim/i\
rule (1,0)\
centre 3/8\
(1,0) rest\
(1,0) @ 1 1/8\
(1,0) @ -1 1/8\
all (1,0) 0\
end'
# A mask that reaches behind the centre, which has 6 unknowns besides
scaled mask-reaches-behind 2 'a rule uses a point opposite to its sector' 's:^(0,0) 5/8:(0,0) 17/32:
s:^(1,0) 3/8:(1,0) 43/128:
s:^(2,0) 1/16:(2,0) 5/64:
s:^(1,1) 1/8:(1,1) 7/64\
(3,0) 1/128\
(2,1) 3/128:
s/^grades .*/grades 0 1 1 1 1 1 1/
s/^eigenvector .*/eigenvector 0 0 0 0 0 0/
/^inverse/d
s/^range .*/&\
inverse 0 0 0 0 0 0 0\
inverse 0 0 0 0 0 0 0\
inverse 0 0 0 0 0 0 0\
inverse 0 0 0 0 0 0 0\
inverse 0 0 0 0 0 0 0\
inverse 0 0 0 0 0 0 0\
inverse 0 0 0 0 0 0 0/'
CLAIM=not-c1 dual graded 1 'scheme: there is no centre' 's/^claim c1/claim not-c1/;s/^form real/reason not-c0\
frequency 0\
form graded/'
scaled weight-without-laurent-value 1 'form: a weight of the centre has no Laurent value' 's:k/16:& + 0*abs(1/k):'

# Growing in compositions: Catmull-Clark's, with 1 - k/8 at the centre; and a second smoothing with 1 + 1/k - k/16.  The
# choices are no prover's.
composed() { CLAIM=not-c1 own composed-grows-80-inf 80..inf "$@"; }
composed nothing 0 '^verified: composed-grows is not C1 at valences 80..inf (frequency 0: 0.673.* <= |L| (8/k)^1 <= 0.759' ''
composed unit 1 'radius: the Krawczyk' 's/^unit 8/unit 9/'
composed degree-0 1 'grades: the scaled block grows' 's/^degree 1/degree 0/'
composed degree-2 1 'radius: the Krawczyk' 's/^degree 1/degree 2/'
composed grade-of-centre 1 'radius: the Krawczyk' 's/^grades 0 1/grades 1 1/'
composed grade-of-centre-2 1 'grades: the scaled block grows' 's/^grades 0 1/grades 3 1/'
composed grade-of-first 1 'radius: the Krawczyk' 's/^grades 0 1/grades 0 0/'
composed grade-of-last 1 'radius: the Krawczyk' 's/^\(grades.*\) 1$/\1 0/'
composed grade-too-large 1 'grades: the scaled block grows' 's/^\(grades.*\) 1$/\1 2/'
composed grades-exchanged 1 'grades: the scaled block grows' 's/^grades 0 1/grades 1 0/'
composed grades-alike 1 'radius: the Krawczyk' 's/^grades .*/grades 0 0 0 0 0 0 0/'
composed eigenvalue 1 'radius: the Krawczyk' 's/^eigenvalue -b/eigenvalue -c/'
composed sign 1 'radius: the Krawczyk' 's/^eigenvalue -/eigenvalue /'
composed eigenvector 1 'radius: the Krawczyk' 's/^eigenvector -8/eigenvector -9/'
composed witness-elsewhere 1 'witness: it does not' 's/^witness .*/witness 0 -/'
composed growth-in-the-text 1 'radius: the Krawczyk' 's:1 - k/8:1 - k/9:'
composed sign-in-the-text 1 'radius: the Krawczyk' 's:1 - k/8:1 + k/8:'
composed decay-in-the-text 1 'radius: the Krawczyk' 's:2/k:3/k:'
composed faster-in-the-text 1 'grades: the scaled block grows' 's:1 - k/8:1 - k^2/8:'
composed edges-grow-in-the-text 1 'radius: the Krawczyk' 's:2/k:2/k + k/1000:'
composed weights-in-the-text 1 'radius: the Krawczyk' 's:^smooth 1/4, 1/2:smooth 9/32, 7/16:'
composed constants-in-the-text 1 'radius: the Krawczyk' 's:centre 1 - k/8, 2/k:centre 1/4, 1/2:'
composed smoothing-more 1 'grades: expected more' 's:^smooth .*:&\
smooth 1/4, 1/2:'
composed smoothing-less 1 'grades: expected no more' '/^smooth 1/d'
composed average 1 'scheme: there is no centre' 's:^smooth .*:&\
average:'
composed weight-without-laurent-value 1 'form: a weight of the centre has no Laurent value' 's:2/k:2/k + 0*abs(1/k):'

negative() { CLAIM=not-c1 own negative-powers-80-inf 80..inf "$@"; }
negative nothing 0 '^verified: negative-powers is not C1 at valences 80..inf (frequency 0: 0.922.* <= |L| (11/k)^1 <= 1.047' ''
negative quotient 0 '^verified' 's:k^-2:1/k^2:'
negative exponent-in-parentheses 0 '^verified' 's:k^-2:k^(1 - 3):'
negative base-with-a-factor 0 '^verified' 's:k^-2:(2*k)^-2*4:'
negative base-below 0 '^verified' 's:k^-2:(1/k)^2:'
negative exponent-smaller 1 'radius: the Krawczyk' 's:k^-2:k^-3:'
negative exponent-larger 1 'radius: the Krawczyk' 's:k^-2:k^-1:'
negative exponent-positive 1 'grades: the scaled block grows' 's:k^-2:k^2:'
negative factor 1 'radius: the Krawczyk' 's:8^-1:9^-1:'
negative factor-inverted 1 'radius: the Krawczyk' 's:8^-1:8:'
negative two-terms 1 'form: a weight of the centre has no Laurent value' 's:k^-2:(k + 1)^-2:'
negative zero 1 '\(no Laurent value\|has no value\)' 's:k^-2:k^-2 + (k - k)^-1:'
negative degree-64 0 '^verified' 's:k^-2:k^-64*k^62:'
negative degree-65 1 'form: a weight of the centre has no Laurent value' 's:k^-2:k^-65*k^63:'
negative exponent-1024 0 '^verified' 's:k^-2:k^-2*1^-1024:'
negative exponent-1025 1 'form: a weight of the centre has no Laurent value' 's:k^-2:k^-2*1^-1025:'
negative exponent-varies 1 'form: a weight of the centre has no Laurent value' 's:k^-2:k^-2*1^-k:'
composed weight-with-sum-below 1 'form: a weight of the centre has no Laurent value' 's:2/k:2/(k + 1):'
composed bounded 1 'grades: expected\|Krawczyk' 's:1 - k/8:1 - 3/k:'
CLAIM=not-c1 own composed-grows-80-inf 79..inf wider 1 'radius: the Krawczyk' 's/^valence 80/valence 79/'
CLAIM=not-c1 own composed-grows-80-inf 3..inf from-3 1 'Krawczyk' 's/^valence 80/valence 3/'
CLAIM=not-c1 own composed-grows-80-inf 81..inf narrower 1 'radius: the Krawczyk' 's/^valence 80/valence 81/'
denial composed-grows-80-inf "$catalogue/catmull-clark.scheme" 80..inf another-scheme 1 'scheme: expected the text' ''
CLAIM=not-c1 own composed-grows-14-15 14..15 small 1 'eigenvalue: |L| is not proved to be larger than 1' ''

smoothings() { CLAIM=not-c1 own two-smoothings-64-70 64..70 "$@"; }
smoothings nothing 0 '^verified: two-smoothings is not C1 at valences 64..70 (frequency 0: 0.56.* <= |L| (12/k)^2 <= 0.58' ''
smoothings degree 1 'grades: the scaled block grows' 's/^degree 2/degree 1/'
smoothings degree-3 1 'radius: the Krawczyk' 's/^degree 2/degree 3/'
smoothings grade-of-second 1 'grades: the scaled block grows' 's/^grades 0 1 1/grades 0 1 2/'
smoothings grade-smaller 1 'radius: the Krawczyk' 's/^grades 0 1 1/grades 0 1 0/'
smoothings exchanged 1 'radius: the Krawczyk' '/^smooth 1.4/{
N
s/^\(.*\)\n\(.*\)$/\2\
\1/
}'
smoothings centres-exchanged 1 'Krawczyk' 's:centre 1 - k/8, 2/k:centre X:
s:centre 1 + 1/k - k/16, 1/2:centre 1 - k/8, 2/k:
s:centre X:centre 1 + 1/k - k/16, 1/2:'
smoothings first-does-not-grow 1 'radius: the Krawczyk' 's: centre 1 - k/8, 2/k::'
smoothings second-does-not-grow 1 'radius: the Krawczyk' 's: centre 1 + 1/k - k/16, 1/2::'
smoothings first-without-laurent-value 1 'form: a weight of the centre has no Laurent value' 's:1 - k/8:& + 0*abs(1/k):'
smoothings second-without-laurent-value 1 'form: a weight of the centre has no Laurent value' 's:1 + 1/k:& + 0*abs(1/k):'
smoothings smaller-term 1 'radius: the Krawczyk' 's:1 + 1/k - k/16:1 + 2/k - k/16:'

growth() { denial centre-divergent-5-inf "$SRCDIR/tests/certificates/schemes/centre-divergent.scheme" "$@"; }
growth 5..inf nothing 0 '^verified: centre-divergent is not C1 at valences 5..inf ' ''
growth 3..inf from-3 0 '^verified: centre-divergent is not C1 at valences 3..inf ' 's/^valence 5/valence 3/'
growth 5..inf frequency-reason 1 '' 's/^reason not-c0/reason frequency/'
growth 5..inf frequency-2 1 'form' 's/^frequency 0/frequency 2/'
growth 5..inf frequency-3 1 'frequency' 's/^frequency 0/frequency 3/'
growth 5..inf eigenvalue 1 'Krawczyk' 's/^eigenvalue ./eigenvalue /'
growth 5..inf witness 1 'witness' 's/^witness \([0-9]*\) .*/witness 1000 -/'
growth 5..inf radius 1 'radius: the Krawczyk' 's/^radius .*/radius 1/'
growth 5..inf radius-large 2 'radius: expected a magnitude' 's/^radius .*/radius 1000000000000000000000000000000000/'
growth 5..inf range 1 'range: it is smaller' 's/^range .*/range 1/'
growth 5..inf point 1 'radius: the Krawczyk' 's/^eigenvector \(-*\)[0-6]/eigenvector \17/;s/^eigenvector \(-*\)[89a-f]/eigenvector \16/'
growth 5..inf cut 1 'expected .witness' '/^witness/d'
growth 5..inf cover 1 'expected .witness' 's/^witness.*/cover 1 inf 800000000000 9\
&/'

# What the prover writes, and one lie each

# told CERTIFICATE VALENCES NAME ...: the scheme is what the certificate says it is.
told() {
  sed -n '/^claim/q;3,$p' "$here/$1.cert" >told.scheme
  certificate=$1 valences=$2
  shift 2
  denial "$certificate" told.scheme "$valences" "$@"
}
sixteenth() { told sixteenth-112-inf 112..inf "$@"; }
sixteenth nothing 0 '^verified: loop-sixteenth is not C1 at valences 112..inf' ''
sixteenth unit 1 'Krawczyk' 's/^unit 16/unit 15/'
sixteenth degree 1 'grades: the scaled block grows' 's/^degree 1/degree 0/'
sixteenth degree-2 1 'Krawczyk' 's/^degree 1/degree 2/'
sixteenth grade 1 'grades: the scaled block grows' 's/^grades 0 1 1 1/grades 0 1 1 2/'
sixteenth grade-smaller 1 'Krawczyk' 's/^grades 0 1 1 1/grades 0 1 1 0/'
sixteenth grade-of-centre 1 'grades: the scaled block grows' 's/^grades 0/grades 2/'
sixteenth eigenvalue 1 'Krawczyk' 's/^eigenvalue -f/eigenvalue -e/'
sixteenth sign 1 'Krawczyk' 's/^eigenvalue -/eigenvalue /'
sixteenth eigenvector 1 'Krawczyk' 's/^eigenvector -6/eigenvector -5/'
sixteenth witness 1 'witness: it does not' 's/^witness .*/witness 0 -/'
sixteenth witness-elsewhere 1 'witness: there are' 's/^witness .*/witness 4 001/'
sixteenth radius 1 'radius: the Krawczyk' 's/^radius .*/radius 1/'
sixteenth radius-large 2 'radius: expected a magnitude' 's/^radius .*/radius 1000000000000000000000000000000000/'
sixteenth range 1 'range: it is smaller' 's/^range .*/range 1/'
sixteenth cut 1 'expected .witness' '/^witness/d'
sixteenth order 1 'expected .unit' '/^unit/{
N
s/^\(.*\)\n\(.*\)$/\2\
\1/
}'
sixteenth reason 1 'form: .graded. is for' 's/^reason not-c0/reason frequency/'
told sixteenth-112-inf 19..inf from-19 1 'Krawczyk' 's/^valence 112 inf/valence 19 inf/'
told sixteenth-112-inf 5..19 proved-to-be-c1 1 'Krawczyk' 's/^valence 112 inf/valence 5 19/'
told sixteenth-112-inf 26..27 modulus-one 1 'Krawczyk' 's/^valence 112 inf/valence 26 27/'
denial sixteenth-112-inf "$SRCDIR/tests/certificates/schemes/centre-grows.scheme" 112..inf another-scheme 1 'scheme' ''
sixteenth slower 1 'scheme' 's:k/16:k/17:'

steps() { told steps-grow-1311-inf 1311..inf "$@"; }
steps nothing 0 '^verified: steps-grow is not C1 at valences 1311..inf (frequency 0: 1.0410.* <= |L| (20/k)^2 <= 1.0418' ''
steps unit 1 'radius: the Krawczyk' 's/^unit 20/unit 21/'
steps degree 1 'grades: the scaled block grows' 's/^degree 2/degree 1/'
steps grade 1 'radius: the Krawczyk' 's/^grades 0 0 0 1/grades 0 0 0 0/'
steps grade-larger 1 'grades: the scaled block grows' 's/^\(grades.*\) 2$/\1 3/'
steps grade-of-edges 1 'grades: the scaled block grows' 's/^grades 0 0/grades 0 1/'
steps grade-missing 1 'grades: expected more' 's/^\(grades.*\) 2$/\1/'
steps eigenvalue 1 'Krawczyk' 's/^eigenvalue 1/eigenvalue 2/'
steps slower 1 'scheme: expected the text' 's:1/9:1/10:'
told steps-grow-1311-inf 1310..inf from-1310 1 'Krawczyk' 's/^valence 1311/valence 1310/'
told steps-grow-1311-inf 3..15 proved-to-be-c1 1 'Krawczyk' 's/^valence 1311 inf/valence 3 15/'
# Its text says something else, of any one step.
steps_own() { CLAIM=not-c1 own steps-grow-1311-inf 1311..inf "$@"; }
steps_own first-step 1 'radius: the Krawczyk' 's:k\*a, 1 - k$:k*a, 2 - k:'
steps_own first-step-slower 1 'radius: the Krawczyk' 's:k\*a, 1 - k$:a, 1 - k:'
steps_own first-step-faster 1 'grades: the scaled block grows' 's:k\*a, 1 - k$:k^2*a, 1 - k:'
steps_own second-step 1 'radius: the Krawczyk' 's:centre 2/k, :centre 3/k, :'
steps_own second-step-slower 1 'radius: the Krawczyk' 's:, k^2\*b:, k*b:'
steps_own second-step-faster 1 'grades: the scaled block grows' 's:, k^2\*b:, k^3*b:'
steps_own third-step 1 'radius: the Krawczyk' '/^smooth 1.4, 1.2$/s:$: centre 1 - 3/k, 2/k:'
steps_own third-step-grows 1 'grades: the scaled block grows' '/^smooth 1.4, 1.2$/s:$: centre 1 - k/8, 2/k:'
steps_own interval-for-a-parameter 1 'form: a weight of the centre has no Laurent value' 's:^parameter b = 1/9:parameter b = [1/9, 1/8]:'
steps_own name-written-out 0 '^verified' 's:k^2\*b:k^2/9:'

turns() { told two-turns-30-inf 30..inf "$@"; }
turns nothing 0 '^verified: two-turns is not C1 at valences 30..inf (frequency 2: 0.599' ''
turns frequency-3 1 'Krawczyk' 's/^frequency 2/frequency 3/;s/^block 2 2/block 3 3/'
turns frequency-1 1 'frequency: it is beyond' 's/^frequency 2/frequency 1/;s/^block 2 2/block 1 1/'
turns block-0 1 'expected .block' '/^block 0/d'
turns below-missing 1 'cover: ' '/^cover 1 1/d'
turns above-missing 1 'cover: ' '/^cover 3/d'
turns itself-covered 1 'cover: ' 's/^cover 1 1/cover 1 2/'
turns not-c0 1 'expected .witness' 's/^reason frequency/reason not-c0/'
turns boundary 1 'boundary' 's/^boundary 0/boundary /'
turns point 1 'radius: the Krawczyk' 's/^eigenvector \(-*\)[0-6]/eigenvector \17/;s/^eigenvector \(-*\)[89a-f]/eigenvector \16/'
turns radius 1 'radius: the Krawczyk' 's/^radius .*/radius 1/'
turns eigenvalue 1 'radius: the Krawczyk' 's/^eigenvalue ./eigenvalue 5/'
told two-turns-30-inf 4..inf from-4 1 'frequency: it is beyond' 's/^valence 30/valence 4/'
told two-turns-30-inf 3..inf from-3 1 'frequency: it is beyond' 's/^valence 30/valence 3/'

rules() { told centre-rules-4-inf 4..inf "$@"; }
rules nothing 0 '^verified: centre-powers is not C1 at valences 4..inf (frequency 0: 0.86' ''
rules eigenvalue 1 'Krawczyk' 's/^eigenvalue d/eigenvalue c/'
rules frequency 1 'frequency: it is beyond' 's/^frequency 0/frequency 2/'
rules cover 1 'cover' 's/^cover 1/cover 2/'
rules graded 1 'eigenvector: expected more' 's/^form plain/form graded\nunit 1\ndegree 0\ngrades 0 0 0 0/;s/^reason frequency/reason not-c0/'

folds() { told fold-33-35 33..35 "$@"; }
folds nothing 0 '^verified: doo-sabin-spectrum is not C1 at valences 33..35' ''
folds one-witness 1 'witness' '0,/^witness/{/^witness/d;}'
folds same-sign 1 'witness' 's/^witness 8 .*/witness 4 0000/'
folds other-sign 1 'witness' 's/^witness 4 .*/witness 8 3333333/'
told fold-33-35 37..39 farther 1 'Krawczyk' 's/^valence 33 35/valence 37 39/'
folds radius 1 'radius: the Krawczyk' 's/^radius .*/radius 1/'
folds radius-large 2 'radius: expected a magnitude' 's/^radius .*/radius 1000000000000000000000000000000000/'
folds range 1 'range: it is smaller' 's/^range .*/range 1/'
folds point 1 'radius: the Krawczyk' 's/^eigenvector \(-*\)[0-6]/eigenvector \17/;s/^eigenvector \(-*\)[89a-f]/eigenvector \16/'
folds eigenvalue 1 'radius: the Krawczyk' 's/^eigenvalue ./eigenvalue 5/'
folds frequency 1 'frequency: it is beyond' 's/^frequency 1/frequency 2/'
folds cover 1 'cover: it ends too early' '/^cover 2 inf 800000000000/d'
folds not-c0 1 'expected .witness' 's/^reason fold/reason not-c0/'
folds order 1 'expected .radius' '/^radius/{
N
s/^\(.*\)\n\(.*\)$/\2\
\1/
}'

# A window of frequencies: Butterfly from 25 on

wave() { denial butterfly-25-inf "$catalogue/butterfly.scheme" 25..inf "$@"; }
wave nothing 0 '^verified: butterfly is not C1 at valences 25..inf (a window of frequencies: 0.502206842 <= |L| <= ' ''
denial butterfly-25-inf "$catalogue/butterfly.scheme" 24..inf wider 1 'window: it is not proved that the largest' 's/^valence 25/valence 24/'
denial butterfly-25-inf "$catalogue/butterfly.scheme" 25..90 fewer 0 '^verified' 's/^valence 25 inf/valence 25 90/'
wave frequency 1 'expected .pivot' 's/^frequency window/frequency 5/'
wave fold 1 'decimal' 's/^reason frequency/reason fold/'
wave not-c0 1 'decimal' 's/^reason frequency/reason not-c0/'
wave words 1 'no more values' 's/^frequency window/frequency window 5/'
wave form 1 'form' 's/^form real/form plain/'
wave window-early 1 'window: it begins too early' 's/^window .*/window a3d70a3d70a/'
wave window-not-too-early 1 'Krawczyk' 's/^window .*/window a3d70a3d70b/'
wave window-late 1 'wave: it does not go on' 's/^window .*/window 600000000000/'
wave bound-0 1 'bound' 's/^bound .*/bound 0/'
wave bound-negative 1 'bound' 's/^bound /bound -/'
wave bound-large 1 'window: it is not proved that the largest' 's/^bound ./bound 9/'
wave bound-one 1 'window: it is not proved that the largest' 's/^bound .*/bound 10000000000000000/'
wave bound-small 1 '\(cover\|wave\): the other' 's/^bound ./bound 7/'
wave wave-first-missing 1 'Krawczyk' '0,/^boundary/{
/^wave/,/^boundary/d
}'
wave cover-missing 1 'expected .cover' '/^cover/d'
wave cover-last-missing 1 'window: not all' '/^cover 1 inf 800000000000/d'
wave cover-over-window 1 'without the window' 's/^cover 1 inf 28b9af72015d/cover 1 inf 28b9af72015e/'
wave cover-frequency 1 'cover: expected .cover 1 inf' 's/^cover 1 inf 8/cover 2 inf 8/'
wave cover-number 1 'cover: expected .cover 1 inf' 's/^cover 1 inf 8/cover 1 100 8/'
wave block-0 1 'block 0 are not proved' 's/^block 0 0 .*/block 0 0 0/'
wave block-1 1 'expected .cover' 's/^block 0 0 .*/&\
block 1 1 9/'
wave boundary-leaf 1 'boundary: a leaf' 's/^boundary .*/boundary 0000/'
wave boundary-letter 1 'word' 's/^boundary ./boundary 2/'
wave range 1 'range: it is smaller' 's/^range .*/range 1/'
wave radius 1 'radius: the Krawczyk' 's/^radius .*/radius 1/'
wave radius-large 2 'radius: expected a magnitude' 's/^radius .*/radius 1000000000000000000000000000000000/'
wave point 1 'radius: the Krawczyk' 's/^eigenvector \(-*\)[0-6]/eigenvector \17/;s/^eigenvector \(-*\)[89a-f]/eigenvector \16/'
wave eigenvalue 1 'radius: the Krawczyk' 's/^eigenvalue ./eigenvalue 5/'
wave more 1 'expected .records' 's/^cover 1 inf 800000000000 .*/&\
witness 0 -/'

# Rules

# ruled NAME STATUS PATTERN CENTRE [CONDITION]: Loop's with a rule at (1,0) that says what the mask says.
ruled() {
  {
    cat "$catalogue/loop.scheme"
    echo "rule (1,0) ${5:-}
  centre $4
  (1,0) rest
  (1,0) @ 1 1/8
  (1,0) @ -1 1/8
end"
  } >ruled.scheme
  sed -e 's/#.*//' -e 's/[ 	][ 	]*/ /g' -e 's/^ //' -e 's/ $//' -e '/^$/d' ruled.scheme >text
  {
    echo "smoothcert-certificate 1"
    echo "scheme $(($(wc -l <text)))"
    cat text
    sed -n -e '/^records/,$d' -e 's/^regularity.*/regularity 222222222222/' -e 's/^boundary.*/boundary 2222/' -e '/^claim/,$p' "$here/loop-31-inf.cert"
  } >body
  finish body lie.cert
  claim "rule-$1" "$2" "$3" ruled.scheme 31..inf lie.cert
}
ruled constant 0 '^verified' 3/8
ruled depends-on-k 1 'rise: a weight of a rule depends on k or m' '3/8 + 0*k'
ruled depends-by-cases 1 'rise: a weight of a rule depends on k or m' 'cases(k > 5: 3/8; else: 1)'
ruled exponent-not-whole 1 'has no value' '3/8 + 0*(1/2)^(k*(1/2))'
ruled unbounded 1 'not bounded' 'k/8'
ruled condition-at-all 0 '^verified' 3/8 'when k > 30'
ruled condition-at-none 0 '^verified' 1/8 'when k < 31 or k = 7'
ruled condition-at-some 1 'not proved to hold at all' 3/8 'when k > 31'
ruled condition-at-one 1 'not proved to hold at all' 3/8 'when k != 100'
ruled condition-unknown 1 'not proved to hold at all' 3/8 'when mod(k, 2) = 0'
ruled condition-of-roots 1 'not proved to hold at all' 3/8 'when sqrt(k + 1) > 2'

# Folders

# folder NAME STATUS PATTERN VALENCES FILE...
folder() {
  name=$1 status=$2 pattern=$3 valences=$4
  shift 4
  rm -rf folder
  mkdir folder
  cp "$@" folder
  claim "folder-$name" "$status" "$pattern" "$catalogue/loop.scheme" "$valences" folder
}
a=$here/loop-9-10.cert b=$here/loop-20-30.cert c=$here/loop-31-inf.cert
folder partition 0 '^verified: loop is C1 at valences 31..inf' 20..inf "$b" "$c"
folder pieces 0 '^verified: loop is C1 at valences 9..10' 7,9..10,20..inf "$a" "$b" "$c" "$singles/loop-7.cert"
folder others 0 '^verified: loop is C1 at valences 9..10' 9,10 "$a" "$b" "$c" "$singles/loop-7.cert"
folder gap 1 'no certificate in folder is about the valences 11..19$' 9..inf "$a" "$b" "$c"
folder gap-first 1 'no certificate in folder is about valence 8$' 8..10 "$a"
folder gap-last 1 'no certificate in folder is about the valences 31..inf$' 20..inf "$b"
folder overlap 1 'both folder/loop-20-30.cert and folder/loop-20.cert are about valence 20$' 20..30 "$b" "$singles/loop-20.cert"
folder overlap-inside 1 'both .* are about valence 30$' 20..30 "$b" "$singles/loop-30.cert"
folder overlap-endless 1 'both .* are about valence 1000$' 31..inf "$c" "$singles/loop-1000.cert"
folder part 1 'loop-20-30.cert is about the valences 20..30, of which only a part is claimed' 20..25 "$b"
folder part-of-endless 1 'of which only a part is claimed' 20..40 "$b" "$c"
echo 'no certificate' >README
cp README .cert
folder other-files 0 '^verified: loop is C1 at valences 31..inf' 20..inf "$b" "$c" README .cert
claim file-of-several-ranges 2 'one certificate' "$catalogue/loop.scheme" 9..10,20 "$a"
claim file-of-another-range 1 'valence: expected 9..11' "$catalogue/loop.scheme" 9..11 "$a"

[ "$failures" = 0 ]
