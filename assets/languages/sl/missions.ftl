# Slovenščina

## assets/missions/depth-step-at-constant-feed.toml

what-ra-is-and-why-one-programmed-feed-canno = Kaj je Ra in zakaj ga eno samo programirano podajanje na obdelovancu z dvema globinama ne more držati.
the-part-is-not-cut-to-its-end-cut-it-whole = Obdelovanec ni obdelan do konca: obdelajte ga celega.
ra-is-out-of-its-tolerance-on-part-of-the-fa = Ra je na delu ploskve zunaj tolerance: bolj hrapav, kjer je rez globlji in sila prevelika, ali bolj gladek od zahtevanega, kjer je podajanje povsod nizko. Kaj lahko zmanjša podajanje samo v globljem odseku?
ra-k5-f-f-k4-f-n-a-d-a-d0 = Ra = K5(F),  F = K4(f, n) A_D / A_D0
sdnrp-2007-models-k4-and-k5 = SDNRP 2007, modela K4 in K5
roughness-follows-the-cutting-force-and-the = Hrapavost sledi rezalni sili, sila pa globini in podajanju. Kjer se globina poveča, se mora podajanje zmanjšati, če naj Ra ostane enak. Eno podajanje za ves obdelovanec je za globlji odsek preveliko ali pa za vse ostalo premajhno.
finish-the-part-with-ra-in-its-tolerance-ove = Dokončajte obdelovanec tako, da je Ra v toleranci na vsaj 95 % dolžine.
ra-is-the-mean-height-of-the-surface-s-profi = Ra je srednja višina profila površine. Tu sledi rezalni sili: zaradi česa se sila v sredini poveča?
the-depth-cannot-be-changed-the-blank-is-as = Globine ni mogoče spremeniti: surovec je, kakršen je. Kaj še lahko zmanjša silo?
a-lower-feed-for-the-whole-part-would-do-and = Manjše podajanje za ves obdelovanec bi zadoščalo, a stane čas povsod. Regulator ga zmanjša samo tam, kjer je treba: izberite Sledenje.
what-does-the-surface-do-in-the-deeper-stret = Kaj se zgodi s površino v globljem odseku?
it-gets-smoother = Postane bolj gladka
a-deeper-cut-takes-more-force-and-a-larger-f = Globlji rez zahteva večjo silo, večja sila pa pusti bolj hrapavo površino.
it-stays-the-same-the-feed-is-the-same = Ostane enaka: podajanje je isto
the-feed-is-the-same-the-chip-is-not-the-edg = Podajanje je isto, odrezek ne: rob je v materialu na večji globini in sila naraste.
it-gets-rougher = Postane bolj hrapava
the-depth-rises-from-2-0-mm-to-2-3-mm-at-45 = Globina se pri 45 mm poveča z 2,0 mm na 2,3 mm in se pri 85 mm vrne na prejšnjo. Podajanje ostane, kot je programirano.
predict = Napoved
what-does-ra-come-to-in-the-deeper-stretch-a = Kolikšen postane Ra v globljem odseku pri stalnem podajanju?
it-stays-inside-its-tolerance = Ostane v toleranci
it-grows-by-about-a-third = Naraste za približno tretjino
it-more-than-doubles = Več kot podvoji se
cut-from-the-start-at-constant-feed-and-read = Režite od začetka s stalnim podajanjem ter odčitajte Ra pred stopnico in med 60 in 84 mm.
watch-the-cut-as-it-comes-and-nothing-change = Opazujte rez tak, kakršen je, brez sprememb: Ra in silo pred globljim odsekom in v njem.
see-it = Oglejte si
change-what-is-open-to-you-and-cut-again = Spremenite, kar vam je na voljo, in ponovite rez.
mend-it = Odpravite
the-drawing-asks-for-ra-0-81-m-on-the-whole = Risba zahteva Ra 0,81 µm na vsej ploskvi. Program ima eno samo podajanje. V sredini je surovec za 0,3 mm debelejši, zato frezalo tam reže globlje.
why-a-deeper-stretch-breaks-constant-feed = Zakaj stalno podajanje odpove v globljem odseku

## assets/missions/gain-leaves-an-error.toml

