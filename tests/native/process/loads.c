/* Loads the library with all flags, unloads it while it is in use, loads it again on a thread that ends, and loads a copy of it as well. */
#include "process.h"

#include <dlfcn.h>

typedef SOCKET_REF (*connecting)(const char *, int);
typedef void (*closing)(SOCKET_REF);
typedef void (*registering)(void *, FrameDataReceived);

static volatile int frames;
static const char *library;
static int port;

static void CALLBACK on_frame(void *object, SOCKET_REF sender, BvhDataHeader *header, float *data)
{
    (void)object, (void)sender, (void)header, (void)data;
    frames++;
}

static void *find(void *handle, const char *name)
{
    void *function = dlsym(handle, name);

    CHECK(function != NULL);
    return function;
}

static void use(const char *path, int flags, int closes)
{
    void *handle = dlopen(path, flags);
    connecting connect;
    closing close_socket;
    registering set_callback;
    SOCKET_REF socket;

    if (handle == NULL)
        fprintf(stderr, "%s\n", dlerror());
    CHECK(handle != NULL);
    *(void **)&connect = find(handle, "BRConnectTo");
    *(void **)&close_socket = find(handle, "BRCloseSocket");
    *(void **)&set_callback = find(handle, "BRRegisterFrameDataCallback");
    set_callback(NULL, on_frame);
    socket = connect("127.0.0.1", port);
    CHECK(socket != NULL);
    frames = 0;
    AWAIT(frames > 20);
    if (closes)
        close_socket(socket);
    CHECK(dlclose(handle) == 0);
}

static void *use_in_thread(void *unused)
{
    use(library, RTLD_NOW | RTLD_GLOBAL, 1);
    return unused;
}

int main(int count, char **arguments)
{
    static const int flags[] = { RTLD_NOW, RTLD_LAZY | RTLD_GLOBAL, RTLD_NOW | RTLD_LOCAL, RTLD_LAZY };
    pthread_t thread;
    size_t i;

    CHECK(count == 3);
    library = arguments[1];
    port = serve(SEND, "1.5");
    alarm(120);
    for (i = 0; i < 4; i++) {
        CHECK(pthread_create(&thread, NULL, use_in_thread, NULL) == 0 && pthread_join(thread, NULL) == 0);
        use(library, flags[i], 1);
    }

    use(arguments[2], RTLD_NOW, 1);
    /* Nobody has closed this connection. It still receives, although dlclose was called for the library. */
    use(library, RTLD_NOW, 0);
    frames = 0;
    AWAIT(frames > 20);
    return 0;
}
