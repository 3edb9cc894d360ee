#!/usr/bin/env bash
# docs/make-pictures.sh
# Draws the pictures of these pages from what the grader and the windows show today: the reports of
# 06 with one mistake in it, the overview and the gallery of the example class, and a window. Look at
# them before you keep them. It needs what ./test installs, and takes about a minute.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# shellcheck source=common/window_test/display.sh
source common/window_test/display.sh  # makes $folder, and puts it away

mkdir -p "$folder/handed-in/06-rotation"
# The mistake of a student: the sine term of (6.13) is missing.
awk -v body=solutions/06-rotation/mistakes/rotation-without-sine.cpp '
    /END TODO\(rotation\)/ { while ((getline line < body) > 0) print line; inside = 0 }
    !inside { print }
    /BEGIN TODO\(rotation\)/ { inside = 1 }' \
    solutions/06-rotation/rotation.cpp > "$folder/handed-in/06-rotation/rotation.cpp"
./grade 06-rotation --submission "$folder/handed-in" --report "$folder/report" > /dev/null || (($? == 1))

class=grader/examples/class
./grade batch $class/submissions --assignment 06-rotation --seed 1 --out "$folder/class" --quiet \
    --roster $class/roster.csv --times $class/times.csv --policy $class/policy.json > /dev/null
./grade gallery "$folder/class" --out "$folder/gallery" > /dev/null

node grader/browser_tests/pictures.js "$folder" docs

cmake --build build/release --target 06-rotation > /dev/null
start_display
open_window "$PWD/build/release/windows/06-rotation" --size 400x300
press Left  # reaches what is not implemented
take_screenshot 06-rotation.png
title=$(xdotool getwindowname "$window")
quit_window
node grader/browser_tests/pictures.js --window "$folder/06-rotation.png" "$title" docs/window.png

for picture in docs/*.png; do
    (($(stat -c %s "$picture") <= 150000)) || fail "$picture has more than 150 KB"
done
ls -l docs/*.png
