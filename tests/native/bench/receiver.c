/* The main function that both receivers share. The verb `native` of tests/NeuronMocap.Benchmarks runs them against its senders. */
#include "receiver.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

static int64_t begun, begun_cpu;
static int64_t *delays;
static size_t delay_count, delay_room;

int64_t clock_now(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * INT64_C(1000000000) + now.tv_nsec;
}

/* CPU time of all threads, in nanoseconds. */
static int64_t cpu_now(void)
{
    struct timespec now;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return now.tv_sec * INT64_C(1000000000) + now.tv_nsec;
}

void measure_begin(void)
{
    begun_cpu = cpu_now();
    begun = clock_now();
}

void measure_end(int64_t frames)
{
    int64_t time = clock_now() - begun;
    int64_t cpu = cpu_now() - begun_cpu;

    printf("frames %lld\nnanoseconds %lld\ncpu %lld\n", (long long)frames, (long long)time, (long long)cpu);
}

void delays_reserve(size_t frames)
{
    delay_room = frames;
    delays = calloc(frames, sizeof *delays);
    if (delays == NULL)
        abort();
}

size_t delays_count(void)
{
    return delay_count;
}

void delays_add(const void *values, int64_t now)
{
    int64_t sent;

    memcpy(&sent, values, sizeof sent);
    if (delay_count < delay_room)
        delays[delay_count++] = now - sent;
}

void delays_print(void)
{
    size_t i;

    for (i = 0; i < delay_count; i++)
        printf("%lld\n", (long long)delays[i]);
}

void report_ready(void)
{
    puts("ready");
    fflush(stdout);
}

static void usage(void)
{
    fputs("throughput PORT FRAMES | check PORT FRAMES | latency PORT FRAMES | udp PORT FRAMES | start PORT\n", stderr);
    exit(2);
}

int main(int count, char **arguments)
{
    const char *mode = count > 2 ? arguments[1] : "";
    int port = count > 2 ? atoi(arguments[2]) : 0;
    long long frames = count > 3 ? atoll(arguments[3]) : 0;

    alarm(120);
    if (strcmp(mode, "start") == 0) {
        /* exec starts the program again and passes the time on, so the measured start includes loading the program. */
        char started[24];

        snprintf(started, sizeof started, "%lld", (long long)clock_now());
        execl("/proc/self/exe", arguments[0], "started", arguments[2], started, (char *)NULL);
        perror("exec");
        return 1;
    }
    if (strcmp(mode, "started") == 0) {
        receive_first(port, frames);
    } else if (strcmp(mode, "throughput") == 0) {
        receive_throughput(port, frames);
    } else if (strcmp(mode, "check") == 0) {
        receive_checked(port, frames);
    } else if (strcmp(mode, "latency") == 0) {
        delays_reserve((size_t)frames);
        receive_delays(port);
        delays_print();
    } else if (strcmp(mode, "udp") == 0) {
        delays_reserve((size_t)frames);
        receive_datagrams(port, (size_t)frames);
        delays_print();
    } else {
        usage();
    }
    return 0;
}
