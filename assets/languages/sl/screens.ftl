# Slovenščina

## src/app/panels/block_diagram/brush.rs

your-own-order-order = lasten, red { $order }
low-to-high-whole = { $low } do { $high } %, celi
low-to-high-2 = { $low } do { $high } %
at-most-rate-s = največ { $rate } %/s
hardness-hb-wear-wear = { $hardness } HB, obraba { $wear }
off = izključeno
noise-level = šum × { $level }
noise-force-n = šum { $force } N
click-a-wire-to-plot-it-a-block-for-its-equa = Kliknite povezavo za njen graf, blok za njegove enačbe. Polna lučka: deluje meja ali pa je model uporabljen zunaj svojega območja.

## src/app/panels/block_diagram/card_view.rs

what-is-this = Kaj je to?
set-here = Nastavitve
as-printed-2 = Kot je natisnjeno
holds-range = velja: { $range }
outside-range = ZUNAJ: { $range }
plot = Graf:

## src/app/panels/block_diagram/draw.rs

plot-signal = Graf: { $signal }
as-it-should-be = kot mora biti

## src/app/panels/block_diagram.rs

block-diagram = Shema
closed-loop = Zaprta zanka
nm-1-and-nm-2-at-the-playhead-learning-curve = NM-1 in NM-2 pri časovnem kazalcu, učne krivulje, več prehodov
networks-that-learn = Mreže, ki se učijo

## src/app/panels/compare/boxes.rs

spread-over-the-seeds = Raztros po semenih:
spread-of-measure = Raztros: { $measure }
no-values-yet-run-the-comparison = Vrednosti še ni: zaženite primerjavo.
every-seed-gave-the-same-run-a-box-is-a-line = Vsako seme je dalo isto simulacijo: škatla je črta.
mean = povprečje
printed-in-table-1 = natisnjeno v preglednici 1
name-most-most-upper-quartile-upper-median-m =
    { $name }
    največ { $most }
    zgornji kvartil { $upper }
    mediana { $median }
    spodnji kvartil { $lower }
    najmanj { $least }
printed = natisnjeno
box-plots-of-title-done-of-n-runs = Okvirji: { $title }, simulacij { $done } od { $n }

## src/app/panels/compare/claims.rs

table-1-of-2005-belongs-to-experiment-2-in-c = Preglednica 1 iz 2005 velja za preizkus 2 v Ck45 pri mrtvem času 40 ms: ob čem drugem njenih številk ni.
beside-table-1-of-2005 = Ob preglednici 1 iz 2005
met-of-n-bands-kept = doseženih pasov: { $met } od { $n }
kept = doseženo
not-reached = ni doseženo
found-found = najdeno { $found }
the-bands-are-judged-when-the-six-methods-of = Pasovi se ocenijo, ko se zaključi vseh šest metod iz preglednice.
chosen-with-the-table-in-view = Izbrano s pogledom na preglednico
not-reached-and-why = Ni doseženo in zakaj
title-figures-of-version-version = { $title } (številke različice { $version })

## src/app/panels/compare/contest.rs

done-of-n-runs-done = opravljenih simulacij: { $done } od { $n }
compare-conditions = Primerjava: pogoji
compare-what = Primerjava: { $what }
the-console-s-cut = Rez s pulta
the-cut-that-is-open-in-the-console-from-its = Rez, ki je odprt na pultu, od začetka, z nastavitvami, ki jih pult kaže zdaj.
experiment-2 = Preizkus 2
experiment-2-of-2005-five-straight-cuts-one = Preizkus 2 iz 2005, pet ravnih rezov, eno programirano podajanje: tisto iz preglednice 1.
experiment-2-feeds-per-cut = Preizkus 2, podajanja po rezih
the-same-with-a-programmed-feed-for-every-cu = Isto s programiranim podajanjem za vsak rez, kot jih načrt najde za najlažje odseke: onkraj članka.
as-it-is = kot je
as-the-part-s-scenario-has-it = Kot ga ima scenarij obdelovanca.
t-0-ms = 0 ms
none = Brez.
t-40-ms = 40 ms
t-40-ms-of-the-2013-paper = 40 ms, iz članka 2013.
t-80-ms = 80 ms
t-80-ms-of-the-2007-paper = 80 ms, iz članka 2007.
ck45 = Ck45
ck45-2 = Ck45.
t-16mncrsi5 = 16MnCrSi5
t-16mncrsi5-xm = 16MnCrSi5 XM.

## src/app/panels/compare/controls.rs

part = Obdelovanec
settings-of-the-comparison = Nastavitve primerjave
run-the-comparison = Zaženi primerjavo
pause-the-comparison = Ustavi primerjavo
runs-everybody-on-every-seed-it-goes-on-whil = Zažene vse z vsemi semeni; teče tudi ob drugih zaslonih
seeds = Semena
every-seed-is-another-material-and-other-sen-2 = Vsako seme pomeni drug material in drug šum senzorja, enak za vse; brez šuma dajo vsa semena isto simulacijo
done = končano
load-step-step-of-of-then-n-runs =
    { $n ->
        [one] stopnica obremenitve { $step } od { $of }, nato { $n } simulacija
        [two] stopnica obremenitve { $step } od { $of }, nato { $n } simulaciji
        [few] stopnica obremenitve { $step } od { $of }, nato { $n } simulacije
       *[other] stopnica obremenitve { $step } od { $of }, nato { $n } simulacij
    }
sdnrp-and-tracking-set-feed-and-speed-by-wha = SDNRP in Sledenje nastavita podajanje in vrtilno hitrost po tem, kar hoče Ra; ta obdelovanec iz 2005 drži silo, njegova preglednica 1 pa ju ne pozna. Izključena sta, dokler ju ne izberete.
dead-time = Mrtvi čas
material = Material
who-takes-part = Kdo sodeluje:
compared-is-title-changed-name-from-its-star = Primerja se »{ $title }, spremenjeno« ({ $name }) od začetka, z nastavitvami, ki jih pult kaže zdaj.
compared-is-title-name-from-its-start-with-t = Primerja se »{ $title }« ({ $name }) od začetka, z nastavitvami, ki jih pult kaže zdaj.
not-repeated-at-their-times-changes-what-the = Ob svojih časih se ne ponovi: { $changes }. Kar pult kaže pri { $time }, velja od začetka, za vse.
name-last-at-time = { $name } (nazadnje pri { $time })
n-more = še { $n }
stands-still-what-is-done-stays = Miruje; kar je opravljeno, ostane

## src/app/panels/compare/robust.rs

without-retuning-anything = Brez kakršne koli ponovne nastavitve
experiment-2-at-other-dead-times-which-the-c = Preizkus 2 pri drugih mrtvih časih, ki jih regulatorji poznajo, in v drugem jeklu, ki ga ne poznajo. Pod vsako številko je številka neodvisnega prototipa istih enačb, kjer jo ima: ni številka iz članka.
run-the-conditions = Zaženi pogoje
pause-the-conditions = Ustavi pogoje
runs-everybody-under-every-condition = Zažene vse v vseh pogojih
done-of-n-runs = simulacij: { $done } od { $n }
control = Vodenje
n-of-runs-runs-not-finished = nedokončanih simulacij: { $n } od { $runs }

## src/app/panels/compare/step.rs

after-a-load-step = Po stopnici obremenitve
done-of-n-done = opravljeno: { $done } od { $n }
from-a-section-of-before-n-into-one-of-after = Iz odseka z { $before } N v odsek z { $after } N (statične konice v Ck45 pri korekciji 100 %), brez šuma: število regulacijskih period po { $period } ms, dokler se povprečje štirih vzorcev dokončno ne vrne na 10 %. Članek natisne iteracije optimizacijskega koraka in ne pove, kaj so; prikazane so ob strani.
not-run-yet-it-comes-first-when-the-comparis = Še ni opravljeno: primerjava ga izvede najprej.
periods = Periode
overshoot = Prenihaj
left-over = Preostanek
printed-2 = Natisnjeno

## src/app/panels/compare/table.rs

printed-value = natisnjeno { $value }
best-within-the-spread = najboljši, znotraj raztrosa
load = Naloži
load-name = Naloži: { $name }
opens-the-cut-in-the-console-with-this-way-o = Odpre rez na pultu s tem načinom krmiljenja in s semenom, ki je tam nastavljeno
n-of-all-not-finished = nedokončanih: { $n } od { $all }
n-of-all-stopped-by-overload = ustavila preobremenitev: { $n } od { $all }
n-of-all-unstable = nestabilno: { $n } od { $all }
n-of-all-chattered = z drdranjem: { $n } od { $all }
why-not-all-hold-the-tolerance = Zakaj vsi ne držijo tolerance
mean-and-standard-deviation-over-the-seeds-a = Povprečje in standardni odklon po semenih. Zvezdica označuje najboljšega v stolpcu, kjer vodi za več kot oba odklona skupaj; pri manj kot treh semenih raztros ni znan in ne vodi nihče. Nsn: normirana standardna napaka, koliko sila odstopa od reference, manj je bolje.
columns-are-ranked-only-among-those-that-hol-2 = Razvrstitev ({ $columns }) je samo med tistimi, ki držijo toleranco: zunaj nje ni pridobitev.
afc-has-no-reference-forces-here-it-is-taugh = AFC tu nima referenčnih sil: uči se s programiranim podajanjem. Naučite ga v oknu AFC na pultu.
so-far-done-ranking = Za zdaj, { $done }: { $ranking }
every-seed-gave-the-same-run-since-nothing-r = Vsako seme je dalo isto simulacijo, saj tu nič naključnega ne deluje: raztrosa ni.
the-force-strays-least-from-its-reference-wi-3 = sila najmanj odstopa od reference z regulatorjem { $controller }: njen normirani standardni pogrešek Nsn je { $nsn }, 0 je popolno
of-those-told = Med njimi { $told }.
of-those-told-the-lead-is-within-the-spread = Med njimi { $told }; prednost je znotraj raztrosa.
of-all-told = Med vsemi { $told }.
of-all-told-the-lead-is-within-the-spread = Med vsemi { $told }; prednost je znotraj raztrosa.
nobody-is-judged-yet = Presojan ni še nihče.
nobody-holds-the-tolerance-on-percent-of-the-2 = Tolerance na { $percent } % dolžine ne drži nihče.
who-holds-the-tolerance-on-percent-of-the-le = Toleranco na { $percent } % dolžine držijo: { $controllers }.
by-controller = Po regulatorjih
by-measure = Po merilih

