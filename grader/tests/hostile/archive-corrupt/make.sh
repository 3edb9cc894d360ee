tar -czf archive.tar.gz 06-rotation
printf 'broken here and there' | dd of=archive.tar.gz bs=1 seek=400 conv=notrunc status=none
