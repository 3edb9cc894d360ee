truncate -s 300M 06-rotation/zeros
tar -cjf archive.tar.bz2 --transform='s|^06-rotation/zeros$|.|' 06-rotation/zeros
rm 06-rotation/zeros
