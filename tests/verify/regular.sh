#!/bin/sh
# smoothcert regular: the printed answers, and what it refuses.
set -u
LC_ALL=C
export LC_ALL

mask() { # NAME MESH, the mask's entries from stdin
  printf 'scheme %s\nmesh %s\ndilation 2\nvertices interior\nparameter w = 1/16\nmask symmetric\n' "$1" "$2"
  cat
  echo end
}
mask butterfly triangle >butterfly.scheme <<EOF
(0,0) 1
(1,0) 1/2
(1,1) 2*w
(2,1) -w
EOF
mask linear triangle >linear.scheme <<EOF
(0,0) 1
(1,0) 1/2
EOF
mask uneven quad-dual >uneven.scheme <<EOF
(1/2,1/2) 9/16
(1/2,3/2) 2/16
(3/2,3/2) 3/16
EOF

# What is printed is compared word by word, blanks aside.
prints() { # NAME ARGUMENT...   (the expected text from stdin)
  name=$1
  shift
  tr -s ' \n' '\n\n' >expected
  if "$SMOOTHCERT" regular "$@" >printed 2>complaints && [ ! -s complaints ]; then
    tr -s ' \n' '\n\n' <printed >words
    if difference=$(cmp expected words 2>&1); then echo "PASS regular-$name"; else echo "FAIL regular-$name: $difference"; fi
  else
    echo "FAIL regular-$name: $(head -n 1 complaints)"
  fi
}

refuses() { # NAME STATUS ARGUMENT...
  name=$1 wanted=$2
  shift 2
  "$SMOOTHCERT" regular "$@" >printed 2>complaints
  status=$?
  if [ $status -eq "$wanted" ] && [ ! -s printed ] && [ "$(wc -l <complaints)" -eq 1 ]; then
    echo "PASS regular-$name"
  else
    echo "FAIL regular-$name: status $status: $(cat printed complaints | head -n 1)"
  fi
}

prints loop loop <<EOF
loop: triangles, 19 mask points, equal to its mirror image

N |S_a1^N| |S_2a12^N| |S_2a13^N|
1 1/2 = 0.5 1/2 = 0.5 1/2 = 0.5

C1 on the regular complex: proved by |S_2a12^1| < 1, |S_2a13^1| < 1

values C = 1/2 = 0.5 K = 1: no weight is negative
derivatives C1 = C2 = 1/2 = 0.5 K1, K2 = 1: no weight is negative

The least constants are above. By decompositions (Zorin's thesis, 4.22 to 4.27):
as printed C = 7/8 = 0.875, C1 = C2 = 3/2 = 1.5
as proved C = 3/4 = 0.75, C1 = C2 = 1
EOF

prints butterfly butterfly.scheme --all --max-power 5 <<EOF
butterfly: triangles, 25 mask points, equal to its mirror image

N |S_a1^N| |S_2a12^N| |S_2a13^N|
1 7/8 = 0.875 1 1
2 31/64 = 0.484375 7/8 = 0.875 7/8 = 0.875
3 261/1024 = 0.254883 11/16 = 0.6875 11/16 = 0.6875
4 2091/16384 = 0.127625 1/2 = 0.5 1/2 = 0.5
5 8441/131072 = 0.0643997 11/32 = 0.34375 11/32 = 0.34375

C1 on the regular complex: proved by |S_2a12^2| < 1, |S_2a13^2| < 1

values C = 1/2 = 0.5 K <= 777/512 < 1.5176 by windows of S^6
derivatives C1 = C2 = 3/4 = 0.75 K1, K2 <= 2149/1024 < 2.0987 by windows of S_2a1^7

The least constants are above. By decompositions (Zorin's thesis, 4.22 to 4.27):
as printed C = 3/4 = 0.75, C1 = C2 = 5/4 = 1.25
as proved C = 1/2 = 0.5, C1 = C2 = 1
EOF

prints json butterfly.scheme --json --set w=0 --max-power 2 <<EOF
{
  "scheme": "butterfly",
  "mesh": "triangle",
  "mirror_symmetric_mask": true,
  "divisible": true,
  "norms": [
    {"power": 1, "a1": "1/2", "2a12": "1", "2a13": "1"},
    {"power": 2, "a1": "1/4", "2a12": "1", "2a13": "1"}
  ],
  "comparison": {"C": "0", "C1": "0", "C2": "0"},
  "comparison_thesis": {"C": "0", "C1": "0", "C2": "0"},
  "comparison_decomposition": {"C": "0", "C1": "0", "C2": "0"},
  "comparison_thesis_is_bound": true,
  "stability": {
    "K": {"method": "none"},
    "K1": {"method": "none"},
    "K2": {"method": "none"}
  },
  "refutation": {"modulus_at_least": 0.5, "frequency": 3, "seen_at": [1, 0]},
  "c1_on_regular_complex": "refuted"
}
EOF

prints linear linear.scheme --max-power 1 <<EOF
linear: triangles, 7 mask points, equal to its mirror image

N |S_a1^N| |S_2a12^N| |S_2a13^N|
1 1/2 = 0.5 1 1

C1 on the regular complex: no; besides those of constant and linear functions there is an
eigenvalue of modulus >= 0.5 (frequency 3), and its eigenfunction is not 0

values C = 0 no bound of K
derivatives C1 = C2 = 0 no bound of K1, K2

The least constants are above. By decompositions (Zorin's thesis, 4.22 to 4.27):
as printed C = 0, C1 = C2 = 0
as proved C = 0, C1 = C2 = 0
EOF

prints uneven uneven.scheme <<EOF
uneven: quads, dual, 16 mask points, equal to its mirror image

The mask is not divisible by 1 + z^-d in the directions needed, and there are no norms.

C1 on the regular complex: no; besides those of constant and linear functions there is an
eigenvalue of modulus >= 0.5 (frequency 2), and its eigenfunction is not 0
EOF

# Four times the tension is an eigenvalue: just below 1/2 nothing is known, 1 is too much even to converge.
answers() { # NAME PATTERN ARGUMENT...
  name=$1 pattern=$2
  shift 2
  if "$SMOOTHCERT" regular "$@" | grep -q "$pattern"; then echo "PASS regular-$name"; else echo "FAIL regular-$name: no '$pattern'"; fi
}
answers refuted 'modulus >= 0.599609375 (frequency 0)' butterfly.scheme --set w=0.15
answers undecided 'undecided; no power up to 6' butterfly.scheme --set w=127/1024
answers divergent 'does not change there' butterfly.scheme --set w=1/4

refuses no-scheme 64
refuses two-schemes 64 loop loop
refuses power-0 64 loop --max-power 0
refuses power-10 64 loop --max-power 10
refuses unknown-option 64 loop --norm
refuses unknown-scheme 65 nothing-like-it
refuses unknown-parameter 65 butterfly.scheme --set v=1
refuses no-file 74 ./nothing.scheme
