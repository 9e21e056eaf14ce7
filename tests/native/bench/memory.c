/* Counts the calls of the allocator. Functions of a program override those of the C library, for libraries too. */
#include "memory.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>

extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *memory, size_t size);

static __thread long calls;
static long begun_calls, begun_faults, begun_resident;

void *malloc(size_t size)
{
    calls++;
    return __libc_malloc(size);
}

void *calloc(size_t count, size_t size)
{
    calls++;
    return __libc_calloc(count, size);
}

void *realloc(void *memory, size_t size)
{
    calls++;
    return __libc_realloc(memory, size);
}

/* Page faults of the calling thread: pages that it touched for the first time. */
static long faults_now(void)
{
    struct rusage usage;

    getrusage(RUSAGE_THREAD, &usage);
    return usage.ru_minflt;
}

/* Resident pages of the process. Reads the file without a stream, because a stream allocates. */
static long resident_now(void)
{
    char text[128];
    long total, resident;
    int file = open("/proc/self/statm", O_RDONLY);
    ssize_t length = file < 0 ? -1 : read(file, text, sizeof text - 1);

    close(file);
    if (length <= 0)
        return -1;
    text[length] = '\0';
    return sscanf(text, "%ld %ld", &total, &resident) == 2 ? resident : -1;
}

void memory_begin(void)
{
    begun_resident = resident_now();
    begun_faults = faults_now();
    begun_calls = calls;
}

void memory_end(void)
{
    long allocations = calls - begun_calls;
    long faults = faults_now() - begun_faults;
    long resident = resident_now() - begun_resident;

    printf("allocations %ld\nfaults %ld\nresident %ld\n", allocations, faults, resident < 0 ? 0 : resident);
}
