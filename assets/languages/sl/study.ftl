# Slovenščina

## crates/study/src/afc.rs

cut-number-is-not-reached-within-run-duratio = reza { $number } ni mogoče doseči v `run.duration_s`, { $limit } s
cut-number-refused = rez { $number }: { $refused }

## crates/study/src/compare/by_hand.rs

your-hand-2 = Vaša roka
name-alone-holds-it-in-time-s = toleranco drži samo { $name }, v { $time } s
count-ways-of-control-hold-it-name-the-faste =
    { $count ->
        [one] toleranco drži { $count } regulator, najhitreje { $name }, v { $time } s
        [two] toleranco držita { $count } regulatorja, najhitreje { $name }, v { $time } s
        [few] toleranco držijo { $count } regulatorji, najhitreje { $name }, v { $time } s
       *[other] toleranco drži { $count } regulatorjev, najhitreje { $name }, v { $time } s
    }
no-way-of-control-holds-it-either = tudi noben regulator ne drži tolerance
your-cut-did-not-come-to-its-end-so-it-has-n = Vaš rez ni prišel do konca, zato nima uvrstitve ({ $why }); { $best }.
nothing-of-your-cut-can-be-judged-so-it-has = V vašem rezu ni mogoče ničesar oceniti, zato nima uvrstitve; { $best }.
you-held-ra-in-tolerance-on-inside-of-the-le = Ra ste držali v toleranci na { $inside } % dolžine, zahteva se { $asked } %: brez uvrstitve; { $best }.
you-held-the-force-in-tolerance-on-inside-of = Silo ste držali v toleranci na { $inside } % dolžine, zahteva se { $asked } %: brez uvrstitve; { $best }.
you-held-ra-in-tolerance-on-inside-of-the-le-2 = Ra ste držali v toleranci na { $inside } % dolžine
you-held-the-force-in-tolerance-on-inside-of-2 = Silo ste držali v toleranci na { $inside } % dolžine
begin-and-no-way-of-control-holds-it-the-cut = { $begin }, noben regulator pa je ne drži: rez je vaš.
as-fast-as-name = enako hitro kot { $name }
time-s-slower-than-name = { $time } s počasneje kot { $name }
time-s-faster-than-name = { $time } s hitreje kot { $name }
begin-and-come-in-as-number-rank-of-the-of-w = { $begin } in dosegli { $rank }. mesto od { $of }, ki držijo toleranco: { $than }, najhitrejši regulator.
cuts-2 = rezi

## crates/study/src/compare/entrants.rs

conventional = Običajno
division = Delilni
adjustable-pi = Nastavljivi PI
p-smith-predictor = P, Smithov prediktor
mrac-one-gain = MRAC, eno ojačanje
preview = Pogled naprej
tracking = Sledenje
own-script = Lasten skript

## crates/study/src/compare/iterations.rs

runs = simulacije

## crates/study/src/compare/load_step.rs

never-back = se ne vrne

## crates/study/src/compare/outcome.rs

periods-2 = periode
more-is-better = Več je bolje.
less-is-better = Manj je bolje.

## crates/study/src/compare/outside.rs

ra-lies-within-its-tolerance-wherever-it-is = Ra je v svoji toleranci povsod, kjer se ocenjuje
the-force-lies-within-its-tolerance-wherever = sila je v svoji toleranci povsod, kjer se ocenjuje
the-machine-s-vibration-leaves-it-without-dy = vzrok so vibracije stroja, brez dinamike je Ra znotraj
feed-and-speed-stay-as-programmed-whatever-t = podajanje in vrtilna hitrost ostaneta, kot sta programirana, kar koli že počne rez
it-is-not-taught-in-so-the-feed-stays-as-pro = ni naučena, zato podajanje ostane, kot je programirano
on-share-of-that-it-is-unstable-feed-and-for = na { $share } % tega je nestabilno, podajanje in sila nihata, ne da bi izzvenela
on-share-of-that-a-command-stands-at-its-lim = na { $share } % tega je ukaz na svoji meji
it-holds-the-force-and-leaves-to-the-model-w = drži silo in prepušča modelu, kakšen Ra iz tega nastane
its-law-does-not-integrate-an-error-remains = njegov zakon ne integrira: v mirovanju ostane pogrešek
it-takes-time-after-each-change-and-noise-mo = po vsaki spremembi potrebuje čas, šum pa ga premika
it-takes-time-after-each-change = po vsaki spremembi potrebuje čas
ra-lies-above-its-tolerance-on-above-and-bel = Ra je na { $above } % dolžine nad toleranco in na { $below } % pod njo: { $cause }
ra-lies-above-its-tolerance-on-share-of-the = Ra je na { $share } % dolžine nad svojo toleranco: { $cause }
ra-lies-below-its-tolerance-on-share-of-the = Ra je na { $share } % dolžine pod svojo toleranco: { $cause }
the-force-lies-above-its-tolerance-on-above = sila je na { $above } % dolžine nad toleranco in na { $below } % pod njo: { $cause }
the-force-lies-above-its-tolerance-on-share = sila je na { $share } % dolžine nad svojo toleranco: { $cause }
the-force-lies-below-its-tolerance-on-share = sila je na { $share } % dolžine pod svojo toleranco: { $cause }

## crates/study/src/compare/robustness.rs

no-dead-time = brez mrtvega časa
dead-time-40-ms = mrtvi čas 40 ms
dead-time-80-ms = mrtvi čas 80 ms
t-16mncrsi5-in-place-of-ck45 = 16MnCrSi5 namesto Ck45
name-before-and-after-kn = { $name } { $before } in { $after } kN
unks-is-insensitive-to-the-workpiece-s-mater = UNKS ni občutljiv za material obdelovanca
largest-force-in-ck45-and-in-16mncrsi5-list = največja sila v Ck45 in v 16MnCrSi5: { $list }

## crates/study/src/compare/table_1.rs

the-part-eight-candidates-were-tried-convent = obdelovanec: preizkušenih je bilo osem kandidatov; vrstica običajnega frezanja je z njim umerjena, ne napovedana, prav tako najboljši možni čas blizu 88 s; pot 488 mm sledi iz 115 s
inhomogeneity-5-run-out-3-um-air-feed-150-de = nehomogenost 5 %, opletanje 3 µm, podajanje v zraku 150 %, mrtvi čas 40 ms: enkrat nastavljeno po verjetnosti, glede na običajno frezanje in idealni regulator
p-kp-1-1-is-the-stability-limit-at-the-heavi = P: Kp = 1.1 je meja stabilnosti v najtežjem odseku; s Smithovim prediktorjem 1,6, od sedmih vrednosti najbližja članku
mrac-some-25-settings-of-two-structures-were = MRAC: preizkušenih je bilo kakih 25 nastavitev dveh zgradb; priložena petparametrska je najbližja preglednici, tista z enim ojačanjem je najboljša in ji ni podobna; petparametrska dvigne korekcijo za največ 10 % na periodo, saj jo je pri 30 % izjemna sila ustavila pri 3 od 20 semen
division-of-three-readings-the-static-one-si = delilni: od treh razlag statična, saj je edina stabilna, porabi kakih 98 s in ima obenem slab Nsn
adjustable-pi-and-unks-first-guesses-kept-af = nastavljivi PI in UNKS: prvi poskusi, ohranjeni po 11 in 9 drugih nastavitvah; niso prilagojeni preglednici, vendar sta bila njihov Nsn in največja sila vidna med izbiro obdelovanca
experiment-1-lengths-and-depths-are-chosen-s = Preizkus 1: dolžine in globine so izbrane tako, da je zadnji odsek pri 650 N in pridobitev blizu 27 %
not-used-for-any-choice-dead-times-and-mater = neuporabljeno za izbiro: mrtvi časi in materiali preglednice robustnosti, referenčne simulacije brez šuma; kaj velja za vrnitev po stopnici obremenitve, je bilo dvakrat določeno na novo, ker prvi dve določitvi nista nikoli nastopili
the-figures-with-the-part-and-the-traces-are = manjkajo slike z obdelovancem in poteki: ujemanje kaže le, da je preglednica s pravimi konstantami sile in mejo 150 % fizikalno mogoča, nič več
division-0-29-and-1-25-kn-static-division-is = delilni 0,29 in 1,25 kN: statično deljenje je gladko že po zgradbi; z zadnjim ukazom niha, upočasnjeno pa je boljše od natisnjenega, ne slabše
pi-94-s-any-integrating-controller-runs-the = PI 94 s: vsak integrirajoči regulator gre skozi lahke odseke pri meji 150 % in tu ne potrebuje več kot kakih 89 s; 6 s med PI in UNKS pri skoraj enakem Nsn ne more izvirati le iz držanja sile
mrac-s-time-in-every-run-with-five-parameter = čas MRAC v vsaki simulaciji: s petimi parametri ima izbruhe in pri nekaterih semenih ga ustavi preobremenitev; z enim ojačanjem izbruhov nima
p-0-20-kp-1-1-is-all-that-the-dead-time-leav = P 0,20: Kp = 1.1 je vse, kar pusti mrtvi čas; s Smithovim prediktorjem in 1,6 se približa
mrac-0-90-unks-0-91-and-pi-1-00-kn-reached-o = MRAC 0,90, UNKS 0,91 in PI 1,00 kN: doseženo samo pri gladkem procesu; zob za zobom opletanje in nehomogenost dodata svoje konice k temu, kar se drži
the-time-of-an-optimisation-step-what-was-ti = čas optimizacijskega koraka: kaj je bilo merjeno in kaj so njegove iteracije, ni povedano; tu so navedeni strošek posodobitve in regulacijske periode po stopnici obremenitve
mrac-s-response-8-longer-constant-roughness = za 8 % daljši odziv MRAC, stalna hrapavost, učne krivulje: članek nima podatkov
no-run-has-given-it = ni je dala še nobena simulacija
name-measure-within-percent-of-wanted = { $name }: { $measure } v mejah { $percent } % od { $wanted }
mean-off = { $mean }, { $off } %
mean-off-over-the-finished-of-runs-runs-that = { $mean }, { $off } % v { $finished } od { $runs } simulacij, ki so prišle do konca
unks-and-pi-the-next-has-next = { $unks } in { $pi }; naslednji ima { $next }
unks-and-adjustable-pi-are-the-two-best-in-n = UNKS in nastavljivi PI sta najboljša po Nsn
unks-measure-at-most-most = UNKS: { $measure } največ { $most }
n-periods-after-the-load-step =
    , { $n ->
        [one] { $n } perioda
        [two] { $n } periodi
        [few] { $n } periode
       *[other] { $n } period
    } po stopnici obremenitve
unstable-after-the-load-step = , po stopnici obremenitve nestabilno
never-back-after-the-load-step = , po stopnici obremenitve se ne vrne
name-error-time-s-step = { $name } ({ $error } %, { $time } s{ $step })
nobody-is-within-percent-next-is-next = v mejah { $percent } % ni nikogar, naslednji je { $next }
within-percent-of-it-list = v mejah { $percent } % od njega { $list }
least-nsn-name-with-error-in-time-s-step-bes = najmanjši Nsn: { $name }, { $error } v { $time } s{ $step }; { $beside }
measure-in-unit = { $measure } v { $unit }

## crates/study/src/csv_table.rs

there-is-no-line-with-the-names-of-the-colum = ni vrstice z imeni stolpcev
line-line-has-values-values-for-columns-colu = vrstica { $line }: vrednosti je { $values }, stolpcev { $columns }; med števili z decimalno vejico morajo biti podpičja, kot v `0,5;1,2`
line-line-has-values-values-for-columns-colu-2 = vrstica { $line }: vrednosti je { $values }, stolpcev { $columns }
line-line-name-is-cell-allowed-is-a-finite-n = vrstica { $line }: `{ $name }` je `{ $cell }`: dovoljeno je končno število
line-line-comma-has-a-comma-which-separates = vrstica { $line }: `{ $comma }` ima vejico, ki v tej tabeli ločuje vrednosti: pišite decimalno piko ali ločite vrednosti s podpičji
line-line-has-comma-line-other-cell-write-al = vrstica { $line } ima `{ $comma }`, vrstica { $other } `{ $cell }`: vsa števila pišite z istim decimalnim znakom in brez ločil tisočic
there-is-no-line-with-the-names-of-the-colum-2 = ni vrstice z imeni stolpcev; potrebni so { $needed }
the-columns-are-found-missing-are-missing-ne = stolpci so { $found }; manjkajo { $missing }; potrebni so { $needed }
the-column-name-stands-there-more-than-once = stolpec { $name } je naveden več kot enkrat

## crates/study/src/errata.rs

