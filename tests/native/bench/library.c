/* bench-library: receives through the library's callback. */
#include "memory.h"
#include "receiver.h"

#include <NeuronDataReader.h>

#include <semaphore.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* During these frames the library makes everything that it makes only once. */
enum { WARM_UP = 2000 };

/* Written by the callback, which runs on one thread. The main thread reads them after the stream has ended. */
static int64_t frames_seen, frames_wanted, first_frame;
static uint64_t sum;
static sem_t ended;

static uint64_t sum_words(const void *bytes, size_t size)
{
    const unsigned char *next = bytes;
    uint64_t total = 0;
    uint32_t word;

    for (; size >= sizeof word; size -= sizeof word, next += sizeof word) {
        memcpy(&word, next, sizeof word);
        total += word;
    }
    return total;
}

static void count_frame(void)
{
    if (frames_seen++ == 0)
        measure_begin();
    if (frames_seen == frames_wanted)
        measure_end(frames_seen);
}

static void CALLBACK on_frame(void *object, SOCKET_REF sender, BvhDataHeader *header, float *data)
{
    (void)object, (void)sender, (void)header, (void)data;
    count_frame();
}

static void CALLBACK on_checked_frame(void *object, SOCKET_REF sender, BvhDataHeader *header, float *data)
{
    (void)object, (void)sender;
    sum += sum_words(header, sizeof *header) + sum_words(data, header->DataCount * sizeof *data);
    if (frames_seen == WARM_UP)
        memory_begin();
    if (frames_seen == frames_wanted - 1)
        memory_end();
    count_frame();
}

static void CALLBACK on_stamped_frame(void *object, SOCKET_REF sender, BvhDataHeader *header, float *data)
{
    (void)object, (void)sender, (void)header;
    delays_add(data, clock_now());
    if (delays_count() == (size_t)frames_wanted)
        sem_post(&ended);
}

static void CALLBACK on_first_frame(void *object, SOCKET_REF sender, BvhDataHeader *header, float *data)
{
    (void)object, (void)sender, (void)header, (void)data;
    if (first_frame == 0)
        first_frame = clock_now();
}

static void CALLBACK on_status(void *object, SOCKET_REF sender, SocketStatus status, char *message)
{
    (void)object, (void)sender, (void)status;
    if (strncmp(message, "Data thread exited", 18) == 0)
        sem_post(&ended);
}

static void connect_to(int port, FrameDataReceived callback)
{
    char host[] = "127.0.0.1";

    sem_init(&ended, 0, 0);
    BRRegisterFrameDataCallback(NULL, callback);
    BRRegisterSocketStatusCallback(NULL, on_status);
    if (BRConnectTo(host, port) == NULL) {
        fprintf(stderr, "%s\n", BRGetLastErrorMessage());
        exit(1);
    }
}

static void receive_all(int port, int64_t frames, FrameDataReceived callback)
{
    frames_wanted = frames;
    connect_to(port, callback);
    sem_wait(&ended);
    if (frames_seen != frames)
        measure_end(frames_seen);
}

void receive_throughput(int port, int64_t frames)
{
    receive_all(port, frames, on_frame);
}

void receive_checked(int port, int64_t frames)
{
    receive_all(port, frames, on_checked_frame);
    printf("sum %llu\n", (unsigned long long)sum);
}

void receive_delays(int port)
{
    connect_to(port, on_stamped_frame);
    sem_wait(&ended);
}

/* Receives until all frames have arrived, or none has arrived for a second. */
void receive_datagrams(int port, size_t frames)
{
    size_t before;

    sem_init(&ended, 0, 0);
    frames_wanted = (int64_t)frames;
    BRRegisterFrameDataCallback(NULL, on_stamped_frame);
    if (BRStartUDPServiceAt(port) == NULL) {
        fprintf(stderr, "%s\n", BRGetLastErrorMessage());
        exit(1);
    }
    report_ready();
    do {
        struct timespec until;

        before = delays_count();
        clock_gettime(CLOCK_REALTIME, &until);
        until.tv_sec++;
        if (sem_timedwait(&ended, &until) == 0)
            return;
    } while (before == 0 || delays_count() > before);
}

void receive_first(int port, int64_t started)
{
    int64_t loaded = clock_now(), called, connected;

    BRGetLastErrorMessage();
    called = clock_now();
    connect_to(port, on_first_frame);
    connected = clock_now();
    sem_wait(&ended);
    printf("loaded %lld\ncall %lld\nconnect %lld\nframe %lld\n", (long long)(loaded - started), (long long)(called - started),
           (long long)(connected - called), (long long)(first_frame - connected));
}
