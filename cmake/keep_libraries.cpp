// Linked into programs under the sanitizers only, in place of the C library's dlclose: libraries stay. Leaks are looked for
// at the very end, and what a library holds in its globals counts as leaked once it is unloaded, as Mesa's driver is by
// eglTerminate; its places in memory have then no names either, for tests/lsan.supp to go by.
extern "C" int dlclose(void*)
{
    return 0;
}