t-1-0-001024-s-2-0-064-s-1-beside-natural-freq = 1 / (0.001024 s^2 + 0.064 s + 1) ob »lastni frekvenci 3 Hz in umiritvenem času 0,4 s«
its-natural-frequency-is-4-97-hz-critically = njena lastna frekvenca je 4,97 Hz, kritično dušena; 3,2 Hz je njena pasovna širina -3 dB; na 2 % se umiri v 0,19 s, na 0,5 % v 0,24 s
both-are-kept-as-separate-drives-2013-eq1-an = obe sta ohranjeni kot ločena pogona, 2013_eq1 in measured_3hz
dead-time-2 = mrtvi čas
the-paper-has-none-2013-has-0-04-s-2007-e-0 = članek ga nima; 2013 ima 0,04 s, 2007 e^(-0.08 s)
t-0-04-s-two-control-periods-papers-paper-2005 = 0,04 s, dve regulacijski periodi; `papers --paper 2005 --robustness` pokaže 0, 40 in 80 ms
radial-depth-r-d-4-mm-in-the-english-text-3 = radialna globina R_D: 4 mm v angleškem besedilu, 3 mm v slovenskem
they-differ-and-so-does-the-force-404-agains = razlikujeta se, sila tudi: 404 proti 281 N pri 0,08 mm in A_D = 2 mm
presets-experiment-1-with-4-mm-and-experimen = prednastavitvi experiment-1 s 4 mm in experiment-1-sl s 3 mm; 280 N kot želena sila spada k 3 mm (`steadycut force`)
experiment-1-desired-force-280-n-in-the-set = Preizkus 1: želena sila 280 N v opisu preizkusa, 650 N v razpravi
at-r-d-4-mm-already-the-starting-depth-takes = pri R_D = 4 mm že začetna globina zahteva 404 N
t-650-n-with-r-d-4-mm-280-n-with-r-d-3-mm = 650 N pri R_D = 4 mm, 280 N pri R_D = 3 mm
experiment-2-desired-force-650-n-in-the-text = Preizkus 2: želena sila 650 N v besedilu, 0,665 kN v preglednici 1
they-differ-by-2 = razlikujeta se za 2 %
t-665-n = 665 N
experiment-1-a-time-saving-of-40-with-one-cu = Preizkus 1: »40 % prihranka časa z enim rezom«
with-an-override-of-at-most-150-no-more-than = s korekcijo največ 150 % ni mogoče več kot 33,3 %, 27 % večji odvzem pa je 21 % časa
the-gain-in-removal-rate-is-judged-the-time = ocenjuje se povečanje odvzema; čas se navede
table-1-times-of-88-to-115-s = Preglednica 1: časi od 88 do 115 s
t-0-08-mm-two-teeth-and-1591-5-1-min-are-254-6 = 0,08 mm, dva zoba in 1591,5 1/min je 254,65 mm/min, torej je 115 s pot 488 mm in 76,7 s najmanj pri 150 %
all-six-times-fit-a-constant-programmed-feed = vseh šest časov ustreza stalnemu programiranemu podajanju: obdelovanec ima 488 mm
returns-the-cutting-force-value-to-the-desir = »vrne vrednost rezalne sile na raven želene vrednosti najkasneje v štirih iteracijah«; slovensko besedilo doda 2 ms
t-0-5-ms-each-cannot-be-samples-of-20-ms = po 0,5 ms ne morejo biti vzorci po 20 ms
read-as-iterations-of-the-internal-loop-with = razumljeno kot iteracije notranje zanke z NM-1 znotraj regulacijske periode
sampling-time-20-ms-28-8-khz = čas vzorčenja 20 ms, 28,8 kHz
t-576-samples-hold-one-tooth-period-of-18-85-m = 576 vzorcev obsega eno periodo zoba 18,85 ms, zato opletanje naredi eno konico visoko in naslednjo nizko
kept-what-is-judged-as-a-transient-is-the-me = ohranjeno; kot prehodni pojav se ocenjuje povprečje štirih konic
fig-5-a-step-of-the-feed-from-0-05-to-2-mm-t = Sl. 5: skok podajanja z 0,05 na 2 mm/zob
t-2-mm-a-tooth-would-break-a-cutter-of-16-mm = 2 mm na zob bi zlomilo frezalo 16 mm
read-as-0-2-mm-tooth = razumljeno kot 0,2 mm/zob
the-optimized-feedrate-would-always-be-equal = »optimirano podajanje bi vedno ustrezalo referenčni največji sili«
a-feed-is-no-force-mistranslated = podajanje ni sila: napačno prevedeno
read-as-the-right-override-would-be-100 = razumljeno: prava korekcija bi bila 100 %
a-d-and-r-d-in-the-english-text = »A_D« in »R_D« v angleškem besedilu
in-another-order-than-in-the-slovene = v drugem vrstnem redu kot v slovenskem
a-d-is-the-axial-depth-r-d-the-radial-one = A_D je aksialna globina, R_D radialna
fig-6-0-07-0-35-2-1-0-09-0-37-0-4 = Sl. 6: 0.07, 0.35, 2.1, 0.09, 0.37, 0.4
without-names-presumably-learning-rates-and = brez imen; verjetno hitrosti učenja in momenti po plasteh
not-used-the-ranges-of-2013-are = neuporabljeno; uporabljena so območja iz 2013
table-1-optimization-time-and-iterations-0-0 = Preglednica 1: »čas optimizacije« in »iteracije«, od 0,001 s / 18 do 0,012 s / 34
what-was-timed-and-what-was-counted-is-not-s = kaj je bilo merjeno in kaj šteto, ni povedano
beside-them-stand-a-controller-s-cost-per-up = ob njih so strošek regulatorja na posodobitev in njegove regulacijske periode po stopnici obremenitve
eq-2-the-normalised-standard-error-over-n-20 = en. 2, normirana standardna napaka, prek n = 20 vzorcev
which-20-is-not-said-the-spread-over-seeds-i = katerih 20, ni povedano; raztros po semenih je približno 0,02
over-all-samples-in-contact-the-form-with-20 = prek vseh vzorcev v stiku; ob njej je oblika z 20 enakomerno razporejenimi
t-8-s-time-delay = »t = 8 s: čas zakasnitve«
the-transfer-functions-have-e-0-08-s = prenosne funkcije imajo e^(-0.08 s)
dead-time-0-08-s = mrtvi čas 0,08 s
eq-2-s-14-0-s-2-155-s-35500 = en. 2: (s + 14.0) + (s^2 + 155 s + 35500)
a-sum-has-no-unit-gain-at-rest = vsota v mirovanju nima ojačanja ena
a-product-14-x-35500-497000-the-printed-nume = zmnožek: 14 x 35500 = 497000, natisnjeni števec
eq-1-with-the-constants-of-table-1 = en. 1 s konstantami iz preglednice 1
gives-582508-s-3-169-0-s-2-38699-7-s-582508 = da 582508 / (s^3 + 169.0 s^2 + 38699.7 s + 582508), z drugimi poli kot en. 2
both-are-kept-as-separate-drives-2007-eq1-an = obe sta ohranjeni kot ločena pogona, 2007_eq1 in 2007_eq2
reference-roughness-0-81-mm = »referenčna hrapavost 0,81 mm«
the-unit = enota
t-0-81-um = 0,81 µm
k2-eq-5 = K2, en. 5
the-feed-is-negative-for-every-force-below-1 = podajanje je negativno za vsako silo pod 177,07 N, torej za polovico preglednice 3
re-identified-the-printed-form-runs-with-its = na novo identificirano; natisnjena oblika teče z omejenimi ukazi in oznako zunaj območja
k1-eq-4 = K1, en. 4
k1-0-81-um-188-0-n-where-table-3-has-178-5-n = K1(0,81 µm) = 188,0 N, kjer ima preglednica 3 178,5 N; pri 0,38 µm 139,7 N proti 161,4 N
re-identified-from-table-3 = na novo identificirano iz preglednice 3
k3-eq-6 = K3, en. 6
gives-about-4100-1-min-where-table-3-has-abo = da približno 4100 1/min, kjer ima preglednica 3 približno 2100 1/min
k4-eq-7 = K4, en. 7
exceeds-the-table-s-final-force-from-the-tab = iz končnega podajanja in vrtilne hitrosti preglednice preseže njeno končno silo za 32,8 N v simulacijah 1 do 9
only-the-intercept-is-wrong-253-66-in-place = napačen je samo prosti člen: 253,66 namesto 286,44 N ustreza vsem desetim vrsticam na 0,75 N
table-3-simulation-10-final-force-195-2-n = Preglednica 3, simulacija 10: končna sila 195,2 N
from-the-table-s-own-feed-and-speed-the-rest = iz podajanja in vrtilne hitrosti same preglednice da obnovljeni K4 190,2 N, kar tudi leži na krivulji sila-hrapavost vseh drugih vrstic
taken-as-a-misprint-of-190-2-n-the-printed-v = vzeto kot tiskovna napaka za 190,2 N; natisnjena vrednost je prikazana ob njej
k5-eq-8 = K5, en. 8
misses-the-table-s-roughness-by-up-to-30 = hrapavost preglednice zgreši za do 30 %
the-exact-inverse-of-the-re-identified-k1 = natančen inverz na novo identificiranega K1
findings-deviation-of-ra-at-most-4-1-of-forc = ugotovitve: odstopanje Ra največ 4,1 %, sile največ 5,2 %
in-the-paper-s-own-table-3-the-final-ra-is-o = v sami preglednici 3 končni Ra odstopa od cilja od +31,6 % (simulacija 1) do -22,4 % (simulacija 10)
the-table-s-own-deviations-are-reported = navedena so odstopanja same preglednice
k1-to-k5-by-genetic-programming-from-185-mea = K1 do K5 z genetskim programiranjem iz 185 meritev
the-measurements-were-never-published-and-th = meritve niso bile nikoli objavljene, končna podajanja in vrtilne hitrosti preglednice pa ležijo na eni premici (korelacija -0,995), iz česar ni mogoče dobiti formule obeh
calibration-genetic-k1-k2-k3-and-k5-found-an = umeritev genetic: K1, K2, K3 in K5 na novo najdeni v preglednici 3 z genetskim programiranjem, K4 natisnjena oblika s prilagojenimi konstantami (`steadycut identify genetic`); vseh 40 končnih vrednosti je v svojih pasovih
eq-3-m2-10-05-f-4 = en. 3 (M2): »10^05 F^4«
can-only-be-10-5-and-rounded-so-m2-gives-neg = je lahko le 10^-5; in tako zaokrožen da M2 pri vsaki sili preglednice 1 negativna podajanja v tisočih
restored-with-1-426371e-5-f-4-1-015767e-2-f = obnovljeno z 1.426371e-5 F^4 - 1.015767e-2 F^3, kar iz želenih sil da končna podajanja preglednice 3 iz 2007; na novo identificirano iz preglednice 1
eq-4-m3-exponent-0-004 = en. 4 (M3): eksponent -0,004
gives-about-3700-1-min-where-table-1-has-abo = da približno 3700 1/min, kjer ima preglednica 1 približno 2200 1/min
restored-with-0-0071-which-gives-the-final-s = obnovljeno z -0,0071, kar iz začetnih sil da končne vrtilne hitrosti na 4,7 %; na novo identificirano
eq-6-m5-leading-coefficient-0-0001 = en. 6 (M5): vodilni koeficient 0,0001
gives-0-11-to-0-14-um-where-table-1-has-0-44 = da 0,11 do 0,14 µm, kjer ima preglednica 1 0,44 do 0,99 µm, in se obrne pri 170,5 N, znotraj preglednice
restored-with-0-00012025-least-squares-which = obnovljeno z 0,00012025 (najmanjši kvadrati), kar še vedno zgreši za do 0,19 µm; na novo identificirano kot natančen inverz M1
eq-2-m1 = en. 2 (M1)
m1-0-40-um-135-6-n-where-table-1-starts-from = M1(0,40 µm) = 135,6 N, kjer preglednica 1 začne s 164,5 N in konča pri 157,5 N; pri 1,11 µm 219,5 N proti 188,1 N
re-identified-from-table-1 = na novo identificirano iz preglednice 1
eq-5-m4 = en. 5 (M4)
exceeds-the-table-s-final-force-from-the-tab-2 = iz končnega podajanja in vrtilne hitrosti preglednice preseže njeno končno silo za 12 do 28 N, začetno pa za 27 do 36 N; noben prosti člen tega ne popravi
the-printed-form-with-its-intercept-and-feed = natisnjena oblika z na novo identificiranima prostim členom in koeficientom podajanja, koeficient vrtilne hitrosti kot natisnjen
eq-1-1-0-001024-s-2-0-064-s-1-beside-natural = en. 1: 1 / (0.001024 s^2 + 0.064 s + 1) ob »lastni frekvenci 3 Hz in umiritvenem času 0,4 s«
its-natural-frequency-is-4-97-hz-critically-2 = njena lastna frekvenca je 4,97 Hz, kritično dušena; 3,2 Hz je njena pasovna širina -3 dB
both-are-kept-as-separate-drives = obe sta ohranjeni kot ločena pogona
neural-network-predictions-were-by-4-closer = »napovedi nevronske mreže so bile za 4 % bliže meritvam v primerjavi s 6 %«
the-3500-measurements-were-never-published-r = 3500 meritev ni bilo nikoli objavljenih; razumljeno kot srednji napaki 4 % in 6 %
networks-and-formulas-are-trained-on-one-dat = mreže in formule so naučene na istem naboru podatkov iz mehanističnega modela sile z merilnim šumom, formula z genetskim programiranjem; njihove napake stojijo ob tistih iz članka, naj držijo ali ne (`steadycut papers --paper 2013`)
section-2-1-seven-constraints-are-listed-in = razdelek 2.1: »sedem omejitev je navedenih v [18]«
the-list-is-not-given = seznam ni podan
the-usual-seven-of-milling-each-marked-as-ch = običajnih sedem pri frezanju, vsaka označena kot izbrana, meje stroja v datoteki nadomestnih vrednosti
table-1-simulations-6-and-7 = Preglednica 1, simulaciji 6 in 7
the-force-differs-by-1-n-the-roughness-by-0 = sila se razlikuje za 1 N, hrapavost za 0,17 µm: preglednica ni gladka, nobena gladka funkcija sile ne zadene obeh
ra-is-judged-within-0-08-um = Ra se ocenjuje na 0,08 µm
section-2-3-momentum-rates-between-0-008-and = razdelek 2.3: »momenti med 0,008 in 0,01 so dobri« za majhne napake, a naj »ne presežejo 0,004, če je treba zmanjšati tudi število učnih ciklov«
no-momentum-serves-both = noben moment ne služi obojemu
steadycut-train-study-prints-both-rates-besi = `steadycut train --study` izpiše oba momenta poleg drugih
m1-to-m5-by-genetic-programming-from-200-mea = M1 do M5 z genetskim programiranjem iz 200 meritev
the-measurements-were-never-published-and-th-2 = meritve niso bile nikoli objavljene, končna podajanja in vrtilne hitrosti preglednice pa ležijo na eni premici (korelacija -0,937)
calibration-genetic-m1-m2-m3-and-m5-found-an = umeritev genetic: M1, M2, M3 in M5 na novo najdeni v preglednici 1 z genetskim programiranjem, M4 natisnjena oblika z natisnjenim koeficientom vrtilne hitrosti in prilagojenimi drugimi (`steadycut identify genetic`); vseh 32 končnih vrednosti je v svojih pasovih

