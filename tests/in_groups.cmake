# Read by CTest before it tests, after tests/CMakeLists.txt has set `program` and `environment`: lists the tests of a program in
# groups, each of them one process. Under a sanitizer a process takes longer to start than most tests take to run.
get_filename_component(name "${program}" NAME)
execute_process(COMMAND "${program}" --gtest_list_tests OUTPUT_VARIABLE listed RESULT_VARIABLE failed TIMEOUT 120)
if(NOT failed EQUAL 0) # not built, or a finding: the test that says so fails
    add_test("${name}: the list of its tests" "${program}" --gtest_list_tests)
    return()
endif()
string(REGEX REPLACE "[][;]" " " listed "${listed}") # values of parameters, which are no part of a name
string(REPLACE "\n" ";" listed "${listed}")
set(group)
set(suite)
foreach(line IN LISTS listed ITEMS "end.")
    string(REGEX REPLACE " *#.*" "" line "${line}")
    if(line MATCHES "^  (.+)")
        list(APPEND group "${suite}${CMAKE_MATCH_1}")
    elseif(line MATCHES "^[^ ]+\\.$")
        set(suite "${line}")
    endif()
    list(LENGTH group count)
    if(count EQUAL 8 OR (count GREATER 0 AND line STREQUAL "end."))
        list(GET group 0 first)
        math(EXPR more "${count} - 1")
        list(JOIN group ":" filter)
        add_test("${name}: ${first} and ${more} more" "${program}" "--gtest_filter=${filter}")
        set_tests_properties("${name}: ${first} and ${more} more" PROPERTIES ENVIRONMENT "${environment}"
            TIMEOUT 1500) # of one test 300
        set(group)
    endif()
endforeach()
