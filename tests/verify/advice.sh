#!/bin/sh
# What `prove` advises where it has no verdict; where it names an option, following it decides.
set -u
LC_ALL=C
export LC_ALL

advises() { # NAME PATTERN ARGUMENT...
  name=$1 pattern=$2
  shift 2
  said=$("$SMOOTHCERT" prove "$@" --out none 2>&1)
  if printf '%s\n' "$said" | grep -q "^undecided: .*; $pattern, [^;]* s\$"; then
    echo "PASS advice-$name"
  else
    echo "FAIL advice-$name: $said"
  fi
}

# The line names an option with a value; with it in place of the option that was too little there is a verdict.
helps() { # NAME OPTION ARGUMENT...
  name=$1 option=$2
  shift 2
  value=$("$SMOOTHCERT" prove "$@" --out none 2>&1 | sed -n "s/^undecided: .*; try $option \([0-9]*\), [^;]* s\$/\1/p")
  said=$("$SMOOTHCERT" prove "$@" "$option" "${value:-none}" --out none 2>&1)
  case $said in
    proved:* | refuted:*) echo "PASS advice-$name" ;;
    *) echo "FAIL advice-$name: advice '$value': $said" ;;
  esac
}

helps levels --max-level modified-butterfly --valence 3 --max-level 2 --max-precision 0
helps bits --max-precision loop-ring --set l2=1/2-1/10^20 --valence 7 --max-precision 0
# Two equal eigenvalues that no cyclotomic field holds.
"$SMOOTHCERT" schemes loop-ring | sed 's/cases(m = 0: a; m = 1: l; m = 2: l2; else: others)/cases(m = 0: a; m = 1: sqrt(2)\/3; m = 2: sqrt(2)\/3; else: others)/' >tie.scheme
advises tie "more bits will hardly help if eigenvalues are equal: see 'smoothcert spectrum' at this valence" ./tie.scheme --valence 7 --max-precision 1024
advises uniform 'try --method adaptive, or --max-level 2' loop --valence 5 --method uniform --max-level 1
advises time 'try a longer --time-limit' midpoint --set degree=9 --valence 1000 --time-limit 0.0001
printf 'scheme linear\nmesh triangle\ndilation 2\nvertices interior\nmask symmetric\n(0,0) 1\n(1,0) 1/2\nend\nrule centre\ncentre 1/2\nall (1,0) rest\nend\n' >linear.scheme
advises regular "no option helps: see 'smoothcert regular'" ./linear.scheme --valence 5
if "$SMOOTHCERT" prove butterfly --valence 3 --max-precision 64 --out none --json | grep -q '"advice":"try --max-precision 128"'; then
  echo "PASS advice-json"
else
  echo "FAIL advice-json: there is none"
fi