## crates/study/src/errata_2019.rs

eq-1-row-1-c3-z3-z2-k3-z3-z2 = en. 1, vrstica 1: + c3 (z3' - z2') + k3 (z3 - z2)
the-force-between-2-and-3-cannot-act-on-the = sila med 2 in 3 ne more delovati na temelj, njen predznak pa ni predznak nobene vzmeti
c5-z5-z1-k5-z5-z1-row-5-of-eq-2-hangs-the-ta = - c5 (z5' - z1') - k5 (z5 - z1): vrstica 5 enačbe 2 obesi mizo na temelj s k5
eq-1-row-2-no-term-with-k3-c3 = en. 1, vrstica 2: nobenega člena s k3, c3
the-tooth-s-spring-ends-on-nothing-momentum = vzmet zoba se konča na ničemer; gibalna količina se ne ohranja
c3-z3-z2-k3-z3-z2-the-reaction-of-row-3 = - c3 (z3' - z2') - k3 (z3 - z2), reakcija vrstice 3
eq-1-row-4-c4-z4-z3-k4-z4-z3 = en. 1, vrstica 4: c4 (z4' - z3') + k4 (z4 - z3)
ties-the-slides-to-the-tooth-without-reactio = veže sani na zob, brez reakcije v vrstici 3, in nasprotuje vrstici 4 enačbe 2
c4-z4-z5-k4-z4-z5 = c4 (z4' - z5') + k4 (z4 - z5)
eq-1-row-5-c5-z5-z4-k5-z5-z4 = en. 1, vrstica 5: - c5 (z5' - z4') - k5 (z5 - z4)
a-spring-of-negative-stiffness-k4-k5-remains = ostane vzmet z negativno togostjo k4 - k5: en. 1, kot je natisnjena, je nestabilna, z realnim polom pri 2 pi x 194.9 rad/s s popravljenimi števili, pri 2 pi x 4057 in 2 pi x 78659 rad/s z natisnjenimi
c5-z5-z1-k5-z5-z1 = + c5 (z5' - z1') + k5 (z5 - z1)
eq-2-row-1-k1-k2-k3-and-k3-i-w-c3-z3 = en. 2, vrstica 1: k1 + k2 + k3 in -(k3 + i w c3) z3
not-symmetric-row-3-has-no-z1-row-5-has-one = ni simetrična: vrstica 3 nima z1, vrstica 5 ga ima brez para
t-5-for-3-three-times-k1-k2-k5-c1-c2-c5-k5-i-w = trikrat 5 namesto 3: k1 + k2 + k5, c1 + c2 + c5, -(k5 + i w c5) z5
eq-2-row-2-k2-w-2-m2-i-w-c2 = en. 2, vrstica 2: (k2 - w^2 m2) + i w c2
the-tooth-s-reaction-is-missing-the-tool-poi = manjka reakcija zoba: konica orodja ima v mirovanju 5.04e-9 m/N, kjer ima popravljeni stroj 1.28e-7, in nobene resonance vretena
k2-k3-w-2-m2-i-w-c2-c3-and-k3-i-w-c3-z3 = (k2 + k3 - w^2 m2) + i w (c2 + c3) in -(k3 + i w c3) z3
eq-2-row-3-k3-i-w-c3-z2-k3-w-2-m3-i-w-c3-z3 = en. 2, vrstica 3: [k3 + i w c3] z2 - [(k3 - w^2 m3) + i w c3] z3 = -P
the-left-side-is-that-of-eq-1-times-1-the-ri = leva stran je stran en. 1 krat -1, desna ni: obe sili kažeta v isto smer
the-left-side-times-1 = leva stran krat -1
eq-2-row-4-c-42 = en. 2, vrstica 4: c_42
there-is-no-such-coefficient = takega koeficienta ni
c4 = c4
table-1-k4-6-3e12-n-m = Preglednica 1: k4 = 6.3e12 N/m
the-rule-below-the-table-gives-6-26e8-with-6 = pravilo pod preglednico da 6.26e8; s 6.3e12 bi bil c4 1.46e7, ne natisnjenih 1.4e5
exponent-8 = eksponent 8
table-1-c5-2-6e8-n-s-m = Preglednica 1: c5 = 2.6e8 N s/m
the-rule-gives-2-62e5-2-6e8-means-q-0-003 = pravilo da 2.62e5; 2.6e8 pomeni Q = 0.003
exponent-5 = eksponent 5
table-1-c2-2348-n-s-m-beside-q-17 = Preglednica 1: c2 = 2348 N s/m ob Q = 17
sqrt-k-m-2348-5-00-q-17-needs-691-and-repeat = sqrt(k m) / 2348 = 5.00; Q = 17 potrebuje 691 in ponavlja maso m2 = 17 svojega stolpca
q-5-17-can-be-chosen-machine-spindle-quality = Q = 5; mogoče je izbrati 17 (machine.spindle_quality)
table-1-k3-1-9e8-n-m-c3-0-5-n-s-m-m3-0-3e-6 = Preglednica 1: k3 = 1.9e8 N/m, c3 = 0.5 N s/m, m3 = 0.3e-6 kg
m3-is-rounded-to-one-digit-its-rule-gives-k3 = m3 je zaokrožen na eno števko: njegovo pravilo da k3 = 2.03e8; noben m3, ki se zaokroži na 0.3e-6, ne da c3 = 0.5 s Q = 10
both-by-the-rule-c3-does-not-matter-up-to-30 = oba po pravilu; c3 do 3000 Hz ni pomemben
table-1-unit-of-c-n-m-sec = Preglednica 1: enota c N/m/sec
a-damper-s-unit-is-n-s-m = enota dušilke je N s/m
n-s-m = N s/m
note-of-table-1-p-cf-107-n = opomba preglednice 1: P_CF = 107 N
may-have-been-10-7-n-which-is-absurd-for-a-c = lahko je bilo 10^7 N, kar je za rez nesmiselno
t-107-n-the-order-of-the-forces-of-2007-and-20 = 107 N, red velikosti sil iz 2007 in 2013
six-differential-equations-1 = »šest diferencialnih enačb (1)«
five-are-printed-for-five-nodes = natisnjenih je pet, za pet vozlišč
five-table-and-work-piece-are-one-node = pet; miza in obdelovanec sta eno vozlišče
substitution-xi-tau-xi-a-exp-i-w-tau = »substitucija xi(tau) = xi_A exp(i w tau)«
another-symbol-than-zeta-for-the-same-quanti = drug simbol kot zeta za isto količino
zeta = zeta
section-3-fig-4a-spectra-roughness-figure-3a = razdelek 3: »sl. 4a .. spektri«, »hrapavost (slika 3a)«
the-captions-say-the-opposite = napisi pod slikami trdijo nasprotno
t-3a-are-the-spectra-4a-is-the-roughness = 3a so spektri, 4a je hrapavost
names-of-the-nodes-against-eq-2 = imena vozlišč proti en. 2
by-the-names-the-slides-carry-the-table-and = po imenih sani nosijo mizo in sila deluje na mizo; po vrsticah 4 in 5 miza nosi sani in sila deluje nanje
variant-a-by-the-equations-variant-b-by-the = izvedba A po enačbah, izvedba B po imenih (machine.variant); G_rel se razlikuje za 2,9 %

## crates/study/src/experiment/measure.rs

no-chip-is-cut = odrezka ni
its-ra-lies-beyond-the-end-of-the-plant-s-mo = njegov Ra je onkraj konca modela procesa

## crates/study/src/experiment/plan.rs

run-run-error = simulacija { $run }: { $error }

## crates/study/src/experiment/way/job.rs

cuts-cuts-is-not-possible-allowed-are-fewest = cuts: { $cuts } ni mogoče: dovoljeno je { $fewest } do { $most }
name-value-is-not-possible-allowed-is-0-to-m = { $name }: { $value } ni mogoče: dovoljeno je 0 do { $most }
there-are-no-models-yet = modelov še ni
the-table-has-no-such-row = tabela nima take vrstice
the-pilot-cuts-found-nothing = pilotni rezi niso našli ničesar
nothing-is-planned = nič ni načrtovano
percent-of-the-way-2 = odstotki poti

## crates/study/src/experiment/way/models.rs

its-front-is-empty = njena fronta je prazna
name-none-of-the-count-formulas-found-can-be = { $name }: uporabna ni nobena od najdenih formul ({ $count }): { $why }
formula-is-not-certain-to-rise-with-input-ov = ni gotovo, da `{ $formula }` v svojih rezih narašča z { $input }
formula-is-not-certain-to-fall-with-input-ov = ni gotovo, da `{ $formula }` v svojih rezih pada z { $input }
column-has-no-unit = `{ $column }` nima enote

## crates/study/src/experiment/way/pilot.rs

pilot-cuts-error-give-another-depth = pilotni rezi: { $error }: podajte drugo globino
pilot-cuts-no-chip-is-cut-give-other-depths = pilotni rezi: odrezka ni: podajte druge globine
pilot-cuts-value-gives-force-n-in-place-of-w = pilotni rezi: { $value } da { $force } N namesto { $wanted } N: podajte drugo globino
pilot-cuts-at-depth-mm-feeds-low-to-high-are = pilotni rezi pri { $depth } mm: podajanja { $low } do { $high } niso območje
pilot-values = pilotne vrednosti

## crates/study/src/experiment/way/plant.rs

plant-formula-the-papers-k4-does-not-know-th = proces: formula: K4 iz člankov ne pozna frezala { $tool }: dovoljeno je { $allowed }
the-papers-k4-with-its-intercept-restored-ti = K4 iz člankov z obnovljenim prostim členom, krat faktor materiala in trdote
tooth-by-tooth-the-mechanistic-model-of-the = zob za zobom, mehanistični model frezala { $tool } v { $material } (Kienzlejevi zakoni; materiali razen Ck45 in 16MnCrSi5 po razmerju svojih sil), njegova največja vrednost vsake regulacijske periode
force-force-ra-what-that-force-leaves-by-the = sila: { $force }; Ra: kar ta sila pusti po K5 iz člankov, česar za drugo frezalo ali material ne potrjuje nobena meritev

## crates/study/src/experiment/way/state.rs

