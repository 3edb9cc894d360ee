# One program with the unit tests of this folder, which stand beside what they test. Helpers are
# programs that a test starts: a runner that answers as it is told, and one that tries its sandbox;
# and a subject that does what no submission should.
add_executable(grader_fake_runner testing/FakeRunner.cpp)
target_link_libraries(grader_fake_runner PRIVATE protocol course_warnings)
add_executable(grader_sandbox_probe testing/SandboxProbe.cpp)
add_library(grader_greedy_subject MODULE testing/GreedySubject.cpp)
target_include_directories(grader_greedy_subject PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(grader_greedy_subject PRIVATE cg protocol course_warnings)
# Sanitizers take more memory than the limits under test allow.
target_compile_options(grader_sandbox_probe PRIVATE -fno-sanitize=all)
target_link_options(grader_sandbox_probe PRIVATE -fno-sanitize=all)
target_link_libraries(grader_sandbox_probe PRIVATE course_warnings)

function(grader_add_unit_tests name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINK")
    add_executable(${name} ${arg_SOURCES})
    target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
    target_link_libraries(${name} PRIVATE
        ${arg_LINK} GTest::gmock GTest::gtest_main course_test)
    target_compile_definitions(${name} PRIVATE
        FAKE_RUNNER="$<TARGET_FILE:grader_fake_runner>"
        SANDBOX_PROBE="$<TARGET_FILE:grader_sandbox_probe>" CONFINE="$<TARGET_FILE:confine>"
        RUNNER="$<TARGET_FILE:runner>" GREEDY_SUBJECT="$<TARGET_FILE:grader_greedy_subject>")
    add_dependencies(${name} grader_fake_runner grader_sandbox_probe grader_greedy_subject confine
        runner)
    gtest_discover_tests(${name} TEST_PREFIX grader.
        PROPERTIES TIMEOUT 60 RUN_SERIAL TRUE FAIL_REGULAR_EXPRESSION "Running 0 tests")
endfunction()

grader_add_unit_tests(grader_unit_tests
    SOURCES
        protocol/Message_test.cpp protocol/Value_test.cpp
        runner/SeededValues_test.cpp
        subject/Judge.cpp subject/Judge_test.cpp subject/ProcessSubject_test.cpp
        subject/Status_test.cpp
        src/Browser_test.cpp src/BuildId_test.cpp src/Carry_test.cpp src/Cgroup_test.cpp
        src/Collect_test.cpp
        src/Diagnostics_test.cpp src/Files_test.cpp src/Includes_test.cpp src/JobUser_test.cpp
        src/Manifest_test.cpp
        src/ObjectCache_test.cpp src/Portability_test.cpp src/Process_test.cpp src/Regions_test.cpp
        src/Result_test.cpp src/Sandbox_test.cpp src/SystemFiles_test.cpp
        src/TimeBox_test.cpp src/Toolchain_test.cpp
        src/batch/Batch_test.cpp src/batch/Class_test.cpp src/batch/Crew_test.cpp
        src/batch/Earlier_test.cpp src/batch/Gallery_test.cpp src/batch/Gradebook_test.cpp
        src/batch/Merge_test.cpp src/batch/Similarity_test.cpp
        src/compare/FrameScore_test.cpp
        src/course/Course_test.cpp src/course/NewAssignment_test.cpp
        src/doctor/Doctor_test.cpp src/formats/Formats_test.cpp
        src/harness/SubmissionMetadata_test.cpp
        src/package/CourseFiles_test.cpp src/package/Leaks_test.cpp
        src/pull_request/Markdown_test.cpp
        src/recognise/Recognise_test.cpp src/recognise/UsualSlips_test.cpp
        src/report/HtmlReport_test.cpp src/report/TerminalPictures_test.cpp
        src/report/TerminalReport_test.cpp src/report/Words_test.cpp
        src/watch/Changes_test.cpp src/watch/FileWatch_test.cpp src/watch/GradingProcess_test.cpp
        unpack/Unpack_test.cpp
    LINK grader_batch grader_course grader_harness grader_package grader_pull_request unpacking)

# The runner's parent, watching that subject.
grader_add_unit_tests(runner_tests SOURCES runner/Child_test.cpp LINK runner_core)

# Pages in a browser: reports by the grader itself, one that has everything, a class of 500.
add_executable(grader_sample_report testing/SampleReport.cpp)
target_include_directories(grader_sample_report PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(grader_sample_report PRIVATE grader_core course_warnings)
add_executable(grader_sample_class testing/SampleClass.cpp)
target_include_directories(grader_sample_class PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(grader_sample_class PRIVATE grader_batch course_warnings)
if(IS_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/browser_tests)
    add_test(NAME report.browser COMMAND node ${CMAKE_CURRENT_SOURCE_DIR}/browser_tests/run.js
        $<TARGET_FILE:grader> $<TARGET_FILE:grader_sample_report>
        $<TARGET_FILE:grader_sample_class>)
    set_tests_properties(report.browser PROPERTIES TIMEOUT 600 RUN_SERIAL TRUE)
    # The workflows of .github, by the same Node.
    add_test(NAME workflows.lint COMMAND
        node ${CMAKE_CURRENT_SOURCE_DIR}/browser_tests/workflows.js ${PROJECT_SOURCE_DIR})
endif()

# The scoring rule on pictures whose worth is known; it prints the table of docs/scoring.md.
add_executable(compare_selftest compare_tests/Pictures.cpp compare_tests/SelfTest.cpp)
target_include_directories(compare_selftest PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_compile_options(compare_selftest PRIVATE -O2)
target_link_libraries(compare_selftest PRIVATE grader_core course_warnings)
add_test(NAME compare.selftest COMMAND compare_selftest)
set_tests_properties(compare.selftest PROPERTIES TIMEOUT 300)
