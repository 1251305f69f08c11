/* scale.c: the law of scales (law.h) on random problems.
 *
 *   scale [--count=N] [--first=I] [--processes=P] [--law=NAME]
 *
 * Problem i is drawn from seed i alone, of the laws in turn (or of one). Exit 1 if one is broken;
 * a line names its law and its seed, with which --first and --count=1 show it again.
 */
#include <stdlib.h>
#include <string.h>

#include "crew.h"
#include "property/scale/law.h"

enum { GIVE_UP = 10 };

static bool job(void *self, uint64_t i, agree *g, uint64_t *failures)
{
    const law_entry *only = self, *e = only ? only : &law_list[i % LAWS];
    law_source source = {.state = i};
    char why[LAW_WHY] = "";
    g->questions++;
    if (!e->holds(&source, why)) {
        ++*failures;
        fprintf(stderr, "seed %llu, %s: %s\n", (unsigned long long)i, e->name, why);
    }
    return *failures < GIVE_UP;
}

static bool read_law(const char *arg, law_entry *only, void **self)
{
    for (int k = 0; strncmp(arg, "--law=", 6) == 0 && k < LAWS; k++)
        if (strcmp(arg + 6, law_list[k].name) == 0) {
            *only = law_list[k];
            *self = only;
            return true;
        }
    return false;
}

int main(int argc, char **argv)
{
    uint64_t count = 1000, first = 0, processes = 2;
    law_entry only;
    void *self = NULL;
    for (int i = 1; i < argc; i++)
        if (!crew_number(argv[i], "--count=", &count) &&
            !crew_number(argv[i], "--first=", &first) &&
            !crew_number(argv[i], "--processes=", &processes) && !read_law(argv[i], &only, &self)) {
            fprintf(stderr, "usage: scale [--count=N] [--first=I] [--processes=P] [--law=NAME]\n");
            return 64;
        }
    crew_sum sum;
    bool good = crew_run(job, self, first, count, (int)processes, 0, &sum);
    printf("%llu problems and their scaled twins, %llu differ%s\n", (unsigned long long)sum.jobs,
           (unsigned long long)sum.failures, good ? "" : "; a process died");
    return good && sum.failures == 0 ? 0 : 1;
}
