/* Shared by the programs of this folder: a check that ends the program, and a server in its own process. */
#ifndef PROCESS_H
#define PROCESS_H

#include <NeuronDataReader.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/types.h>
#include <unistd.h>

#define CHECK(condition) \
    do { \
        if (!(condition)) { \
            fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
            _exit(99); \
        } \
    } while (0)

enum { VALUES = 354 };

/* How the server treats each connection. */
enum serving {
    SEND,   /* sends frames as fast as the client takes them */
    MIXED,  /* in turn: sends frames without end; sends some and closes; sends some and resets; closes at once */
    REFUSE  /* resets at once */
};

struct session {
    int socket, kind;
    const char *line;
};

static inline void *serve_session(void *argument)
{
    struct session session = *(struct session *)argument;
    struct linger reset = { 1, 0 };
    size_t length = strlen(session.line);
    int frames = session.kind == 0 ? -1 : session.kind < 3 ? 20 : 0;

    free(argument);
    while (frames-- != 0 && send(session.socket, session.line, length, MSG_NOSIGNAL) > 0)
        ;
    if (session.kind == 2)
        setsockopt(session.socket, SOL_SOCKET, SO_LINGER, &reset, sizeof reset);
    close(session.socket);
    return NULL;
}

static inline void serve_forever(int listener, enum serving serving, const char *line)
{
    int count;

    for (count = 0;; count++) {
        struct session *session = (struct session *)malloc(sizeof *session);
        pthread_t thread;

        session->socket = accept(listener, NULL, NULL);
        session->kind = serving == MIXED ? count % 4 : serving == REFUSE ? 2 : 0;
        session->line = serving == REFUSE ? "" : line;
        if (session->socket < 0 || pthread_create(&thread, NULL, serve_session, session) != 0)
            _exit(1);
        pthread_detach(thread);
    }
}

/* Starts the server and returns its port. The server ends with this process. Each frame is a line of text in which all numbers are value. */
static inline int serve(enum serving serving, const char *value)
{
    static char line[64 * VALUES];
    struct sockaddr_in address;
    socklen_t length = sizeof address;
    int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0), i;
    char *end = line + sprintf(line, "0 Char00 ");
    pid_t program;

    for (i = 0; i < VALUES; i++)
        end += sprintf(end, "%s ", value);
    sprintf(end, "||\r\n");
    memset(&address, 0, sizeof address);
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    CHECK(bind(listener, (struct sockaddr *)&address, sizeof address) == 0 && listen(listener, 64) == 0);
    CHECK(getsockname(listener, (struct sockaddr *)&address, &length) == 0);
    fflush(stdout);
    program = getpid();
    if (fork() == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != program)
            _exit(0);
        alarm(120);
        serve_forever(listener, serving, line);
    }

    close(listener);
    return ntohs(address.sin_port);
}

/* Waits until another thread makes the condition true, for at least a minute. */
#define AWAIT(condition) \
    do { \
        int waited = 0; \
        while (!(condition) && waited++ < 60000) \
            usleep(1000); \
        CHECK(condition); \
    } while (0)

#endif
