mkdir a
ln -s /tmp a/out
tar -cf archive.tar a/out
rm a/out
mkdir a/out
echo x > a/out/left-behind
tar -rf archive.tar a/out/left-behind
