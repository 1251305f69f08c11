/* selection.c: which engines project a part, and with which budgets; see selection.h. */
#include "solve/portfolio/selection.h"

#include <math.h>

#ifdef FMB_ABLATE
const fmb_choice *fmb_selection_forced;
#endif

/* ---- the table ------------------------------------------------------------------------------- */

/* The predictions, as base-2 logarithms in fixed point: the work of the best engine, in units; the
 * ratio of each engine's work to it; and time with bounded elimination first over time without. */
#define FORETOLD(T)                                                                                \
    T(BEST, "best")                                                                                \
    T(RAYS, "double description")                                                                  \
    T(ELIMINATION, "elimination")                                                                  \
    T(QUERIES, "support queries")                                                                  \
    T(BOUNDED, "bounded elimination")

#define FORETOLD_IDENTIFIER(id, name) FORETOLD_##id,
enum { FORETOLD(FORETOLD_IDENTIFIER) FORETOLD_COUNT };
#undef FORETOLD_IDENTIFIER

/* Units of fixed-point numbers: 1 / MARKS of marks, the rough logarithms of features; 1 / PARTS of
 * predictions; 1 / FINE of weights. */
enum { MARKS = 256, PARTS = 32, FINE = 128 };

/* A prediction is a weighted sum of marks plus corrections by trees. A tree tests whether marks are
 * above thresholds; the results, the first as the highest bit, number a leaf, which has a letter
 * for each prediction: its correction, NEUTRAL for none. */
enum { QUESTIONS = 6, LEAVES = 1 << QUESTIONS, NEUTRAL = 'm' };
typedef struct tree {
    struct {
        unsigned char feature;
        short above;
    } question[QUESTIONS];
    char leaf[LEAVES * FORETOLD_COUNT + 1];
} tree;

/* clang-format off */
/* Made by `ninja fit-selection`; do not edit from here. */
/* 19118 problems of 91 families, seeds 1 to 199029, ways as of commit c32b56bf.
 * Time over that of the best method alone: 1.120 on families seen, 1.220 on others. */
