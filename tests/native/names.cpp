// names.c, compiled as C++.
#include "names.c"
