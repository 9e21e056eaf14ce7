// channel.c, compiled as C++: bool is C++'s own type.
#include "channel.c"
