#!/usr/bin/env bash
# picture_test.sh PROGRAM COMPARE REFERENCE KEY...
# Opens a window, presses the keys, saves a screenshot by the key o, quits by Esc, and demands that
# the picture is the one that the grader has for the same pose. r must then lead back to the start.

source "$(dirname "${BASH_SOURCE[0]}")/display.sh"

program=$1 compare=$2 reference=$3
shift 3
name=$(basename "$(dirname "$reference")")
[[ -f $reference ]] || fail "no reference $reference: draw it with grader update-references"

start_display
open_window "$program" --size 400x300
take_screenshot "$name.png"
press "$@"
take_screenshot "$name-2.png"
press r
# Keys that switch something are no pose: pressed again, they switch it back.
for key in "$@"; do
    [[ $key != p ]] || press p
done
take_screenshot "$name-3.png"
quit_window

"$compare" "$folder/$name-2.png" "$reference" || fail "the window's picture is not the reference"
if "$compare" "$folder/$name.png" "$reference"; then
    fail "the keys changed nothing: $*"
fi
"$compare" "$folder/$name-3.png" "$folder/$name.png" || fail "r does not lead back to the start"

# The same first picture without any key.
"$program" --size 400x300 --screenshot "$folder/first.png" > "$log" 2>&1 ||
    fail "--screenshot ended with exit code $?"
"$compare" "$folder/first.png" "$folder/$name.png" || fail "--screenshot shows something else"
echo "passed: $name"
