# SPDX-License-Identifier: MIT
#
#     cmake -DCXX=aarch64-linux-gnu-g++ -DINCLUDE=-I... -DSOURCE=neon.cpp -DALL=ON -P neon.cmake
#
# Fails where a function does one by one, at plain -O2, what NEON does to four floats at a time.
function(check function)
    execute_process(COMMAND ${CXX} -std=c++20 -O2 ${INCLUDE} -D${function} -S ${SOURCE} -o - OUTPUT_VARIABLE text
                    COMMAND_ERROR_IS_FATAL ANY)
    foreach(instruction IN LISTS ARGN)
        string(REGEX MATCHALL "[ \t]${instruction}[ \t]+v[0-9]+[.]4s" found "${text}")
        list(LENGTH found count)
        message("${function}: ${count} ${instruction} on four floats")
        if(count EQUAL 0)
            message(SEND_ERROR "${function}: no ${instruction} on four floats")
        endif()
    endforeach()
endfunction()
check(PCF_2X2 fcvtzs fcmge scvtf)
if(ALL)
    check(ENCODE fcvtzs)
    check(DECODE scvtf fmul)
    check(BOX fcvtzs fcmge)
endif()