proportional-control-of-the-force-and-the-er = Proporcionalna regulacija sile in pogrešek, ki ga pusti za seboj.
in-the-deeper-stretch-the-mean-force-is-stil = V globljem odseku je srednja sila še vedno za več kot 7 % nad želeno. Kjer je zanka mirna, jo približa večje ojačanje; kjer niha, manjše.
the-force-does-not-come-to-rest-in-the-deepe = Sila se v globljem odseku ne umiri: niha in njena srednja vrednost ne pove ničesar. Ojačanje je večje, kot ga dopušča mrtvi čas.
the-loop-overshoots-the-gain-is-more-than-th = Zanka prenihava: ojačanje je večje, kot ga dopušča mrtvi čas.
f-set-f-d-kp-f-d-f-m-f-k2-f-set-n-k3-f-set = F_set = F_d + Kp (F_d - F_m),  f = K2(F_set),  n = K3(F_set)
sdnrp-2007-the-controller-s-structure-remain = SDNRP 2007, zgradba regulatorja; trajni pogrešek proporcionalne regulacije: učbenik
proportional-control-needs-an-error-to-act-o = Proporcionalna regulacija za svoje delovanje potrebuje pogrešek, zato ga nekaj ostane: čim večje je ojačanje, tem manjši je. Kako veliko sme biti ojačanje, določa mrtvi čas. Trajni pogrešek ni napaka nastavitve; tak regulator pač deluje tako.
bring-the-force-in-the-deeper-stretch-to-wit = Samo z ojačanjem spravite silo v globljem odseku na 7 % ali manj od želene, brez nihanja.
compare-the-measured-force-with-the-desired = Primerjajte izmerjeno silo z želeno v globljem odseku pri dveh ojačanjih.
the-correction-is-kp-times-the-error-without = Popravek je Kp krat pogrešek: brez pogreška ga ni. Pri večjem Kp za enak popravek zadošča manjši pogrešek.
raise-kp-in-steps-and-watch-the-first-instan = Povečujte Kp po korakih in opazujte prve trenutke reza: prenihaj pove, kdaj je prevelik.
where-does-the-force-come-to-rest-in-the-dee = Kje se sila umiri v globljem odseku?
exactly-on-the-desired-force = Natančno na želeni sili
the-correction-is-proportional-to-the-error = Popravek je sorazmeren s pogreškom. Na želeni sili je pogrešek nič in popravek tudi: kdo potem zmanjša podajanje?
above-it-nearer-than-at-constant-feed = Nad njo, bliže kot pri stalnem podajanju
nowhere-it-keeps-swinging = Nikjer: niha naprej
kp-is-small-and-so-is-what-a-measured-error = Kp je majhen, zato izmerjeni pogrešek malo premakne: zanka je tu mirna. Poglejte silo po stopnici.
kp-is-0-5-the-part-gets-15-deeper-at-45-mm = Kp je 0,5. Rez se pri 45 mm poglobi za 15 %.
by-how-many-percent-of-the-desired-force-f-d = Za koliko odstotkov želene sile F_d je sila F v globljem odseku nad njo, če je Kp tak, kot je podan (0,5)?
solve-f-1-15-f-d-kp-f-d-f-for-f-f-d = Rešite F = 1,15 (F_d + Kp (F_d - F)) za F / F_d.
the-models-are-of-the-shallow-part-15-more-d = Modeli veljajo za plitvi del: 15 % večja globina zahteva 15 % večjo silo, kot se od njih zahteva. Zahteva se želena sila, popravljena za Kp krat pogrešek: v mirovanju je F = 1,15 (F_d + Kp (F_d - F)).
predict-how-far = Napovejte, kako daleč
find-the-gain-that-meets-the-goal = Poiščite ojačanje, ki doseže cilj.
tune = Nastavitev
the-part-is-the-one-with-the-deeper-stretch = Obdelovanec je tisti z globljim odsekom. Tokrat SDNRP vodi podajanje in vrtilno hitrost: modele vpraša po sili, popravljeni za Kp krat odstopanje sile.
a-gain-comes-near-and-stays-off = Ojačanje silo približa cilju, a je tja ne spravi

## assets/missions/integral-action-holds.toml

integral-action-brings-the-force-onto-the-de-2 = Integralno delovanje spravi silo na želeno tudi pri drugi globini, dokler ima prostor za delovanje.
the-force-does-not-come-to-rest-in-the-deepe-2 = Sila se v globljem odseku ne umiri: zanka je nestabilna. Vsota deluje na pretekle pogreške: z manjšim Ki ali Kp se umiri.
the-mean-force-in-the-deeper-stretch-is-not = Srednja sila v globljem odseku ni želena. Samo ojačanje pusti pogrešek; vsota ga odpravi, če ima čas, če ne niha in če korekcija ni na meji.
ra-is-outside-its-tolerance-over-too-much-of = Ra je na prevelikem delu dolžine zunaj tolerance: po vsaki stopnici pride sila na želeno prepočasi ali pa niha.
u-1-kp-e-ki-sum-e-e-1-f-m-f-ref = u = 1 + Kp e + Ki sum e,  e = 1 - F_m / F_ref
textbook-form-of-pi-control-the-override-loo = Učbeniška oblika regulacije PI; zanka korekcije v kombiniranem sistemu, 2005
the-sum-of-the-errors-stops-changing-only-wh-2 = Vsota pogreškov se neha spreminjati šele tam, kjer je pogrešek enak nič. Zato integralno delovanje drži silo pri drugi globini ali v drugem materialu, dokler velja troje: korekcija ni na meji, zanka je stabilna in manjše podajanje še pomeni manjšo silo. Na meji vsota obstane in pogrešek ostane. Njegova cena: odziva se na to, kar je bilo, zato preveliko ojačanje zaniha.
let-the-force-in-the-deeper-stretch-rest-wit = Sila v globljem odseku naj se umiri na 0,5 % od želene, Ra pa naj bo v toleranci na 95 % dolžine.
what-would-an-override-do-that-keeps-falling = Kaj bi dosegla korekcija, ki se zmanjšuje, dokler je še kaj pogreška?
set-the-integral-gain-ki-above-zero-small-it = Integralno ojačanje Ki nastavite nad nič. Majhno: traja nekaj sekund. Veliko: prenihava. Kar spremenite med rezom, deluje šele od tam naprej: nastavite ga, nato režite od začetka.
set-ki-to-0-2-press-cut-from-the-start-and-c = Ki nastavite na 0,2, pritisnite »Reži od začetka« in preverite rez.
with-an-integral-gain-above-zero-where-does = Kje se sila umiri, če je integralno ojačanje večje od nič?
on-the-desired-force-at-2-3-mm-as-at-2-0-mm = Na želeni sili, pri 2,3 mm tako kot pri 2,0 mm
on-the-desired-force-at-2-0-mm-only = Na želeni sili samo pri 2,0 mm
the-sum-goes-on-changing-as-long-as-there-is = Vsota se spreminja, dokler je še kaj pogreška, tudi pri 2,3 mm: umiri se lahko le tam, kjer je pogrešek nič.
nearer-but-off-as-with-the-gain-alone = Bliže, a ne na njej, kot pri samem ojačanju
a-gain-needs-an-error-to-hold-its-correction = Ojačanje potrebuje pogrešek, da drži svoj popravek. Vsota drži, kar je seštela, brez preostalega pogreška.
find-an-integral-gain-ki-that-meets-the-goal = Poiščite integralno ojačanje Ki, ki doseže cilj. Obdelovanec se ocenjuje na vsej dolžini, zato je ojačanje, nastavljeno med rezom, prepozno: nastavite ga, nato pritisnite »Reži od začetka«.
the-same-part-again-now-the-controller-is-p = Spet isti obdelovanec. Zdaj je regulator P: korekcijo podajanja premika za ojačanje krat relativni pogrešek in preostanek pusti, kot ste videli. Pogrešek lahko od vzorca do vzorca tudi sešteva.
adding-up-the-error-takes-it-away = Seštevanje pogreška ga odpravi

## assets/missions/dead-time-against-gain.toml

