/* Closes while callbacks wait for the thread that closes: read, two, exit. Closing returns soon, no callback begins after it, and a callback that ends
   later can still read its frame. */
#include "process.h"

#include <semaphore.h>
#include <time.h>

enum { CONNECTIONS = 3, ROUNDS = 4 };

static sem_t entered, released;
static volatile int is_closed, begun_late, running, ended;
static volatile float sum;

static double now(void)
{
    struct timespec time;

    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void CALLBACK on_frame(void *object, SOCKET_REF sender, BvhDataHeader *header, float *data)
{
    unsigned i;

    (void)object;
    (void)sender;
    if (is_closed)
        __atomic_add_fetch(&begun_late, 1, __ATOMIC_SEQ_CST);
    __atomic_add_fetch(&running, 1, __ATOMIC_SEQ_CST);
    sem_post(&entered);
    while (sem_wait(&released) != 0)
        ;
    CHECK(header->Token1 == 0xDDFF && header->Token2 == 0xEEFF && header->DataCount == VALUES);
    for (i = 0; i < header->DataCount; i++)
        CHECK(data[i] == 1.5f);
    __atomic_add_fetch(&ended, 1, __ATOMIC_SEQ_CST);
}

static void CALLBACK on_other_frame(void *object, SOCKET_REF sender, BvhDataHeader *header, float *data)
{
    (void)object;
    (void)sender;
    sum += data[header->DataCount - 1];
    sem_post(&entered);
}

/* Each connection needs its own server: a second connection to the same address would return the first. */
static void connect_all(const int *ports, SOCKET_REF *sockets)
{
    int i;

    is_closed = 0;
    BRRegisterFrameDataCallback(NULL, on_frame);
    for (i = 0; i < CONNECTIONS; i++) {
        sockets[i] = BRConnectTo("127.0.0.1", ports[i]);
        CHECK(sockets[i] != NULL);
        while (sem_wait(&entered) != 0)
            ;
    }
}

static void *close_socket(void *socket)
{
    BRCloseSocket(socket);
    return NULL;
}

/* Closes each connection on one thread, or on two at the same time. */
static void close_all(SOCKET_REF *sockets, int threads)
{
    pthread_t thread;
    int i;

    for (i = 0; i < CONNECTIONS; i++) {
        if (threads > 1)
            CHECK(pthread_create(&thread, NULL, close_socket, sockets[i]) == 0);
        BRCloseSocket(sockets[i]);
        if (threads > 1)
            pthread_join(thread, NULL);
        CHECK(BRGetSocketStatus(sockets[i]) == CS_OffWork);
    }

    is_closed = 1;
}

/* Uses memory like a program that keeps running, so that freed memory is overwritten. */
static void receive_others(int port)
{
    int i;

    BRRegisterFrameDataCallback(NULL, on_other_frame);
    for (i = 0; i < 5; i++) {
        SOCKET_REF socket = BRConnectTo("127.0.0.1", port);

        CHECK(socket != NULL);
        while (sem_wait(&entered) != 0)
            ;
        BRCloseSocket(socket);
        while (sem_trywait(&entered) == 0)
            ;
    }
}

int main(int count, char **arguments)
{
    const char *how = count > 1 ? arguments[1] : "read";
    const int other_port = serve(SEND, "2.5"), threads = strcmp(how, "two") == 0 ? 2 : 1;
    int ports[CONNECTIONS];
    SOCKET_REF sockets[CONNECTIONS];
    double quickest = 1e9;
    int round, i;

    alarm(120);
    sem_init(&entered, 0, 0);
    sem_init(&released, 0, 0);
    for (i = 0; i < CONNECTIONS; i++)
        ports[i] = serve(SEND, "1.5");
    for (round = 1; round <= ROUNDS; round++) {
        double start;

        connect_all(ports, sockets);
        start = now();
        close_all(sockets, threads);
        if (now() - start < quickest)
            quickest = now() - start;
        CHECK(running == round * CONNECTIONS && ended == running - CONNECTIONS);
        if (strcmp(how, "exit") == 0)
            return 0;
        receive_others(other_port);
        for (i = 0; i < CONNECTIONS; i++)
            sem_post(&released);
        AWAIT(ended == round * CONNECTIONS);
        CHECK(begun_late == 0 && running == ended);
    }

    /* If closing waited for the callbacks to end, it would take 2 s for each. */
    CHECK(quickest < 2);
    return 0;
}
