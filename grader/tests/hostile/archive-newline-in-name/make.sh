touch $'06-rotation/a\n::error::b'
tar -cf archive.tar 06-rotation
