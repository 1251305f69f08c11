/* scene.c: see scene.h. */
#include <criterion/criterion.h>

#include "scene.h"
#include "support/dense.h"
#include "support/must.h"

bool scene_open(scene *c, const fmb_system *s)
{
    c->options = (fmb_options){.size = sizeof(fmb_options)};
    atomic_init(&c->cancel, 0);
    fmb_mem_init(&c->mem, NULL, 0);
    fmb_arena_init(&c->arena, &c->mem);
    fmb_run_begin(&c->run, &c->mem, &c->options, &c->cancel, (fmb_sink){0}, "test");
    must(fmb_parts_split(&c->parts, s, &c->run, &c->arena, FMB_SPLIT_NAMED));
    c->m = 0;
    if (c->parts.count == 0)
        return false;
    cr_assert_eq(c->parts.count, 1);
    fmb_part *p = &c->parts.part[0];
    must(fmb_part_load(p, s, c->parts.place, &c->run, false));
    c->n = (size_t)p->n;
    c->m = p->m;
    c->rel = p->rel;
    c->row = fmb_arena_get(&c->arena, p->m, sizeof *c->row);
    cr_assert_not_null(c->row);
    for (size_t i = 0; i < p->m; i++)
        c->row[i] = (fmb_lp_row){&p->row[i], p->rel[i]};
    return true;
}

void scene_close(scene *c)
{
    fmb_parts_clear(&c->parts, &c->mem);
    fmb_arena_clear(&c->arena);
    cr_expect_eq(c->mem.used, 0);
}

void scene_combine(const scene *c, const uint32_t *index, mpq_t *factor, size_t size, size_t j,
                   mpq_t out)
{
    mpq_t t;
    mpq_init(t);
    mpq_set_ui(out, 0, 1);
    for (size_t k = 0; k < size; k++) {
        fmb_vec_get_q(c->row[index[k]].v, j, t);
        mpq_mul(t, t, factor[k]);
        mpq_add(out, out, t);
    }
    mpq_clear(t);
}

void scene_excess(const scene *c, size_t i, mpq_t *x, mpq_t out)
{
    mpq_t t;
    mpq_init(t);
    fmb_vec_get_q(c->row[i].v, c->n, out);
    mpq_neg(out, out);
    for (size_t j = 0; j < c->n; j++) {
        fmb_vec_get_q(c->row[i].v, j, t);
        mpq_mul(t, t, x[j]);
        mpq_add(out, out, t);
    }
    mpq_clear(t);
}

bool scene_holds(const scene *c, size_t i, mpq_t *x)
{
    mpq_t excess;
    mpq_init(excess);
    scene_excess(c, i, x, excess);
    int sign = mpq_sgn(excess);
    mpq_clear(excess);
    return c->rel[i] == FMB_EQ ? sign == 0 : c->rel[i] == FMB_LT ? sign < 0 : sign <= 0;
}
