/* The floating-point environment belongs to the caller. Each call restores it, and the numbers that the library reads do not depend on it. */
#include "process.h"

#include <fenv.h>
#include <math.h>

static volatile int frames, wrong;
static float expected;

static void CALLBACK on_frame(void *object, SOCKET_REF sender, BvhDataHeader *header, float *data)
{
    unsigned i;

    (void)object, (void)sender;
    wrong |= fegetround() != FE_TONEAREST;
    for (i = 0; i < header->DataCount; i++)
        wrong |= memcmp(&data[i], &expected, sizeof expected) != 0;
    frames++;
}

static void CALLBACK on_status(void *object, SOCKET_REF sender, SocketStatus status, char *message)
{
    (void)object, (void)sender, (void)status, (void)message;
}

/* Rounds upwards and enables traps. On x64 it also turns subnormal numbers into zero. */
static void make_unusual(void)
{
    CHECK(fesetround(FE_UPWARD) == 0);
#ifdef __x86_64__
    __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | 0x8040);
    feraiseexcept(FE_UNDERFLOW);
    feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW | FE_INEXACT);
#endif
}

static void expect_same(const fenv_t *environment)
{
    fenv_t now;

    fegetenv(&now);
    CHECK(memcmp(&now, environment, sizeof now) == 0);
}

#define CALL(call) \
    do { \
        fenv_t environment; \
        fegetenv(&environment); \
        call; \
        expect_same(&environment); \
    } while (0)

int main(int count, char **arguments)
{
    /* The first value differs between rounding to nearest and rounding upwards. The second is subnormal. */
    const char *value = count > 1 ? arguments[1] : "0.1";
    int port = serve(SEND, value), order;
    char text[64];
    SOCKET_REF socket = NULL, other = NULL;

    alarm(120);
    expected = strtof(value, NULL);
    make_unusual();
    CALL(BRRegisterFrameDataCallback(NULL, on_frame));
    CALL(BRRegisterCalculationDataCallback(NULL, NULL));
    CALL(BRRegisterSocketStatusCallback(NULL, on_status));
    CALL(socket = BRConnectTo("127.0.0.1", port));
    CHECK(socket != NULL);
    AWAIT(frames > 20);
    CALL(other = BRConnectTo("127.0.0.1", 1));
    CHECK(other == NULL);
    CALL(BRGetSocketStatus(socket));
    CALL(BRGetLastErrorMessage());
    CALL(BRConnectCmd("no host", 1));
    CALL(other = BRStartUDPServiceAt(0));
    CALL(ZeroOut(socket, 0));
    CALL(ZeroOutAll(NULL));
    CALL(GetBvhRotation(socket, (void *)&order));
    CALL(GetBvhHeader(socket, 0, text, sizeof text));
    CALL(BRCloseSocket(socket));
    CALL(BRCloseSocket(other));
    CHECK(!wrong);

    /* The process ends while it receives. */
    CALL(socket = BRConnectTo("127.0.0.1", port));
    frames = 0;
    AWAIT(frames > 20);
    return 0;
}
