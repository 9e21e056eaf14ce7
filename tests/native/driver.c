/*
 * Reads commands from standard input, one a line, and calls the functions that they name. Prints one line for each result and each callback. A test
 * drives it.
 *
 *   = VALUE                            the result of an input line
 *   ! VALUE                            the result of a line that a callback or another thread ran
 *   KIND OBJECT SENDER THREAD …        a callback; THREAD is main or the system's thread number
 *
 * "when KIND LINE" makes the next callback of that kind run a line; "whenever KIND LINE" makes every callback of that kind run it. KIND is frame,
 * calculation, status, or status:TEXT for messages that begin with TEXT. In such a line, sender means the callback's connection. "thread LINE" runs
 * a line on a new thread. Objects are letters.
 */
#include <NeuronDataReader.h>

#include "old_functions.h"

#include <inttypes.h>
#include <pthread.h>
#include <semaphore.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <unistd.h>

enum { MOST_WORDS = 6, MOST_REACTIONS = 8, LINE_LENGTH = 400 };

struct call {
    char mark;
    SOCKET_REF sender;
    char *words[MOST_WORDS];
};

struct reaction {
    char kind[16], text[32], line[LINE_LENGTH];
    int once;
};

static char letters[] = "abcdefghijklmnopqrstuvwxyz";
static struct reaction reactions[MOST_REACTIONS];
static pthread_mutex_t reacting = PTHREAD_MUTEX_INITIALIZER;
static sem_t released;

static void run(char mark, SOCKET_REF sender, const char *line);

static void answer(const struct call *call, const char *format, ...)
{
    char text[1200];
    va_list values;
    va_start(values, format);
    vsnprintf(text, sizeof text, format, values);
    va_end(values);
    printf("%c %s\n", call->mark, text);
}

static const char *thread_name(void)
{
    static const char main_thread[] = "main";
    static __thread char number[16];
    long id = syscall(SYS_gettid);
    if (id == getpid())
        return main_thread;
    snprintf(number, sizeof number, "%ld", id);
    return number;
}

/* Copies the line of a reaction if the reaction fits this callback, and returns whether it does. A reaction of "when" is then used up. */
static int take_line(size_t index, const char *kind, const char *text, char *line)
{
    struct reaction *reaction = &reactions[index];
    int taken = 0;
    pthread_mutex_lock(&reacting);
    if (strcmp(reaction->kind, kind) == 0 && strncmp(text, reaction->text, strlen(reaction->text)) == 0) {
        strcpy(line, reaction->line);
        taken = 1;
        if (reaction->once)
            reaction->kind[0] = '\0';
    }
    pthread_mutex_unlock(&reacting);
    return taken;
}

static void react(const char *kind, const char *text, SOCKET_REF sender)
{
    char line[LINE_LENGTH];
    for (size_t i = 0; i < MOST_REACTIONS; i++)
        if (take_line(i, kind, text, line))
            run('!', sender, line);
}

static void add_reaction(const struct call *call, int once)
{
    size_t i = 0;
    char *text = strchr(call->words[1], ':');
    pthread_mutex_lock(&reacting);
    while (i < MOST_REACTIONS - 1 && reactions[i].kind[0] != '\0')
        i++;
    if (text != NULL)
        *text++ = '\0';
    snprintf(reactions[i].kind, sizeof reactions[i].kind, "%s", call->words[1]);
    snprintf(reactions[i].text, sizeof reactions[i].text, "%s", text == NULL ? "" : text);
    snprintf(reactions[i].line, sizeof reactions[i].line, "%s", call->words[2]);
    reactions[i].once = once;
    pthread_mutex_unlock(&reacting);
    answer(call, "added");
}

/* FNV-1a. */
static uint64_t hash(const void *data, size_t length)
{
    const unsigned char *bytes = data;
    uint64_t value = 14695981039346656037u;
    for (size_t i = 0; i < length; i++)
        value = (value ^ bytes[i]) * 1099511628211u;
    return value;
}

