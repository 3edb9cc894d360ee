# The kit: the one folder of ours that a sandbox sees. Headers, the precompiled prelude, library cg,
# shaders, meshes, the runner, confine (the steps into a sandbox) and unpack; no test, no reference, no solution.

set(KIT ${PROJECT_BINARY_DIR}/kit)
set(kit_headers)
foreach(folder common common/cg grader/runner grader/protocol)
    file(GLOB found CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.h)
    list(APPEND kit_headers ${found})
endforeach()
file(GLOB kit_resources CONFIGURE_DEPENDS
    ${PROJECT_SOURCE_DIR}/common/shaders/* ${PROJECT_SOURCE_DIR}/common/models/*.obj)

set(copies)
function(kit_copy source target)
    add_custom_command(OUTPUT ${target}
        COMMAND ${CMAKE_COMMAND} -E copy ${source} ${target}
        DEPENDS ${source} VERBATIM)
endfunction()
foreach(header IN LISTS kit_headers)
    file(RELATIVE_PATH name ${PROJECT_SOURCE_DIR} ${header})
    string(REGEX REPLACE "^(common|grader)/" "" name ${name})
    kit_copy(${header} ${KIT}/include/${name})
    list(APPEND copies ${KIT}/include/${name})
endforeach()
foreach(resource IN LISTS kit_resources)
    file(RELATIVE_PATH name ${PROJECT_SOURCE_DIR}/common ${resource})
    kit_copy(${resource} ${KIT}/${name})
    list(APPEND copies ${KIT}/${name})
endforeach()
# A header that is gone must not be found by anybody's #include.
file(GLOB_RECURSE kit_there ${KIT}/include/*)
foreach(file IN LISTS kit_there)
    if(NOT file IN_LIST copies)
        file(REMOVE ${file})
    endif()
endforeach()
kit_copy(${CMAKE_CURRENT_SOURCE_DIR}/prelude.h ${KIT}/prelude/prelude.h)

# The prelude is compiled with the very flags of a student's file, or the compiler ignores it.
add_custom_command(OUTPUT ${KIT}/prelude/prelude.h.gch
    COMMAND ${CMAKE_CXX_COMPILER} ${STUDENT_GRADING_FLAGS} -x c++-header ${KIT}/prelude/prelude.h
            -o ${KIT}/prelude/prelude.h.gch -MD -MF ${KIT}/prelude/prelude.d
    DEPFILE ${KIT}/prelude/prelude.d
    DEPENDS ${KIT}/prelude/prelude.h ${PROJECT_SOURCE_DIR}/cmake/StudentFlags.cmake VERBATIM)

add_custom_command(OUTPUT ${KIT}/lib/libcg.a
    COMMAND ${CMAKE_COMMAND} -E copy $<TARGET_FILE:cg> ${KIT}/lib/libcg.a
    DEPENDS cg VERBATIM)
add_custom_command(OUTPUT ${KIT}/bin/runner
    COMMAND ${CMAKE_COMMAND} -E copy $<TARGET_FILE:runner> ${KIT}/bin/runner
    DEPENDS runner VERBATIM)
add_custom_command(OUTPUT ${KIT}/bin/confine
    COMMAND ${CMAKE_COMMAND} -E copy $<TARGET_FILE:confine> ${KIT}/bin/confine
    DEPENDS confine VERBATIM)
add_custom_command(OUTPUT ${KIT}/bin/unpack
    COMMAND ${CMAKE_COMMAND} -E copy $<TARGET_FILE:unpack> ${KIT}/bin/unpack
    DEPENDS unpack VERBATIM)
add_custom_target(prelude DEPENDS ${copies} ${KIT}/prelude/prelude.h.gch ${KIT}/lib/libcg.a
    ${KIT}/bin/runner ${KIT}/bin/confine ${KIT}/bin/unpack)
