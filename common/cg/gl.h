#pragma once
/// The only place that includes an OpenGL header: core profile functions, declared as ordinary C
/// functions. No loader is needed, because libOSMesa.so and libOpenGL.so both export them all;
/// which one is linked is the choice of the program, not of the code that calls them.

#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES 1
#endif
#include <GL/glcorearb.h>
