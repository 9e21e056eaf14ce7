/* The exported functions on Linux. They call the managed functions, which the build renames to managed_NAME. They start the runtime. They fail if the
   runtime did not start, or if this is a child that fork created after the start. Managed code runs with the default floating-point environment; the
   caller's environment is saved and restored. */
#include <fenv.h>
#include <pthread.h>
#include <stddef.h>
#include <stdlib.h>

enum { NOT_STARTED, STARTING, RUNNING, FAILED, FORKED };

const char *managed_BRGetLastErrorMessage(void);

static volatile int state = NOT_STARTED;
static pthread_once_t once = PTHREAD_ONCE_INIT;
static int (*start_runtime)(void);
static void (*exit_handler)(void);
static void (*refusal_handler)(void);

/* A child process has none of the library's threads, and locks that those threads held stay locked. */
static void on_fork_in_child(void)
{
    state = FORKED;
}

static void end_callbacks(void)
{
    fenv_t environment;

    if (state != RUNNING)
        return;

    fegetenv(&environment);
    fesetenv(FE_DFL_ENV);
    exit_handler();
    fesetenv(&environment);
}

static void start(void)
{
    /* A child of a process that was just starting reaches this point again. */
    if (state != NOT_STARTED)
        return;

    state = STARTING;
    if (pthread_atfork(NULL, NULL, on_fork_in_child) != 0 || start_runtime() != 0 || atexit(end_callbacks) != 0) {
        state = FAILED;
        return;
    }

    /* Creates the objects that all functions share, and sets the handlers, unless memory runs out. */
    managed_BRGetLastErrorMessage();
    state = exit_handler != NULL ? RUNNING : FAILED;
}

/* When the library is loaded, the runtime passes the function that starts it. The first managed function would call that function and abort on a
   failure. Here it is called earlier, so that a failure can be handled. */
static int is_started(void)
{
    return state == STARTING || state == RUNNING ? 0 : -1;
}

void __real_RhSetRuntimeInitializationCallback(int (*callback)(void));

void __wrap_RhSetRuntimeInitializationCallback(int (*callback)(void))
{
    start_runtime = callback;
    __real_RhSetRuntimeInitializationCallback(is_started);
}

/* Called from managed code. on_exit_of_process runs before the destructors of the program's objects. on_refusal runs when a connection is refused because
   threads cannot be created. */
void NeuronMocapSetHandlers(void (*on_exit_of_process)(void), void (*on_refusal)(void))
{
    exit_handler = on_exit_of_process;
    refusal_handler = on_refusal;
}

static int enter(fenv_t *environment)
{
    if (state == FORKED)
        return 0;

    fegetenv(environment);
    fesetenv(FE_DFL_ENV);
    pthread_once(&once, start);
    if (state == RUNNING)
        return 1;

    fesetenv(environment);
    return 0;
}

static void *wait_at(void *gate)
{
    pthread_mutex_lock(gate);
    pthread_mutex_unlock(gate);
    return NULL;
}

/* The runtime starts threads on demand and ends the process if it cannot create one. A connection is therefore opened only if the threads that it may need
   can be created. */
static int has_threads(void)
{
    enum { NEEDED = 8 };

    pthread_mutex_t gate = PTHREAD_MUTEX_INITIALIZER;
    pthread_t threads[NEEDED];
    int started = 0, i;

    pthread_mutex_lock(&gate);
    while (started < NEEDED && pthread_create(&threads[started], NULL, wait_at, &gate) == 0)
        started++;
    pthread_mutex_unlock(&gate);
    for (i = 0; i < started; i++)
        pthread_join(threads[i], NULL);
    if (started < NEEDED)
        refusal_handler();
    return started == NEEDED;
}

#define FUNCTION(type, failure, name, parameters, arguments) GUARDED(1, type, failure, name, parameters, arguments)
#define OPENING(name, parameters, arguments) GUARDED(has_threads(), void *, NULL, name, parameters, arguments)

#define GUARDED(condition, type, failure, name, parameters, arguments) \
    type managed_##name parameters; \
    type name parameters \
    { \
        fenv_t environment; \
        type result = failure; \
        if (enter(&environment)) { \
            if (condition) \
                result = managed_##name arguments; \
            fesetenv(&environment); \
        } \
        return result; \
    }

#define PROCEDURE(name, parameters, arguments) \
    void managed_##name parameters; \
    void name parameters \
    { \
        fenv_t environment; \
        if (enter(&environment)) { \
            managed_##name arguments; \
            fesetenv(&environment); \
        } \
    }

enum { OFF_WORK = 2 };

#define NO_RUNTIME "The library cannot run here: it did not start, or this is a forked process."

PROCEDURE(BRSetHeaderLayout, (int layout), (layout))
PROCEDURE(BRRegisterFrameDataCallback, (void *object, void *handle), (object, handle))
PROCEDURE(BRRegisterCalculationDataCallback, (void *object, void *handle), (object, handle))
PROCEDURE(BRRegisterSocketStatusCallback, (void *object, void *handle), (object, handle))
PROCEDURE(BRRegisterCommandDataCallback, (void *object, void *handle), (object, handle))
OPENING(BRConnectTo, (const char *host, int port), (host, port))
OPENING(BRStartUDPServiceAt, (int port), (port))
OPENING(BRConnectCmd, (const char *host, int port), (host, port))
PROCEDURE(BRCloseSocket, (void *socket), (socket))
FUNCTION(int, OFF_WORK, BRGetSocketStatus, (void *socket), (socket))
FUNCTION(const char *, NO_RUNTIME, BRGetLastErrorMessage, (void), ())
FUNCTION(int, 0, ZeroOut, (void *socket, int avatar), (socket, avatar))
FUNCTION(int, 0, ZeroOutAll, (void *socket), (socket))
FUNCTION(int, 0, GetBvhRotation, (void *socket, int *order), (socket, order))
FUNCTION(int, 0, GetBoneSize, (void *socket, int avatar, void *sizes), (socket, avatar, sizes))
FUNCTION(int, 0, BRGetBoneSize, (void *socket, int avatar, void *sizes), (socket, avatar, sizes))
FUNCTION(int, 0, GetBvhHeader, (void *socket, int avatar, char *data, int length), (socket, avatar, data, length))
FUNCTION(int, 0, BRCommandFetchDataFromServer, (void *socket, int command), (socket, command))
FUNCTION(int, 0, BRCommandFetchAvatarDataFromServer, (void *socket, int avatar, int command), (socket, avatar, command))
FUNCTION(int, 0, BRRegisterAutoSyncParmeter, (void *socket, int command), (socket, command))
FUNCTION(int, 0, BRUnregisterAutoSyncParmeter, (void *socket, int command), (socket, command))