## src/app/panels/compare.rs

compare = Primerjava
controllers-ranking-best-seeds-statistics-to = regulatorji lestvica najboljši semena statistika turnir primerjaj controllers ranking
nobody-takes-part = Nihče ne sodeluje
choose-at-least-one-way-of-control-above = Zgoraj izberite vsaj en regulator.

## src/app/panels/equation_cards/live.rs

symbol-c-delayed-by-time-s = { $symbol }_c z zamikom { $time } s
in-now-out-then-unit = vhod { $now }, izhod { $then } { $unit }
symbol-c-command-gives-symbol-a-actual-unit = { $symbol }_c = { $command } da { $symbol }_a = { $actual } { $unit }
f-c-command-gives-f-a-feed-mm-min = f_c = { $command } da f_a = { $feed } mm/min
a-straight-ramp-beyond-error-1-min-of-error = enakomerna rampa pri pogrešku nad { $error } 1/min
level-level-band-band-ripple-ripple-inhomoge = raven { $level }: pas { $band } %, valovanje { $ripple } %, nehomogenost { $inhomogeneity } %
f-m-symbol-noise-of-deviation-n-standard-dev = F_m = { $symbol } + šum { $deviation } N (standardni odklon)
f-m-measured-n-held-since-the-last-sample-sy = F_m = { $measured } N, zadržana od zadnjega vzorca; { $symbol } zdaj { $force } N

## src/app/panels/equation_cards/machine.rs

p-f-g-max-g-force-factor-b-u-u-t-g-the-teeth = P = F g / max g - { $force } · { $factor } b (u - u_T), g odrezek zob, u_T en zob prej
u-vibration-um-as-the-last-tooth-made-the-su = u = { $vibration } µm, ko je zadnji zob naredil površino; hitrost { $sound } mm/s v zadnji sekundi
ra-dyn-ra-ra-marks-ra-marks-without-vibratio = Ra_{ "{" }dyn{ "}" } = Ra + Ra(sledi) - Ra(sledi brez vibracij)

## src/app/panels/equation_cards/models.rs

symbol-low-to-high-unit = { $symbol } { $low } do { $high } { $unit }
range-straight-on-beyond = { $range }; naprej po premici
f-d-at-least-force-n = F_d vsaj { $force } N
f-s-from-force-n-on-below-it-the-feed-is-neg = F_s od { $force } N naprej; pod njo je podajanje negativno
f-s-where-the-feed-is-positive-and-rises-wit = F_s, kjer je podajanje pozitivno in raste z njo
f-s-up-to-force-n-above-it-there-is-no-root = F_s do { $force } N; nad njo ni korena
range-goes-on-beyond = { $range }; naprej se nadaljuje
symbol-the-tool-is-in-the-air = { $symbol }: orodje je v zraku
no-force-so-no-surface-is-cut = brez sile, zato se površina ne reže
range-straight-on-beyond-before-its-pole-at = { $range }; naprej po premici, pred polom pri 293 N
range-it-turns-round-at-force-n = { $range }; obrne se pri { $force } N

## src/app/panels/equation_cards/overrides.rs

ramp = rampa
round-wanted-to-whole = zaokroži({ $wanted }) na cele %
rate-t-rate-s-period-s-step-name-is-on-its-w = hitrost T = { $rate } %/s · { $period } s = { $step } %: { $name } je na poti
rate-t-rate-s-period-s-step-name-is-arrived = hitrost T = { $rate } %/s · { $period } s = { $step } %: { $name } je na cilju
ramp-limit-wanted-ramp-rate-t-wanted-limit-s = rampa' = limit(želeno - rampa, ± hitrost T),  želeno = limit({ $symbol } / { $symbol }_p, { $low }..{ $high } %)
name-reaches-what-is-wanted-within-a-period = { $name } doseže želeno v eni periodi

## src/app/panels/identify/actions.rs

with-units-and-ranges-as-steadycut-identify = Z enotami in območji, kot zapiše `steadycut identify gp --out`
save-as-a-model = Shrani kot model
copy-as-text = Kopiraj kot besedilo
copy-as-latex = Kopiraj kot LaTeX
puts-the-formula-into-the-clipboard = Kopira formulo v odložišče
the-formula-is-in-the-clipboard-form = Formula je v odložišču ({ $form }).
neither-a-model-nor-for-the-cut-because = Niti model niti za rez: { $because }.
input-in-unit = `{ $input }` v { $unit }
nothing = nič
and = { " " }in{ " " }
a-number-without-a-unit = število brez enote
the-cut-has-no-place-for-it-by-its-units-it = Rez po njenih enotah nima mesta zanjo: naredi { $makes } ({ $made }).
use-in-the-cut-place = Uporabi v rezu: { $place }
in-the-running-cut-place = V tekočem rezu: { $place }.
show-the-cut = Pokaži rez
plant-and-controller-compute-with-it-from-no = Proces in regulator odslej računata z njo (umeritev: lastne formule); Razveljavi jo vzame nazaj
place-the-formula-stands-in-the-running-cut = { $place }: formula je v tekočem rezu, z umeritvijo lastne formule. Razveljavi jo vzame nazaj.

## src/app/panels/identify/columns.rs

target-and-inputs = Cilj in vhodi
left-out-because = izpuščeno: { $because }
units = Enote
input = vhod
target-2 = cilj
name-low-to-high = { $name }: { $low } do { $high }
unit-of-name = Enota: { $name }
as-mm-min-1-min-n-um-empty-or-1-for-none-the = Kot mm/min, 1/min, N, um; prazno ali 1 za brez. Najprej jo pove konec imena stolpca

## src/app/panels/identify/controls.rs

table-table = Tabela: { $table }
open-a-csv = Odpri CSV…
a-table-with-a-line-of-names-it-can-also-be = Tabela z vrstico imen; lahko jo tudi spustite sem
table-rows-rows-columns-columns = { $table }: vrstic { $rows }, stolpcev { $columns }.
search = Iskanje
seed = Seme
most-batches = Največ serij
it-ends-earlier-where-nothing-is-gained-for = Konča se prej, če 200 serij ne prinese izboljšanja ali je formula točna.
known-part-of-the-formula = Znani del formule
none-or-as-a-b-n-3-t-f = brez ali kot a + b*n^3 + T(f)
columns-by-their-names-other-names-are-const = Stolpci po imenih; druga imena so konstante, ki se prilagodijo. T(...) stoji za to, kar se išče: formulo stolpcev v njegovem oklepaju
only-formulas-that-are-right-in-their-units = Samo formule s pravilnimi enotami
beside-it-as-searched-in-a-paper = Ob tem, kot se išče v članku:
paper-s-search-beside-paper = Iskanje iz članka ob tem: { $paper }
its-functions-constants-population-and-proba = Njegove funkcije, konstante, populacija in verjetnosti; poročilo pove, katero iskanje je našlo formulo z manjšo napako

## src/app/panels/identify/facts.rs

constants-with-95-intervals = Konstante s 95-odstotnimi intervali
it-has-none = Nima nobene.
low-to-high = { $low } do { $high }
not-determined-low-to-high = nedoločeno: { $low } do { $high }
not-determined-by-these-rows = teh vrstic ne določajo
units-because = Enote: { $because }
slope-uncertain = naklon negotov
where-it-holds = Kje velja
name-low-to-high-unit-trend = { $name } { $low } do { $high } { $unit }: { $trend }
or = { " " }ali{ " " }
outside-ranges-it-says-nothing = Zunaj { $ranges } ne pove ničesar.
certain-to-be-finite-from-low-to-high-unit = zagotovo končna, od { $low } do { $high } { $unit }
certain-to-be-finite = zagotovo končna
not-certain-to-be-finite-why = ni zagotovo končna: { $why }
not-certain-to-be-finite = ni zagotovo končna
there-it-is-finite = Tam je { $finite }.
with-percent-more-on-each-side-finite = S { $percent } % več na vsaki strani: { $finite }.

## src/app/panels/identify/fit/choose.rs

what-is-fitted = Kaj se prilagaja
fitted-what = Prilagaja se: { $what }
open-a-recording = Odpri posnetek…
text-of-any-layout-matlab-hdf5-tdms-or-parqu-2 = Besedilo kakršne koli oblike, MATLAB, HDF5, TDMS ali Parquet; lahko ga tudi spustite sem
try-with-sample-data = Poskusi z vzorčnimi podatki
simulates-the-recording-that-the-present-sce = Simulira posnetek, ki bi ga dal trenutni scenarij, s šumom po njegovem semenu: kar pride iz prilagajanja, se lahko primerja s tem, kar je šlo vanj
none-yet = Še nobenih.

## src/app/panels/identify/fit/fields.rs

which-channel-is-which = Kateri kanal je kateri
options = Možnosti
choose = izberite
unit-channel = Enota: { $channel }
the-scenario-s-value = v scenariju: { $value }
clear = Počisti

## src/app/panels/identify/fit/found.rs

is-half-a-95-interval-from-what-is-left-if-t = ± je polovica 95-odstotnega intervala, iz preostanka, če je model pravi.
use-in-this-scenario = Uporabi v tem scenariju
sets-these-settings-in-one-step-of-undo-the = Nastavi te nastavitve v enem koraku razveljavitve; rez teče od začetka
save-as-a-file = Shrani kot datoteko
the-file-that-steadycut-identify-id-out-writ = Datoteka, kakršno zapiše steadycut identify { $id } --out, z virom in intervali
it-stands-in-the-scenario-undo-takes-it-back = Stoji v scenariju. Razveljavi to vzame nazaj.
n-settings = Nastavitve: { $n }
this-scenario-does-not-take-it-why = Ta scenarij tega ne sprejme: { $why }

## src/app/panels/identify/fit/mod.rs

