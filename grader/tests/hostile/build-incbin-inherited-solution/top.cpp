asm(".section .rodata\n.global stolen\nstolen: .incbin \"rotation.cpp\"\n.text\n");
