/* selection.c: which way of a projection is tried, and for how long; see selection.h. */
#include "solve/portfolio/selection.h"

#include <math.h>
#include <string.h>

#ifdef FMB_ABLATE
int fmb_selection_forced = -1;
#endif

/* ---- pipelines ------------------------------------------------------------------------------- */

/* Identifier, name in data and reports, trials of bounded elimination, and units of work of rays,
 * of pruned elimination, and of queries, in this order. */
#define PIPELINES(P)                                                                               \
    P(QUERIES, "queries", 0, 0, 0, 64)                                                             \
    P(MORE_RAYS, "more rays", 0, 8, 0, 64)                                                         \
    P(MORE_PRUNED, "more pruned elimination", 0, 0, 8, 64)                                         \
    P(BOUNDED_MORE_RAYS, "bounded elimination, more rays", 2, 8, 0, 64)                            \
    P(BOUNDED_PRUNED, "bounded and pruned elimination", 2, 0, 1, 64)                               \
    P(BOUNDED_MORE_PRUNED, "bounded and more pruned elimination", 2, 0, 8, 64)

#define PIPELINE_IDENTIFIER(id, ...) PIPELINE_##id,
enum { PIPELINES(PIPELINE_IDENTIFIER) PIPELINE_COUNT };
#undef PIPELINE_IDENTIFIER
_Static_assert(PIPELINE_COUNT <= FMB_MOST_PIPELINES, "scores have room");

static const struct named_pipeline {
    const char *name;
    unsigned bounded, rays, pruned, queries;
} PIPELINE[] = {
#define PIPELINE_STEPS(id, ...) [PIPELINE_##id] = {__VA_ARGS__},
    PIPELINES(PIPELINE_STEPS)
#undef PIPELINE_STEPS
};

const char *fmb_selection_name(int pipeline)
{
    return pipeline < PIPELINE_COUNT ? PIPELINE[pipeline].name : NULL;
}

/* A bound, or a row that names few variables, holds up most directions. */
static bool tries_recession(const fmb_features *f)
{
    return fmb_features_are_dense(f) && f->bounds == 0;
}

/* About as many steps as 128 rays take, and four for each row: entries of a row, and the bits of
 * its numbers, tell what one does; long ones are divided by what they have in common. */
static uint64_t unit_of_work(const fmb_features *f)
{
    uint64_t bits = f->minor_bits;
    return 16 * (uint64_t)f->entries * (f->is_long ? 128 + 16 * bits : 64 + bits);
}

static void add_step_if(bool suits, fmb_pipeline *p, int *steps, fmb_step_kind kind,
                        uint64_t budget)
{
    if (suits)
        p->step[(*steps)++] = (fmb_pipeline_step){kind, budget};
}

static fmb_pipeline pipeline_of_name(const fmb_features *f, const struct named_pipeline *named)
{
    fmb_pipeline p = {.step = {{FMB_STEP_NONE, 0}}};
    int n = 0;
    uint64_t unit = unit_of_work(f);
    add_step_if(tries_recession(f), &p, &n, FMB_STEP_RECESSION, 0);
    add_step_if(named->bounded > 0, &p, &n, FMB_STEP_BOUNDED, named->bounded);
    add_step_if(named->rays > 0, &p, &n, FMB_STEP_RAYS, named->rays * unit);
    add_step_if(named->pruned > 0, &p, &n, FMB_STEP_PRUNED, named->pruned * unit);
    add_step_if(named->queries > 0, &p, &n, FMB_STEP_QUERIES, named->queries * unit);
    return p;
}

/* ---- the table ------------------------------------------------------------------------------- */

/* Marks are rough logarithms of features, in so many parts of one. */
#define MARKS 256

/* A tree asks whether marks are above thresholds. Its answers, the first one as the highest bit,
 * are the number of a leaf: a letter for each pipeline, NEUTRAL and more if it speaks against it.
 */