version-cannot-be-version-allowed-is-allowed = `version` ne more biti { $version }: dovoljeno je { $allowed }
it-was-gone-with-other-settings-and-all-but = prehojena je bila z drugimi nastavitvami, vse razen števila serij pa mora biti, kot je bilo: bilo je { $found }, ne { $own }
searches-cannot-be-count-allowed-is-allowed = `searches` ne more biti { $count }: dovoljeno je { $allowed }

## crates/study/src/formula_place.rs

a-run-has-no-use-for-it-because = simulacija je ne uporablja: { $because }

## crates/study/src/identify/drive/mod.rs

the-recording-has-count-samples-allowed-are = vzorcev v posnetku: { $count }, dovoljeno { $least } do { $most }
the-recording-has-samples-that-are-no-number = v posnetku so vzorci, ki niso števila
the-command-never-changes-record-a-step = ukaz se nikoli ne spremeni: posnemite stopnico

## crates/study/src/identify/fits/data.rs

one-and-other-have-different-times = `{ $one }` in `{ $other }` imata različne čase
the-samples-of-name-are-not-even-in-time-or = vzorci kanala `{ $name }` niso enakomerni v času ali pa njihovi časi niso znani: podajte --layout rate_hz=
missing-samples-of-name-are-missing-or-no-nu = manjkajočih ali neštevilskih vzorcev kanala `{ $name }`: { $missing }; pričakovani so celi posnetki

## crates/study/src/identify/fits/drive.rs

feed-measured = Podajanje, izmerjeno
the-channel-with-the-feed-that-was-measured = Kanal z izmerjenim podajanjem.
a-feed = podajanje
feed-asked-for = Podajanje, zahtevano
the-channel-with-the-feed-that-was-asked-for = Kanal z zahtevanim podajanjem. Kar je v vzorcu, velja od prejšnjega vzorca naprej, kakor v vrsticah simulacije.
a-feed-that-was-asked-for-or-the-step-that-w = zahtevano podajanje ali zahtevana stopnica
step-at = Stopnica ob
step-from = Stopnica od
step-to = Stopnica do
the-step-that-was-asked-for-where-it-was-not = Zahtevana stopnica, če ni bila posneta: kdaj, s katerega in na katero podajanje.
drive = Pogon
dead-time-order-and-lag-of-the-feed-drive-fo = Mrtvi čas, red in zakasnitev podajalnega pogona; štiri strukture, primerjane po Schwarzovem in Akaikejevem kriteriju.
a-recording-of-a-step-of-the-feed-the-feed-t = Posnetek stopnice podajanja: izmerjeno in zahtevano podajanje, enakomerno v času, od pred stopnico do ustaljenega podajanja.
lag = zakasnitev
gain = ojačanje
left-rms = preostanek, RMS
structures-compared-the-one-of-least-bic-is = Primerjane strukture; vzeta je tista z najmanjšim BIC
structure-2 = struktura
dead-time-s = mrtvi čas [s]
lag-s = zakasnitev [s]
this-recording-does-not-tell-one-from-other = ta posnetek ne loči struktur: { $one } in { $other }; njuna BIC se razlikujeta za { $by }
samples-samples-period-s-apart-structure = vzorcev: { $samples }, na { $period } s; { $structure }

## crates/study/src/identify/fits/force.rs

a-force = sila
force-along-the-feed = Sila vzdolž podajanja
the-channel-with-the-force-on-the-tool-along = Kanal s silo na orodje vzdolž podajanja, v N ali kN.
force-across-the-feed = Sila prečno na podajanje
the-channel-with-the-force-on-the-tool-acros = Kanal s silo na orodje prečno na podajanje, tja, kjer zobje vstopajo v rez.
force-along-the-axis = Sila vzdolž osi
the-channel-with-the-force-on-the-tool-along-2 = Kanal s silo na orodje vzdolž njegove osi, stran od konice.
size-across-the-tool = Velikost prečno na orodje
the-channel-with-the-size-of-the-force-acros = Kanal z velikostjo sile prečno na orodje, sqrt(Fx^2 + Fy^2), če njene komponente niso bile posnete.
forces-on-the-workpiece = Sile na obdelovanec
the-forces-are-those-on-the-workpiece-as-of = Sile so tiste na obdelovanec, kakor jih da dinamometer pod njim: predznak se jim obrne.
another-cutter-than-the-scenario-s = Drugo frezalo od tistega v scenariju.
the-scenario-s = tisto iz scenarija
another-feed-than-the-scenario-s-mm-min = Drugo podajanje od tistega v scenariju, mm/min.
another-spindle-speed-than-the-scenario-s-1 = Druga vrtilna hitrost od tiste v scenariju, 1/min.
another-axial-depth-than-the-scenario-s-mm = Druga aksialna globina od tiste v scenariju, mm.
another-radial-depth-than-the-scenario-s-mm = Druga radialna globina od tiste v scenariju, mm; utor ima globino celega frezala.
keep-exponents-of-kienzle-s-laws-as-the-stee = Eksponente Kienzlejevih zakonov pusti, kakor jih ima jeklo, kjer jih rez ne pove.
keep-m-c-of-the-steel = Pusti m_c jekla
keep-m-r-of-the-steel = Pusti m_r jekla
keep-m-a-of-the-steel = Pusti m_a jekla
scenario-workpiece-cuts-has-several-sections = { $scenario }: `workpiece.cuts` ima več odsekov: podajte --axial-depth in --radial-depth posnetega
forces = Sile
coefficients-of-the-force-model-tooth-by-too = Koeficienti modela sil zob za zobom (Kienzlejevi zakoni), opletanje vsakega zoba in kot vretena.
forces-along-and-across-the-feed-or-along-th = Sile vzdolž in prečno na podajanje ali vzdolž osi v enakomernem rezu skozi vsaj en vrtljaj vretena, okoli 60 vzorcev na vrtljaj in več; scenarij se simulira zob za zobom ter ima frezalo in rez.
choose-at-least-one-force = izberite vsaj eno silo
the-size-across-the-tool-is-for-recordings-w = velikost prečno na orodje je za posnetke brez Fx in Fy
k-letter-at-at-mm = k_{ $letter } pri { $at } mm
tooth-number-out-of-the-mean = zob { $number }, odmik od povprečja
shift-of-the-axis = premik osi
first-angle = prvi kot
angle-of-the-spindle = kot vretena
condition = pogojenost
samples-samples-turns-turns-at-speed-1-min-l = vzorcev: { $samples }, vrtljajev: { $turns } pri { $speed } 1/min, položenih na mesta vrtljaja: { $places }; zakoni k h^-m tega reza, h v mm

## crates/study/src/identify/fits/material.rs

force-largest-of-a-turn = Sila, največja v vrtljaju
the-channel-with-the-largest-force-of-a-revo = Kanal z največjo silo vrtljaja, v N ali kN (`steadycut measured --peak` jo naredi iz komponent).
the-channel-with-the-feed-mm-min-without-it = Kanal s podajanjem, mm/min; brez njega velja program scenarija.
the-channel-with-the-spindle-speed-1-min-wit = Kanal z vrtilno hitrostjo, 1/min; brez njega velja program scenarija.
a-spindle-speed = vrtilna hitrost
position-along-the-path = Položaj vzdolž poti
the-channel-with-the-position-along-the-path = Kanal s položajem vzdolž poti, mm, če ima obdelovanec več globin.
a-position = položaj
the-factor-of-the-material-s-force-over-that = Faktor sile materiala glede na Ck45 pri 200 HB in trdota, pri kateri bi ga imel material scenarija.
the-largest-force-of-each-revolution-in-a-cu = Največja sila vsakega vrtljaja v rezu, enakomerno v času, 40 vzorcev in več; ob njej podajanje, vrtilna hitrost in položaj, če se spreminjajo; scenarij ima frezalo, obdelovanec in model sile, ki je funkcija, ne zob za zobom (te prilagodi »Sile«).
plant-force-model-is-id-tooth-by-tooth-expec = `plant.force_model` je { $id }, zob za zobom: pričakovan je scenarij, katerega sila je funkcija; zobe prilagodi `steadycut identify force`
hardness-of-material = trdota: { $material }
force-over-that-of-ck45-at-200-hb = sila glede na Ck45 pri 200 HB
the-model-was-used-outside-its-range-in-perc = model je bil v { $percent } % vzorcev uporabljen zunaj svojega območja
one-factor-holds-wear-material-and-hardness = en faktor zajema obrabo, material in trdoto skupaj: same sile jih ne ločijo
samples-samples-in-the-cut = vzorcev v rezu: { $samples }

## crates/study/src/identify/fits/noise.rs

the-channel-with-the-force-in-n-or-kn = Kanal s silo, v N ali kN.
times-in-s-between-which-the-tool-was-in-the = Časa v s, med katerima je bilo orodje v zraku: tam se pokaže šum senzorja.
sizes-of-the-sensor-s-noise-of-band-limited = Velikosti šuma senzorja, pasovno omejenega šuma, nehomogenosti materiala in valovitosti ob prehodih zob.
the-force-of-a-steady-cut-even-in-time-256-s = Sila enakomernega reza, enakomerno v času, 256 vzorcev in več, bolje nekaj sekund pri 1 kHz; scenarij ima vrtilno hitrost, zobe in podajanje reza.
white-noise = beli šum
white-noise-in-the-air = beli šum v zraku
band-limited-noise-of-the-force = pasovno omejeni šum, od sile
inhomogeneity-of-the-force = nehomogenost, od sile
ripple-at-tooth-passing-of-the-force = valovitost ob prehodih zob, od sile
ripple-at-the-spindle-s-turns-of-the-force = valovitost ob vrtljajih vretena, od sile
name-not-seen-the-samples-are-too-far-apart = { $name }: ni vidno, vzorci so za to preredki
the-shapes-of-the-noise-are-those-of-the-sce = oblike šuma so tiste iz scenarija: pas od { $low } do { $high } Hz, korelacija čez { $length } mm
noise-in-all-rms = ves šum, RMS
r-of-mean-drift-and-ripple = R² povprečja, lezenja in valovitosti
drift = lezenje
density-of-the-noise = Gostota šuma
frequency = frekvenca
samples-samples-about-mean-n-period-s-apart = vzorcev: { $samples }, okoli { $mean } N, na { $period } s

## crates/study/src/identify/fits/outcome.rs

value-not-determined = { $value }, ni določeno
left-over-rms = preostanek, RMS
nothing-is-fitted-yet = nič še ni prilagojeno

## crates/study/src/identify/fits/request.rs

within-2 = Med
takes-the-samples-between-two-times-in-s-alo = Vzame le vzorce med dvema časoma v s.
value-unit-cannot-be-allowed-is-a-number-fro = { $value } { $unit } ni mogoče: dovoljeno je število od { $low } do { $high }
from-from-s-to-to-s-is-no-span-of-time-the-s = od { $from } s do { $to } s ni časovni razpon: drugi čas mora biti za prvim
there-is-no-channel-name-there-are-names = kanala `{ $name }` ni; so { $names }
name-is-in-unit-expected-is-what-in-units = `{ $name }` je v { $unit }; pričakovano: { $what }, v { $units }
first-or-last = { $first } ali { $last }
choose-a-channel-expected-is-what = izberite kanal; pričakovano: { $what }

## crates/study/src/identify/fits/structure.rs

frequency-2 = Frekvenca
the-column-with-the-frequencies-hz-ascending = Stolpec s frekvencami, Hz, naraščajoče.
a-frequency = frekvenca
displacement-over-force-real-and-imaginary-p = Pomik na silo: realni in imaginarni del ali velikost in faza.
a-displacement-over-a-force = pomik na silo
real-part = Realni del
imaginary-part = Imaginarni del
magnitude = Velikost
an-angle = kot
direction = Smer
whether-the-response-is-along-or-across-the = Ali je odziv vzdolž podajanja ali prečno nanj.
number-of-modes = Število nihajnih oblik
number-of-modes-without-it-as-many-as-there = Število nihajnih oblik; brez njega toliko, kolikor je vrhov, največ 8.
keep-the-other-direction = Ohrani drugo smer
keeps-the-modes-that-the-scenario-has-in-the = Ohrani nihajne oblike, ki jih ima scenarij v drugi smeri: tako pridejo obe iz dveh posnetkov, ene za drugo.
choose-real-and-imaginary-part-or-magnitude = izberite realni in imaginarni del ali velikost in fazo
frequencies-damping-ratios-and-masses-of-the = Frekvence, razmerja dušenja in mase nihajnih oblik na konici orodja, iz katerih sledi stabilnost.
a-frequency-response-at-the-tip-as-of-an-imp = Frekvenčni odziv na konici, kakor iz udarnega preizkusa: frekvenca ter realni in imaginarni del ali velikost in faza pomika na silo; 20 vrstic in več.
problem-where-noise-makes-peaks-say-how-many = { $problem }; če vrhove dela šum, povejte, koliko nihajnih oblik je
mode-number-frequency = nihajna oblika { $number }: frekvenca
mode-number-damping-ratio = nihajna oblika { $number }: razmerje dušenja
mode-number-modal-mass = nihajna oblika { $number }: modalna masa
kept-from-the-scenario-n-modes-direction = ohranjeno iz scenarija, { $direction }: nihajnih oblik { $n }
the-machine-does-not-stand-in-the-loop-machi = stroj ni v zanki (machine.coupled): dokler ni, nihajne oblike delujejo le v karti stabilnosti
flexibility-of-stiffer-modes-flexibility-um = podajnost bolj togih nihajnih oblik { $flexibility } um/N, ki ni nihajna oblika
share-of-the-response = { $share } % odziva

