# Target course_warnings: the warnings that the project's own code is held to, as errors.
# Link it PRIVATE. Grading never uses it: there a student's warnings are advice.
add_library(course_warnings INTERFACE)
target_compile_options(course_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Werror -Wno-missing-field-initializers
    # g++ 12 reports overlapping copies in std::string's own operator+ (its bug 105651).
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>)
