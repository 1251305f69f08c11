/* What Criterion asks of libgit2, without libgit2: it shows where two strings differ by that, which
   no test here wants, and each test is a process. Fourteen libraries are not loaded then, nor are
   the machine's certificates read. The library that tests link by this name goes before the real
   one. */
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
