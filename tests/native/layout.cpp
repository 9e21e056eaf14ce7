// The same from C++.
#include "layout.c"
