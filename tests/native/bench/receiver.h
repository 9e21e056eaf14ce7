/* Shared by the two receivers of the benchmarks: bench-raw, the lower bound, and bench-library. Both take the same arguments and print the same
   figures. */
#ifndef RECEIVER_H
#define RECEIVER_H

#include <stddef.h>
#include <stdint.h>

/* A frame of the benchmarks has 354 values. A time stamp, if the frame has one, takes the place of the first eight bytes of the values. */
enum { FRAME_SIZE = 1480, HEADER_SIZE = 64 };

/* Nanoseconds of CLOCK_MONOTONIC. All processes share this clock, and .NET's Stopwatch uses it, too. */
int64_t clock_now(void);

/* Throughput: measures the time between the first frame and the last. */
void measure_begin(void);
void measure_end(int64_t frames);

/* Latency: the time since a frame's time stamp. delays_print prints the values at the end, in nanoseconds. */
void delays_reserve(size_t frames);
size_t delays_count(void);
void delays_add(const void *values, int64_t now);
void delays_print(void);

/* Tells the sender of the benchmarks that it may begin. UDP has no connection that the sender could wait for. */
void report_ready(void);

/* The modes. Each program implements them in its own way. */
void receive_throughput(int port, int64_t frames);
void receive_checked(int port, int64_t frames);
void receive_delays(int port);
void receive_datagrams(int port, size_t frames);
void receive_first(int port, int64_t started);

#endif
