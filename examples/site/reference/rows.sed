# SPDX-License-Identifier: MIT
#
# A docstring's row "///   term   text" as an item of a list, which Doxygen keeps: "///   - term :: text".
s|^( *///)   ([^ ]+( [^ ]+)*)  +(.*)$|\1   - \2 :: \4|
