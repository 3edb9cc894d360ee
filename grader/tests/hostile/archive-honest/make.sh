tar -czf archive.tar.gz 06-rotation
