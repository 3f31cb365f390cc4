#!/bin/sh
# smoothcert spectrum: small valences in full, large ones by ranges, and what it refuses.
set -u
LC_ALL=C
export LC_ALL

# All of the words must be in what is printed.
says() { # NAME WORDS ARGUMENT...
  name=$1 words=$2
  shift 2
  if ! "$SMOOTHCERT" spectrum "$@" >printed 2>complaints || [ -s complaints ]; then
    echo "FAIL spectrum-$name: $(head -n 1 complaints)"
  elif grep -F -e "$words" printed >found; then
    echo "PASS spectrum-$name"
  else
    echo "FAIL spectrum-$name: expected '$words', found '$(tail -n 3 printed | head -n 1)'"
  fi
}

refuses() { # NAME WORDS ARGUMENT...
  name=$1 words=$2
  shift 2
  "$SMOOTHCERT" spectrum "$@" >printed 2>complaints
  status=$?
  if [ "$status" -eq 64 ] && [ ! -s printed ] && grep -F -e "$words" complaints >found; then
    echo "PASS spectrum-$name"
  else
    echo "FAIL spectrum-$name: status $status, $(head -n 1 complaints)"
  fi
}

# The same line of both, however the blocks are treated.
agrees() { # NAME PATTERN ARGUMENT...
  name=$1 pattern=$2
  shift 2
  "$SMOOTHCERT" spectrum "$@" | grep "$pattern" >short
  "$SMOOTHCERT" spectrum "$@" --blocks all | grep "$pattern" >long
  if [ -s short ] && cmp -s short long; then
    echo "PASS spectrum-$name"
  else
    echo "FAIL spectrum-$name: '$(cat short)' is not '$(cat long)'"
  fi
}

says small 'dominant: L = 0.530872450464' loop --valence 7
says small-blocks 'block 3' loop --valence 7
says small-tie 'no eigenvalue but 1 is certainly larger' butterfly --valence 3
says small-frequency 'in block 2, simple' butterfly --valence 8
says verdict 'C1 here: proved' loop --valence 7
says verdict-refuted 'C1 here: refuted; frequency 2 dominates' butterfly --valence 8
says signs 'signs of normals: all alike' butterfly --valence 8
says signs-cups 'signs of normals: they sum to 0' loop-ring --set z=3/4 --valence 5
says waves 'Theorem 6.1: lambda > |mu_0|, hence C1' wave --valence 3
says waves-nothing 'Theorem 6.1: lambda < |mu_0|, nothing follows' catmull-clark-weights --set alpha=9/10 --set beta=1/20 --valence 5
says json-verdict '"c1":"proved","signs_alike":true,"waves_inequality":null' loop --valence 7 --json
says valence-100 'block 49' loop --valence 100
says valence-101 'blocks 4 to' loop --valence 101
says json '"ranges":[{"first":4,' loop --valence 1000 --json
says json-small '"ranges":[],"dominant":' loop --valence 7 --json

for scheme in loop butterfly catmull-clark modified-butterfly loop-spiral doo-sabin; do
  agrees "all-blocks-$scheme" '^dominant' $scheme --valence 157
done

# Neighbouring blocks agree to more digits than doubles have.
for k in 1000000000 1000000000000000; do
  says "loop-$k" 'dominant: L = 0.62500000' loop --valence $k
  says "loop-doubles-$k" 'double intervals' loop --valence $k
  says "catmull-clark-$k" 'in block 1, simple' catmull-clark --valence $k
  says "modified-butterfly-$k" 'runner-up: mu < 0.250000001' modified-butterfly --valence $k
done
says modified-loop 'dominant: L = 0.5 in block 1, simple' modified-loop --valence 1000000000
says complex 'modulus > 0.53851648 in block 1, simple' loop-spiral --valence 1000000000
says balls 'balls of 256 bits' loop --valence 1000000000 --precision 256
says balls-dominant 'in block 1, simple' loop --valence 1000000000 --precision 256
# The largest is in the middle: near k / 5.19.
says interior 'in block 193, simple' butterfly --valence 1000
says interior-large 'in block 1927494, simple' butterfly --valence 10000000
# It is at w = pi, where L is even in u.
says at-pi 'in block 500000, simple' "$SRCDIR/bench/twelve.scheme" --valence 1000001
# Block 0 has the largest.
says block-0 'in block 0, simple' loop-ring --valence 1000000 --set z=3/4

# A rule may name the centre twice.
cat >twice.scheme <<'END'
scheme twice
mesh triangle
dilation 2
vertices interior
mask symmetric
  (0,0) 5/8
  (1,0) 3/8
  (1,1) 1/8
  (2,0) 1/16
end
rule centre
  centre 7/8
  centre 1/4
  all (1,0) rest
