/* Threads of the program: the first call on a small stack, or on many threads at the same time; or random calls of all functions on eight threads, while
   callbacks close and connect. */
#include "process.h"

#include <limits.h>
#include <time.h>

enum { SOCKETS = 8 };

static SOCKET_REF volatile sockets[SOCKETS];
static volatile int frames, is_over, closes_in_callbacks;
static int port;
static char *const hosts[] = { "127.0.0.1", "127.0.0.2", "127.0.0.3", "127.0.0.4", "127.0.0.5", "127.0.0.6", "127.0.0.7", "127.0.0.8" };

static void CALLBACK on_frame(void *object, SOCKET_REF sender, BvhDataHeader *header, float *data)
{
    (void)object, (void)header, (void)data;
    if (++frames % 1000 == 0 && closes_in_callbacks) {
        BRCloseSocket(sender);
        sockets[frames / 1000 % SOCKETS] = BRConnectTo(hosts[frames / 1000 % SOCKETS], port);
    }
}

static void CALLBACK on_status(void *object, SOCKET_REF sender, SocketStatus status, char *message)
{
    (void)object, (void)message;
    CHECK(BRGetSocketStatus(sender) <= CS_OffWork);
    if (status == CS_OffWork && closes_in_callbacks)
        BRCloseSocket(sender);
}

static void *first_call(void *unused)
{
    (void)unused;
    BRRegisterFrameDataCallback(NULL, on_frame);
    return BRConnectTo("127.0.0.1", port);
}

static void *call_at_random(void *seed_address)
{
    unsigned seed = *(unsigned *)seed_address;

    while (!is_over) {
        int which = rand_r(&seed) % SOCKETS;

        switch (rand_r(&seed) % 8) {
        case 0:
        case 1:
            sockets[which] = BRConnectTo(hosts[which], port);
            break;
        case 2:
            BRCloseSocket(sockets[which]);
            break;
        case 3:
            BRCloseSocket(BRStartUDPServiceAt(0));
            break;
        case 4:
            BRRegisterFrameDataCallback(&seed, rand_r(&seed) % 2 ? on_frame : NULL);
            break;
        case 5:
            BRRegisterSocketStatusCallback(&seed, rand_r(&seed) % 2 ? on_status : NULL);
            break;
        case 6:
            CHECK(strlen(BRGetLastErrorMessage()) < 1024);
            break;
        default:
            CHECK(BRGetSocketStatus(sockets[which]) <= CS_OffWork);
        }
    }
    return NULL;
}

int main(int count, char **arguments)
{
    const char *how = count > 1 ? arguments[1] : "random";
    pthread_attr_t attributes;
    pthread_t threads[32];
    unsigned seeds[32];
    int number = strcmp(how, "small") == 0 ? 1 : strcmp(how, "many") == 0 ? 32 : 8, i;
    sigset_t all;
    void *socket;

    alarm(120);
    port = serve(strcmp(how, "random") == 0 ? MIXED : SEND, "1.5");
    sigfillset(&all);
    pthread_attr_init(&attributes);
    if (number == 1)
        CHECK(pthread_attr_setstacksize(&attributes, 64 * 1024) == 0);
    else
        pthread_sigmask(SIG_BLOCK, &all, NULL);
    closes_in_callbacks = number == 8;
    for (i = 0; i < number; i++) {
        seeds[i] = (unsigned)i;
        CHECK(pthread_create(&threads[i], &attributes, number == 8 ? call_at_random : first_call, &seeds[i]) == 0);
    }
    if (number == 8) {
        sleep(2);
        AWAIT(frames > 0);
        is_over = 1;
    }
    for (i = 0; i < number; i++) {
        CHECK(pthread_join(threads[i], &socket) == 0);
        CHECK(number == 8 || socket != NULL);
    }

    /* The threads that connected have ended. Connections must still work. */
    closes_in_callbacks = 0;
    BRRegisterFrameDataCallback(NULL, on_frame);
    BRRegisterSocketStatusCallback(NULL, NULL);
    if (number == 8)
        port = serve(SEND, "1.5");
    socket = BRConnectTo("127.0.0.1", port);
    frames = 0;
    AWAIT(frames > 20);
    BRCloseSocket(socket);
    return 0;
}
