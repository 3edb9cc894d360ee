tar -C 06-rotation -cJf archive.tar.xz .
