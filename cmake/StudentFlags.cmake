# How a student's code is compiled: one list for the grader, the windows and the debugger.

# In current GLM `mat4 m;` is garbage without GLM_FORCE_CTOR_INIT; the empty GLM_FORCE_RADIANS lets
# the lecture notes' own #define pass without a warning.
set(STUDENT_DEFINITIONS GLM_FORCE_CTOR_INIT GLM_FORCE_RADIANS= GLM_ENABLE_EXPERIMENTAL)

# Warnings are advice to a student, so never -Werror.
set(STUDENT_WARNINGS -Wall -Wextra)

# What the grader adds: light optimisation, line numbers for crash reports, symbols of the
# submission's own.
set(STUDENT_GRADING_FLAGS -std=c++20 -O1 -g1 -fPIC -fno-gnu-unique ${STUDENT_WARNINGS})
list(TRANSFORM STUDENT_DEFINITIONS PREPEND -D OUTPUT_VARIABLE student_definition_flags)
list(APPEND STUDENT_GRADING_FLAGS ${student_definition_flags})

include(CheckCXXSourceCompiles)
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=mold STUDENT_LINKER_IS_MOLD)
set(STUDENT_LINK_FLAGS -shared -Wl,-Bsymbolic -Wl,-z,lazy)
if(STUDENT_LINKER_IS_MOLD)
    list(PREPEND STUDENT_LINK_FLAGS -fuse-ld=mold)
endif()