/* Prints a frame, runs the reactions, and reports whether the frame's memory changed meanwhile. */
static void print_frame(const char *kind, const void *object, SOCKET_REF sender, const void *header, const float *data, size_t count)
{
    char image[129];
    uint64_t header_hash = hash(header, 64), data_hash = hash(data, 4 * count);
    for (size_t i = 0; i < 64; i++)
        sprintf(image + 2 * i, "%02X", ((const unsigned char *)header)[i]);
    printf("%s %c %p %s %p %p %s %016" PRIX64 "\n", kind, *(const char *)object, sender, thread_name(), header, (const void *)data, image, data_hash);
    react(kind, "", sender);
    if (hash(header, 64) != header_hash || hash(data, 4 * count) != data_hash)
        printf("overwritten %p\n", sender);
}

static void CALLBACK on_frame(void *object, SOCKET_REF sender, BvhDataHeader *header, float *data)
{
    print_frame("frame", object, sender, header, data, header->DataCount);
}

static void CALLBACK on_calculation(void *object, SOCKET_REF sender, CalcDataHeader *header, float *data)
{
    print_frame("calculation", object, sender, header, data, header->DataCount);
}

static void CALLBACK on_status(void *object, SOCKET_REF sender, SocketStatus status, char *message)
{
    size_t length = strlen(message);
    int ends = length > 0 && message[length - 1] == '\n';
    printf("status %c %p %s %d %.*s%s\n", *(const char *)object, sender, thread_name(), (int)status, (int)(length - (size_t)ends), message, ends ? "\\n" : "");
    react("status", message, sender);
}

static SOCKET_REF handle_of(const struct call *call)
{
    void *handle = NULL;
    if (strcmp(call->words[1], "sender") == 0)
        return call->sender;
    sscanf(call->words[1], "%p", &handle);
    return handle;
}

/* "null" is NULL, "empty" an empty text, "long" a text of 5,000 letters, and "broken" a text that is not valid UTF-8. */
static const char *host_of(const struct call *call)
{
    static char letters_of_long[5001];
    const char *word = call->words[1];
    if (strcmp(word, "long") == 0)
        return memset(letters_of_long, 'x', sizeof letters_of_long - 1);
    return strcmp(word, "null") == 0 ? NULL : strcmp(word, "empty") == 0 ? "" : strcmp(word, "broken") == 0 ? "\xFF\xC3.\x80" : word;
}

static int number_of(const struct call *call, size_t index)
{
    return atoi(call->words[index]);
}

static void register_callback(const struct call *call)
{
    const char *kind = call->words[1];
    char *object = strcmp(call->words[2], "") == 0 ? NULL : &letters[call->words[2][0] - 'a'];
    if (strcmp(kind, "frame") == 0)
        BRRegisterFrameDataCallback(object, object == NULL ? NULL : on_frame);
    else if (strcmp(kind, "calculation") == 0)
        BRRegisterCalculationDataCallback(object, object == NULL ? NULL : on_calculation);
    else
        BRRegisterSocketStatusCallback(object, object == NULL ? NULL : on_status);
    answer(call, "registered");
}

static void rotation(const struct call *call)
{
    RotateOrders order = RO_XYZ;
    bool succeeded = GetBvhRotation(handle_of(call), &order);
    answer(call, "%d order %d", succeeded, (int)order);
}

/* Calls every function that takes a handle: 10 times the status, plus the number of calls that succeeded. */
static int ask_all(SOCKET_REF handle)
{
    RotateOrders order = RO_XYZ;
    BoneDimension size;
    char text[8];
    int done = ZeroOut(handle, 0) + ZeroOutAll(handle) + GetBvhRotation(handle, &order) + GetBoneSize(handle, 0, &size)
        + GetBvhHeader(handle, 0, text, sizeof text) + ask_old_functions(handle);
    int status = (int)BRGetSocketStatus(handle);
    BRCloseSocket(handle);
    return 10 * status + done;
}

/* Tries foreign handles: addresses of the program's own memory, misaligned addresses, and random numbers that no library returns. */
static void ask_all_foreign(const struct call *call)
{
    static char memory[4096];
    uint64_t random = 88172645463325252u;
    int count = number_of(call, 1), bad = 0;
    for (int i = 0; i < count; i++) {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        void *handle = i % 2 == 0 ? &memory[random % sizeof memory] : (void *)(uintptr_t)(random | 0x100000000u);
        bad += ask_all(handle) != 10 * CS_OffWork;
    }
    answer(call, "%d", bad);
}

