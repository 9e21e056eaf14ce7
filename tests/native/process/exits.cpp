// Ends in the way that its argument names, while it receives at full speed. Its callback uses an object that exit destroys. The object's destructor calls
// the library.
#include "process.h"

#include <sys/resource.h>

#include <string>
#include <vector>

static volatile int frames;
static volatile bool exits_in_callback;

class Statistics {
public:
    Statistics() : sums(8192, 0.0f), socket(NULL), is_alive(true) {}
    ~Statistics()
    {
        is_alive = false;
        sums.assign(1, -1);
        sums.shrink_to_fit();
        BRCloseSocket(socket);
        BRRegisterFrameDataCallback(NULL, NULL);
        // Leaves time for callbacks that must not come.
        usleep(20000);
    }

    void add(const BvhDataHeader *header, const float *data)
    {
        if (!is_alive) {
            static const char late[] = "a callback came too late\n";
            if (write(2, late, sizeof late - 1) > 0)
                abort();
        }
        for (unsigned i = 0; i < header->DataCount; i++)
            sums[i] += data[i];
    }

    void closes_at_exit(SOCKET_REF opened)
    {
        socket = opened;
    }

private:
    std::vector<float> sums;
    SOCKET_REF volatile socket;
    bool is_alive;
};

static Statistics statistics;

static void CALLBACK on_frame(void *, SOCKET_REF, BvhDataHeader *header, float *data)
{
    statistics.add(header, data);
    frames++;
    if (exits_in_callback)
        exit(0);
}

static void CALLBACK on_status(void *, SOCKET_REF, SocketStatus, char *)
{
}

static void *exit_now(void *)
{
    exit(0);
}

static void *exit_later(void *)
{
    usleep(50000);
    exit(0);
}

int main(int count, char **arguments)
{
    const std::string how = count > 1 ? arguments[1] : "return";
    const int port = serve(SEND, "1.5");
    const struct rlimit no_core = {0, 0};
    pthread_t thread;

    alarm(120);
    setrlimit(RLIMIT_CORE, &no_core);
    BRRegisterFrameDataCallback(NULL, on_frame);
    BRRegisterSocketStatusCallback(NULL, on_status);
    for (int i = 0; i < 3; i++) {
        // A second connection to the same address would return the first.
        char hosts[][16] = {"127.0.0.1", "127.0.0.2", "localhost"};
        statistics.closes_at_exit(BRConnectTo(hosts[i], port));
    }
    if (how != "at-once")
        AWAIT(frames > 20);

    if (how == "exit")
        exit(0);
    if (how == "quick_exit")
        quick_exit(0);
    if (how == "_exit")
        _exit(0);
    if (how == "abort")
        abort();
    if (how == "exit-in-thread" && pthread_create(&thread, NULL, exit_now, NULL) == 0)
        pause();
    if (how == "pthread_exit" && pthread_create(&thread, NULL, exit_later, NULL) == 0)
        pthread_exit(NULL);
    if (how == "exit-in-callback") {
        exits_in_callback = true;
        pause();
    }
    return 0;
}
