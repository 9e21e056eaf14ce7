/* Tests only compile this file: layout.h, and typical calls, without a warning. */
#include "layout.h"

#ifdef NEURONDATAREADER_B10
typedef BvhDataHeader FrameHeader;
#else
typedef BvhDataHeaderEx FrameHeader;
#endif

static void CALLBACK on_frame(void *customedObj, SOCKET_REF sender, FrameHeader *header, float *data)
{
    *(float *)customedObj = sender != NULL && header->WithDisp && header->DataVersion.Major == 1 ? data[0] : 0;
}

static void CALLBACK on_calculation(void *customedObj, SOCKET_REF sender, CalcDataHeader *header, float *data)
{
    *(float *)customedObj = sender != NULL && header->DataVersion._VersionMask == 0 ? data[0] : 0;
}

static void CALLBACK on_status(void *customedObj, SOCKET_REF sender, SocketStatus status, char *message)
{
    *(char *)customedObj = sender != NULL && status == CS_Running ? message[0] : '\0';
}

SOCKET_REF use_reader(char *host, float *value);
SOCKET_REF use_reader(char *host, float *value)
{
    SOCKET_REF (NEURONDATAREADER_CALL *open_service)(int) = BRStartUDPServiceAt;
    void (NEURONDATAREADER_CALL *set_frames)(void *, FrameDataReceived) = BRRegisterFrameDataCallback;
    char *error = BRGetLastErrorMessage();
    SOCKET_REF reader = BRConnectTo(host, 7001), literal = BRConnectTo("127.0.0.1", 7001);

    set_frames(value, on_frame);
    BRRegisterFrameDataCallback(value, on_frame);
    BRRegisterFrameDataCallback(NULL, NULL);
    BRRegisterCalculationDataCallback(value, on_calculation);
    BRRegisterSocketStatusCallback(value, on_status);
    BRSetHeaderLayout(BR_HEADER_NEW);
    if (BRGetSocketStatus(reader) == CS_OffWork)
        BRCloseSocket(literal);
    return *error != '\0' ? reader : open_service(7002);
}

bool use_commands(char *host, RotateOrders *order, BoneDimension *size, char *text);
bool use_commands(char *host, RotateOrders *order, BoneDimension *size, char *text)
{
    SOCKET_REF commands = BRConnectCmd(host, 8013);
    return ZeroOut(commands, 0) && ZeroOutAll(commands) && GetBvhRotation(commands, order) && GetBoneSize(commands, 0, size)
        && GetBvhHeader(commands, 0, text, 100);
}

#ifdef NEURONDATAREADER_B12

static void CALLBACK on_command(void *customedObj, SOCKET_REF sender, CommandPack *pack, void *data)
{
    *(char *)customedObj = sender != NULL && pack->CommandId == Cmd_BoneSize ? (char)((CmdResponseBoneSize *)data)->BoneName[0] : '\0';
}

BOOL use_old_commands(SOCKET_REF reader, char *name);
BOOL use_old_commands(SOCKET_REF reader, char *name)
{
    BRRegisterCommandDataCallback(name, on_command);
    return BRCommandFetchDataFromServer(reader, Cmd_AvatarCount) && BRCommandFetchAvatarDataFromServer(reader, 0, Cmd_BoneSize)
        && BRRegisterAutoSyncParmeter(reader, Cmd_BoneSize) && BRUnregisterAutoSyncParmeter(reader, Cmd_BoneSize);
}

#endif
