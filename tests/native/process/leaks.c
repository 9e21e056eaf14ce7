/* The library's managed objects hold memory of malloc. The sanitizer does not see these objects, so it reports their memory as leaked. Measured: this
   memory does not grow with thousands of connections. */
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
