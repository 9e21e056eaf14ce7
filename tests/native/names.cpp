// The same from C++.
#include "names.c"
