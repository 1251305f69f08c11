/* vertex_bench.c: see vertex_bench.h. */
#include "vertex_bench.h"

#include <criterion/criterion.h>

void vertex_bench_open(vertex_bench *b)
{
    b->options = (fmb_options){.size = sizeof(fmb_options)};
    atomic_init(&b->cancel, 0);
    fmb_mem_init(&b->mem, NULL, 0);
    fmb_run_begin(&b->run, &b->mem, &b->options, &b->cancel, (fmb_sink){0}, "test");
    fmb_program_init(&b->p, &b->mem, 2);
}

void vertex_bench_stand(vertex_bench *b)
{
    cr_assert_eq(fmb_vertex_init(&b->v, &b->run, &b->p), FMB_OK);
}

void vertex_bench_close(vertex_bench *b)
{
    fmb_vertex_clear(&b->v);
    fmb_program_clear(&b->p);
    cr_assert_eq(b->mem.used, 0);
}
