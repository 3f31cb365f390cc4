#!/bin/sh
# Random mutants of good certificates: the checker must not crash, and whatever it accepts must state the claim.
#
# MUTANTS (default 400) are made; four out of five get a right count of records and a right hash.  An accepted mutant
# must have been made right, and be unchanged up to its valence: it then differs only in choices or does not differ.
# SMOOTHCERT_SEED (default 1) and MUTANT, a number, repeat one of them and leave its file as ./mutant.
set -u
LC_ALL=C
export LC_ALL
here=$SRCDIR/tests/certificates
seed=${SMOOTHCERT_SEED:-1}
count=${MUTANTS:-400}
batch=200

scheme_file() { # NAME
  if [ "$1" = loop ]; then echo "$SRCDIR/lib/catalogue/loop.scheme"; else echo "$here/schemes/$1.scheme"; fi
}

# Writes mutants FROM..TO as body-N (without its last line, if it is to be made right) and a line "N RIGHT NAME SCHEME
# VALENCE" for each.  Every mutant draws from a generator of its own (Lehmer's, multiplier 16807, exact in doubles).
make_mutants() { # FROM TO
  sed '/^#/d' "$here/accept/table" | awk -v seed="$seed" -v from="$1" -v to="$2" -v folder="$here/accept" '
    function random(n) { state = state * 16807 % 2147483647; return int(state / 2147483647 * n) }
    function pick(text,   n, part) { n = split(text, part, "|"); return part[1 + random(n)] }
    function join(   i, s) { s = token[1]; for (i = 2; i <= tokens; i++) s = s " " token[i]; return s }

    function some_integer(   i, n, s) {
      s = pick("0|1|-1|2|20|-20|ffffffffffffffff|8000000000000000|-8000000000000000|100000000|7fffffff|10000000000000000|c")
      if (random(4) == 0) { n = 1 + random(60); s = pick("1|2|7|8|f|-1|-f"); for (i = 0; i < n; i++) s = s pick("0|1|8|f|a") }
      return s
    }

    function some_decimal() {
      return pick("0|1|2|3|4|5|6|7|8|10|11|12|20|40|41|60|63|64|65|100|127|128|200|256|300|512|513|4095|4096|4097|8192|8193|65536|4294967296|999999999|1000000000|18446744073709551616")
    }

    function mutate_character(s,   i, n) {
      n = length(s)
      i = 1 + random(n + 1)
      n = random(4)
      if (n == 0) return substr(s, 1, i - 1) substr(s, i + 1)
      if (n == 1) return substr(s, 1, i - 1) sprintf("%c", 1 + random(255)) substr(s, i)
      return substr(s, 1, i - 1) pick("0|1|2|9|a|f|F|-| |.|/|k|#") substr(s, i + (n == 2))
    }

    # A word of trees: splits to leaves, leaves to splits, parts repeated or left out.
    function mutate_word(s,   i, j) {
      i = 1 + random(length(s))
      j = i + random(length(s) - i + 1)
      if (random(2)) return substr(s, 1, i - 1) pick("0|1|0000|10000|100") substr(s, i + 1)
      return substr(s, 1, j) substr(s, random(2) ? j + 2 : i)
    }

    # Another number of the same length.
    function nudge(s,   i) {
      i = length(s) - random(length(s) < 6 ? length(s) : 6)
      return substr(s, 1, i - 1) pick("1|2|3|7|9") substr(s, i + 1)
    }

    function mutate_token(s,   n) {
      n = random(14)
      if (n > 8) return s ~ /^[01][01][01]+$/ ? mutate_word(s) : nudge(s)
      if (n == 0) return some_integer()
      if (n == 1) return some_decimal()
      if (n == 2) return s ~ /^-/ ? substr(s, 2) : "-" s
      if (n == 3 && length(s) > 1) return substr(s, 1, length(s) - 1)
      if (n == 4) return s pick("0|1|8|f")
      if (n == 5) return "0" s
      if (n == 6 && s ~ /^[01]+$/) return mutate_word(s)
      return mutate_character(s)
    }

    function mutate_line(s,   i, j, n, t) {
      tokens = split(s, token, " ")
      if (tokens == 0) return some_integer()
      i = 1 + random(tokens)
      if (i == 1 && tokens > 1 && random(8)) i = 2 + random(tokens - 1)
      j = 1 + random(tokens)
      n = random(10)
      if (n == 0) { token[i] = token[i] " " token[i] }
      else if (n == 1 && tokens > 1) { t = token[i]; token[i] = token[j]; token[j] = t }
      else if (n == 2) { token[i] = token[j] }
      else if (n == 3) return mutate_character(s)
      else token[i] = mutate_token(token[i])
      return join()
    }

    function mutate(   i, j, k, n) {
      i = 1 + random(lines)
      if (i <= heading && random(4)) i = heading + 1 + random(lines - heading)
      j = 1 + random(lines)
      n = random(24)
      if (n == 0) { for (k = i; k < lines; k++) line[k] = line[k + 1]; lines-- }
      else if (n == 1) { for (k = ++lines; k > i; k--) line[k] = line[k - 1] }
      else if (n == 2) { k = line[i]; line[i] = line[j]; line[j] = k }
      else if (n == 3) { line[i] = line[j] }
      else line[i] = mutate_line(line[i])
    }

    { name[NR] = $1; scheme[NR] = $2; valence[NR] = $3 }

    END {
      for (m = from; m <= to; m++) {
        state = (seed * 7919 + m * 104729) % 2147483646 + 1
        for (i = 0; i < 10; i++) random(2)
        base = 1 + random(NR)
        lines = heading = 0
        file = folder "/" name[base] ".cert"
        while ((getline text < file) > 0) { line[++lines] = text; if (text ~ /^valence /) heading = lines }
        close(file)
        right = random(5) > 0
        if (right) lines -= 2
        for (i = 1 + (random(3) == 0) * random(4); i > 0 && lines > heading + 1; i--) mutate()
        out = "body-" m
        for (i = 1; i <= lines; i++) print line[i] > out
        if (right) { n = 0; for (i = 1; i <= lines; i++) n += 1 + gsub(/\n/, "\n", line[i]); print "records " n > out }
        close(out)
        print m, right, name[base], scheme[base], valence[base]
      }
    }'
}

