tar -P --transform "s,^06-rotation,../../left-behind," -czf archive.tar.gz 06-rotation