enum { QUESTIONS = 6, LEAVES = 1 << QUESTIONS, NEUTRAL = 'm' };
typedef struct tree {
    struct {
        unsigned char feature;
        short above;
    } question[QUESTIONS];
    char leaf[LEAVES * PIPELINE_COUNT + 1];
} tree;

/* clang-format off */
/* Made by `ninja fit-selection`; do not edit from here. */
/* 5853 problems of 48 families, seeds 1 to 110051, ways as of commit b4a70387.
 * Time over that of the best method alone: 1.075 on families seen, 1.222 on others. */
static const int START[PIPELINE_COUNT] = {23, 23, 30, 18, 25, 28};
static const tree TREE[] = {
    {{{10, 1184}, {4, 320}, {11, 1432}, {7, 17}, {2, 832}, {0, 512}},
     "riijkjpjkkkknlllmlmkklkkmmmmmmrhmmmlmmmmmmmmmmmmolklkkriljmlmmmmmmllkmkkmmmmmmonlmllmmmmmmmmm"
     "mmmphlimloljmlkktjslknmlmnmpjhhgfumhjhgltimihrlnmqnimknlkmjjklkivnsmmmomommjriskjrsgpihkvmtmm"
     "nskqlkllmlmmoninjjljlkllmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmllnlmmnm]aabaafghghhmmmmmmmmmmmmmmm"
     "mmmmmmmmmmhwiuwpkllmmoiqkrrqiskssjmjmjjrokkkjmplkkkntouoohksmrsohoipogqrrosmkplophspupqookokk"
     "jvnsnnnqjokj"},
    {{{10, 1288}, {4, 320}, {11, 1376}, {7, 17}, {3, 1056}, {0, 384}},
     "pjjkkkqjjkkjmmmmmmmmmmmmmmmmmmpimmnmmmmmmmmmmmmmnllmmlrijjkjmmmmmmjkkkjkmmmmmmoollllmmmmmmmmm"
     "mmmnimjnmrjjklkjqmqmnmnjolkoiijiisjiiihlnjjihpnjlkijnnnoomjikkijsruprjrkpkkjpjpkjoohoihjupuqp"
     "mtkrllklllllnkllmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmkjnknnliijjjbfeffeddeeeemmmmmmmmmmmmmmm"
     "mmmmmmmmmliqjqrpirjrrjktmrtqhrissllkllkmkllmmlnknllnqmqlmjmqnqrmipjppgqrqqrkjqkoqmnnnnnllmlmm"
     "ktrsrrkrlqkl"},
    {{{5, 499}, {11, 1200}, {4, 384}, {10, 1604}, {2, 800}, {11, 1883}},
     "qjkkkkmmmmmmpknkoommmmmmmmmmmmmmmmmmmmmmmmmmmmmmnkjjiimmmmmmpsirmimmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmqnkmkkopinjinqkkjjmokolkmmmmmmmmmmmmmmmmmmmmmmmmmmjmkjmqkqlllvkmjilsmtonmmmmmmmmmmmmmmmmmm"
     "mmmnnnojmknnmmmmmmqhmkonmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmoiojoommmmmmnllnnlmmmmmmokqlrqmmmmmmqkp"
     "lppmmmmmmqjkklkmlnlnnmilklmkkklkkmmmmmmmmmmmm^edfdemnnonnnjokopklomoohprqkrkoppnqklrmpsknpopq"
     "qkrlrsmjpjpp"},
    {{{7, 28}, {10, 832}, {6, 56}, {0, 384}, {11, 1883}, {5, 823}},
     "mnllllmmmmmmmnlnllmmmmmmlnljkkmmmmmmmpkplkmmmmmmoljkjjmmmmmmlnknlkmmmmmmqjmknmmmmmmmmmlmllmmm"
     "mmmkrmqmmmmmmmmkppqppmmmmmmjqmrlmmmmmmmlolqmlmmmmmmllpmoqfijjijjoqpqqjkmklmojokoogikjjkmjnjnn"
     "nkmkmmmmmmmmmmmmmmnmmmmmmmmmmmopkollmmmmmmooknlkmmmmmmmkkkkjmmmmmmllkllkmmmmmmpllkkjmmmmmmnnj"
     "kjimmmmmmmrkjjjmmmmmmlqnroommmmmmnrjljimmmmmmmqksmkmmmmmmlmklkjmmmmmmksotppmmmmmmnojnkkmmmmmm"
     "mqkqlkmmmmmm"},
    {{{10, 1368}, {5, 823}, {3, 1056}, {11, 1883}, {8, 68}, {7, 13}},
     "okllmkokklkkoklkllnlkklkmllmmlnpkolkjlnmoommklkklmmmmmqmlnolknmnlmmpkljjmlmlmmnnkmkkkonomnlqn"
     "rnnnnmmmmmmmmmmmmmmmmmmmmmmjifhffmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmnkpkppllmlmmmmmmmmmmmmmmklolnollmlnnmmmmmmmmmmmmklqmoqlnlnllpkpkqpjpqolqklmmlmlmnnnnmlq"
     "lqqlqprppmkpkppmmmmmmmmmmmmmmmmmmlkmlmnmmmmmmmmmmmmmmmmmmchghfgmmmmmmmmmmmmmmmmmmnnonoommmmmm"
     "mmmmmmmmmmmm"},
    {{{7, 44}, {5, 384}, {9, 0}, {10, 1288}, {3, 1248}, {0, 576}},
     "mnlomlmmmmmmlpnpoommmmmmmmmmmmmmmmmmlplomkmmmmmmlnkmkkrqjmjjkqmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmnljlkkqolpmlmmlmklmmmmmmlknlnooqiqkijonolnmmmmmmmmpmpppiqksqjrmrlmkllmklnkqkqrmmmmmmnkokpo"
     "nlpmopmkllllnmmmmmmoklkkmmmmmmmmmmmmmmmmmmnokmkkmmmmmmmlkkkknmlmlllmlklknoklllmmmmmmmmmmmmmnm"
     "nmmmmmmmmmpkplkrpkplkmmmmmmmmmmmmnmmlnmmmmmmmllllllmmmmmmnmmmmmolklkkmlmmmmpqkqlkmmmmmmpolnlk"
     "mmmmmmqpiqnj"},
    {{{10, 1040}, {4, 320}, {6, 81}, {0, 512}, {11, 1644}, {5, 525}},
     "mmmmmmmmmmmmmmmmmmmmmmmmmlopookllmllnnmmmmmmmmmmmlllklokklkkmmmmmmnmlmllolkljjolmlmmnmmmmmnmm"
     "mmmmpkkjjmmmmmmlomnmmmmmmmmoolmllmjnknonnklkkmmmmmmmkllllomkmkkknlnmlmmjnjjpllkllnlmlmmpnmnll"
     "nkplpommmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmknknnmmmmmmfgghhgmmmmmmpokolkmmm"
     "mmmlkmkmmlpkmkklmlmlmkqoroolnlokmnqjrmkokplppnnkolklmknjkmknknnlmomookoqoqqlmnmnnmolollpmllml"
     "mlmllmoknknn"},
    {{{5, 823}, {10, 1604}, {6, 243}, {5, 640}, {7, 17}, {9, 128}},
     "mmmmmmmllmllnnlmllmmnooomlolnnlmnmonlniojilnnnnnmljljjmmmmmmmmnmonmmmmmmnmmmmnllnlonmmmmmmmmm"
     "mmmnkpkpppjqjrqkmonnommmmmmmjmjlmnlmlmmmojokjmmmmmmlonoonnlmlnmmmmmmmmmmmmmkqoqmonlnlnnmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmoolnmlmlmlnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnmnlmnmlmlmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmggfgffmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmminmolmmmmmmm"
     "mmmmmmmmmmmm"},
    {{{5, 823}, {1, 1104}, {0, 576}, {3, 1104}, {1, 960}, {9, 85}},
     "mlmmmmmlmlmmpjokoonnmklllnnnmnnmpmqplololllnoooopqjrkkpnlkkkqolnmlmmmmnnppklkkpplpmlommnnmoll"
     "molmmmmmmmmmmmmnlmlmmmmmmmmmmmmmmmmmmmmmommllnjlkmlmmmmmmmmmmmmmmmmmmnlmmmmmmmmmmmmmmmmmmmmmm"
     "mlolnohgfgffmlnlonopopoommmmmmnqoqmommmmmmlononnmmmmmmnnmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmeeeefemmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmm"},
    {{{5, 823}, {10, 1604}, {3, 960}, {11, 1883}, {0, 384}, {9, 14}},
     "nlnlonmkllmlonjmljnkmlmmlmkmlkkmmmmmomkmlkllmkmmlnnnmnknlmkkmmllllnmmmmmloopookppqppmllmlllnn"
     "nmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlnnnnnoknkonmkoknorkolpolpnponmknkonmlllkl"
     "mlmlmmmmmmmmmmmmmmnmlmmlmmmmmmllllllmmmmmmkjijihmmmmmmmmpmpplllllllkkkkknmomoonnonoolmmmmmmmm"
     "mlmnnonoommmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmifegfemmmmmmhjijiimmmmmmmmmmmmmmmmmm"
     "nmnmnnmmmmmm"},
    {{{0, 384}, {11, 1344}, {3, 896}, {7, 37}, {9, 75}, {13, 0}},
     "mmmmlmnmllllnmmmmmnmlmllmmmmmmmmmmmmmlnnnnmmmmmmknknkkmlnkonlloloolmknmlllmlllmlllmlmmmlllmmm"
     "mmmmmmmmllmjmjjmmmmmmmmmmmnmlmlmmlmllllmlllmlmmnmmmmpopoolpopnolnonoolmompokllmmmlpnpoolomonm"
     "lnmmmlmmnmoonllmllmmllllmmmmmmllomppnlmmmmmllmllmlnnnmllnmnnmlmmmmpkoloomlmmnmlknkmnmmlmllook"
     "kjjnmknlkmmmmmmnmimjjomlmmmnmlmmlmlmlmmpnmmmmmlmkmmmmmlmmklpmnpmllmllmlnlnnmmonoomklllkooknkk"
     "mololljmomoo"},
    {{{4, 320}, {2, 1088}, {0, 640}, {9, 222}, {6, 237}, {10, 1464}},
     "omlmmlkkkkkkkkhkiimpppppnlijjjmmmmmmmlmlmmmmmmmmnmmnmmmmmmmmnomommmmmmmmlmnnnnmmmmmmmmmmmmmmm"
     "mmmmmmmmmmpppppmmmmmmhgggggmmmmmmmmmmmmmmmmmmmmmmmmklkllkmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmlnmnnnmmmnmmmmmmmlolommmmlllmjlmlmmnnonoorrkplkmmkmlkmmmmmmmmmmmmokqkrpmmmmmmmmm"
     "mmmmmmmmmlonmnnmmllmlmmmmmmmpnpnnmmmmmmmmmlnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmipppkpmmmmmm"
     "mmmmmmmmmmmm"},
    {{{3, 1344}, {5, 334}, {11, 2304}, {1, 1150}, {11, 1814}, {8, 90}},
     "lkmmlmmmmllllimimmmmkmllmmmmmmmmmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmnlmlmmmnmmmmmmmmmmlnnnnnknmnmmnkllmligggggmmkmklmmmmmmmmmmmmmlkllkmllmklmmmmmmmmmmmmnmnnnn"
     "nmlmllmmmmmmnnlikkmmmmmmmnmnmmmmmmmmmolgjimmmmmmmookmmmmmmmmmmmmmmmmmmmmnnkollmmmmmmmmmmmmmmm"
     "mmmmllommlqlqnmkoopoomolomlmmmmmmjnmnjllmomnoorqrpqlnqpormmmmmmmmmmmmklnllnnlmmnnmmmmmmmmmmmm"
     "mmmmmmmkllml"},
    {{{6, 67}, {1, 1150}, {11, 1344}, {0, 576}, {5, 346}, {11, 2223}},
     "mmmlmlmmmmmmlqkokkmmmmmmnplpmmmmmmmmnnjnkkmmmmmmmnllllnmkolllompnmmnmnmmonmmmmmmmmmmnmnnnoolk"
     "lnkmmmmmmmmmmmmnlllmlmmmmmmmmmmmmmmmmmmmkokoommmmmmmonillmllnnmlnponpnlllmlmmmmmmmmmmmmlllmll"
     "lnlnlllllmllmmmmmmmlmmnmmmmmmmmmmmmmmmmmmmmmnlmmmmmmmmljljllmmmmmmlmmmnnmlmllmmmmmmmmmmmmmopk"
     "qlknmmmlmmmmmmmmmmmmmnlllmlmmmmmmmmmmmmmmmmmmommmmmmmmmmmmmmmmmmmmmmmijijiiommmmmmmmmmmmmmmmm"
     "mmlmllmmlmll"},
    {{{0, 384}, {10, 1040}, {4, 288}, {7, 0}, {2, 864}, {3, 1288}},
     "nmlmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmjmjjmmmmmmnnlmllnnllllmmmmllmnmlmmmmmnmmmmm"
     "mmmmmmmmmmmmmmmnnonpolkkklkmmmmmmmmmmmmmmmmmmmmmmmmllnlmnmpnponnrqroqmlmlmmlomonmmonnnnmnmnnm"
     "nmnmnnnmlmllmmmmmmllllllmmmmmmlmomoommmmmmmmmmmmmmmmmmmmjmkjmmmmmmmmmmmmmmmmmmnmmmmmmmmklmmmn"
     "nnnlnlmlloonommmmmmmmgfffggmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnmnlmnllklkkmlmmmmnmmmmmlmlmllkmmnmm"
     "lkkmkkmnlmll"},
    {{{2, 768}, {10, 1764}, {5, 678}, {4, 288}, {0, 384}, {4, 599}},
     "mmmmmmmmmmmmmmnlnnmmmmmmmmmmmmmlnmonmmlmmlljnkmmmmmmmmmmmmmmmmmmmmmmmmmmlmmmmmmmmmmmmmnmnnmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnnnmnmnlnlnnllmllmmmmmmmmmmmmmmmmmmmmmmmmmihfigfmmnmonnlnlnn"
     "nmmmlmnmmmmmmmmmmmnlmmmmmmmmmmmnnomnmmmlllmmmmmmnolmlloononnmmmmmmlkijiimmmmmmkmkmjkmmmmmmmnm"
     "nmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnlmlnmmnmnmmllllmlmmmmmmlklkllmmmmmmotqtqqmnmnkm"
     "lpnpmnmmmmmm"},
    {{{10, 704}, {9, 0}, {6, 86}, {0, 576}, {12, 0}, {7, 28}},
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnnmlmmmmmmmmnmmlmmmmmmmmmmmmmmmmmmmmmmmnmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmlllmmmmmmnnmkllmmmmmmllnpnnmmmmmmmmmlmmnmlmllmmmmllmmmmmmmkljklmmmmmmnmkljkmmmmmm"
     "mmmmmmlnmommmmlkllmmlmmlnnlomlmmmmmmnnnponmmmmnmnmmnlmmmmmmmllllllnmlmllmomommnqjqkjnmmnmmmmm"
     "mmmnmmmmmmnmmmmmnmlllmlmmmmlmnooolnnnlnnmmmnmonlmllnmmmllokokoomlnmnnllnlonlmmnlmmmmnmmnomllm"
     "mmmmmmlnnnmn"},
    {{{10, 832}, {0, 640}, {11, 1024}, {9, 105}, {4, 435}, {5, 537}},
     "llomppmmmmmmmmmmllmmmmmmnmklkkmmmmmmllnonnmmmmmmomlmmlmmmmmlmmllllmmmmmmnollklnllmmmmlnmmnmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmlmnnoommmmmmmmmmmmmmmmmmonlnllmmmmmmmmmmmmmmmmmmnnlmlllmlmllmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmnnnlkmlkmmmnmmmmmmmmmlllllmlmlmmnkllllmmmmmmmnmnmmmmmmmmlolpmmlmnmnnkmp"
     "oopoknkommmmmmmmmmmmmmmmmmmmmmmmmmmmmnmmljmjkmmmmmmmmmmmmnmmnnmnolomloomlmmonlnllmmlmlmnmlmll"
     "onloolmmmmmm"},
    {{{5, 334}, {3, 1584}, {11, 1970}, {9, 59}, {2, 704}, {3, 1120}},
     "mkmklllknllmmmmmmmmnmilkmlmmmmmmmmmmmmmnmmmmmmmmmmmmmmlkmkmmmmmmmmmmlmmmnnmmmmmmmmmmnmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmomjllmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmllnmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmlnmnnmkmkmmmmlmlllonomnmmlmlmmlmlmmnmnlmmmmlmmmmmlnllmmmmnmmmnmmnmmkmllmpoooollmlmmmmm"
     "mmlmmnmnnmmmmmmlomommmmmmmmlmonopmmmmmmmmmmmmmmmmmmjqnpkmmmmmmmmnlnmlmmmmmmmlnlnnmmmmmmmmmmmm"
     "mmmmmmmmmmmm"},
    {{{0, 704}, {8, 51}, {1, 1150}, {4, 320}, {10, 1368}, {7, 17}},
     "mnlmlkmmmmnnooqoqqmmmmmmmmlmmlmmmmmmmmnmmnmnknkjmmmmmmmmmmmmkhgghgmmmmmmmmmmmmmmmmmmmpppopmmm"
     "mmmnmlmmmlmmnlmmmmmmmmmmmmmlmmmmmlmmmmmmmnmnnmmnmnnlmlmllmmmmmmmmmmmmmmmmmmnmnmnnllnlnnnmlmll"
     "mmmlmmmmlmmmmnmlmmmmmmmmmmmmmmmmmmmmpnmoolmmmmmmmmmmmmmmllllmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnlqlrpmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmlnonnp"},
    {{{2, 1024}, {3, 1328}, {6, 237}, {4, 320}, {4, 559}, {9, 0}},
     "onmmmmlllmllmmmmmmmmmmmmmmlmllmmmmmnmlnmnnmlmlmmlnmommmlllllmmmmmmmmmmmmmmnmmmmnnnnnoklknlomk"
     "mlkmmmmmmmmmmmmmmmmmmmmmmmmnmlmmlmmnmnnmmmmmmmmmmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlomolm"
     "mlmlmmnpppqpmmmmmmmmmmmmmmmmmmmljkjjklmmlmmmmmmmmmmmmmigggggmmmmmmmmmmmmmmmmmmlononnmmmmmmmmm"
     "mmmmmmmmmmmmmmmlllmllmmmmmmmmmmmmlnoonoknmnlmnlmkllmnmmmlopppppmmmmmmmmmmmmmmmmmmmlklkkmmmmmm"
     "mmmmmmmmmmmm"},
    {{{2, 1088}, {6, 56}, {0, 384}, {2, 896}, {5, 823}, {1, 864}},
     "mmmmmmmnmmnmmmmmmmmmmmmmmmmmmmmmmmnmmmmmmmmmmmmmpplollmnlnllmmmmmmmmmmmmmmmmmmmmlnmlmmmmmmmmm"
     "mmmlmmmmmnmmmlmigfggfllllllmmmmmmmonnlnmmmmmmopqqqqmmmmmmnmnmmmpopnppllllllmmmmmmmlmlmmmmmmmm"
     "kjijiimmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmnmmnmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlpnpnn"
     "mmmmmmmppppp"},
    {{{5, 334}, {7, 64}, {11, 1814}, {5, 426}, {3, 896}, {9, 113}},
     "mmmmmmmmmmmmmnljkkmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnmlnmlmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmllmlmmnnnnmlnmmmmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmlmmmmmmmmmkmkmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmonppmmmmnnmmlmmmmlmnmlnmmmmmnmmmmmmmnmmnmmmmmlnmmmmmmmmmmmmnmonmnnomonlmkmkkmnmnmnmmn"
     "mnnlmmmmmmmmmmmlmnnmmmmllllkjonnonnmmmmnmlllloolnlloplnmlmnmmmmmmmmmmnolnlkkmnnnmnmmmmmmmmmmm"
     "lomommllmllm"},
    {{{3, 1584}, {2, 768}, {9, 113}, {10, 1184}, {4, 448}, {11, 2109}},
     "nmlmllnlllllmmlmmlmmnnmnmmnmonmlmlmmmlmlnmmlllllmmnmnnmnmmlllknnnnlpopoommmmnnlnmnnnolllmmmmm"
     "mnnmmmnmmmmlmmlmmnmmnnmmnnnlmmmlmnmmmmmmpkokkmnlnllmnkmllmlnlmmklmnnmllolmoolmlnmlmkmkknlllml"
     "nknknnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlolomlmnlnmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmnommnmlmnnmmmmmmmmmmmmmmmmkllmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "kooolommmmmm"},
};
/* To here. */
/* clang-format on */

/* log2(1 + x), by a straight line between powers of two: the same on every machine. */
static double rough_logarithm(double x)
{
    int exponent;
    double mantissa = frexp(1 + x, &exponent);
    return exponent - 2 + 2 * mantissa;
}

static size_t find_leaf(const tree *t, const int *mark)
{
    size_t leaf = 0;
    for (int k = 0; k < QUESTIONS; k++)
        leaf = 2 * leaf + (mark[t->question[k].feature] > t->question[k].above);
    return leaf;
}

void fmb_selection_score(const fmb_features *f, int *score)
{
    int mark[FMB_FEATURE_COUNT];
    for (int k = 0; k < FMB_FEATURE_COUNT; k++)
        mark[k] = (int)(MARKS * rough_logarithm(fmb_features_value(f, (fmb_feature_id)k)));
    memcpy(score, START, sizeof START);
    for (size_t t = 0; t < sizeof TREE / sizeof *TREE; t++) {
        const char *leaf = &TREE[t].leaf[find_leaf(&TREE[t], mark) * PIPELINE_COUNT];
        for (int k = 0; k < PIPELINE_COUNT; k++)
            score[k] += leaf[k] - NEUTRAL;
    }
}

int fmb_selection_best(const fmb_features *f)
{
    int score[FMB_MOST_PIPELINES], best = 0;
    fmb_selection_score(f, score);
    for (int k = 1; k < PIPELINE_COUNT; k++)
        if (score[k] < score[best])
            best = k;
    return best;
}

fmb_pipeline fmb_selection_pipeline(const fmb_features *f)
{
    int pipeline = fmb_selection_best(f);
#ifdef FMB_ABLATE
    if (fmb_selection_forced >= 0)
        pipeline = fmb_selection_forced;
#endif
    return pipeline_of_name(f, &PIPELINE[pipeline]);
}

/* ---- bounded elimination --------------------------------------------------------------------- */

/* In so many dimensions a hull takes longer than to find out which of many rows are irredundant. */
#define SHORT_QUERIES 4

/* To find out which of many rows are irredundant takes as long as some queries, where few variables
 * are kept; of long numbers, so it does of fewer rows. */
bool fmb_selection_keeps_rows(const fmb_elim *e, size_t before, int kept)
{
    size_t most = fmb_elim_minor_bits(e) > FMB_LONG_MINOR ? before : before * (size_t)kept;
    return kept >= SHORT_QUERIES || e->live.size <= most;
}
