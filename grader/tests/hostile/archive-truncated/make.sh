tar -czf whole.tar.gz 06-rotation
head -c 700 whole.tar.gz > archive.tar.gz
