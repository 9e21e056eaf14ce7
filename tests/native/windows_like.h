/* Declares the names that both windows.h and our headers use, as windows.h does. */
#ifndef _WINDEF_
#define _WINDEF_

/* Compilers treat the real windows.h as a system header, too. */
#pragma GCC system_header

#define CALLBACK __stdcall
#define WINAPI __stdcall
typedef int BOOL;
typedef unsigned char UCHAR;

#endif
