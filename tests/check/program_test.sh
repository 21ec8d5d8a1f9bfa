#!/usr/bin/env bash
# usage: program_test.sh RINGWATCH RINGWATCH_CHECK
set -euo pipefail
ringwatch=$1 checker=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
fail() { echo "program_test.sh: $1" >&2; exit 1; }
expect() { # STATUS COMMAND …: ends with that status; its output in `out`
  local status=$1 got=0
  shift
  out=$("$@" 2>&1) || got=$?
  [[ $got == "$status" ]] || fail "'$*' ends with $got, not $status: $out"
}

"$ringwatch" mesh generate bar --size 0.2 0.04 0.04 --cells 5 1 1 --jitter 0.2 -o bar.msh > mesh.txt
"$ringwatch" inspect bar.msh --young 30e3 --poisson 0.3 --density 1000 --fix "x < 1e-6" --certificate bar.certificate > report.txt
grep -q "certificate: bar.certificate" report.txt || fail "inspect does not tell of its certificate"
expect 0 "$checker" bar.certificate
[[ $out == *": proven"* && $out == *"30 elements"* ]] || fail "$out"
printf '\xff' | dd of=bar.certificate bs=1 seek=2000 conv=notrunc status=none
expect 2 "$checker" bar.certificate
[[ $out == *"checksum"* ]] || fail "$out"
expect 2 "$checker" absent
expect 2 "$checker"
expect 2 "$ringwatch" inspect bar.msh --young 30e3 --poisson 0.3 --density 1000 --certificate absent/bar.certificate