static void ask_with_nulls(const struct call *call)
{
    SOCKET_REF pipe = handle_of(call);
    char text[8] = "before";
    answer(call, "%d %d %d %d %d %s", GetBvhRotation(pipe, NULL), GetBoneSize(pipe, 0, NULL), GetBvhHeader(pipe, 0, NULL, 100),
           GetBvhHeader(pipe, 0, text, 0), GetBvhHeader(pipe, 0, text, -1), text);
}

static void *run_on_thread(void *line)
{
    run('!', NULL, line);
    free(line);
    return NULL;
}

static void start_thread(const struct call *call)
{
    pthread_t thread;
    char *line = strdup(call->words[1]);
    if (line == NULL || pthread_create(&thread, NULL, run_on_thread, line) != 0)
        abort();
    pthread_detach(thread);
    answer(call, "started");
}

static void run_words(const struct call *call)
{
    const char *name = call->words[0];
    if (strcmp(name, "connect") == 0)
        answer(call, "%p", BRConnectTo(host_of(call), number_of(call, 2)));
    else if (strcmp(name, "udp") == 0)
        answer(call, "%p", BRStartUDPServiceAt(number_of(call, 1)));
    else if (strcmp(name, "close") == 0)
        BRCloseSocket(handle_of(call)), answer(call, "closed");
    else if (strcmp(name, "get-status") == 0)
        answer(call, "%d", (int)BRGetSocketStatus(handle_of(call)));
    else if (strcmp(name, "error") == 0)
        answer(call, "%s", BRGetLastErrorMessage());
    else if (strcmp(name, "error-length") == 0)
        answer(call, "%zu", strlen(BRGetLastErrorMessage()));
    else if (strcmp(name, "error-address") == 0)
        answer(call, "%p", (void *)BRGetLastErrorMessage());
    else if (strcmp(name, "register") == 0)
        register_callback(call);
    else if (strcmp(name, "connect-commands") == 0)
        answer(call, "%p", BRConnectCmd(host_of(call), number_of(call, 2)));
    else if (strcmp(name, "rotation") == 0)
        rotation(call);
    else if (strcmp(name, "all") == 0)
        answer(call, "%d", ask_all(handle_of(call)));
    else if (strcmp(name, "all-foreign") == 0)
        ask_all_foreign(call);
    else if (strcmp(name, "nulls") == 0)
        ask_with_nulls(call);
    else if (strcmp(name, "when") == 0)
        add_reaction(call, 1);
    else if (strcmp(name, "whenever") == 0)
        add_reaction(call, 0);
    else if (strcmp(name, "thread") == 0)
        start_thread(call);
    else if (strcmp(name, "hold") == 0)
        answer(call, "held"), sem_wait(&released), answer(call, "released");
    else if (strcmp(name, "release") == 0)
        sem_post(&released), answer(call, "done");
    else
        printf("? %s\n", name);
}

/* Splits a line into words and runs it. Missing words are empty. A line inside a line stays one word. */
static void run(char mark, SOCKET_REF sender, const char *line)
{
    static char none[] = "";
    char copy[LINE_LENGTH];
    char *next = copy;
    struct call call = { mark, sender, { none, none, none, none, none, none } };
    snprintf(copy, sizeof copy, "%s", line);
    copy[strcspn(copy, "\n")] = '\0';
    for (size_t i = 0; i < MOST_WORDS && next != NULL; i++) {
        call.words[i] = next;
        if ((i == 2 && strncmp(copy, "when", 4) == 0) || (i == 1 && strcmp(copy, "thread") == 0))
            break;
        next = strchr(next, ' ');
        if (next != NULL)
            *next++ = '\0';
    }
    run_words(&call);
}

int main(void)
{
    char line[LINE_LENGTH];

    alarm(120);
    setvbuf(stdout, NULL, _IOLBF, 0);
    sem_init(&released, 0, 0);
    BRRegisterFrameDataCallback(&letters['f' - 'a'], on_frame);
    BRRegisterCalculationDataCallback(&letters['c' - 'a'], on_calculation);
    BRRegisterSocketStatusCallback(&letters['s' - 'a'], on_status);
    while (fgets(line, sizeof line, stdin) != NULL)
        run('=', NULL, line);
    return 0;
}
