mkdir 06-rotation/many && cd 06-rotation/many && seq 1 10000 | xargs touch
