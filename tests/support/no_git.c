/* A stub of the libgit2 functions that Criterion calls. Criterion uses libgit2 only to show where
   two strings differ, which no test here needs, but loads it in each test's process, with fourteen
   libraries and the machine's certificates. Tests link this library under the same name, before the
   real one. */
int git_libgit2_init(void);
int git_libgit2_shutdown(void);
int git_diff_buffers(void);

int git_libgit2_init(void)
{
    return 1;
}

int git_libgit2_shutdown(void)
{
    return 0;
}

int git_diff_buffers(void) /* without a line that differs */
{
    return 0;
}
