# Programs can't be asked for their test cases while others are still built: one test each.
function(doctest_discover_tests target)
    add_test(NAME ${target} COMMAND ${target})
endfunction()
