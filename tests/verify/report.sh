#!/bin/sh
# smoothcert report: pages and figures of all kinds of verdicts; and directories that are not what they should be.
set -u
LC_ALL=C
export LC_ALL

holds() { # NAME STATUS REASON
  if [ "$2" -eq 0 ]; then echo "PASS report-$1"; else echo "FAIL report-$1: $3"; fi
}

# Makes a page, and looks at it: tags in pairs, no numbers that are none, nothing from elsewhere.
report() { # NAME ARGUMENT... of prove
  name=$1
  shift
  "$SMOOTHCERT" prove "$@" --out "$name" >lines 2>&1
  said=$("$SMOOTHCERT" report "$name" --svg "$name.svg" 2>&1)
  status=$?
  page=$name/report.html
  if [ $status -ne 0 ]; then
    echo "FAIL report-$name: $said"
    return
  fi
  for tag in svg g text title figure table tr td pattern; do
    if [ "$(grep -o "<${tag}[ >]" "$page" | wc -l)" -ne "$(grep -o "</$tag>" "$page" | wc -l)" ]; then
      echo "FAIL report-$name: not every <$tag> is closed"
      return
    fi
  done
  if found=$(grep -Eio '"[^" ]*(nan|inf)[^" ]*"|[MLx]-?nan|<script|(src|href)="[^#][^"]*"|url\([^#]|@import' "$page" | grep -v '^"nan-' | head -n 1) && [ -n "$found" ]; then
    echo "FAIL report-$name: the page has $found"
    return
  fi
  for figure in "$name.svg"/*.svg; do
    if ! head -n 1 "$figure" | grep -q '^<svg xmlns=' || [ "$(tail -n 1 "$figure")" != '</svg>' ]; then
      echo "FAIL report-$name: $figure is no drawing"
      return
    fi
  done
  echo "PASS report-$name"
}

has() { # NAME FILE PATTERN
  grep -Eq -- "$3" "$2" 2>grep.log
  holds "$1" $? "$2 has nothing like '$3'"
}

report proved loop --valence 3..12
has proved-sentence proved/report.html 'Proved:</b> the scheme is C1 at valence 3\.\.12\.'
has proved-digest proved/report.html "title=\"$(awk '$1 == 7 { print $3 }' proved/index)\""
has proved-check proved/report.html '^<pre>smoothcert-check --scheme scheme.scheme --claim c1 --valence 3,4,5,6,7,8,9,10,11,12 \.'
has proved-title proved/report.html '>Characteristic map of loop, valence 3<'
# shellcheck disable=SC2012  # these names are simple
[ "$(ls proved.svg | tr '\n' ' ')" = "eigenpair.svg eigenvalues.svg elements.svg errors.svg jacobian.svg levels.svg limit.svg map-12.svg map-3.svg map-6.svg map-9.svg precision.svg spectrum-12.svg spectrum-3.svg spectrum-6.svg spectrum-9.svg " ]
holds proved-figures $? "the figures are $(echo proved.svg/*)"

# As the page says, in the directory itself.
command=$(sed -n 's/^<pre>smoothcert-check //p' proved/report.html)
# shellcheck disable=SC2086  # words
(cd proved && "$SMOOTHCERT_CHECK" $command) >log 2>&1
holds page-command $? "$(head -n 1 log)"

report mixed butterfly --valence 3,7,8 --max-precision 64
has mixed-refuted mixed/report.html 'not C1 at valence 8\.'
has mixed-undecided mixed/report.html 'nothing is known at valence 3;'
has mixed-reason mixed/report.html 'eigenpair: no box round'
has mixed-curve mixed.svg/curve-8.svg 'the image winds 2 times'
has mixed-bar mixed.svg/spectrum-8.svg 'block 2, too large'
has mixed-check mixed/report.html '^smoothcert-check .* --claim not-c1 --valence 8 \.'

report folded loop-ring --set l=99/100 --valence 7
has folded-place folded.svg/map-7.svg '^<path d="M.*fill="url\(#map-7-negative\)"'
has folded-sentence folded/report.html 'the characteristic map folds'

report wound "$SRCDIR/tests/certificates/schemes/winding-quad.scheme" --valence 5
has wound-curve wound.svg/curve-5.svg 'the image winds -4 times'
has wound-sentence wound/report.html 'the characteristic map does not wind once: -4'

report spiral loop-spiral --valence 5,300
report dual doo-sabin --valence 5
report quads catmull-clark --valence 5,1000000
report large butterfly --valence 1000
report all loop --valence all
has all-sentence all/report.html 'Proved:</b> the scheme is C1 at valence 3\.\.inf \(without end\)\.'
has all-map all/report.html '>Characteristic map of loop, valence 3<'
report uniform modified-loop --method uniform --valence 5
has uniform-error uniform.svg/errors.svg 'uniform method'
printf 'scheme grows\nmesh triangle\ndilation 2\nvertices interior\nmask symmetric\n(0,0) 5/8\n(1,0) 3/8\n(1,1) 1/8\n(2,0) 1/16\nend\nrule centre\ncentre 2\nall (1,0) rest\nend\n' >grows.scheme
report discontinuous ./grows.scheme --valence 5
has discontinuous-bar discontinuous.svg/spectrum-5.svg 'block 0, too large'

"$SMOOTHCERT" report proved --valence 5,7 --out one.html --svg one.svg >log 2>&1 && [ -f one.svg/map-5.svg ] && [ -f one.svg/map-7.svg ] && [ ! -f one.svg/map-3.svg ]
holds chosen $? "the chosen maps are not those that were drawn"
"$SMOOTHCERT" report proved --out again.html >log 2>&1 && cmp -s again.html proved/report.html
holds same $? "two reports of one directory differ"

refuses() { # NAME STATUS MESSAGE ARGUMENT...
  name=$1 wanted=$2 message=$3
  shift 3
  "$SMOOTHCERT" report "$@" >stdout 2>stderr
  status=$?
  [ $status -eq "$wanted" ] && [ ! -s stdout ] && [ "$(wc -l <stderr)" -eq 1 ] && grep -q -- "$message" stderr
  holds "$name" $? "status $status, $(cat stdout stderr | head -n 1)"
}
refuses nothing 64 'expected one directory'
refuses unknown 64 'unknown option' proved --page
refuses bad-valence 64 '--valence' proved --valence x
mkdir empty
refuses empty 65 "expected a directory of 'smoothcert prove'" empty
refuses missing 65 "expected a directory of 'smoothcert prove'" nowhere
cp -r proved no-index && rm no-index/index
refuses no-index 65 'the index does not say what is there' no-index
cp -r proved garbled && echo '5 perhaps' >>garbled/index
refuses garbled 65 'the index does not say what is there' garbled
cp -r proved forged && sed -i 's/^valence 7$/valence 8/' forged/valence-7.cert
refuses forged 65 'the certificate of valence 7 is damaged' forged
# A lie with the right digest: the Jacobian of valence 3 is not positive by these trees.
cp -r proved lie && sed -i 's/^regularity .*/regularity 0/' lie/valence-5.cert
digest=$(sed '$d' lie/valence-5.cert | sha256sum | cut -d ' ' -f 1)
sed -i "s/^sha256 .*/sha256 $digest/" lie/valence-5.cert
sed -i "s/^5 proved [0-9a-f]*/5 proved $(sha256sum <lie/valence-5.cert | cut -d ' ' -f 1)/" lie/index
rm lie/journal
refuses lie 65 'the certificate of valence 5 does not prove what it claims' lie
cp -r proved lost && rm lost/valence-9.cert
refuses lost 65 'the index does not say what is there' lost
refuses no-place 74 'nowhere/page.html' proved --out nowhere/page.html
if [ -w /dev/full ]; then refuses full 74 '/dev/full: No space left' proved --out /dev/full; fi
