/* What windows.h declares of the names that our headers use too. */
#ifndef _WINDEF_
#define _WINDEF_

/* As compilers treat the real one. */
#pragma GCC system_header

#define CALLBACK __stdcall
#define WINAPI __stdcall
typedef int BOOL;
typedef unsigned char UCHAR;

#endif
