#!/usr/bin/env bash
# starter_test.sh PROGRAM NAME COMPARE
# The window of an assignment in which nothing is filled in yet opens, shows something, says what
# is missing, survives every key and a new size, and quits by Esc.

source "$(dirname "${BASH_SOURCE[0]}")/display.sh"

program=$1 name=$2 compare=$3
start_display
open_window "$program" --size 400x300
take_screenshot "$name.png"
press Left Up Right Down p h r x
help_twice() { (($(grep -c Esc "$log") >= 2)); }
wait_for "h prints the list of keys again" help_twice
title_says_it() { xdotool getwindowname "$window" | grep -q "^$name: .* - not implemented yet: "; }
wait_for "the title names what is not implemented" title_says_it
grep -q "^TODO .*: not implemented yet$" "$log" || fail "nothing printed about what is missing"

# Twice as wide: what was a picture of 400 x 300 must not be stretched.
xdotool windowsize --sync "$window" 800 300
press p  # back, where p switches
take_screenshot "$name-2.png"
quit_window

"$program" --size 800x300 --screenshot "$folder/wide.png" > "$log" 2>&1 ||
    fail "--screenshot ended with exit code $?"
"$compare" "$folder/$name-2.png" "$folder/wide.png" || fail "resizing spoils the picture"
colours=$("$compare" --colours "$folder/$name.png")
((colours > 1)) || fail "the window shows nothing"

code=0
"$program" --size none > "$log" 2>&1 || code=$?
[[ $code == 2 ]] || fail "exit code $code for a wrong option, expected 2"
code=0
DISPLAY=:nowhere "$program" > "$log" 2>&1 || code=$?
[[ $code == 2 ]] || fail "exit code $code without a display, expected 2"
echo "passed: $name"
