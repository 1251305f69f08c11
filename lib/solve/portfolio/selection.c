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
/* 6759 problems of 48 families, seeds 1 to 120055, ways as of commit 72e53a81.
 * Time over that of the best method alone: 1.064 on families seen, 1.216 on others. */
static const int START[FORETOLD_COUNT] = {5, 37, 46, 33, 0};
static const tree TREE[] = {
    {{{7, 18}, {14, 1376}, {0, 512}, {3, 1056}, {13, 768}, {0, 384}},
     "cfjqmghjsmcfunmgfurmktmjnkkmmncjykmievpmmmmmmijismmmmmmrhhrmmmmmmqhmommmmmmfgusnlmjjmmjhpmnmt"
     "hmzgpkmtwufmsvmgljtyfm{iuhmmmmmmfjiummmmmm}hlpmmmmmm}mmjmmmmmmyftmmfffomhhfrl`jhim_igkmemfkkh"
     "qemk_nhjm^njhmmmmmmhhhwnmmmmmjnjrlmmmmmflhunmmmmmntgtmkqggmnqdlmmmmmmoljmmgxofmoxjhmkpolmvpph"
     "mmmmmmpretlmmmmmpmipmmmmmmvueplmmmmmwnmon"},
    {{{12, 1232}, {6, 66}, {14, 1432}, {0, 512}, {7, 18}, {9, 12}},
     "iuiknmmmmmhufkkmmmmmpnkomvjmlmktfrmqjpommvmhlmmmmmlwmimmmmmmwnmlmylpkmwtinlplnlmfgjrmmmmmmghf"
     "oliiponmiiqmlknomhleuklgppspmjjmmmmmmmqhimmlmmmpiiqmmmmmmprgrmmmklmjjmmnmmmmmjsimkmmmmmipsmmm"
     "mmmmqtipmmmmmmotpimmmmmmkvlhlmmmmmsmnlmmmmmmsrjnmmmmmmghwnmmmmmm]kggmmmmmmmiosmmmmmmjklrnmmmm"
     "mumtimmmmmmpsthmmmmmm{hqommmmmmsmjommmmmm"},
    {{{12, 1368}, {3, 1072}, {14, 1264}, {7, 13}, {0, 384}, {11, 105}},
     "hinnmgjmommilqnhimqmghimmhkhmlgjjrljijrnllmlmhmplmtjipmdimqmlpiimjpmjmoogqmmmklnnonlmjqkkntko"
     "mmjjknnhnhlkllmlmkmgomjrgpmrurinonolmvqmil}kqjmjumimkonkmpuhmmvnokmgjpnmlmmmmmkpnmjlnnmilllmm"
     "mmmmdknlmmmmmmqksimhnplmyhqnmjlrnmmmmmmmmmmmqiqkmmmmmmdjqknejoqmljrnmehqsmkmlmmmmmmmhllmmmmmm"
     "mksthmdgslmvjrkmigupmbqoimmmmmmnpljmmwshm"},
    {{{5, 496}, {3, 992}, {14, 1264}, {0, 576}, {13, 800}, {14, 1816}},
     "jiipmmmmmmlllmmmmmmmkhlppmmmmmmmmmmmmmmmmijlnmnhmmmlmmmmmmlmknlqmonkqmmmmnmmmmmminhnlmmmmmolo"
     "lnmmmmmlqiqmmmmmmqtiqmmmmmmitikklrljnrlnlmtnqjmrritmrrgsmnnlnmsnknmhjkpmmmmmmgiqommmmmmlllnmm"
     "mmmmlllnmmmmmmaijtmlohmmjilpmukokmlokomqmlmmnqipmwllmmjklnnmmmmmcipnmmmmmmdfptnmmmmmlmlqmmmmm"
     "mrptjmyoojmfmrkmvkqkmtiqonrkqlmqwrimolkmm"},
    {{{12, 1232}, {3, 1280}, {15, 0}, {11, 128}, {7, 13}, {0, 512}},
     "lkknmmjknmkkjnlknjrlgjkqnlkmomijjmnkhppprmlkmtmkpmmojkmophqmlmolmmmmmmjqojmklnknctnkkmnlmmksk"
     "kknpknmkrjjnynmjmlplkmorklmonkknnmmmmpqnknqoiqmqookmnmmmmooolmynmkmjkslmnknpm`kkjmnmjqmdippme"
     "kppmnmnmmmmmmmxkokm}jlomonqjmrlmomimrlmmmmmmmmnmmmmmmmksrimkmpmmjrlkknomlmhiopmkippmmmmmmqvpk"
     "mupmjmsmlmmqqnjmooknngjpmmmmmmmmmmmmmmmmm"},
    {{{6, 56}, {12, 1040}, {0, 384}, {14, 1344}, {7, 18}, {16, 0}},
     "mmmmmlolnmlplklmmmmmmmmmmnnkmmlonlmmnmmloknmmlnlmmlskpllllknxlokmhqkklppmmmjpjnmmmmmmkqlknmmm"
     "mmlmlmmmmmmmkqqknmmmmmkqnklklnommspimlpkmlpqjompkolmuqklnmpnkmpqkmllllmmiliomkklmmlkjmlknnlmm"
     "njlmmlkkmjolkmkjlpmokiomklkplkkkongjkpmnkjmmmkjmmlojnmnmtkmgipmnenjjmlkmmnposjmmppjmlqmkmgsrk"
     "mjjsqmminomenhlmiklpnqiqkmslmmmrmmlmuommm"},
    {{{6, 72}, {7, 51}, {3, 1120}, {11, 113}, {14, 2074}, {10, 73}},
     "mokomlokomnnlomnokomlmlnmkrlnkmmlmmmmmmmqrmlnismkktpkmmppmlnkvmhnojmmmsppjmnmpkmlmmnmlnkolmnm"
     "nmmmlnmnmmmnjpknlmmmmmnmmmmnnkomlmjmlpokomknkmmknhqmkjmknumllmlmmlmhkmnmllmmmwkmmmtkmimfjoomi"
     "klomjookmmprlmjpqkmslrjnwmmlmtpokmdjqsmmklmmiiqmmnlmmmmnjnmmljnllrlnmpmkmmnkmnoljllolnlmmnonl"
     "mlmlnmmilknnnlnmlnlmmmmmmmmmmmmmmmmmmmmmm"},
    {{{2, 768}, {5, 524}, {0, 384}, {14, 1972}, {3, 1024}, {11, 40}},
     "lkjlmlkmmnlillnjnklllolkmmnlkmioqkmipqkmlmlqmmklnmnjlmmllkmnoojomnmkmmpjklmkqllmhkommjkommgln"
     "kmhknommnmkmioqkmlpolmmmmmmmkjnmgkmomijommkkoqmqlkmmllolmvjllmkkplmmmmmmmmmmmjqmlmmrljlmmmmmm"
     "mmmmlpnlmmqplmlmmnmnlnmonqmklmrknmnnlnmnmllmvmjnnprnlmdllnmjllnmkspkmkmpmmpnmomnnnlmvnmlmkmpl"
     "mkojqmgkmpmmonkmmkonmrmmpmmnnnmxklkmpkpmm"},
    {{{3, 928}, {5, 496}, {0, 384}, {14, 1886}, {2, 768}, {10, 96}},
     "kllnmnklmmmmmmmmmmmmlolkmnllmmmmmmmmmmmmmknnnmlkolnmnmnmmmmmnmkommllnmmmmmmmmmmmkkonmklknmill"
     "nmlllnmlllkmnmmlmlmmmmmmmmmklkpmkmkomhmipmikmpmnmknmmlllmjokommmmmmkkllnlmklllnnlmlqklljprkmk"
     "nmlmkoolmkpolnnklmmlmknmqqjpmjqkmknolmmllklluokpmmonkmiknlmnlnlmjpokmpopkmkppkmkpplmpnnmmqonl"
     "mjjpnmolkomlnpnmqjlmmrknlmqkkkmtlnmmqmnkm"},
    {{{3, 1584}, {0, 512}, {7, 38}, {6, 86}, {11, 0}, {16, 0}},
     "mmmmmqpmlmoroklkmlmmfmjjmmlmmmmlqmmglonmmkmlmlokmmlokllklmlnmjlknlomlnnklmmmmkmmmmmmmwmkmnpko"
     "omjjnommmmmmqllnmfjoomllnnmlkllmqojrmloknlmmlmnmmmmmnmkrmmnkoliljokmmmmmioollmmmmmhnlllmmmmmp"
     "plkmmmmmmmmmmmmmmmmlmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmonplmmmmmmpsqimmmmmmmmmmmmmmmmmmmm"
     "mmmmmmkokmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{12, 1040}, {9, 0}, {4, 448}, {2, 800}, {11, 70}, {7, 13}},
     "nminmnmlqmkkjnmlmjolnninmonlomkllomjrkplnmllmlkklmmmkkmkmmmmhnmlmloknmmmmmmmnnknmmmmmmkpmnmmm"
     "mmololqmmmmmmlmmmumnlmoipnmmmmmmlmlmmmmmmmlkmknmmmmmmmmmmmmmmmmmmmmrlmmmmnmnmjmrlmnmmnnlpmmms"
     "mlomjmnnmqnokmololmjnllmijoommolomqqnkmmomlmjkmnmqqokmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmlnknmmmmmmlnlnmmmmmmmmmmmmmmmmmmmmm"},
    {{{3, 1280}, {5, 332}, {7, 96}, {14, 2221}, {14, 1652}, {10, 104}},
     "mmmmmnllmmmmmmmmklmmmmmmmmmmmmmmmmmmmmmmmmmmmpkmknmmmmmnhkmmmmmmmmmmmmmmmmmmmmmmllnnmlmknmknm"
     "lmmomkmmmmmmmmmmmulmnmnmlkmklknmlnlolkokmmkmmlmmmmmmmmmmmnnmnmmmmmmmmmmmioinjmmmmmfomlkmmmmmm"
     "mmmmmmmmmmnknnmmmmmlkmlmmmmmmmjllmmmmmmmmmmmmmmmmmmmmmmpnlmpmllmmomlmmorknmmmmmmmmmmpmnlmskmm"
     "mnokqmmmmmmkplqmmmmmmmmmmmmmmmmtlklmmmmmm"},
    {{{0, 576}, {2, 896}, {14, 1200}, {12, 1264}, {8, 68}, {1, 896}},
     "llmnnmkmmlmmlmmmlnmmillmmmmmmmploomlllnmknkmmphnnmnnmlmmnmmmnmnlmpkmnmmlpkmllnnmmmmmmmmmmmmmm"
     "mmkrilnmmmmmmmmmmmmmmmkklmmmmmmmkmlmmmmmmmmnnmmmmmmmcrmmmmmmmmoomlmknjolomnnnlolnllmnnmlmmnmn"
     "mmmmmmmmmmmmmmonkmmopkrmjpkqmmmmmmqpiomonkommmmmmmmmmmmmmmmjhpqmmmmmmgjhnmmmmmmnnkrmmmmmmkmnm"
     "mmmmmmqmlmmmmmmmukolmmmmmmpmmmmmmmmmmmolm"},
    {{{0, 384}, {3, 896}, {5, 464}, {14, 1432}, {2, 640}, {6, 86}},
     "mmmmmmlmmmmmmmmmmmmmmmmmmojkmmmmmmmmmmmmmmmmmllmmmmmmmmillommmmmmmkjkmmmmmmlllnmmlmmmllllmlmk"
     "lllmllmmmlmmlmllmjoolnkqqlmmmmmmjmnmmmpmmmllnlmmmmmmjnommrmmmmjoolmmmmmmmlmmmnmnmonmlmlmmmmmm"
     "klmmmmmnmnmmnmmmmmmlllommmmmmjlkolmmmmmkninmmmmmmfmlpmnkmkmmmlnlnnlnmmlmmmnjlllmlmnnmnlmmpnml"
     "mmmmmmlkmlmlllmmnlmnmmmmmmlljmmwnpjmolnmm"},
    {{{0, 576}, {2, 1088}, {9, 12}, {11, 222}, {14, 2156}, {2, 832}},
     "lmmmmlonlmrlmmmnnlnmilonmknklmgpokmrmnmmmlpknlkoommmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmfoolmmmm"
     "mmmllmmmmmmmmllmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmojommnlpmqnlpmvmkmmjmknlh"
     "hmonmmmmmmmmmmolompmkmmmmmmmmmmmmmmmollmmmmmmmmmmmmmmmmmmmmklppmmmmmmolmlmmmmmmoppkmmmmmmmmmm"
     "mmmmmmtnmkmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{12, 832}, {9, 0}, {0, 640}, {7, 28}, {14, 2074}, {11, 40}},
     "hoknlllknmnljnmnlllmmkllmmmlnlmllnmmklnmmnmmmlnlnmnmmmmknlomknmnmmmmmmmnmnmmmmmmmmmmmlkonmmmm"
     "mmmmmmmmmmmmnkolommmmmlnmmmmmmmmumnjmmmmmmmmmmmmmmmmmmolnmmmmmmmmmmlmmmmklnnmrlmmmlmolmllklmm"
     "nlmmlpmmmnoplmnpkommmnnmomlmmrlmkmoolomnplpnpmmnmrlllmmmmmmmmnmommmmmmmnmmmmmmmmknjmmmmmmknnm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmnmnmmmmmmjolqm"},
    {{{12, 2049}, {12, 1592}, {5, 703}, {7, 18}, {13, 1056}, {1, 800}},
     "olllmnmmmmllnmmplmmmlnmmmmmmmmimikmmllnnlnmmmfoiqmqlplmlknommmmmmmmmmmfnhlmmmmmmjmlmmjknomlkn"
     "nmgknpmnmnmmlmnmmmmmmmmmmmmmmmmmmmmmmpmnlmionlmmmmmmmmmmmepilmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmqpllmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmnmnkpnmmmmmmmmmmmmmmmmmmmmmm"},
    {{{0, 384}, {3, 928}, {14, 1320}, {1, 800}, {7, 24}, {10, 51}},
     "kmnnmlmmmmlnlnlllomnnmmnmmllmmmmmmmommmmlmklmmmmlmnnllmolmlmlkmpmlllmmmmmmmnjlmmlkmmmmlmlmimi"
     "lmmlmnmlmllmoonmmmmmmmmmmllkomlmlnolmmnmmmkopmmlnnmmmnnmmlnolmlmllmnmmnmmmmmmjmkolmmlmmnmknml"
     "mlnmmmommommmmmmkmmmmmmmnmlmmnllmmgmjqmklmnmmmmpmmlmmmmlpnmslnlnhnikmlmlnmlqllmmlmnmkjlnmmmmm"
     "mplmmmsklkmlommmommlmnmmnmmlmlmomnomnmmmm"},
    {{{5, 332}, {6, 33}, {14, 2221}, {13, 384}, {11, 14}, {16, 0}},
     "mmmmmknkmjmmmmmmmmmmmmmmmhnmmlmmmmmjnmmmmmmmmkmmmnmmmmmmmmmmmmmmmnllnmmmmmmmmlnnmimkmmmlnlmll"
     "mmolmlnmkmlmmmmmmnmllmmlmmmmmmmmlnmlmmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnmslommnlmmmmmmmmmmmm"
     "mmmmmmmmmoookmmmmmmpkmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmllmlmmommnlolnmlmkmmhmkkmmmmmmnmnmmkmnm"
     "mmmmmmqmlnmknlompmnlmolnlmqmlnmnmmmmlnnlm"},
    {{{4, 288}, {0, 576}, {2, 896}, {10, 104}, {11, 128}, {14, 2042}},
     "gllnmgnlnmnmmmmmmmmmmlmnmmmmmmllmnnmmmmmbjommgmkommmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmmmlmmmnmn"
     "mlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlnmmommmmklmnminolmnmlmmm"
     "mmlmmkokommmmmoqnlmomlmmmqkkmqmmlmknmmllmmmnmlmmmlmmmmnpkommolpmmmmmnrlmlmlnmolnlmkmnmmlmmmmm"
     "mnlmomnlmmmllnomnmmlmnlllmmmmmmsnmlmmmmmm"},
    {{{0, 384}, {5, 580}, {8, 21}, {16, 0}, {13, 800}, {11, 40}},
     "nkmmmmmmmmmmmmmmmmmmmnllmmmmmmlnlmmlmkomnknlmmnnlmmmmmmmmnmmmmmmmmmmlmjnnmmkjnnmmmmmmmmmmmini"
     "mmmmmmmhnkmmmnlmmmnnlmjmmmmmmmmmnnnlmmmmmmnmolmlnmmmmmmmmnpmlmmmmmmmkmmmmnmolmmmmmmmmmmlolomn"
     "mlnlllinmonlpmnjmkmnnmmmnmnmmnlnnmpllmmmlmlntknlmpomjmlmmlmmmmmmjmmlmmmmmmhojpmmmmnmolmnminol"
     "mmmmmmjlonmmmmmmmmmomkomlmjlmomklmmmlmmnm"},
    {{{12, 2049}, {8, 51}, {5, 345}, {4, 512}, {16, 0}, {14, 1432}},
     "nllmmnmmnmnmmmmmlnlmllnlmmjllmnmmmmmmmmmimlmmllnmmommnmlmmmmmlmlmmmmnmkllomlmlomnnlnmmklnmnmm"
     "mmnlmmmmlmlmlmkmmmmlnmkmlmlmmnmmomnlmmllmmpmnlmlnlnllnmmmmmmlnkmolmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmkomlmmmmmmmmmmmpnmlmppkmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{5, 821}, {12, 1592}, {2, 800}, {14, 1816}, {14, 2221}, {5, 515}},
     "mlmmmmmlnmmmmmmmmmmmmnmmmlmmlmommmmolommlnlmlonmlmmmmmmmmmmmjmplnmmmnmnmlnmsmllmnlmnmllnmmmmm"
     "mmmmmmmkmnmmlmlmmmmmmmpmlmmmmmmmilnpmmmmmmmmmmmmmmmmlmmmmmmmmmjkmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmjllmmmmmmmmmmmmmmmmmimllmmmmmmlnknmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmlqmlmmmmmmmmmmmmmmmmgnmlmmmmmmnmlmm"},
    {{{9, 0}, {4, 320}, {14, 1104}, {12, 832}, {5, 345}, {7, 56}},
     "mmmmmmmmmmomlmljmlmlmmmmmmmmmmmmlmmmmmmmmmmmmmmmmmllmnmlmmnlmmmmmmmmmmfnlnmmmmmmnmllmnlmlmmnk"
     "nlmomnlmmmmmllmmnlllmmmnlnlknlnmnjmmmknknllmlnmlnlmmkmlnmnmmmmnnmmmmmmmmmmmmmnnnmmnmnlommmmmm"
     "mmmmnmnmnmmmmmmmmmmmmmmmrmnlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmllpmmnlnlnmmmmmmmmmmmmmmmnknk"
     "nmmmmmmmmlmmknnmkmmlmmmmmmmmmmmmnnmmlnmnm"},
    {{{0, 704}, {8, 21}, {6, 136}, {7, 18}, {15, 0}, {16, 0}},
     "mmmmmllmnmmmmmmmmlmmlmmmmjmlolmkmmmnmmommlqnmlnmmmnlmlmnmlmminikmmmnnmmnnmmmomlmnmnmmmmmmmmnn"
     "mmpllmmmmmmmnmmlmmmmmmlnnlmnmnnmkllnmklnlmmmmlmjkpnnnkommolmmmmmllmmmmmmmmmmmmmmmmmmmmmmmmmml"
     "olpmmmmmmpmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlkmmnmmmmmmmmmnmmmmmmmmmkjmnmmmmmmolmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{2, 1088}, {0, 640}, {11, 222}, {3, 928}, {14, 2336}, {1, 1072}},
     "mmlnmnmmmnfpmommmmmmmmmmmllnnmlnkmnpllnmkmmmmmmmmmmmmmmmmmmmkollmlmmmmpmnlmmmmmmnmmmmmllmnmmm"
     "mmmmmmmnplpmpmllmqmmmmmmmmmlmnmlmmmmnmmmmmmmmmmljqommmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmh"
     "nolmmmmmmlmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmllmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmolnmmmmmmmnmml"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmnolmmmmmmmmmmm"},
    {{{2, 640}, {6, 255}, {13, 1844}, {0, 384}, {15, 0}, {14, 1886}},
     "mmnmnmmmmmnlllmmlmlmllmmmmmmmmllnmnmllmmnommmmmmmmmmmmmmnmmmqlmlmmmmmmmmmmmnlklmlmkmmlmnmmmmm"
     "mmnmlmmimlmmlmllmmmmmmmmhnmmmmmmmmmmmmmmmmlnnmmmmmmmmmmmmmmmmmmmmmmmmmlmknknmlnlmnknommmmmmmk"
     "mnkmlmnlnnmmmmnpmnmmmmmmmmmmmommmmnpmlmmmmmmmmmmmnmlmmjlkmmgqnlmmmmmmpllmmjmmnmjmnkmmmmmmpmnn"
     "mkkmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"},
    {{{4, 288}, {5, 788}, {13, 1056}, {4, 460}, {3, 1440}, {7, 18}},
     "lllmmmmnmlmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmcojpmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmgjnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnmmmmmmmnmlkmnmmmmmmnnmlmm"
     "mmmmmmnmmmmmnmolommmmmmmmmmmmmmmmmklmnmjmjlmoomkmonlmmlojnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mommmmmmmmmmmmmmmmmmmlpmmmmmmmmmmmmmmmmmm"},
    {{{11, 230}, {13, 512}, {0, 576}, {1, 864}, {14, 1652}, {10, 96}},
     "lmlnmmmmmmlnmlmlnmmmnmnlmmmlmlpllnmlmnlmkomnmmnmnmkmlommmmmmnlnmnomllmmnmnmollllnmnmmolommmmm"
     "mmolkmmkmnnmmmkmmjmmmmolmlmnqknmmmmmmtklkmmmmmmlmmnmmnmomnmlmmmmlmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmljpommmmmmmmmmmmmmmmkmnmmmmmmmknmlmmmmmmmmmmmmmlmmmmmmmmmmm"
     "mmmmmmmmmmmmmmmmmmmmmmnnlmmmmmmmmmmmmmmmm"},
    {{{4, 384}, {12, 1592}, {11, 40}, {14, 2042}, {0, 512}, {13, 800}},
     "kmkomjlmmmlolnmnnimmkmjnmolmmmkomnmololmmlmmmllnlmllmmmnmlmmpmkmmlmnmmlnmmmmmmmmmmmmmkomlmmmm"
     "mmknnkmmmmmmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmnnmmommlmslnlmmmmlmn"
     "llmmollnmpkmmmmmmmmomnlmlnmnmnnmlmmnommkmnmmkmmmmqmnlmnkommmmmlmmmmmmhlpomnmlmmmnlmmmmmmmrmkn"
     "mmmmmmmmmpmimmommmmmmmmmmmikmmmommlmmmmmm"},
    {{{0, 640}, {1, 1216}, {9, 0}, {14, 1040}, {5, 384}, {11, 128}},
     "nmmmmnlmmmlmlnmlmlmllmlmmljpkpnmmmmkmmmmmlnlnnmnmommolmnnnmnmkmjmlmmmmllommmmmmmmmmmmmmmmmmmm"
     "mmmlmmmmmnmmmmmmmkmmmmmllmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmllmnmlmmnmmmmmmmmmmmmmmmmjmikmknmomm"
     "mmmmooknmqmlnmmmmmmmmmmmmmmmmmmmmnmmmmmmmmmmknmommmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmnm"
     "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmololmpnmlm"},
    {{{10, 116}, {5, 409}, {11, 113}, {7, 38}, {14, 1652}, {6, 106}},
     "jnjmmmmlmnjomnmlnnlmmmmlmlmmmmkmmmmmmmmmlmlmmnmlmmmmlmmmmmmmnnnlolnlmlmmmmmmmmmmqmplmmmmmmtlm"
     "lmlmmmmnlmmmkkqnnnnmmmmnmmmmmmmmlmnnmkmnmmkmnlmlmklmmmmmmqmnkmnmlmmmnkmlollkmnmnmmmmmmmmnmnln"
     "mmmmmnlnmolmmmmmmmmmmmmmlmmmmmmmmmnknlmmlnmnjkoknmmmmmmnjommnjnmjnkmmmlmkmmnmomnmlnmmmnlmomln"
     "mnnmlmmmmnnkmnmmmnmmmlplnknlnmmlmlmmollmm"},
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