fit-of-measured-data = Prilagajanje izmerjenim podatkom
sample-data = Vzorčni podatki
no-sample-data-why = Ni vzorčnih podatkov: { $why }
data-options-or-the-cut-were-changed-since-w = Podatki, možnosti ali rez so se odtlej spremenili: kar je tu, je od prej. Prilagodi vpraša znova.
open-a-file-first = Najprej odprite datoteko.
stop-the-fit = Ustavi prilagajanje
gives-this-fit-up = Opusti to prilagajanje
fit = Prilagodi
fits-the-model-to-the-data-it-goes-on-while = Prilagodi model podatkom; teče tudi, ko so prikazani drugi zasloni
no-measured-data-yet = Še ni izmerjenih podatkov
choose-what-is-to-be-fitted-open-a-recording = Izberite, kaj se prilagaja, odprite posnetek ali ga spustite sem in povejte, kateri kanal je kateri; nato pritisnite Prilagodi. Vrednosti s 95-odstotnimi intervali, preostanek in to, česar podatki ne ločijo, se pokažejo, preden se karkoli prevzame v scenarij ali shrani.
sample-data-sample-on-the-command-line-stead = Vzorčni podatki: { $sample }. V ukazni vrstici: steadycut identify { $id }.

## src/app/panels/identify/fit/plots.rs

the-fit = prilagoditev
measured = izmerjeno
model-2 = model
what-over-over-measured-against-the-model-n = { $what }, { $over }: izmerjeno in model, mest { $n }
measured-over-model = Izmerjeno deljeno z modelom
left-over-measured-less-model = Preostanek: izmerjeno minus model
left-over-2 = preostanek
what-the-fit-of-what-leaves-over-over = preostanek prilagoditve, { $what }, { $over }

## src/app/panels/identify/fit_plots.rs

predicted-over-measured = Napovedano proti izmerjenemu
upright-lines-the-95-band-in-which-the-true = Navpične črte: 95-odstotni pas, v katerem so prave vrednosti, če je oblika formule prava.
left-over-row-by-row = Preostanek po vrsticah
row-row-does-not-fit-target-value-off-off-de = Vrstica { $row } se ne ujema: { $target } = { $value }, odstopa { $off }, { $deviations } lastnih standardnih odklonov.
n-more-rows-do-not-fit =
    { $n ->
        [one] Ne ujema se še { $n } vrstica.
        [two] Ne ujemata se še { $n } vrstici.
        [few] Ne ujemajo se še { $n } vrstice.
       *[other] Ne ujema se še { $n } vrstic.
    }
predicted = napovedano
predicted-over-measured-n-rows-apart-of-them = napovedano proti izmerjenemu: vrstic { $n }, od tega se jih { $apart } ne ujema
row = vrstica
left-over-over-row-n-rows-apart-of-them-do-n = preostanek po vrsticah: vrstic { $n }, od tega se jih { $apart } ne ujema
row-that-does-not-fit = vrstica, ki se ne ujema

## src/app/panels/identify/form.rs

known-part-nothing-is-left-to-be-searched-fo = znani del: za iskanje ne ostane nič; zapišite T(...) s stolpci, ki jih sme brati ostanek (same konstante prilagodi `steadycut identify gp --template`)
the-unit-of-column-is-not-known-write-it-bes = enota za `{ $column }` ni znana: zapišite jo ob ime, `1` za brez, ali pa dovolite formule s poljubnimi enotami
unit-of-column-problem = enota za `{ $column }`: { $problem }
open-a-table-or-choose-one-of-the-papers = odprite tabelo ali izberite eno iz člankov
choose-the-column-that-the-formula-is-to-giv = izberite stolpec, ki naj ga da formula
choose-at-least-one-column-that-the-formula = izberite vsaj en stolpec, ki ga sme formula brati
known-part-problem = znani del: { $problem }
collinear-leave-one-of-them-out = { $collinear }; enega od njiju izpustite
data = podatki
inputs = vhodi
units-2 = enote
known-part = znani del
seed-2 = seme
batches = serije
paper-2 = članek
not-opened-because = ni odprto: { $because }
nothing-was-checked = preverjeno ni bilo nič

## src/app/panels/identify/formula.rs

formula-of-size-size-the-one-chosen = Formula velikosti { $size }, izbrana
formula-of-size-size = Formula velikosti { $size }
formula-of-size-size-so-far = Formula velikosti { $size }, za zdaj
with-all-digits-formula = Z vsemi števkami: { $formula }
unsure-doubt = Negotovo: { $doubt }.
exact-but-for-rounding = Točno do zaokrožitve.

## src/app/panels/identify/front.rs

front-the-formula-of-the-least-error-of-each = Fronta: formula z najmanjšo napako pri vsaki velikosti
no-formula-has-a-finite-value-on-all-rows-ye = Nobena formula še nima končne vrednosti v vseh vrsticah.
size-2 = velikost
error = napaka
left-out = izpuščeno
chosen-exact = izbrana, točna
chosen = izbrana
exact = točna
unsure = negotova
errors-are-root-mean-squares-of-what-is-left = Napake so efektivne vrednosti preostanka. Na izpuščenih vrsticah se izračunajo, ko je iskanje končano.
left-out-rows-unsure-more-than-twice-the-lea = Izpuščeno: { $rows }. Negotovo: več kot dvakratna najmanjša napaka tam ali ni zagotovo končna.
searched-on-searched-of-n-rows-drawn-by-the = Iskano na { $searched } od { $n } vrstic, izžrebanih s semenom; konstante so prilagojene vsem.
no-formula = ni formule
the-smaller-error-is-that-of-the-paper-searc = Manjšo napako ima iskanje iz članka.
the-smaller-error-is-that-of-the-default-sea = Manjšo napako ima privzeto iskanje.
stop-at-stop-reached = ustavitev pri { $stop } dosežena
stop-at-stop-not-reached = ustavitev pri { $stop } ni dosežena
as-the-paper-of-paper-searched-formula-size = Kot je iskal članek { $paper }: { $formula }, velikost { $size }, R2 { $fitness }, generacij { $n }, { $reached }.
digest-digest-the-same-on-the-command-line = Digest { $digest }: enak v ukazni vrstici.

## src/app/panels/identify/front_plot.rs

size-nodes = velikost [vozlišča]
at-rows-left-out = na izpuščenih vrsticah
looked-at = ogledana
front-error-against-size-n-formulas = Fronta: napaka glede na velikost, formul { $n }
front-error-in-unit-against-size-n-formulas = Fronta: napaka v { $unit } glede na velikost, formul { $n }

## src/app/panels/identify/mod.rs

fit-settings = Prilagajanje nastavitev
search-formulas = Iskanje formul
looks-in-a-table-for-a-formula-of-one-column = V tabeli išče formulo za en stolpec, z genetskim programiranjem
fits-drive-forces-structure-noise-wear-or-ma = Posnetku prilagodi pogon, sile, strukturo, šum, obrabo ali material
identify = Formule
no-formula-was-searched-for-yet = Formula še ni bila iskana
choose-a-table-a-csv-can-be-dropped-here-the = Izberite tabelo (CSV lahko spustite sem), stolpec, ki naj ga da formula, in stolpce, ki jih sme brati; nato pritisnite Iskanje.
the-front-grows-while-the-search-works-for-e = Fronta raste, ko iskanje dela: za vsako velikost formula z najmanjšo napako. Vsako od njih si lahko ogledate, shranite in vstavite v tekoči rez.
without-a-table-of-one-s-own-go-the-whole-wa = Brez lastne tabele: Prehodi vso pot načrtuje in izmeri reze na simulatorju, ki jih je nato prav tako mogoče preiskati.

## src/app/panels/identify/preview.rs

no-numbers = ni števil
unit-not-told = enota ni podana

## src/app/panels/identify/search.rs

not-certain-to-be-finite-on-the-ranges-of-th = ni zagotovo končna na območjih vrstic
at-rows-left-out-more-than-twice-the-least-e = na izpuščenih vrsticah več kot dvakratna najmanjša napaka fronte
identify-target = Identifikacija: { $target }
the-front-has-this-formula-no-more = fronta te formule nima več

## src/app/panels/identify/symbols.rs

simulation = Simulacija
ra = Ra
desired-ra = Želeni Ra
ra-produced = Nastali Ra
force-start = Sila, začetek
force-end = Sila, konec
feed-start = Podajanje, začetek
feed-end = Podajanje, konec
speed-2 = Vrtljaji
speed-start = Vrt. hitrost, začetek
speed-end = Vrt. hitrost, konec
axial-depth = Aksialna globina
radial-depth = Radialna globina

## src/app/panels/identify/transport.rs

searches-for-formulas-it-goes-on-while-other = Išče formule; teče tudi ob drugih zaslonih
stands-still-what-was-found-stays = Miruje; kar je najdeno, ostane
pause-the-search = Ustavi iskanje
goes-on-where-it-was-paused = Nadaljuje tam, kjer je bilo ustavljeno
go-on-with-the-search = Nadaljuj iskanje
ends-the-search-with-its-last-whole-batch-wh = Konča iskanje z zadnjo celo serijo; kar je najdeno, se še oceni na izpuščenih vrsticah
end-here = Končaj tu
searches-for-what-is-set-now-and-gives-this = Išče, kar je nastavljeno zdaj, in to iskanje opusti
begin-anew = Začni znova
writes-a-file-to-go-on-with-later-here-or-wi = Zapiše datoteko za poznejše nadaljevanje, tu ali z --resume
save-the-search = Shrani iskanje
changed-since-this-search-was-begun-changed = Spremenjeno po začetku iskanja: { $changed }. Ostalo je, kot se je začelo; `Začni znova` išče, kar je nastavljeno zdaj.
sets-table-columns-and-numbers-to-those-of-t = Nastavi tabelo, stolpce in števila kot v tem iskanju
set-back = Nastavi nazaj
resume = Nadaljuj…
goes-on-with-a-saved-search-of-the-same-tabl = Nadaljuje shranjeno iskanje z isto tabelo, stolpci, enotami in semenom; datoteko lahko tudi spustite sem
batch-batch-of-at-most-most = serija { $batch } od največ { $most }
the-paper-s-own-search = iskanje iz samega članka
judging-the-front-at-rows-left-out = ocena fronte na izpuščenih vrsticah
done-after-n-batches =
    { $n ->
        [one] končano po { $n } seriji
        [two] končano po { $n } serijah
        [few] končano po { $n } serijah
       *[other] končano po { $n } serijah
    }
n-formulas =
    { $n ->
        [one] { $n } formula
        [two] { $n } formuli
        [few] { $n } formule
       *[other] { $n } formul
    }
at-most-left-left = še največ { $left }
paused = ustavljeno

## src/app/panels/identify/tree.rs

as-a-tree = Kot drevo
tree-of-the-formula-n-parts = Drevo formule, delov: { $n }

