/* order_complete.c: see order_complete.h.
 *
 * The elimination of the checker is repeated, always with the variable that makes the fewest rows.
 * Most remaining rows are rows of the image; each other one is a combination of these, found by a
 * linear program.
 */
#include "solve/project/order_complete.h"

#include "lp/oracle/oracle.h"
#include "num/rationals.h"
#include "proof/by_elimination.h"
#include "system/system_private.h"

/* The work of a linear program. */
#define WORK_OF_PROGRAM ((uint64_t)1 << 14)

typedef struct order_proof {
    fmb_query *q;
    const int *place;
    const fmb_system *image;
    size_t first; /* claim of this proof; those before it are of the image's rows */
    fmb_elimination of;
    bool *gone;          /* [dim] eliminated, or kept */
    size_t *variable;    /* [k] kept variables, by column of the image */
    fmb_program program; /* the image */
    fmb_oracle *oracle;
    bool done;
} order_proof;

/* ---- the order ------------------------------------------------------------------------------- */

/* An upper bound of the rows after eliminating that variable; 0 if an equality names it, which is
 * substituted. SIZE_MAX: no row names it. */
static size_t count_rows_made(const order_proof *w, size_t v)
{
    size_t positive = 0, negative = 0, equalities = 0;
    for (size_t i = 0; i < w->of.rows; i++) {
        int sign = mpz_sgn(w->of.row[i].z.z[v]);
        bool equality = w->of.row[i].rel == FMB_EQ;
        equalities += equality && sign != 0;
        positive += !equality && sign > 0;
        negative += !equality && sign < 0;
    }
    if (equalities + positive + negative == 0)
        return SIZE_MAX;
    return equalities > 0 ? 0 : w->of.rows + positive * negative - positive - negative;
}

/* The variable to eliminate next, or SIZE_MAX. */
static size_t choose_variable(const order_proof *w)
{
    size_t best = SIZE_MAX, least = SIZE_MAX;
    for (size_t v = 0; v < w->of.dim && least > 0; v++) {
        size_t made = w->gone[v] ? SIZE_MAX : count_rows_made(w, v);
        if (made < least) {
            least = made;
            best = v;
        }
    }
    return best;
}

/* Eliminate all variables and list their order in the claim, which needs at least one step. */
static fmb_status eliminate_all(order_proof *w, fmb_claim *claim, bool *done)
{
    fmb_status st = FMB_OK;
    size_t steps = 0, v;
    mpq_t number;
    mpq_init(number);
    *done = true;
    while (st == FMB_OK && *done && (v = choose_variable(w)) != SIZE_MAX) {
        w->gone[v] = true;
        mpq_set_ui(number, ++steps, 1);
        st = fmb_elimination_go_on(&w->of, v, done);
        FMB_THEN(st, fmb_evidence_push(w->q->claims, &claim->point, v, number));
    }
    for (v = 0; v < w->of.dim && steps == 0 && w->gone[v];)
        v++;
    if (st == FMB_OK && steps == 0 && v < w->of.dim) {
        mpq_set_ui(number, ++steps, 1);
        st = fmb_evidence_push(w->q->claims, &claim->point, v, number);
    }
    mpq_clear(number);
    *done = *done && steps > 0;
    return st;
}

/* ---- rows beside those of the image ---------------------------------------------------------- */

static fmb_status open_program_of_image(order_proof *w)
{
    bool feasible;
    for (size_t i = 0; i < w->image->rows; i++) {
        const fmb_sysrow *r = fmb_system_row(w->image, i);
        FMB_TRY(fmb_program_add(&w->program, r->nnz, r->var, NULL, &r->val, r->rel));
    }
    FMB_TRY(fmb_oracle_new(&w->q->run, &w->program, &w->oracle));
    return fmb_oracle_feasible(w->oracle, &feasible);
}

/* Append weight times row number `row` of the image, as a multiple of its claim. */
static fmb_status push_multiple_of_claim(order_proof *w, size_t row, mpq_srcptr weight,
                                         fmb_sparse_vector *to)
{
    fmb_evidence *e = w->q->claims;
    const fmb_sysrow *r = fmb_system_row(w->image, row);
    size_t of = w->first - w->image->rows + row;
    mpq_t t;
    mpq_init(t);
    fmb_vec_get_q(&r->val, 0, t);
    mpq_div(t, t, fmb_sparse_find(&e->claim[of].terms, w->variable[r->var[0]]));
    mpq_mul(t, t, weight);
    fmb_status st = fmb_evidence_push(e, to, of, t);
    mpq_clear(t);
    return st;
}

/* The place in sum of the row with the least number >= from, or SIZE_MAX. */
static size_t find_next_row(const fmb_weights *sum, size_t from)
{
    size_t next = SIZE_MAX;
    for (size_t i = 0; i < sum->size; i++)
        if (sum->index[i] >= from && (next == SIZE_MAX || sum->index[i] < sum->index[next]))
            next = i;
    return next;
}

