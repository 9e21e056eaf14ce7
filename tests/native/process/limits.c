/* A process with a limit on addresses (KiB), descriptors or threads. A connection either fails or receives; nothing else happens. */
#include "process.h"

#include <dlfcn.h>
#include <sys/resource.h>

static volatile int frames;
static int threads, most_threads = 1000;

struct start {
    void *(*function)(void *);
    void *argument;
};

static void *run_counted(void *argument)
{
    struct start start = *(struct start *)argument;
    void *result;

    free(argument);
    result = start.function(start.argument);
    __atomic_sub_fetch(&threads, 1, __ATOMIC_SEQ_CST);
    return result;
}

/* Replaces the system's function, for the library too. */
int pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*function)(void *), void *argument)
{
    int (*create)(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *);
    struct start *start = malloc(sizeof *start);

    *(void **)&create = dlsym(RTLD_NEXT, "pthread_create");
    start->function = function;
    start->argument = argument;
    if (__atomic_add_fetch(&threads, 1, __ATOMIC_SEQ_CST) <= most_threads)
        return create(thread, attributes, run_counted, start);

    __atomic_sub_fetch(&threads, 1, __ATOMIC_SEQ_CST);
    free(start);
    return 11;
}

static void CALLBACK on_frame(void *object, SOCKET_REF sender, BvhDataHeader *header, float *data)
{
    (void)object, (void)sender, (void)header, (void)data;
    frames++;
}

static void limit(int which, unsigned long most)
{
    struct rlimit limit;

    getrlimit(which, &limit);
    limit.rlim_cur = most;
    CHECK(setrlimit(which, &limit) == 0);
}

int main(int count, char **arguments)
{
    int port, i, failures = 0;
    unsigned long most;

    CHECK(count == 3);
    alarm(120);
    port = serve(SEND, "1.5");
    most = strtoul(arguments[2], NULL, 10);
    if (strcmp(arguments[1], "addresses") == 0)
        limit(RLIMIT_AS, most * 1024);
    else if (strcmp(arguments[1], "descriptors") == 0)
        limit(RLIMIT_NOFILE, most);
    else
        most_threads = (int)most;

    for (i = 0; i < 20; i++)
        failures += BRStartUDPServiceAt(0) == NULL;
    BRRegisterFrameDataCallback(NULL, on_frame);
    for (i = 0; i < 5; i++) {
        SOCKET_REF socket = BRConnectTo("127.0.0.1", port), commands = BRConnectCmd("127.0.0.1", port);

        failures += (socket == NULL) + (commands == NULL);
        if (socket != NULL) {
            frames = 0;
            AWAIT(frames > 20);
        }
        BRCloseSocket(socket);
        BRCloseSocket(commands);
    }
    CHECK(failures == 0 || strcmp(BRGetLastErrorMessage(), "No error.") != 0);
    printf("%d\n", failures);
    return 0;
}