## crates/study/src/identify/fits/wear.rs

the-column-with-the-cutting-speed-m-min = Stolpec z rezalno hitrostjo, m/min.
a-cutting-speed = rezalna hitrost
time-in-the-cut = Čas v rezu
the-column-with-the-time-in-the-cut-min = Stolpec s časom v rezu, min.
a-time = čas
the-column-with-the-width-of-the-flank-wear = Stolpec s širino obrabe proste ploskve VB, mm.
a-width = širina
the-column-with-the-feed-per-tooth-mm-where = Stolpec s podajanjem na zob, mm, če se je spreminjalo.
a-feed-per-tooth = podajanje na zob
the-column-with-the-axial-depth-mm-where-tha = Stolpec z aksialno globino, mm, če se je spreminjala.
a-depth = globina
number-of-the-tool = Številka orodja
the-column-with-the-number-of-the-tool-where = Stolpec s številko orodja, če jih je več delalo isti rez.
wear-land-at-the-end = Širina obrabe na koncu
the-wear-land-at-which-a-tool-s-life-ends-mm = Širina obrabe, pri kateri se konča obstojnost orodja, mm.
taylor-s-constants-n-and-c-of-the-tool-s-lif = Taylorjevi konstanti n in C obstojnosti orodja ter eksponenta podajanja in globine, če sta se spreminjala.
a-table-with-a-reading-of-the-wear-land-in-e = Tabela z odčitkom širine obrabe v vsaki vrstici, po času: rezalna hitrost, čas v rezu, širina obrabe; orodja pri vsaj dveh rezalnih hitrostih, obrabljena do meje.
life-at-speed-m-min = obstojnost pri { $speed } m/min
c-of-v-t-n-c = C iz v T^n = C
exponent-of-the-feed = eksponent podajanja
exponent-of-the-depth = eksponent globine
lives-of-the-tools = Obstojnosti orodij
life-min = obstojnost [min]
by-the-fit-min = po modelu [min]
share-of-the-life = { $share } % obstojnosti
deviation-of-the-lives = odklon obstojnosti
not-told-as-many-constants-as-lives = ni znan: toliko konstant kolikor obstojnosti
r-of-the-logarithms = R² logaritmov
life = Obstojnost
count-lives-to-a-wear-land-of-land-mm = obstojnosti do širine obrabe { $land } mm: { $count }

## crates/study/src/identify/force/fit.rs

the-run-out = opletanje
the-angle = kot
no-place-to-begin-the-fit = prilagajanje se nima kje začeti
the-model-gives-no-forces-in-this-cut = model v tem rezu ne da sil

## crates/study/src/identify/force/fold.rs

axis-is-value-n-throughout-no-cut-was-record = { $axis } je ves čas { $value } N: rez ni bil posnet; pričakovana je sila, ki se spreminja s prehodi zob
the-samples-do-not-fill-places-places-of-a-t = vzorci ne zapolnijo { $places } mest vrtljaja: pričakovan je daljši posnetek ali več kot { $count } vzorcev na vrtljaj
the-forces-do-not-repeat-with-the-turns-of-t = sile se ne ponavljajo z vrtljaji vretena pri { $speed } 1/min: pričakovan je enakomeren rez pri tej hitrosti

## crates/study/src/identify/force/mod.rs

these-forces-tell-nothing-of-k-letter-and-m = te sile o k_{ $letter } in m_{ $letter } ne povedo ničesar: vrednosti sta tisti jekla, pri katerem se je prilagajanje začelo
this-cut-cannot-tell-names-apart-condition-c = ta rez ne loči { $names } (pogojenost { $condition }): posnemite še eno komponento, drugo podajanje ali zadržite eksponent
a-tooth-stands-rest-um-off-what-a-shift-of-t = zob stoji { $rest } um drugje, kot ga postavi premik osi: frezalo v programu ima le ta premik
what-is-left-repeats-from-turn-to-turn-place = preostanek se ponavlja iz vrtljaja v vrtljaj ({ $place } N): rez se razlikuje od modela in vrednosti so lahko zunaj svojih intervalov
spindle-speed-2 = vrtilna hitrost
axial-depth-2 = aksialna globina
radial-depth-2 = radialna globina
slice-height-2 = višina rezine
the-name-is-value-unit-nothing-is-cut-expect = { $name }: { $value } { $unit }, nič se ne reže; pričakovano je število nad 0
axis-sample-sample-is-no-number = { $axis }: vzorec { $sample } ni število
the-recording-has-turns-turns-of-the-spindle = vrtljajev vretena v posnetku: { $turns }; pričakovan je vsaj eden
the-model-explains-share-of-the-forces-expec = model pojasni { $share } % sil: pričakovane so sile na orodje v N, vzdolž (Fx) in prečno (Fy) na podajanje ali vzdolž osi (Fz), iz podanega reza

## crates/study/src/identify/force/settings.rs

plant-force-model-is-id-expected-is-a-scenar = `plant.force_model` je { $id }: pričakovan je scenarij, katerega sila se simulira zob za zobom, mechanistic

## crates/study/src/identify/genetic.rs

models = modeli

## crates/study/src/identify/gp/columns.rs

no-rows-below-the-names-of-the-columns = pod imeni stolpcev ni vrstic
there-is-one-column = en sam stolpec
a-target-and-an-input-need-two-columns-of-nu = cilj in vhod potrebujeta dva stolpca števil: { $which }

## crates/study/src/identify/gp/constants.rs

the-formula-is-too-large = formula je prevelika
constants-constants-cannot-be-fitted-to-rows = konstant ({ $constants }) ni mogoče prilagoditi tolikim vrsticam ({ $rows })
the-formula-has-no-finite-value-on-some-row = formula v kaki vrstici nima končne vrednosti
a-constant-is-not-finite = konstanta ni končna

## crates/study/src/identify/gp/declared.rs

no-start-has-a-value-on-all-rows = noben začetek nima vrednosti v vseh vrsticah

## crates/study/src/identify/gp/folds.rs

the-search-repeated-without-each-row = iskanje, ponovljeno brez vsake vrstice
the-constants-fitted-without-each-row = konstante, prilagojene brez vsake vrstice
the-constants-fitted-without-each-tenth-of-t = konstante, prilagojene brez vsake desetine vrstic

## crates/study/src/identify/gp/paper.rs

generations = generacije

## crates/study/src/identify/gp/problem.rs

t-1-row-at-least-fewest-are-needed = 1 vrstica: potrebnih je vsaj { $fewest }
rows-rows-at-least-fewest-are-needed = vrstic je { $rows }: potrebnih je vsaj { $fewest }
count-inputs-allowed-are-1-to-most = vhodov je { $count }: dovoljeno je 1 do { $most }
input-is-the-target-and-an-input = `{ $input }` je cilj in vhod
the-input-input-is-named-twice = vhod `{ $input }` je naveden dvakrat
the-unit-of-column-is-not-known-give-it-with = enota za `{ $column }` ni znana: podajte jo z `--unit { $column }=UNIT`, `1` za brez
name-is-value-in-every-row-nothing-can-be-to = `{ $name }` je v vsaki vrstici { $value }: iz tega ni mogoče ničesar razbrati
name-has-values-above-1e100-choose-another-u = `{ $name }` ima vrednosti nad 1e100: izberite drugo enoto
a-and-b-lie-on-one-line-correlation-correlat = `{ $a }` in `{ $b }` ležita na eni premici (korelacija { $correlation }, inflacija variance { $inflation }): te vrstice ne ločijo njunih učinkov in prosta formula obeh bi bila naključje

## crates/study/src/identify/gp/range.rs

constant = stalna
rising = naraščajoča
falling = padajoča
turning = se obrne
uncertain = negotova

## crates/study/src/identify/gp/report.rs

the-constants-fitted-without-some-of-the-row = konstante, prilagojene brez nekaterih vrstic

## crates/study/src/identify/gp/search.rs

the-saved-search-has-formulas-that-cannot-be = shranjeno iskanje ima formule, ki ne morejo obstajati

## crates/study/src/identify/gp/state.rs

the-search-was-of-another-table-of-other-col = iskanje je bilo za drugo tabelo, druge stolpce, enote ali drugo seme: vse to mora biti, kot je bilo

## crates/study/src/identify/gp/template.rs

t-stands-there-twice-allowed-is-once = T stoji dvakrat: dovoljen je enkrat
the-bracket-of-t-is-not-closed = oklepaj T ni zaprt
count-constants-allowed-are-most = konstant je { $count }: dovoljenih je { $most }
there-is-neither-a-constant-to-fit-nor-t-to = ni niti konstante za prilagajanje niti T za iskanje
t-name-name-is-no-input-inputs-are-list = T({ $name }): `{ $name }` ni vhod; vhodi so { $list }
part-beside-t-every-part-needs-one-constant = `{ $part }`: ob T potrebuje vsak del eno konstanto, ki ga množi, in nobene druge
t-has-to-stand-in-the-sum-by-itself-as-in-a = T mora v vsoti stati sam, kot v `a + b*n^3 + T(f)`
a-part-of-the-template-has-no-finite-value-o = del predloge v kaki vrstici nima končne vrednosti

## crates/study/src/identify/material.rs

the-recording-has-count-samples-of-the-force = vzorcev sile v posnetku: { $count }; pričakovanih je vsaj { $least } in prav toliko podajanj, vrtljajev in leg
force = sila
position-2 = lega
name-sample-sample-is-no-number = { $name }: vzorec { $sample } ni število
the-position-falls-expected-is-that-along-th = lega pada: pričakovana je lega vzdolž poti
the-model-has-a-force-in-count-samples-expec = vzorcev, v katerih ima model silo: { $count }; pričakovanih je vsaj { $least } v rezu, s podajanjem v mm/min in vrtljaji v 1/min
the-forces-are-not-above-0-expected-is-the-s = sile niso nad 0: pričakovana je velikost sile

## crates/study/src/identify/noise.rs

what-count-samples-allowed-are-least-to-most = { $what }: vzorcev je { $count }, dovoljeno { $least } do { $most }
what-sample-sample-is-no-number = { $what }: vzorec { $sample } ni število
the-cut-2 = rez
expected-are-a-period-speed-feed-corners-of = pričakovani so perioda, vrtljaji, podajanje, meji pasu in korelacijska dolžina nad 0 ter vsaj en zob
the-force-does-not-vary-nothing-is-told-of-i = sila se ne spreminja: o njenem šumu ne pove ničesar
the-mean-force-is-mean-n-expected-is-a-cut-w = povprečna sila je { $mean } N: pričakovan je rez s silo nad 0
at-rest = v mirovanju

## crates/study/src/identify/response/fit.rs

the-response-has-no-resonance-im-has-no-peak = odziv nima resonance: -Im nima vrha nad 0; je to pomik na silo?

## crates/study/src/identify/response/table.rs

its-columns-are-names-wanted-are-frequency-h = njeni stolpci so { $names }: potrebni so frequency_hz z real_m_n in imaginary_m_n ali z magnitude_m_n in phase_deg; _um_n za um/N
the-response-has-count-points-allowed-are-le = odziv ima { $count } točk: dovoljenih je { $least } do { $most }
the-frequencies-do-not-ascend-from-above-0-h = frekvence ne naraščajo od nad 0 Hz

## crates/study/src/identify/wear.rs

there-is-no-column-name-there-are-names = stolpca `{ $name }` ni; so { $names }
reading-number-expected-are-a-speed-feed-and = odčitek { $number }: pričakovani so hitrost, podajanje in globina nad 0 ter čas in širina obrabe vsaj 0
reading-number-its-time-time-min-is-not-behi = odčitek { $number }: njegov čas, { $time } min, ni za časom prejšnjega odčitka pri { $speed } m/min: podajte stolpec s številko orodja
speed-m-min = { $speed } m/min
a-limit-of-land-mm-expected-is-a-number-abov = meja { $land } mm: pričakovano je število nad 0
at-cut-the-first-reading-is-already-above-th = pri { $cut } je že prvi odčitek nad mejo: obstojnost leži na premici od novega orodja
at-cut-the-wear-land-does-not-come-to-land-m = pri { $cut } obraba proste ploskve ne doseže { $land } mm: izpuščeno
count-tools-came-to-land-mm-all-at-one-cutti = orodij, ki so dosegla { $land } mm: { $count }, vsa pri eni rezalni hitrosti; pričakovani sta vsaj dve
count-tools-came-to-land-mm-expected-are-at = orodij, ki so dosegla { $land } mm: { $count }; pričakovana so vsaj { $least }, po eno za vsako konstanto
speed-feed-and-depth-were-varied-only-togeth = hitrost, podajanje in globina so se spreminjali le skupaj: pričakovani so rezi, v katerih se spremeni eno samo
the-life-does-not-fall-with-the-cutting-spee = obstojnost z rezalno hitrostjo ne pada: pričakovani so stolpci hitrosti, časa in širine obrabe
depth-2 = globina
the-name-was-not-varied-its-exponent-stays-a = { $name } se ni spreminjala: eksponent ostane, kot je v scenariju

