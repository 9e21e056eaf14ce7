/* Children of fork. A child made before the first call uses the library. In a child made after it, all functions fail, and the child may end in any
   way. Also starts programs while it receives. */
#include "process.h"

#include <errno.h>
#include <spawn.h>
#include <sys/wait.h>

extern char **environ;

static volatile int frames;

static void CALLBACK on_frame(void *object, SOCKET_REF sender, BvhDataHeader *header, float *data)
{
    (void)object, (void)sender, (void)header, (void)data;
    frames++;
}

static void receive(int port)
{
    BRRegisterFrameDataCallback(NULL, on_frame);
    CHECK(BRConnectTo("127.0.0.1", port) != NULL);
    frames = 0;
    AWAIT(frames > 20);
}

static int end_of(pid_t child)
{
    int status;

    CHECK(child > 0);
    while (waitpid(child, &status, 0) < 0)
        CHECK(errno == EINTR);
    return status;
}

static void expect_no_library(int port, SOCKET_REF socket)
{
    char text[16];

    BRRegisterFrameDataCallback(NULL, NULL);
    CHECK(BRConnectTo("127.0.0.1", port) == NULL);
    CHECK(strlen(BRGetLastErrorMessage()) > 0);
    CHECK(BRGetSocketStatus(socket) == CS_OffWork);
    CHECK(BRStartUDPServiceAt(0) == NULL && BRConnectCmd("127.0.0.1", port) == NULL);
    CHECK(!ZeroOutAll(socket) && !GetBvhHeader(socket, 0, text, sizeof text));
    BRCloseSocket(socket);
}

int main(void)
{
    static char *const echo[] = { "true", NULL };
    int port = serve(SEND, "1.5"), i;
    pid_t child;
    FILE *output;
    char line[16];

    alarm(120);
    if ((child = fork()) == 0) {
        receive(port);
        exit(0);
    }
    receive(port);
    CHECK(end_of(child) == 0);

    for (i = 0; i < 20; i++) {
        if ((child = fork()) == 0) {
            alarm(120);
            expect_no_library(port, (SOCKET_REF)1);
            if (i % 4 == 0)
                exit(0);
            if (i % 4 == 1)
                execlp("true", "true", NULL);
            if (i % 4 == 2)
                pthread_exit(NULL);
            _exit(0);
        }
        CHECK(end_of(child) == 0);
    }
    for (i = 0; i < 5; i++) {
        CHECK(system("true") == 0);
        CHECK(posix_spawnp(&child, "true", NULL, NULL, echo, environ) == 0 && end_of(child) == 0);
        CHECK((output = popen("echo text", "r")) != NULL && fgets(line, sizeof line, output) != NULL && pclose(output) == 0);
        if ((child = vfork()) == 0) {
            execlp("true", "true", (char *)NULL);
            _exit(1);
        }
        CHECK(end_of(child) == 0);
    }

    frames = 0;
    AWAIT(frames > 20);
    return 0;
}
