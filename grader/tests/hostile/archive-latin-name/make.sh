mkdir $'\xdcbung'
mv 06-rotation $'\xdcbung/'
tar -cf archive.tar $'\xdcbung'
