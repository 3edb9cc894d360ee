truncate -s 300M 06-rotation/zeros
tar -czf archive.tar.gz --transform='s|^06-rotation/zeros$|.|' 06-rotation/zeros
rm 06-rotation/zeros