a-gain-that-is-good-at-a-short-dead-time-swi = Ojačanje, ki je dobro pri kratkem mrtvem času, pri dolgem zaniha.
ra-leaves-its-tolerance-on-more-than-a-tenth = Ra je na več kot desetini dolžine zunaj tolerance: niha ali pa leze. Kaj od tega vidite?
k-l-pi-2-k-rate-of-the-integrator-with-all-t = K L < pi / 2,  K: hitrost integratorja z vsem, kar mu sledi, 1/s,  L: mrtvi čas, s
textbook-stability-limit-of-an-integrator-be = Učbenik: meja stabilnosti integratorja za mrtvim časom
within-the-dead-time-the-loop-is-blind-what = Med mrtvim časom je zanka slepa: kar v tem času doda, doda, ne da bi videla, kaj je iz tega nastalo. Zato je omejen zmnožek ojačanja in mrtvega časa. Dvakrat daljši mrtvi čas dopušča približno pol manjše ojačanje.
find-the-largest-integral-gain-that-still-ho = Poiščite največje integralno ojačanje, ki Ra še drži na 90 % dolžine, pri mrtvem času 160 ms.
for-160-ms-the-controller-goes-on-asking-for = Regulator 160 ms zahteva vedno več, ker ne vidi še ničesar od tega, kar je zahteval. Kako daleč čez cilj lahko zaide v tem času?
halve-the-gain-and-look-at-the-overshoot = Ojačanje razpolovite in opazujte prenihaj.
the-edge-for-a-good-cut-lies-between-0-2-and = Meja dobrega reza je med 0,2 in 0,35.
what-will-the-cut-do = Kaj se bo zgodilo z rezom?
the-same-80-ms-later = Enako, 80 ms pozneje
the-command-is-late-in-every-round-of-the-lo = Ukaz zamuja v vsakem krogu zanke, ne enkrat: regulator popravlja pogrešek, ki ga je že popravil.
it-swings-and-ra-with-it = Zaniha, z njim pa tudi Ra
it-gets-slower-and-stays-calm = Postane počasnejši in ostane miren
a-slower-answer-would-need-a-smaller-gain-th = Počasnejši odziv bi zahteval manjše ojačanje. Ojačanje je isto: staro je le to, kar vidi.
the-integral-gain-is-0-8-as-on-the-machine-w = Integralno ojačanje je 0,8, kot na stroju z 80 ms, kjer se je obneslo.
lower-the-gain-until-the-cut-is-good-and-no = Zmanjšajte ojačanje, dokler rez ni dober, in nič bolj, kot je treba.
find-the-edge = Poiščite mejo
on-this-machine-the-plc-passes-the-override = Na tem stroju PLK posreduje korekcijo dvakrat počasneje: 160 ms po zahtevi. Ojačanja so bila nastavljena na drugem stroju, zdaj pa se miza trese.
dead-time-against-gain-find-the-edge = Mrtvi čas proti ojačanju: poiščite mejo

## assets/missions/smith-predictor.toml

why-a-predictor-helps-against-dead-time-and = Zakaj prediktor pomaga proti mrtvemu času in kaj v njem povzroči napačen mrtvi čas.
it-still-swings-the-predictor-has-to-know-ho = Še vedno niha. Prediktor mora vedeti, koliko časa ukaz v resnici potuje.
y-y-u-0-u-a-u-a-with-and-u-0-without-the-ass = y* = y u_0 / u_a,  u_a s predpostavljenim mrtvim časom in u_0 brez njega
o-j-m-smith-1957-here-in-multiplicative-form = O. J. M. Smith 1957; tu v multiplikativni obliki, ker gre sila s podajanjem
the-predictor-takes-the-measured-force-for-w = Prediktor izmerjeno silo z modelom poti korekcije preračuna v tisto, ki bi bila brez mrtvega časa. S pravim mrtvim časom je mogoče zanko nastaviti, kot da mrtvega časa ni. Z veliko predolgim popravlja, kar ni pogrešek, in niha; nekoliko prekratek škodi manj. Model je vreden toliko, kolikor je resničen.
keep-the-integral-gain-at-0-8-and-hold-ra-ov = Integralno ojačanje pustite na 0,8 in držite Ra na 88 % dolžine.
switch-the-smith-predictor-on-and-look-at-th = Vključite Smithov prediktor in opazujte silo: je mirna?
the-predictor-assumes-a-dead-time-which-one = Prediktor predvideva mrtvi čas. Katerega predvideva tu in katerega ima stroj?
set-the-assumed-dead-time-to-0-16-s = Predvideni mrtvi čas nastavite na 0,16 s.
you-switch-the-predictor-on-and-change-nothi = Vključite prediktor in ničesar drugega ne spremenite. Kaj se zgodi?
the-cut-is-as-calm-as-without-dead-time = Rez je tako miren kot brez mrtvega časa
it-would-be-if-its-model-were-true-it-expect = Bil bi, če bi bil njegov model resničen. Odziv, ki pride po 160 ms, pričakuje po 300 ms in to, kar pride prej, ima za motnjo.
it-still-swings-the-model-is-wrong = Še vedno niha: model je napačen
the-part-is-cut-with-a-constant-feed = Obdelovanec se reže s stalnim podajanjem
the-predictor-changes-what-the-controller-se = Prediktor spremeni to, kar regulator vidi, ne pa, ali ukrepa.
the-predictor-assumes-a-dead-time-of-300-ms = Prediktor predvideva mrtvi čas 300 ms; stroj ima 160 ms.
make-the-controller-s-belief-fit-the-machine = Uskladite regulatorjevo predstavo s strojem.
make-it-true = Uskladite
the-machine-with-160-ms-again-the-gain-must = Spet stroj s 160 ms. Ojačanje mora ostati veliko, ker šef hoče kratke čase. Regulatorju je mogoče dati model poti ukaza: potem ve, kaj je zahteval in česa še ni videl.
a-model-that-waits-the-smith-predictor = Model, ki čaka: Smithov prediktor

## assets/missions/noise-against-tolerance.toml

