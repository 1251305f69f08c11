/* selection.c: which way of a projection is tried, and for how long; see selection.h. */
#include "solve/portfolio/selection.h"

#include <math.h>

#ifdef FMB_ABLATE
const fmb_choice *fmb_selection_forced;
#endif

/* ---- the table ------------------------------------------------------------------------------- */

/* What trees tell, as logarithms to base 2 in parts of one: the work of the best engine, in units;
 * that of each engine over it; and time with bounded elimination first over time without. */
#define FORETOLD(T)                                                                                \
    T(BEST, "best")                                                                                \
    T(RAYS, "double description")                                                                  \
    T(ELIMINATION, "elimination")                                                                  \
    T(QUERIES, "support queries")                                                                  \
    T(BOUNDED, "bounded elimination")

#define FORETOLD_IDENTIFIER(id, name) FORETOLD_##id,
enum { FORETOLD(FORETOLD_IDENTIFIER) FORETOLD_COUNT };
#undef FORETOLD_IDENTIFIER

/* Features are rough logarithms, too, in so many parts of one; a weight is in so many of a part. */
enum { MARKS = 256, PARTS = 32, FINE = 128 };

/* Trees add to what weights of marks tell. A tree asks whether marks are above thresholds. Its
 * answers, the first one as the highest bit, are the number of a leaf: a letter for each number
 * that is told, NEUTRAL if it adds nothing. */
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
/* 14968 problems of 91 families, seeds 1 to 183020, ways as of commit be4293cf.
 * Time over that of the best method alone: 1.115 on families seen, 1.211 on others. */
