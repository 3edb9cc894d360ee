rm -r 06-rotation
ln -s @ROOT@/solutions/06-rotation 06-rotation