## src/app/panels/identify/way.rs

identify-the-whole-way = Identifikacija: vsa pot
the-open-scenario-s-cutter-is-none-of-the-sh = frezalo odprtega scenarija ni med priloženimi: pot gre z enim od teh
from-cuts-to-a-controller = Od rezov do regulatorja
with-the-open-scenario-s-cutter-and-material = S frezalom in materialom odprtega scenarija: { $n } rezov, načrtovanih in izmerjenih na simulatorju, iz njih identificirani modeli 1 do 5, vrstice preglednice 3 na teh modelih.
go-the-whole-way = Prehodi vso pot
pause-the-way = Ustavi pot
go-on-with-the-way = Nadaljuj pot
give-the-way-up = Opusti pot
percent-of-the-way-about-left-left = { $percent } % poti, še približno { $left }
percent-of-the-way = { $percent } % poti
percent-of-the-way-paused = { $percent } % poti, ustavljeno
its-cuts-as-the-table = Rezi kot tabela
cuts-of-the-way = rezi poti
ra-0-81-m-with-tracking-on-the-models-found = Ra 0,81 µm s Sledenjem na najdenih modelih
cut-with-its-models = Reži z njenimi modeli
the-scenario-of-the-way = Scenarij poti
the-whole-way-tool-in-material = Vsa pot: { $tool } v { $material }
truth-truth = Resnica: { $truth }.
measured-of-n-cuts-measured-axial-mm-deep-an = Izmerjenih rezov: { $measured } od { $n }, globokih { $axial } mm in širokih { $radial } mm.
cut-run-problem = Rez { $run }: { $problem }.
name-low-to-high-2 = { $name } { $low } do { $high }
error-error-n-cuts-ranges = napaka { $error }, rezov { $n }, { $ranges }
ra-against-its-target-n-rows-of-table-3 = Ra proti cilju, vrstic preglednice 3: { $n }
digest-digest-that-of-steadycut-experiment-w = Digest { $digest }: tak kot pri `steadycut experiment way`.
n-rows-outside-the-ranges-of-the-models = vrstic zunaj območij modelov: { $n }
off-by-worst-at-most-rms-rms = odstopa največ { $worst } %, efektivno { $rms } %
n-rows-without-a-ra = vrstic brez Ra: { $n }
controller-on-models = { $controller } na { $models }

## src/app/panels/learn/answer.rs

from-the-start-by-hand-again = Od začetka, spet ročno
from-the-start-with-what-is-set-now = Od začetka, s tem, kar je nastavljeno zdaj
cut-from-the-start = Reži od začetka
marks-the-whole-cut-as-it-is-set-now-and-you = Oceni ves rez, kot je nastavljen zdaj, in vaše napovedi
check-my-answer = Preveri odgovor
the-cut-still-runs-percent-the-check-runs-it = Rez še teče ({ $percent } %): preverjanje ga najprej izvede do konca.
the-cut-is-over-the-check-marks-all-of-it = Rez je končan: preveri se ves.
the-cut-is-being-marked = Rez se ocenjuje
this-was-the-last-mission-leave-leads-to-the = To je bila zadnja naloga. »Zapusti« vodi na seznam vseh.
next-mission-title = Naslednja naloga: { $title }
your-name = Vaše ime
if-you-like = če želite
a-file-with-your-answer-and-what-it-came-to = Datoteka z vašim odgovorom in njegovim izidom; preveri jo steadycut mission check
save-result = Shrani rezultat

## src/app/panels/learn/catalogue.rs

missions = Naloge
each-takes-some-minutes-say-what-will-happen = Vsaka traja nekaj minut: napovejte, kaj se bo zgodilo, obdelajte in poglejte, ali ste imeli prav. Kar storite, preveri isti program, ki reže.
begin = Začni
begin-mission = Začni: { $mission }
a-mission-of-your-own-is-a-text-file-steadyc = Lastna naloga je besedilna datoteka: steadycut mission new zapiše eno za začetek. Spustite jo sem.
not-passed-yet = še ni opravljena
won-of-most-stars = { $won } od { $most } zvezdic
a-link-to-this-mission-with-its-qr-code = Povezava do te naloge z njeno kodo QR
link-mission = Povezava: { $mission }
stars-are-kept-until-the-program-ends-the-pl = Zvezdice se ohranijo, dokler se program ne zapre: trajno shranjevanje tu ni dovoljeno.
forget-my-stars = Pozabi moje zvezdice…
all-stars-of-every-mission = Vse zvezdice, vseh nalog?
forget-them = Pozabi jih
keep-them = Obdrži jih

## src/app/panels/learn/lesson.rs

marking-of-the-mission = Ocenjevanje naloge

## src/app/panels/learn/mod.rs

learn = Vadnica
predict-first = Najprej napovejte
the-cut-begins-and-is-shown-as-soon-as-you-h = Rez se začne in prikaže, ko poveste, kaj pričakujete, ali nadaljujete brez napovedi.

## src/app/panels/learn/pen.rs

sketch-right-and-left-draw-up-and-down-lift = Skica: levo in desno rišeta, gor in dol dvigneta in spustita pero

## src/app/panels/learn/questions.rs

the-right-answer-is-needed-to-pass = Za uspeh je potreben pravi odgovor.
your-prediction = Vaša napoved
prediction = Napoved

## src/app/panels/learn/sketch.rs

signal-up-to-top-unit = { $signal } do { $top } { $unit }
value-at-time = { $value } pri { $time }
draw-here = Rišite tukaj

## src/app/panels/learn/tasks.rs

back-to-all-missions-the-cut-stays-as-it-is = Nazaj na vse naloge; rez ostane, kot je, in vse na njem je spet mogoče spreminjati
story = Zgodba
goal = Cilj:
step-step-of-count-title = Korak { $step } od { $count }: { $title }
back = Nazaj
next = Naprej
that-is-my-prediction = To je moja napoved
go-on-without-a-prediction = Naprej brez napovedi
that-is-my-answer = To je moj odgovor
go-on-without-an-answer = Naprej brez odgovora
without-an-answer-there-is-no-third-star-any = Brez odgovora ni tretje zvezdice: vsaka domneva nauči več kot nobena.
go-on-all-the-same = Vseeno naprej
your-prediction-stays-as-it-is-the-cut-has-b = Vaša napoved ostane, kakršna je: rez je že bil prikazan.
it-was-left-without-a-prediction-the-cut-has = Ostalo je brez napovedi: rez je že bil prikazan.
you-have-seen-this-cut-before-another-answer = Ta rez ste že videli: drugačen odgovor kot prvič šteje za opravljeno nalogo, ne pa za tretjo zvezdico.
answered-after-the-cut-or-a-check-has-shown = Odgovorjeno, ko sta to že pokazala rez ali preverjanje: šteje za opravljeno nalogo, ne pa za tretjo zvezdico.
what-you-may-change = Kaj smete spremeniti
nothing-this-mission-asks-only-for-answers = Nič: ta naloga zahteva samo odgovore.
given-2 = Podano
hint-number = Namig { $number }:
hint-number-of-count = Namig { $number } od { $count }

## src/app/panels/learn/verdict.rs

tries-begun-begun-checked-checked = Poskusi: začeto { $begun }, preverjeno { $checked }
digest-of-the-cut-digest = Digest reza: { $digest }
puts-the-result-away-a-check-brings-the-next = Odstrani izid; naslednjega prinese preverjanje
close-the-result = Zapri izid
passed-won-of-most-stars = Opravljeno: { $won } od { $most } zvezdic
not-passed-yet-2 = Še ni opravljeno
this-is-of-before-your-last-change-check-aga = To velja za stanje pred zadnjo spremembo: preverite znova.
off-the-curve-by-percent-of-its-height = od krivulje odstopa za { $percent } njene višine
within-tolerance-of-the-true-value = znotraj { $tolerance } od prave vrednosti
too-low-allowed-is-tolerance-to-either-side = premajhno; dovoljeno je { $tolerance } na vsako stran
too-high-allowed-is-tolerance-to-either-side = preveliko; dovoljeno je { $tolerance } na vsako stran
words-the-true-value-is-truth = { $words }; prava vrednost je { $truth }
no-answer-was-given-in-step-step-that-costs = V koraku { $step } ni bilo odgovora: to stane tretjo zvezdico
no-prediction-was-made-in-step-step-that-cos = V koraku { $step } ni bilo napovedi: to stane tretjo zvezdico
your-answer-in-step-step-is-right-it-came-wh = Vaš odgovor v koraku { $step } je pravilen; podan je bil, ko je bil rez že viden
your-answer-in-step-step-is-wrong = Vaš odgovor v koraku { $step } je napačen
your-prediction-in-step-step-was-right = Vaša napoved v koraku { $step } je bila pravilna
your-prediction-in-step-step-was-wrong = Vaša napoved v koraku { $step } je bila napačna
your-prediction-in-step-step-was-right-off-2 = Vaša napoved v koraku { $step } je bila pravilna ({ $off })
your-prediction-in-step-step-was-wrong-off-2 = Vaša napoved v koraku { $step } je bila napačna ({ $off })
for-all-three-stars = Za vse tri zvezdice:
reached-condition = doseženo: { $condition }
missed-condition = zgrešeno: { $condition }
predictions-that-are-right-made-before-the-c = pravilne napovedi pred rezom

## src/app/panels/learning/actions.rs

the-cut-begins-with-networks = Rez se začne z mrežami
learned-before = prej naučene
begin-the-same-cut-with-what-has-been-learne = Začne isti rez s tem, kar je bilo naučeno na njegovem koncu
cut-again-with-what-was-learned = Reži znova z naučenim
save-nm-r-nm-1-and-nm-2-as-they-are-at-the-e = Shrani NM-R, NM-1 in NM-2, kot so na koncu reza
save-networks = Shrani mreže
begin-with-the-networks-of-a-file-one-can-al = Začne z mrežami iz datoteke; lahko jo tudi spustite sem
load-networks = Naloži mreže

## src/app/panels/learning/curves.rs

