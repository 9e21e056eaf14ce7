/* The library's managed objects hold memory of malloc, and live where the sanitizer does not look: it takes what they hold for lost. That it is not was
   measured: it does not grow with thousands of connections. */
const char *__lsan_default_options(void);
const char *__lsan_default_suppressions(void);

const char *__lsan_default_options(void)
{
    return "print_suppressions=0";
}

const char *__lsan_default_suppressions(void)
{
    return "leak:libNeuronDataReader";
}
