/* Each test is a process, which ends before another would have begun: nothing is loaded that no
   test needs (no_git.c), and the leak checker reads no globals that are not somebody's. */
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define LEAKS_ARE_SOUGHT
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define LEAKS_ARE_SOUGHT
#endif

int git_libgit2_init(void);
int (*const fmb_no_git)(void) = git_libgit2_init; /* so that the linker keeps the library */

#ifdef LEAKS_ARE_SOUGHT
#include <link.h>
#include <sanitizer/asan_interface.h>
#include <sanitizer/lsan_interface.h>

/* Criterion sees a leak only if the process is aborted: how a test ends that has passed does not
 * count. */
const char *__asan_default_options(void)
{
    return "abort_on_error=1";
}

/* Half of the time that such a process takes was spent on ten megabytes of zeros: variables of the
   sanitizer itself, in the program. Only what other libraries point to is no leak. A test that
   keeps memory in a variable of its own has to release it. */
const char *__lsan_default_options(void)
{
    return "use_globals=0";
}

static int points_to_memory(struct dl_phdr_info *of, size_t size, void *no_data)
{
    (void)size, (void)no_data;
    for (unsigned k = 0; k < of->dlpi_phnum && *of->dlpi_name; k++) /* the program has no name */
        if (of->dlpi_phdr[k].p_type == PT_LOAD && of->dlpi_phdr[k].p_flags & PF_W)
            __lsan_register_root_region((const void *)(of->dlpi_addr + of->dlpi_phdr[k].p_vaddr),
                                        of->dlpi_phdr[k].p_memsz);
    return 0;
}

__attribute__((constructor)) static void name_what_points_to_memory(void)
{
    dl_iterate_phdr(points_to_memory, NULL);
}
#endif