feedback-s-share-of-the-override = Delež povratne zveze v korekciji [%]
error-of-nm-1-s-prediction = Napaka napovedi NM-1 [%]
internal-loop-now-iterations-now-mean-on-ave = Notranja zanka: iteracij zdaj { $now }, doslej povprečno { $mean }
means-of-the-size-over-about-a-second-in-con = Povprečja velikosti prek približno sekunde v stiku. Delež povratne zveze je vse, kar zanki dodata k NM-2, kjer je korekcija med svojimi mejami.
mean-of-its-size-over-about-a-second-in-cont = Povprečje velikosti prek približno sekunde v stiku, kjer je korekcija med svojimi mejami.
playhead = časovni kazalec

## src/app/panels/learning/mod.rs

no-networks-at-the-playhead-yet = Pri časovnem kazalcu še ni mrež.
positive = pozitivno
negative = negativno
f-is-the-measured-force-f1-and-f2-what-it-wa = F je izmerjena sila, F1 in F2 njeni vrednosti pred eno in dvema regulacijskima periodama; a je korekcija, ki jo je podajalni pogon dosegel, u tista, ki se zahteva.
a-dot-in-a-neuron-is-its-bias-beside-the-wei = Pika v nevronu je njegov prag. Ob utežeh obroč označuje nevrone, ki so se najbolj spremenili.
nm-2-is-the-inverse-model-it-asks-for-the-ov = NM-2 je inverzni model: korekcijo zahteva sam. Začne nenaučen in zahteva 100 %, zato sprva vse delo opravi povratna zveza, tako kot delilni regulator.
what-the-feedback-adds-is-what-nm-2-has-not = Povratna zveza doda tisto, česar NM-2 ni vedel: iz tega se uči, vzorec za vzorcem (učenje iz pogreška povratne zveze). Med učenjem delež povratne zveze pada.
nm-1-has-no-part-in-the-cold-start-and-does = NM-1 v hladnem zagonu ne sodeluje in se ne uči.
nm-2-is-the-inverse-model-it-asks-for-the-ov-2 = NM-2 je inverzni model: zahteva korekcijo, ki da želeno silo. NM-1 je neposredni model: napove silo korekcije, notranja zanka pa z njim korekcijo popravi, preden se pošlje.
both-were-trained-before-and-go-on-learning = Oba sta bila naučena prej in se med rezom učita naprej: NM-1 iz tega, kakšna je bila sila, NM-2 iz tega, kar sta mu dodali zanki.

## src/app/panels/learning/net.rs

weights = Uteži
change-since-the-start = Sprememba od začetka
links-as-thick-as-their-weights-rings-mark-w = Povezave, debele kot njihove uteži; obroči označujejo, kar se je najbolj spremenilo
links-as-thick-as-what-the-weights-have-chan = Povezave, debele kot sprememba uteži v tem rezu
predicts-the-force = napove silo
change-of-ln-f = sprememba ln F
has-no-part-in-the-cold-start = v hladnem zagonu ne sodeluje
asks-for-the-override = zahteva korekcijo
n-lessons-largest-weight-weight-largest-chan = lekcij: { $n }; največja utež { $weight }, največja sprememba { $change }

## src/app/panels/learning/passes.rs

passes-of-unks = Prehodi UNKS
the-same-part-again-and-again = Isti obdelovanec znova in znova
n-passes-without-the-changes-of-this-session =
    { $n ->
        [one] { $n } prehod
        [two] { $n } prehoda
        [few] { $n } prehodi
       *[other] { $n } prehodov
    } brez sprememb te seje, isti obdelovanec, šum in seme; naučeno se prenaša naprej.
stop-the-passes = Ustavi prehode
cut-n-passes =
    { $n ->
        [one] Reži { $n } prehod
        [two] Reži { $n } prehoda
        [few] Reži { $n } prehode
       *[other] Reži { $n } prehodov
    }
done-of-n-passes = prehodov: { $done } od { $n }
no-further-pass-because = Ni nadaljnjega prehoda: { $because }
made-with-other-settings-than-those-of-now = Narejeno z drugimi nastavitvami od sedanjih.
begin-the-cut-with-the-networks-as-they-are = Začne rez z mrežami, kakršne so po zadnjem prehodu
use-these-networks = Uporabi te mreže
pass = prehod
number-of-the-pass = Številka prehoda
normalised-standard-error-over-all-samples-i = Normirana standardna napaka prek vseh vzorcev v stiku
time-2 = čas
time-of-the-cut-s = Čas reza, s
largest-force = Največja sila
feedback = povratna zveza
mean-size-of-the-feedback-s-share-of-the-ove = Srednja velikost deleža povratne zveze v korekciji, %
by-quarter-of-the-part-quarters = Po četrtinah obdelovanca: { $quarters } %
nothing-is-learned-every-pass-is-the-same = Nič se ne nauči: vsak prehod je enak.
the-feedback-s-share-falls-pass-by-pass = Delež povratne zveze pada od prehoda do prehoda.
the-feedback-s-share-does-not-fall-pass-by-p = Delež povratne zveze ne pada od prehoda do prehoda.
error-of-the-last-pass-against-the-first-cha = Napaka zadnjega prehoda glede na prvega: { $change } (od hladnega zagona na vsem obdelovancu: -{ $wanted } %).
error-of-the-last-pass-against-the-first-cha-2 = Napaka zadnjega prehoda glede na prvega: { $change }.

## src/app/panels/machine/controls.rs

machine-and-chip = Stroj in odrezek
wear = Obraba
sound-noise-and-prediction = Zvok, šum in napoved
the-programmed-feed-speed-and-depth-of-cut-a = Programirano podajanje, vrtljaji in globina reza so s pulta.

## src/app/panels/machine/life.rs

trends-over-the-tool-life = Trendi skozi obstojnost
life-of-one-tool = Obstojnost enega orodja

## src/app/panels/machine/mod.rs

stability = Stabilnost
vibration = Vibracije
the-masses-moving-the-frequency-response-and = Gibanje mas, frekvenčni odziv in nihajne oblike
wear-and-sound = Obraba in zvok
wear-sound-and-roughness-over-the-tool-s-lif = Obraba, zvok in hrapavost skozi obstojnost orodja ter njena napoved
the-depth-at-which-the-cut-chatters-over-the = Globina, pri kateri rez drdra, po vrtilni hitrosti
chatter-stability-lobes-sound-vibration-wear = drdranje stabilnost režnji zvok vibracije obraba obstojnost nihajne oblike frekvenčni odziv mejna globina chatter
settings-of-the-machine = Nastavitve stroja

## src/app/panels/machine/picture.rs

five-masses-at-at-parts-scale = Pet mas pri { $at }: { $parts }. { $scale }
shape-of-a-mode-its-size-means-nothing = Nihajna oblika: njena velikost ne pomeni ničesar
movement-drawn-times = Gibanje narisano ×{ $times }

## src/app/panels/machine/plot.rs

title-from-from-to-to = { $title } od { $from } do { $to }

## src/app/panels/machine/response.rs

g-rel-tooth-to-work = |G_rel| zob proti obdelovancu
h33-tooth = |H33| zob
hww-work = |Hww| obdelovanec
the-frequency-response = frekvenčni odziv
frequency-response-unit = Frekvenčni odziv [{ $unit }]
modes = nihajne oblike
passing-teeth = prehodi zob
cursor-frequency = Frekvenca kazalca
the-cursor-drag-it-here-or-in-the-plot-or-us = Kazalec: povlecite ga tu ali v grafu ali uporabite smerne tipke
to-3000-hz = do 3000 Hz
to-600-hz = do 600 Hz
phase = Faza
at-at-said = Pri { $at }: { $said }
response = Odziv
mode-number-at = oblika { $number }, { $at }
cursor = kazalec

## src/app/panels/machine/sound.rs

the-sound-of-the-cut-as-the-model-gives-it-p = Zvok reza, kot ga da model: prehodi zob in naključna sila pri tej vrtilni hitrosti, z obrabo glasneje. Sliši se, ko rez teče.
sound-of-the-cut = Zvok reza
sound-on = Vključi zvok
sound-off = Izključi zvok
volume = Glasnost
no-sound-problem = Ni zvoka: { $problem }.
silent-while-the-cut-is-paused = tiho, dokler je rez ustavljen

## src/app/panels/machine/stability.rs

limit-depth-at-this-speed = Mejna globina pri tej hitrosti
quiet-at-speed-up-to-limit-limit-depth-at-an = Mirno pri { $speed } do { $limit } (mejna globina), pri vsaki vrtilni hitrosti do { $any }.
quiet-at-speed-up-to-highest-at-least-no-lim = Mirno pri { $speed } vsaj do { $highest }: mejna globina ni bila najdena; pri vsaki vrtilni hitrosti do { $any }.
stability-chart = Karta stabilnosti
no-chart-can-be-made-of-this-machine = Za ta stroj ni mogoče izdelati karte
charted-cut = Na karti: { $cut }.
go-on-with-the-chart = Nadaljuj karto
structure = Struktura
n-measured-modes-at-the-tool-s-tip = { $n } izmerjenih nihajnih oblik na konici orodja
takes-the-measured-modes-away-the-five-masse = Odstrani izmerjene nihajne oblike: spet velja pet mas iz leta 2019
back-to-the-five-masses = Nazaj k petim masam
spindle-quality = Dobrota vretena
q-5-by-its-damper = Q 5, po njegovi dušilki
the-printed-damper-of-2348-n-s-m-belongs-to = K njemu spada natisnjena dušilka 2348 N s/m
q-17-as-printed = Q 17, kot natisnjeno
the-quality-printed-in-the-table-a-third-of = Dobrota, natisnjena v preglednici: tretjina dušenja
the-cuts-of-this-run-are-being-judged = Rezi te simulacije se ocenjujejo
chatter-at-speed-and-depth-deep-from-from-to = Drdranje pri { $speed } in globini { $depth }, od { $from } do { $to } poti: motnja zraste ×{ $grown } na zob
stable-at-speed-and-depth-deep-from-from-to = Stabilno pri { $speed } in globini { $depth }, od { $from } do { $to } poti, rez te simulacije, najbližji drdranju: motnja se skrči na ×{ $grown } na zob
stable-at-every-speed-up-to-any-by-the-lobes = Po režnjih stabilno pri vsaki vrtilni hitrosti do { $any }.
nothing-can-chatter-the-chip-does-not-feel-t = Nič ne more drdrati: odrezek ne čuti vibracij.
depth-deep-it-is-quietest-near-speed-where-t = Pri globini { $depth } je najmirneje okoli { $speed }, kjer je mejna globina { $limit }.
depth-deep-it-is-quietest-near-speed-where-n = Pri globini { $depth } je najmirneje okoli { $speed }, kjer mejne globine ni bilo.
depth-deep-it-is-quiet-at-no-speed-of-the-ch = Pri globini { $depth } ni mirno pri nobeni vrtilni hitrosti diagrama.
at-the-playhead-no-cut = Pri časovnem kazalcu: ni reza.
at-the-playhead-speed-and-depth-deep-chatter = Pri časovnem kazalcu, { $speed } in globina { $depth }: drdranje, ×{ $grown }.
at-the-playhead-speed-and-depth-deep-no-chat = Pri časovnem kazalcu, { $speed } in globina { $depth }: brez drdranja, ×{ $grown }.
limit-depth = Mejna globina
limit-depth-mm-over-the-speed-1-min-quiet-be = Mejna globina [mm] po vrtilni hitrosti [1/min]: pod črto je mirno
lobes = režnji
interrupted-cut = prekinjani rez
stable-at-every-speed = stabilno pri vsaki hitrosti
furthest-into-chatter-in-the-run = najgloblje v drdranju v poteku
nearest-to-chatter-in-the-run = v simulaciji najbliže drdranju
the-cut-now = trenutni rez

