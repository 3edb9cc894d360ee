touch $'06-rotation/a\u202Eppc.noitator'
tar -cf archive.tar 06-rotation
