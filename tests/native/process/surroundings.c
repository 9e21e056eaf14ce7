/* Checks that the library leaves the process unchanged: locale, environment, umask, folder, terminal, descriptors, children, threads, output. It
   prints nothing. */
#include "process.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <locale.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <termios.h>

extern char **environ;

static volatile int frames, wrong;

static void CALLBACK on_frame(void *object, SOCKET_REF sender, BvhDataHeader *header, float *data)
{
    (void)object, (void)sender;
    wrong |= header->DataCount != VALUES || data[7] != 1.5f;
    frames++;
}

static int entries_of(const char *folder)
{
    DIR *directory = opendir(folder);
    int count = 0;

    while (readdir(directory) != NULL)
        count++;
    closedir(directory);
    return count;
}

static void expect_closed_on_exec(void)
{
    int descriptor, flags;

    for (descriptor = 3; descriptor < 256; descriptor++)
        if ((flags = fcntl(descriptor, F_GETFD)) >= 0)
            CHECK((flags & FD_CLOEXEC) != 0);
}

static unsigned long sum_of_environment(void)
{
    unsigned long sum = 0;
    char **entry;
    const char *letter;

    for (entry = environ; *entry != NULL; entry++)
        for (letter = *entry; *letter != 0; letter++)
            sum = sum * 31 + (unsigned char)*letter;
    return sum;
}

int main(void)
{
    int port = serve(SEND, "1.5"), i, descriptors, threads;
    unsigned long environment;
    char folder[4096], folder_after[4096], *locale;
    struct stat input, input_after;
    mode_t mask;

    alarm(120);
    /* Close the descriptors that the parent process passed on. */
    for (i = 3; i < 256; i++)
        close(i);
    /* Use a locale with a decimal comma, if the system has one. */
    if (setlocale(LC_ALL, "de_DE.UTF-8") == NULL)
        setlocale(LC_ALL, "C.UTF-8");
    locale = strdup(setlocale(LC_ALL, NULL));
    setenv("LC_NUMERIC", "de_DE.UTF-8", 1);
    environment = sum_of_environment();
    umask(mask = 0123);
    CHECK(getcwd(folder, sizeof folder) != NULL && fstat(0, &input) == 0);

    BRRegisterFrameDataCallback(NULL, on_frame);
    for (i = 0; i < 10; i++)
        BRCloseSocket(BRStartUDPServiceAt(0));
    descriptors = entries_of("/proc/self/fd");
    threads = entries_of("/proc/self/task");
    for (i = 0; i < 400; i++) {
        SOCKET_REF service = BRStartUDPServiceAt(0), connection = i % 10 == 0 ? BRConnectTo("127.0.0.1", port) : NULL;

        CHECK(service != NULL && (i % 10 != 0 || connection != NULL));
        if (i % 100 == 0)
            expect_closed_on_exec();
        BRCloseSocket(service);
        BRCloseSocket(connection);
    }

    /* The pool may start or end a few threads at any time. */
    AWAIT(entries_of("/proc/self/fd") <= descriptors);
    AWAIT(entries_of("/proc/self/task") <= threads + 4);
    CHECK(frames > 0 && !wrong);
    CHECK(waitpid(-1, NULL, WNOHANG) == 0);
    CHECK(strcmp(locale, setlocale(LC_ALL, NULL)) == 0);
    CHECK(sum_of_environment() == environment);
    CHECK(umask(0) == mask);
    CHECK(getcwd(folder_after, sizeof folder_after) != NULL && strcmp(folder, folder_after) == 0);
    CHECK(fstat(0, &input_after) == 0 && input.st_ino == input_after.st_ino && input.st_dev == input_after.st_dev);
    free(locale);
    return 0;
}