## src/app/panels/machine/vibration.rs

stop-the-masses = Ustavi mase
move-the-masses = Poženi mase
the-contact-force-at-the-frequency-of-the-cu = Kontaktna sila pri frekvenci kazalca
at-the-cursor = Pri kazalcu
passing-teeth-2 = Prehodi zob
the-contact-force-at-harmonic-times-the-toot = Kontaktna sila pri { $harmonic }-kratniku trenutne frekvence zob
passing-teeth-harmonic = Prehodi zob ×{ $harmonic }
mode-number-at-shown-at-slow-hz = Oblika { $number }: { $at }, prikazano pri { $slow } Hz
force-at-at-shown-at-slow-hz = { $force } pri { $at }, prikazano pri { $slow } Hz
modes-2 = Nihajne oblike
the-eigenvalues-of-this-machine-do-not-conve = Lastne vrednosti tega stroja ne konvergirajo.
mode = oblika
damping = dušenje
moves-most = najbolj niha
mode-number = Oblika { $number }
let-it-swing = Zanihaj

## src/app/panels/machine/wear.rs

tool-life-used = Izraba obstojnosti
share-of-the-tool-s-life = Delež obstojnosti orodja
fraction-t-of-the-tool-s-life-that-is-drawn = Delež τ/T obstojnosti orodja, ki se riše in sliši
the-tool-of-the-running-cut-which-wears-in-i = Orodje tekočega reza, ki se v njem obrablja
as-in-the-cut = Kot v rezu
go-on = Nadaljuj
wear-land-land-force-force-sound-sound-ra-ra = širina obrabe { $land }, sila { $force }, zvok { $sound }, Ra { $ra }
wear-land-vb = Širina obrabe VB
over-the-fraction-of-life = po deležu obstojnosti
the-tool-of-the-running-cut-by-the-sound-of = Orodje tekočega reza, po zvoku vibrirajočega stroja
in-the-cut = V rezu
remaining-left-at-the-programmed-cut-worn-ou = še { $remaining } pri programiranem rezu, obrabljeno po svojem zvoku
remaining-left-at-the-programmed-cut = še { $remaining } pri programiranem rezu
no-estimate-yet = ocene še ni
estimated-once-the-cut-is-simulated = oceni se, ko je rez simuliran
every-ten-minutes-the-cutting-speed-is-set-s = Vsakih deset minut se rezalna hitrost nastavi tako, da orodje doseže želeno obstojnost, kolikor jo pokaže njegov zvok
adjust-the-speed = Prilagajaj hitrost
worn-out-after-time-at-last-speed = obrabljeno po { $time }, nazadnje { $speed }
not-worn-out-in-ten-times-the-desired-tool-l = v desetkratni želeni obstojnosti ni obrabljeno, nazadnje { $speed }
cutting-minute-minute-at-last-speed = rezanje: minuta { $minute }, nazadnje { $speed }
sound-spectrum = Spekter zvoka
sharp-tool = ostro orodje
worn-out = obrabljeno
trends-over-the-life-each-from-0-to-1 = Trendi skozi obstojnost, vsak od 0 do 1
sound-e-s = zvok E_S
roughness-ra = hrapavost Ra
predicted-life = Napovedana obstojnost
t-90-of-the-belief = 90 % pričakovanja
from-the-sound = iz zvoka
desired = želena
true = resnična
the-equations-are-being-solved-for-every-sec = Enačbe se rešujejo za vsako sekundo.
here-found-r-r-largest-difference-difference = Tu: najdeno R = { $r }, največja razlika { $difference }.
here-with-the-noise-of-the-settings-r-r = Tu: s šumom iz nastavitev R = { $r }.
the-paper-claim = Članek: { $claim }.

## src/app/panels/papers/calibrations.rs

met-of-all-worst = { $met } od { $all }, { $worst }
sim = Sim
met-of-all = { $met } od { $all }
the-calibrations-side-by-side = Umeritve druga ob drugi
in-each-cell-final-values-of-the-row-within = V vsaki celici: končne vrednosti vrstice v svojih pasovih in največji preostanek v pasovih. Proces in regulator imata isto umeritev, sila procesa je sila formule.
progress-done = Opravljeno ({ $progress }).

## src/app/panels/papers/claim.rs

model = Model
claimed = trditev
median = mediana
the-claim-about-forces-4-against-6 = Trditev o silah: 4 % proti 6 %
the-paper-claim-errors-of-the-force-here-ove = Članek: { $claim }. Napake sile tu prek istih svežih vrstic ({ $n }).

## src/app/panels/papers/deviations.rs

ra-printed = Ra natisnjen
ra-run = Ra simuliran
force-printed = sila natisnjena
printed-read-corrected =
    { $printed }
    (popravljeno { $read })
force-run = sila simulirana
the-findings-speak-of-at-most-4-1-in-ra-and = Ugotovitve govorijo o največ 4,1 % pri Ra in 5,2 % pri sili. Sama preglednica 3, končna vrednost proti želeni, pove več: { $extremes }. Proporcionalna povratna zveza pusti trajni pogrešek. Z identificiranimi modeli simulacije pustijo enakega.
section-4-makes-the-difference-between-desir = Razdelek 4 za merilo vzame razliko med želenim in simuliranim Ra in ugotovi, da je model »učinkovit pri doseganju želene hrapavosti površine«, brez številke. Številko da sama preglednica 1: { $extremes }. Proporcionalna povratna zveza pusti trajni pogrešek. Z identificiranimi modeli simulacije pustijo takega: pri finih rezih prehrapavo, pri grobih pregladko.
ra-is-off-by-high-in-simulation-first-to-low = Ra odstopa od { $high } v simulaciji { $first } do { $low } v simulaciji { $second }
the-paper-s-own-deviations = Odstopanja samega članka

## src/app/panels/papers/machine.rs

springs-k-m-2-f-dampers-c-k-m-q-printed-then = Vzmeti k = m (2 π f)², dušilke c = √(k m) / Q: natisnjeno, nato po pravilu.
node = Vozlišče
verdict = Ocena
printed-rule-rule = { $printed }, pravilo { $rule }
open-machine = Odpri Stroj
what-the-equations-give = Kaj dajo enačbe
reproduced = Ponovljeno
not-reproduced-and-why = Ni ponovljeno in zakaj

## src/app/panels/papers/table.rs

start-feed = Začetno podajanje
start-speed = Začetni vrtljaji
final-force = Končna sila
final-feed = Končno podajanje
final-speed = Končni vrtljaji
produced-ra = Nastali Ra
opens-the-scenario-name-in-the-console = Odpre scenarij { $name } v pultu
given = podano
residual-met = { $residual } doseženo
residual-missed = { $residual } zgrešeno
printed-compared-with-read = { $printed } (primerjano z { $read })
at-the-end-of-simulation-number-states = Na koncu simulacije { $number }: { $states }.
simulation-number-note = Simulacija { $number }: { $note }.
force-without-a-verdict-the-paper-does-not-s = { $force }: brez ocene, članek ne pove, kako jo dobi.
in-each-cell-printed-then-run-below-residual = V vsaki celici: natisnjeno, nato simulirano; spodaj: preostanek in ocena.
run = simulirano
residual = preostanek
simulation-number = Simulacija { $number }

## src/app/panels/papers.rs

papers = Članki
tables-errata-reproduction-published-calibra = preglednice tiskovne napake ponovitev objavljeno umeritve papers errata
calibration-of-plant-and-controller = Umeritev procesa in regulatorja:
plant-s-force-from = Sila procesa iz:
papers-paper = Članki: { $paper }
calibrations-paper = Umeritve: { $paper }
claim-about-forces = Trditev o silah
combined-system-2005-table-1 = Kombinirani sistem 2005, preglednica 1
dynamic-model-2019-table-1 = Dinamični model 2019, preglednica 1
paper = Članek:
table-1-compares-six-ways-of-control-on-expe = Preglednica 1 primerja šest načinov vodenja na preizkusu 2. Njene številke stojijo ob simulacijah s številnimi semeni, skupaj s tem, kar je bilo izbrano glede nanje, na zaslonu Primerjava.
open-compare = Odpri Primerjavo
load-experiment-1 = Naloži preizkus 1
load-the-five-steps = Naloži pet korakov
on-the-command-line-steadycut-papers-paper-2 = V ukazni vrstici: steadycut papers --paper 2005, z --robustness in --beyond.
go-on-with-the-table = Nadaljuj preglednico
final-values-as-they-are-the-table-s-forces = Končne vrednosti, kot so: sile preglednice so iz formule, drug model sile procesa po naravi da druge
no-simulation-is-done-yet = Nobena simulacija še ni opravljena
each-row-is-run-in-time-from-its-printed-sta = Vsaka vrstica teče v času iz natisnjenih začetnih vrednosti, brez šuma, SDNRP; končne vrednosti so povprečja zadnje od 15 s.
met-force-within-force-feed-feed-speed-speed = Doseženo: sila v { $force } %, podajanje v { $feed } %, vrtilna hitrost v { $speed } %, Ra v { $ra }.
errata = Tiskovne napake
here-resolution = Tu: { $resolution }
met-of-n-final-values-met = doseženih končnih vrednosti: { $met } od { $n }
met-of-n-final-values-met-so-far = doslej doseženih končnih vrednosti: { $met } od { $n }
met-of-n-final-values-met-by-models-fitted-t = doseženih končnih vrednosti: { $met } od { $n }, z modeli, prilagojenimi prav tem vrsticam
met-of-n-final-values-met-so-far-by-models-f = doslej doseženih končnih vrednosti: { $met } od { $n }, z modeli, prilagojenimi prav tem vrsticam
met-of-n-final-values-met-by-formulas-of-one = doseženih končnih vrednosti: { $met } od { $n }, z lastnimi formulami
met-of-n-final-values-met-so-far-by-formulas = doslej doseženih končnih vrednosti: { $met } od { $n }, z lastnimi formulami

