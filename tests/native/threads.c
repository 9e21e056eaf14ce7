/* Several threads call at the same time: threads same PORT, threads errors PORT, threads churn PORT. A test compares the output. */
#include <NeuronDataReader.h>

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { THREADS = 4, ERRORS = 100, ROUNDS = 25, ERROR_CAPACITY = 1024 };

static pthread_barrier_t start;
static int port;
static int frames, wrong;

static void run_all(void *(*work)(void *))
{
    pthread_t threads[THREADS];
    pthread_barrier_init(&start, NULL, THREADS);
    for (size_t i = 0; i < THREADS; i++)
        pthread_create(&threads[i], NULL, work, NULL);
    for (size_t i = 0; i < THREADS; i++)
        pthread_join(threads[i], NULL);
}

static void *print_connection(void *unused)
{
    pthread_barrier_wait(&start);
    printf("%p\n", BRConnectTo("127.0.0.1", port));
    return unused;
}

/* Alternates long and short error texts. */
static void *fail(void *unused)
{
    static const char long_host[] = "a-name-that-is-so-long-that-no-computer-in-the-world-could-have-it-because-a-part-of-a-name-has-63-letters-at-most.invalid";
    pthread_barrier_wait(&start);
    for (int i = 0; i < ERRORS; i++)
        if (BRConnectTo(i % 2 == 0 ? long_host : "", i) != NULL)
            __atomic_add_fetch(&wrong, 1, __ATOMIC_RELAXED);
    __atomic_add_fetch(&frames, 1, __ATOMIC_RELEASE);
    return unused;
}

static void *fail_and_read(void *unused)
{
    pthread_t failing;
    char *error = BRGetLastErrorMessage();
    pthread_create(&failing, NULL, fail, NULL);
    pthread_detach(failing);
    do {
        if (memchr(error, 0, ERROR_CAPACITY) == NULL || BRGetLastErrorMessage() != error)
            __atomic_add_fetch(&wrong, 1, __ATOMIC_RELAXED);
    } while (__atomic_load_n(&frames, __ATOMIC_ACQUIRE) < THREADS);
    return unused;
}

static void CALLBACK on_frame(void *object, SOCKET_REF sender, BvhDataHeader *header, float *data)
{
    (void)data;
    if (object != &port || sender == NULL || header->Token1 != 0xDDFF || header->Token2 != 0xEEFF)
        __atomic_add_fetch(&wrong, 1, __ATOMIC_RELAXED);
    __atomic_add_fetch(&frames, 1, __ATOMIC_RELAXED);
}

/* All threads open, register, unregister and close, often the same connection. */
static void *churn(void *unused)
{
    pthread_barrier_wait(&start);
    for (int i = 0; i < ROUNDS; i++) {
        SOCKET_REF connection = BRConnectTo("127.0.0.1", port);
        SOCKET_REF service = BRStartUDPServiceAt(0);
        BRRegisterFrameDataCallback(&port, i % 2 == 0 ? on_frame : NULL);
        BRGetSocketStatus(connection);
        BRCloseSocket(service);
        if (service == NULL || BRGetSocketStatus(service) != CS_OffWork)
            __atomic_add_fetch(&wrong, 1, __ATOMIC_RELAXED);
        BRCloseSocket(connection);
    }
    return unused;
}

int main(int argc, char **argv)
{
    alarm(120);
    if (argc < 3)
        return 2;
    port = atoi(argv[2]);
    if (strcmp(argv[1], "same") == 0) {
        run_all(print_connection);
    } else if (strcmp(argv[1], "errors") == 0) {
        run_all(fail_and_read);
        printf("%d\n", wrong);
    } else {
        run_all(churn);
        BRRegisterFrameDataCallback(&port, on_frame);
        SOCKET_REF connection = BRConnectTo("127.0.0.1", port);
        for (int before = __atomic_load_n(&frames, __ATOMIC_RELAXED); __atomic_load_n(&frames, __ATOMIC_RELAXED) == before;)
            usleep(1000);
        BRCloseSocket(connection);
        printf("%d\n", wrong);
    }
    return 0;
}
