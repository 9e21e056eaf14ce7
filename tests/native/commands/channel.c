/* Sends commands on the command channel, as C programs do. channel.cpp includes this file for C++. Input lines name the functions to call; a test drives it. */
#include <NeuronDataReader.h>

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define THREADS 4

/* Some languages and declarations read the result as an int, so the bytes above the bool must be 0. */
typedef int (NEURONDATAREADER_CALL *IntResult)(SOCKET_REF, int);

/* Converts the function pointer without a compiler warning. */
static IntResult zero_out_as_int(void)
{
    IntResult result;
    bool (NEURONDATAREADER_CALL *function)(SOCKET_REF, int) = ZeroOut;

    memcpy(&result, &function, sizeof result);
    return result;
}

static void print_rotation(SOCKET_REF socket)
{
    RotateOrders order = RO_XZY;
    bool told = GetBvhRotation(socket, &order);

    printf("= %d order %d\n", told, (int)order);
}

static void print_bone_size(bool (NEURONDATAREADER_CALL *ask)(SOCKET_REF, int, BoneDimension *), SOCKET_REF socket, int avatar)
{
    BoneDimension size;
    const float *values = &size.Head;
    bool told;
    int i;

    memset(&size, 0xFF, sizeof size);
    told = ask(socket, avatar, &size);
    printf("= %d", told);
    for (i = 0; i < 12; i++)
        printf(" %.9g", values[i]);
    printf("\n");
}

/* Prints what the call wrote into len bytes, all 'x' before, and whether it left the byte after them unchanged. */
static void print_header(SOCKET_REF socket, int avatar, int len)
{
    size_t room = len > 0 ? (size_t)len : 0, end, i;
    char *text = (char *)malloc(room + 1);
    bool told;

    memset(text, 'x', room + 1);
    told = GetBvhHeader(socket, avatar, text, len);
    for (end = 0; end < room && text[end] != '\0'; end++)
        ;
    printf("= %d ", told);
    for (i = 0; i < end; i++) {
        if (text[i] == '\n')
            printf("\\n");
        else if (text[i] == '\r')
            printf("\\r");
        else
            putchar(text[i]);
    }
    printf("%s%s\n", end < room ? "\\0" : "", text[room] == 'x' ? "" : " OVERRUN");
    free(text);
}

static void *ask_often(void *argument)
{
    SOCKET_REF socket = *(SOCKET_REF *)argument;
    size_t right = 0;
    int i;

    for (i = 0; i < 25; i++) {
        RotateOrders order = RO_Unknown;
        BoneDimension size;
        right += ZeroOut(socket, 0) && GetBvhRotation(socket, &order) && order == RO_ZXY && GetBoneSize(socket, 1, &size) && ZeroOutAll(socket);
    }
    return (void *)right;
}

static void print_threads(SOCKET_REF socket)
{
    pthread_t threads[THREADS];
    int i;

    for (i = 0; i < THREADS; i++)
        pthread_create(&threads[i], NULL, ask_often, &socket);
    printf("=");
    for (i = 0; i < THREADS; i++) {
        void *right;
        pthread_join(threads[i], &right);
        printf(" %d", (int)(size_t)right);
    }
    printf("\n");
}

/* Runs a command while another one is waiting for its answer. */
static void *ask_once(void *argument)
{
    printf("asked %d\n", ZeroOutAll((SOCKET_REF)argument));
    return NULL;
}

int main(void)
{
    char line[256], text[128];
    int number, other;
    void *socket;
    pthread_t asking;

    alarm(120);
    setvbuf(stdout, NULL, _IOLBF, 0);
    while (fgets(line, sizeof line, stdin) != NULL) {
        if (sscanf(line, "connect-commands %127s %d", text, &number) == 2)
            printf("= %p\n", BRConnectCmd(text, number));
        else if (sscanf(line, "connect %127s %d", text, &number) == 2)
            printf("= %p\n", BRConnectTo(text, number));
        else if (sscanf(line, "get-status %p", &socket) == 1)
            printf("= %d\n", (int)BRGetSocketStatus(socket));
        else if (sscanf(line, "zero-out %p %d", &socket, &number) == 2)
            printf("= %d\n", ZeroOut(socket, number));
        else if (sscanf(line, "zero-out-as-int %p %d", &socket, &number) == 2)
            printf("= %d\n", zero_out_as_int()(socket, number));
        else if (sscanf(line, "zero-out-all %p", &socket) == 1)
            printf("= %d\n", ZeroOutAll(socket));
        else if (sscanf(line, "rotation %p", &socket) == 1)
            print_rotation(socket);
        else if (sscanf(line, "bone-size %p %d", &socket, &number) == 2)
            print_bone_size(GetBoneSize, socket, number);
        else if (sscanf(line, "bone-size-by-heading %p %d", &socket, &number) == 2)
            print_bone_size(BRGetBoneSize, socket, number);
        else if (sscanf(line, "header %p %d %d", &socket, &number, &other) == 3)
            print_header(socket, number, other);
        else if (sscanf(line, "threads %p", &socket) == 1)
            print_threads(socket);
        else if (sscanf(line, "ask-aside %p", &socket) == 1)
            pthread_create(&asking, NULL, ask_once, socket), pthread_detach(asking);
        else if (sscanf(line, "close %p", &socket) == 1)
            BRCloseSocket(socket), printf("= closed\n");
        else if (strcmp(line, "error\n") == 0)
            printf("= %s\n", BRGetLastErrorMessage());
        else
            printf("? %s", line);
    }
    return 0;
}