## crates/study/src/library/facts.rs

names-and-more-more = { $names } in še { $more }
length-mm-long-at-most-depth-mm-deep = dolg { $length } mm, globok največ { $depth } mm
n-moves = gibov: { $n }
n-lines = vrstic: { $n }
controller-length-mm = { $controller }, { $length } mm
it-is-none-of-the-files-that-this-program-re = to ni nobena od datotek, ki jih ta program bere
shape-1-tooth-d-mm = { $shape }, 1 zob, { $d } mm
shape-n-teeth-d-mm = { $shape }, zob: { $n }, { $d } mm
t-1-mode-hz-hz = 1 lastno nihanje, { $hz } Hz
n-modes-low-to-high-hz = lastnih nihanj: { $n }, { $low } do { $high } Hz
k-c1-1-kc11-n-mm-m-c-mc-hb-hb = k_c1.1 { $kc11 } N/mm², m_c { $mc }, { $hb } HB
feed-drive-of-order-n = podajalni pogon reda { $n }
spindle-drive-of-order-n = pogon vretena reda { $n }
dead-time-s-s = mrtvi čas { $s } s
limits-at-most-feed-mm-min = omejitve, največ { $feed } mm/min
limits = omejitve

## crates/study/src/library/kind.rs

cutters = Frezala
materials = Materiali
machines = Stroji
structures-at-the-tool-s-tip = Strukture na konici orodja
parts = Obdelovanci
programs-g-code = Programi (koda G)
scripts = Skripti
scenarios = Scenariji
formulas = Formule
tables = Tabele
networks-of-unks = Mreže UNKS
saved-searches = Shranjena iskanja
results-of-missions = Rezultati nalog
not-readable = Neberljivo

## crates/study/src/library/mod.rs

size-mb-not-looked-into = { $size } MB, vsebina ni pregledana
size-mb-files-of-its-kind-have-at-most-most = { $size } MB: datoteke te vrste imajo največ { $most } MB

## crates/study/src/machine_life/adaptive.rs

percent-of-the-life = odstotki obstojnosti

## crates/study/src/machine_life/mod.rs

sound-trend-and-roughness-trend-are-identica = trend zvoka in trend hrapavosti sta enaka (število ni natisnjeno)
calculated-and-measured-sound-trend-r-0-993 = izračunani in izmerjeni trend zvoka: R = 0,993; meritev ni objavljena
calculated-and-measured-sound-spectrum-r-0-6 = izračunani in izmerjeni spekter zvoka: R = 0,684; meritev ni objavljena
points-of-time = časovne točke

## crates/study/src/machine_life/monte_carlo.rs

tools = orodja

## crates/study/src/mission/answer.rs

predictions-step-step-allowed-is-one-of-choi = `predictions`, korak { $step }: dovoljeno je eno od choice, number in curve
predictions-step-step-is-answered-twice = `predictions`: korak { $step } ima dva odgovora
path-is-set-to-value-the-mission-opens-open = `{ $path }` je nastavljen na { $value }: naloga dovoli { $open }
path-is-changed-at-time-s-the-mission-opens = `{ $path }` je spremenjen pri { $time } s: naloga dovoli { $open }
the-change-of-path-at-time-s-is-part-of-the = sprememba `{ $path }` pri { $time } s je del naloge in manjka
predictions-step-step-asks-nothing-steps-tha = `predictions`: korak { $step } ne sprašuje ničesar; koraki, ki sprašujejo: { $all }
predictions-step-step = `predictions`, korak { $step }
entry-choice-is-number-allowed-is-1-to-most = { $entry }: choice je { $number }: dovoljeno je 1 do { $most }
entry-number-is-number-allowed-are-finite-on = { $entry }: number je { $number }: dovoljena so končna števila
entry-allowed-is-a-choice = { $entry }: dovoljena je choice
entry-allowed-is-a-number = { $entry }: dovoljeno je number
entry-allowed-is-a-curve = { $entry }: dovoljena je curve
entry-curve-has-count-points-allowed-are-2-t = { $entry }: točk v curve je { $count }: dovoljeno je 2 do { $most }
entry-curve-has-a-number-that-is-not-finite = { $entry }: curve ima število, ki ni končno
entry-the-times-of-the-curve-do-not-ascend = { $entry }: časi v curve ne naraščajo
bytes-bytes-at-most-most-are-read = bajtov je { $bytes }; prebere se jih največ { $most }
version-is-version-allowed-is-allowed = `version` je { $version }: dovoljeno je { $allowed }
mission-is-found-this-mission-is-own = `mission` je `{ $found }`: ta naloga je `{ $own }`
link-holds-settings-and-changes-allowed-is-a = `link` ima nastavitve in spremembe: dovoljena je povezava ali set in edits

## crates/study/src/mission/condition.rs

allowed-is-one-of-list-between-two-formulas = dovoljeno je eno od { $list } med dvema formulama
text-compares-twice-allowed-write-two-condit = `{ $text }` primerja dvakrat: { $allowed }; zapišite dva pogoja
text-compares-nothing-allowed = `{ $text }` ne primerja ničesar: { $allowed }

## crates/study/src/mission/cut.rs

set-or-edits-error = `set` ali `edits`: { $error }
allowed-are-tables-of-settings-as-in-a-scena = dovoljene so tabele nastavitev, kot v datoteki scenarija

## crates/study/src/mission/file/controls.rs

is-not-open-allowed-are-settings-of-controls = ni odprto: dovoljene so nastavitve iz `controls.open`: { $open }
is-no-choice-allowed-are-settings-with-optio = ni izbira: dovoljene so nastavitve z možnostmi
offers-count-options-allowed-are-2-at-least = ponujenih možnosti: { $count }; dovoljeni sta vsaj 2 izmed { $list }
lacks-own-that-of-the-mission-s-own-cut-is-a = nima `{ $own }`: možnost lastnega reza naloge je med ponujenimi

## crates/study/src/mission/file.rs

entry-at-line-line-problem = `{ $entry }` v vrstici { $line }: { $problem }
entry-has-count-entries-allowed-are-most = število vnosov v `{ $entry }` je { $count }: dovoljeno je { $most }
checks-is-empty-a-mission-checks-at-least-on = `checks` je prazen: naloga preveri vsaj en pogoj
is-id-allowed-are-1-to-60-of-a-to-z-0-to-9-a = je `{ $id }`: dovoljeno je 1 do 60 znakov od a do z, 0 do 9 in -
is-empty-a-mission-has-a-title = je prazen: naloga ima naslov
is-the-name-of-a-metric-allowed-is-another-n = je ime merila: dovoljeno je drugo ime
allowed-is-one-of-options-number-and-curve = dovoljeno je eno od options, number in curve
is-value-allowed-is-above-0-to-100 = je { $value }: dovoljeno je nad 0 do 100 %
has-count-options-allowed-are-2-to-most = možnosti je { $count }: dovoljeno je 2 do { $most }
has-right-and-right-if-allowed-is-one-of-the = ima `right` in `right_if`: dovoljeno je eno od njiju
no-option-is-right-at-least-one-has-right-tr = nobena možnost ni prava: vsaj ena ima right = true ali right_if
allowed-is-one-of-metric-signal-setting-chan = dovoljeno je eno od metric, signal, setting, changes, prediction in ended
has-take-from-or-to-allowed-with-a-signal-on = ima take, from ali to: dovoljeno samo s signalom
has-a-run-allowed-with-a-metric-a-signal-or = ima run: dovoljeno samo z merilom, signalom ali koncem
is-step-allowed-is-the-number-of-a-step-1-to = je { $step }: dovoljena je številka koraka, 1 do { $most }
is-empty = je prazen
entry-ended-no-end-id = `{ $entry }.ended`: konca `{ $id }` ni
goes-from-from-to-to-allowed-is-from-0-on-an = gre od { $from } do { $to }: dovoljeno je od 0 naprej in from pod to
entry-signal-no-signal-id = `{ $entry }.signal`: signala `{ $id }` ni
there-is-no-id-did-you-mean-near-allowed-is = `{ $id }` ni (ste mislili `{ $near }`?): dovoljeno je eno od { $list }
there-is-no-id-allowed-is-one-of-list = `{ $id }` ni: dovoljeno je eno od { $list }
there-is-no-value-or-metric-name-did-you-mea = vrednosti ali merila `{ $name }` ni (ste mislili `{ $near }`?): dovoljena so tista iz [values] in { $list }
there-is-no-value-or-metric-name-allowed-are = vrednosti ali merila `{ $name }` ni: dovoljena so tista iz [values] in { $list }

## crates/study/src/mission/link.rs

its-link-problem = njena povezava: { $problem }

## crates/study/src/mission/mod.rs

mission = naloga
answer = odgovor
path-is-set-to-value-the-mission-offers-list = `{ $path }` je nastavljeno na { $value }: naloga ponuja { $list }

## crates/study/src/mission/result.rs

format-is-format-allowed-is-allowed = `format` je `{ $format }`: dovoljeno je `{ $allowed }`
mission-digest-is-found-this-mission-s-is-ow = `mission.digest` je { $found }: digest te naloge je { $own }; razlikujeta se v več kot komentarjih
entry-says-said-the-answer-gives-found = `{ $entry }` pravi { $said }: odgovor da { $found }

## crates/study/src/mission/shipped.rs

there-is-none-with-the-id-id-there-are-list = z id `{ $id }` ni nobene; obstajajo { $list }

## crates/study/src/mission/words.rs

left-at-most-right = { $left }: največ { $right }
left-at-least-right = { $left }: najmanj { $right }
left-the-same-as-right = { $left }: enako kot { $right }
left-other-than-right = { $left }: drugače kot { $right }
left-less-than-right = { $left }: manj kot { $right }
left-more-than-right = { $left }: več kot { $right }
there-is-no-such-value = take vrednosti ni
yours-is-off-by-percent = vaša odstopa za { $percent }
yours-value = vaša: { $value }
yours-value-the-limit-limit = vaša: { $value }, meja: { $limit }
value-within-percent-of-wanted = { $value }: v mejah { $percent } od { $wanted }
the-value-of-the-cut-as-given = vrednost danega reza
the-value-at-constant-feed-as-programmed = vrednost pri programiranem stalnem podajanju
the-value-with-controller = vrednost z regulatorjem { $controller }
changes-during-the-cut = spremembe med rezom
changes-during-the-cut-2 = Spremembe med rezom
prediction-in-step-step = Napoved v koraku { $step }
of-the-cut-as-given = podanega reza
at-constant-feed-as-programmed = pri stalnem podajanju, kot programirano
from-from-unit-on = od { $from } { $unit } naprej
from-to-to-unit = { $from } do { $to } { $unit }
largest-value = največja vrednost
least-value = najmanjša vrednost
largest-less-least-value = razlika največje in najmanjše vrednosti
first-value = prva vrednost
last-value = zadnja vrednost
ra-at-the-end = Ra na koncu
ra-at-the-end-off-its-target = Odstopanje Ra od cilja na koncu
share-of-the-length-in-tolerance = Delež dolžine v toleranci
share-of-the-length-above-the-tolerance = Delež dolžine nad toleranco
share-of-the-length-in-tolerance-with-dynami = Delež dolžine v toleranci z dinamiko
share-of-the-length-above-the-tolerance-with = Delež dolžine nad toleranco z dinamiko
share-of-the-length-that-is-not-judged = Delež dolžine, ki ni ocenjen
force-at-the-end = Sila na koncu
force-at-the-end-off-its-reference = Odstopanje sile od reference na koncu
largest-deviation-of-the-force-from-its-refe = Največje odstopanje sile od reference
feed-at-the-end = Podajanje na koncu
spindle-speed-at-the-end = Vrtilna hitrost na koncu
normalised-standard-error = Normirana standardna napaka
normalised-standard-error-over-20-samples = Normirana standardna napaka iz 20 vzorcev
settling-time-of-the-force = Umiritveni čas sile
overshoot-of-the-force = Prenihaj sile
length-of-path-done = Opravljena dolžina poti
length-of-scrap = Dolžina izmeta
cost-of-the-scrap = Cena izmeta
cost-of-the-cut = Cena reza
share-of-the-time-at-a-limit = Delež časa na meji
share-of-the-time-with-a-model-outside-its-r = Delež časa z modelom zunaj območja

