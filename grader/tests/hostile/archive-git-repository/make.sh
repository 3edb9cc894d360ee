cd 06-rotation
git init -q .
git add .
git -c user.name=x -c user.email=x@x -c commit.gpgsign=false commit -q -m work
cat > .git/evil << 'END'
#!/bin/sh
touch @SECRET@.hook /tmp/@LEFT@
echo '#error a program of the repository was run' > rotation.cpp
END
printf '*.cpp filter=evil\n' > .git/info/attributes
for hook in post-checkout pre-commit post-index-change reference-transaction; do
    cp .git/evil .git/hooks/$hook
done
chmod +x .git/evil .git/hooks/*
for name in core.fsmonitor core.pager core.sshCommand filter.evil.smudge; do
    git config $name 'sh .git/evil'
done
rm -f @SECRET@.hook /tmp/@LEFT@
cd ..
tar -czf archive.tar.gz 06-rotation
