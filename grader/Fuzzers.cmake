# The fuzzers are a project of their own, built by clang; each goes on from the inputs in corpus/, and
# those that read text from all that students are given, for half a minute. What breaks one is written to build/…/fuzz/found.
include(ExternalProject)

ExternalProject_Add(fuzzers
    SOURCE_DIR ${CMAKE_CURRENT_SOURCE_DIR}/fuzz
    BINARY_DIR ${PROJECT_BINARY_DIR}/fuzz
    CMAKE_ARGS -G Ninja -DCMAKE_CXX_COMPILER=clang++
    BUILD_ALWAYS TRUE
    INSTALL_COMMAND "")

set(found ${PROJECT_BINARY_DIR}/fuzz/found)
file(GLOB corpora RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/fuzz/corpus
    ${CMAKE_CURRENT_SOURCE_DIR}/fuzz/corpus/*)
if(NOT corpora)
    message(FATAL_ERROR "no folder in grader/fuzz/corpus: there is nothing to fuzz")
endif()
foreach(name IN LISTS corpora)
    # OpenImageIO 2.4 does not free the text of its last error: for leaks, look at the others.
    set(leaks 1)
    if(name STREQUAL image)
        set(leaks 0)
    endif()
    # A few bytes may claim 4 GiB (xz's dictionary, a bitmap's palette). Libraries in C are told, as in
    # the sandbox, that there are none; of C++ the sanitizer would make an error.
    set(limits -rss_limit_mb=2048 -malloc_limit_mb=8192)
    set(refusals)
    if(name STREQUAL archive)
        set(refusals :allocator_may_return_null=1:max_allocation_size_mb=1024)
    endif()
    set(given)
    if(name MATCHES "^(manifest|source)$")
        set(given ${PROJECT_SOURCE_DIR}/assignments)
    endif()
    file(MAKE_DIRECTORY ${found} ${PROJECT_BINARY_DIR}/fuzz/new/${name})
    add_test(NAME fuzz.${name} COMMAND ${PROJECT_BINARY_DIR}/fuzz/fuzz_${name}
        -seed=1 -max_total_time=30 -timeout=10 ${limits} -artifact_prefix=${found}/${name}-
        ${PROJECT_BINARY_DIR}/fuzz/new/${name} ${CMAKE_CURRENT_SOURCE_DIR}/fuzz/corpus/${name}
        ${given})
    set_tests_properties(fuzz.${name} PROPERTIES TIMEOUT 300
        ENVIRONMENT ASAN_OPTIONS=detect_leaks=${leaks}${refusals})
endforeach()