scatter-of-the-force-becomes-scatter-of-ra-a = Raztros sile postane raztros Ra; toleranca mora imeti prostor zanj.
less-than-80-of-the-length-is-in-the-toleran = V toleranci, ki jo zahtevate, je manj kot 80 % dolžine. Je kriv regulatorjev odziv na šum ali šum sam?
so-wide-a-tolerance-will-not-be-granted-at-m = Tako široke tolerance ne bodo odobrili: največ 25 %. Najprej umirite regulator.
ra-k5-f-an-error-of-1-in-the-force-is-one-of = Ra = K5(F): pogrešek 1 % v sili je nekaj odstotkov v Ra
sdnrp-2007-table-3-force-and-ra-of-the-same = SDNRP 2007, preglednica 3 (sila in Ra istih vrstic); Bodejev integral za meje povratne zveze
feedback-corrects-what-lasts-longer-than-its = Povratna zveza popravi, kar traja dlje kot njen mrtvi čas. Kar se spreminja hitreje, ne more popraviti, hiter regulator pa to še poveča. Ostalo je stvar procesa: toleranca mora imeti prostor za njegov raztros.
tune-the-controller-for-this-noise-and-find = Nastavite regulator za ta šum in poiščite toleranco, za katero boste prosili konstruktorja: najmanjšo, ki drži na 80 % dolžine.
how-much-do-the-force-and-ra-scatter-while-n = Koliko se raztrosita sila in Ra, ko se nič drugega ne spreminja?
a-controller-that-answers-each-wiggle-adds-t = Regulator, ki se odziva na vsak tresljaj, jih še poveča: zamuja za mrtvi čas. Naj se odziva počasneje.
try-a-response-time-of-1-to-3-s-then-widen-t = Poskusite z odzivnim časom od 1 do 3 s, nato po korakih širite toleranco.
you-make-the-controller-answer-faster-what-d = Regulator nastavite hitreje. Kaj se zgodi z deležem ploskve v toleranci?
it-grows-errors-are-corrected-sooner = Poveča se: pogreški so prej odpravljeni
errors-that-last-are-noise-has-changed-its-s = Trajni pogreški že. Šum pa zamenja predznak, preden popravek pride, 80 ms in zakasnitev pogona pozneje.
it-falls-or-stays-it-answers-noise-with-nois = Zmanjša se ali ostane enak: na šum odgovarja s šumom
first-the-response-time-then-the-tolerance = Najprej odzivni čas, nato toleranca.
tune-then-ask = Nastavite, nato prosite
steel-is-not-the-same-from-place-to-place-ed = Jeklo ni povsod enako, rezalni robovi opletajo, senzor šumi. Risba dopušča 10 % okoli Ra 0,81 µm. Delovodja sprašuje, zakaj je v najboljšem primeru petina ploskve zunaj tolerance, in to z regulatorjem, ki so ga hvalili.
what-no-controller-can-hold-noise-against-to = Česar noben regulator ne zmore: šum proti toleranci

## assets/missions/another-material.toml

a-model-based-controller-on-a-material-that = Modelni regulator na materialu, za katerega njegovi modeli niso bili narejeni.
ra-is-not-held-the-controller-s-models-are-t = Ra ne drži. Regulatorjevi modeli pripadajo drugemu jeklu: kateri regulator to ugotovi sam?
gain-estimate-f-m-f-modelled = ocena ojačanja = F_m / F_model
tracking-controller-observer-of-the-gain-mat = Regulator Sledenje (opazovalnik ojačanja); materiali: specifične rezalne sile, kot so navedene v programu
a-model-is-a-belief-what-corrects-it-is-meas = Model je predstava. Popravi jo merjenje: razmerje med izmerjeno in modelno silo pove, kako napačna je, in regulator, ki sledi temu razmerju ali sešteva pogrešek, ne potrebuje konstant novega jekla.
hold-ra-over-at-least-90-of-the-length-witho = Držite Ra na vsaj 90 % dolžine, ne da bi poznali konstante novega jekla.
the-controller-s-models-believe-in-ck45-what = Regulatorjevi modeli predvidevajo Ck45. Po čem lahko regulator spozna, da se motijo?
sdnrp-corrects-its-models-answer-by-a-gain-y = SDNRP odgovor modelov popravi z ojačanjem. Kaj ojačanje pusti, že veste.
tracking-estimates-how-much-larger-the-force = Sledenje oceni, za koliko je sila večja od modelne, Nastavljivi PI in P z integralnim ojačanjem pa seštevata pogrešek.
what-roughness-will-the-part-have-at-the-end = Kakšno hrapavost v µm bo imel obdelovanec na koncu, kjer se zahteva 0,81?
the-force-of-this-steel-is-larger-by-a-fifth = Sila tega jekla je večja za petino in več. Nekaj odstotkov sile je več deset odstotkov Ra: enkrat obdelajte in poglejte.
sdnrp-with-kp-0-5-its-models-belong-to-ck45 = SDNRP s Kp = 0,5; njegovi modeli pripadajo Ck45.
choose-what-does-not-need-to-know-the-steel = Izberite regulator, ki mu jekla ni treba poznati.
hold-it = Držite Ra
the-store-has-run-out-of-ck45-and-brings-16m = V skladišču je zmanjkalo Ck45 in prinesli so 16MnCrSi5. Program, modeli in ojačanje ostanejo, kot so: po modelih je vse v redu.
another-steel-under-a-model-that-does-not-kn = Drugo jeklo pod modelom, ki ga ne pozna

## assets/missions/wear-heard-and-seen.toml

