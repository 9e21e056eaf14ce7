// Lets an exception leave a callback, which is not allowed, on the receive thread or on the calling thread.
#include "process.h"

#include <sys/resource.h>

#include <stdexcept>

static bool throws_in_status;

static void CALLBACK on_frame(void *, SOCKET_REF, BvhDataHeader *, float *)
{
    if (!throws_in_status)
        throw std::runtime_error("thrown in a frame's callback");
}

static void CALLBACK on_status(void *, SOCKET_REF, SocketStatus, char *)
{
    if (throws_in_status)
        throw std::runtime_error("thrown in a status callback");
}

int main(int count, char **)
{
    const struct rlimit no_core = {0, 0};
    const int port = serve(SEND, "1.5");

    alarm(120);
    setrlimit(RLIMIT_CORE, &no_core);
    throws_in_status = count > 1;
    BRRegisterFrameDataCallback(NULL, on_frame);
    BRRegisterSocketStatusCallback(NULL, on_status);
    try {
        char host[] = "127.0.0.1";
        BRConnectTo(host, port);
        pause();
    } catch (const std::exception &) {
        fprintf(stderr, "came through\n");
    }
    return 1;
}