/* Claim a.x <= b, given as z[k + 1], with the rows of the image that combine to it. */
static fmb_status claim_sum_of_rows(order_proof *w, const fmb_integers *z, bool strict,
                                    const fmb_weights *sum)
{
    fmb_evidence *e = w->q->claims;
    size_t k = (size_t)fmb_system_dim(w->image);
    fmb_claim *claim;
    mpq_t t;
    fmb_status st = fmb_evidence_claim(e, FMB_CLAIM_FOLLOWS, &claim);
    if (st != FMB_OK)
        return st;
    mpq_init(t);
    claim->rel = strict ? FMB_LT : FMB_LE;
    mpq_set_z(claim->value, z->z[k]);
    for (size_t j = 0; st == FMB_OK && j < k; j++) {
        mpq_set_z(t, z->z[j]);
        st = fmb_evidence_push(e, &claim->terms, w->variable[j], t);
    }
    size_t i = find_next_row(sum, 0);
    for (; st == FMB_OK && i != SIZE_MAX; i = find_next_row(sum, sum->index[i] + 1))
        st = push_multiple_of_claim(w, sum->index[i], sum->value[i], &claim->multipliers);
    mpq_clear(t);
    return fmb_query_finish_claim(w->q, st);
}

/* A callback of type fmb_unsaid. */
static fmb_status claim_unsaid_row(void *self, const fmb_integers *z, bool strict)
{
    order_proof *w = self;
    fmb_weights form = {0}, sum = {0};
    fmb_mem *mem = w->q->run.mem;
    fmb_oracle_end end = FMB_ORACLE_UNBOUNDED;
    bool attained = true;
    mpq_t t;
    w->of.work += WORK_OF_PROGRAM;
    w->done = w->done && w->of.work <= w->of.most;
    if (!w->done)
        return FMB_OK;
    mpq_init(t);
    fmb_status st = w->oracle ? FMB_OK : open_program_of_image(w);
    for (size_t j = 0; st == FMB_OK && j + 2 < z->size; j++) {
        mpq_set_z(t, z->z[j]);
        if (mpz_sgn(z->z[j]) != 0)
            st = fmb_weights_add(&form, (uint32_t)j, t, mem);
    }
    FMB_THEN(st, fmb_oracle_maximize(w->oracle, &form, &end, &attained));
    if (st == FMB_OK && end == FMB_ORACLE_OPTIMUM)
        st = fmb_oracle_multipliers(w->oracle, &sum);
    w->done = st == FMB_OK && end == FMB_ORACLE_OPTIMUM;
    if (w->done)
        st = claim_sum_of_rows(w, z, strict, &sum);
    mpq_clear(t);
    fmb_weights_clear(&form, mem);
    fmb_weights_clear(&sum, mem);
    return st;
}

/* ---- the proof ------------------------------------------------------------------------------- */

static fmb_status open_order_proof(order_proof *w, uint64_t work, const fmb_poll *poll)
{
    fmb_mem *mem = w->q->run.mem;
    size_t dim = (size_t)fmb_system_dim(w->q->s), k = (size_t)fmb_system_dim(w->image);
    fmb_program_init(&w->program, mem, (int)k);
    w->gone = fmb_mem_zero(mem, dim, sizeof *w->gone);
    w->variable = fmb_mem_get(mem, k, sizeof *w->variable);
    FMB_TRY(fmb_elimination_open(&w->of, w->q->s, work, mem, poll));
    if (!w->gone || !w->variable)
        FMB_TRY(fmb_mem_status(mem));
    for (size_t j = 0; j < dim; j++)
        if (w->place[j] >= 0) {
            w->gone[j] = true;
            w->variable[w->place[j]] = j;
        }
    return FMB_OK;
}

static void close_order_proof(order_proof *w)
{
    fmb_mem *mem = w->q->run.mem;
    fmb_elimination_close(&w->of);
    fmb_oracle_free(w->oracle);
    fmb_program_clear(&w->program);
    fmb_mem_put(mem, w->gone, (size_t)fmb_system_dim(w->q->s), sizeof *w->gone);
    fmb_mem_put(mem, w->variable, (size_t)fmb_system_dim(w->image), sizeof *w->variable);
}

fmb_status fmb_query_claim_whole(fmb_query *q, const int *place, fmb_claim **out)
{
    mpq_t one;
    fmb_status st = fmb_evidence_claim(q->claims, FMB_CLAIM_WHOLE, out);
    if (st != FMB_OK)
        return st;
    mpq_init(one);
    mpq_set_ui(one, 1, 1);
    for (int j = 0; st == FMB_OK && j < q->claims->dim; j++)
        if (place[j] >= 0)
            st = fmb_evidence_push(q->claims, &(*out)->terms, (size_t)j, one);
    mpq_clear(one);
    return fmb_query_finish_claim(q, st);
}

static fmb_status claim_order(order_proof *w)
{
    fmb_evidence *e = w->q->claims;
    fmb_claim *claim;
    const char *why;
    const fmb_unsaid unsaid = {claim_unsaid_row, w};
    fmb_status st = fmb_query_claim_whole(w->q, w->place, &claim);
    FMB_THEN(st, fmb_query_finish_claim(w->q, eliminate_all(w, claim, &w->done)));
    if (st != FMB_OK || !w->done)
        return st;
    st = fmb_by_elimination_match(&w->of, e, &e->claim[w->first], &unsaid, &why);
    w->done = w->done && st == FMB_OK && !why;
    return st;
}

fmb_status fmb_query_order_complete(fmb_query *q, const int *place, const fmb_system *image,
                                    uint64_t work, bool *done)
{
    order_proof w = {.q = q, .place = place, .image = image, .first = q->claims->claims};
    const fmb_poll poll = fmb_run_asked(&q->run);
    fmb_status st = open_order_proof(&w, work, &poll);
    FMB_THEN(st, claim_order(&w));
    close_order_proof(&w);

    *done = st == FMB_OK && w.done;
    while (!*done && q->claims->claims > w.first)
        fmb_evidence_drop_last(q->claims);
    return st;
}
