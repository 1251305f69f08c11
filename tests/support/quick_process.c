/* Makes each test's process start quickly, without a library that no test needs (no_git.c). */
int git_libgit2_init(void);
int (*const fmb_no_git)(void) = git_libgit2_init; /* so that the linker keeps the library */
