tar -P --transform "s,^06-rotation,/tmp/left-behind," -cf archive.tar 06-rotation
