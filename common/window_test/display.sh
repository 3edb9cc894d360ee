# shellcheck shell=bash
# Sourced by the window tests: a display of their own without a screen, and a window driven by keys.
# Everything is put away when the script ends, however it ends.

set -euo pipefail

fail() {
    echo "FAILED: $*" >&2
    [[ -s ${log:-} ]] && sed 's/^/  window: /' "$log" >&2
    exit 1
}

for tool in Xvfb xdotool; do
    command -v "$tool" > /dev/null || fail "$tool is missing: install the packages xvfb and xdotool"
done

folder=$(mktemp -d)
log=$folder/log
server=
window_process=

# One after the other: of two servers that start or end at once, one may take the other's socket away.
alone() {
    exec 9> "${TMPDIR:-/tmp}/course-display-$(id -u).lock"
    flock 9
}
together() { exec 9>&-; }

cleanup() {
    [[ -z $window_process ]] || kill "$window_process" 2> /dev/null || true
    if [[ -n $server ]]; then
        alone
        kill "$server" 2> /dev/null || true
        wait "$server" 2> /dev/null || true
        together
    fi
    rm -rf "$folder"
}
trap cleanup EXIT

# wait_for WHAT COMMAND...: runs the command until it succeeds, for at most 20 seconds.
wait_for() {
    local what=$1
    shift
    for _ in {1..400}; do
        if "$@" > /dev/null 2>&1; then
            return
        fi
        sleep 0.05
    done
    fail "waited in vain: $what"
}

start_display() {
    alone
    # -noreset: it would begin anew, and be away for a moment, when the first client has gone.
    Xvfb -displayfd 3 -noreset -screen 0 1280x1024x24 -nolisten tcp 3> "$folder/display" \
        2> "$folder/server" 9>&- &
    server=$!
    wait_for "the display starts" test -s "$folder/display"
    DISPLAY=:$(< "$folder/display")
    export DISPLAY LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe
    # A GL driver leaks a little and is unloaded before LeakSanitizer could tell that it was that.
    export ASAN_OPTIONS="${ASAN_OPTIONS:-}:detect_leaks=0"
    wait_for "the display answers" xdotool getdisplaygeometry
    together
}

# open_window PROGRAM ARGUMENT...: runs it in $folder, where its screenshots appear, and gives its
# window the keyboard. Sets $window.
open_window() {
    [[ -x $1 ]] || fail "there is no program $1: build it first"
    (cd "$folder" && exec "$@" > "$log" 2>&1) &
    window_process=$!
    find_window() { xdotool search --onlyvisible --pid "$window_process"; }
    ended() { ! kill -0 "$window_process"; }
    opened_or_ended() { find_window || ended; }
    wait_for "a window opens" opened_or_ended
    window=$(find_window | head -n 1) || fail "the program ended before its window was there"
    xdotool windowfocus --sync "$window"
    wait_for "the list of keys is printed" grep -q "Esc" "$log"
}

# press KEY...: as if typed, in X11's names ("Left", "Escape", "o").
press() { xdotool key --clearmodifiers --delay 30 "$@"; }

# take_screenshot FILE: presses o and waits until the window says that it has written FILE.
take_screenshot() {
    press o
    wait_for "a screenshot $1" grep -qx "screenshot: $1" "$log"
}

# quit_window: presses Esc; the program must end with exit code 0.
quit_window() {
    press Escape
    wait_for "Esc quits" ended
    local code=0
    wait "$window_process" || code=$?
    window_process=
    [[ $code == 0 ]] || fail "exit code $code after Esc, expected 0"
}