what-force-sound-and-roughness-do-from-a-sha = Kaj se s silo, zvokom in hrapavostjo dogaja od ostrega do obrabljenega roba.
the-part-is-not-finished-its-tool-was-worn-o = Obdelovanec ni dokončan: orodje se je izrabilo ali pa je potekel čas. Izberite krajšega.
at-its-end-the-surface-is-more-than-three-ti = Na koncu je površina več kot trikrat bolj hrapava kot na začetku. Orodje je treba zamenjati prej.
f-f-sharp-1-growth-wear-used-life = F = F_ostro (1 + rast * obraba(porabljena obstojnost))
machine-model-2019-wear-sound-and-tool-life = Model stroja 2019: obraba, zvok in obstojnost orodja
wear-goes-in-three-parts-break-in-steady-gro = Obraba poteka v treh delih: začetna obraba, enakomerna rast, odpoved. Sila, zvok in hrapavost naraščajo skupaj, zato lahko zvok napove čas menjave orodja, preden se to pokaže na površini.
say-what-becomes-of-sound-and-roughness-and = Povejte, kaj se zgodi z zvokom in hrapavostjo, in obdelajte kos, ki se konča, ko je Ra največ trikrat tolikšen kot na začetku.
look-at-force-sound-and-ra-over-the-whole-li = Opazujte silo, zvok in Ra skozi vso obstojnost. Katere dele lahko razločite?
break-in-is-short-then-it-grows-steadily-the = Začetna obraba je kratka, nato raste enakomerno, nato hitro.
a-shorter-part-ends-before-the-end-of-the-li = Krajši obdelovanec se konča pred iztekom obstojnosti: čemu vam je na voljo dolžina?
from-the-sharp-tool-to-the-worn-one-what-doe = Kaj se dogaja z zvokom reza od ostrega do obrabljenega orodja?
it-gets-louder = Postaja glasnejši
it-stays-the-same = Ostaja enak
the-force-grows-with-the-wear-and-a-larger-f = Sila raste z obrabo, večja sila pa stroj bolj trese. Primerjajte zvok po 5 s z zvokom na koncu.
it-gets-quieter = Postaja tišji
a-worn-edge-does-not-cut-it-presses-that-tak = Obrabljen rob ne reže, temveč tišči: za to je potrebna večja sila. Primerjajte zvok po 5 s z zvokom na koncu.
choose-a-length-that-is-cut-before-the-surfa = Izberite dolžino, ki je obdelana, preden se površina pokvari.
stop-in-time = Ustavite pravočasno
a-tool-cuts-from-its-first-to-its-last-minut = Orodje reže od prve do zadnje minute, prikazano v 52 sekundah: ena sekunda pomeni šest minut. Vajenec pravi, da se nič ne sliši.
a-tool-s-life-heard-and-seen = Obstojnost orodja, slišana in videna

## assets/missions/choose-for-the-2005-part.toml

five-cuts-of-changing-depth-and-width-which = Pet rezov spremenljive globine in širine: kateri regulator in kako nastavljen?
it-takes-too-long-on-light-sections-the-feed = Traja predolgo. V lahkih odsekih se mora podajanje povečati.
the-largest-force-is-above-1050-n-feedback-s = Največja sila presega 1050 N. Povratna zveza težji odsek opazi šele, ko je orodje v njem: kaj ga pozna prej?
u-f-ref-f-modelled-1-exponent-corrected-by-t = u = (F_ref / F_model)^(1 / eksponent), popravljeno z izmerjeno silo
combined-system-2005-experiment-2-and-its-ta = Kombinirani sistem 2005, preizkus 2 in njegova preglednica 1; Pogled naprej: lastni regulator tega programa
feedback-answers-what-has-happened-on-a-part = Povratna zveza odgovarja na to, kar se je zgodilo. Na obdelovancu z znanimi odseki predkrmiljenje zmanjša podajanje pred odsekom, povratna zveza pa popravi, kar je model zgrešil. Skupaj sta boljša kot vsak zase.
cut-the-part-in-less-than-92-s-with-no-force = Obdelajte kos v manj kot 92 s, ne da bi sila presegla 1050 N.
where-does-the-largest-force-come-from-from = Od kod največja sila: od tam, kjer frezalo vstopi v globlji ali širši odsek, preden lahko to pove katera koli meritev.
what-could-a-controller-know-before-the-sect = Kaj bi lahko regulator vedel, preden pride odsek?
preview-reads-the-part-s-program = Pogled naprej bere program obdelovanca.
the-feed-is-lowered-by-feedback-from-the-mea = Podajanje zmanjšuje povratna zveza iz izmerjene sile. Kje je največja sila?
in-the-middle-of-the-deepest-section = Na sredini najglobljega odseka
there-the-controller-has-had-time-to-lower-t = Tam je imel regulator že čas zmanjšati podajanje. Poglejte prve trenutke odseka.
where-a-heavier-section-begins = Na začetku težjega odseka
at-the-end-of-each-cut = Na koncu vsakega reza
the-engagement-does-not-grow-there-look-at-w = Prijem tam ne raste. Poglejte, kje se začne težji odsek.
choose-and-tune = Izberite in nastavite
five-straight-cuts-of-different-depth-and-wi = Pet ravnih rezov različne globine in širine, zob za zobom, sila naj se drži pri 665 N. Pri stalnem podajanju je največja sila več kot dvakrat tolikšna. Naročnik plačuje po minutah; orodje se lomi po newtonih.
choose-and-tune-for-the-part-of-2005 = Izbira in nastavitev za obdelovanec iz 2005

## assets/missions/beat-it-by-hand.toml

