cd 06-rotation
for name in rotation.o subject.so rotation.h.gch prelude.h.gch libcg.a; do head -c 4096 /dev/urandom > $name; done