## crates/study/src/opening/frame.rs

embed-flag-allowed-behind-hide-are-list = embed: `{ $flag }`: za hide: so dovoljeni { $list }
embed-flag-allowed-behind-lock-are-all-a-set = embed: `{ $flag }`: za lock: so dovoljeni all, nastavitev ali skupina nastavitev: { $list }
embed-flag-allowed-behind-screen-is-the-name = embed: `{ $flag }`: za screen: je dovoljeno ime enega
embed-flag-allowed-behind-lang-are-list = embed: `{ $flag }`: za lang: so dovoljeni { $list }
embed-flag-allowed-are-hide-lock-screen-and = embed: `{ $flag }`: dovoljeni so hide, lock, screen in lang, vsak z dvopičjem in svojo vrednostjo

## crates/study/src/opening/mod.rs

the-link-was-not-used-title-is-open-instead = Povezava ni bila uporabljena, namesto nje je odprt scenarij »{ $title }«. { $error }
embed-error = embed: { $error }
the-mission-title-begins-anew-the-cut-of-the = Naloga »{ $title }« se začne znova: rez iz povezave ni bil uporabljen. { $problem }

## crates/study/src/own_file/entry.rs

line-line-problem = vrstica { $line }: { $problem }

## crates/study/src/own_file/limits.rs

at-most-speed-max-rpm-most-1-min = največ `speed_max_rpm`, { $most } 1/min
spindle-drive-stands-in-the-place-of-lag-and = { "[" }spindle_drive] stoji namesto zakasnitve in omejitve pospeška
there-is-nothing-in-limits = v [limits] ni ničesar

## crates/study/src/own_file/machine.rs

machine-file = datoteka stroja
the-pole-re-and-im-rad-s-lacks-its-conjugate = polu { $re } in { $im } rad/s manjka konjugirani, { $re } in { $other }
t-2-to-n-coefficients-above-0-a0-first-with-an = 2 do { $n } koeficientov nad 0, najprej a0: z drugim predznakom ni stabilen noben pogon
one-of-poles-and-denominator-is-wanted-besid = zraven je potreben natanko eden od `poles` in `denominator`
a-drive-has-at-least-one-pole = pogon ima vsaj en pol
it-stands-without-poles = stoji brez `poles`
the-feed-drive-stands-in-feed-drive-already = podajalni pogon je že v [feed_drive]
there-is-nothing-in-it-dead-time-s-feed-driv-2 = v njej ni ničesar: dead_time_s, [feed_drive], [spindle_drive] ali [limits]

## crates/study/src/own_file/material.rs

material-file = datoteka materiala

## crates/study/src/own_file/mod.rs

file-of-your-own = lastna datoteka
it-is-none-of-a-cutter-diameter-mm-teeth-a-s-2 = ni ne frezalo (diameter_mm, teeth) ne struktura ([[mode]]) ne material (kc11_n_mm2) ne stroj ([feed_drive], poles ali [limits])

## crates/study/src/papers/calibrations.rs

calibrations = umeritve

## crates/study/src/papers/table_job.rs

simulations = simulacije

## crates/study/src/papers.rs

the-paper-prints-a-final-force-of-195-2-n-mo = članek navaja končno silo 195,2 N, kar je najverjetneje tiskovna napaka za 190,2 N: simulacija se primerja z 190,2 N. Model K4 (obnovljen) da za podajanje in vrtilno hitrost te vrstice 190,2 N, in s to silo se njen Ra ujema z vsemi drugimi vrsticami

## crates/study/src/papers_2019.rs

natural-frequencies-without-damping-list-hz = lastne frekvence brez dušenja: { $list } Hz
one-resonance-between-tooth-and-work-from-0 = ena resonanca med zobom in obdelovancem od 0 do 3000 Hz: { $peak } m/N pri { $frequency } Hz
eq-1-as-printed-is-unstable-real-poles-at-co = en. 1, kot je natisnjena, je nestabilna: realni poli pri +{ $corrected } 1/s s popravljenimi števili, pri +{ $printed } 1/s z natisnjenimi
eq-2-as-printed-tool-point-printed-m-n-at-re = en. 2, kot je natisnjena: konica orodja { $printed } m/N v mirovanju in { $moving } pri 110 Hz; popravljeno { $corrected } v mirovanju, { $times }-krat tako podajna
table-1-s-springs-and-dampers-from-its-rules = vzmeti in dušilke preglednice 1 iz njenih pravil, razen vnosov med tiskovnimi napakami
the-solution-of-eq-2-by-gauss-from-0-to-3000 = rešitev en. 2 po Gaussu od 0 do 3000 Hz v korakih po 10 Hz (`steadycut machine frf`)
no-published-curve-the-figures-are-not-avail = objavljene krivulje ni: slike niso na voljo kot podatki, zato spektri, trend zvoka, profil hrapavosti in trend hrapavosti nimajo ob sebi nobene meritve
the-correlations-0-684-and-0-993-compare-wit = korelaciji 0,684 in 0,993 primerjata z meritvami, ki niso bile objavljene; izbrati je mogoče šum, ki ju da, kar ne potrjuje ničesar
how-wear-changes-springs-and-dampers-is-not = kako obraba spremeni vzmeti in dušilke, ni navedeno; vsak zakon obrabe tu je predpostavka
absolute-amplitudes-a-force-of-107-n-at-ever = absolutne amplitude: sila 107 N pri vsaki črti spektra je formalna razlaga en. 2
parameters-of-the-tool-life-prediction-its-e = parametri napovedi obstojnosti: njenih enačb v članku ni

## crates/study/src/part/blank.rs

the-blank-s-size-along-axis-is-size-mm-allow = velikost surovca vzdolž { $axis } je { $size } mm: dovoljeno je od { $least } do { $most } mm
the-blank-s-corner-has-to-be-three-numbers-i = vogal surovca morajo biti tri števila v mm
a-grid-of-cell-mm-over-the-blank-has-n-cells = mreža { $cell } mm čez surovec ima { $n } celic: dovoljenih je { $most }; večji korak jih ima manj

## crates/study/src/part/carved.rs

the-program-has-no-feed-move-nothing-is-cut = program nima podajalnega giba: nič se ne reže
the-way-has-n-pieces-at-most-most-are-drawn = pot ima { $n } kosov: narisanih je največ { $most }

## crates/study/src/part/columns.rs

column-name-the-unit-is-unit-allowed-is-all = stolpec `{ $name }`: enota je `{ $unit }`: dovoljeno je { $all }
the-columns-name-and-other-mean-the-same = stolpca `{ $name }` in `{ $other }` pomenita isto
s-or-x-and-y = s (ali x in y)
the-columns-are-found-missing-are-missing = stolpci so { $found }; manjkajo { $missing }
line-line-column-name-cell-allowed-is-a-numb = vrstica { $line }, stolpec `{ $name }`: `{ $cell }`: dovoljeno je število od { $least } do { $most } { $unit }
line-line-the-path-begins-at-s-mm-allowed-is = vrstica { $line }: pot se začne pri { $s } mm: dovoljeno je 0
line-line-the-path-is-at-s-mm-allowed-is-mor = vrstica { $line }: pot je pri { $s } mm: dovoljeno je več od { $before } mm prejšnje vrstice
the-table-has-n-rows-allowed-is-2-or-more-fr = tabela ima toliko vrstic: { $n }; dovoljeni sta 2 ali več, od začetka poti do njenega konca
the-path-is-length-mm-long-allowed-is-at-mos = pot je dolga { $length } mm: dovoljeno je največ { $most } mm
columns-that-are-not-used-names = Neuporabljeni stolpci: { $names }.

## crates/study/src/part/gcode/arc.rs

the-arc-s-radius-is-first-mm-at-its-start-an = polmer loka je na začetku { $first } mm, na koncu { $last } mm: dovoljen je enak, večji od 0
an-arc-of-radius-radius-mm-does-not-join-poi = lok s polmerom { $radius } mm ne povezuje točk, ki sta { $way } mm narazen: dovoljen je polmer polovice tega ali več in dve različni točki

## crates/study/src/part/gcode/reader.rs

at-most-n-lines-are-read = največje število prebranih vrstic je { $n }
letter-stands-there-twice = `{ $letter }` je zapisana dvakrat
two-kinds-of-motion-in-one-line = dve vrsti gibanja v eni vrstici
word-changes-where-the-tool-goes-in-a-way-th = { $word } spremeni pot orodja na način, ki ni upoštevan
word-allowed-is-0-or-more = { $word }: dovoljeno je 0 ali več
word-subprograms-are-not-followed = { $word }: podprogrami niso upoštevani
word-only-x-y-z-i-j-and-r-say-where-the-tool = { $word }: pot orodja povedo samo X, Y, Z, I, J in R
axis-is-relative-and-where-the-tool-is-along = `{ $axis }` je relativna in ni znano, kje vzdolž nje je orodje
a-place-without-a-motion-g0-g1-g2-or-g3-come = mesto brez gibanja: najprej pride G0, G1, G2 ali G3
a-feed-move-from-a-place-that-is-not-known-r = podajalni gib z mesta, ki ni znano: najprej pridejo hitri gibi na X, Y in Z
i-j-and-r-belong-to-arcs-g2-and-g3 = I, J in R sodijo k lokom, G2 in G3
an-arc-has-i-and-j-or-r-not-both = lok ima I in J ali R, ne obojega
an-arc-without-i-j-or-r = lok brez I, J ali R

## crates/study/src/part/gcode/words.rs

a-comment-has-no-end = komentar nima konca
code-sign-is-no-letter-of-a-word-variables-e = `{ $code }`: `{ $sign }` ni črka besede; spremenljivke, izrazi, preskočeni bloki in besede O niso upoštevani
letter-is-followed-by-number-allowed-is-a-nu = črki `{ $letter }` sledi `{ $number }`: dovoljeno je število

## crates/study/src/part/milling.rs

the-step-is-step-mm-allowed-is-least-to-most = korak je { $step } mm: dovoljeno je od { $least } do { $most } mm
a-way-of-length-mm-in-steps-of-step-mm-allow = pot { $length } mm s koraki { $step } mm: dovoljenih korakov je { $most }; večji korak jih ima manj
mm-of-the-way = mm poti
rapid-moves-through-material-lines-lines = Hitri gibi skozi material: vrstice { $lines }.
straight-down-into-material-lines-lines = Naravnost navzdol v material: vrstice { $lines }.
not-acted-on-word-lines-lines = Neupoštevano: { $word }, vrstice { $lines }.
behind-the-end-of-the-program-n-lines-not-re = Za koncem programa: { $n } vrstic, neprebranih.
there-are-feed-moves-before-the-first-f-thei = Pred prvim F so podajalni gibi: njihovo podajanje ni znano.

## crates/study/src/part/path.rs

the-part-has-n-cuts-with-air-between-them-on = obdelovanec ima več rezov z zrakom med njimi ({ $n }): samo ena pot je tabela globin

## crates/study/src/part/taken.rs

the-depths-change-at-n-places-allowed-are-mo = globine se spremenijo na { $n } mestih: dovoljenih je { $most }, pri čemer razlike do { $same } mm ne štejejo; večji korak ali del poti jih ima manj
differences-of-depth-up-to-same-mm-are-taken = Razlike globine do { $same } mm ne štejejo, da gre obdelovanec v scenarij.
the-time-limit-is-time-s-now-run-duration-s = Časovna omejitev je zdaj { $time } s (`run.duration_s`), dvakrat toliko, kolikor traja pot pri programiranem podajanju.
it-would-take-wanted-s-a-run-has-most-s-at-m = Trajalo bi { $wanted } s; simulacija ima največ { $most } s in se lahko konča pred potjo.
one-row-is-recorded-per-control-period-run-r = Zapiše se ena vrstica na regulacijsko periodo (`run.record_every`): simulacija je dolga.
the-file-programs-feeds-from-low-to-high-mm = Datoteka programira podajanja od { $low } do { $high } mm/min; simulacija programira { $feed } mm/min (`program.feed_mm_min`).
the-file-programs-speeds-from-low-to-high-1 = Datoteka programira vrtilne frekvence od { $low } do { $high } 1/min; simulacija programira { $speed } 1/min (`program.spindle_rpm`).

## crates/study/src/plan/constraints.rs