you-are-the-controller-the-operator-s-knob-i = Vi ste regulator: operaterjev gumb je vaš.
the-knob-was-not-turned-during-the-cut-one-f = Gumba med rezom niste zavrteli. Eno podajanje za ves obdelovanec tu ni tisto, kar se zahteva.
the-override-went-beyond-120-where-a-machine = Korekcija je presegla 120 %, kjer se pult stroja konča.
ra-is-out-of-tolerance-on-more-than-15-of-th = Ra je na več kot 15 % dolžine zunaj tolerance. Pazite, kje se spremeni globina, in bodite tam trenutek prej.
sdnrp-holds-more-of-the-length-than-you-did = SDNRP drži večji del dolžine kot vi.
f-u-f-n-2-3-mm-f-f-n-2-0-mm-solved-for-the-o = F(u f, n, 2,3 mm) = F(f, n, 2,0 mm), rešeno za korekcijo u
sdnrp-2007-override-control-2005-combined-sy = SDNRP 2007 (vodenje s korekcijo); kombinirani sistem 2005 (povratna zveza in predkrmiljenje)
a-person-who-knows-the-part-does-what-feedfo = Človek, ki pozna obdelovanec, dela isto kot predkrmiljenje: ukrepa pred stopnico. Naporno je to početi ves dan, na vsakem kosu. Regulator s povratno zvezo obdelovanca ne pozna in se ne utrudi; regulator s pogledom naprej zmore oboje.
turn-the-knob-during-the-cut-so-that-ra-is-i = Med rezom vrtite gumb tako, da je Ra v toleranci na 85 % dolžine, bolje kot pri SDNRP.
at-45-mm-the-part-gets-deeper-at-85-mm-it-ge = Pri 45 mm rez postane globlji, pri 85 mm spet plitvejši. Kolikšna naj bo korekcija vmes?
the-command-arrives-80-ms-later-and-the-driv = Ukaz pride 80 ms pozneje, tudi pogon potrebuje svoj čas: začnite malo prej.
about-60-in-the-deeper-stretch-holds-ra-befo = Okoli 60 % v globljem odseku drži Ra; pred njim in za njim 100 %. Gumb zaskoči na vsaka 2 %.
which-override-holds-ra-in-the-deeper-stretc = Katera korekcija drži Ra v globljem odseku, v odstotkih od 300 mm/min?
read-the-feed-in-the-deeper-stretch-when-a-c = Odčitajte podajanje v globljem odseku, ko ga vodi regulator, ali poskusite: 15 % več globine potrebuje precej manj podajanja, ker se sila s podajanjem spreminja počasi.
cut-and-turn-the-knob-while-it-cuts-pausing = Obdelujte in med rezom vrtite gumb. Premor in vračanje sta dovoljena: kar zavrtite tam, nadomesti, kar je prišlo pozneje.
forty-years-ago-this-was-done-by-ear-with-a = Pred štiridesetimi leti so to delali po posluhu, z roko na korekciji. Obdelovanec ima globlji odsek in gumb za korekcijo podajanja je vaš: povlecite okoli njega ali ga zavrtite z miškinim kolescem, tipkama + in - ali s prstom. Zaslon Pult kaže, kar vidi operater, in vas na koncu oceni v primerjavi z vsemi regulatorji.
beat-the-controller-by-hand = Ročno boljši od regulatorja

## assets/missions/teach-in-feed-control.toml

a-control-that-learns-the-force-of-a-good-cu = Krmilje, ki se nauči sile dobrega reza in popusti, ko orodje ne reže več tako.
the-reference-of-the-first-cut-is-not-the-pe = Referenca prvega reza ni največja sila dobrega reza. Učite pri rezu, kot je pripravljen: rob se okruši šele med rezom.
the-feed-was-never-lowered-with-fmin-at-100 = Podajanje se ni nikoli zmanjšalo: s FMIN pri 100 % krmilje opazuje in ne stori ničesar.
with-the-chipped-edge-there-is-hardly-less-f = Z okrušenim robom je sila komaj kaj manjša kot brez regulacije. Je FMIN dovolj majhen in ali so reference od dobrega reza?
u-limit-f-1-f-m-fmin-fmax-f-m-1-3-f-1-u-0-6 = u = omeji(F_1 / F_m, FMIN, FMAX),  F_m = 1,3 F_1 u^0,6
adaptive-feed-control-afc-as-machine-control = Prilagodljiva regulacija podajanja (AFC), kot jo imajo krmilja strojev; hitrosti in pragovi so izbrani
teach-in-needs-no-model-the-good-part-is-the = Učenje ne potrebuje modela: dober kos je model. Zato deluje na vsakem stroju in zato mora biti prvi kos dober. Krmilje silo zmanjša, ne drži je: manjše podajanje zmanjša tudi to, kar bere, zato se umiri na pol poti. In okrušenega roba ne loči od tršega obdelovanca: pri obeh popusti, dnevnik pa to pokaže.
teach-in-the-good-part-then-let-the-control = Naučite z dobrim kosom, nato naj krmilje zmanjša podajanje, ko se rob okruši: v najglobljem odseku vsaj 7 % manj sile kot brez njega, obdelovanec cel.
the-reference-is-the-force-of-a-good-cut-wha = Referenca je sila dobrega reza. Kakšna bi bila, če bi jo naučili z okrušenim robom?
on-the-screen-console-the-button-afc-opens-t = Na zaslonu Pult gumb AFC... odpre okno krmilja. »Nauči« enkrat obdela kos, kot je pripravljen, z ostrim orodjem, in vpiše, kar je našel.
fmin-says-how-far-the-feed-may-go-down-with = FMIN pove, kako daleč se sme podajanje zmanjšati: pri 50 % je dovolj prostora. FMIN in FMAX pri 100 % samo opazujeta.
the-references-are-taught-in-fmin-and-fmax-a = Reference so naučene, FMIN in FMAX sta 100 %. Kaj stori krmilje, ko se rob okruši?
it-lowers-the-feed-until-the-force-is-that-o = Zmanjšuje podajanje, dokler sila ni enaka referenčni
it-may-go-no-lower-than-fmin-and-that-is-100 = Nižje od FMIN ne sme, ta pa je tu 100 %.
it-watches-the-feed-stays-and-an-overload-is = Opazuje: podajanje ostane, preobremenitev se javi
it-stops-the-machine-at-once = Stroj takoj ustavi
an-overload-has-to-last-for-more-than-a-seco = Preobremenitev mora trajati več kot sekundo, in kaj se tedaj zgodi, je izbrano: sporočilo, ustavitev, odmik in ustavitev.
where-does-the-feed-come-to-rest-in-the-deep = Kje se podajanje umiri v najglobljem odseku tretjega reza, čigar sila je njegova referenca, v odstotkih programiranega?
t-1-1-3-would-be-77-but-at-a-lower-feed-the-fo = 1 / 1.3 bi bilo 77 %. Toda pri manjšem podajanju je manjša tudi sila in z njo to, kar krmilje bere: u = 1 / (1.3 u^0.6).
the-control-sets-the-feed-to-reference-over = Krmilje nastavi podajanje na referenco, deljeno z izmerjeno silo. Pri enakem podajanju okrušeni rob potrebuje 30 % večjo silo; sila pa pada približno s potenco 0,6 podajanja.
teach-in-with-the-window-afc-of-the-screen-c = Naučite v oknu AFC na zaslonu Pult, FMIN in FMAX nastavite tam ali tukaj in obdelajte kos.
teach-in-set-fmin-and-cut = Naučite, nastavite FMIN in obdelajte
the-machine-s-control-has-adaptive-feed-cont-2 =
    Krmilje stroja ima prilagodljivo regulacijo podajanja, AFC: prvi kos se obdela s programiranim podajanjem in največja sila vsakega reza se shrani kot njegova referenca. Od tedaj podajanje sledi sili. Včeraj se je v drugem rezu okrušil rezalni rob, česar ni opazil nihče, dokler se orodje ni zlomilo. Danes se bo to po 12 s zgodilo znova.
    Taka regulacija zna še dvoje. Preobremenitev javi, kadar sila več kot 1 s ostane nad mejo, podajanje pa je že na FMIN: bolj popustiti ne more. In za preostanek reza se izključi, kadar operater korekcijo zmanjša za več kot 10 %: podajanje tedaj vodi roka.
