#!/bin/sh
# usage: fuzz.sh SOURCE SECONDS [TARGET...]
#
# Runs each fuzz target for so many seconds, with libFuzzer and the address and undefined-behaviour sanitizers of
# clang, in ./fuzz (made if need be).  fuzz/TARGET.found/ is the corpus, which a next run goes on with; the first one
# begins with the catalogue, the certificates of tests/certificates/ and tests/fuzz/inputs/TARGET/.  What crashes, leaks
# or takes longer than 25 seconds is left in fuzz/ and ends the run with status 1.
#
# Afterwards fuzz/TARGET.least/ has the smallest inputs that reach the same places: to be looked at, and copied to
# tests/fuzz/inputs/TARGET/ where they are new.
set -eu
LC_ALL=C
export LC_ALL

source=$(cd "$1" && pwd)
seconds=$2
shift 2
[ $# -gt 0 ] || set -- check-scheme check-certificate check-arguments scheme certificate formula valences

sanitizers=address,undefined
flags="-g -O1 -fno-omit-frame-pointer -fno-sanitize-recover=all"
mkdir -p fuzz
cd fuzz

# The project's libraries, for the targets that are not the checker's: of a copy, for the sources may be configured.
build_libraries() {
  mkdir -p copy
  (cd "$source" && tar cf - --exclude='*.o' --exclude='*.a' --exclude=.deps configure configure.ac aclocal.m4 build-aux Makefile.am Makefile.in \
    config.h.in bigfloat lib verify tests bench) | (cd copy && tar xf -)
  [ -f copy/Makefile ] || (cd copy && ./configure CC=clang CFLAGS="$flags -fsanitize=$sanitizers,fuzzer-no-link" --with-oracles=no >configure.log)
  (cd copy && make -s libverify.a libscheme.a libbigfloat.a libgeneric_interval.a libgeneric_ball.a libgeneric_grid.a \
    libjet_interval.a libjet_ball.a libjet_grid.a >make.log)
}

compile_checker() { # TARGET
  sources=
  for file in "$source"/verify/check/*.c; do
    case $file in */main.c | */scratch.c) ;; *) sources="$sources $file" ;; esac
  done
  # shellcheck disable=SC2086  # lists
  clang $flags -fsanitize=fuzzer,$sanitizers -I"$source" -Dexit=checker_exit -Dfopen=checker_fopen -o "$1" \
    "$source/tests/fuzz/$1.c" $sources "$source/tests/fuzz/result.c" checker.o
}

compile() { # TARGET
  case $1 in
    check-*)
      # shellcheck disable=SC2086
      clang $flags -fsanitize=$sanitizers,fuzzer-no-link -I"$source" -c "$source/tests/fuzz/checker.c"
      compile_checker "$1"
      ;;
    *)
      build_libraries
      # shellcheck disable=SC2086
      clang $flags -fsanitize=fuzzer,$sanitizers -frounding-math -Icopy -I"$source" -o "$1" "$source/tests/fuzz/$1.c" "$source/tests/fuzz/result.c" \
        -Wl,--start-group copy/*.a -Wl,--end-group -lm -lpthread
      ;;
  esac
}

# A good certificate, and its body alone: the mutants of that are sealed.
seed_certificate() { # FILE COPY
  sed '/^records /,$d' "$1" >"$2.body"
  cp "$1" "$2"
}

seed() { # TARGET FOLDER
  case $1 in
    *scheme) for file in "$source"/lib/catalogue/*.scheme "$source"/tests/*/*schemes/*.scheme; do cp "$file" "$2"; done ;;
    *certificate)
      for file in "$source"/tests/certificates/accept-1/*.cert "$source"/tests/certificates/accept/loop-7.cert "$source"/tests/check/ranges/*.cert; do
        seed_certificate "$file" "$2/${file##*/}"
      done
      for file in "$source"/proofs/*/valence-*..*.cert; do
        scheme=${file%/*}
        [ "$(wc -c <"$file")" -gt 2800 ] || seed_certificate "$file" "$2/${scheme##*/}-${file##*/}"
      done
      ;;
    formula)
      sed -n -e 's/^ *all ([^)]*) *\(..*\)/=\1/p' -e 's/^ *centre *\(..*\)/=\1/p' -e 's/^let [a-z_0-9]* = /=/p' -e 's/.* when \(.*\)/?\1/p' \
        "$source"/lib/catalogue/*.scheme "$source"/tests/*/schemes/*.scheme | sort -u | split -l 1 -a 4 - "$2/line-"
      for file in "$2"/line-*; do tr -d '\n' <"$file" >"$file.seed" && rm "$file"; done
      ;;
    valences)
      for list in 3 3..20 3..7,20 5,4,9..12 3..100000 3..inf all 1000000000 7..5 , ..; do printf %s "$list" >"$2/list-$list"; done
      ;;
    check-arguments)
      printf '%s\n' --scheme=x --valence=3..7,20 --claim=c1 file >"$2/one"
      printf '%s\n' --scheme x --set a=1 --set=b=2 --valence 3 --claim not-c1 -- file >"$2/two"
      printf '%s\n' --help >"$2/three"
      printf '%s\n' --version >"$2/four"
      ;;
  esac
  if [ -d "$source/tests/fuzz/inputs/$1" ]; then cp "$source/tests/fuzz/inputs/$1"/* "$2"; fi
}

words() { # TARGET
  case $1 in
    *certificate)
      echo "smoothcert-certificate scheme claim c1 not-c1 valence inf grid contraction stability records sha256"
      echo "reason frequency not-c0 fold tie jordan modulus-one form real complex plain graded degree grades winding"
      echo "pivot eigenvalue eigenvector radius range inverse modulus second block limit rise cover window bound wave"
      echo "field factor coefficient power line others exact halfplane regularity boundary witness 800000000000"
      ;;
    check-arguments) echo "--scheme --set --valence --claim --help --version -- = .. , c1 not-c1" ;;
    valences) echo ".. , 1000000000 100000" ;;
    *) echo "scheme mesh triangle quad dual dilation vertices interior mask symmetric end rule centre all rest when otherwise parameter let spectrum composition refine smooth average times pi cos sin sqrt abs min max mod cases else and or k m j @ ^ <= >= !=" ;;
  esac | tr ' ' '\n' | sed 's/.*/"&"/'
}

for target; do
  compile "$target"
  if [ ! -d "$target.found" ]; then
    mkdir "$target.found"
    seed "$target" "$target.found"
  fi
  words "$target" >"$target.words"
  echo "== $target, $seconds s"
  ./"$target" -max_total_time="$seconds" -timeout=25 -rss_limit_mb=1500 -max_len=20000 -dict="$target.words" -close_fd_mask=3 \
    -print_final_stats=1 -artifact_prefix="$target-" "$target.found" 2>"$target.log" || {
    echo "$target: an input is left in $(pwd) ($target.log)"
    exit 1
  }
  sed -n 's/^stat::number_of_executed_units: */inputs tried: /p' "$target.log"
  rm -rf "$target.least"
  mkdir "$target.least"
  ./"$target" -set_cover_merge=1 -close_fd_mask=3 "$target.least" "$target.found" 2>>"$target.log"
  echo "inputs kept: $(ls "$target.least" | wc -l)"
done
