// SPDX-License-Identifier: MIT
//
// Runs a page's code, and writes its shaders:  page_code PAGE FOLDER
#include "page.hpp"

int main(int argc, char** argv) {
    if (argc != 3 || !pages().contains(argv[1])) return 2;
    shaders = argv[2];
    pages().at(argv[1])();
    return wrong == 0 ? 0 : 1;
}