static const int START[FORETOLD_COUNT] = {-2358565, -455776, 1008402, 635990, 23796};
static const short WEIGHT[FMB_FEATURE_COUNT][FORETOLD_COUNT] = {
    {7987, -2585, -2772, 3658, -122},
    {1035, -1478, -213, 994, -139},
    {-2844, 2828, -264, 611, 102},
    {-2648, 1060, -247, 560, 1},
    {-1708, -255, -1771, -255, 140},
    {1768, 809, 604, 170, 256},
    {-5302, -6472, -1427, 753, -766},
    {-10198, 6491, -2329, 415, -1014},
    {-733, -2717, 2042, 199, -9},
    {-268, 4624, 5721, -13750, 4885},
    {3270, -1425, -1448, -663, -64},
    {-4854, -1877, 2507, -690, 437},
    {672, -79, 1653, -299, 12},
    {99, -504, 556, -113, -18},
    {-113, 569, 479, -273, 46},
    {1024, -652, 1311, -2081, -152},
    {2641, -37, 1147, -823, -18},
    {1364, -1289, 1664, -998, 108},
    {1126, 154, -128, -512, 70},
    {-389, 1404, -1743, -2, -28},
    {4821, -508, -490, 181, -136},
    {284, 205, -285, 328, 227},
};
static const tree TREE[] = {
    {{{14, 2217}, {6, 55}, {14, 1360}, {19, 992}, {0, 384}, {7, 16}},
     "mmmmmmmmmmmmmmmknmnmrtglnooilknshknoqjmlmmmmmmmmmmmmmmmilnmmooplojrmllroohmmqmklmlmpmsjlnmknl"
     "ommmnnmmkonmmkgmmjjqonjnjmmlnmommnlkmjmjmmjnlmmjrpmmgsrmmpkojmomnkmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmmmmnjnonfmrnnqglpnmjkrnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmqkommmmmmsknpmkplqmsnlomjpqmnxglnmvllnm"},
    {{{14, 2396}, {6, 55}, {5, 345}, {11, 134}, {5, 530}, {8, 99}},
     "iqmsmhplmkmmmmmmmmmmmhmkmpikmmmmmmmmmmmmmslplorpjnmmmmmxiolmrthmnlvfjnmprhmslokmojolmnokmlmmm"
     "mmmmmmmohojnnknlnmmmmmmmmmmlnlnmnnmlmnmmlmokommpmnlnlmkmmgonnlhhnrmmmmmmfelqnmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmrljpmqjlpmmmmmmmmmmmxjiomwmmllmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mkmmomslmmmjmipmrllmmollmmmmmmmmmmmmmmmmm"},
    {{{14, 2307}, {6, 68}, {14, 1248}, {5, 530}, {19, 1024}, {0, 384}},
     "nmmmmlnmolpphllnrilmmmmmmkkmnmmmmmmhijmnmmmmmhnmnmjqolnmqmkmmmmmmliqonrmolmskrkmrklnmnlmmmojk"
     "nmnkmnmjkonmfmnmmhknpmgkqqmmmkmmknmmmhqrmmoknjmmnnmmmmlnmlqnmmoknlmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmjmnmmkloonpjkpmmmmmmmmmmmpllmmmgmkmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmlnmnmnnmmmsjnnmpmkomknjpmsiknmpiiom"},
    {{{12, 1988}, {4, 563}, {0, 640}, {11, 119}, {7, 21}, {12, 1040}},
     "ilknmrlolmmnmnmjojlmlpjmmklmnmnlnlmokmmmlnmnmpsjnmhsopmptkpmvmnjmgjplmplnkmjjmkmhgmmmilpnmmjn"
     "lmmkmnmmmmmmdjnrloklmmskmlmmmmmmmmmmmjqlqlipkqmmmmmmmmmmmmmmmmurkommmmmmhsgjmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmoqiommmmmmomkmmmmmmmjklpmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{14, 2217}, {3, 1304}, {8, 146}, {14, 1760}, {5, 493}, {1, 960}},
     "nlmnmnnnlmimnnmjmpnnknmlmlmlknmmmkmokpompklmnnqillmmlpmqnllmiqommgrjlmkmnmmmlpnmqoknmorkmmnon"
     "lmpqpjmjokqmnlnkmqohnmiphkmnonlmlqiljmmmmmmklnmlmnmmimrlnmmmmmolmmmmmmmmmmmmmmmmmmmmmmmlmmpmo"
     "nlomukmnmvkjommmmmmmmmmmmmmmmmmmmmkorlmmplnmplnkmumlmmmmmmmmmmmmmmmmmmmmmmvlnlmqmipmqljmmrjkm"
     "mmmmmmmmmmmmmmmmmmmmmlnpmniimonmmmmmhflnm"},
    {{{5, 790}, {12, 1540}, {11, 98}, {0, 576}, {20, 0}, {15, 640}},
     "lkmmmqnnkmlmmmmmmommnslomolmmnjolqmmnlpmomlmmnoklmlmnkmsmpnmmomlmrlolmmlojmtjqkmjlolmnpjjmqml"
     "nmrmjmmqnklmyonjmpnjomommlmimntmejmrmfknnlbhlpmmmmmmdgoqmkmmmmmmmmmnmlomfmkmmtkopmhoipmnujnmm"
     "mmmmrlllmmmmmmmmmmmkmmomknlnmmolommmmmmmmmmmmmmmmmmmmmnmmmmisjjmmmmmmnnkmmnmmmmjonkmmmmmmmmmm"
     "mmmmmmnmmmmmmmmmnmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{14, 2396}, {19, 704}, {7, 21}, {5, 640}, {14, 1360}, {11, 134}},
     "ppnkmppmklrpmqmqomrmmmmmmmmmmmkmmmmmmmmmqkplmqnokmmmnlmnjpkpmmmmmmmmmmmmmmmmmmmmmlonmknknmmmn"
     "lmklnnmmlqmmglopmqmlmmnnmklmmlnlmllmmlommmnknlm]obgmnmnmmpnnmmjmnmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmpikomullmmmmmmmmmmmmimjommmmm"
     "mmmmmmmmmmmjklomplmlmmmmmmmmmmmmmmmmmmmmm"},
    {{{6, 246}, {4, 563}, {13, 1056}, {7, 21}, {21, 0}, {11, 46}},
     "jlommonnmmnllmmnmllmnknmmmnlmmmnmnmllnlmikqlnkkqomololmjnonm_nehmnskpmrkmlmglplnnmllmrnkmmijm"
     "mmmlnmmngpjnnllnmjmmnmnmlmmjnnongklrmjkpnmhknpmujlmnnmknmmlnmnopmnmmmlmmmmmmmkoimmkolommmmmmm"
     "mmmmlnmnmmmmmmponmmmmmmmrmnlmknnnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnmmmmmmmmmmmmmmmmmmmmmmm"
     "mnplnmmmmmmnojmmllmnmmmmmmmmmmmmmmmmmmmmm"},
    {{{18, 1528}, {5, 680}, {3, 1072}, {0, 512}, {13, 896}, {7, 21}},
     "lllomnmmlmjmqmniljknhmnmmllnnmmmjjmmpjolonnlmknnlmjloomomnmnnllmmmmmompnqjmspkmmjmkommmmmmklq"
     "mmommmmopklminlnlspimmmmmmminnlmnmmmmjqllm^oejnmmmmmmmmmmjmmkmkmmmmkninmlnlmmmllkmmmmlmjnlnml"
     "nmqmnnjomollmmslmlmmlnkmlnlnmmlnmmnmlomlllomrlkomolmnmjpiommmmmmqlnmmmmmmmiokommmmmmujnnmmmmm"
     "mmmmmmmmmmmtljnmmmmmmmmmmmmmmmmvkjommmmmm"},
    {{{1, 1352}, {4, 402}, {19, 1200}, {10, 133}, {11, 119}, {0, 512}},
     "mmmnmknlnmnolmllomlmlliompmlnnnlknmnjnnmgpklmiojkmqokkmppjkmmnjommmmmmlqjlmlqllnllnlmnmmnmlmn"
     "nmpkmmmnmmlmlqmplmkmlolinknnolmmqlkmmhjnpmklmnmlnplmrmnnmmnlmmlmmmmnlopmmmmmmskrrmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmplmlmmmmmmqlolmmmmmmmmmmmmmmmm{mnimmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mjgnnmmmmmmmkllnjkkmmkkqmoolnmmmmmmmmmmmm"},
    {{{5, 323}, {19, 1056}, {6, 76}, {11, 134}, {0, 384}, {14, 1760}},
     "nlmmmllmmmmjolmjjmllmmmmmmmmmmnkokmkjmkmslmlmnjmmmpkolmklnnmpnnlnmmmmmomnlmllmmmoljmkhmmmnimk"
     "ojgjlnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmoklmlknmlmkpmoliplommmmmml"
     "mlmmlllnnniplnnllnmmnllmkmmnmmmlmmommommpnommnmmmmlnkmpoklmkoonnqonkmonnmmppklmmnknmlnllmrmkl"
     "mmnmmmjqonmnkolmqjllmnjnpmjkmmlgloqmhjmmm"},
    {{{19, 768}, {3, 960}, {5, 493}, {11, 46}, {20, 0}, {0, 512}},
     "olnmmklonlmnmkmjonpmsnnlmomnlmplmkmmlmlmmnmmmlnmnmipllmkomomkooominnlmtnlqmmmmlmokokmjjqknmjn"
     "lmjknnmolnllnlpmmmlmllknmnmmmmmmlnnlmmmmmmmmmlmmmmmmmmmmmmmmmmmmmmmjmmnnkmnnnjmjmmjlmnmmmknmk"
     "nlnlkmjlmkkmlmkmnnnlpinnlnkmmlmmnmlmmomhmkomknmkmnmojmmkmmmpmnnmkmnmmnklpmnmjllmolmmipnlmnmlm"
     "mknnkmmmllnplmmmrkjpmomnnmllnmmmmnnmpjomm"},
    {{{12, 1988}, {16, 1552}, {2, 800}, {11, 192}, {5, 493}, {14, 1884}},
     "nlmmmknmmmkmmnmolmmmolplonkmkmlmonmfpollnqlmmnnmlmomnlmolmmmmmnnnllnkmkllmmnkmommmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmjlkmkiinnnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmkmnnmhomnmlmnnmonkmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmipimmlllmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmqqkmmmnholmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{14, 2396}, {6, 246}, {11, 46}, {21, 0}, {6, 85}, {4, 512}},
     "fjoknoiqjnjlmlmollmmqnnmmlnmnmmmmmmklnmmmnnmmmqkmlnmnnmnllnmmllmmnmmmmmnmlmjknnmmmmmmmmmmmmom"
     "nmnommmmmmmmmmmmmomlmmnokmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmknmnmkklnmlnnnmmnnmmmmmmmmmmmmskklml"
     "kkomimlnmmmmmmmmmmmrlipmmmmmmmmmmmslmllmmlnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmjnlnmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{0, 704}, {4, 554}, {12, 1040}, {15, 256}, {7, 21}, {14, 1328}},
     "oqmlllolkmomnlmmmmmmlnkmmjmlnmlmlnllnmmmnoknmioimmkplollmklmnlnmmomnlmkmjlmnnmlmmmmmmnmmmmoko"
     "kmnkmlmnnnmnmklmmmjolmlmlnmjlnnmkljmmnmnpmpljmmklonnlnmnmllknnmlnmmlmmjmmmmmmknmmlionlmmmmmmm"
     "mmmmlmnmmmnolmlmmjmmmmmmmmmmmjolmmkrrhmmmmmmjkqnnmmnlmmmmmmmmmmmmmmmmlmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmnnmmmmmmnmmmmmmmmmmmmompmollmm"},
    {{{5, 790}, {18, 1366}, {1, 928}, {5, 544}, {7, 4}, {12, 1120}},
     "mmmmnokplnmlmmmolmnnlnlmmmmnmmpnjnmjmllmjollmroojmmmmmmloklmokqpmkknnmpkolmmpmkmlmlmmmkolmlnm"
     "mmlmnlmjpkmmolmmmmnlnmnmmmmnoismrnkmmnklnmlmknmlkkmmkkkommmmnmrlmnmmmmmmmmmmmmmmmmmmmmmjllnmn"
     "oknmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmgojkmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmhnlmmmnlommmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmolkmmmmmmmmmmmm"},
    {{{5, 790}, {16, 384}, {12, 1592}, {18, 568}, {0, 384}, {15, 384}},
     "onmmmnmknmoonjmlmlmmqonpmkmknmkmomnimnnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmqnnmmomkmmmmn"
     "mmmmmmmnmmmmlnnnmlmlmmnlmmmlmmnmjllomllmnnellrminpnmknlmmollmmokllmmmmmmmmmmmmmmmmmmmmmmmmmmj"
     "kknmmmmmmanlpmmmmmmmmmmmmmmmmmmmmmmmmmmllmlmmmmmmjiolmmmmmmnlllmmmmmmlmnnmmmmmmmnjmmmnmmmomln"
     "mmmmmmmnmmmmmmmmmmmmmmmmmmlqkmmmmmmmgrkkm"},
    {{{7, 146}, {5, 336}, {14, 1328}, {18, 1366}, {1, 832}, {19, 928}},
     "pmmmllllomomollllnnlmmmmmmmmmmmmmmmmmmmmollmmnmlmmmknlnjmkmkmllomlnmmmnllnmjllnnmmlnmllmmnmnm"
     "mmlnmmmmmmmmmmmmmmmmmmmmmmmmmlkmnnolmlmnmnnmnlmknllmmmnmmmmlpmpllnmnlmmmmmmmmnjojmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmnlmlmmmmmmlmnnmmmmmmohokmmlmmmlknlnmmmmmmkplnlmnmmmmmmmmmmmmmmmmmmmmm"
     "mlrnplmmmmmknnmmmmmmmkmnmmmmmmmlmnnmjnmnm"},
    {{{1, 1352}, {0, 640}, {11, 170}, {19, 1200}, {10, 27}, {14, 2004}},
     "kmmlmnmmnmnmmmmlnmlmmnmmmnmknmonmlmknmmmlmnnmhpmmmnlnmnllnmmlmlomgjlmmopkjmqnpkmnqmmmkmnkmjql"
     "olkpmpmnmmmmmmmmmekmqmqjmkmijnmnmmmmmlmnlmqjmkmkqqimmmmmmlmmomnkmlmmmmmmmmmmmilqmmvlmqmmmmmmm"
     "mmmmjlpmnoimmmmmmmmmmmmmkmmmmqmmommmmmmmmmmmmklmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmzlnjmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{1, 1352}, {17, 256}, {18, 346}, {1, 992}, {0, 576}, {11, 119}},
     "mlmkmmkmlmmmmmmmlmlllolpmopkkmmmmmmkmnmnmmmmmlmmmmlqlomnknkmmmmmmkolnmlmnmmmlmmmmmmmmmmmmmmmm"
     "mmnmlmmmmmmmmmmmmmmmmmnmomolnnnmmmlmmmnlomklinlikormllmomnjnnmmlmommmmmmmmmmmmmmmmmmmmmmmmmmm"
     "llmmmmmmmkmlnmmmmmmmmmmmmmmmmmmmmmlkpmnplopmmmmmmrlokmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnlmmmvmmkm"},
    {{{0, 704}, {10, 42}, {11, 46}, {21, 0}, {7, 21}, {18, 1366}},
     "hlnmmlnmnmfnhjmpmlmmnmnmmomlnmolmnmlnmnmlnkomklknmhkqnmomlnmmmlnmkmllmmnlmllokllomqmnnmommnln"
     "mmpjmmmkmnnolkllmnmmnmknmnmmmnmmqnmmmmnmmmmlkmmnmlmmklmnmmlmlmjoollmmmmmmmmmmmmmmmmmmmmmnmmmn"
     "mmmmnoolmjlokmlmmimmmmmmmmmmmmmmmmlqqimmmmmmmmmmmmmmmmmmmmmmmmmmnmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mlmmmmmmmmmjonnmmmmmmmmmmmmmmmmnomomomlmm"},
    {{{12, 1988}, {0, 384}, {14, 1940}, {4, 457}, {12, 1024}, {1, 832}},
     "nmlmmnnlommlommnnmlmpmlnmolmlmmllnmommlmlnllmjniomkomlmrllomkoommmlmnnjpommlmommlmlmmlnmnmomn"
     "nmlmmnmmmmmmlknkmmlmmmonmlmknlomnlnnmnknlmoknlmlnmmmknmomollmmmmmmmmmmmmmmmmmmmmmmllknmmmmmmm"
     "mmmmiolnmonmmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmkplnmmmmmmmmmmmmmmmmmmmmmlnjmmmmmmmmmmmmplmlmmmmn"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmolimmlmmmm"},
    {{{19, 640}, {0, 512}, {12, 1040}, {18, 1160}, {3, 1040}, {15, 384}},
     "pnnlmmmmmmmmnmmmmmmmolmkmmmmmmnknlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnlnmnmmmmmmmo"
     "lmmmmmmmnnnmmmmmmlmnnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnmmmlknmllnlnlmkllnmllml"
     "mjmmmkllmknnmmknonnklonmlloomnmmmmlmklmlmnmmlmmlmlnnmmlnmmlklmnmllnlmkmmnmmlmnmnlmnmjnmomnnln"
     "mkojnmpoimmlnmnmommmmmlkkmololmnlknmqklmm"},
    {{{6, 246}, {13, 896}, {0, 576}, {3, 1104}, {15, 576}, {14, 1416}},
     "mmmmmmmmmmmlknlmmmnmljnlmllmlmnmmlmmnnmmlnmmmllmmmkllnmrkpjmmmnnmlnmnmhknpnrmmlmkmommllnlmoln"
     "mmmmmmmmlmnmmmnnmkmkmmknlmmmpklmqmlkmmmmmmnmmlmmqlnlpmlmmoomkmnonlmmomnmlokmmmmmmmfqjqmmmmmmm"
     "mmmmmmmmmmmmmmlnmmmmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnmnmmnmmmmmmmnmnlmnmllmlmonkmmkmlmnnplm"
     "mnpknmqnjlmmmmmmmmmmmmmmmmonkmmmmmmmlmmlm"},
    {{{6, 246}, {18, 1539}, {13, 800}, {7, 21}, {8, 0}, {18, 652}},
     "fjlknhomomnmmmmmmnmmlmnmmkonlmmmmmmmmmmmmmommlmnmmononmkmmlmfnhjmomnommolnmpmmmmmmmmmioknmmmm"
     "mmtilmmmmmmmllmnmmmmmmmnmommmmmmolnmmmmmmmnmmmmmmmmmlmnmmmmmmmlnnmmjnlnmloklmmmmmmnmmmmmmmmmm"
     "mmmmmmmmmmmmmmlnlnmmnmlmmmmmmkmmmmmmmmmmmmmmmmmmmmmmmmmmmmmipknmmmmmmmmmmmmmmmmlnmmmmmmmmmmmm"
     "mmmmmmollnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{10, 170}, {11, 119}, {4, 402}, {5, 369}, {8, 109}, {21, 0}},
     "komomllmlmmmmmmmmmmmmlmmmlmmmmljnomllknmnkmlmmnlommmlmmllmmmlmmmmmmmmmnnmlmommlmmnmnmonmmnmmm"
     "mmmmmmmpmnnmmnmlmnnllmnnklmkjmkmnlmlnmmmmmnjlnmqllnmknommgknomjkmnmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmkoipmolnllmmnnmmmmmmonlmmisnnmlnmmmjqnmmjnlmmmmmmmmmmmmmmmmmlommmmmnmmmlmnmmlommljmo"
     "nmlmmmmmpkommmmmmkolommmmmkmnmnmnmmmiinln"},
    {{{5, 790}, {16, 384}, {19, 1072}, {8, 69}, {1, 928}, {18, 1160}},
     "lnmklmnmkmomnkmmmmmmlmnmmmmnmmknoomsmmpmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnmmmmmmmmn"
     "mmnmmmmmmlnmmmmlmllnnmmmlmmlmmnmnmlmmikmmnlmlnmplnlmmnommnnmmmlmlmmhllomgolnmjknnmhmkmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmkinkmmlmmmmmmmmmmmmmmmmmmmmmmmmnknmnmmnmkmllmqmllmmmmmmmmmmmmmmmmmmmm"
     "mnqmmmjomnmjpjmmmnmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{6, 146}, {5, 512}, {18, 1338}, {11, 46}, {16, 832}, {7, 16}},
     "jlmnnlmnmmllmlmnllmmlmllmmmmmmnnllmlmlmmkmmmmmmmommmlmmmlmmmlkllmllknmmnmmmlnnmmmllnnmnmnmtnr"
     "kmqmolnolnnmoklnnllmnmnnnlmlllmmmmmlmskmmlollmmmlnnmnkllmlkmmlnmmlmlnnnnnnnomkmnnnmlonnoommmo"
     "monnlnmnmmmnnnlmklmnnmkmjpmnmnmmmmrmlpmolmlmllmmmomllmmnmmmlmonmmmnmmhmjkmmmmlmmmkmmknlommlpo"
     "mmmmmmipmlmmmlmmomnmmjommmjmnmmimmmmnlknm"},
    {{{2, 1024}, {3, 1336}, {8, 187}, {12, 832}, {7, 46}, {11, 134}},
     "jnmommnmmmnmnmmnknmnmmmmmmnmmmmmlmmmkmmmmnlnmnlmmmmmmmmmmmmmonmmmmnkmmmmmnmmmmmmlnmnmmmmmmlnm"
     "nmmmmmmlnlmmlmlmmmllnmrnlmmlnlnmmmmmmmmmmmmmmmmlnplmkkmnmmmmmmmmmmmqjmlmulnkmmmmmmllmnmjmmlml"
     "nllmmmmmmoolnmmnkommmlmmmmmmmmmmmmmmmmmiolmnmmmmmmmmmmmmmnmmmmmmmmmmmmmmmmlljnmklmmmkmlnmmmmm"
     "mmlmmmmmmmmmmmmmmmmmmnjnmmmlmmmmmmmmmmmmm"},
    {{{7, 146}, {9, 0}, {3, 1072}, {14, 992}, {21, 0}, {10, 107}},
     "nmmnmommllmmkmloomkmmlmmmmllmmmmmmmlmmmmlmonmnlnknjklmmlknmmmmlmmmonmmnmmmmmmmnmjnnlmmmmmmnnl"
     "mnmnlmlkkmpmjllmljmkmlknjmlmmmmmmmmmmmmmmmmmmmmkjnnmqkmkmkmkkmklllnmlnkmomnlmmmmmmnmnmmmmmlmm"
     "moommmmlmmnnommmmkmmmnlmmmmmmmmmmmnlnmmljojnklolmmnnnmmmmmmmmmmmmmmmnmmmmmmmmmmmmmmmmmmmmmmml"
     "nmmmmmmmmmmmmmmmmmmmmmmmmmmmlomlnlnmmmmmm"},
    {{{5, 790}, {11, 237}, {12, 1368}, {18, 568}, {2, 800}, {4, 448}},
     "mmmmmnlmmmnnlmmmnmmmmmmmmmmmmmnmnlmnmnmmnmnmmimkomflnpmmmlmmplnmmlmmmmmjmlmomllmmnnnmomnmmkkj"
     "mmmmmmmjnolmiksmnklqommmmmmlmnmmrmmlmmmmmmkppjmipnlminmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmkllnmm"
     "mmmmeokommmmmmlmmnmmmmmmmmmmmmmmmmoknmmmmmmmlnllmpolmmmmmmmmmmmmmmmmmmmmmmlnlnmmmmmmmlmnmmmmm"
     "mlmmmmmmmmmmllmmmmmmmlmmmmmmmmmmnkmmmmmmm"},
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

/* The inverse of rough_logarithm, without subtracting 1. */
static double rough_power(double x)
{
    double whole = floor(x);
    return ldexp(1 + x - whole, (int)whole);
}

static size_t find_leaf(const tree *t, const int *mark)
{
    size_t leaf = 0;
    for (int k = 0; k < QUESTIONS; k++)
        leaf = 2 * leaf + (mark[t->question[k].feature] > t->question[k].above);
    return leaf;
}

/* The weighted sum of marks, rounded towards 0: linear, so that it extrapolates beyond the data of
 * the fit. */
static int foretell_by_weights(const int *mark, int which)
{
    int64_t sum = START[which];
    for (int k = 0; k < FMB_FEATURE_COUNT; k++)
        sum += (int64_t)WEIGHT[k][which] * mark[k];
    return (int)(sum / (FINE * MARKS));
}

static void foretell(const fmb_features *f, int *told)
{
    int mark[FMB_FEATURE_COUNT];
    for (int k = 0; k < FMB_FEATURE_COUNT; k++)
        mark[k] = (int)(MARKS * rough_logarithm(fmb_features_value(f, (fmb_feature_id)k)));
    for (int k = 0; k < FORETOLD_COUNT; k++)
        told[k] = foretell_by_weights(mark, k);
    for (size_t t = 0; t < sizeof TREE / sizeof *TREE; t++) {
        const char *leaf = &TREE[t].leaf[find_leaf(&TREE[t], mark) * FORETOLD_COUNT];
        for (int k = 0; k < FORETOLD_COUNT; k++)
            told[k] += leaf[k] - NEUTRAL;
    }
}

/* The entries of a row and the bits of its numbers determine what a step of any engine takes. */
static double unit_of_work(const fmb_features *f)
{
    return 16 * (double)f->entries * (double)(64 + f->minor_bits);
}

/* A bound, or a row that names few variables, excludes most directions. */
static bool tries_recession(const fmb_features *f)
{
    return 4 * f->entries >= 3 * f->rows * f->columns && f->bounds == 0;
}

/* The budget of bounded elimination is the work expected of the best engine. */
fmb_choice fmb_selection_of(const fmb_features *f)
{
    int told[FORETOLD_COUNT];
    double unit = unit_of_work(f), least = INFINITY;
#ifdef FMB_ABLATE
    if (fmb_selection_forced)
        return *fmb_selection_forced;
#endif
    foretell(f, told);
    fmb_choice c = {.recession = tries_recession(f)};
    for (int k = 0; k < FMB_ENGINES; k++) {
        int parts = told[FORETOLD_BEST] + told[FORETOLD_RAYS + k];
        c.work[k] = unit * rough_power((double)parts / PARTS);
        least = fmin(least, c.work[k]);
    }
    c.bounded = told[FORETOLD_BOUNDED] < 0 ? 1 + (uint64_t)least : 0;
    return c;
}

/* ---- bounded elimination --------------------------------------------------------------------- */

/* From so many dimensions on, a hull takes longer than finding the irredundant among many rows. */
#define SHORT_QUERIES 4

/* With few kept variables, finding the irredundant ones of many rows takes as long as some support
 * queries; where numbers are long, already with fewer rows. */
bool fmb_selection_keeps_rows(const fmb_elim *e, size_t before, int kept)
{
    size_t most = fmb_elim_minor_bits(e) > FMB_LONG_MINOR ? before : before * (size_t)kept;
    return kept >= SHORT_QUERIES || e->live.size <= most;
}
