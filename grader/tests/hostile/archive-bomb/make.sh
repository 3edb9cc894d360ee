truncate -s 300M 06-rotation/zeros
tar -czf archive.tar.gz 06-rotation
rm 06-rotation/zeros
