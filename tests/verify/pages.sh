#!/bin/sh
# The manual pages are sound, and speak of every command and option that the programs know; the pages' example of a certificate
# is one.
set -uf
LC_ALL=C
export LC_ALL

if command -v mandoc >/dev/null; then
  lint() { mandoc -T lint -W warning "$1"; }
elif command -v groff >/dev/null; then
  lint() { groff -mdoc -ww -z -T ascii "$1" 2>&1; }
else
  lint() { :; }
  echo "SKIP pages-lint: there is neither mandoc nor groff"
fi
for page in smoothcert.1 smoothcert-check.1 smoothcert-scheme.5 smoothcert-certificate.5; do
  complaints=$(lint "$SRCDIR/man/$page" | head -n 1)
  if [ -z "$complaints" ]; then echo "PASS pages-$page"; else echo "FAIL pages-$page: $complaints"; fi
done

options() { # from a --help text on stdin
  sed -n 's/^ *--\([a-z-]*\).*/\1/p'
}
pattern() { # of an option in a page
  sed 's/.*/Fl.-&([^a-z-]|$)/'
}
speaks() { # NAME PAGE PATTERN...
  name=$1 page=$SRCDIR/man/$2
  shift 2
  for pattern; do
    if ! grep -Eq -- "$pattern" "$page"; then
      echo "FAIL pages-$name: ${page##*/} has nothing like '$pattern'"
      return
    fi
  done
  echo "PASS pages-$name"
}
commands=$("$SMOOTHCERT" --help | sed -n 's/^  smoothcert \([a-z]*\) .*/\1/p')
for command in $commands; do
  # shellcheck disable=SC2046  # a list of words
  speaks "$command" smoothcert.1 "^\.It Cm $command( |\$)" $("$SMOOTHCERT" "$command" --help | options | pattern)
done
# shellcheck disable=SC2046  # a list of words
speaks check smoothcert-check.1 $("$SMOOTHCERT_CHECK" --help | options | pattern)

# The certificate of smoothcert-certificate(5) is what prove writes, and smoothcert-check accepts it.
sed -n '/^smoothcert-certificate 1/,/^\.Ed/p' "$SRCDIR/man/smoothcert-certificate.5" | sed '/^\.Ed/d' >page.cert
said=$("$SMOOTHCERT_CHECK" --scheme "$SRCDIR/lib/catalogue/loop.scheme" --valence 7 --claim c1 page.cert 2>&1)
case $said in
  "verified: loop is C1 at valence 7 "*) echo "PASS pages-certificate" ;;
  *) echo "FAIL pages-certificate: $said" ;;
esac