set-up-feed-control-by-teach-in = Regulacija podajanja z učenjem

## assets/missions/quiet-speed.toml

at-one-speed-a-depth-chatters-at-another-the = Pri eni vrtilni hitrosti globina drdra, pri drugi je ista globina mirna.
it-still-chatters-in-the-deeper-stretch-the = V globljem odseku še vedno drdra. Karta pove, pri katerih vrtilnih hitrostih je 2 mm pod mejo.
b-lim-1-2-k-s-mu-re-g-omega-min = b_lim = -1 / (2 K_s mu Re[G(omega)]_min)
tobias-and-fishwick-1958-tlusty-and-polacek = Tobias in Fishwick 1958, Tlusty in Polacek 1963; stroj iz 2019
a-tooth-cuts-into-the-wave-that-the-tooth-be = Zob reže v val, ki ga je pustil zob pred njim. Če ga sreča v fazi, je odrezek enakomeren in rez miren; če ne, debelina odrezka niha in hrani vibracijo. Faza je odvisna od vrtilne hitrosti, zato so mirne hitrosti med režnji.
find-a-spindle-speed-at-which-the-deeper-str = Poiščite vrtilno hitrost vretena, pri kateri se globlji odsek obdela brez drdranja, s programiranim podajanjem.
the-stability-chart-on-screen-machine-shows = Karta stabilnosti na zaslonu Stroj kaže, katera globina je pri kateri vrtilni hitrosti mirna.
chatter-depends-on-where-in-its-vibration-th = Drdranje je odvisno od tega, kje v svojem nihanju zob sreča val, ki ga je pustil prejšnji zob: to je stvar vrtilne hitrosti, v režnjih.
look-for-a-place-where-the-limit-is-above-2 = Poiščite mesto, kjer je meja nad 2 mm: eno je blizu 1571 1/min.
what-helps = Kaj pomaga?
only-a-lower-speed = Samo manjša vrtilna hitrost
lower-is-not-quieter-as-such-below-each-quie = Manjša ni sama po sebi mirnejša: pod vsako mirno hitrostjo je še en reženj, ki drdra.
only-a-higher-speed = Samo večja vrtilna hitrost
higher-is-not-quieter-as-such-at-1900-1-min = Večja ni sama po sebi mirnejša: pri 1900 1/min drdra tako kot pri 1800. Poglejte karto.
a-certain-speed-there-are-quiet-ones-between = Določena vrtilna hitrost: med režnji so mirne
at-1800-1-min-the-stretch-of-2-mm-chatters = Pri 1800 1/min odsek z 2 mm drdra.
choose-a-speed-by-the-chart-and-cut = Izberite vrtilno hitrost po karti in obdelajte.
find-it = Poiščite jo
the-deeper-stretch-sings-and-its-marks-can-b = Globlji odsek poje in njegove sledi je mogoče otipati. Globina je na risbi, zato ostane. »Počasneje,« pravi eden. »Hitreje,« pravi drugi.
a-quiet-speed-between-two-lobes = Mirna hitrost med dvema režnjema

## assets/missions/plan-and-what-binds.toml

the-fastest-cut-within-seven-limits-which-of = Najhitrejši rez v okviru sedmih omejitev: katere od njih ga zadržujejo?
the-programmed-feed-is-not-that-of-the-optim = Programirano podajanje ni podajanje optimuma.
the-programmed-speed-is-not-that-of-the-opti = Programirana vrtilna hitrost ni hitrost optimuma.
least-time-within-g-i-f-n-0-i-1-to-7 = najkrajši čas znotraj g_i(f, n) <= 0, i = 1 do 7
control-strategy-2013-particle-swarm-the-lim = Strategija vodenja 2013 (roj delcev); omejitve same so izbrane, članek svojega seznama ne navaja
an-optimum-within-limits-lies-on-some-of-the = Optimum v okviru omejitev leži na nekaterih od njih. Dejavne omejitve povedo, za kaj se splača plačati: tu za silo, ki stoji namesto hrapavosti, in obstojnost roba. Desetkratna moč ne bi prihranila niti sekunde.
plan-the-cut-program-what-the-plan-found-and = Načrtujte rez, programirajte, kar je načrt našel, in povejte, katere omejitve so dejavne.
screen-plan-shows-the-limits-as-lines-over-f = Zaslon Načrt kaže omejitve kot črte nad podajanjem in vrtilno hitrostjo ter v tabeli z rezervo vsake.
a-limit-binds-where-nothing-is-left-of-it-th = Omejitev je dejavna, kjer nima več rezerve: optimum leži na njeni črti.
use-the-plan-s-button-to-program-the-optimum = Z gumbom načrta programirajte optimum: približno 167 mm/min pri 2196 1/min.
which-limits-bind-at-the-optimum = Katere omejitve so v optimumu dejavne?
spindle-power-and-spindle-speed = Moč vretena in vrtilna hitrost vretena
look-at-what-is-left-of-them-in-the-table-ne = Poglejte v tabeli njihovo rezervo: skoraj vsa moč, pol vrtilne hitrosti. Močnejše vreteno ne bi spremenilo ničesar.
cutting-force-and-tool-life = Rezalna sila in obstojnost orodja
cutter-deflection-and-feed = Upogib frezala in podajanje
look-at-what-is-left-of-them-in-the-table-mo = Poglejte v tabeli njihovo rezervo: večina obeh. Reza ne zadržujeta.
run-the-plan-on-screen-plan = Zaženite načrt na zaslonu Načrt.
program-the-optimum-and-cut-the-part = Programirajte optimum in obdelajte kos.
program-it = Programirajte
before-the-first-chip-the-swarm-looks-for-th = Pred prvim odrezkom roj išče podajanje in vrtilno hitrost, ki kos obdelata najhitreje v okviru sedmih omejitev. Vodja obrata sprašuje: kaj naj kupimo, da bomo hitrejši, močnejše vreteno ali boljši rezalni rob?
plan-a-cut-and-say-what-binds = Načrtujte rez in povejte, kaj ga omejuje

