# Target course_warnings: the warnings that the project's own code is held to, as errors.
# Link it PRIVATE. Grading never uses it: there a student's warnings are advice.
add_library(course_warnings INTERFACE)
target_compile_options(course_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Werror -Wno-missing-field-initializers
    # g++ 12 reports overlapping copies in std::string's own operator+ (its bug 105651).
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>)

# Target course_test: for programs of tests, which are compiled as often as they run: the optimiser
# would take longer than it saves.
add_library(course_test INTERFACE)
target_link_libraries(course_test INTERFACE course_warnings)
target_compile_options(course_test INTERFACE -O0)