static const int START[FORETOLD_COUNT] = {-3400068, -472170, 834583, 713908, 47988};
static const short WEIGHT[FMB_FEATURE_COUNT][FORETOLD_COUNT] = {
    {7728, -2286, -2746, 3766, -82},
    {1022, -1424, -256, 926, -127},
    {-2703, 2562, -200, 548, 30},
    {-2404, 1083, -208, 425, -15},
    {-1387, -263, -1701, -304, 153},
    {1694, 666, 683, 119, 272},
    {-5263, -5819, -1280, 805, -827},
    {-10027, 6173, -1877, 433, -918},
    {-516, -2401, 2003, 131, 50},
    {-1219, 4471, 6856, -12270, 5362},
    {3063, -1424, -1411, -549, -33},
    {-4761, -1877, 2550, -719, 422},
    {688, -83, 1596, -302, 32},
    {76, -512, 534, -103, -11},
    {-3, 532, 415, -282, 36},
    {815, -407, 1228, -1928, -128},
    {2266, 108, 974, -739, -34},
    {1402, -1300, 1701, -1073, 158},
    {1041, 184, -83, -491, 77},
    {-284, 1159, -1420, -5, -46},
    {4636, -491, -445, 154, -144},
    {355, 214, -274, 291, 258},
};
static const tree TREE[] = {
    {{{14, 2217}, {6, 54}, {14, 1352}, {19, 992}, {0, 384}, {5, 496}},
     "mmmmmmmmmmknmmlmmmmmoqjllprhknnsimmonjlnmmmmmmmmmmjknlmmmmmmjqolmplmmmlqnkl}mphmtkmnmjkmpmmmn"
     "nminlompjimmilnnmnnllmgjponlmklmmonomjnlmmkmjmmgsqlmjrpmmnpnjmpjokmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmgkqonrlmnmmhkrnzjllmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmplomiompmrkmpmhqqnnumlnmvmlnmxglnm"},
    {{{14, 2397}, {6, 67}, {5, 345}, {14, 1248}, {5, 530}, {8, 99}},
     "liommmlkmlmmmmmmmmmmjkmmmholmkmmmmmmmmmmntjnmnshkmikklniijnnpolnmnsojnnpqhmrhqmmsiplmsmkmlmmm"
     "mmmmmmmmjnkmnnkmmmmmmmmmmmmnlmnmokknmglommhkosmknmmmlnolmommlmljnommmmmmmmmmmmmmmmmmmmmmmmmmf"
     "flqnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmujipmtkmommmmmmolmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmplmmmkljomtkkmm"},
    {{{12, 1988}, {4, 563}, {0, 640}, {11, 118}, {7, 20}, {12, 1040}},
     "jmkonrlolmmnmnljojkmlpjnmimmnmmlnlmnlmmmnmmmmprjnmgsopmntkpmxlpimgjqlmomoknhimlnigmmmilpnmmjn"
     "lmlkmnmmmmmmdinslpklmmqkmlmmmmmmmmmmmjqlqljpkqmmmmmmmmmmmmmmmmvqjnmmmmmmgsgkmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmopiommmmmmonllmmmmmmjllommmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{14, 2217}, {3, 1304}, {8, 187}, {19, 1056}, {11, 134}, {6, 85}},
     "jplollmlmmminknmmnmmonokmllplmmojlnhkppmmmmmmsnhplnlmmmnmmmmoqnlmmpjnmksgkmklmnmkmmommmmmmmmm"
     "mmmmmmmprlklnpjmmnollmhjmsmmmmmmmmmmmmmmmmmmmmmkopkmmmmmmmllmmkkmomknmomskmommmmmmkpmnlpmpnmw"
     "klmmwlmmmlmmmmmmmmmlmlnmmmmmmmmmmmpoknmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmoljpmsljmmuhllmfjlp"
     "mmmmmmmmmmmmmmmmmmmmmjgmonmmmmmlmmmmhjmnm"},
    {{{14, 2244}, {6, 54}, {15, 1056}, {0, 576}, {11, 118}, {15, 704}},
     "lolmmmqmlloilmnmsgknksmrmrknmmklmlmrommmmmmmmikollmmmmmmlmmmmmmmmmmmmmmmmmmuprgmmlmmmrqpjmmmn"
     "mmkllpmlrlpmnmolmmmnkmhhppmmmmmmepijmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnmnmnllonmmmmmullnlkomomm"
     "mmnmmmmmmslllmmmmmmjglonmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmrkmnmsljomnoommfklpmmmlomommmmtkllmmiml"
     "mmmmmmmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{5, 792}, {6, 246}, {7, 16}, {13, 896}, {14, 1352}, {0, 512}},
     "omlmmjlmnmmmnmmplmlmjkspmqmolmkkplmrkmlmpklmlmmnnmkonkmmmmomcmgknnskomonnlnsmklmjmmomkolnmjpi"
     "lmlokmmjmpnmonlmmpollmsmjnmmmmmmmmmmmmmmmmmmmmmnmnmmnmmmmmmlmmmmmmmmmllmmmmmmhnjomfplomjmmomm"
     "mmmmjrjlmkoklmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlnjnmjnlnmlmmommmmmmnmlnmrmln"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{0, 384}, {14, 1882}, {7, 20}, {19, 896}, {1, 832}, {8, 0}},
     "klmnmqoknmmmmmmqolrnknpmmlknnnhokmmommmnnmnlnrllnmmmmmmqlnlmcndkmojknmmmnnmnnjllknikmimllmmmm"
     "mmkmkomnqmnmiqommpnlnmnmnomkpmjmlnklmmmmmmnkmmmlnmmmgrrmmmmmmmioonnkolnmknkmmjmmnmennnnmmpmmm"
     "kqnmekmknnmnlmmnnnmmlmmmjpommnmnlm]nfgmoklmnlmnknmoknllojmmimklmgokpmkmkmmsklmmojnkmmmkqmpjml"
     "miqmlnjmllmjonomlkmmmlmnnmomlmmmmmmmlmmmm"},
    {{{19, 704}, {15, 256}, {14, 1760}, {0, 384}, {19, 1040}, {1, 928}},
     "tmomnrookmmmmmmmmmmmolpknpmojmmmmmmmmmmmokmkmolnmmmmmmmmmmmmkmnmmnjokmmmmmmmmmmmnmlmmlonpmmmm"
     "mmmmmmmkmnnnnmnmmmmmmmmmmmmmmlmmunkrmmmmmmmmmmmmlmnmmmmmmmmmmmmmmmmqlnpmnmmlmjmonmmmmmmlnmomk"
     "pmnlklpnnmmmmmpljkmmmmmminmnmmmmmmknjlmkpknmrkgmmmmmmmlklnmmknnmlmlmmnpkllkmlnmkmnnmnlolmmnll"
     "mkomlmrkjnmjqpnmlnmnnmlmlmllnmnrknlmklmmm"},
    {{{1, 1353}, {4, 402}, {19, 1136}, {0, 576}, {11, 118}, {20, 0}},
     "klmnnmmkommnknlomnmmltlommnmomlnllmokpjmlqklmollmmnshkmpnnlmnmnmmnmmmmnnmnmqmmlmmlmmmmmmlmpkn"
     "lnhmokmnqlnmjplqmplmmmnjmjmonnlmmnlnmkmlomijlomolmmmlnkpmhjoomommmmmmnmmnmmnmjlqpmvlormmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnllmmmmmmmylnjmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mkkqlmmgmnmmjkmmmmmmmmmmmmmmmmmkmlnmmmmmm"},
    {{{14, 2305}, {1, 960}, {5, 530}, {11, 46}, {21, 0}, {10, 102}},
     "olmnmmiplnmmmmmknmpmmmlnmmnmmmlnmlmmkmlnhmlkmrnmnmnmmmmmmjlmnlpnmrnkmmhnmmllllomfimjnogqjnpnm"
     "lmkmmnlonmnmkskmlopmknlnlkmommmmmmmmmnnnkmlkonneiqqmrkpnmjlommokmmmqlnlmlnqlmolnlmmmnnmmmmmmm"
     "mmmmrkpllmmmnmmmmmmmmmmmmnlompmlmmmmmmmmmmmmomlnmmmmmminmpmmmmmmnmkmmjklomuliomommmmtllmmmnkp"
     "mmmmmmmmmmmskjmmmlllmijlnmmmmmmgilommmmmm"},
    {{{5, 323}, {19, 992}, {18, 1388}, {0, 512}, {7, 16}, {13, 800}},
     "pmlnmmmmmmqknkmmmmmmmmmmmmmmmmmjnjlllnmmmmmmmmmmmmmjmlmmmmmmmmmmmmmmmmklnmmmmmmmikmllmmmmmkmj"
     "mkmmmmmmmmmmmmmmmkmkokmmmmmlimnmmmmmmhmlmnmmmmmmmmmmmmmmmimkpmmmmmmmmmonlmqmmnlllmklmmnhonnmn"
     "pilmmmnnmmoknminimmmmnmmkpllmmmlkmhoknmqknlmkmmpmnnkomomnkmknonmlnmlmhoilmnlmlmpmnkmmlmmnqplm"
     "mplmmmnllnmknplmnnnmmpljpmsklnmolkqmtllmm"},
    {{{12, 1988}, {4, 554}, {0, 640}, {19, 1088}, {14, 1416}, {1, 928}},
     "mmmnmmmmmllmmmmmlmnmukpknmnkmmonplmonnlmkonnmkpmlmkonmmlmnlmnnmnmglonnnmnmmwjmjmnjmommjplnnll"
     "mmnjkkmlkmnmlmlnllmnmmjlmnmnomnmmnmnllmmomjpkqmnplomoolomslkmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmipjlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmkmmnmmmmmmooinmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{1, 1353}, {6, 81}, {4, 362}, {20, 0}, {5, 512}, {11, 46}},
     "lnnmmlmkommmmmmmjnomlmmlmpjnkmmmmmmmjqpmnmmmmnokllupqkmlmmlmlmmnmkommmvkllmpmnmmjmnnmnnmkmknk"
     "mmkmknmknmnmpllomomlnmpmmklmknmmommmmkmnlmlloomlmmnmlnllmpllmmklnmmmmmmmmmmmmmmmmmulnkmmmmmmm"
     "mmmmmmmmmmmmmmllplnmmmmmmmmmmlklmmohlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmilqommmmmmmmmmmmmmmmvlor"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{19, 768}, {14, 1200}, {5, 388}, {11, 118}, {0, 512}, {8, 109}},
     "qmnllnmmmmnknllmmmmmqonlnnmmlmpmnknmmmmmmmolmmmmmmjmpmnmmmmmonmmmmnlmmonnjmmmmmmplmlmpmlnmmnn"
     "nlmmmmmpknlonmmlmnknlnmmmmmmommmmmmmmjooommmmmmonnpmmmmmmkknlmmmmmmmklmlmljmlmmmmmmmmlmllmmnn"
     "kmmnljnlmlkmmnkmnnmmlmmmknlomlmmolnnlnmnnkmmmolmmimlomlmllmknmmmiqlqmnmlomlkpknllolnlkmkmnmkm"
     "mmmmlmlnolmnmlnmulnkmlonnmjlkomplmkmlkmnm"},
    {{{7, 146}, {11, 170}, {19, 928}, {5, 496}, {11, 46}, {21, 0}},
     "nmlnmknmomnmlmlmmllmlmknmknlmmnmlomlmjllnkomnmmmnmlplmmknlmmkmmlmomnmmnmonmolmmmmmmmmmmmmmojm"
     "lmnlpkommmmmmmmmmmmmomkmnmmmmmmmmmmmmplnlmpmmnmmmmmmmmmmmnmkomklmmmmhpinknoomlnoolmlnmmmnlnml"
     "mnlmmmmmmmmmmmmlmmmlmmnmmmmmmkmmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmknlmmmpmpmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{13, 1824}, {0, 384}, {12, 1040}, {15, 384}, {14, 1760}, {7, 3}},
     "nnmnmpmnmmonkmmolllmmljnmoljmlkninmkpnmnknonnpmmomkmnlmommlmmmommlmjmmmnmmmjpqnmjnnlmmmnlmjon"
     "lmkmmmmimlnmlmlnmkmllmlmmmmhomommnmnmmmklmmlkmmomonmmmllmnknmmplnlmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmkommmlmmnnhpmnminmnmkqknmmmmmmnpjomonmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mplllmmlmmmolimmqlmmmnmmmmmmmmmonjmmmmmmm"},
    {{{12, 1540}, {11, 98}, {7, 46}, {18, 624}, {12, 832}, {21, 0}},
     "gknmmknlnlmmmkmollmmjnmomjlkonnmolmnlmmmnlolmomnmmlllmmmmlnmnkmmnlomommnkmmmolmmommmlookllnol"
     "kmmnmmmlnoommmmmmomnnmlomklmonnlommmnomlmmlllnnnmlmmmkoknqkllmnknkmmmmmmmmmmmdohlmommlmmmmmmm"
     "mmmmonmnmlnlmmmmmmmmmmmmkoinnnmmmmmmmmmmmmmmrijlmnlmlnmmmmmmmmmmglmrmiklqmmmmmmmmmmmgjlmmejmn"
     "lmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{5, 792}, {6, 246}, {12, 1540}, {18, 568}, {13, 896}, {7, 20}},
     "ommmmmmmmmmnqlmoolnmmlmmmmmmmmmmolmnmllmfkmpminjnmklmrmnmlmnnlllmjlnlmklnnmmmklmlmmnmmmmmmlnl"
     "mmmmmmmlpkmmmmmmmomommmmmmmmmmmmmmmmmjllmnmmmmmmmmmmmmmmmonkmmmmmmmmmklmmmmmmlmmmmmmmmmfpjomm"
     "mmmmmoklmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmkollmmmmmmmmmmmmmmmmmmmnmmmmmmhoinmmmmmmplmmmmmmm"
     "mmmmmmmmmmmmmmnmmmmmmmmmmmmmmmmkomlmmmmmm"},
    {{{18, 1366}, {1, 928}, {10, 170}, {11, 118}, {5, 530}, {2, 768}},
     "mlmmmomolnkmnmmoollmnlmmmolmmmlnlnmnllmmmqmnlhrnmmmmmmmmmmmmmlnmmmkmnmmmmmmnmmmmllnmmmnnlmhmq"
     "nnnmnlmnnmlmlpkmmkmnnmmlnnmnlnmlkolommmmmmnlmmmmlokpljomommmmmljonnlmmmmmmnmmomlmmpmlmmknmmlp"
     "nmmmhpmlllmmnmmmmommnllmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnllnmmmlnmlllnmrljnmqnlpmtlkmmmmmmmgklo"
     "mmlmmmmoinmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{14, 2305}, {0, 640}, {4, 554}, {0, 384}, {19, 1072}, {1, 864}},
     "mmmmmnmmnmkolmmnommmmmmmmlmmnmpknlmmnmlmmmnnmolmmmkonnmllnnmmllmmljnkmnlmmmkmmmlmmmmmmmmmmmmm"
     "mmmmmmmkpmnmknmmmlpmompmmlmmmmmmmmmmmmmmmmmmmmmmmmnmlomommplomommomnmlmmolnlmmlmmmpmlmmnmmmmi"
     "ojnmmmnmmskknmmmmmmmmmmmmmmmmkkommmmmmmmmmmmonnmmkllnmmmmmmmmmmmmmmmmmmmmmmlmlmmlmkmmmmmmmkmk"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmpllmmmmmmm"},
    {{{1, 1353}, {16, 1560}, {15, 704}, {12, 832}, {0, 512}, {14, 1840}},
     "nmmmmmnlmmlmnnmkmnnmllmmmlnmlmnnlmmnlmmmlokollnkomkjmnmllopmoonlmlnnmmmommnnllnmmmmmmmmmmmmmm"
     "mmmmmmmopkmmmninlnmmmmmmmmmlmlllmmmmmmmmmmmmmmmmljmkjkmmmlmkmkkllnmmmmmmmmmmmmmmmmmmmmmjlonmt"
     "lnqmmmmmmmmmmmmmmmmmmmmmtmnjmmmmmmnknmmmmnmnlllnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmjnlmmmmmmmmmmmmmmmmllomnmmmmmnmnmm"},
    {{{18, 1539}, {12, 1184}, {11, 236}, {21, 0}, {4, 457}, {11, 46}},
     "kmnnmmmmmmlkmlmmnmmmlmlmmmnlmmnmmmmmmmlmmmmmmlnknmmmmmmomlnmmmmmmkknmmmmmmmkksmolkqmmklnnmmmm"
     "mmmolnmnmmlmmjnnmlmnlmmkmmmmmmmmmnlmmmmmmmtmkmmmmmmmkmnnmmmmmmgoollkolnmmmmmmlnmnmmmmmmkoknmm"
     "mmmmmnlnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmokolmmmmmmplnmmmmmmmqknnmmmmmmolkommmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmkommmmmmmmmmmmm"},
    {{{19, 768}, {3, 960}, {14, 1620}, {1, 832}, {0, 576}, {5, 496}},
     "onmmmlnmmmmlkmlmmmmmonomlknonmnmnlmkmnlmnlmkmkomlmlmmmmmmmmmolmmmsmmpmlmmmmmmmlmnlnlmmmmmmlnn"
     "mmmmmmmokpkmmmmmmlknlmlmnlmmmmmmmmmmmjonommmmmmolnmmmmmmmmmmmmnmmlmlmlnmnmmommmmmmksjomkmnmmk"
     "llomkmmnnimlklmlklmlmllmmlolmpmmlmklkmmimnnnkmmnlknllmnklnmlmmlmmqmomopjmmmmmmmommmmnnmnmkmnm"
     "mlnnmmmmmmmmnlomonklmlmmmmnlmmmmmmmmolnkm"},
    {{{11, 192}, {7, 34}, {4, 576}, {8, 99}, {21, 0}, {0, 512}},
     "kmmmmhmmmmmmnmmmnlmmnmommnmnmmmmlmmqlmlmonnnmnmmmmlmlnmlkoomknlonmmmmmlmnmmnnmmmommmmmnlnmmnm"
     "mmnmmnmlolmmlmnmnlmmmmlnknmpjnmnoimkmllolnlmlomklkmmllkmmkmklmkmkolooknmmmmmmlnmmmloolmpmpmmm"
     "mmmmmlmmmlmlmmmmmmmmmmmmmmmmmmmmmmomnmmmmmmmmmmmmmmmmmommnmnjmlmkmsmplkolnplmnmmmmmmmllmmmknn"
     "mnmmmmqmlnmmmmmmomnmmmmmmmmmmmmmmmmmmmmmm"},
    {{{19, 640}, {7, 20}, {5, 682}, {14, 2099}, {11, 134}, {0, 512}},
     "pomllmmmmmnnmllmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnlnlmnmnmlomn"
     "moomnlommmmmlmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmnmmmmnlmmmmnmknmmmnllmmm"
     "mlmmkklmmpkllmlnnmmonklmmmmmmsnnkmplmmmommnmmnmmmlnmmmmmlmmmnmnmmlmmmmlmlmlnnmmmllomkqomlsmkm"
     "mbofkmkmlmmmmmmmmmmmmmnmmmmmmmmmmmmmlmmmm"},
    {{{0, 704}, {10, 42}, {18, 624}, {19, 1340}, {11, 56}, {4, 457}},
     "llmmmimjkmnmlmmknmqmjmnmmjlkmnmmmmmlmkomomnmmlmnmmlnmmmjkmmmkmjmmnolnmmmmmmkkkpmlnnnmnlommmml"
     "mmnlmmmmmmmmlllmlillompmlkmjllmmnmmmmmmmmmlnmmmmmmmmmlomnolllmqmoknmmmlmnmmmmklkkmmmmmmmmmmmm"
     "mmmmmmmmmmqphmnnnjmlnnlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmknnmllnnnmmmmmmmmmmmlmmmmnmmo"
     "mmmmmmmmmmmlmnmlomlmmmmmmmmmmmmlmmmmmmmmm"},
    {{{5, 792}, {2, 800}, {16, 1560}, {12, 832}, {11, 46}, {14, 2099}},
     "lmnmmknmpmnmmmmmmmnmlmmmmolmnmmmmmmjnmmmmmmmmmmmmmmmmmmmmmmmmokmmomjnmmmmmmmmmmminlnmjolommln"
     "nmlmnmmqnolmommlmnnmlmommmmllmlmnknlmmmmmmmmmmmnllmljklmmmmmmmmmmmmlmmmmmmmmmmmmmmmmmmmkmlomq"
     "lonmmmmmmlnmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmjojmmioknmmmmmmpmln"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{3, 800}, {4, 384}, {10, 157}, {11, 118}, {18, 1036}, {0, 384}},
     "mnnmmkmommomlmmknnlmmnnmmnomlmnmmnmmmmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmonnnnmmmmmoml"
     "lmmmmmmnnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnnmmmmmmmmnmmmmmmmmmlllmmlmlnmknmmmlmmmmmllmml"
     "nlmmqmlnmplmllknkpnnllnmknjnmmlkklnmlmmlklnnnmmmmojommmmmmmnmnmmlnnmmnmlmmnmmomlmmnmllmmmmlml"
     "mommmmmnmmlnmmnmkpnnmnlnmnmkpkokmnmmjkokn"},
    {{{0, 704}, {10, 42}, {7, 20}, {6, 174}, {14, 1352}, {21, 0}},
     "lmknmnmlmmjmlomolnmmjlqomnlmmmmnmmmlmmmmomllmnmlnmojnmnnnlnmengjmmmmnmonnmmkmnlmmlmmmnmmmmnmn"
     "lmmlmmmonmmmnolmlonmomnnmlmmmmnmmmmmmmmmlmmmmmmpmponmlnnmrllmmkmmkmmmnjmmqpimmmmmmnmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmllpmmmmmmmmnnlmmmmmmmmmmmmmmmmmmmmmlmmmmmmmmmkmmnmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mkmnmmmnmommmmmmollmmmmmmmmmmmmmmmmmmmmmm"},
    {{{7, 146}, {18, 650}, {14, 1328}, {11, 170}, {21, 0}, {4, 475}},
     "lmmmmmmlmmmnlnlnlmmmllmllqlnlnmmlmmmnnlmllllnrmolmpmmmmnnkmmlmmmmllmnmmlmnmlkmnmkmpmnnmnpmnln"
     "nmlkommmmmmmmmmmmlmmmmmnnmnmmnmmnnmmmmmlmmlmmmmlmlmmqllmmnmommkkolmjnmmnmknjnnkmmmmknlnmmmlmn"
     "lmmmmmomnmmnmmmmmmmmmmmmmmnlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmnmommknlmknnmmkomnmlmmmmmmmnmmmmmmmmmmm"},
    {{{7, 146}, {4, 512}, {21, 0}, {7, 20}, {12, 1288}, {6, 90}},
     "mmnlmmmnmmlllnmllpmmlmmmmnmlmmimmmnjnjjmonlmmlmlmmoknlmomnmmmlnmmlnmmmmmmmmmmnmmmmlnlolkmmtpk"
     "kmlnlnmmmmmmnmmmmknmnmollnmlmnmmkmmmmjlmmmkmmnmmmmmmolmmmmlkmmklommmmmmmmmmmmmmmmmmmmmmmonnml"
     "knmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmolnmmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnjnkmnlnlmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmlmmnmllnmmmmnmmmmmmm"},
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

/* The inverse of that, but for the 1. */
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

/* The weighted sum of marks, rounded towards 0: linear, so that it holds beyond what the fit saw.
 */
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

/* Entries of a row, and the bits of its numbers, tell what a step of any engine takes. */
static double unit_of_work(const fmb_features *f)
{
    return 16 * (double)f->entries * (double)(64 + f->minor_bits);
}

/* A bound, or a row that names few variables, holds up most directions. */
static bool tries_recession(const fmb_features *f)
{
    return 4 * f->entries >= 3 * f->rows * f->columns && f->bounds == 0;
}

/* Bounded elimination that does not answer has cost no more than the best engine was expected to.
 */
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

/* In so many dimensions a hull takes longer than to find out which of many rows are irredundant. */
#define SHORT_QUERIES 4

/* To find out which of many rows are irredundant takes as long as some queries, where few variables
 * are kept; of long numbers, so it does of fewer rows. */
bool fmb_selection_keeps_rows(const fmb_elim *e, size_t before, int kept)
{
    size_t most = fmb_elim_minor_bits(e) > FMB_LONG_MINOR ? before : before * (size_t)kept;
    return kept >= SHORT_QUERIES || e->live.size <= most;
}
