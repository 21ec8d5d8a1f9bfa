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
# Whose body it is: by the hash that inspect prints, and by law, constants, held components and extent.
body=$(sed -n 's/certificate: .* of the body \([0-9a-f]*\), .*/\1/p' report.txt)
[[ $out == *"hash        $body"* && $out == *"30 tet4 of stvk: lambda 17307.69231 Pa, mu 11538.46154 Pa"* &&
   $out == *"held        in x 4 nodes, in y 4, in z 4"* && $out == *"extent      x 0 to 0.2 m, y 0 to 0.04 m"* ]] || fail "$out"
expect 0 "$checker" --expect "$body" bar.certificate
expect 1 "$checker" bar.certificate --expect 0123456789abcdef
[[ $out == *"PROVEN OF ANOTHER BODY"* ]] || fail "$out"
for hash in "" 12 "${body}0" 0123456789abcdeg; do expect 2 "$checker" --expect "$hash" bar.certificate; done
expect 2 "$checker" --expect "$body"
expect 2 "$checker" .
[[ $out == "ringwatch-check: .: cannot be read, or is empty" ]] || fail "$out"
other() { # OPTION VALUE: the hash of the body, with that option in place of its own
  local -A options=([--young]=30e3 [--poisson]=0.3 [--density]=1000 [--fix]="x < 1e-6")
  local given=() option
  if (($# == 2)); then options[$1]=$2; else given=("$@"); fi
  for option in "${!options[@]}"; do given+=("$option" "${options[$option]}"); done
  "$ringwatch" inspect bar.msh "${given[@]}" --certificate other.certificate |
    sed -n 's/certificate: .* of the body \([0-9a-f]*\), .*/\1/p'
}
[[ $(other) == "$body" && $(other --exact) == "$body" ]] || fail "the hash depends on the proof"
for change in "--young 30001" "--poisson 0.31" "--density 1001" "--model neo-hookean" "--fix z<1e-6"; do
  # shellcheck disable=SC2086
  other $change > /dev/null
  expect 1 "$checker" --expect "$body" other.certificate
done
printf '\xff' | dd of=bar.certificate bs=1 seek=2000 conv=notrunc status=none
expect 2 "$checker" bar.certificate
[[ $out == *"checksum"* ]] || fail "$out"
expect 2 "$checker" absent
expect 2 "$checker"
expect 2 "$ringwatch" inspect bar.msh --young 30e3 --poisson 0.3 --density 1000 --certificate absent/bar.certificate

# What a factorisation proves: both sides, as close as it says; a step that is stable, and one that is not.
inspect=("$ringwatch" inspect bar.msh --young 30e3 --poisson 0.3 --density 1000 --fix "x < 1e-6" --certificate exact.certificate)
"${inspect[@]}" --exact > report.txt
expect 0 "$checker" exact.certificate
proven=$(sed -n 's/.*stable up to the step 2\/sqrt(lambda) = \(.*\) s/\1/p' <<< "$out")
awk -v proven="$proven" '/^  exact/ { exit !(proven <= $2 * (1 + 1e-15) && proven > $2 * (1 - 2e-9)) }' report.txt ||
  fail "the certificate proves $proven s: $(grep exact report.txt)"
for share in 0.9 1.1; do
  step=$(awk -v h="$proven" -v s=$share 'BEGIN { printf "%.10g", s * h }')
  expect "$([[ $share == 0.9 ]] && echo 0 || echo 1)" "${inspect[@]}" --prove "$step"
  expect 0 "$checker" exact.certificate
  [[ $share == 0.9 && $out == *"stable up to the step 2/sqrt(lambda) = $step s"* && $out != *unstable* ||
     $share == 1.1 && $out == *"unstable above"* && $out != *"<="* ]] || fail "--prove $step: $out"
done
expect 2 "${inspect[@]}" --exact --prove "$step"
[[ $out == *"--certificate: with --exact and --prove it could be of either; give one of them"* ]] || fail "$out"

# Along a run: every third observation, and before and at the first violated step; what an earlier run left is gone.
cat > run.toml <<'scene'
[mesh]
file = "bar.msh"
[material]
model = "stvk"
young = 30e3
poisson = 0.3
density = 1000
[integrator]
step = 3.5e-3
end = 0.4
[monitor]
on_violation = "stop"
certificates = 3
[[fix]]
where = "x < 1e-6"
[[move]]
where = "x > 0.2 - 1e-6"
velocity = [0.4, 0, 0]
[output]
picture = false
scene
mkdir -p run/certificates
: > run/certificates/step_00099999.certificate
expect 1 "$ringwatch" run run.toml --out run
violated=$(tail -n 1 run/history.csv | cut -d, -f1)
[[ $(tail -n 1 run/history.csv) == *violated* && $violated -gt 6 ]] || fail "the run ends otherwise: $(tail -n 1 run/history.csv)"
wanted=$(for ((k = 0; k <= violated; ++k)); do
  if ((k % 3 == 0 || k >= violated - 1)); then printf 'step_%08d.certificate\n' "$k"; fi
done)
[[ $(ls run/certificates) == "$wanted" ]] || fail "certificates: $(ls run/certificates), not $wanted"
pulled=$(sed -n "s/.*certificates ($(wc -l <<< "$wanted") files, of the body \([0-9a-f]*\)).*/\1/p" run/summary.json)
[[ -n $pulled && $pulled != "$body" ]] || fail "the summary does not list them"
for file in run/certificates/*; do expect 0 "$checker" --expect "$pulled" "$file"; done
# The last one proves that the step is too large: above 2/sqrt(lower).
largest=$(sed -n 's/.*unstable above 2\/sqrt(lambda) = \(.*\) s/\1/p' <<< "$out")
awk -v h=3.5e-3 -v most="$largest" 'BEGIN { exit !(most > 0 && h > most) }' || fail "3.5e-3 s is not above $largest s"
# A run without them leaves none.
expect 1 "$ringwatch" run run.toml --out run --set monitor.mode=bracket --set monitor.certificates=1000000
[[ $(ls run/certificates | wc -l) == 3 ]] || fail "first, and before and at the violated step: $(ls run/certificates)"
expect 2 "$ringwatch" run run.toml --out other --set monitor.certificates=0
expect 2 "$ringwatch" run run.toml --out other --set monitor.mode=metric --set monitor.metric=single-element
[[ $out == *"certificates along a run do not go with runs without a bracket"* && ! -e other ]] || fail "$out"
expect 2 "$ringwatch" run run.toml --out other --set handler.method=imex
[[ $out == *"certificates are of the whole body"* ]] || fail "$out"
