/* What the two receivers of the benchmarks share: bench-raw, the floor, and bench-library. Both take the same arguments and print the same figures. */
#ifndef RECEIVER_H
#define RECEIVER_H

#include <stddef.h>
#include <stdint.h>

/* A frame of the benchmarks: 354 values. A time stamp, where there is one, is the first eight bytes of them. */
enum { FRAME_SIZE = 1480, HEADER_SIZE = 64 };

/* Nanoseconds of the clock that all processes share, which is also that of .NET's Stopwatch. */
int64_t clock_now(void);

/* Of the throughput: what passed between the first frame and the last. */
void measure_begin(void);
void measure_end(int64_t frames);

/* Of the latency: the stamp that a frame carries, against the clock. Printed at the end, in nanoseconds. */
void delays_reserve(size_t frames);
size_t delays_count(void);
void delays_add(const void *values, int64_t now);
void delays_print(void);

/* Told by the sender's side of the benchmarks when it may begin: a UDP port has no connection to wait for. */
void tell_ready(void);

/* The ways to receive; each program has its own. */
void receive_throughput(int port, int64_t frames);
void receive_checked(int port, int64_t frames);
void receive_delays(int port);
void receive_datagrams(int port, size_t frames);
void receive_first(int port, int64_t started);

#endif
