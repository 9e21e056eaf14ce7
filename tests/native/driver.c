/* Calls the functions that lines on its input name, and prints what they and the callbacks say. A test drives it. */
#include <NeuronDataReader.h>

#include <stdio.h>
#include <string.h>

static void CALLBACK on_frame(void *object, SOCKET_REF sender, BvhDataHeader *header, float *data)
{
    printf("frame %s %p avatar %u '%.32s' index %u count %u first %g last %g\n", (const char *)object, sender, header->AvatarIndex,
           (const char *)header->AvatarName, header->FrameIndex, header->DataCount, data[0], data[header->DataCount - 1]);
}

static void CALLBACK on_calculation(void *object, SOCKET_REF sender, CalcDataHeader *header, float *data)
{
    printf("calculation %s %p avatar %u index %u count %u first %g last %g\n", (const char *)object, sender, header->AvatarIndex,
           header->FrameIndex, header->DataCount, data[0], data[header->DataCount - 1]);
}

static void CALLBACK on_status(void *object, SOCKET_REF sender, SocketStatus status, char *message)
{
    size_t length = strlen(message);
    int ends = length > 0 && message[length - 1] == '\n';
    printf("status %s %p %d %.*s%s\n", (const char *)object, sender, (int)status, (int)(length - (size_t)ends), message, ends ? "\\n" : "");
}

int main(void)
{
    char line[256], text[128];
    int number;
    void *socket;

    setvbuf(stdout, NULL, _IOLBF, 0);
    BRRegisterFrameDataCallback("frames", on_frame);
    BRRegisterCalculationDataCallback("calculations", on_calculation);
    BRRegisterSocketStatusCallback("statuses", on_status);
    while (fgets(line, sizeof line, stdin) != NULL) {
        if (sscanf(line, "connect %127s %d", text, &number) == 2)
            printf("= %p\n", BRConnectTo(text, number));
        else if (sscanf(line, "udp %d", &number) == 1)
            printf("= %p\n", BRStartUDPServiceAt(number));
        else if (sscanf(line, "close %p", &socket) == 1)
            BRCloseSocket(socket), printf("= closed\n");
        else if (sscanf(line, "get-status %p", &socket) == 1)
            printf("= %d\n", (int)BRGetSocketStatus(socket));
        else if (strcmp(line, "error\n") == 0)
            printf("= %s\n", BRGetLastErrorMessage());
        else
            printf("? %s", line);
    }
    return 0;
}
