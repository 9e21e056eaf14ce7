/* The functions of b12 for a program that otherwise uses those of b18. */
#ifndef OLD_FUNCTIONS_H
#define OLD_FUNCTIONS_H

/* How many of them did something with this handle. */
int ask_old_functions(void *handle);

#endif
