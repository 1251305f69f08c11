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
/* 19674 problems of 91 families, seeds 1 to 280052, ways as of commit 93a3b18d.
 * Time over that of the best method alone: 1.147 on families seen, 1.251 on others. */
static const int START[FORETOLD_COUNT] = {-1931183, -1088838, 1529987, 237732, -252140};
static const short WEIGHT[FMB_FEATURE_COUNT][FORETOLD_COUNT] = {
    {7110, -1841, -3039, 4055, -200},
    {1626, -1489, -225, 1199, -162},
    {-3345, 3400, -349, 765, 351},
    {-2802, 1206, -459, 682, 65},
    {-1095, -372, -1429, -238, 95},
    {913, 1213, 739, 158, -63},
    {-4707, -5739, -2571, 1463, 119},
    {-8302, 4385, -1696, -1328, -861},
    {-726, -2297, 1597, -22, -45},
    {-8847, 4122, -1356, -13220, 103},
    {3083, -983, -2020, -508, -267},
    {-4071, -2656, 2445, -1208, 490},
    {850, -415, 1646, -521, -36},
    {303, -460, 472, -108, -35},
    {-14, 466, 478, -347, 102},
    {1938, -1543, 1268, -2360, -110},
    {2365, 5, 1230, -791, -54},
    {2545, -1434, 1370, -1076, 72},
    {617, 411, -335, -203, 41},
    {-826, 1623, -1734, 48, 133},
    {4634, -289, -841, 203, -52},
    {126, 567, -483, 699, 186},
};
static const tree TREE[] = {
    {{{14, 2304}, {6, 57}, {2, 1104}, {19, 1056}, {11, 118}, {0, 576}},
     "innomismsmlmmllkjnkmnulklooopmlvfjmrqkpmmmmmmmmmmmmmmmmmmmmmjlojnrlnlmkkmomwmsgmlllmmktlpmmmm"
     "mmnlmkmomokmupknmglnpmfhpqmmmmmmmmmmmmmmmmmmmmmepjimmmmmmmmmmmmmmmmmmmmmkmmnmmmmmmmmmmmkklrnl"
     "mlom}jlolnlmmmmmmmmmmmmmmmmmmmmmmmhbmrnmmmmmmmmmmnimlmtleqmeqmpmpniolmmmmmyjmnlqmjomfhpqlulnk"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{14, 2206}, {3, 1352}, {12, 1264}, {11, 105}, {14, 1320}, {7, 21}},
     "nkmnmnlmnljolmmkpmlmnqjmmomlnlnmnmmnknjnmjumndlflnompkmmnllndlpsnpmnnmehqolmkokmmmmmmlnlnmkmp"
     "jnnqnkmmqkmnmnmmmnmmmmmmmmmhmkonpnhompsimmmpjlljmjnnqrkombiowmmmmmmmmmmmmmmmmnmkqmgonqmmmmmmm"
     "mmmmvnqlmympklmmmmmmmmmmzjknlpmlnmmmmmmmmmmmlmlnlpmnmmmmmmmmmmmmjemqnilmqnmmmmmmmmmmpmkqmmmmn"
     "mmmmmmmmmmmljknnijkommmmmmmmmmmhflqmmmmmm"},
    {{{18, 1524}, {5, 497}, {11, 48}, {19, 960}, {14, 1360}, {0, 384}},
     "rjmomljpmmllklmhonpmmkkonqjnlmjonmmnkmmmrmlnmnnmmlolljnmlmjnpmhmlnrjmlisolmopmjmikponjkolnkol"
     "kmipjnmglnmmijpknksqlmpkmjmkmmrmjmlonnnoomilmnmlnnqmjlopnmmrpmriolmmmmmmmmmmmlmlkmbrnrmmmmmmm"
     "mmmmgpnlmjnksmmmmmmmmmmmmnllmnmmmmmmmmmmmmmmmnnmmommlmmmmmmmmmmmmnilmisirmmmmmmmmmmmsnmmlvikn"
     "mmmmmmmmmmmhrmllmnkmmmmmmmmmmmmopjmlonlnl"},
    {{{14, 2376}, {6, 73}, {19, 1040}, {11, 118}, {0, 384}, {18, 1060}},
     "nmlmljomlnkpnplfpnrmnmlmlmmmmmkknnnmhoknppkmlirpmnpomkmlpmmmpsglmlmmmmmpklmrlnklnkmnmnmlkmmlm"
     "nmlnknmnmmpmononmmmmmmmllkmknmmnjqpnmmkpkmsimlmjknrmfjnnmekormhinnmmmmmmmmmmmmmmmmhmnmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmjmonmmmmmlhlqmmmmmmnnnmmmmmmm}jjnlmmmmmknlnmmmmmmhmknmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmqlkmmmmmmmllkmmmmmmmmmmmmmmmmmmmmmm"},
    {{{12, 1986}, {4, 560}, {18, 1392}, {5, 512}, {1, 960}, {19, 1040}},
     "nlmmmploknnomlmlrkkmkmmmmnnnlmnjppnololmiomnmnmnnmgplomlnirmmoknmtjolmokiomtilnmoklnmoklmnnkn"
     "lnlmlllilonmhkqnmmmmmmhkmrmlknlmjoqmmofnhmjhlomlmkkmokmnmmmmmmgjlpmmmmmmmmmmmmmmmmmmmmmmmmmmn"
     "plmmmmmmmeqgkmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmjlnonmmmmmmmmmmmmmmmmqmmmmmmmmmmmn"
     "mmmmmmfqmpmmmmmmmmmmmmmmmmqogommmmmmlmmnm"},
    {{{19, 704}, {1, 1344}, {4, 384}, {7, 0}, {14, 1360}, {15, 384}},
     "opnkmmmmmmponqmmmmmmpnokmmmmmmmlplnmmmmmpnmmmmmmmmonmmmmmmmmrlpmmmmmmmokolmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmkomlmlnmomfqlnmlnknmlnmlmk"
     "mkpmjnnlmoklnmlmonmmkpnmknkmmplolmmmmnmkmjmmmmlmmlonlmmmmmmmmmmmmmmmmskssmmmmmmmmmmmmmmmm}kpi"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmjjknnmmmmmlhomn"},
    {{{6, 246}, {4, 560}, {15, 256}, {12, 928}, {7, 21}, {14, 2040}},
     "nonkmlmmmmplolmfooplinkkminkmmmolnmirkqmkmlnmgplqmmmlmmiqnomnmolmpknlmlnjlmlonmmmmmmmmmmmmpjo"
     "lmkknmmjlnmmmlmnmqlknnomjnmilmlmkhnmmmjnlmjjnmnhloomkknomnlmmmllnmmmmmmmkomnmmmmmmmmmmmksjome"
     "ukrmmmmmmmmmmmmnlmmmmmmmmmmmmmmmmmomolmqnknmmmmmmmmmmmpnmmmmmmmmmmmmmmmmmmllmlmipfpmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmlqmnmrnjnlmmmmmmmmmm"},
    {{{5, 790}, {14, 2241}, {19, 1296}, {8, 147}, {12, 1424}, {19, 1088}},
     "mmmmmqlnkmilmkmkkonmlmknmmqmlmmmmmmhnkommmmmmqrklmmmmmmnoknmmmmmmnnnkmmmmmmgkkqminmomukmnmuio"
     "lmrllmmlmkmmrnnlmmmmmmomlmmmmmmmpmkqmmmmmmqlinmmmmmmljmnmmmmmmeilommoiommmmmmolnkmktmkmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmhpglmmmmmmmmmmmmmmmmmmmmmkpipmmmmmmqmiomlnmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{5, 336}, {6, 73}, {4, 336}, {7, 16}, {15, 512}, {14, 1360}},
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmjjmlnmiolmkjmmmlmlokimknlmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmpnmmmqnlnmmmmmmmmmmmqlnllnjmlmmmmmmmmmmmmmmmmmmmmmmjpnm{koimmmnlml"
     "mnlmljmonphpmmmmmmmmmmmmmojmnqnmlmkpmpmkompmnplmlnonlmlnllmkpmomlllomkmkmmnomkmklplnlklnnoimk"
     "mlloomlmlmmmjonmolommmmmnmnmllmjmhlmlpnmm"},
    {{{6, 241}, {0, 576}, {15, 704}, {14, 1890}, {12, 1232}, {11, 105}},
     "nlmmmmlmmmkkmlnlmoqmknmmmnmnlmnlmlmhmmmlnomlmnrilmrqnkljlkommlonmnmnnmmllnmhjlqmnpnnmlmmlmstj"
     "nlpomlmfnnpmnkmkmnqkpmmmmkmmmmpmrjplnsnnkmcmprnknlnmrlmmmtkkmmlhmmmlolnmlmmnmnnomminonmirkoml"
     "nlmmqmlmmjpnllmmmmmmmmmmgonkmlmlmmjnmnmmmmmmmmimmmokmmkpmmmmmmmmtrilmmmmmmknmmmmmmmmjsjommmmm"
     "mmmmmmmmmmmmmmlmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{12, 1986}, {0, 384}, {18, 1392}, {19, 992}, {7, 11}, {1, 896}},
     "kmnnmqmormomlmmplmlmmnommopmmmkmknmmnkmlkmlllllkomnmlkmpimmnlnolmnljnmhprmmlknlnmnlmmjlnnmmlm"
     "lmmnnmmokplmmlmlmmmmmmmnmmmkolpmikknmjnmomklnmmrjnmmllkpmoklnmnkkommmmmmmmmmmmmmmmmmmmmirlomk"
     "oknmjlonmmmmmmmmmmmmmmmmmmmmmmmmmmirlpmmmmmmjnmommmmmmmmmmmmmmmmmmmmmmmmmmqlmkmhnjkmmmnlnmmmm"
     "mmmmmmmmmmmmmmmmmmmmmqkinmmmmmmpnkmmmmmmm"},
    {{{12, 800}, {15, 256}, {14, 2040}, {19, 1136}, {5, 533}, {11, 67}},
     "nlommpmolmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmminoolnllmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmkknnlnlmmmmmm"
     "mmjknpncgkinnmmlmmmmmmmmmmmhnnpnkomnmlmmmmmlmnmepmqmmmommmmmmmmmmmmnnlmmnmmmmhpmnmlqknmjmnnmm"
     "mmmmokmkmmmmmmiplpmlmnmmgskpmnmmmmkmlnnmmmmmmmhnmmmmmmnlmnmlmlmmllmlmmlnmmonmmmopkkmlonlmllno"
     "mkmmnmlnnkmollmmnnmnmmmmnmpnplmrllmmgjnnm"},
    {{{5, 790}, {16, 384}, {14, 1232}, {12, 1592}, {15, 768}, {5, 512}},
     "oomkmlmmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmononnhmonmmmmmmmllnmmmmmmmmmmmmmmmmmmmmmmmmnmkmonmnsk"
     "lnllkmnmljpmimlqmmmlmmflnqmmmmmmnmmmmkmmmmvmpkmkommmlmmmmmllmmhjmqmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmjnmnmmmmmmgjnmmmmmmmmmmmmmmmmmkhnlmmmmmmmnlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmpoknmmmmmmokjlmmmmmmmolmmmmmmmjsjlm"},
    {{{4, 384}, {10, 135}, {11, 118}, {0, 512}, {14, 1780}, {7, 0}},
     "kmpnmlmlmmnllnmlkklmpmklmklmomkpkomhnmnmknnmmnpmmlpnmnlmmklmmnmlmmmmlmpnkjmmklllhnjqmpllmmili"
     "nmonkommmmmmlmmmmmmmmmmlmmmlllomollmnlmlmmnlkommnlkmlmmonlnllmpjommnmommklllmmmnlmmmmkmukojmn"
     "mmmmpllnmmmlomknkpmnllmnflnnmloollelnpmnnmlmljmmmsjmlmqmklnonmmlkppmmlnolmoonlmmpmpkmnommmpmq"
     "mnmllmmknlnlmlmmilmjnnnmlmljnmmlmnmmkjmkn"},
    {{{5, 346}, {8, 51}, {16, 896}, {14, 1320}, {0, 512}, {13, 800}},
     "omnmlmmmmmnlnmmmmmmmnkmlmmmmmmnknmmklmmmmjqlnmmmmmliplnlmmmnngnknmmmmmlinkmllmnmqnnmmmmmmmnnm"
     "mlmmmmmnmmnmmmmmmknmpmmmmmmmjlmlmmmmmkjnommmmmmkllmmmmmmmllkqlmmmmmmmnnnhmplmklnmmonllmmnllmn"
     "lnlmjononookmmklllmillnmklmmmqrlolmnmmmlnlmmklmnmonknmnmkmmmmponknmommmllmmlmmmlkokmmknmmpljj"
     "momklmmmlomlmlmmqophmmoolmimnmmpmlmmtkojm"},
    {{{0, 640}, {15, 576}, {10, 49}, {7, 21}, {13, 800}, {14, 1360}},
     "kllnmiplommlpnmmmmmmnmlonlmmmmdmgimommmmnnkmmlklmmplpmnmkmkmmlmmmmmmlmnnlpmpllmmqoiknrmmlmmmn"
     "nmlmlmmoolmnskkmm_qckmknnmmmmmmmlmnnmpnmlmqomlmlmlnlknmmmqpmimqoolmlmnkmlnmmmmnlmmppllmoommml"
     "nolmnommmlnmkmknlmmnnlmmmmmmmqnmkmkpmnmjomommqlnmoolommmmmmqmnlmlqrflmmmmmfjnmnplmlmmmmmmmmmm"
     "mfknqmvkmjmmmmmmmmmmmlomnnpmmlmqnlomommmm"},
    {{{1, 1344}, {19, 1216}, {4, 409}, {10, 135}, {11, 118}, {6, 81}},
     "knnommmmmmkommlmnmlmjpkomklkommkmnmnmkmmlmmmmmlmmmojmlmlmnmmlnnnmnomnlljnkmmmmmnqkmmmjmklmopj"
     "lmmmmmmnnkommmmmmkqkkmmmmmmonlmmnnlmmommlmhkmqmnmommmmnmmmmmmmmmmmmmmmmmmmonmmmmmmplppmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmlmmmmmmmmmmmmmmmmmmmmmmmmmmmomnmmmmmmmtmllmmmmmmmmmmmmmmmmslokmmmmm"
     "mljomnmmmmmkkmnmmmmmmolnnnmmmmmmmmmmmmmmm"},
    {{{6, 254}, {14, 2206}, {0, 640}, {11, 118}, {5, 533}, {1, 960}},
     "mmmmmmmmlmmmmmmmlplmnlmmmlollmlnlnmkknomnrmpmpqmmmpqlmmsnklmmmmmmnnmnmjlplmmmpjmolmnmmllnmplm"
     "mmpkjmmonplmrklomjommlhllomglnmmkmnjmnnmmmmmmmmqllmmomlmmlmmlmokmkmnnmnmmmmmmmolmmmlmlmmmmmmm"
     "mmmmmmllmmmmmmmmmmmmmmmmnolmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmqmlomqoknmmmmmmmmmmmmnmmmmmmm"
     "mmmmmmmmmmmlmmlmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{19, 1384}, {8, 147}, {14, 1780}, {0, 384}, {1, 832}, {19, 1088}},
     "nmmnmmlmmmmmnmmppnmmlmmmmokolmlmnmmnmmmmlnnlmhqonmqkknmnnlmmlmmmmqklmmmlmmmnlmmmolkmmkkhmnmlk"
     "nloolnlllmmnmknmnmlklmoomlmkpommgopnmlmkmmlommmkmnlmolnkmmkkmmknnlmmmmmmjqmnmmmmmmmmmmmmmmmmq"
     "lllmmmmmmpnkmmmmmmmiolpmmmmmmmmlmmmmmmmnminmmmmmmmkiommmmmmmmmmmmmmmmnljmlmmmmmmmmmmmmmmmjlkn"
     "kmmmmmlnmmmmmmmmlknmommmmmmmmmmmmmmmlkmnn"},
    {{{19, 768}, {15, 256}, {12, 1040}, {0, 512}, {18, 1392}, {4, 451}},
     "onnlmplnlmlmmnmnmmlnnmnmmllnlmjnnllknnommmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmpnmomnlnlmmnm"
     "nmmmmkmnmnlmmmmmmlnnommmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnmmommlmlnnnmnmlmmlmmkmm"
     "mmlmlmmlmlnmommnlmmmmmmmkomomlmjmmholmmlpkomionnmkoknmlmlnmmmmmmkmkmmlnnlmlmmmmklnmmhpmqmkmnp"
     "mnmommlmmmmolmlmlmnmmolllmqmlkmmnlnmqklom"},
    {{{0, 704}, {4, 570}, {12, 832}, {14, 2065}, {8, 85}, {21, 0}},
     "mmnmmmmnlmmmnnmlmlnmgqmsmkonpmmmmmmlnkomkmlmmmmmmmmnmmmnmmmmollmmmnmnmnmolmnlllmmipknmnmnlomm"
     "mmklmmnognjnlnnnlmmmmmnknlmolmnmkmmmmkljmnlmlmlrkklmnmmmmjonmmkmmmmmmmmmlnnlmmmmmmmmmmmlmmmml"
     "mnlmmmmmmmmmmmlmnkmqnolnmmmmmkqqhmmmmmmilnjmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "monlmmnompnmmmmmmmmmmlmmmmplllmmmmmmmmmmm"},
    {{{5, 790}, {0, 384}, {18, 624}, {12, 1480}, {11, 67}, {21, 0}},
     "nmmmmnmknmpmlmlomkmminfmmjmkmmlmlnmmllomommmmmmnmmnnnnmjnnlmlonnmlnnmmmlmnmkjmlmjkokmnnlmmnnm"
     "mlmmmmmdnkmmomnmnhmmrmklmnmmmlmmmmmnmmmmmmmlmkmrlnkmnkmmmkmlnmhmokmmmmmmjllnmmmmmmmmlmmmmmmmm"
     "mlmmmmmmmmmlmmmmmmminiommmmmmmokmmmnmmmkpkmmmmmmmmmmmmmmmmmmmmmmmmmmmmnlmmmnlmmmmmmmmmmmmlmmn"
     "mmolmmomlnmmmmmmolmnmnmnlmlmlkmmmmmmlmnmm"},
    {{{6, 254}, {15, 256}, {18, 1176}, {1, 800}, {7, 21}, {13, 896}},
     "nnlmmllommnmmnnpnnpmmnnlmklnkmnmmlmkplnmmmmlmioknmmmmlnplkmmknmmmklkjmmlnlmlolnmnllmmnmpnmmlm"
     "mminikmmmmmmlnmmmmmmmmromlmlmmlmmlnlmknnmmnnmmmnmmnmllmmmmmlmmtmmmmnmnmmllommmmmmmmmmmmmmmmmj"
     "mnmmmmmmmmmmmmlqnomirjommmmmmmmmmmmmmmmlnlmmmmmmmmmmmmnmmmmmnkmmmmmmmmmmmmmmmmmmknnmmmmmmmmmm"
     "mlnkmmpmnlmmmmmmmmmmmkomomonkommmmmmmmmmm"},
    {{{5, 357}, {18, 549}, {13, 512}, {7, 85}, {6, 85}, {1, 928}},
     "mnmmllmmmlonlmlmmmlmmlnllnjojmnmnmlnmnlmlimnnmmmmmmmmmmmmmmmmlmmommmlmmmmmmmmmmmjnmnmmlmmmoml"
     "mmnmmmmknnomnjoknmlnonnlmlmoklmmmmmmmmmlmmmmmmmmmlnmmmmmmnllmlmnlmlolmlmlnlmlmmlmmommlmknmnlm"
     "mmnmmnmnlmlnlmronjmkmnmmmmlnmimmomoplnmjomomlmmnmllmmmmmnlmmmlmmllmmmnmnnmlnnmmmnnmmmmnknlkml"
     "mpmpkmqolkmmmmmmlmmmmnmmlmkqlolonlnnmmlnn"},
    {{{0, 704}, {1, 1136}, {0, 576}, {11, 166}, {5, 522}, {14, 2065}},
     "mmmmmlnmmmlmnmmolmmmnlmlnnpmllmmlnmkmmmllpmomknmomrqjlmmplmmmlmlmqllmmmmmlmknnlmlmmmmlkmmmllm"
     "lmslmomlomlmlmmmmklmmmqmmomqmnkmqlklmmknnmmlmlmnmolmmmmmmllnnmmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmronlmilnkmnnmmmlmmmmnnmpmolllmijqmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmlnkmmmmmmmmmmmmmmmmkpqimmmmmm"},
    {{{10, 64}, {11, 26}, {21, 0}, {7, 21}, {16, 960}, {18, 886}},
     "imoomlmmlmijmlnkomnmengjmmnmnmrllnmqlmmmplnlmmmmmmnnllmmmmmmpmnmmlnmlmrmmmnmllmmlnnmmmlmmmmnk"
     "onmmkomlnnnnollnmnlmnmpnkmmlnmmljollmmomlmklmmmlmlmmmmkmmnpmmmnmokmmlnmnmlmkmnnmmmknnnmllomno"
     "lmnmoipmnpjnlnmmknnjllmmolomnokmmmlmlnmlomomnmmmlknmnmnlnmnmmommmonlnmnmlmnmmmlnmlmmmolmlkomm"
     "mmmlmmnllkmolmmminlnmmnlmmmlolnkjmnmklmlm"},
    {{{6, 246}, {15, 256}, {4, 612}, {12, 1024}, {18, 624}, {0, 384}},
     "pommmmmmmlolmmnlmnmmmnlnmlmmmmnmlmmlnlmmmmnmmllnlmnlmmmnlmlmmmnnmmmnnmllmlmollnmnmlmmlmmmmmnl"
     "mmlnmnmmmlmmmmmmmlnnmmnlmlmmlnmmllolmnjmmmninjmnljnlkmlmlkmnnmmkmmmmmmmmmmmmmnmmlmkonmmmmmmmn"
     "mmlmmmmmmhrlomnmmmmmmmmmnmmmmmmmmmmmmmmmmmmmnmmmmmlkmmmmmmmmmmmmmnlnmlnmmmlnmnmmolmmmnllmommm"
     "mmmmmmmmmmmmmmmmmmmmmilkmmmmmmmlplnlslklm"},
    {{{11, 237}, {6, 130}, {4, 365}, {21, 0}, {11, 48}, {18, 1060}},
     "mmmmmmmmmmmknnnrllpmkmmlmjmmlmmmmmmplmkllknlmmlnlmmnlmlmmmmmomnmmmmlnmmmlmmmlmlmlmllmkmlmminp"
     "nmqmmomlmlmmknlommnlmmnnlkmknlmmnmmmmnnonnnmmmmnmnmmmmmlmmolnnnlllmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmljmnnlkmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlkqknjjplpmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmnnmmolm"
     "mmmmmmmmmmmsolmmpoiommmmmmmmmmminonmempkm"},
    {{{5, 790}, {16, 384}, {0, 512}, {18, 1364}, {15, 704}, {11, 134}},
     "lmmmmnnmmmmmmmmllmnmrmmompmlommmmmmmmmmmilpmnnmmmmmmmmmmmmmmlmnllmmmmmmmmmmmmmmmmmmmmmmmnmmon"
     "mmmmlmmmmmmmkomllomllmjmmnmnmmmmnlmlmolnlmlmmnmlmmomnlolmmmkpmskjnmmmmmmmmmmmkjnmmmmmmmmmmmmm"
     "mmmmillmmmmmmmjnmnmmmmmmlmnmmmmmmmlmmmmmmmmmjnmmmmmmmmknlnmlmlmmkpkmmmmlmmmmmommnlmmmmkmmnmkm"
     "msmllmmmmmmjnlkmmmmmmnnmmmmmmmmmmmmmmmmmm"},
    {{{12, 1986}, {8, 0}, {7, 21}, {13, 896}, {0, 512}, {14, 1416}},
     "lmlnlipkomhlllnfomnmmlonmnmmlmsnjlmmnmnmmlmmmmnmknmmnnmkmnmmfnhjmknnmmmnmnmmmmmmnmmmmmmmmmmmm"
     "mmommlmlmnomjmnlmpnojmmmllmmmmmmmmmmmlmmnmnlmnmpmnomomlmmnolnmpmlmmmmmmmmmmmmmmmmmmmmmmmmllmm"
     "oknmmlnmmmllmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmlnmmmmmmmmmmmmmmmmmmmmmnlmnmipnommmmmmmmmm"
     "mmmmmmjomlmmmmmmmmmmmmmonmlnmnmmllmonmlmn"},
    {{{12, 1540}, {4, 384}, {5, 469}, {15, 640}, {11, 105}, {10, 85}},
     "knmmmjmmnmnmlmmnmnmmommmmmnmmmmmmmmkqlmlnmmmmkmlnnlnlmmlmmmmkllnmjmkomllmmmolmnmmmlmmmmmmmqmm"
     "mmmlmmmlnklmlmnmmmnmnmllnkmnlmlmnlnmmilpmmmllmnqlokmqpommonmkmmmnlmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmminmlmmmmmmkmmnmmmmmmlnlnmmmnmmmmmmmmmmmmlmlmmlmlmmonllmmmmm"
     "mlmmmmmlnlnknlmmmmmmmoojmmspmlmhlmpmkmlmm"},
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
