// The words around the options in --help.
#pragma once

#include <string>

namespace epure {

std::string help_of_program();
std::string examples_of_program();
std::string examples_of_list();
std::string examples_of_draw();
std::string examples_of_check();
std::string examples_of_bench();

}  // namespace epure