## src/app/panels/plan/answer.rs

the-search-was-stopped-move-the-swarm-goes-o = Iskanje je bilo ustavljeno; »Premakni roj« ga nadaljuje.
the-swarm-is-still-searching-to-the-end-shor = Roj še išče; »Do konca« to skrajša.
not-programmed-why = Ni programirano: { $why }.
the-plan-is-programmed-feed-and-speed-the-pa = Načrt je programiran, { $feed } in { $speed }: kos se obdela od začetka, s stalnim podajanjem.
the-plan-is-programmed-feed-and-speed-the-pa-2 = Načrt je programiran, { $feed } in { $speed }: kos se obdela od začetka, { $controller } od tam naprej vodi podajanje.
best-so-far = Doslej najboljše
optimum = Optimum
no-optimum = Ni optimuma
the-network-does-not-know-this-cut-material = Mreža tega reza ne pozna: material, trdota ali globini so zunaj njenih učnih podatkov, sila pa se nadaljuje.
cut-it-at-constant-feed = Reži s stalnim podajanjem
programs-this-feed-and-speed-switches-the-co = Programira to podajanje in vrtljaje, preklopi regulator na stalno podajanje in na pultu reže od začetka: tu načrtovani rez. En korak razveljavitve.
use-as-programmed-values = Uporabi kot programirane vrednosti
programs-this-feed-and-speed-keeps-all-else = Programira to podajanje in vrtljaje, ohrani vse drugo in na pultu reže od začetka. Stalno podajanje, kot je programirano, je nato to podajanje; regulator, ki podajanje nastavlja po svojih modelih, gre na isto kot prej. En korak razveljavitve.
controller-moves-the-feed-on-from-the-progra = { $controller } programirano podajanje takoj premakne.
the-console-s-force-at-the-playhead-is-force-2 = Sila na pultu pri časovnem kazalcu je { $force }, { $off } glede na načrtovano pri njeni globini, { $depth }.
feed-per-tooth = Podajanje na zob
cutting-speed = Rezalna hitrost
removal = Odvzem
time-at-this-feed = Čas pri tem podajanju
with-tool-changes = z menjavami orodja
cost-of-cut-your-currency = Cena reza, v vaši valuti
objective = Ciljna funkcija

## src/app/panels/plan/controls.rs

changed-during-the-cut-after-its-start-names = Spremenjeno med rezom, po začetku: { $names }.
makes-the-values-at-the-playhead-those-of-th = Vrednosti pri časovnem kazalcu naredi za začetne in načrtuje zanje
plan-for-the-values-now = Načrtuj za sedanje vrednosti
what-is-sought = Kaj se išče
the-heavier-a-weight-beside-the-others-the-m = Čim težja je utež v primerjavi z drugimi, tem bolj gre načrt v to smer: velika sila je blizu svoje meje in vzame večje podajanje. Velikost ene same uteži ne spremeni ničesar.
the-cut = Rez
swarm = Roj
costs-and-times = Cene in časi
a-plan-is-made-before-the-cut-changes-here-h = Načrt se naredi pred rezom: spremembe tu veljajo od njegovega začetka.

## src/app/panels/plan/convergence.rs

mean-of-all-particles = povprečje vseh delcev
best-allowed = najboljši dovoljeni
particles-at-an-allowed-place = delci na dovoljenem mestu [%]
allowed = Dovoljeno

## src/app/panels/plan/legend.rs

the-map = karta
equal-force = enaka sila
particles-full-allowed = delci (polni: dovoljeni)
their-own-bests = njihova najboljša mesta
best-of-all = najboljše od vseh
the-speed-searched = iskana vrtilna hitrost
outside-the-map = Zunaj karte:
constraint-violated = { $constraint } (kršeno)
placeholder-no-public-data-of-this-machine-w = nadomestna vrednost: javnih podatkov o tem stroju ni bilo mogoče najti
a-chosen-limit-of-the-process = izbrana meja procesa
given-by-the-settings-or-a-data-sheet = podano v nastavitvah ali podatkovnem listu
limit-limits-unit-source = Meja: { $limits } { $unit } ({ $source }).
the-constraint-is-origin = Omejitev je { $origin }.

## src/app/panels/plan/map.rs

cutting-speed-m-min = rezalna hitrost [m/min]
feed-per-tooth-mm = podajanje na zob [mm]
zoom-to-allowed = Povečaj dovoljeno
shows-the-part-of-the-map-that-holds-allowed = Pokaže del karte z dovoljenimi rezi
there-are-none-on-the-map = Na karti jih ni
shows-the-whole-map-as-a-double-click-on-it = Pokaže vso karto, tako kot dvoklik nanjo; poteg po njej povečuje
whole-map = Vsa karta
force-over-cutting-speed-and-feed-per-tooth = Sila po rezalni hitrosti in podajanju na zob; optimum pri { $speed } in { $feed }
force-over-cutting-speed-and-feed-per-tooth-2 = Sila po rezalni hitrosti in podajanju na zob; doslej najboljše pri { $speed } in { $feed }

## src/app/panels/plan/readout.rs

force-by-the-network = Sila po mreži
force-in-the-run = Sila v rezu
ra-of-feed-marks = Ra sledi podajanja
spindle-power = Moč vretena
deflection = Upogib
tool-life = Obstojnost orodja
in-the-run-held = V rezu: { $held }
allowed-by-the-plan = po načrtu dovoljeno
violated-by-the-plan-s-own-forces-constraint = kršeno po silah načrta: { $constraints }
let-go-of-this-place = Opusti to mesto
force-by-the-plan-s-network-in-colour-where = Sila po mreži načrta: v barvi, kjer je rez dovoljen, sivo, kjer ga prepoveduje omejitev

## src/app/panels/plan/recommended.rs

recommended-conditions = Priporočene razmere
by-r-d-engagement = po R_D: { $engagement }
engagement = Prijem
engagement-how-the-cutter-stands-in-the-mate = Prijem: kako frezalo stoji v materialu
for-hardness-hb-a-cutter-of-diameter-engagem = Za { $hardness } HB, frezalo { $diameter }, { $engagement }:
speed-feed-a-tooth = { $speed }, { $feed } na zob
inside-the-table = znotraj tabele
outside-the-table-its-edge-answers = zunaj tabele: odgovarja njen rob
programs-these-values-as-a-start-for-the-pla = Programira te vrednosti kot začetek za načrt in rez. En korak razveljavitve.
start-from-it = Začni od tod
the-table-note = Tabela: { $note }.

## src/app/panels/plan/relief.rs

turns-the-surface-so-does-a-drag-with-the-mo = Zavrti ploskev; tako kot poteg z miško
turn-left = Zavrti levo
turn-right = Zavrti desno
force-surface-in-space-turned-by-turn-seen-t = Ploskev sile v prostoru, zavrtena za { $turn }°, gledana { $tilt }° od zgoraj

## src/app/panels/plan/search.rs

plan-search-of-the-swarm = Načrt: iskanje z rojem

## src/app/panels/plan/steps.rs

no-plan = ni načrta
nothing-feasible-values = nič dopustnega: { $values }
found-values = najdeno: { $values }
best-so-far-values = doslej najboljše: { $values }
values-the-optimum = { $values }, optimum
values-not-the-optimum = { $values }, ni optimum
the-optimal-cutting-conditions-are-found-by = Optimalne rezalne razmere najde PSO-NN
they-are-programmed = Programirajo se
the-desired-roughness-is-set = Nastavi se želena hrapavost
the-reference-force-follows-from-letter-1 = Referenčna sila sledi iz { $letter }1
feed-and-speed-are-commanded-controller = Ukaže se podajanje in vrtilna hitrost ({ $controller })
the-measured-force-is-compared-with-the-refe = Izmerjena sila se primerja z referenco
in-the-air = v zraku
the-overrides-go-back-to-the-machine = Korekciji gresta nazaj na stroj
steps-5-to-7-are-repeated-to-the-end = Koraki 5 do 7 se ponavljajo do konca
control-sample-number-of-all = regulacijski vzorec { $number } od { $all }
the-strategy-in-eight-steps = Strategija v osmih korakih
control-strategy-2013-section-2-values-at-th = Strategija vodenja 2013, razdelek 2; vrednosti pri časovnem kazalcu simulacije.

## src/app/panels/plan/table.rs

the-seven-constraints-there-at-depth-depth = Tamkajšnjih sedem omejitev, pri globini { $depth }
the-list-is-origin = Seznam je { $origin }.
constraint = Omejitev
value = Vrednost
limit = Meja
margin = Rezerva
n-limits-of-the-machine-are-placeholders-no = { "*" } nadomestnih meja stroja: { $n }; javnih podatkov ni bilo mogoče najti.
explain-constraint = Razloži: { $constraint }
binding = dejavna

## src/app/panels/plan/transport.rs

again-from-the-same-random-start = Znova z istim naključnim začetkom
search-again = Išči znova
the-swarm-stands-still = Roj miruje
pause-the-swarm = Ustavi roj
the-swarm-moves-on-at-its-end-again-from-the = Roj se premika naprej; na koncu: znova od začetka
move-the-swarm = Premakni roj
one-iteration-of-the-swarm = Ena iteracija roja
one-iteration = Ena iteracija
to-the-end-of-the-search = Do konca iskanja
to-the-end = Na konec
another-seed-another-random-start-and-nearly = Drugo seme: drug naključni začetek in skoraj isti optimum
other-seed = Drugo seme
done-iteration-iteration-of-at-most-most = končano: iteracija { $iteration } od največ { $most }
stopped-iteration-iteration-of-at-most-most = ustavljeno: iteracija { $iteration } od največ { $most }
searching-iteration-iteration-of-at-most-mos = iskanje: iteracija { $iteration } od največ { $most }
n-evaluations-of-the-force-surface = izračunov ploskve sile: { $n }
at-once = takoj
speed-of-the-swarm = Hitrost roja

