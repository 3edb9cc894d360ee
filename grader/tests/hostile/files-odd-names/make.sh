cd 06-rotation
touch "$(printf 'two\nlines')" "$(printf 'red\033[31m')" "$(printf 'gnp\342\200\256exe')" '=cmd|calc' '<img src=x onerror=alert(1)>' -- '--help' "$(head -c 250 /dev/zero | tr '\0' n)"
