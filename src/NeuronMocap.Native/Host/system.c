/* Replaces system calls of the runtime, because the runtime is a guest in another program's process. The linker redirects the calls here (--wrap). */
#include <errno.h>
#include <fenv.h>
#include <pthread.h>
#include <signal.h>
#include <sys/socket.h>

int __real_sigaction(int number, const struct sigaction *action, struct sigaction *previous);
int __real_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*start)(void *), void *argument);
ssize_t __real_send(int socket, const void *data, size_t length, int flags);
ssize_t __real_sendmsg(int socket, const struct msghdr *message, int flags);

/* All signals belong to the program. The runtime would ignore SIGPIPE. It would turn faults of managed code into exceptions, but correct code has no
   faults. It would also stop threads for a garbage collection with a signal that programs use, too. */
int __wrap_sigaction(int number, const struct sigaction *action, struct sigaction *previous)
{
    (void)action;
    return __real_sigaction(number, NULL, previous);
}

void (*__wrap_signal(int number, void (*handler)(int)))(int)
{
    (void)number;
    (void)handler;
    return SIG_DFL;
}

/* A thread that must stop for a garbage collection stops at its next call out of managed code. In this library that call comes soon. */
int __wrap_pthread_kill(pthread_t thread, int number)
{
    (void)thread;
    (void)number;
    return ESRCH;
}

/* The library's threads inherit nothing from the thread that starts them. They have the default floating-point environment. Signals that are sent to a
   process are blocked, so their handlers run on the program's own threads. All other signals are open: faults, and the signals with which runtimes that
   callbacks use (Mono, Java) stop threads. */
int __wrap_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*start)(void *), void *argument)
{
    static const int of_processes[] = { SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGALRM, SIGCHLD, SIGTSTP, SIGWINCH };
    fenv_t environment;
    sigset_t blocked, mask;
    size_t i;
    int error;

    sigemptyset(&blocked);
    for (i = 0; i < sizeof of_processes / sizeof of_processes[0]; i++)
        sigaddset(&blocked, of_processes[i]);
    fegetenv(&environment);
    fesetenv(FE_DFL_ENV);
    pthread_sigmask(SIG_SETMASK, &blocked, &mask);
    error = __real_pthread_create(thread, attributes, start, argument);
    pthread_sigmask(SIG_SETMASK, &mask, NULL);
    fesetenv(&environment);
    return error;
}

/* Sending to a connection that the other side has closed returns an error. The process gets no SIGPIPE. */
ssize_t __wrap_send(int socket, const void *data, size_t length, int flags)
{
    return __real_send(socket, data, length, flags | MSG_NOSIGNAL);
}

ssize_t __wrap_sendmsg(int socket, const struct msghdr *message, int flags)
{
    return __real_sendmsg(socket, message, flags | MSG_NOSIGNAL);
}
