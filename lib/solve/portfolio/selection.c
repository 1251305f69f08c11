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
/* 19579 problems of 101 families, seeds 1 to 390050, ways as of commit 563c3091.
 * Time over that of the best method alone: 1.135 on families seen, 1.209 on others. */
static const int START[FORETOLD_COUNT] = {-1861401, -972894, 982344, 942706, -197951};
static const short WEIGHT[FMB_FEATURE_COUNT][FORETOLD_COUNT] = {
    {7239, -1236, -3348, 3727, -305},
    {1498, -1690, -101, 1148, -108},
    {-3694, 3225, -37, 585, 388},
    {-2778, 1065, 25, 552, 49},
    {-985, -1018, -1427, -176, 60},
    {1716, 1141, 472, 788, -159},
    {-6973, -5097, -1949, -169, 130},
    {-9808, 4219, -1467, -599, -970},
    {-2404, -2295, 791, 359, -61},
    {-3233, 4047, 2977, -13390, 1632},
    {3728, -940, -1768, -279, -293},
    {-3547, -3231, 2806, -1140, 541},
    {811, -332, 1635, -599, -55},
    {157, -383, 475, -40, -10},
    {168, 282, 505, -383, 162},
    {1640, -1266, 1242, -2573, -211},
    {2503, 523, 835, -651, -77},
    {1058, -1592, 1075, -1108, 160},
    {352, 584, -223, -358, 42},
    {-663, 1300, -1516, -99, 147},
    {4648, 293, -915, -485, -223},
    {-444, 848, -586, 750, 195},
};
static const tree TREE[] = {
    {{{14, 2382}, {6, 66}, {19, 1040}, {11, 113}, {0, 512}, {18, 1059}},
     "mlmmljnmnnkrnplfpntmmklnmlmmmmklmlmminjnorkklisoknspllmoolomltgllknokmopllnujmlmmknnmnmkkmlnm"
     "nmjpkqmmmmomnmmlmlmnmmnjnjnlkoknnpplmvjoinwillmhkotmjkpolbkpsnlgommmmmmmmmmmmmmmmmhmnnmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmgfooommmmmkgjqmmmmmmrmomlmmmmm{illlmmmmmmlimmmmmmmllklmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmtjkllmmmmmommlmmmmmmmmmmmmmmmmmmmmm"},
    {{{6, 252}, {5, 524}, {19, 960}, {14, 2026}, {1, 928}, {11, 56}},
     "nknmmnlllmlkpmmoonmmdpmqmjokmmglnnmmkolmpkmmnnlkmmmnklmmtilljoonmooplmhjmonqomlmjlmmnknmnmimm"
     "pmimonmjpjnmjokllkmkomlmlkmkjoknllppmpnpimljppnqlnmmjnplltijlmpgpqmommmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmminlommmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmloknmmnlmmmmmmmmmmmmksjplmnlmmmmmmmmmmm"
     "mqomlmkllnmolnkmmmmmmpqlnllmmmmvlimmmmmmm"},
    {{{19, 768}, {7, 21}, {4, 409}, {11, 128}, {14, 1296}, {12, 1168}},
     "lnnmmmmmmmlonqmmmmmmoqllmmmmmmponommmmmmnnmmmmmmmmonmmmmmmmmmmmmmmmmmmmmmmmmmmmmllplmmmmmmjlq"
     "lommmmmpomklmmmmmolpkommmmmqlpmmmmmmmolnlmmmmmmqlolnmmmmmohojommmmmmmkonokrnnkklomqmjlmmrilmg"
     "mqqmpmmnmjqmllmklmmljsonklnlnpmolmnnlmmfmnpnllllndgorlipkplpmllmiomomnolmmknknmlmmmmnkmmnlmnl"
     "mlmlnkhmfmmlommmmnllmmklmmmnnonnknkmskmll"},
    {{{14, 2382}, {6, 66}, {18, 1472}, {0, 576}, {11, 113}, {19, 1136}},
     "komnloqmkllmkllmqjkmksmrmwmklmmlmmmsnnkmjlmnmkmpmnmmmmmmnommhmnqmlmmnmwjklmrmolmmlmmmonokmmlm"
     "mmfjnrmmrlomullimmmmlmehpqmmnlmmlonomjrlllklmnmgpksmnnknmlmmlmmmmmmmmmmmnojmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmlnlmmmmmmjgnnnmmmmmulmmlimnomnjlpmmmmmmrjlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mkjgmlslommmmmmmmmmmmklmmmmmmmmmmmmmmmmmm"},
    {{{0, 384}, {14, 1978}, {19, 992}, {5, 490}, {11, 46}, {14, 1376}},
     "pkmnmplkmmqnlnmplkknlkqommmkmmlmmqnnmoqmmkkonjplnmomimllpjlmillmmlsommlmmpmmnlmmmmmmmllkmmmmm"
     "mmloklmmmmmmlpmllmmmmmpoopmmmmmminpnnmmmmmhsqmmmmmmmjqoolmmmmmhooomlkommmmomnmnmmlnkmjnllmlnk"
     "okomjnmnnklmmmnlmmmnnlllmqkmmmrlimjjolmqknjmklnonxkoimmmmmmgnnpmmmmmmknlnmmmmmmkojommmmmmllml"
     "mmmmmmkjmnmmmmmmonllmmmmmmskklmmmmmmqjolm"},
    {{{6, 252}, {4, 565}, {0, 384}, {7, 16}, {19, 928}, {14, 1376}},
     "mmnonlnlompmnnnmoonmqmmnmomlknkmhllkrommlnlmminlnmmlommqknkmmmmmllmmmnjolmlnnmmmmmmmmmmmmmilo"
     "pmhnnomqlmnmqjklmmjlnnjnnmmmmmmmmmmmmikqpmkgomnmjolnninkmnmknnnllmlmlonmmnkllnmnmmnoolmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmirkpmomnmmslkmmmmmmmmmmmmmmmmmmmmmmmmmmmommmmimmomislommmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmnlnmmrnilmmmmmmmmmmmmmmmmmmmmm"},
    {{{12, 1934}, {2, 1104}, {19, 1320}, {8, 170}, {14, 2088}, {12, 832}},
     "nmnmmmmmmmgonrmnmmmmlojpmnqklmlqiolmopmmmmmmmoqjlmmmmmmrkimmjnlnllnlnmlnlmmhlnnn}lnhmhmnkmmmm"
     "mmmllmmmmmmmmmmmmmmmmmmmmmmmmmmmbjosmmmmmmlilmmiklmnmlmmlggqnnkglnnmmmmmkmnommmmmmrllnmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmqknmmmmmmkpjommmmmmlmmnmmmmmmlmmnmmmmmmiollmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmgogmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{19, 640}, {0, 576}, {12, 1040}, {19, 1288}, {7, 21}, {14, 2088}},
     "qpmkmmmmmmqlplmlnmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmolo"
     "kminomlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmlnmjnjommlmmmjomnmjmllnj"
     "ipnnmpnlmknplnllpmmplnmlllklmloplmmoknmnlkommokllkmlmmnnnmminmnmlmnmminnpmzmnimllmmmjmmomlkmo"
     "mspikmopjnmpqknmomlomelnqnojklmroknmnllpm"},
    {{{5, 787}, {12, 1644}, {16, 1520}, {15, 704}, {14, 1772}, {5, 524}},
     "mmmmmjlnmmmmmmmnmmmmoskkmplolmnonmmsjnmmmmmmmmmmmmmmmmmmmmmmknjmjmmmmmjhonnmmmmmmlkpnjkpnmfpn"
     "nmmmnmmlmlmmcjotmmmmmmiilnmjmmnmppkmmlmlmmiphommmmmmmmmmmmmlmmmmmmmmmmmmrnknmmmmmmqmjnmmmmmmf"
     "lmnmmmmmmlnhmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmpomlmmmmmmmmmmmmmmmmltkkmmmmmmgnhl"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{4, 396}, {21, 0}, {8, 128}, {11, 46}, {5, 534}, {7, 16}},
     "hlmomllnlmknnlmjllmmpmnonkmmnmlmrpmmmllmmmmmmmmmmmmmmmmmmmmmmokkmlnjmmulolmqkmnmklnmnjonnmmnj"
     "nmhqlpmlollmnnllmkolmmhlnlmjoiqmkomommiknmmmmmmjokmmlmjmmoljomkkknnflknmnjmlmlmommfnhinomkmmm"
     "nlmmhkpomrnmnmonqlmmlslnpnolmlmmmmponjmlqllljlmqmmmllmqkokmlnmomomnmmnmolmokmkmolmlmjmolmgkqk"
     "mlknlnlmlnltnnlmmmmmmmlmlmlmmlmjjlnmjmlnm"},
    {{{19, 768}, {15, 256}, {18, 554}, {0, 384}, {12, 1040}, {0, 512}},
     "soommmmmmmmmmmmmmmmmomnlmnmnklmmmmmmmmmmrlnlnmmmmmmmmmmmmmmmmlnkmlmomnmmmmmmmmmmommnmmmmmmmmm"
     "mmmmmmmmmmmlmnmllmmmmmmmmmmoomommmmmmmmmmmmmmmmlnmmmlmpmmmmmmmmmmmmnnmnnmmmmmnmnommmmmmmmmmnk"
     "mmlmlmmnmmnmnnolllnmmmmmnlkmmmmmmmmnlmmkmlmmlmjnmkqjomnmknlmmmmmmmlommmmmmlmllllmmnmnmmmmlnkn"
     "mmmlmmmmmmmknnmmmmmmmklmmmkmmnmmlokmrkllm"},
    {{{18, 1522}, {4, 554}, {19, 1200}, {0, 640}, {11, 168}, {12, 1264}},
     "mmmmmnlnlmnmmmnjlpommpnnmrtjomkknkmlknmmppnlmpplkmorikmikkomulnlmokmmmnlnmmkopimmkmmmlknnmqkm"
     "lmsnlnmipmpmmqlomtnlmmpmlmmllnmmkmlnmpnnkmjjmomnmmnmollmmmmmmmoolomjplnmomlmmkollljqmmlemnnmj"
     "olnmmmmmmmmmmmqmnmlrlnmmmmnmmmmmmmmmmmmnmmmmmmmmmmmmmmmlmlmnlmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mnnmlmlnkommmnmmmmmmmlmmnmmmmmmmmmmmmmmmm"},
    {{{6, 252}, {0, 576}, {15, 576}, {16, 704}, {14, 1772}, {21, 0}},
     "mmnmnnnmmmollmmknknlllmmmmkonnnmllmllmlmhlopnjlmomskoqmlljnmmoklmonmmmnoommlmmmmklolmmollmmjp"
     "jnlnlmllpmnlppnnnlnkpmjnlomomnmmjkmnmnkommpinkmolnnmkolnmokllmrllnmmmmmmnlmnmnmnmmlpkomklnnmo"
     "nmmmoollmlnllmmmmmmlllmmmmmmmplkmmnmmmmjnlmmmokmmnollmmmmmmmnmmmmmmmmipnnmommmmmmmmmmmmmmjpko"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{0, 384}, {14, 1922}, {1, 960}, {19, 896}, {5, 506}, {7, 0}},
     "mnlmmpmmmmmmlommmlnmlllmnmlknmlmnnmimimnoonlmonolnponqmmmmmmlojnmomlllnnommnpmlmkllmmmnlkmmlk"
     "kmlnnlmlmmlljpqmmjpommjpoommmmmmmmmmmmmmmmmmmmmmnjmmllnnnqkmommmmmmkmmlmmlmmmjnmmmmmmmmpjnlmn"
     "mmmmolnnmllmlmmmmllnmnlmjnnmmlmnlmmpljnkolmllkolmllmlmjmmmmknmnmiplomknlmmlmnlmnmmlmollmmolmm"
     "mmmmmmmipjnnmmmmmlllmloklmklmmmnkmnmolnmm"},
    {{{5, 688}, {7, 21}, {11, 139}, {10, 157}, {15, 704}, {18, 1376}},
     "mlnmmkmmmmrmokmnlnnmkmkomllknmlpnomnnimmnnmnmhlolmjmknmojlolmllmmmmmmmkmkpmmmmmmnmmmmlmmmmnom"
     "mlmllnmlpmmllnnomknnmmlmmmmnlmlmonnllknmnmmnpmmmiolnmmmmmlhmpnmmmmmqmmmmpnmnmhplkmnjilmmmmmmm"
     "mmmmmmmmmmmmmmjmnnmiplmlnmlnmoplmmmmmmmmmmmmmmmmmmmmmm^ocjmmmlnmmnmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mlnnmmkmmmmmmnmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{12, 1934}, {14, 1376}, {3, 1584}, {18, 720}, {1, 832}, {12, 1424}},
     "nlmmmjmkmmmnmmmglmqmllmmmmkpnmnmnnommmmmmmmmmmmmmmmmmmmqsqemmmmmmmmmmmmmmmmmmmmmoqlmmsmmmmqmn"
     "lmpnojmmnmmmlmolmmlmmmnkllmmmmmmmmmmmklkmllmknkmmmmmmmmmmljomnkkknmmmmmmikmonmmmmmmmmnmmmmmml"
     "lommmmmmmmmmmmmmmmmjnlmmmmmmmmmmmmmmmmmnmllmmmmmmmmmmmmmmmmmmmmmmmmmmjohmmmmmmmnolnmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmlphommmmmmmmmmm"},
    {{{5, 341}, {8, 51}, {16, 896}, {21, 0}, {14, 1336}, {12, 1168}},
     "omnllmmmmmkjnlnmmmmmolmlmmmmmmmkmkmmmmmmliqkmllmmmmgnjmlkmmmlnmnmmmmmmlnnpmmmmmmomonlmmmmmlll"
     "nmmmmmmpnlklmmmmmnmnnmmmmmmnkmlkmmmmmkmllnmmmmmklmollmlmlkmmnmjlinklmonmemmlmnmmmmnlmkmmmmmmo"
     "lpnmlnmmmmmllmjlomnlojommmlomqmknmlolnmllonmnnmnmmmlmmmmlnlnmpnmnmmmmnjnlmlnknmnllmnlllmmnljl"
     "mmnlllnnlmmlpnlmmnnmmnmklnnknmmnnnlmomolm"},
    {{{19, 768}, {15, 256}, {4, 396}, {18, 1414}, {0, 512}, {13, 800}},
     "nnnlmmmmmmnlnknmmmmmlnmnmmmmmmknmnlmmmmmomnlmmmmmmmlnllmmmmmmlmlmmmmmmknnolmmmmmonmommmmmmlmn"
     "llmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmmmmmlnnmmmmmmmmmmkmmmmmmmmmmmmmmmmknmmmmmmmmjmmlminmlmkonnmm"
     "mmmmknmnminmmmnmmlnmmmnmmmlmmnpkommnlnmlmimmknmnmknjommmlnmkmnmmmmmmmomllmknjnmnmllmholqmnnko"
     "mmmmlmkmnmmmmmmmqnmjmlmnlmlmnmmlllpmtjmmm"},
    {{{11, 238}, {2, 1104}, {6, 74}, {7, 11}, {21, 0}, {12, 1232}},
     "omnkmspkkmopjmmnmlmmlmnmmnpmmmmnmmmmnkmmlmnnmlmnnmmmlmmnmnmmmmmmmlmkmmmmmmmnlomnsmnkmikmnmkkp"
     "nnmjmnntmmlmmmmmmmlmlmmkknmmmmmmmmmmmmmmmmhmjlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmomlmmm"
     "mmmmjinnnmmmmmqonmmmmmmmmmmkmionnmnnnmmspjnmjlqloclpmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmpqpf"
     "lmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{3, 800}, {0, 384}, {19, 1088}, {11, 139}, {10, 128}, {5, 397}},
     "onmlnmnmnmqmmmmmmmmmpommnnnmnmnmmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmllomojnnmmmlm"
     "mmmmmmmpoolnnollmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmllmmmlmlmnmlmljolnmnmmnnm"
     "nnomnmnlnlljnmmnlmmlomnmnlnnmkpmnmmmnmmllmommmmmmmnkmmkmmmmlmmmmmnmnlmnlmmnlmmmmmmmmljnknmlnn"
     "njojmmplmlmmlmmmrlqkmmklmmlmmnmnklnmlqjlm"},
    {{{0, 640}, {19, 1104}, {16, 1104}, {12, 1320}, {11, 113}, {18, 1059}},
     "mmmmmmmlmmlmmmmnlmlmjlmmmnlmlmlnlomjommmljolmnimknnlmmmnmmnmolmnmnllmmmmmmmmmmmmplokmnnnmmnpl"
     "kmomplmnnnlmnmmmmhnmpmeknomnnnmmlmnmmnlllmqnmmmomllmknlnmkmkomjjkomnpnlmhnnnmlmnmmomlllntloll"
     "plnmmmmmmmlmmmkpmnmkompmlnmmmnmmnmkmmmmmmmnmnnmmmmmmmmrlmlmommmmsmllmomlnmpmmlmmmmmmmmmmmlmmm"
     "mnmmommlmnmlmnnmrkmmmrnlmmollmmjnnompklkm"},
    {{{5, 787}, {16, 384}, {18, 720}, {0, 384}, {15, 384}, {12, 928}},
     "onmlmmmmmmlmlommmmmmoomkmlmmimknmnmkmmlmoomommmmmmnmlmmmmmmmlnolmkmmmmkmonmmmlmmomnnmnnmomnmk"
     "mlnllmmmmnmmmnmnmlmlnmnmmmmnlmlnmmmlmlmlmmlnnnmmmnmmlmlmmmmmnmnlmlmmmmmmmmmmmmmmmmjklnmmmmmmm"
     "mmmmmmmmmfjonmmmmmmmmmmmmmmmmlmjnmmmmmmmmmmmmmmmmljllmmmmmmmmmmmmmmmmprklmmmmmmmommmmmmmmnokm"
     "mmmmmmmmmmmmmmmmmnjmmmmmmmkmmmmmmmmmpllmm"},
    {{{12, 1934}, {0, 512}, {11, 46}, {12, 1104}, {14, 1448}, {7, 21}},
     "mlmmmllmmmkmmnmnmmlmnlqmmjljlmmmmlmnmolmmmlmmnmlmmnmmmmmmmlmmmmnmmmmomjmmnmmnlmmiklmmlmnnmknm"
     "omknnomrnklmsoknmmmlnmomlnmmmmmmlmmnmnmmlmnlmmmlmnmmmnmmmolmlmplllmmmmmmmmmmmmmmmmmmmmmlmmmml"
     "lonmlpknmknnmmmmmmmmmmmmmmmmmmmmmmmmlnmmmmmmkmmnmmmmmmmmmmmmmmmmmmmmmmmmmmllmmmmmmmnnjkmmslll"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{11, 238}, {19, 1368}, {4, 576}, {10, 76}, {21, 0}, {4, 362}},
     "kmnkmkmlnmlnlmmommmmnlnnmmnmmmmmlmmmmmmmmmmmmollnmmmmmmllnnmmmmmmniolnmmmmmkmnmmmmmmmonjmmjmj"
     "mmllknmmmmmmmlnmmmmmmmmlnmnmmmmmjnlommmmmmnnkmmmmmmmmmmmmmmmmmklknlnnmmmqokmmmmlmmflrlmrnnmmp"
     "nknmmlnlmimpmnmmmmmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmpqpgmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{14, 2088}, {1, 992}, {19, 1088}, {0, 512}, {13, 832}, {11, 0}},
     "lmmnmmmlmmkmmlmmmommnnmnmmlmmmpnklmmmmmmnkokmnlommlnmmmmmlomrmmmmpkmlmnkplmqnmmmmkpnnnmmlmjmn"
     "mmkmmlmlmnlmlmmmmkkommjomnlonnlmmnklmhokmmmmnomllmllkmmmmllnlmsonimlolmmmnmmmnlolmmnnlmjnnoml"
     "omomkolpmmlmlminpmmmnommnmmnmjlmnmplllmolmlmrjmmmqlokmnklnmvlnrmnkjmmmmmmmjomnmmlnkmknlmmmnmm"
     "momlmmkmmmmmlkmmjmlommmkmmollmmmmmmmolmlm"},
    {{{18, 1537}, {15, 256}, {1, 704}, {18, 812}, {5, 506}, {3, 992}},
     "ommnnonmpmolnmmolnmnpllmnolllmlolnmoljlmnmmmllmnlmlnmlmoomnnmmnlnmmmmmjmmkljnmmmmlkmlmlknnnmo"
     "nmjlmmmlnmmmkoommmllkmonmlmlmmmmmmmmmlnmnmnmmlmmkllmmmmmmmmmmmmlnmmmmmmmmmmmmmmmmmmmmmmmmmmml"
     "nmmmhsnqmhoiommmmmmmmmmmmmmmmmmmmmmnmnllmmlmlmmlmmmlmmmmmmmmmmmmmmmmmmmmmmmmmmmlnmnmlmnmmlmon"
     "mmmmmmmmmmmmmmmmmmmmmmomomkmmnmnnlnmpmmmm"},
    {{{12, 800}, {7, 56}, {11, 128}, {10, 128}, {6, 74}, {4, 384}},
     "komolimmnmlmnnmgnlnlmmmmmmlolmmlmmmonmmmmmmlmmmmmmonmlmmnknlnllonmmmmmmmlomlmnmoklolnmlnmmmln"
     "mlolnmmklnmnmlnmlnlmmmnmnmlmmnmmmmmmmommmmnmnnnolnmmllnkmmlnnnlmokpqmmnmnolmmlmmmmmmmmmlokpmm"
     "lnmnlllnmnommmllmlmmmlmmmnlmmjlnompollmllllmknlmmmlklmmmmlmjnmnmknlnmnmlmmnmmmmlolnmqmlmnmnmm"
     "lmnlmmplllmmolnmnmmmmnkoomljmlmllnmollmln"},
    {{{6, 252}, {15, 256}, {4, 603}, {12, 928}, {2, 768}, {14, 1772}},
     "nmnmmmmmmmkmmlmmmmlmmnmmmmnlmmmnmkmjmnlmmlnlmmjmkmmmmmmmmmmmnmnompkkkmmmmmmmmmmmlmmmmmnmmmlnm"
     "nmmmmmmklmnmmlmlmomnlmnmmmmmjolnoimkmlmnnmmmmmmnkmmmkmnnmknlnkjlknmmmnmmlonmmmmmmmmmmmmjnnmmg"
     "rkpmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmmmllilmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnmommlmnllmmonln"
     "mmmmmmmmmmmmmmmmmmmmmonlmmlnmmmmmmmmmmmmm"},
    {{{17, 256}, {0, 640}, {4, 480}, {11, 113}, {10, 149}, {16, 800}},
     "mmmmmolnlmllmmmmolmlnmmmmjnlmmmlmnnllnkmnmmlmmmmmmnmmnllomnmnmmmnnlmmmnmmlnljnkmkpnlmmnmmmmmm"
     "mmlonollnmkmjlommololmnmlnmmmmmmmolpmmmmmmknmnmmmmmmqnlnmmmmmmmmmmmklmpnmlmnmlmmmmmmmmmlnkoll"
     "lmnmlnlmmmmmmmmmmmmmkmlnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmllmmmmmmmmmmmmomknmrmklmlnlmmmmmm"
     "mmmmmmlnlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{0, 384}, {5, 647}, {7, 21}, {18, 640}, {15, 384}, {11, 75}},
     "lnonnnokmmonkmmnmmmmlmmmmnnmnmmnnnmnlmmmnmnnmonmmmmlkmlollmlolmmmmlmlnlnmmmlpmmmmmmmmmmmmmkkm"
     "mmmmlnmmmmmmmmmmmlommmmommmmmmmmmmmmmhngmmnnnlmmmmmmmmmmmlmmmmmnmmmnmnmmlnmlmnlmlmnmmmmkmlmml"
     "mmlmnmmmmllmmmllnlmmmmmlllmnmlmlmmlmmmmnlmlmnmmmmmmnlmoolmmkmnmmjlpomjmmomknlnmimnlmolnmmnnnl"
     "mkmmlmomllmaogimnmolmomnmmknmnmrmlmmlmnkm"},
    {{{0, 704}, {10, 42}, {18, 533}, {16, 960}, {13, 800}, {21, 0}},
     "omlmnnnkmmpmlnmknknmopklnpoiknqolomlonnnlmmnmmnmmmhmlkmnmmmmklkmmpnmmmmnmnmllmnmnmmmmmnlmmono"
     "mmlmlmmlmnmmlkmnmonllmoomimmlmmmmmmmmnmnlmkmllmmmnlmmmmmmonlnmpmolmmmmkmmmmmmmmmkmmmmmmmmmmmm"
     "mmmmmmmmmmoojmmmmmmkmnkmmmmmmjnnlmmmmmmpknlmmmmmmmlmlmmkommlmnlmmmmmmmmmmmjlnnmlmmmmmmmmmmomo"
     "mmmmmmnmnlmmmmmmkmmmmjmmommnmnmlnmnmqkllm"},
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

/* The oracle takes about a tenth of a unit. So it is asked first if the best engine is expected to
 * take this many units: without a solution, others may take very long. */
#define UNITS_FOR_VERDICT 16

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
    c.verdict = least > UNITS_FOR_VERDICT * unit;
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
