asm(".section .rodata\n.global stolen\nstolen: .incbin \"@SECRET@\"\n.text\n");
