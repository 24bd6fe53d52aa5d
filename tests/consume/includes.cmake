# SPDX-License-Identifier: MIT
#
# Fails when umbrage.hpp reaches a header that costs its users too much or ties them to a machine.
file(WRITE includes.cpp "#include <umbrage/umbrage.hpp>\n")
execute_process(COMMAND ${CXX} -M includes.cpp OUTPUT_VARIABLE files COMMAND_ERROR_IS_FATAL ANY)
string(JOIN | heavy
    iostream istream ostream fstream sstream iomanip locale regex functional execution thread future filesystem random
    [a-z0-9]*intrin\\.h arm_neon\\.h)
string(REGEX MATCHALL "[^ ]*/(${heavy})[ \n]" found "${files}")
if(found)
    string(REGEX REPLACE "[ \n;]+" "\n  " found ";${found}")
    message(FATAL_ERROR "umbrage.hpp reaches${found}")
endif()
