cd 06-rotation
printf "message(FATAL_ERROR forged)\n" | tee CMakeLists.txt toolchain.cmake > ../CMakeLists.txt
printf "all:\n\techo forged\n" > Makefile
printf "{}" > CMakePresets.json
printf -- "-DFORGED" > compile_flags.txt