end
END
says centre-twice '  0.75000000000000' ./twice.scheme --valence 5
# Without any rule the regular valence has the spectrum that explicit weights give there; others have none.
sed '/^rule/,$d' twice.scheme >ruleless.scheme
cat >bicubic.scheme <<'END'
scheme bicubic
mesh quad
dilation 2
vertices interior
mask symmetric
  (0,0) 9/16
  (1,0) 3/8
  (2,0) 3/32
  (1,1) 1/4
  (2,1) 1/16
  (2,2) 1/64
end
END
same_spectrum() { # NAME VALENCE SCHEME SCHEME
  for s in "$3" "$4"; do
    for p in 64 256; do
      "$SMOOTHCERT" spectrum "$s" --valence "$2" --precision $p | sed '1d;/^Chen/d;s/ +\/- [^ ]*//g'
    done >"spectrum-of-$(basename "$s")"
  done
  if [ -s "spectrum-of-$3" ] && cmp -s "spectrum-of-$3" "spectrum-of-$(basename "$4")"; then
    echo "PASS spectrum-$1"
  else
    echo "FAIL spectrum-$1: $(sed -n 2,3p "spectrum-of-$3") instead of $(sed -n 2,3p "spectrum-of-$4")"
  fi
}
same_spectrum ruleless-triangles 6 ruleless.scheme loop
same_spectrum ruleless-quads 4 bicubic.scheme catmull-clark
"$SMOOTHCERT" spectrum ./ruleless.scheme --valence 7 >printed 2>complaints
if [ $? -eq 65 ] && [ ! -s printed ] && grep -q 'no rule for the extraordinary vertex' complaints; then
  echo 'PASS spectrum-ruleless-elsewhere'
else
  echo "FAIL spectrum-ruleless-elsewhere: $(head -n 1 complaints)"
fi
# One rule is enough for the neighbourhood not to be regular.
cat ruleless.scheme - >one-rule.scheme <<'END'
rule (1,0)
  centre 3/8
  (1,0) 3/8
  all (1,0) 1/8
  (1,0) @ 1 rest
end
END
"$SMOOTHCERT" spectrum ./one-rule.scheme --valence 6 >printed 2>complaints
if [ $? -eq 65 ] && [ ! -s printed ] && grep -q 'no rule for the extraordinary vertex' complaints; then
  echo 'PASS spectrum-one-rule'
else
  echo "FAIL spectrum-one-rule: $(head -n 1 complaints)"
fi
# Opposite eigenvalues of a block of complex numbers are no conjugates.
cat >opposite.scheme <<'END'
scheme opposite
mesh triangle
dilation 2
vertices interior
mask symmetric
  (0,0) 5/8
  (1,0) 3/8
  (1,1) 1/8
  (2,0) 1/16
end
rule centre
  centre 5/8
  all (1,0) rest
end
rule (1,0)
  centre rest
  (1,0) spectrum cases(m = 0: 5/8; m = 1: 1/2; else: 1/8), 0
end
rule (1,1)
  centre rest
  (1,1) spectrum cases(m = 1: -1/2; else: 0)
end
END
says opposite 'no eigenvalue but 1 is certainly larger' ./opposite.scheme --valence 5
# -1 is not 1, and without a tangent plane there is no curvature.
cat >minus.scheme <<'END'
scheme minus
mesh triangle
dilation 2
vertices interior
mask symmetric
  (0,0) 5/8
  (1,0) 3/8
  (1,1) 1/8
  (2,0) 1/16
end
rule centre
  centre 3/8 - 1
  all (1,0) rest
end
END
# Blocks of which nothing is known are no want of memory.
cat >unknown.scheme <<'END'
scheme unknown
mesh triangle
dilation 2
vertices interior
mask symmetric
  (0,0) 5/8
  (1,0) 3/8
  (1,1) 1/8
  (2,0) 1/16
end
rule centre
  centre 5/8
  all (1,0) rest
end
rule (1,0)
  centre rest
  (1,0) spectrum cases(m = 0: 5/8; m = 1: 1/2; else: (1/2)^abs(m - 7777))
end
END
says unknown 'in block 1, simple' ./unknown.scheme --valence 101
says minus-one 'dominant: L = -1.0' ./minus.scheme --valence 5
"$SMOOTHCERT" spectrum ./minus.scheme --valence 5 >printed
if grep curvature printed >found; then
  echo "FAIL spectrum-no-curvature: $(cat found)"
else
  echo "PASS spectrum-no-curvature"
fi

refuses valence-2 'expected one valence from 3 to 1000000000000000' loop --valence 2
refuses valence-large 'expected one valence from 3 to 1000000000000000' loop --valence 1000000000000001
refuses blocks "expected 'all'" loop --valence 7 --blocks some
refuses blocks-large 'up to valence 100000 only' loop --valence 100001 --blocks all
refuses no-valence 'no valence given' loop
exit 0
