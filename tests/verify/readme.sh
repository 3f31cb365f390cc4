#!/bin/sh
# The session in README: every command, and what it prints (but for seconds).
set -u
LC_ALL=C PATH=$BUILDDIR:$PATH
export LC_ALL PATH

# In one line, without what differs from run to run; where lines are folded depends on that, too.
plain() {
  tr '\n' ' ' | tr -s ' ' | sed 's/, [0-9.e-]* s;/, T s;/g; s/ $//'
  echo
}

# Commands begin with "    $ " and may go on behind a backslash; what follows without such a sign is their output.
# The first one builds the programs before; that is done.
awk '/^    [$] / { n++; going = 1; sub(/^    [$] (\.\/bootstrap && make && \.\/)?/, ""); print >("command" n); more = /\\$/; next }
     going && /^    / && more { print >("command" n); more = /\\$/; next }
     going && /^    / { sub(/^    /, ""); print >("output" n); next }
     { going = 0 }' "$SRCDIR/README"

n=1
while [ -f command$n ]; do
  [ -f output$n ] || : >output$n
  sh ./command$n 2>&1 | plain >found$n
  plain <output$n >expected$n
  if difference=$(diff expected$n found$n | sed -n 2p) && [ -z "$difference" ]; then
    echo "PASS readme-$n"
  else
    echo "FAIL readme-$n: $(head -n 1 command$n): $difference"
  fi
  n=$((n + 1))
done
if [ $n -ge 7 ]; then echo "PASS readme-session"; else echo "FAIL readme-session: only $((n - 1)) commands"; fi
