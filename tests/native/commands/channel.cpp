// The same as a C++ program: bool is C++'s own.
#include "channel.c"
