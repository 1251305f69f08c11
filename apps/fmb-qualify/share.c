/* share.c: see share.h. */
#include "fmb-qualify/share.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "common/ranks.h"
#include "fmb-qualify/watch.h"

int qualify_join_ranks(void)
{
    enum { MOST_COUNTERS = 16 };
    int code = app_ranks_begin(MOST_COUNTERS);
    if (code == APP_YES && app_rank() > 0 && !freopen("/dev/null", "w", stdout))
        return app_ranks_fail(APP_CANNOT_WRITE);
    return code;
}

int qualify_leave_ranks(int code)
{
    app_ranks_end();
    return app_rank() == 0 ? code : APP_YES;
}

qualify_share qualify_share_begin(const qualify_setup *o, size_t cells)
{
    bool *mine = app_need(calloc(cells + 1, sizeof *mine));
    return (qualify_share){o->counter, cells, mine};
}

bool qualify_share_next(qualify_share *s, size_t *i)
{
    if (qualify_watch_interrupted())
        return false;
    *i = (size_t)app_ranks_take(s->counter, 1);
    if (*i >= s->cells)
        return false;
    s->mine[*i] = true;
    qualify_watch_part(*i, s->cells);
    return true;
}

void qualify_share_collect(const qualify_share *s, void *cell, size_t size)
{
    size_t n;
    bool *done = app_ranks_gather(s->mine, s->cells * sizeof *done, &n);
    char *of_rank = app_ranks_gather(cell, s->cells * size, &n);
    for (size_t k = 0; done && k < (size_t)app_ranks() * s->cells; k++)
        if (done[k])
            memcpy((char *)cell + k % s->cells * size, of_rank + k * size, size);
    free(done);
    free(of_rank);
}

bool qualify_share_end(qualify_share *s)
{
    free(s->mine);
    s->mine = NULL;
    return app_rank() == 0;
}
