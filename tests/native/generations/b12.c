/*
 * A typical program for b12: frames with the old header, and commands on the data connection. Input lines name the functions to call; a test drives it.
 * With OLD_BINARY it stands for a program that was compiled with the vendor's headers: it does not tell the library the layout of its structs.
 */
#define NEURONDATAREADER_B12
#include <NeuronDataReader.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#ifdef OLD_BINARY
#undef BRRegisterFrameDataCallback
#endif

/* The command that the next callback of each kind sends, or -1 for none. */
static volatile int in_frame = -1;
static volatile int in_answer = -1;

static void append_hex(char *text, const void *bytes, size_t count)
{
    size_t i;

    for (i = 0; i < count; i++)
        sprintf(text + 2 * i, "%02X", ((const unsigned char *)bytes)[i]);
}

static void CALLBACK on_frame(void *object, SOCKET_REF sender, BvhDataHeaderEx *header, float *data)
{
    char image[129];
    int command = in_frame;

    append_hex(image, header, sizeof *header);
    if (header->DataVersion.Minor == 0)
        printf("frame %s %p version %u.%u.%u.%u count %u displacement %d reference %d avatar %u '%.32s' compressed %u reserved %u first %.9g last %.9g %s\n",
               (const char *)object, sender, header->DataVersion.Major, header->DataVersion.Minor, header->DataVersion.Revision,
               header->DataVersion.BuildNumb, header->DataCount, (int)header->WithDisp, (int)header->WithReference, header->AvatarIndex,
               (const char *)header->AvatarName, header->IsCompressed, header->Reserved1, data[0], data[header->DataCount - 1], image);
    else
        printf("new frame %s\n", image);

    if (command >= 0) {
        in_frame = -1;
        printf("sent in frame %d\n", BRCommandFetchDataFromServer(sender, (CmdId)command));
    }
}

static void print_bones(const CmdResponseBoneSize *bones, unsigned count)
{
    unsigned i;

    for (i = 0; i < count; i++)
        printf(" %.60s=%.9g", (const char *)bones[i].BoneName, bones[i].BoneLength);
}

static void CALLBACK on_answer(void *object, SOCKET_REF sender, CommandPack *pack, void *data)
{
    int parameters[2];
    int command = in_answer;

    memcpy(parameters, pack->CmdParaments, sizeof parameters);

    /* The main thread prints lines, too. */
    flockfile(stdout);
    printf("answer %s %p id %d version %08X length %u count %u parameters %d %d", (const char *)object, sender, (int)pack->CommandId, pack->DataVersion,
           pack->DataLength, pack->DataCount, parameters[0], parameters[1]);
    if (data == NULL)
        printf(" no data");
    else if (pack->CommandId == Cmd_BoneSize)
        print_bones((const CmdResponseBoneSize *)data, pack->DataCount);
    else if (pack->CommandId == Cmd_BvhInheritanceTxt)
        printf(" %u bytes '%.9s'", pack->DataCount, (const char *)data);
    else
        printf(" data");
    printf("\n");
    funlockfile(stdout);

    if (command >= 0) {
        in_answer = -1;
        printf("sent in answer %d\n", BRCommandFetchAvatarDataFromServer(sender, 0, (CmdId)command));
    }
}

static void CALLBACK on_status(void *object, SOCKET_REF sender, SocketStatus status, char *message)
{
    (void)sender;
    printf("status %s %d %.*s\n", (const char *)object, (int)status, (int)strcspn(message, "\n"), message);
}

int main(void)
{
    char line[256], text[128];
    int number, other;
    void *socket;

    alarm(120);
    setvbuf(stdout, NULL, _IOLBF, 0);
    while (fgets(line, sizeof line, stdin) != NULL) {
        if (strcmp(line, "register\n") == 0) {
            BRRegisterFrameDataCallback((void *)"frames", on_frame);
            BRRegisterCommandDataCallback((void *)"answers", on_answer);
            BRRegisterSocketStatusCallback((void *)"statuses", on_status);
            printf("= registered\n");
        } else if (strcmp(line, "unregister\n") == 0)
            BRRegisterCommandDataCallback(NULL, NULL), printf("= unregistered\n");
        else if (sscanf(line, "setenv %127s", text) == 1)
            printf("= %d\n", setenv("NEURONDATAREADER_HEADER", text, 1));
        else if (sscanf(line, "layout %d", &number) == 1)
            BRSetHeaderLayout((BRHeaderLayout)number), printf("= set\n");
        else if (sscanf(line, "connect-commands %127s %d", text, &number) == 2)
            printf("= %p\n", BRConnectCmd(text, number));
        else if (sscanf(line, "connect %127s %d", text, &number) == 2)
            printf("= %p\n", BRConnectTo(text, number));
        else if (sscanf(line, "udp %d", &number) == 1)
            printf("= %p\n", BRStartUDPServiceAt(number));
        else if (sscanf(line, "close %p", &socket) == 1)
            BRCloseSocket(socket), printf("= closed\n");
        else if (sscanf(line, "fetch %p %d", &socket, &number) == 2)
            printf("= %d\n", BRCommandFetchDataFromServer(socket, (CmdId)number));
        else if (sscanf(line, "fetch-avatar %p %d %d", &socket, &other, &number) == 3)
            printf("= %d\n", BRCommandFetchAvatarDataFromServer(socket, other, (CmdId)number));
        else if (sscanf(line, "watch %p %d", &socket, &number) == 2)
            printf("= %d\n", BRRegisterAutoSyncParmeter(socket, (CmdId)number));
        else if (sscanf(line, "unwatch %p %d", &socket, &number) == 2)
            printf("= %d\n", BRUnregisterAutoSyncParmeter(socket, (CmdId)number));
        else if (sscanf(line, "in-frame %d", &number) == 1)
            in_frame = number, printf("= noted\n");
        else if (sscanf(line, "in-answer %d", &number) == 1)
            in_answer = number, printf("= noted\n");
        else if (strcmp(line, "error\n") == 0)
            printf("= %s\n", BRGetLastErrorMessage());
        else
            printf("? %s", line);
    }
    return 0;
}
