#!/bin/sh
# Every complete file in smoothcert-scheme(5) is read and has a spectrum; the lines that the page proposes for the rules of
# its first example work in their place.
page=$SRCDIR/man/smoothcert-scheme.5

# An example is what stands between .Bd and .Ed and begins with `scheme NAME`, but for comments.
awk '/^\.Bd/ { inside = 1; n = 0; next }
     /^\.Ed/ { if (inside && n && example ~ /(^|\n)scheme /) { count++; printf "%s", example > ("example" count) } inside = 0; example = ""; next }
     inside { n++; gsub(/\\&/, ""); gsub(/\\-/, "-"); example = example $0 "\n" }' "$page"

count=0
for file in example*; do
  count=$((count + 1))
  for valence in 3 4 5 6 11; do
    if ! message=$("$SMOOTHCERT" spectrum "./$file" --valence $valence 2>&1 >/dev/null); then
      echo "FAIL man-$file: valence $valence: $message"
      continue 2
    fi
  done
  if "$SMOOTHCERT" regular "./$file" | grep -q 'complex: proved'; then echo "PASS man-$file"; else echo "FAIL man-$file: not C1 on the regular complex"; fi
done
if [ $count -ge 5 ]; then echo "PASS man-examples"; else echo "FAIL man-examples: only $count complete files"; fi

# A rule of the page in the place of the rules of a complete file.
replaces() { # NAME FILE SPECTRUM-HEAD (rules from stdin)
  { sed '/^rule/,$d' "$2"; cat; } >"$1.scheme"
  if head=$("$SMOOTHCERT" spectrum "./$1.scheme" --valence 5 2>&1 | head -n 1) && [ "${head#*, }" = "$3" ]; then
    echo "PASS man-rule-$1"
  else
    echo "FAIL man-rule-$1: $head"
  fi
}
rule_centre='rule centre
  centre     5/8
  all (1,0)  rest
end'
grep -q '^scheme my-ring' example2 || echo "FAIL man-my-ring: the second complete file is another one"
replaces mirror example1 'double intervals' <<EOF
$rule_centre
$(sed -n '/^rule (1,0)$/,/^end/p' "$page" | sed '/^end/q')
EOF
replaces spiral example2 'double intervals, complex blocks' <<EOF
$rule_centre
rule (1,0) when k != 6
  centre rest
$(sed -n '/^(1,0)  spectrum cases.*,/p' "$page")
end
EOF
for k in 1 2 3; do
  replaces "weight-$k" example1 'double intervals' <<EOF
rule centre
$(sed -n '/# Loop$/p; /# Warren$/p; /# 3\/(k(k+2)) each$/p' "$page" | sed -n ${k}p)
$(if [ $k -eq 3 ]; then echo centre rest; else echo 'all (1,0) rest'; fi)
end
EOF
done
replaces sectors example1 'double intervals' <<EOF
$rule_centre
$(sed -n '/^rule (1,0) when k = 4/,/^\.Ed/p' "$page" | sed '/^\.Ed/d')
EOF