## assets/missions/outside-its-range.toml

what-a-controller-promises-with-models-that = Kaj regulator obljublja z modeli tam, kjer jih ni nihče preizkusil.
for-more-than-half-of-the-cut-a-model-is-out = Več kot polovico reza je kak model zunaj svojega območja: kar pove tam, ni nihče izmeril.
the-target-is-not-held-over-85-of-the-length = Cilj ne drži na 85 % dolžine.
k1-k5-valid-between-the-least-and-largest-va = K1..K5: veljajo med najmanjšimi in največjimi vrednostmi iz preglednice 3
a-formula-answers-everywhere-it-is-known-onl = Formula odgovori povsod; znana je samo tam, kjer so jo izmerili. Zunaj program nadaljuje z naklonom na robu in to pove. Lučka, ki pravi »zunaj«, je vredna več kot število s tremi števkami.
find-the-roughest-target-that-is-held-over-8 = Poiščite najbolj hrapav cilj, ki drži na 85 % dolžine, pri čemer so modeli večino reza v svojem območju.
the-chips-for-k1-to-k5-say-which-model-is-ou = Oznake K1 do K5 povedo, kateri model je zunaj območja, iz katerega je bil narejen.
table-3-of-2007-has-targets-from-0-38-to-1-5 = Preglednica 3 iz 2007 ima cilje od 0,38 do 1,52 µm. Onstran tega formule le nadaljujejo z robnim naklonom.
try-1-2-m-then-go-up-until-the-lamps-light-f = Poskusite 1,2 µm, nato povečujte, dokler lučke ne svetijo več kot polovico reza.
what-roughness-does-the-part-get-at-the-end = Kakšno hrapavost v µm dobi obdelovanec na koncu?
the-feed-that-the-model-asks-for-is-more-tha = Podajanje, ki ga zahteva model, je večje, kot ga dopušča korekcija: ukaz obstane na meji in Ra z njim.
the-target-is-4-m = Cilj je 4 µm.
lower-the-target-until-the-models-can-be-bel = Zmanjšajte cilj, dokler modelom ni mogoče verjeti.
find-the-end-of-what-is-known = Poiščite konec znanega
for-a-roughing-cut-somebody-sets-the-target = Za grobi rez nekdo nastavi cilj na Ra 4 µm. Regulator ima formulo tudi za to, kot za vse: formule vedno odgovorijo.
a-model-outside-its-range = Model zunaj svojega območja

## assets/missions/read-the-errata.toml

why-the-printed-equation-cannot-have-made-th = Zakaj natisnjena enačba ni mogla dati natisnjene preglednice.
the-force-after-15-s-is-not-within-1-of-the = Sila po 15 s ni v mejah 1 % od 166,5 N, ki jih navaja preglednica 3.
k2-f-0-for-f-177-07-n-as-printed-table-3-has = K2(F) < 0 za F < 177,07 N, kot je natisnjeno; preglednica 3 ima sile od 166,5 N naprej
sdnrp-2007-equation-5-and-table-3-errata-of = SDNRP 2007, enačba 5 in preglednica 3; tiskovne napake v tem programu
printed-constants-lose-digits-signs-and-unit = Natisnjene konstante po poti izgubljajo števke, predznake in enote. Kdor ponovi rezultat, preveri, ali se enačba in preglednica ujemata, in pove, kateri je verjel in zakaj.
find-the-calibration-with-which-simulation-1 = Poiščite umeritev, s katero simulacija 1 iz preglednice 3 da natisnjeno vrednost: 166,5 N po 15 s.
cut-simulation-1-with-the-models-as-printed = Izvedite simulacijo 1 z modeli, kot so natisnjeni, in poglejte silo po 15 s.
k2-as-printed-gives-the-feed-for-a-force-put = K2, kot je natisnjen, da podajanje za silo. Vstavite vanj 166 N: kaj pride ven?
the-calibration-identified-takes-its-constan = Umeritev `identificirano` jemlje konstante iz same preglednice, ker natisnjene ne morejo biti prave.
why-can-k2-as-printed-not-have-made-table-3 = Zakaj K2, kot je natisnjen, ni mogel dati preglednice 3?
it-gives-forces-that-are-too-small = Daje premajhne sile
k2-gives-a-feed-not-a-force-read-its-erratum = K2 da podajanje, ne sile. Še enkrat preberite njegovo tiskovno napako.
its-feed-is-negative-for-half-of-the-forces = Njegovo podajanje je za polovico sil v preglednici negativno
its-unit-is-wrong-mm-instead-of-m = Njegova enota je napačna: mm namesto µm
that-is-another-erratum-of-the-reference-rou = To je druga tiskovna napaka, pri referenčni hrapavosti. Poiščite K2, enačba 5.
open-the-errata-on-screen-papers-and-the-car = Odprite tiskovne napake na zaslonu Članki in kartico K2.
read = Preberite
choose-the-calibration-that-repeats-the-row = Izberite umeritev, ki ponovi vrstico.
repeat-the-table = Ponovite preglednico
you-are-asked-to-build-what-a-paper-describe = Zgraditi morate, kar opisuje članek. Enačbe so natisnjene, rezultati tudi. Rezultate poskusite dobiti iz enačb in nič se ne ujema.
read-the-errata = Preberite tiskovne napake
