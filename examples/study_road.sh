#!/usr/bin/env bash
# The study's whole road: people draw (here: simulated people with a known truth), the answers are analysed,
# a rule table is made of them, and a plan uses it. Two truths give two plans.
#
#   examples/study_road.sh [FOLDER]      FUZZYTIME names the command, `fuzzytime` if it is not set.
set -euo pipefail
fuzzytime=${FUZZYTIME:-fuzzytime}
folder=${1:-$(mktemp -d)}
mkdir -p "$folder"

# What people mean: the study's table, and one of people who are four times as lenient.
printf 'fuzzytime: 1\n' > "$folder/strict.yaml"
printf 'fuzzytime: 1\nwidth: {base: 451.6 s, growth: 0.13624, source: an example}\n' > "$folder/lenient.yaml"

for truth in strict lenient; do
  $fuzzytime study simulate --participants 32 --seed 1 --truth "$folder/$truth.yaml" --db "$folder/$truth.sqlite"
  $fuzzytime study analyse "$folder/$truth.sqlite" --out "$folder/$truth-report" --no-plots > "$folder/$truth.txt"
  $fuzzytime study calibrate "$folder/$truth.sqlite" -o "$folder/$truth-table.yaml"
  $fuzzytime rules check "$folder/$truth-table.yaml"
  # Two tasks of some minutes for the same moment: how satisfied is anybody then?
  said=(-i 'In ten minutes, fry the steak for four minutes' -i 'In ten minutes, fry the onions for four minutes')
  ask=(plan --now 2026-03-04T09:00 --rules "$folder/$truth-table.yaml" "${said[@]}")
  $fuzzytime "${ask[@]}" --format json -o "$folder/$truth-plan.json"
  $fuzzytime "${ask[@]}"
done
echo "everything is in $folder"
