# What is committed is right; what lies beside it is not, so nobody takes one for the other.
git init -q .
printf '*.cpp filter=evil\n' > .gitattributes
git add .
git -c user.name=x -c user.email=x@x -c commit.gpgsign=false commit -q -m work
printf '#error the folder was graded, not the commit\n' > 06-rotation/rotation.cpp
evil='touch @SECRET@.hook /tmp/@LEFT@'
for hook in post-checkout pre-commit post-index-change reference-transaction; do
    printf '#!/bin/sh\n%s\n' "$evil" > .git/hooks/$hook
done
chmod +x .git/hooks/*
for name in core.fsmonitor core.pager core.sshCommand; do
    git config $name "$evil"
done
# This one would be seen in what it makes, wherever it is run.
git config filter.evil.smudge "$evil; cat > /dev/null; echo '#error a filter was run'"
rm -f @SECRET@.hook /tmp/@LEFT@
