mkdir -p hand-in/final
mv 06-rotation hand-in/final/
tar -cf archive.tar hand-in