# The head of a certificate: everything that is no choice.
head_of() { # FILE
  sed '/^valence /q' "$1"
}

try_mutants() { # reads what make_mutants wrote
  while read -r number right name scheme valence; do
    if [ "$right" -eq 1 ]; then
      read -r digest _ <&3
      echo "sha256 $digest" >>"body-$number"
    fi
    "$SMOOTHCERT_CHECK" --scheme "$(scheme_file "$scheme")" --valence "$valence" --claim c1 "body-$number" >stdout 2>stderr
    status=$?
    if [ "$status" -gt 2 ]; then
      echo "BAD $number the checker ended with status $status"
    elif [ "$status" -ne 0 ] && [ -s stdout ]; then
      echo "BAD $number not verified, but something is on stdout"
    elif [ "$status" -eq 0 ] && ! grep -q "^verified: .* is C1 at valence $valence (" stdout; then
      echo "BAD $number accepted, but not with the claim"
    elif [ "$status" -ne 0 ]; then
      echo "$status"
    elif cmp -s "body-$number" "$here/accept/$name.cert"; then
      echo same
    elif [ "$right" -eq 0 ]; then
      echo "BAD $number accepted with a wrong hash"
    elif [ "$(head_of "body-$number")" = "$(head_of "$here/accept/$name.cert")" ]; then
      echo 0
    else
      echo "BAD $number accepted with another statement"
    fi
    if [ -n "${MUTANT:-}" ]; then mv "body-$number" mutant; else rm "body-$number"; fi
  done
}

first=1
last=$count
if [ -n "${MUTANT:-}" ]; then
  first=$MUTANT
  last=$MUTANT
fi
while [ "$first" -le "$last" ]; do
  to=$((first + batch - 1))
  [ "$to" -le "$last" ] || to=$last
  make_mutants "$first" "$to" >list
  awk '$2 == 1 { print "body-" $1 }' list >names
  if [ -s names ]; then xargs sha256sum <names >digests; else : >digests; fi
  try_mutants <list 3<digests
  first=$((to + 1))
done >answers

if grep '^BAD' answers >bad; then
  sed -n 's/^BAD \([0-9]*\) \(.*\)/\2 (SMOOTHCERT_SEED='"$seed"' MUTANT=\1)/p' bad | head -n 1 | sed 's/^/FAIL mutate: /'
  exit 1
fi
awk '{ n[$1]++ } END { printf "%d accepted, %d rejected, %d cannot be checked, %d unchanged\n", n["0"], n["1"], n["2"], n["same"] }' answers >&2
# Mutants that are all rejected at once would test nothing.
if [ -z "${MUTANT:-}" ] && [ "$count" -ge 200 ] && ! grep -q '^0' answers; then
  echo "FAIL mutate: no mutant was accepted: they do not reach the choices"
  exit 1
fi
echo "PASS mutate"
