cd 06-rotation
mkdir -p "$(seq -s / 1 200)"