chosen-the-papers-cite-their-list-of-seven-w = izbrano: članka navajata svoj seznam sedmih, ne da bi ga podala
the-spindle-turns-neither-slower-nor-faster = Vreteno se ne vrti niti počasneje niti hitreje.
the-feed-drives-move-neither-slower-nor-fast = Podajalni pogoni se ne premikajo niti počasneje niti hitreje.
f-sqrt-f-x-2-f-y-2-from-the-network = F = sqrt(F_x^2 + F_y^2), iz mreže
roughness-follows-the-force-above-the-refere = Hrapavost sledi sili: nad referenčno silo ciljnega Ra (ali lastno mejo) je površina bolj hrapava, kot bi smela biti.
the-spindle-motor-must-turn-the-cutter-again = Motor vretena mora vrteti frezalo proti sili.
roughness-of-the-feed-marks = Hrapavost sledi podajanja
feed-marks-grow-with-the-square-of-the-feed = Sledi podajanja rastejo s kvadratom podajanja. 318 f^2 / (4 D) je oblika po Tolouei-Radu in Bidhendiju; faktor 5 in z f_z (opletanje: vse odreže en zob) sta izbrana.
cutter-deflection = Upogib frezala
a-bent-cutter-leaves-the-contour = Upognjeno frezalo zapusti konturo.
the-edges-must-last-taylor-s-law-with-the-co = Rezalni robovi morajo zdržati. Taylorjev zakon s konstantami prednastavitve table_2005.

## crates/study/src/plan/machine.rs

placeholder = nadomestna vrednost

## crates/study/src/plan/mod.rs

iterations-2 = iteracije

## crates/study/src/plan/optimum.rs

feasible-at-depth-mm-depth-by-the-plan-s-net = po mreži načrta dopustno pri globini { $depth } mm; nobena omejitev ni dejavna
feasible-at-depth-mm-depth-by-the-plan-s-net-2 = po mreži načrta dopustno pri globini { $depth } mm; dejavne: { $names }
nothing-is-feasible-in-the-range-searched-at = v preiskanem območju pri globini { $depth } mm ni nič dopustno; prikazana je najmanjša kršitev, kršene: { $names }

## crates/study/src/plan/over_depths.rs

in-tolerance-2 = v toleranci
above-its-tolerance = nad toleranco
below-its-tolerance = pod toleranco
not-judged-outside-the-model = ni presojano, zunaj modela
verdict-not-places = { $verdict }; ne pa { $places }
verdict-at-the-part-s-other-depths-too = { $verdict }; tudi pri drugih globinah obdelovanca
verdict-the-part-has-no-such-depth = { $verdict }; obdelovanec te globine nima
at-depth-broken = pri { $depth }: { $broken }
depth-plan-n-by-the-network-no-force-in-the = { $depth }: po mreži { $plan } N, v simulaciji brez sile
depth-plan-n-by-the-network-run-n-in-the-run = { $depth }: po mreži { $plan } N, v simulaciji { $run } N ({ $more } %), { $held }
violated-names = ; kršene: { $names }
outside-the-network-s-training-data = ; zunaj učnih podatkov mreže
at-this-feed-kept-constant-without-noise-and = Pri tem podajanju, ki ostane stalno, brez šuma in tresenja
at-this-feed-kept-constant-without-noise-and-2 = Pri tem podajanju, ki ostane stalno, brez šuma in tresenja; vmesnih globin, ki niso presojane: { $n }

## crates/study/src/plan/problem.rs

at-least-least-mm-for-a-plan = vsaj { $least } mm za načrt
above-0-for-at-least-one-of-weight-force-wei = nad 0 za vsaj eno od weight_force, weight_removal_rate, weight_time in weight_cost
above-0-or-plan-tool-cost-above-0-where-cost = nad 0, ali pa `plan.tool_cost` nad 0, kjer se išče cena

## crates/study/src/plan/remarks.rs

times-removal-rate-and-cost-are-those-of-thi = Časi, odvzem in cena veljajo za to podajanje, ohranjeno skozi ves rez: { $controller } med rezom spreminja podajanje in z njim vse to
the-plan-s-force-is-that-of-the-network-plan = Sila načrta je sila mreže ({ $plan }), sila simulacije pa prihaja iz: { $run }; razlikujeta se, zato se simulacija ne začne pri načrtovani sili
chatter-is-none-of-the-constraints-and-this = Drdranje ni med omejitvami, ta stroj pa v rezu niha: ali sta načrtovana hitrost in globina mirni, pove njegov diagram stabilnosti
the-constraints-are-judged-at-the-programmed = Omejitve so presojane pri programiranih vrednostih: prilagodljivi regulator potem drži silo ter premika podajanje in vrtilno hitrost po svojih modelih, ne glede na to, kaj to pomeni za obstojnost orodja in moč

## crates/study/src/profilometer.rs

the-line-s-ends-must-be-numbers-in-mm = konca črte morata biti števili v mm
no-tooth-has-cut-anything-yet = noben zob še ni ničesar odrezal
the-line-is-length-mm-long-with-these-cut-of = črta je dolga { $length } mm: s temi mejnimi valovnimi dolžinami potrebuje vsaj { $least } mm (zalet na vsaki strani in eno referenčno dolžino) in največ { $most } mm
the-line-leaves-the-machined-surface-at-x-x = črta zapusti obdelano površino pri x = { $x } mm, y = { $y } mm: { $beside }
there-y-reaches-from-low-to-high-mm = tam y sega od { $low } do { $high } mm
x-reaches-from-first-to-last-mm-so-far = x za zdaj sega od { $first } do { $last } mm

## crates/study/src/published.rs

initial-force = Začetna sila

## crates/study/src/recommend/learned.rs

input-first-engagement-second = { $input }: { $first }, prijem: { $second }
low = nizko
middle = srednje
high = visoko

## crates/study/src/recommend/mod.rs

a-recommendation-interpolates-a-table-it-is = Priporočilo interpolira tabelo; ni poznavanje reza.
hardness-2 = trdota
diameter-2 = premer

## crates/study/src/recommend/table.rs

synthetic-formulas-that-imitate-a-maker-s-ta = sintetično: formule, ki posnemajo tabelo proizvajalca, s 3 % šuma; brez proizvajalčevih podatkov

## crates/study/src/safe_feed/mod.rs

no-constant-feed-is-safe-even-at-feed-mm-min = nobeno stalno podajanje ni varno, niti { $feed } mm/min pri { $speed } 1/min: { $broken }
speeds = vrtilne hitrosti

## crates/study/src/safe_feed/trial.rs

ra-is-value-um-at-place-mm-rougher-than-allo = Ra je { $value } µm pri { $place } mm, bolj hrapavo od dovoljenega
the-force-is-value-n-at-place-mm-above-its-t = sila je { $value } N pri { $place } mm, nad svojo toleranco
ra-is-value-um-with-vibration-at-place-mm-ro = Ra z vibracijami je { $value } µm pri { $place } mm, bolj hrapavo od dovoljenega
the-part-is-not-cut-to-its-end-end = obdelovanec ni obdelan do konca ({ $end })
the-part-is-not-cut-to-its-end-the-machine-d = obdelovanec ni obdelan do konca: stroj ne doseže podajanja
ra-lies-outside-its-model-on-the-whole-part = Ra je na vsem obdelovancu zunaj svojega modela, zato ni mogoče ničesar oceniti

## crates/study/src/stability/chart.rs

curves = krivulje

## crates/study/src/stability/mod.rs

r-d-radial-mm-of-a-cutter-of-diameter-mm-wit = R_D { $radial } mm frezala { $diameter } mm, število zob { $teeth }: vsak reže po kotu { $angle } stopinj
above-0-mm-for-a-stability-chart = nad 0 mm za karto stabilnosti

## crates/study/src/stability/tip/mod.rs

r-d-radial-mm-of-a-cutter-of-diameter-mm-wit-2 = R_D { $radial } mm frezala { $diameter } mm s { $teeth } zobmi: vsak reže od { $from } do { $to } stopinj, { $way }
down-milling = istosmerno frezanje
up-milling = protismerno frezanje

## crates/study/src/train/claim.rs

neural-network-predictions-were-by-4-closer-2 = »napovedi nevronske mreže so bile za 4 % bliže meritvam v primerjavi s 6 %« najboljše formule, razumljeno kot srednji napaki
literal-network = dobesedna mreža
inputs-activation-and-learning-as-the-paper = vhodi, aktivacija in učenje, kot jih ima članek
improved-network = izboljšana mreža
logarithms-of-the-inputs-other-learning = logaritmi vhodov, drugačno učenje
genetic-programming = genetsko programiranje
a-formula-of-the-same-inputs-found-here = formula istih vhodov, najdena tu
the-network-is-closer-than-the-formula-own-a = { $network } je bližja kot formula: { $own } % proti { $formula } %
name-own-where-the-paper-has-paper-within-ne = { $name }: { $own } %, kjer ima članek { $paper } %, v mejah { $near } odstotne točke

## crates/study/src/train/comparison.rs

networks = mreže

## crates/study/src/train/data.rs

the-papers-3500-measurements-were-never-publ = 3500 meritev iz člankov ni bilo nikoli objavljenih: učni podatki izhajajo iz mehanističnega modela kroglastega frezala (latinska hiperkocka, opletanje 3 µm, rezine 0,25 mm) s šumom 3 % in 3 N.
rows = vrstice

## crates/study/src/train/mod.rs

epochs = epohe

## crates/study/src/uses/mod.rs

it-reads-list = bere { $list }

## crates/study/src/uses/reads.rs

only-run-prints-it = izpiše ga samo `run`
only-metrics-judge-by-it-and-this-prints-non = po njem ocenjujejo samo merila, to pa ne izpiše nobenega od njih
it-prints-no-cost = cene ne izpiše
a-row-is-recorded-for-every-control-period = vrstica se zapiše za vsako regulacijsko periodo
the-controller-is-always-unks = regulator je vedno UNKS
ra-is-not-among-what-this-prints = Ra ni med tem, kar se izpiše
plant-force-model-is-no-formula-and-ra-is-no = `plant.force_model` ni formula, Ra pa ni med tem, kar se izpiše
twin-kind-is-programmed = `twin.kind` je programmed
plan-force-limit-is-not-fixed = `plan.force_limit` ni fixed
plan-force-limit-is-fixed = `plan.force_limit` je fixed
plan-free-speed-is-true-the-speed-is-searche = `plan.free_speed` je true: hitrost se išče
machine-tip-modes-gives-the-machine-and-the = `machine.tip_modes` podaja stroj, koti zob pa smer
machine-tip-modes-is-empty-the-five-masses-h = `machine.tip_modes` je prazen: pet mas ima eno smer
workpiece-cuts-gives-the-radial-depths = `workpiece.cuts` podaja radialne globine
workpiece-radial-depth-mm-is-the-width-of-th = `workpiece.radial_depth_mm` je širina reza ne glede na obliko čela
plant-calibration-is-not-formula = `plant.calibration` ni formula
it-tells-how-a-run-goes-and-this-is-no-run = pove, kako poteka simulacija, to pa ni simulacija

## choices of the studies

met = doseženo
missed = ZGREŠENO
first-order = prvi red
second-order-critically-damped = drugi red, kritično dušen
second-order = drugi red
third-order = tretji red
slot = utor
heavy-side-cut = težek stranski rez
light-side-cut = lahek stranski rez
finishing = fina obdelava
as-the-rules-say = kot pravijo pravila
q-wrong-the-damper-shows-5-not-17 = Q napačen: dušilka kaže 5, ne 17
m3-rounded-to-one-digit-damper-wrong = m3 zaokrožen na eno števko; dušilka napačna
exponent-of-the-spring-wrong-8-not-12 = eksponent vzmeti napačen: 8, ne 12
exponent-of-the-damper-wrong-5-not-8 = eksponent dušilke napačen: 5, ne 8
not-as-the-rules-say = ni, kot pravijo pravila
nsn = Nsn
nsn-20-samples = Nsn, 20 vzorcev
in-tolerance = V toleranci
force-within-10 = Sila v mejah 10 %
longest-overload = Najdaljša preobremenitev
override-travel = Pot korekcije
the-papers-models = modeli iz člankov
the-models-found = najdeni modeli
sdnrp-2007-table-3 = SDNRP 2007, preglednica 3
control-strategy-2013-table-1 = Strategija vodenja 2013, preglednica 1
feasible = dopustno
nothing-is-feasible = nič ni dopustno
at-most = največ
at-least = vsaj
the-same-as = enako kot
other-than = drugače kot
less-than = manj kot
more-than = več kot
largest-less-least = razpon
first = prva vrednost
last = zadnja vrednost
x-along-the-feed = x, vzdolž podajanja
y-across-the-feed = y, prečno na podajanje
holds = drži
holds-in-part = delno drži
does-not-hold = ne drži
no-run-yet = simulacije še ni
k4-of-the-papers = K4 iz člankov
tooth-by-tooth-2 = zob za zobom
lines-lines-direction-modes-n = vrstic: { $lines }, { $direction }; nihajnih oblik: { $n }
