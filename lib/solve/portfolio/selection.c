/* selection.c: which way of a projection is tried, and for how long; see selection.h. */
#include "solve/portfolio/selection.h"

#include <math.h>
#include <string.h>

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

/* Features are rough logarithms, too, in so many parts of one. */
enum { MARKS = 256, PARTS = 32 };

/* A tree asks whether marks are above thresholds. Its answers, the first one as the highest bit,
 * are the number of a leaf: a letter for each number that is told, NEUTRAL if it adds nothing. */
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
/* 8854 problems of 63 families, seeds 1 to 153203, ways as of commit f1cd36dd.
 * Time over that of the best method alone: 1.086 on families seen, 1.258 on others. */
static const int START[FORETOLD_COUNT] = {7, 34, 40, 38, 0};
static const tree TREE[] = {
    {{{12, 1184}, {14, 1352}, {7, 23}, {0, 512}, {3, 1088}, {11, 128}},
     "egkqmdghsmgnkjniujinfhiqmjjjqmtinnmmnmnmfggpldhgomfqfkjhlklngmfxkffitningrmekisnpkilmngnrnmyo"
     "fluqqimniiqmpgkpmxojmm}lqimnpfhmkplinlxkfmlopimrretmpgmmnswfrm}pjmmffznm`htomikyjmcfsqnqjkpml"
     "lmnmlisonchtsn]jffmmmmmm`oijmllmlmlmlpmmmmmmkpjtmosirmwiuhmlouimusxemegxlm}inpmmmlmm}mrkmrhul"
     "mlookmmmmmmmvqfmnookmplkmmmmmmmvthpmqllln"},
    {{{12, 1264}, {6, 54}, {14, 1818}, {0, 512}, {7, 23}, {3, 1024}},
     "mmmmmgwjimmmmmmiwhjjmmmmm{lnjmllmmmjphpmmmmmmnvohmmmmmmnwoinmmmmmtpmlmmmmmmwqhnmdglrmmnojnhgh"
     "nmgmhllfihumhijnniiisnhmitmrkklmxpnimmpgjmlsmgnujmmmylnlmrnhqmsqipmmmmmmmsnjmmmmmmjsjlkmmmmmo"
     "wvgmmmmmmoviolmmmmmktoinmmmmmmtmimmmmmmmmmmmmmmmmrqjmmdgvomglwkm^jiim^mkgmsliqmjiupnmmmmmlpjs"
     "mvlsimzltgmmmmmmqsrgm}ipnm}irkmmmmmmunion"},
    {{{5, 512}, {3, 1120}, {0, 384}, {14, 1352}, {3, 896}, {0, 640}},
     "iiknnmmmmmgjjllmmmmmmjimmmmmmmhsngmmmmmmiijqmlinophkhrljnismnjionmmlpnqnhmmrqjrmmmmmmmmmmmiqj"
     "jlmmmmmmmmmmmmmmmhvqhmmmmmmmmmmmmmmmmjlilmovgtmmmmmmmmmmmqtjimwuhtmeinommmmmmciqkmmmmmmkmkimm"
     "mmmmmouimmmmmmgijrmlllomgioommokpmijiqmlmlnmwiplmnojpmmmmmmmmmmmbktknmmmmmmmmmmmmmmmkuvgmmmmm"
     "mmmmmmmmmmmjiponinuonmmmmmmmmmmxksjm}lpkm"},
    {{{12, 1368}, {3, 1296}, {14, 2008}, {11, 102}, {0, 576}, {8, 91}},
     "ijknmmnllmkrhtmokoomjjkomhkknmjikqnpjnomqojmmvoohmtshtmnmmmmlpoimqpskmsklkmrlnmmllmlmhwljkmqk"
     "pmmmmmmmomlmkjllmquirmznoimmllkmqslknlpkpmonmnmropkmrnllmwmllmmmmmmfkskmmlrlnmpmonnnlmmdjqpme"
     "isrmmmmmmhkpqmzjqkmtnpkmsokommmmmminrlmfislmmmmmmjkqnmmrshmmunilmmmmm|plkmikommgjpomrvshmgiqr"
     "mwonjmosmjmmmmmmuollmmmmmmgiqmmmmmmmrkpkm"},
    {{{7, 23}, {3, 1248}, {14, 1264}, {12, 1040}, {0, 512}, {11, 114}},
     "kkinmlkjompkoomlkjomjisnnfirpmmkonmhknqmmljomkjkpmjlkonnjmomqlqkmkktmmwjmomnkmnmmolnmlolmmmmm"
     "mmmmmmmjlplmjlmmnmmmmmikmpmiqlklpmmlmflklnykpjmprqimgjsnmyqnkmortjmjkknliljnmjlkqmjkkomblijmk"
     "klmnlnjqlfhlpomoikmknmjnmqjrmnjmlmfqlimonojmrqiqmmjmknkokllmmmmmlmkmmlokmmlnlmllomlmmnkomorjo"
     "mmrlkmlmmmmlqjolunknmnrmjlmoolmqqjnmznlkm"},
    {{{12, 1040}, {6, 74}, {0, 384}, {14, 1264}, {4, 336}, {10, 97}},
     "mmmmmmmmmmlnlmmkqjlkmmmmmmmmmmnnmmmjqlkmmlmonikjpmlolonkojolmmlnmtiqmmmqjpmmpkkmmmmmmjllnmikk"
     "mmkkkmlojlsnkllmmjqmimmlkimljlonjkknmijmnmkljpljklpmjjmonlpjomolilmmmmmmmmmmmlqkknmomllmmmmmm"
     "mmmmpqoknjrokmmmmmmmmmmmmrmnnkjknmmmmmmmmmmmxtnjmnrllmmmmmmmmmmmejqmmmmnllapolmmmmmmjpqimmorl"
     "mklmnmmmmmmhjqommllpllnlnmqlmlmsjommrlkmm"},
    {{{5, 493}, {2, 768}, {14, 1818}, {0, 384}, {3, 992}, {7, 23}},
     "mkkmmlkllmlkmmnkkjllmkkomlklomjkklnkkkomkomkmmokjmjppkmhqnkmomkommmjnmpmkmmlmjmmmmmmmmmmmmkrm"
     "lmkqjkknmkpmjllonrpkjmmsjolmmmmmmmmmmlpplniqnknmlllmnmllmopmkmqplmmhjpomlllmmgkqlmelikmjkkpmk"
     "llomkispmeljkmnmmlmlplkmlopkmgspkmrkklmkpknmwinlmomlmmfkmommmmmmksqjmgpjkmglkqmllmomnlommilmn"
     "ntloommmmmmsonkmmpnlmulommmllmmtkolmtmonn"},
    {{{5, 530}, {2, 768}, {11, 128}, {14, 1932}, {10, 90}, {8, 34}},
     "jmkmmnknomllkolllkmmmqjpmnmnlmmlkomkpnlmjlmnnmkmonljmmnljllnnllmmkrpkmllnmmnkmkmipjpnspmmmmmm"
     "mmksllkqqjrmuplnmmmmmmnpmknoqkqmmsmjnmmmmmljkomullkmuppjmmmmmmqkmkmhlnlmgiqomknmommlnnmrmmlmn"
     "lqlmmmmmmpmmjmfkpnmkllommmmmmklkmmhnpjmllnlmmmmmmmmmmmgonlmqqrlmmmmmmrlmmmvmmnmtlolmmmmmmtmmk"
     "mhlommeiormmmmmmmkmnmlnommjiqmmmmmmmrjqpm"},
    {{{6, 54}, {10, 109}, {14, 1400}, {7, 59}, {11, 13}, {16, 0}},
     "mmmmmkollmkskqlnxnfmmmmmmmmmmmmmmmmookpmmmmmmnplmnmpkpmsonkmmmmmmpmmnmmnmmmmmmmmmmmmmknkomonl"
     "mllmkommmmmmlmlnlljlmlkilmnmmmmmkomllropjmknmlmmmmmmkokolkkllmmmkmmblikmoknmmlkromjknomlkmknn"
     "qkqmkjmnmlllnnnmnkmpnmlmolpnmlmnkmmlmmmlsknmnkkmmlolmmmmmmmmmiomlokmljljnmmjmjnmmlmmlmkolllkn"
     "mmmmmmnmkkmkpmlmklmlmmgkjmmnlmmnllnmnlmjm"},
    {{{0, 384}, {12, 864}, {7, 12}, {14, 2049}, {2, 832}, {11, 64}},
     "lmknmnkkpmmolnmmmmmmlnlmmmmmmmmnjmmmmmmmnkkkmmmllmmmmmmmmmmmnllmnmmmmmmmmmmmmmmmimokmikqlmjsq"
     "kmjnmmmponlmmmplmrnlmmkmolmiljkmjnmlmjomllmnmlmfrqkmirpkmkoolmlonlmhkklmjklomdonlkplommnnlnmm"
     "mmmmplkmmmmmmmllmmmmmlmmemjmnmlnomnlkommnjnmnnjpmsnknmolmnmmlmnmnppjmjknomximmmklplmqojmmkkpn"
     "mkmlmmlllnmoqmllmpmlmonkmmnnllmrnjnnqorkm"},
    {{{12, 1352}, {4, 457}, {1, 1104}, {0, 576}, {11, 114}, {14, 2111}},
     "mmlnmpmlmmlmlmmoomkmmrkqmrokqmlllnmtmlmmpnnmmqllnmqjopmqlnomnjonmmmmmmslomoklnnmlmllmoommmkkm"
     "knmqrkmlmknmlokqmmllnmslllmjqoklplmmnnkmlnlmmmmnmmmmommnmmmmmmmmmmmnlpmmukommflpnmjoolmooknmt"
     "lllmmmmmmmmmmmdpolmnmlnmnklmmmmmmmlnmmmmmmmmgkoqmlkommhmnlmrlmmmhkpqmfkommlrlqmmmmmmllmmnmmmm"
     "mmnmlmlomlmnlllmmmmmmvnlkmomllmqrpimmmmmm"},
    {{{0, 384}, {12, 864}, {9, 0}, {14, 1700}, {7, 16}, {10, 78}},
     "mllmmimlnmkmlmmmlmmmmmmmmsljqmmnlklnkklmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmjmommpmqkmhni"
     "kmkmlllknnkmqmpmnlpmkmjqplmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmgjklnhllpmjnkpllnlolookqmj"
     "mmllnokommllmmmmmnmrlnmmnlrlpnjnlnmmmmmmmmmmmmlmmlmlkmmmnnmqlkmmknknmlmlnmolmmmsknjmpmlnmomml"
     "mmmmmmmlnmmmmmnnnkmlmmmmmmnmnlmknlomimmkm"},
    {{{2, 1168}, {0, 640}, {11, 170}, {6, 70}, {8, 34}, {4, 362}},
     "mmmmmhikjmmlmnmmplmmmmlommmmmmnklnmnmnlmmmmmmllmmmhjponnnljmjmommkmommnlnmniknnmmnmnmoolomsnk"
     "omommommojplnrlqmlllnlmmnnmmmmmmqnlnmpkonnkipnnolplpmmmmmmlmnnnmmmmmmmmmmmmmmmmmmmjmnlmdpolmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmtnmkmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmosqhmmmmmmmmmmmmmmmmmmmmm"},
    {{{2, 640}, {0, 384}, {14, 1464}, {1, 800}, {7, 23}, {3, 992}},
     "mmmmmjllnmklnmnklllnlmlmmmmmmmnmlmlmkmmmllljmimommmmlkmlonlmolmqmmmmmmolllmmilmmmmmnmlknmmmlk"
     "nmjlllnnmlolmmmmmmlnnlmjnmmkmilmmklmmlnllmmnllmmmnpmkmknmpllnlkjllmlmnlmnkokmmmmmmimjlmjllomm"
     "pnlmmmmmmmnllljookmlqnlmmmmmmhpqmmnlmpmooolmmmmmmjpnlmnnlomqkqnmmnlnmilkkmknjomllmmmmmmnnmnmn"
     "mplplmsknlmmnlnmpnnkmlllnmmmnlmnmlnmnnmmm"},
    {{{5, 341}, {6, 38}, {14, 2241}, {4, 296}, {5, 493}, {8, 51}},
     "mmmmmmmmmmmmmmmmmmmmmmmmmgokmkmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmlnnmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmlimkmmllmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "nrlommmmmqrpimmmmmmmmmmmmmmmmmmmmmmmmmmqklnmmmmmmmmmmmololnmmnmoclnmmglnommnlommnmlmlmmmmnlom"
     "mmmmmmmmmmmbqjqmmmmmmrmlnmpnmmmtmlmmulmlm"},
    {{{9, 0}, {13, 576}, {10, 69}, {8, 64}, {6, 70}, {16, 0}},
     "hkkknolnpmlllmmmnknmmmlmmmpilmnmmmmrnlmmkjlkmpjnmmmkmmmnnmmmkpmmllmlmmnmlnmlnlmmmmmmmsnlnmilm"
     "lmmmmmmmmmmmpqoimflppmjknmmkinmnmmlnmlmmnmomnkmrnmkmmklmmqlolmolllmmmmmmmlllmmmmmmolqlqmmmmmm"
     "mmmmllqmmmmmmmnmlmmmmlnmnkmjlmmmlnqknlmlnloljjqnnllmkmmmmmmmmmmmmmmmmmmmllmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmlomllmlmlmllmnlmmmmlmmmmmnlmlmnlm"},
    {{{0, 576}, {13, 800}, {7, 23}, {8, 51}, {16, 0}, {3, 1120}},
     "mmlnmjkllnjnjompmlmmmloomopnkmnlklmnnllmlknmmmilkmmnmlmnllmnnmlnmmomlmlmmlmlmmmmllplmpmnmmmln"
     "mmlnnmmnmpmmjmnomklmlnnlolmgnikmmlmnmmlmnmmlmmmolommnmmmmmmmmmnopkmnmllmiklknlnknmmmmmmmlnomo"
     "lmmmolmmmlmmommlmnmlknmnlnmomnnlnmkompmljolmnlmmmoninmnllmmmmmmmpojnmmnnlmmmmmmmmmmmrmmkmlqoj"
     "mllmmmlrlqlpnlnmpolomplnlmmmmmmnmmlmommkm"},
    {{{9, 15}, {1, 832}, {3, 928}, {14, 1700}, {0, 384}, {12, 1636}},
     "klmmmmmmmmlmknmmmmmmlmlkmmmmmmnmklmmmmmmmkmmmkmnlmmmmmmnkplmkopkmipnmmnmmlmqllmmllmmmmmmmmkml"
     "olmmmmmskkpmmmmmmpmmommmmmmlnmlmmonmmmnlmmhmoqmnmmmngmnmmnmmmmilnlmmmmmmmmmmmmllkmmmmmmmmmmmm"
     "mmmmnlmjmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlnlmmmmmmmmmmmmmmmmmnlolnmmmmmmmmmmmmmmmmlmlmmmmm"
     "mmmmmmmmmmmmkplmmmmmmmmmmmmmmmmmmlnmmmmmm"},
    {{{14, 2163}, {12, 800}, {4, 296}, {5, 332}, {6, 38}, {14, 1700}},
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmklmmnmmmmmmmmmmmmmmmplmlmlklmmmmmmmmmmmmkmlnmnmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmhlonmflpnmjnjmkgnnlkmlmlmlklmmponkmomslommmnmknnlmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlqlrmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmepkp"
     "mmmmmmlmlnmmmmmmlmlmmmmmmmplommmmmmmrmmmm"},
    {{{11, 231}, {5, 811}, {12, 1636}, {6, 93}, {1, 928}, {15, 0}},
     "mmmmmmmmmmnnmmmommmmlllmmnmmlmklonmujlpmmmmmmmmmmmiknomiknmmkmommpllmmlmnomjmmnmmmmmmmmmmmmmm"
     "mmmmmmmlnkmmknmmmhlmmmomjnmmmmmmmmmmmmmmmmmmmmmmqmlmmmmmmfqokmmmmmmkllmmkkommklpmmjloomjmpmmh"
     "onlmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmmmmmnmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{12, 2048}, {12, 1636}, {4, 384}, {11, 56}, {14, 2111}, {13, 800}},
     "knlomlmknmknknmrkommmlmmmmmmlmpmlnmjnnmmmmmmmlmmmmomlnmpkmmmlmmmmmpnmmloommolnlmmmmmmjpokmmmm"
     "mmmlmmmmmmmmmmmmmmmmmmmmmmmpkplmjknmmnnllmnlmomilnomklnpmmlnmmhlnmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmjomlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmnnmmoomkmmolmmrmlmmmmmmmllmmmmmmmmmmmmm"},
    {{{4, 554}, {3, 1320}, {8, 146}, {5, 416}, {16, 0}, {10, 28}},
     "mmmmmmnmmmmnlnmmmmmmjmllmmmnnmommnmnnmlmmmmmmlollmlmmmmkmmlmmmmmmqopkmplmmmmmlmmmmmmmmmmmmlmm"
     "nmmmmmmmmmmmsmmmmlqnkmmmmmmmmmmmmmnmmjmmmmnmplnmmmmmolnmmokmmmlkmmmmmmmmmjmlmlnknnllmmmommmmk"
     "imnnjklommlomnmmmmmmnlnmlmmmmlmmmmmmmmmmmmmmllmnmmmmmmmmmmmmlmlmlnknmknlpmlmmmmmmmmmoomkmponl"
     "mmmmmmmmmmminmmmkmmmlkmmnnmmmmmjlmnmmmmmm"},
    {{{0, 384}, {13, 1842}, {11, 128}, {12, 1540}, {15, 0}, {16, 0}},
     "lmnlmlmmmmnmmlmmmnlmkplmmnnnlmnlmmmionmmjmnlmlnkmmrmlomionmmmmmmmklnnmllmmmjkmmmmmmmmmmmmmmmm"
     "mmmmmmmlommmlqnmmpnmmmlomnmmmmmmmmmmmmmmmmmmmmmmmmmmllmmmmmmmmmmmmmmmmmmnmmmmmmmmmnmlnmjmmmml"
     "lpmmolnlmpmlnmlkommlmmmmnkmmmolnkmjlnomklmnmkmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlnmlmpmllmpklmmpljm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{9, 0}, {14, 1024}, {0, 640}, {7, 46}, {3, 1168}, {11, 128}},
     "llkmmnmlmliklmnmlmmmnmmnlllmlmmnmnmljmmmmmmmmnmmmmmmmmmljqnmmmmmmllmmmmmmmmikilmmmmmmlmmmmmnm"
     "lmknmmmmnlnmklnlmllllmomlnnookomonkomsmknmmmnlmkomnmnkmmmnomomqoknmlmplmomnlnmmmmmmmmmmmlnkno"
     "mnmnmmmmmmmmmmmmmmmmmnmmmmmmmmmmmmmmmmmnlnlnmmmmmmmmmmllpnmmlnlmmmllmmlmmmkkmimmmmlmlllkmmmmm"
     "mmmmmmnlmmmololmsmlkmmmmmmlmkolkolommmmmm"},
    {{{11, 231}, {4, 402}, {3, 1072}, {0, 576}, {11, 114}, {14, 1932}},
     "lllmmlmmnmnmmmmrllmmmrlomommnmnmlmmrkpjmmpnlmomkmmlrjlmpnnmmmnmlmmmmmmpmmnmplmmmnmmmmlmmlmllm"
     "lnkoommlnmolommnmlmmlmknmlmmmmlmnmmmmllmmmilnmmpmlmmknlomklmnmmllmmmmmmmmmmmmjlnmmjmommmmmmmm"
     "mmmmlmmmmlmnmmmmmmmmmmmmlmmmmllnommmmmmmmmmmlkpnmlmmmmmmmmmmmmmmlmmlmknmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmnlmmmmmmmmmmmmmmmmmmnonlmmmmmm"},
    {{{5, 341}, {6, 93}, {1, 1104}, {15, 0}, {16, 0}, {11, 39}},
     "lknlmmmlmllmlnmlkmmmljmkmkllnmknlnnomlmmmmmmmmmmmmimlmklmmmmmmmmmmmmmmmlmmnmmmmmmmnmnomlmmmmm"
     "mmomlmmmlmmmnlmmmmmmmmolmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmjlmknlomnlnommmlnlmmomloml"
     "onmmplmmmlmnlmmmmmmpmlmmpmpmnnmmmmmmmmmkmommrklnmlmnmmjmmlnllnmmmmmmmlmlnmnlmlmollmmnmlmmmmnl"
     "mmmmmmhlpnmhmmmmmmmllmmmmmslmpmnlkommmmmm"},
    {{{9, 0}, {0, 640}, {11, 179}, {4, 573}, {3, 1320}, {14, 2332}},
     "mmmmmnnknmlnnmmnllnmlkmmmmmmmmnnllmkmmmmkmmmmpnlmmllmmmlmmmmmlmmmmmmmmmonjmlnolmmplpmolmlmmlm"
     "nmlmmmmmmmmmmmmmmmmmmmmmmmmmjpmnmmmmmnmnmmmmmmmmmmmmmmmmmnnlomqkllmlknkmmmmmmmmmmmmmmmmlkmkmm"
     "mmmmmmmmmmmmmmnmolommmmmmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmolmmmmmmmmqmllmmmmmmlnmommmmmmkmmnmmmmm"
     "mmlnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{0, 384}, {10, 179}, {14, 1400}, {4, 457}, {10, 11}, {7, 46}},
     "olnlmmmmmmnmmlmkmnmmmlllmmmmmmnmnmmmlmmnmmmlmmmmmmlnmmmmmnmmjonmmmmmmmjnommlnmlmmmmmmmmmmmlnl"
     "ommmmmmmmmmmmmmmmnlmmmommmmmmmmmmmmmmknjmmlmmmmmmmmmmmmmmlmmmmnllmlplonmklimlmmmnmnnmmljmllmm"
     "mmnmqmmlmmmmmmmmmmmknmnmmlmmmolmmmmlknmlmmnmnmnlmlnlmmmmmmmmmmmmmnmnmlkmnnmmmmmmmmmmmmmmmnlnl"
     "nmmmmmmmmmmmmmlmjkponmmmmmmmmmmmmmmmjnnmm"},
    {{{5, 416}, {3, 864}, {14, 1700}, {0, 512}, {1, 992}, {7, 51}},
     "nmllmnmnmnpmmnlnmmmmmmmmmlmmmmnmmmnomnmommmmmnlmkmmmmmmommmmmmmmmmmmmmmmmmmnmmmlllknmmmmmmmmk"
     "mlmlmmllpkommlmmmlnknlmmmolkommmmmmmmjmnmmmmlmmlnlomknlmmpmlnmlnlnmkmmmmlmnmmjmmnmmmmmmimmnlk"
     "mlnlolnlnmlmmlmljkmmmmmlrmlommmmmmgolommmmmmmmmmmmmmmmnmnmmnlmlnlomlmmlmmnomlmmmmmnmmmnmmklkn"
     "mlmmlmkomlmommomnllmmqlommnlmlmlmmmmlkmmm"},
    {{{4, 554}, {3, 1168}, {1, 1120}, {5, 416}, {14, 1136}, {11, 114}},
     "nmmmlnlmlmmnlnmlmmlnmmnnmmmmmlnmmmmmmmmmmmmmmnmmmlmmmmmnmlmmmmmmmmlmmnlklomolnommmmmmmlnlnlnl"
     "mmkknkmlmmnmknimmsomlmlomnmmmmmmmmmmmnmolmmlmmmmmmmmmllmmqnmlmmmmmmllnlnklmnnlllmmommlmmmlnml"
     "mlomilmnmmkmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmkmkmlkmmmkmlnmpmlnmjlmlnmpnkmnmmmmmlmn"
     "mmmmmmmmmmmmlmmmmmmmmmlnnnmmmmmllmmmmmmmm"},
    {{{9, 0}, {14, 832}, {12, 1040}, {8, 64}, {4, 336}, {15, 0}},
     "nmlmkmmmmmnmmmmmmmmmmmmmmmmmmmommmlmmmmmmmmmmmmmmmjkjnmmmmmmmmmmmmmmmmllmnmmmmmmhmmnmlnmmmlln"
     "mmmmmmmkmlmnplonmlnlmmnmlmmhnlmmlmmmmmmnmmnlmmmomllmqmnlmnmmmmnmnmmnmolommmmmmmnkmmmmmmmmmmmm"
     "mmmmlmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlnlmmmmmnlmknlnmmmnmmlmmmlmmmlpmmlmml"
     "mmmlmmmmmmmmmlmmkmmmmmmmmmmmmmmmlmmmlmmmm"},
    {{{5, 811}, {13, 1056}, {7, 23}, {11, 0}, {15, 0}, {1, 960}},
     "mmlmmlmnmmnllmmomknmmmmlmlmmmmnmnkmrmlomommmnolmmlkommmollnmmmmmmmmmmmmmmmmllmmmmmnmmmmmmmolm"
     "nmmmmmmmmmomlnnmmimnlmjmmmmioilmmmmmmmmnmmmmmmmmklmmmolommmnmnmnmnmjnlnmmmlmmeplomhokomnmllmm"
     "mmmmnmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlnlmmhmmmmplnmmplllmkmnnmmmmmmlnmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
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

static void foretell(const fmb_features *f, int *told)
{
    int mark[FMB_FEATURE_COUNT];
    for (int k = 0; k < FMB_FEATURE_COUNT; k++)
        mark[k] = (int)(MARKS * rough_logarithm(fmb_features_value(f, (fmb_feature_id)k)));
    memcpy(told, START, sizeof START);
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
