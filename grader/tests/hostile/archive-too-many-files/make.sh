mkdir many
(cd many && seq 6000 | xargs touch)
tar -czf archive.tar.gz many 06-rotation
