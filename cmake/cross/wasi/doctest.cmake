# One CTest test per program: test cases cannot be listed before all programs are built.
function(doctest_discover_tests target)
    add_test(NAME ${target} COMMAND ${target})
endfunction()
