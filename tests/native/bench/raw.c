/* bench-raw: the lower bound. Receives into one buffer with blocking calls and parses nothing. */
#include "receiver.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/time.h>

static unsigned char buffer[256 * 1024];

static int open_socket(int type, int port, int (*attach)(int, const struct sockaddr *, socklen_t))
{
    struct sockaddr_in address;
    int handle = socket(AF_INET, type, 0);

    memset(&address, 0, sizeof address);
    address.sin_family = AF_INET;
    address.sin_port = htons((uint16_t)port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (handle < 0 || attach(handle, (struct sockaddr *)&address, sizeof address) != 0) {
        perror("socket");
        exit(1);
    }
    return handle;
}

static int connect_to(int port)
{
    int handle = open_socket(SOCK_STREAM, port, connect), on = 1;

    setsockopt(handle, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    return handle;
}

void receive_throughput(int port, int64_t frames)
{
    int handle = connect_to(port);
    ssize_t count = recv(handle, buffer, sizeof buffer, 0);
    int64_t received = 0;

    (void)frames;
    measure_begin();
    for (; count > 0; count = recv(handle, buffer, sizeof buffer, 0))
        received += count;
    measure_end(received / FRAME_SIZE);
}

/* Sums all 32-bit words of the stream. The bytes of an incomplete word wait at the start of the buffer. */
void receive_checked(int port, int64_t frames)
{
    int handle = connect_to(port);
    int64_t received = 0;
    uint64_t sum = 0;
    size_t kept = 0;
    ssize_t count = recv(handle, buffer, sizeof buffer, 0);

    (void)frames;
    measure_begin();
    for (; count > 0; count = recv(handle, buffer + kept, sizeof buffer - kept, 0)) {
        size_t size = kept + (size_t)count, i;
        uint32_t word;

        for (i = 0; i + sizeof word <= size; i += sizeof word) {
            memcpy(&word, buffer + i, sizeof word);
            sum += word;
        }
        kept = size - i;
        memcpy(buffer, buffer + i, kept);
        received += count;
    }
    measure_end(received / FRAME_SIZE);
    printf("sum %llu\n", (unsigned long long)sum);
}

void receive_delays(int port)
{
    int handle = connect_to(port);
    ssize_t count;

    while ((count = recv(handle, buffer, sizeof buffer, 0)) > 0) {
        int64_t now = clock_now();

        if (count == FRAME_SIZE)
            delays_add(buffer + HEADER_SIZE, now);
    }
}

/* Receives until all frames have arrived, or none has arrived for a second. */
void receive_datagrams(int port, size_t frames)
{
    int handle = open_socket(SOCK_DGRAM, port, bind);
    struct timeval timeout = {1, 0};

    report_ready();
    while (delays_count() < frames && recv(handle, buffer, sizeof buffer, 0) == FRAME_SIZE) {
        delays_add(buffer + HEADER_SIZE, clock_now());
        setsockopt(handle, SOL_SOCKET, SO_RCVTIMEO, &timeout, sizeof timeout);
    }
}

void receive_first(int port, int64_t started)
{
    int64_t loaded = clock_now(), called, connected, frame;
    int handle = socket(AF_INET, SOCK_STREAM, 0);

    called = clock_now();
    (void)handle;
    handle = connect_to(port);
    connected = clock_now();
    if (recv(handle, buffer, FRAME_SIZE, MSG_WAITALL) != FRAME_SIZE)
        exit(1);
    frame = clock_now();
    while (recv(handle, buffer, sizeof buffer, 0) > 0)
        continue;
    printf("loaded %lld\ncall %lld\nconnect %lld\nframe %lld\n", (long long)(loaded - started), (long long)(called - started),
           (long long)(connected - called), (long long)(frame - connected));
}
