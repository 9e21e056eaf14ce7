/* Signals belong to the program: the library changes no disposition, handler or mask while it receives. A command to a server that is gone raises no
   signal. */
#include "process.h"

#include <setjmp.h>

static volatile sig_atomic_t calls[NSIG];
static volatile int frames, callback_mask_is_full;
static pthread_t main_thread;
static sigjmp_buf after_fault;

static void CALLBACK on_frame(void *object, SOCKET_REF sender, BvhDataHeader *header, float *data)
{
    sigset_t mask;

    (void)object, (void)sender, (void)header, (void)data;
    pthread_sigmask(SIG_SETMASK, NULL, &mask);
    callback_mask_is_full = sigismember(&mask, SIGTERM) && sigismember(&mask, SIGALRM) && !sigismember(&mask, SIGSEGV);
    frames++;
}

static void on_signal(int number)
{
    if (pthread_equal(pthread_self(), main_thread))
        calls[number]++;
}

static void on_fault(int number)
{
    calls[number]++;
    siglongjmp(after_fault, 1);
}

static void handle(int number, void (*handler)(int))
{
    struct sigaction action;

    memset(&action, 0, sizeof action);
    action.sa_handler = handler;
    CHECK(sigaction(number, &action, NULL) == 0);
}

static void expect_handlers(void)
{
    static const int numbers[] = { SIGINT, SIGTERM, SIGCHLD, SIGALRM, SIGUSR1 };
    volatile int zero = 0, *volatile nowhere = NULL;
    size_t i;

    for (i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        int before = calls[numbers[i]];

        kill(getpid(), numbers[i]);
        AWAIT(calls[numbers[i]] == before + 1);
    }

    if (sigsetjmp(after_fault, 1) == 0)
        *nowhere = 1;
    if (sigsetjmp(after_fault, 1) == 0)
        zero = 100 / zero;
}

static void set_handlers(void)
{
    handle(SIGINT, on_signal);
    handle(SIGTERM, on_signal);
    handle(SIGCHLD, on_signal);
    handle(SIGALRM, on_signal);
    handle(SIGUSR1, on_signal);
    handle(SIGSEGV, on_fault);
    handle(SIGFPE, on_fault);
}

int main(void)
{
    struct sigaction before[NSIG], after;
    sigset_t mask_before, mask_after;
    int port = serve(SEND, "1.5"), refusing = serve(REFUSE, "0"), i;
    SOCKET_REF socket, commands;

    alarm(120);
    main_thread = pthread_self();
    set_handlers();
    signal(SIGPIPE, SIG_DFL);
    sigemptyset(&mask_before);
    sigaddset(&mask_before, SIGUSR2);
    pthread_sigmask(SIG_SETMASK, &mask_before, NULL);
    for (i = 1; i < NSIG; i++)
        sigaction(i, NULL, &before[i]);

    BRRegisterFrameDataCallback(NULL, on_frame);
    socket = BRConnectTo("127.0.0.1", port);
    CHECK(socket != NULL);
    AWAIT(frames > 100);
    CHECK(callback_mask_is_full);
    for (i = 1; i < NSIG; i++)
        if (sigaction(i, NULL, &after) == 0)
            CHECK(after.sa_handler == before[i].sa_handler && after.sa_flags == before[i].sa_flags);
    CHECK(after.sa_handler == SIG_DFL);
    pthread_sigmask(SIG_SETMASK, NULL, &mask_after);
    CHECK(memcmp(&mask_before, &mask_after, sizeof(long)) == 0);

    /* Some handlers were set before the first call, others after it. */
    expect_handlers();
    CHECK(calls[SIGSEGV] == 1);
    CHECK(calls[SIGFPE] == 1);
    set_handlers();
    expect_handlers();
    CHECK(calls[SIGSEGV] == 2 && calls[SIGFPE] == 2);

    /* The default action of SIGPIPE ends the program. */
    commands = BRConnectCmd("127.0.0.1", refusing);
    for (i = 0; i < 20; i++)
        ZeroOutAll(commands);
    BRCloseSocket(commands);

    frames = 0;
    AWAIT(frames > 100);
    BRCloseSocket(socket);
    return 0;
}
