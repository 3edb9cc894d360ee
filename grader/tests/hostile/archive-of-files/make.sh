tar -C 06-rotation -czf archive.tgz .