## src/app/panels/plan.rs

plan = Načrt
optimise-optimum-cutting-conditions-swarm-co = optimizacija optimum rezalne razmere roj delcev omejitve podajanje hitrost načrtuj optimise swarm
settings-of-the-plan = Nastavitve načrta
programmed-now = programirano zdaj
programmed-now-outside-the-map = programirano zdaj: zunaj karte
the-force-as-a-surface-in-space-cut-by-the-p = Sila kot ploskev v prostoru, presekana z ravnino svoje meje
n-iterations-of-the-swarm = iteracij roja: { $n }
no-plan-can-be-made = Načrta ni mogoče narediti
the-settings-are-beside-or-below = Nastavitve so ob strani ali spodaj.

## src/app/panels/workpiece/blank.rs

the-part-is-another-one-than-that-of-name-no = Obdelovanec zdaj ni več tisti iz { $name }: njegov surovec ni prikazan.
the-blank-of-name-is-not-shown-why = Surovec iz { $name } ni prikazan: { $why }.
name-was-cut-with-another-cutter-cut-it-from = { $name } je bil izrezan z drugim frezalom: za prikaz ga znova izrežite iz surovca.
in-the-air-line-line = v zraku, vrstica { $line }
axial-deep-radial-wide-line-line = globina { $axial }, širina { $radial }, vrstica { $line }
this-part-is-a-table-of-depths-along-its-way = Ta obdelovanec je tabela globin vzdolž poti in nima oblike v prostoru: prikazan je trak vzdolž poti. Obdelovanec, ki tu nastane iz programa, je prikazan tudi kot surovec.
the-blank-in-space-as-it-is-cut-up-to-the-pl = Surovec v prostoru, obdelan do časovnega kazalca
blank = Surovec
the-way-made-straight-with-the-fine-surface = Zravnana pot s fino površino obdelane stene
strip-along-the-way = Trak vzdolž poti
blank-in-space-place = Surovec v prostoru, { $place }
blank-x-y-z-mm = surovec { $x } × { $y } × { $z } mm

## src/app/panels/workpiece/judged.rs

within = znotraj
too-rough-up-to-twice-as-far-off = prehrapavo, do dvakratnega odstopanja
rougher-still = še bolj hrapavo
smoother-than-asked = bolj gladko od zahtevanega
too-large-up-to-twice-as-far-off = prevelika, do dvakratnega odstopanja
larger-still = še večja
smaller-than-asked = manjša od zahtevane

## src/app/panels/workpiece/picture.rs

heights = višine ×
part-in-space-place-heights-drawn-times-time = Obdelovanec v prostoru, { $place }, višine narisane { $times }-krat večje
tool-length-before-the-part = orodje { $length } pred obdelovancem
tool-at-place-of-length-mm = orodje pri { $place } od { $length } mm
cut-number-of-all-tool = rez { $number } od { $all }, { $tool }

## src/app/panels/workpiece/placed.rs

that-is-beside-the-part = To je zunaj obdelovanca.
kind-press-on-the-part-to-place-it-escape-le = { $kind }: pritisnite na obdelovanec, kjer naj bo; Escape konča
choose-one-then-press-on-the-part-where-it-i-2 = Izberite eno in pritisnite na obdelovanec tam, kjer naj se začne; za orodjem se rez ponovi. Ob držanju tipke Shift naslednji pritisk doda še eno.
disturb-the-part = Zmoti rez
choose-one-then-press-on-the-part = Izberite eno in pritisnite na obdelovanec
then-press-on-the-part = Nato pritisnite na obdelovanec.

## src/app/panels/workpiece/profile_chart.rs

as-the-teeth-left-it = kot so pustili zobje
roughness-profile = profil hrapavosti
profile-m = Profil [µm]
name-height-along-along-the-line =
    { $name }: { $height }
    { $along } vzdolž črte
profile-from-from-to-to-along-the-line = Profil od { $from } do { $to } vzdolž črte

## src/app/panels/workpiece/profilometer/fields.rs

a-drag = Poteg
draws-the-line = riše črto
turns-the-part = vrti obdelovanec
no-tooth-has-been-in-this-cut-yet-there-is-n = V tem rezu še ni bilo zoba: ni površine za merjenje.
from-x = Od x
from-y = Od y
to-x = Do x
to-y = Do y
five-sampling-lengths-along-the-feed-as-the = Pet referenčnih dolžin vzdolž podajanja, medtem ko gre orodje naprej
behind-the-tool = Za orodjem
length-long = dolžina { $length }
over-one-sampling-length-of-long-the-standar = Prek ene referenčne dolžine { $long }; standard jih vzame pet.
over-n-sampling-lengths-of-long-the-standard =
    { $n ->
        [one] Prek { $n } referenčne dolžine { $long }; standard jih vzame pet.
        [two] Prek { $n } referenčnih dolžin { $long }; standard jih vzame pet.
        [few] Prek { $n } referenčnih dolžin { $long }; standard jih vzame pet.
       *[other] Prek { $n } referenčnih dolžin { $long }; standard jih vzame pet.
    }
over-n-sampling-lengths-of-long = Prek { $n } referenčnih dolžin { $long }.
the-run-s-ra-with-dynamics-is-ra-along-the-l = Ra z dinamiko simulacije je vzdolž črte povprečno { $ra }.
simulated-tooth-by-tooth-k5-gives-no-ra-here = Pri simulaciji zob za zobom K5 tu ne da Ra: samo sledi podajanja in opletanje.

## src/app/panels/workpiece/program/picture.rs

what-is-left-of-the-blank-from-above-with-th = Kar ostane od surovca, od zgoraj, s potjo orodja

## src/app/panels/workpiece/program.rs

part-of-a-program = Obdelovanec iz programa
name-n-moves = { $name }, gibi: { $n }
size-and-corner-of-the-rectangular-blank-in = Velikost in vogal pravokotnega surovca v koordinatah programa; na začetku leži okrog podajalnih gibov, s 5 mm pod najglobljim.
cut-it-from-the-blank = Izreži iz surovca
with-the-cutter-of-the-scenario = S frezalom scenarija
size = Velikost
size-of-the-blank-along-axis = Velikost surovca vzdolž { $axis }
least-corner = Najmanjši vogal
least-corner-of-the-blank-along-axis = Najmanjši vogal surovca vzdolž { $axis }
step = Korak
step-along-the-way = Korak vzdolž poti
milling-name = Frezanje: { $name }
length-long-air-of-it-air-up-to-axial-deep-a = dolžina { $length }, od tega { $air } zraka; globina do { $axial }, širina do { $radial }
make-it-the-part = Vzemi za obdelovanec
it-was-cut-with-another-cutter-cut-it-again = Izrezano je bilo z drugim frezalom: izrežite znova

## src/app/panels/workpiece/view.rs

whole-part = Ves obdelovanec
all-of-the-present-cut = Ves sedanji rez
at-the-tool = Pri orodju
goes-along-with-the-tool = Spremlja orodje
the-surface-right-behind-the-tool-near-enoug = Površina tik za orodjem, dovolj blizu, da se vidi sled vsakega zoba
close-up = Od blizu
nearer = Bliže
nearer-so-does-the-wheel = Bliže; tako kot kolesce
farther = Dlje
farther-so-does-the-wheel = Dlje; tako kot kolesce
turns-the-picture-so-does-a-drag-over-it = Zavrti sliko; tako kot poteg po njej
higher = Više
lower = Niže
follow-the-tool = Sledi orodju
fingers-on-the-picture-turn-the-part-otherwi = Prsti na sliki vrtijo obdelovanec; sicer premikajo stran
turn-by-touch = Vrti z dotikom
a-factor-of-your-own-otherwise-as-the-distan = Lasten faktor; sicer tak, kot ga hoče razdalja
own-factor = Lasten faktor

## src/app/panels/workpiece.rs

part-surface-3d-profile-roughness-profilomet = kos površina 3d profil hrapavost profilometer slika workpiece
a-table-of-depths-along-a-path-csv-or-a-prog = Tabela globin vzdolž poti (CSV) ali program (koda G), ki se izreže iz surovca; oboje se lahko tudi spusti na okno
part-from-a-file = Obdelovanec iz datoteke…
a-stylus-drawn-along-a-line-over-the-machine = Tipalo, potegnjeno po črti čez obdelano površino: njen profil, Ra, Rq, Rz
profilometer = Profilometer
colour-ra-against-its-tolerance = Barva: Ra glede na svojo toleranco
colour-ra-with-dynamics-against-its-toleranc = Barva: Ra z dinamiko glede na svojo toleranco
colour-force-against-its-tolerance = Barva: sila glede na svojo toleranco
colour-force-without-dynamics-against-its-to = Barva: sila brez dinamike glede na svojo toleranco
outside-the-model-not-judged = zunaj modela: ni ocenjeno
disturbances-along-the-edges-of-the-part = motnje, vzdolž robov obdelovanca
cutting-edges = rezalni robovi
scrap-length-mm-at-a-cost-of-cost = Izmet: { $length } mm, cena { $cost }
length-of-the-way-beyond-the-tolerance-on-th = Dolžina poti zunaj tolerance na slabi strani, po `economics.scrap_cost_per_mm`
the-cutter-is-drawn-turning-times-times-slow-2 = Frezalo je narisano pri { $times }-krat počasnejšem vrtenju.
the-blank-has-its-true-size-what-is-cut-has = Surovec ima pravo velikost; kar je odrezano, ima barvo trenutka, v katerem je bilo frezalo tam nazadnje.
too-rough-is-rework-or-scrap-smoother-than-a = Prehrapavo pomeni dodelavo ali izmet; bolj gladko od zahtevanega nobenega.
what-stands-in-front-of-the-wall-was-taken-b = Kar stoji pred steno, je odvzel prejšnji rez.
simulated-tooth-by-tooth-k5-s-ra-does-not-ho = Pri simulaciji zob za zobom Ra iz K5 ne velja: površina kaže samo sledi podajanja in opletanje.
t-1-setting = 1 nastavitev
