/* Invalid arguments: every function reports an error or does nothing. */
#include "process.h"

static char *const texts[] = { NULL, "", " ", "\xff\xfe\x80", "no such host", "256.1.1.1", "[", "%s%n", "127.0.0.1:80", "::g" };
static const int numbers[] = { 0, -1, 65536, 1 << 30, -2147483647 - 1, 2147483647 };

int main(void)
{
    static char long_text[100000], buffer[8];
    SOCKET_REF stale = BRStartUDPServiceAt(0), foreign[] = { NULL, (SOCKET_REF)-1, (SOCKET_REF)12345, buffer, NULL };
    SOCKET_REF service = BRStartUDPServiceAt(0);
    BoneDimension sizes;
    size_t i, j;

    alarm(120);
    CHECK(stale != NULL && service != NULL);
    foreign[4] = stale;
    BRCloseSocket(stale);
    memset(long_text, 'x', sizeof long_text - 1);
    CHECK(BRConnectTo(long_text, 7001) == NULL && BRConnectCmd(long_text, 7001) == NULL);
    for (i = 0; i < sizeof texts / sizeof texts[0]; i++)
        CHECK(BRConnectTo(texts[i], 1) == NULL && BRConnectCmd(texts[i], 1) == NULL);
    for (i = 1; i < sizeof numbers / sizeof numbers[0]; i++) {
        CHECK(BRConnectTo("127.0.0.1", numbers[i]) == NULL && BRConnectCmd("127.0.0.1", numbers[i]) == NULL);
        CHECK(BRStartUDPServiceAt(numbers[i]) == NULL);
        for (j = 0; j < sizeof foreign / sizeof foreign[0]; j++) {
            CHECK(!ZeroOut(foreign[j], numbers[i]) && !GetBoneSize(foreign[j], numbers[i], &sizes));
            CHECK(!GetBvhHeader(foreign[j], numbers[i], buffer, 8));
        }
    }
    for (j = 0; j < sizeof foreign / sizeof foreign[0]; j++) {
        RotateOrders order;

        CHECK(BRGetSocketStatus(foreign[j]) == CS_OffWork);
        CHECK(!ZeroOutAll(foreign[j]) && !GetBvhRotation(foreign[j], &order) && !GetBvhRotation(foreign[j], NULL));
        CHECK(!GetBoneSize(foreign[j], 0, NULL) && !GetBvhHeader(foreign[j], 0, NULL, 8) && !GetBvhHeader(foreign[j], 0, buffer, -1));
        BRCloseSocket(foreign[j]);
    }
    /* A UDP service accepts no commands and is not a command connection. */
    CHECK(!ZeroOutAll(service) && !GetBvhHeader(service, 0, buffer, 8));
    BRRegisterFrameDataCallback(buffer, NULL);
    BRRegisterCalculationDataCallback(NULL, NULL);
    BRRegisterSocketStatusCallback(buffer, NULL);
    BRCloseSocket(service);
    BRCloseSocket(service);
    return 0;
}
