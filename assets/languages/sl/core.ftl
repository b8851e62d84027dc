# Slovenščina

## crates/core/src/base/files.rs

a-whole-number-from-0-to-4294967295 = celo število od 0 do 4294967295
a-whole-number-from-0-on = celo število od 0 naprej
a-list = seznam
a-list-of-3-numbers = seznam 3 števil
a-table = tabela
missing-field-field = manjka polje { $field }
unknown-field-field-expected-one-of-known = neznano polje { $field }, pričakovano je eno od { $known }
unknown-field-field-expected-known = neznano polje { $field }, pričakovano je { $known }
invalid-type-found-allowed-is-allowed = napačna vrsta: { $found }, dovoljeno je { $allowed }
invalid-type-found-expected-expected = napačna vrsta: { $found }, pričakovano je { $expected }
invalid-value-found-allowed-is-allowed = napačna vrednost: { $found }, dovoljeno je { $allowed }
invalid-value-found-expected-expected = napačna vrednost: { $found }, pričakovano je { $expected }
invalid-length-found-allowed-is-allowed = napačna dolžina { $found }, dovoljeno je { $allowed }
invalid-length-found-expected-expected = napačna dolžina { $found }, pričakovano je { $expected }
problem-at-line-line-column-column = { $problem } v vrstici { $line }, stolpec { $column }
not-json-problem = ni JSON: { $problem }
problem-at-line-line = { $problem } v vrstici { $line }
not-toml-problem = ni TOML: { $problem }

## crates/core/src/base/formula/certificate.rs

given-ranges-were-given-for-needed-inputs = podanih območij: { $given }, vhodov: { $needed }
the-range-low-high-of-name-is-none-allowed-i = območje { $low }..{ $high } za `{ $name }` ni območje: dovoljeno je spodaj <= zgoraj
its-slope-may-be-of-either-sign = njen naklon ima lahko oba predznaka

## crates/core/src/base/formula/error.rs

column-column-problem = stolpec { $column }: { $problem }

## crates/core/src/base/formula/interval.rs

there-is-no-such-input = takega vhoda ni
it-may-be-too-large-for-a-number = lahko je prevelika za število
the-logarithm-of-0-or-a-negative-number = logaritem iz 0 ali negativnega števila
the-root-of-a-negative-number = koren negativnega števila
a-division-by-0 = deljenje z 0
t-0-to-a-power-that-is-not-positive = 0 na potenco, ki ni pozitivna
a-negative-number-to-a-power-that-is-not-who = negativno število na potenco, ki ni cela

## crates/core/src/base/formula/mod.rs

the-formula-is-nested-more-than-n-deep = formula je gnezdena globlje kot { $n }
the-formula-has-n-nodes-allowed-are-most = formula ima preveč vozlišč ({ $n }): dovoljeno jih je { $most }
there-is-no-input-input-there-are-n = vhoda { $input } ni: vseh je { $n }
the-derivative-by-input-cannot-be-written-pr = odvoda po `{ $input }` ni mogoče zapisati: { $problem }
name-is-no-name-of-an-input-allowed-is-any-w = `{ $name }` ni ime vhoda: dovoljeno je vsako brez `"`
two-inputs-have-the-name-name = dva vhoda imata ime `{ $name }`
the-formula-reads-input-input-there-are-n = formula bere vhod { $input }: vseh je { $n }
the-formula-has-the-number-number-allowed-ar = formula ima število { $number }: dovoljena so končna
the-constant-name-is-value-allowed-are-finit = konstanta `{ $name }` je { $value }: dovoljena so končna števila
name-is-an-input-and-a-constant = `{ $name }` je vhod in konstanta
a-minus-sign-before-a-number-write-a-negativ = minus pred številom: zapišite negativno število

## crates/core/src/base/formula/parse.rs

the-formula-has-n-bytes-allowed-are-most = formula ima preveč bajtov ({ $n }): dovoljeno jih je { $most }
expected-an-operator-or-the-end = pričakovan je operator (+ - * / ^) ali konec
expected-a-number-a-name-a-function-or = pričakovano je število, ime, funkcija ali `(`
expected-or-an-operator = pričakovan je `)` ali operator (+ - * / ^)
expected-behind-the-function-name = za funkcijo `{ $name }` je pričakovan `(`
expected-but-the-formula-ends-here = { $expected }, a formula se tu konča
expected-but-found-found = { $expected }, najdeno pa je `{ $found }`
a-number-has-a-decimal-point-not-a-comma = število ima decimalno piko, ne vejice
a-product-needs-its = zmnožek potrebuje svoj `*`
a-quoted-name-without-its-end = ime v narekovajih brez konca
sign-has-no-meaning-in-a-formula-allowed-are = `{ $sign }` v formuli nima pomena: dovoljeni so + - * / ^ ( )
the-number-is-too-large = število je preveliko
this-is-no-number = to ni število
the-formula-has-more-than-n-nodes = formula ima preveč vozlišč (več kot { $n })
unknown-function-name-the-natural-logarithm = neznana funkcija `{ $name }`: naravni logaritem je `ln`
unknown-function-name-did-you-mean-near = neznana funkcija `{ $name }`: ste mislili `{ $near }`?
unknown-name-name-did-you-mean-near = neznano ime `{ $name }`: ste mislili `{ $near }`?
unknown-function-name-known-are-names = neznana funkcija `{ $name }`: znane so { $names }
unknown-name-name-known-are-names = neznano ime `{ $name }`: znana so { $names }

## crates/core/src/base/formula/unit.rs

the-unit-unit-ends-with = enota `{ $unit }` se konča z `/`
unit-is-no-unit-a-power-is-a-number-as-in-mm = `{ $unit }` ni enota: potenca je število, kot v mm^2
unit-is-no-unit-known-are-known = `{ $unit }` ni enota: znane so { $known }

## crates/core/src/base/formula/units.rs

given-units-were-given-for-needed-inputs = podanih enot: { $given }, vhodov: { $needed }
the-formula-has-the-unit-unit-but-its-result = formula ima enoto { $unit }, njen rezultat pa mora imeti { $wanted }
name-needs-a-plain-number-but-this-has-the-u = `{ $name }` potrebuje golo število, to pa ima enoto { $unit }
cannot-add-second-to-first = { $second } ni mogoče prišteti k { $first }
cannot-subtract-second-from-first = { $second } ni mogoče odšteti od { $first }
an-exponent-is-a-plain-number-but-this-has-t = eksponent je golo število, ta pa ima enoto { $unit }
with-an-exponent-that-changes-the-base-must = pri spremenljivem eksponentu mora biti osnova golo število, ta pa ima enoto { $unit }

## crates/core/src/base/network/file.rs

note-is-n-bytes-long-allowed-is-at-most-most = dolžina `note` v bajtih je { $n }: dovoljeno je največ { $most }
activation-cannot-be-found-allowed-is-ids = `activation` ne more biti { $found }: dovoljeno je { $ids }
low-and-high-must-be-equally-long-found-lows = `{ $low }` in `{ $high }` morata biti enako dolga, najdeno je { $lows } in { $highs }
longer-than-n-bytes = daljše od { $n } bajtov

## crates/core/src/base/network/mod.rs

sizes-must-be-2-to-layers-layers-of-1-to-neu = `sizes` mora imeti 2 do { $layers } plasti z 1 do { $neurons } nevroni
weights-holds-n-numbers-needed-are-needed = število vrednosti v `weights` je { $n }, potrebnih je { $needed }
weights-index-is-weight-it-must-be-finite = `weights[{ $index }]` je { $weight }: mora biti končno

## crates/core/src/base/network/scaling.rs

name-must-hold-needed-values-each-found-foun = `{ $name }` mora imeti po { $needed } vrednosti, najdenih je { $found }
xmin-index-and-xmax-index-are-low-and-high-t = `xmin[{ $index }]` in `xmax[{ $index }]` sta { $low } in { $high }: morata biti končna in naraščajoča, pozitivna, kjer je `ln_inputs` true
ymin-index-and-ymax-index-must-be-finite-and = `ymin[{ $index }]` in `ymax[{ $index }]` morata biti končna in naraščajoča
norm-lo-norm-hi-and-target-lo-target-hi-must = `norm_lo`, `norm_hi` in `target_lo`, `target_hi` morajo naraščati

## crates/core/src/base/settings/error.rs

unknown-setting-path-did-you-mean-near = neznana nastavitev `{ $path }`; ste mislili `{ $near }`?
unknown-setting-path-list-prints-all-setting = neznana nastavitev `{ $path }`; `list` izpiše vse nastavitve
path-cannot-be-value-allowed-is-allowed = `{ $path }` ne more biti { $value }: dovoljeno je { $allowed }

## crates/core/src/base/settings/kind.rs

a-number-from-min-to-max-unit = število od { $min } do { $max }{ $unit }
a-whole-number-from-min-to-max-unit = celo število od { $min } do { $max }{ $unit }
true-or-false = true ali false
one-of-ids = eno od { $ids }
text-of-at-most-n-characters = besedilo z največ { $n } znaki

## crates/core/src/base/text.rs

it-is-utf-32-save-it-as-utf-8 = je UTF-32: shranite kot UTF-8
it-is-utf-16-with-half-a-character-in-it-sav = je UTF-16 s polovico znaka: shranite kot UTF-8
it-is-no-text-but-an-archive-or-a-spreadshee = ni besedilo, temveč arhiv ali preglednica: njeno tabelo shranite kot CSV
it-is-no-text-byte-0x-byte-in-line-line = ni besedilo: bajt 0x{ $byte } v vrstici { $line }
it-is-not-utf-8-byte-0x-byte-in-line-line-bu = ni UTF-8 (bajt 0x{ $byte } v vrstici { $line }), morda pa Latin-1 ali Windows-1252, kjer je to { $letter }: shranite kot UTF-8
it-is-not-utf-8-byte-0x-byte-in-line-line-bu-2 = ni UTF-8 (bajt 0x{ $byte } v vrstici { $line }), morda pa Windows-1252: shranite kot UTF-8
it-is-utf-16-little-endian-without-a-byte-or = je UTF-16 (little endian) brez oznake vrstnega reda bajtov: shranite kot UTF-8
it-is-utf-16-big-endian-without-a-byte-order = je UTF-16 (big endian) brez oznake vrstnega reda bajtov: shranite kot UTF-8

## crates/core/src/blocks/cnc/overload.rs

the-machine-stopped-at-time-s-position-mm-fo = Stroj se je ustavil pri { $time } s, { $position } mm: { $force } N, dovoljeno { $limit } N; orodje je dvignjeno z obdelovanca
the-machine-stopped-at-time-s-position-mm-fo-2 = Stroj se je ustavil pri { $time } s, { $position } mm: { $force } N, dovoljeno { $limit } N

## crates/core/src/blocks/control/adjustable_pi.rs

stute-and-goetz-cited-in-combined-system-200 = Stute in Goetz, navedena v Kombinirani sistem 2005; ojačanja izbrana, K z rekurzivno metodo najmanjših kvadratov s pozabljanjem

## crates/core/src/blocks/control/afc/mod.rs

after-heidenhain-s-adaptive-feed-control-afc = po prilagodljivi regulaciji podajanja (AFC) podjetja Heidenhain, samo z besedami; F_1 z učenjem, hitrosti, podajanje v zraku in ob vstopu izbrani
f-m-measured-n-no-reference-for-cut-cut = F_m = { $measured } N; za rez { $cut } ni reference
teach-in = učenje
watching = opazovanje
u-goes-to-limit-f-1-f-m-low-high = u gre v limit(F_1 / F_m, { $low } %, { $high } %)

## crates/core/src/blocks/control/constant_feed.rs

conventional-milling-which-every-paper-compa = običajno frezanje, s katerim primerja vsak članek

## crates/core/src/blocks/control/division.rs

combined-system-2005-divisional-controller-i = Kombinirani sistem 2005, delilni regulator, samo z besedami: razlaga, ki je stabilna in tako malo natančna kot v preglednici 1
chosen-the-divisional-controller-of-2005-ove = izbrano: delilni regulator iz 2005 z doseženim podajanjem
chosen-the-divisional-controller-of-2005-ove-2 = izbrano: delilni regulator iz 2005 z zadnjim ukazom

## crates/core/src/blocks/control/mrac.rs

landau-and-lozano-s-direct-form-as-daneshmen = neposredna oblika po Landauu in Lozanu, kot so jo uporabili Daneshmend in Pak ter Tomizuka, navedeni v Kombinirani sistem 2005; števila izbrana
chosen-model-reference-adaptive-control-of-c = izbrano: prilagodljiva regulacija z referenčnim modelom iz Kombinirani sistem 2005 z enim ojačanjem
u-from-five-adapted-parameters = u iz petih prilagojenih parametrov θ φ

## crates/core/src/blocks/control/preview/mod.rs

chosen-a-kalman-filter-of-the-gain-g-over-th = izbrano: Kalmanov filter ojačanja g nad predvidenim obdelovancem; ne natisne ga noben članek

## crates/core/src/blocks/control/proportional.rs

tlusty-and-elbestawi-cited-in-combined-syste = Tlusty in Elbestawi, navedena v Kombinirani sistem 2005; ojačanja izbrana

## crates/core/src/blocks/control/script/mod.rs

update-gave-kind-allowed-is-a-number-the-fee = `update` je vrnila `{ $kind }`: dovoljeno je število, override podajanja v odstotkih, ali preslikava z { $names }
name-that-update-gave-is-no-number = `{ $name }`, ki jo je vrnila `update`, ni število
update-gave-name-which-nothing-takes-allowed = `update` je vrnila `{ $name }`, česar nič ne sprejme: dovoljeno je { $names }
name-came-to-value-which-is-no-finite-number = `{ $name }` je dala { $value }, kar ni končno število
more-than-n-steps-in-one-control-period-an-e = več kot { $n } korakov v eni regulacijski periodi: neskončna zanka?
a-script-of-one-s-own = lasten skript

## crates/core/src/blocks/control/script/program.rs

line-line-what = vrstica { $line }: { $what }
it-has-n-bytes-at-most-most-are-allowed = ima { $n } bajtov: dovoljenih je največ { $most }
function-name-has-n-parameters-one-is-allowe = funkcija `{ $name }` ima { $n } parametrov: dovoljen je en, `{ $name }({ $parameter })`
there-is-no-function-update-now-which-gives = ni funkcije `update(now)`, ki daje ukaz
something-stands-outside-of-its-functions-no = nekaj stoji zunaj funkcij: dovoljene so samo funkcije
a-script-with-a-function-update-now-at-most = skript s funkcijo `update(now)`, največ { $n } bajtov
this-script-problem = ta skript ({ $problem })

## crates/core/src/blocks/control/sdnrp.rs

sdnrp-2007-figures-lost-the-reading-that-fit = SDNRP 2007, slike izgubljene: razlaga, ki ustreza besedilu in preglednici 3
control-strategy-2013-steps-5-to-7-in-words = Strategija vodenja 2013, koraki 5 do 7, samo z besedami: razloženo kot v SDNRP 2007

## crates/core/src/blocks/control/tracking.rs

chosen-internal-model-control-with-a-smith-p = izbrano: vodenje z notranjim modelom in Smithovim prediktorjem; ne natisne ga noben članek
g-follows-f-m-model-predicted-f-n-with-a-tim = g sledi F_m / { $model }(napovedana f, n) s časovno konstanto { $time } s
f-c-n-c-from-model-4-f-c-n-c-u-on-the-line-o = f_c, n_c iz { $model_4 }(f_c, n_c) = u na črti { $model_2 } in { $model_3 }
model-3-and-the-inverse-of-model-4-within-th = { $model_3 } in inverz { $model_4 } v svojih območjih
what-rounding-to-whole-takes-is-added-to-the = kar odvzame zaokroževanje na cele %, se prišteje naslednji zahtevi: povprečje je, kot je zahtevano
t-1-is-feed-mm-min-and-speed-1-min = 1 % je { $feed } mm/min in { $speed } 1/min
gain-gain = ojačanje { $gain }

## crates/core/src/blocks/control/unks/mod.rs

combined-system-2005-unks-after-kawato-s-hie = Kombinirani sistem 2005: UNKS, po Kawatovi hierarhični shemi; uteži in hitrosti učenja niso bile nikoli objavljene
feedback-error-learning-miyamoto-kawato-seto = učenje iz pogreška povratne zveze (Miyamoto, Kawato, Setoyama, Suzuki 1988), na katerem temelji UNKS iz Kombinirani sistem 2005

## crates/core/src/blocks/cutting/breakage.rs

the-tool-broke-at-time-s-position-mm-by-too = Orodje se je zlomilo pri { $time } s, { $position } mm zaradi predebelega odrezka, { $load } mm: prenese { $stands } mm
the-tool-broke-at-time-s-position-mm-by-too-2 = Orodje se je zlomilo pri { $time } s, { $position } mm zaradi prevelike sile, { $load } N: prenese { $stands } N

## crates/core/src/blocks/cutting/crash.rs

the-tool-crashed-at-time-s-position-mm-a-fee = Orodje je trčilo pri { $time } s, { $position } mm: podajanje { $feed } mm/min pri { $speed } 1/min je za vsak zob več kot polmer frezala, { $radius } mm

## crates/core/src/blocks/cutting/force_model/formula.rs

sdnrp-2007-eq-7-ck45-a-d-2-mm-r-d-3-mm-sharp = SDNRP 2007, en. 7 (Ck45, A_D 2 mm, R_D 3 mm, ostro orodje)
control-strategy-2013-eq-5-the-paper-then-ta = Strategija vodenja 2013, en. 5; članek nato namesto nje vzame svojo nevronsko mrežo
a-formula = formula
f-from-feed-mm-min-on-its-least-force-n-from = f od { $feed } mm/min naprej (njena najmanjša sila), n od { $speed } 1/min naprej
of-the-papers-cutter-alone = samo za frezalo iz člankov
of-the-cutter-cutter-alone = samo za frezalo { $cutter }
f-least-feed-to-most-feed-mm-min-n-least-spe = f { $least_feed } do { $most_feed } mm/min, n { $least_speed } do { $most_speed } 1/min; naprej po premici

## crates/core/src/blocks/cutting/force_model/mechanistic.rs

combined-system-2005-fig-3-lost-as-ball-end = Kombinirani sistem 2005, sl. 3 (izgubljena), kot geometrija kroglastega frezala po Leeju in Altintasu
combined-system-2005-eq-1-compliance-with-th = Kombinirani sistem 2005, en. 1: podajnost z zamikom ene periode zoba
kienzle-s-laws-tangential-radial-and-axial-c = Kienzlejevi zakoni, tangencialni, radialni in aksialni (konstante objavljenih preglednic, deloma izbrane)
by-teeth = po zobeh
f-t-feed-teeth-speed-chip-mm-run-out-runout = f_t = { $feed } / ({ $teeth } · { $speed }) = { $chip } mm, opletanje ± { $runout } mm
f-largest-f-x-2-f-y-2-of-a-control-period = F = največja √(F_x^2 + F_y^2) regulacijske periode
f-force-n-with-vibration-shaken-n-a-d-axial = F = { $force } N; z vibracijami { $shaken } N  (A_D { $axial } mm, R_D { $radial } mm)

## crates/core/src/blocks/cutting/force_model/network_card.rs

f-x-f-y-f-z-factor-nn-inputs = F_x, F_y, F_z = { $factor }NN(vhodi)
f-xy-f-x-2-f-y-2-at-the-instant-of-its-large = F_{ "{" }xy{ "}" } = √(F_x^2 + F_y^2), v trenutku njene največje vrednosti
f-feed-mm-min-n-speed-1-min-r-d-radial-mm-a = f { $feed } mm/min, n { $speed } 1/min, R_D { $radial } mm, A_D { $axial } mm, material { $material }, { $hardness } HB, D { $diameter } mm, geometrija { $geometry }
feed-per-tooth-2 = podajanje na zob
cutting-speed-2 = rezalna hitrost
geometry = geometrija
name-value-unit-trained-on-range = { $name } { $value } { $unit }, naučeno na { $range }
this-cutter-trained-on-ball-ends-with-two-te = to frezalo, naučeno na kroglastih frezalih z dvema zoboma in vijačnico iz člankov
material-at-hardness-hb-trained-on-materials = { $material } pri { $hardness } HB, naučeno na { $materials }
rows-rows-epochs-epochs-seed-seed = vrstic: { $rows }, epoh: { $epochs }, seme { $seed }

## crates/core/src/blocks/cutting/force_model/neural.rs

control-strategy-2013-section-2-3-8-inputs-1 = Strategija vodenja 2013, razdelek 2.3: 8 vhodov, 15 skritih nevronov, 3 izhodi; njene uteži niso bile nikoli objavljene

## crates/core/src/models/disturbances/mod.rs

factor = faktor
times-the-force = { " " }× sila
change-2 = sprememba
mm-deeper = { " " }mm globlje
wear-land = širina obrabe
mm-more-vb = { " " }mm več VB
amplitude = amplituda
of-the-force = { " " }% sile
offset = odmik
n-in-the-end = { " " }N na koncu
addition = dodatek
s-longer = { " " }s dlje
override = korekcija
of-the-feed = { " " }% podajanja

## crates/core/src/models/disturbances/placed.rs

position-mm = položaj mm
positions-ascending-from-0-to-most-mm = položaji naraščajoče od 0 do { $most } mm
length-mm = dolžina mm
lengths-from-least-to-most-mm = dolžine od { $least } do { $most } mm
size-from-least-to-most-unit = { $size } od { $least } do { $most } { $unit }
at-most-n-lists-entries-ranges = največ { $n } seznamov [{ $entries }], { $ranges }

## crates/core/src/models/formula_model/file.rs

tool-cannot-be-id-allowed-is-one-of-ids = `tool` ne more biti `{ $id }`: dovoljeno je eno od { $ids }
n-bytes-at-most-most-are-read = bajtov: { $n }; prebere se jih največ { $most }
version-cannot-be-version-allowed-is-known = `version` ne more biti { $version }: dovoljeno je { $known }
inputs-index-the-range-low-to-high-of-name-i = `inputs[{ $index }]`: območje { $low } do { $high } za `{ $name }` ni območje: dovoljeno je spodaj pod zgoraj

## crates/core/src/models/formula_model/fit.rs

rows-cannot-be-rows-allowed-is-more-than-the = `rows` ne more biti { $rows }: dovoljeno je več, kot je konstant ({ $n })
deviation-cannot-be-deviation-allowed-is-0-o = `deviation` ne more biti { $deviation }: dovoljeno je 0 ali več
constants-cannot-have-constant-allowed-are-n = `constants` ne more imeti { $constant }: dovoljena so števila formule, od leve proti desni
covariance-is-none-of-n-constants-allowed-is = `covariance` ni za toliko konstant ({ $n }): dovoljen je spodnji trikotnik končnih števil, na diagonali nobeno pod 0

## crates/core/src/models/formula_model/mod.rs

n-inputs-allowed-are-at-most-most = vhodov: { $n }; dovoljenih je največ { $most }
the-inputs-are-not-those-of-the-formula = vhodi niso vhodi formule
first-and-last = { $first } in { $last }
the-formula-has-no-bounds-on-its-ranges = formula na svojih območjih ni omejena
its-slope-by-input-slope-has-no-bounds-on-it = njen naklon po `{ $input }`, { $slope }, na svojih območjih ni omejen
name-from-low-to-high = `{ $name }` od { $low } do { $high }
the-formula-is-not-certain-to-have-a-finite = ni gotovo, da ima formula na svojih območjih končno vrednost: za { $place }, { $why }
its-slope-by-input-slope-is-not-certain-to-h = ni gotovo, da ima njen naklon po `{ $input }`, { $slope }, na svojih območjih končno vrednost: za { $place }, { $why }

## crates/core/src/models/formula_model/setting.rs

name-in-unit = `{ $name }` v { $unit }
it-makes-output-of-inputs-allowed-is-wanted = naredi { $output } ({ $inputs }): dovoljeno je { $wanted } ({ $of })
nothing-or-the-text-of-a-formula-s-model-fil = nič ali besedilo datoteke modela formule: { $wanted } ({ $of }), končno na svojih območjih
this-text-problem = to besedilo ({ $problem })

## crates/core/src/models/genetic/model_file.rs

name-turns-round-within-low-high-allowed-is = `{ $name }` se v { $low }..{ $high } obrne: dovoljena je monotona krivulja
name-field-cannot-be-value-allowed-is-a-fini = `{ $name }.{ $field }` ne more biti { $value }: dovoljeno je končno število

## crates/core/src/models/neural_force/mod.rs

sizes-cannot-be-sizes-allowed-is-8-1-to-most = `sizes` ne more biti { $sizes }: dovoljeno je 8, 1 do { $most } in 3 nevroni

## crates/core/src/models/part/shapes.rs

at-most-n-pairs-position-mm-depth-mm-positio = največ { $n } parov [položaj mm, globina mm], položaji naraščajoče od 0 do { $position }, globine od 0 do { $depth }
at-most-n-cuts-of-1-to-sections-sections-len = največ { $n } rezov z 1 do { $sections } odseki [dolžina mm, aksialna globina mm, stena mm], dolžine od { $shortest } do { $length }, globine od 0 do { $depth }, stene od -{ $depth } do { $depth }
at-most-n-numbers-one-for-each-cut-from-min = največ { $n } števil, eno za vsak rez, od { $min } do { $max }{ $unit }

## crates/core/src/models/structure/parameters.rs

base-console = konzolno ogrodje
tooth = zob
slides = sani
table-2 = miza

## crates/core/src/models/structure/reduction.rs

n-modes-across-the-feed-in-a-running-cut = { $n } nihajnih oblik prečno na podajanje v tekočem rezu
t-1-to-4-modes-across-the-feed-which-the-surfa = 1 do 4 nihajne oblike prečno na podajanje, ki jih vidi površina

## crates/core/src/models/tip_modes/file.rs

structure-file = datoteka strukture
line-line-entry-cannot-be-value-allowed-is-a = vrstica { $line }: `{ $entry }` ne more biti { $value }: dovoljeno je { $allowed }
x-or-y = x ali y
mode-place-one-of-mass-kg-and-stiffness-n-m = nihajna oblika { $place }: potreben je natanko eden od `mass_kg` in `stiffness_n_m`
what-makes-a-modal-mass-from-low-to-high-kg = kar da pri tej frekvenci modalno maso od { $low } do { $high } kg
a-number-from-low-to-high = število od { $low } do { $high }
text-of-n-characters = besedilo z { $n } znaki
text-of-1-to-n-characters = besedilo z 1 do { $n } znaki
there-is-no-mode-at-least-one-mode-is-wanted = ni nihajne oblike: potreben je vsaj en `[[mode]]`

## crates/core/src/models/tip_modes/mod.rs

n-modes-allowed-are-at-most-most = { $n } nihajnih oblik: dovoljenih je največ { $most }
mode-place-entry-cannot-be-value-allowed-is = nihajna oblika { $place }: `{ $entry }` ne more biti { $value }: dovoljeno je število od { $low } do { $high }
at-most-n-lists-axis-frequency-damping-ratio = največ { $n } seznamov [os, frekvenca, dušilno razmerje, modalna masa]: os 0 za x ali 1 za y, { $f0 } do { $f1 } Hz, { $d0 } do { $d1 }, { $m0 } do { $m1 } kg

## crates/core/src/models/tool/file.rs

tool-file = datoteka orodja
key-must-be-text-of-1-to-n-characters = `{ $key }` mora biti besedilo z 1 do { $n } znaki
key-is-missing = `{ $key }` manjka
version-version-is-missing = `version = { $version }` manjka
key-is-missing-allowed = `{ $key }` manjka: { $allowed }
unknown-entry-key-there-are-version-title-so = neznan vnos `{ $key }`; obstajajo version, title, source, { $known }
line-line-corner-radius-mm-cannot-be-radius = vrstica { $line }: `corner_radius_mm` ne more biti { $radius } mm: dovoljena je največ polovica `diameter_mm`, { $most } mm

## crates/core/src/models/transfer/setting.rs

stable-poles-real-parts-from-slowest-down-to = stabilni poli: realni deli od { $slowest } do { $fastest } rad/s, imaginarni deli od 0 do { $largest } rad/s, red največ { $n }
pole-place-cannot-be-re-and-im-rad-s-allowed = pol { $place } ne more biti { $re } in { $im } rad/s: dovoljeno je { $allowed }
the-order-cannot-be-order-allowed-is-allowed = red ne more biti { $order }: dovoljeno je { $allowed }
lists-real-imaginary-of-poles = seznami [realni, imaginarni del]: { $poles }

## crates/core/src/models/unks/stored.rs

start-cannot-be-found-allowed-is-one-of-ids = `start` ne more biti { $found }: dovoljeno je eno od { $ids }
sizes-cannot-be-sizes-allowed-is-allowed = `sizes` ne more biti { $sizes }: dovoljeno je { $allowed }
nothing-or-the-text-of-a-file-that-steadycut = nič ali besedilo datoteke, ki jo zapiše `steadycut unks --save`: končne uteži NM-R 2-12-1, NM-1 4-8-1, NM-2 4-8-1

## crates/core/src/models/unks.rs

name-sizes-cannot-be-sizes-allowed-is-allowe = { $name }: `sizes` ne more biti { $sizes }: dovoljeno je { $allowed }

## crates/core/src/run/closed_loop/mod.rs

signal-is-not-finite-at-tick-tick-the-run-en = `{ $signal }` v koraku { $tick } ni končen: simulacija se konča
the-script-failed-at-time-s-problem-the-run = Skript je odpovedal pri { $time } s, { $problem }: potek se konča

## crates/core/src/run/constant_feed_twin.rs

safe-constant-feed = varno stalno podajanje

## crates/core/src/run/diagram/mod.rs

reference = Referenca
turns-the-target-roughness-into-the-cutting = Pretvori ciljno hrapavost v rezalno silo, ki jo pusti. Zanka nato drži to silo: stalna sila ohranja stalno hrapavost.
compares-the-measured-force-with-the-desired = Vsako regulacijsko periodo primerja izmerjeno silo z želeno in zahteva podajanje in vrtilno hitrost. Modeli, s katerimi računa, so njegova predstava: ni nujno, da so modeli reza.
limit-2 = meja
override-limits = Meje korekcije
the-cnc-takes-commands-as-percent-of-the-pro = CNC sprejema ukaze kot odstotke programiranega podajanja (DNCFRO) in vrtilne hitrosti (DNCSPO), v mejah. Kar regulator zahteva čez nje, se odreže; lučka to pokaže. Pravi CNC jemlje cele odstotke in se k novi korekciji premika z omejeno hitrostjo: oboje je mogoče vključiti.
rate = hitrost
the-plc-of-the-machine-passes-every-command = PLK stroja vsak ukaz posreduje po stalnem času. Vsaka pika je ukaz na poti; njena višina kaže velikost v primerjavi z drugimi.
the-servo-system-follows-the-command-with-th = Servosistem sledi ukazu z zakasnitvijo svoje prenosne funkcije, izračunano natančno v vsakem koraku.
the-spindle-follows-its-command-as-a-first-o = Vreteno sledi ukazu kot člen prvega reda, ki vrtilne hitrosti ne more spreminjati hitreje od svoje omejitve.
cutting-process = Proces rezanja
the-true-cut-maximum-cutting-force-from-feed = Resnični rez: največja rezalna sila iz podajanja in vrtilne hitrosti, pomnožena s tem, česar model ne ve: material in trdota, prerez reza, obraba orodja.
dynamic-component = Dinamična komponenta
what-a-real-force-adds-to-the-model-band-lim = Kar prava sila doda modelu: pasovno omejen šum, valovanje zob, počasne spremembe materiala vzdolž poti; vsako s svojim nizom iz semena.
contact = stik
dynamometer = Dinamometer
the-force-sensor-reads-the-dynamic-force-onc = Senzor sile: enkrat na regulacijsko periodo odčita dinamično silo in doda svoj šum. Regulator vidi samo to.
surface = Površina
the-roughness-that-the-force-leaves-on-the-p = Hrapavost, ki jo sila pusti na obdelovancu, brez dinamike stroja. Identificirani modeli so natančen inverz modela reference, zato sila, držana na želeni vrednosti, pusti želeno hrapavost.
the-roughness-with-machine-dynamics-the-same = Hrapavost z dinamiko stroja: ista enačba, v katero vstopa sila s svojo dinamično komponento.

## crates/core/src/run/diagram/names.rs

the-controller-s-belief = regulatorjeva predstava
the-plant = proces
own-formula = lastna formula
now-whose-force = Zdaj, { $whose }: { $force }
now-whose-models-origin = Zdaj, { $whose }: { $models }, { $origin }
now-2 = Zdaj
force-for-a-target-ra-2 = sila za ciljni Ra
feed-for-a-force-2 = podajanje za silo
speed-for-a-force-2 = vrtljaji za silo
cutting-force = rezalna sila
model-outside-its-range = { $model } zunaj svojega območja

## crates/core/src/run/diagram/printed.rs

sdnrp-2007-eq-4 = SDNRP 2007, en. 4
sdnrp-2007-eq-5 = SDNRP 2007, en. 5
sdnrp-2007-eq-6 = SDNRP 2007, en. 6
sdnrp-2007-eq-8 = SDNRP 2007, en. 8
control-strategy-2013-eq-2 = Strategija vodenja 2013, en. 2
control-strategy-2013-eq-3-10-05-can-only-be = Strategija vodenja 2013, en. 3 (»10^05« je lahko le 10^-5)
control-strategy-2013-eq-4 = Strategija vodenja 2013, en. 4
control-strategy-2013-eq-6 = Strategija vodenja 2013, en. 6
a-drive-of-your-own-by-its-poles-and-gain = lasten pogon, po polih in ojačenju
the-dead-time-of-the-command-channel-the-dri = mrtvi čas ukaznega kanala; pogon je lasten
sdnrp-2007-eq-1-with-the-constants-of-its-ta = SDNRP 2007, en. 1, s konstantami iz preglednice 1
sdnrp-2007-eq-2-the-sum-is-a-misprint-a-prod = SDNRP 2007, en. 2 (vsota je tiskovna napaka: zmnožek ima ojačanje 1)
sdnrp-2007-eq-3-the-drive-that-the-paper-sim = SDNRP 2007, en. 3: pogon, s katerim članek simulira
control-strategy-2013-eq-1-natural-frequency = Strategija vodenja 2013, en. 1 (»lastna frekvenca 3 Hz« se z njo ne ujema)
second-order-natural-frequency-3-hz-settling = drugi red, lastna frekvenca 3 Hz, umiritveni čas 0,4 s
control-strategy-2013-section-2-2-measured-s = Strategija vodenja 2013, razdelek 2.2: izmerjeni odzivi na stopnico, samo z besedami
sdnrp-2007-eq-2-and-3-the-text-s-t-8-s-is-a = SDNRP 2007, en. 2 in 3 (»t = 8 s« v besedilu je tiskovna napaka)
control-strategy-2013-section-2-2-below-eq-1 = Strategija vodenja 2013, razdelek 2.2, pod en. 1
control-strategy-2013-section-2-whole-percen = Strategija vodenja 2013, razdelek 2; celi odstotki in hitrost: praksa CNC, izbrano
chosen-no-paper-gives-a-spindle-drive = izbrano: noben članek ne navaja pogona vretena
sdnrp-2007-fig-10-lost-random-sized-like-mea = SDNRP 2007, sl. 10 (izgubljena): naključno, velikosti izmerjenih nihanj; oblika izbrana
sdnrp-2007-section-1-kistler-force-transduce = SDNRP 2007, razdelek 1: merilnik sile Kistler; šum izbran

## crates/core/src/run/diagram/wires.rs

signal-after-dead-time = { $signal }, po mrtvem času
symbol-delayed = { $symbol } z zamikom

## crates/core/src/run/edits.rs

the-change-at-at-s-does-not-fit-any-more-rea = sprememba pri { $at } s ne ustreza več: { $reason }
changed-again = znova spremenjeno
at-most-100000-changes-in-a-run = največ 100000 sprememb v simulaciji
a-change-of-the-scenario-itself-it-belongs-t = sprememba samega scenarija: spada k pripravi
changed-during-the-run = spremenjeno med simulacijo
a-time-from-0-to-before-end-s = čas od 0 do pred { $end } s
changed-at-at-s = spremenjeno pri { $at } s

## crates/core/src/run/explanation.rs

name-low-to-high-unit = { $name } { $low } do { $high } { $unit }
straight-on-beyond = naprej po premici

## crates/core/src/run/job.rs

done-of-total-unit = { $unit }: { $done } od { $total }

## crates/core/src/run/packed.rs

its-packed-part-is-not-url-safe-base64-probl = njen stisnjeni del ni Base64, varen za URL: { $problem }
its-packed-part-unpacks-to-more-than-n-bytes = njen stisnjeni del se razširi na več bajtov, kot se jih prebere (največ { $n })
its-packed-part-is-not-whole = njen stisnjeni del ni cel
text-that-is-not-utf-8 = besedilo, ki ni UTF-8

## crates/core/src/run/presets.rs

preset-name = prednastavitev `{ $name }`
there-is-none-of-this-name-there-are-names = s tem imenom ni nobene; obstajajo { $names }

## crates/core/src/run/scenario/rules.rs

formula-without-a-formula-for-the-plant = formula brez formule za proces
formula-together-with-formula-force-or-formu = formula skupaj s `formula.force` ali `formula.ra`: nastavite oboje hkrati ali najprej formulo in jo nazadnje odstranite
formula-without-a-formula = formula brez formule
formula-together-with-one-of-formula-force-o = formula skupaj z eno od `formula.force_of_ra`, `formula.feed`, `formula.speed`, `formula.force`, `formula.ra`: nastavite oboje hkrati ali najprej formulo in jo nazadnje odstranite
at-most-cnc-speed-max-rpm-most-1-min = največ `cnc.speed_max_rpm`, { $most } 1/min
model-with-plant-steps-of-step-s = { $model } s koraki procesa { $step } s
plant-steps-of-at-most-longest-s-run-steps-p = koraki procesa največ { $longest } s: `run.steps_per_control` od { $steps } naprej (576 jih da 28,8 kHz)
n-modes-across-the-feed-with-machine-coupled = { $n } nihajnih oblik prečno na podajanje z `machine.coupled` = true
t-1-to-4-modes-across-the-feed-axis-1-there-of = tam 1 do 4 nihajne oblike prečno na podajanje (os 1) z največ { $most } Hz: deset korakov po 0,1 ms na periodo
parameters-with-machine-coupled-true-overdam = { $parameters } z `machine.coupled` = true (nadkritično dušena nihanja)
d-or-t-in-a-coupled-run = D ali T v sklopljeni simulaciji
true-without-the-machine-s-sound = true brez zvoka stroja
true-with-machine-coupled-true = true z `machine.coupled` = true
networks-of-the-start-start = mreže začetka `{ $start }`
networks-of-controller-unks-start-wanted-or = mreže za `controller.unks.start`, { $wanted }, ali nobene; nastavite oboje hkrati
at-most-half-of-tool-diameter-mm-half-mm = največ polovica `tool.diameter_mm`, { $half } mm
at-most-tool-diameter-mm-diameter-mm = največ `tool.diameter_mm`, { $diameter } mm
n-broken-teeth = zlomljenih zob: { $n }
at-most-most-one-fewer-than-tool-teeth-teeth = največ { $most }, eden manj od `tool.teeth`, { $teeth }
n-with-machine-coupled-true = { $n } z `machine.coupled` = true
none-there-the-machine-s-regeneration-and-th = tam nobeden: regeneracija stroja in sledi zob štejejo vsak zob
frequency-hz-with-bursts-and-plant-steps-of = { $frequency } Hz z izbruhi in koraki procesa { $step } s
at-most-most-hz-three-steps-to-a-period-more = največ { $most } Hz, trije koraki na periodo; več `run.steps_per_control` jih dopušča več
so-much-the-cut-would-be-deepest-mm-deep = toliko: rez bi bil globok { $deepest } mm
what-leaves-it-at-most-most-mm-deep-everywhe = kar ga povsod pusti globokega največ { $most } mm, skupaj z `workpiece.axial_depth_mm` ali globino rezov
below-noise-band-high-hz-high-hz = pod `noise.band_high_hz`, { $high } Hz
a-divisor-of-run-steps-per-control-steps-eve = delitelj `run.steps_per_control`, { $steps }: zapiše se vsak regulacijski vzorec
at-most-longest-s-with-a-row-every-row-s-row = največ { $longest } s z vrstico na { $row } s (vrstic: { $rows }); zapisujte redkeje z `run.record_every`

## crates/core/src/run/scenario/unused.rs

controller-kind-is-another-one = `controller.kind` je drug
the-controller-does-not-ask-for-it-as-its-ot = regulator je pri drugih svojih nastavitvah ne potrebuje
the-controller-as-it-is-set-does-not-ask-for = regulator, kot je nastavljen, je ne potrebuje
wear-curve-gives-the-wear-over-the-life = `wear.curve` podaja obrabo skozi obstojnost
wear-force-curve-gives-the-force-over-the-we = `wear.force_curve` podaja silo po obrabi
wear-stiffness-curve-gives-the-stiffness-ove = `wear.stiffness_curve` podaja togost po obrabi
wear-life-curve-gives-the-life-over-the-cut = `wear.life_curve` podaja obstojnost po rezu
target-reference-is-force = `target.reference` je force
target-reference-is-ra = `target.reference` je ra
belief-model-set-is-milling-2005-which-has-o = `belief.model_set` je milling_2005, ki ima eno umeritev
plant-model-set-is-milling-2005-which-has-on = `plant.model_set` je milling_2005, ki ima eno umeritev
belief-calibration-is-not-formula-or-belief = `belief.calibration` ni formula ali pa je `belief.model_set` milling_2005
neither-belief-calibration-nor-plant-calibra = niti `belief.calibration` niti `plant.calibration`, kjer je `plant.force_model` formula, ni formula
neither-belief-calibration-nor-plant-calibra-2 = niti `belief.calibration` niti `plant.calibration` ni formula
tool-shape-is-no-bull-nose = `tool.shape` ni bull_nose
only-the-off-line-plan-bends-the-cutter = frezalo upogne samo načrt pred rezom
plant-force-model-is-a-map-not-mechanistic = `plant.force_model` je karta, ne mehanistični model
machine-coupled-is-true-the-machine-is-what = `machine.coupled` je true: popušča stroj
plant-force-model-is-mechanistic-the-teeth-s = `plant.force_model` je mehanistični: sila zob nima prostega člena
noise-level-is-0 = `noise.level` je 0
noise-band-percent-is-0 = `noise.band_percent` je 0
noise-inhomogeneity-percent-is-0 = `noise.inhomogeneity_percent` je 0
nothing-is-random-noise-level-or-every-size = nič ni naključno: `noise.level` ali vse velikosti šuma so 0
cnc-override-rate-limited-is-false = `cnc.override_rate_limited` je false
feed-drive-poles-gives-the-drive = `feed_drive.poles` podaja pogon
feed-drive-poles-is-empty-the-papers-drives = `feed_drive.poles` je prazen: pogoni iz člankov imajo ojačenje 1
spindle-drive-poles-gives-the-drive = `spindle_drive.poles` podaja pogon
spindle-drive-poles-is-empty-lag-and-rate-li = `spindle_drive.poles` je prazen: zakasnitev in omejitev hitrosti spremembe imata ojačenje 1
cnc-force-stop-is-false = `cnc.force_stop` je false
workpiece-cuts-is-empty = `workpiece.cuts` je prazen
program-cut-feeds-mm-min-programs-every-cut = `program.cut_feeds_mm_min` programira vsak rez
workpiece-cuts-gives-lengths-and-depths = `workpiece.cuts` podaja dolžine in globine
machine-coupled-is-false-the-cut-does-not-fe = `machine.coupled` je false: rez ne čuti stroja
machine-tip-modes-gives-the-machine = `machine.tip_modes` podaja stroj
only-the-stability-chart-of-measured-modes-h = ima jo samo karta stabilnosti izmerjenih nihajnih oblik
machine-tip-modes-gives-the-machine-its-toot = `machine.tip_modes` podaja stroj: njegov zob je tog
wear-model-is-fixed = `wear.model` je fixed
wear-model-is-fixed-the-tool-is-worn-by-dist = `wear.model` je fixed: orodje obrabijo samo `disturbances.wear_jumps`
machine-coupled-is-false-nothing-vibrates = `machine.coupled` je false: nič ne vibrira
disturbances-chatter-bursts-is-empty = `disturbances.chatter_bursts` je prazen
wear-life-curve-gives-the-life-over-the-cut-2 = `wear.life_curve` podaja obstojnost po rezu in nič ne prilagaja hitrosti
wear-indentation-n-mm3-is-0 = `wear.indentation_n_mm3` je 0
wear-adjust-speed-is-false-or-wear-model-fix = `wear.adjust_speed` je false ali pa je `wear.model` fixed
only-trends-over-the-tool-s-life-have-it-a-r = to imajo samo trendi skozi obstojnost orodja; simulacija ima silo svojega reza
ra-with-dynamics-in-the-running-cut-leaves-o = Ra z dinamiko med rezom izpušča valove pod 50 µm, kar koli je nastavljeno
no-vibration-of-a-coupled-machine-makes-ra-w = Ra z dinamiko ne nastane iz vibracij sklopljenega stroja (`machine.coupled`, `machine.roughness_from`)
the-off-line-plan-has-it-not-a-run = to ima načrt pred rezom, ne simulacija
it-chooses-what-a-cut-is-compared-with-and-m = izbira, s čim se rez primerja, in ne premika nobenega

## crates/core/src/run/scenario_file.rs

scenario-file = datoteka scenarija
version-is-version-this-program-reads-known = `version` je { $version }; ta program bere { $known }
path-and-now-are-one-setting-keep-now = `{ $path }` in `{ $now }` sta ista nastavitev; obdržite `{ $now }`
edits-must-be-a-list-of-tables-with-at-s-a-n = `edits` mora biti seznam tabel z `at_s` (število), `path` (besedilo) in `value`
unknown-field-edits-key-use-at-s-path-value = neznano polje `edits.{ $key }`; uporabite at_s, path, value

## crates/core/src/run/scenario_link/series.rs

the-series-of-path-has-n-parts-not-4 = število delov v nizu `{ $path }` je { $n }, ne 4
the-series-of-path-has-times-times-and-value = niz `{ $path }`: časov je { $times }, vrednosti { $values }
the-series-of-path-has-decimals-decimals-all = niz `{ $path }` ima toliko decimalk: `{ $decimals }`; dovoljeno je 0 do { $most }
the-series-of-path-has-step-where-a-whole-nu = niz `{ $path }` ima `{ $step }`, kjer mora biti celo število

## crates/core/src/run/scenario_link.rs

it-is-packed-twice = je stisnjena dvakrat
link = povezava
a-without-two-hexadecimal-digits = % brez dveh šestnajstiških števk
part-is-not-name-value = `{ $part }` ni ime=vrednost
version-version-this-program-reads-known = različica { $version }; ta program bere { $known }
v-version-is-missing = `v={ $version }` manjka
at-key-names-no-setting = `at.{ $key }` ne imenuje nobene nastavitve
at-key-has-no-time-in-seconds = `at.{ $key }` nima časa v sekundah

## crates/core/src/run/signals.rs

feed-at-a-limit = podajanje na meji
speed-at-a-limit = vrtljaji na meji
feed-override-at-its-rate = korekcija podajanja na največji hitrosti
spindle-override-at-its-rate = korekcija vretena na največji hitrosti
tooth-out-of-contact = zob ni v stiku
force-over-the-controller-s-limit = sila nad mejo regulatorja
control-switched-off = regulator izključen
tooth-broken = zob zlomljen

## crates/core/src/run/story/changes.rs

on = vključeno
another-one = drug

## crates/core/src/run/story/effects.rs

it-was-unstable-stretches = Nestabilno je bilo { $stretches }.
it-chattered-stretches = Drdralo je { $stretches }.
the-cut-is-finished-length-of-path = Rez je končan: { $length } poti.
the-time-limit-ends-the-run-with-done-of-who = Časovna omejitev konča simulacijo pri { $done } od { $whole } reza.

## crates/core/src/run/story/mod.rs

start = Začetek
contact-2 = Stik
air-2 = Zrak
depth-step-2 = Stopnica globine
disturbance = Motnja
setting = Nastavitev
chatter = Drdranje
unstable = Nestabilno

## crates/core/src/run/story/words/lasting.rs

the-command-answers-command-after-the-start = Ukaz se odzove { $command } po začetku, podajanje šele po { $feed }, ker ima ukazni kanal mrtvi čas { $dead }
the-command-answers-command-after-contact-th = Ukaz se odzove { $command } po stiku, podajanje šele po { $feed }, ker ima ukazni kanal mrtvi čas { $dead }
the-command-answers-command-after-the-step-t = Ukaz se odzove { $command } po stopnici, podajanje šele po { $feed }, ker ima ukazni kanal mrtvi čas { $dead }
the-command-answers-command-after-the-change = Ukaz se odzove { $command } po spremembi, podajanje šele po { $feed }, ker ima ukazni kanal mrtvi čas { $dead }
the-command-answers-command-after-it-the-fee = Ukaz se odzove { $command } po njej, podajanje šele po { $feed }, ker ima ukazni kanal mrtvi čas { $dead }
the-command-answers-command-after-this-the-f = Ukaz se odzove { $command } po tem, podajanje šele po { $feed }, ker ima ukazni kanal mrtvi čas { $dead }
until-then-name-goes-size-below-its-target = do tedaj gre { $name } za { $size } pod svoj cilj
until-then-name-goes-size-above-its-target = do tedaj gre { $name } za { $size } nad svoj cilj
the-feed-command-stands-at-its-upper-limit-v = Ukaz podajanja je na zgornji meji, { $value } (korekcija { $share } %)
the-feed-command-stands-at-its-lower-limit-v = Ukaz podajanja je na spodnji meji, { $value } (korekcija { $share } %)
the-spindle-speed-command-stands-at-its-uppe = Ukaz vrtilne hitrosti vretena je na zgornji meji, { $value } (korekcija { $share } %)
the-spindle-speed-command-stands-at-its-lowe = Ukaz vrtilne hitrosti vretena je na spodnji meji, { $value } (korekcija { $share } %)
at-share-of-this-time = { $at }, { $share } % tega časa
name-is-outside-the-model-meanwhile = { $name } je medtem zunaj modela
meanwhile-name-is-size-below-its-target-with = medtem je { $name } { $size } pod ciljem, v toleranci
meanwhile-name-is-size-below-its-target-outs = medtem je { $name } { $size } pod ciljem, zunaj tolerance
meanwhile-name-is-size-above-its-target-with = medtem je { $name } { $size } nad ciljem, v toleranci
meanwhile-name-is-size-above-its-target-outs = medtem je { $name } { $size } nad ciljem, zunaj tolerance
meanwhile-ra-with-dynamics-is-size-below-its = medtem je Ra z dinamiko { $size } pod ciljem, v toleranci
meanwhile-ra-with-dynamics-is-size-below-its-2 = medtem je Ra z dinamiko { $size } pod ciljem, zunaj tolerance
meanwhile-ra-with-dynamics-is-size-above-its = medtem je Ra z dinamiko { $size } nad ciljem, v toleranci
meanwhile-ra-with-dynamics-is-size-above-its-2 = medtem je Ra z dinamiko { $size } nad ciljem, zunaj tolerance
meanwhile-ra-with-dynamics-is-outside-the-mo = medtem je Ra z dinamiko zunaj modela namesto na svojem cilju
without-dynamics-size-below-it = brez dinamike { $size } pod njim
without-dynamics-size-above-it = brez dinamike { $size } nad njim
the-model-of-the-force-for-a-target-ra-model = Model sile za ciljni Ra ({ $model }) se uporablja zunaj tega, za kar je bil narejen: njegov odgovor je ugibanje.
the-model-of-the-feed-for-a-force-model-is-u = Model podajanja za silo ({ $model }) se uporablja zunaj tega, za kar je bil narejen: njegov odgovor je ugibanje.
the-model-of-the-speed-for-a-force-model-is = Model vrtilne hitrosti za silo ({ $model }) se uporablja zunaj tega, za kar je bil narejen: njegov odgovor je ugibanje.
the-model-of-the-cutting-force-model-is-used = Model rezalne sile ({ $model }) se uporablja zunaj tega, za kar je bil narejen: njegov odgovor je ugibanje.
the-model-of-ra-model-is-used-outside-what-i = Model Ra ({ $model }) se uporablja zunaj tega, za kar je bil narejen: njegov odgovor je ugibanje.
the-model-of-ra-with-dynamics-model-is-used = Model Ra z dinamiko ({ $model }) se uporablja zunaj tega, za kar je bil narejen: njegov odgovor je ugibanje.
the-model-of-the-force-for-a-target-ra-model-2 = Model sile za ciljni Ra ({ $model }) se uporablja zunaj svojega območja
the-model-of-the-feed-for-a-force-model-is-u-2 = Model podajanja za silo ({ $model }) se uporablja zunaj svojega območja
the-model-of-the-speed-for-a-force-model-is-2 = Model vrtilne hitrosti za silo ({ $model }) se uporablja zunaj svojega območja
the-model-of-the-cutting-force-model-is-used-2 = Model rezalne sile ({ $model }) se uporablja zunaj svojega območja
the-model-of-ra-model-is-used-outside-its-ra = Model Ra ({ $model }) se uporablja zunaj svojega območja
the-model-of-ra-with-dynamics-model-is-used-2 = Model Ra z dinamiko ({ $model }) se uporablja zunaj svojega območja
the-target-ra-goes-to-value = ciljni Ra gre na { $value }
the-force-asked-for-goes-to-value = zahtevana sila gre na { $value }
the-feed-goes-to-value = podajanje gre na { $value }
the-spindle-speed-goes-to-value = vrtilna hitrost vretena gre na { $value }
the-force-goes-to-value = sila gre na { $value }
the-force-with-dynamics-goes-to-value = sila z dinamiko gre na { $value }
it-holds-from-low-to-high-unit = velja od { $low } do { $high } { $unit }
it-holds-from-low-unit-on = velja od { $low } { $unit } naprej
it-holds-up-to-high-unit = velja do { $high } { $unit }
it-holds-elsewhere = velja drugje
it-ends-where-the-depth-changes = Konča se tam, kjer se globina spremeni.
it-ends-where-the-tool-leaves-the-part = Konča se tam, kjer orodje zapusti obdelovanec.
it-ends-while-the-depth-stays-the-same = Konča se, čeprav globina ostane enaka.
it-goes-on-to-the-end = Traja do konca.
it-still-goes-on = Še traja.
chatter-at-depth-depth-and-speed-teeth-jump = Drdranje pri globini { $depth } in { $speed }: zobje skačejo iz reza in sila gre na { $largest }, kjer bi bila brez vibracij { $mean }
chatter-at-depth-depth-and-speed-the-teeth-k = Drdranje pri globini { $depth } in { $speed }: zobje ohranijo stik, a vibracije ne izzvenijo in puščajo sledi, do ±{ $marks } µm od zoba do zoba, sila pa gre na { $largest }, kjer bi bila brez vibracij { $mean }
ra-is-with-where-it-would-be-without-without = Ra je { $with }, kjer bi bil brez njih { $without }
the-tool-wears-from-from-to-to-of-its-life-s = Orodje se je doslej obrabilo od { $from } do { $to } % svoje obstojnosti
the-tool-wears-from-from-to-to-of-its-life-i = Orodje se je v tej simulaciji obrabilo od { $from } do { $to } % svoje obstojnosti
here-it-falls-by-size = tu pade za { $size }
here-it-grows-by-size = tu naraste za { $size }
the-force-falls-by-size = sila pade za { $size }
the-force-grows-by-size = sila naraste za { $size }
force-with-the-feed-kept-at-feed = { $force } ob podajanju, ohranjenem pri { $feed }
force-while-the-feed-goes-from-from-to-to = { $force }, podajanje pa gre od { $from } na { $to }
at-safe-constant-feed-the-force-falls-by-siz = pri varnem stalnem podajanju sila pade za { $size }
at-safe-constant-feed-the-force-grows-by-siz = pri varnem stalnem podajanju sila naraste za { $size }
at-constant-feed-the-force-falls-by-size = pri stalnem podajanju sila pade za { $size }
at-constant-feed-the-force-grows-by-size = pri stalnem podajanju sila naraste za { $size }
unstable-feed-and-force-swing-without-dying = Nestabilno: podajanje in sila nihata, ne da bi izzvenela (mejni cikel), s periodo { $period }, { $times }-kratnikom mrtvega časa { $dead }; sila za ±{ $force }, podajanje za ±{ $feed }.
unstable-feed-and-force-swing-without-dying-2 = Nestabilno: podajanje in sila nihata, ne da bi izzvenela (mejni cikel), s periodo { $period }; sila za ±{ $force }, podajanje za ±{ $feed }.
from-from-to-to-s = od { $from } do { $to } s
n-times-first-up-to-last = { $n }-krat, { $first } … { $last }
on-share-of-the-time-a-model-was-used-outsid = { $share } časa je bil model uporabljen zunaj svojega območja, kjer je podaljšan prek izmerjenega.
ra-lies-outside-its-model-on-the-whole-lengt = Ra je na vsej dolžini zunaj svojega modela: ali je bil cilj dosežen, ni znano.
ra-with-dynamics-was-within-tolerance-of-its = Ra z dinamiko je bil v mejah ±{ $tolerance } % cilja na { $share } dolžine
ra-without-dynamics-was-within-tolerance-of = Ra brez dinamike je bil v mejah ±{ $tolerance } % cilja na { $share } dolžine
ra-was-within-tolerance-of-its-target-on-sha = Ra je bil v mejah ±{ $tolerance } % cilja na { $share } dolžine
the-force-without-dynamics-was-within-tolera = Sila brez dinamike je bila v mejah ±{ $tolerance } % reference na { $share } dolžine
the-force-was-within-tolerance-of-its-refere = Sila je bila v mejah ±{ $tolerance } % reference na { $share } dolžine
within-without-dynamics-on-share = { $within } (brez dinamike na { $share })
within-and-outside-for-time-at-the-longest = { $within }, zunaj pa najdlje { $time }
the-target-was-held-that-takes-share = cilj je bil dosežen (za to je treba { $share } %)
the-target-was-not-held-that-takes-share = cilj ni bil dosežen (za to je treba { $share } %)
with-unknown-of-it-outside-the-model-whether-3 = { $unknown } tega je zunaj modela, zato ni znano, ali je bil cilj dosežen (za to je treba { $share } %)
the-reference-was-held-that-takes-share = referenca je bila dosežena (za to je treba { $share } %)
the-reference-was-not-held-that-takes-share = referenca ni bila dosežena (za to je treba { $share } %)
with-unknown-of-it-outside-the-model-whether-4 = { $unknown } tega je zunaj modela, zato ni znano, ali je bila referenca dosežena (za to je treba { $share } %)
too-rough-on-share-alone-elsewhere-smoother = pregrobo samo na { $share }, drugod bolj gladko od zahtevanega

## crates/core/src/run/story/words.rs

a-hard-spot-begins-here-size-times-the-force = tu se začne trdo mesto: { $size } × sila na dolžini { $length }
a-gap-begins-here-over-length = tu se začne vrzel: na dolžini { $length }
a-depth-step-begins-here-size-mm-deeper-over = tu se začne stopnica globine: { $size } mm globlje na dolžini { $length }
the-tool-s-wear-jumps-here-size-mm-more-vb = tu skoči obraba orodja: { $size } mm več VB
a-tooth-breaks-here-the-next-one-cuts-its-fe = tu se zlomi zob: naslednji reže tudi njegovo podajanje
a-chatter-burst-begins-here-size-of-the-forc = tu se začne izbruh drdranja: { $size } % sile na dolžini { $length }, vsiljen
the-sensor-drops-out-here-and-reads-0-over-l = tu senzor izpade in na dolžini { $length } kaže 0
a-sensor-drift-begins-here-size-n-in-the-end = tu se začne lezenje senzorja: { $size } N na koncu, na dolžini { $length }
a-longer-dead-time-begins-here-size-s-longer = tu se začne daljši mrtvi čas: { $size } s dlje na dolžini { $length }
an-operator-s-override-begins-here-size-of-t = tu se začne operaterjeva korekcija: { $size } % podajanja na dolžini { $length }
the-hard-spot-ends-here = tu se trdo mesto konča
the-gap-ends-here = tu se vrzel konča
the-depth-step-ends-here = tu se stopnica globine konča
the-wear-jump-has-grown-to-its-end-here = tu skok obrabe doseže svoj konec
the-broken-tooth-has-grown-to-its-end-here = tu zlom zoba doseže svoj konec
the-chatter-burst-ends-here = tu se izbruh drdranja konča
the-sensor-dropout-ends-here = tu se izpad senzorja konča
the-sensor-drift-has-grown-to-its-end-here = tu lezenje senzorja doseže svoj konec
the-longer-dead-time-ends-here = tu se daljši mrtvi čas konča
the-operator-s-override-ends-here = tu se operaterjeva korekcija konča
the-cut-begins-at-the-programmed-feed-and-sp = rez se začne pri programiranih { $feed } in { $speed }
the-tool-meets-the-part = orodje sreča obdelovanec
the-tool-leaves-the-part = orodje zapusti obdelovanec
the-part-gets-size-deeper-here = rez je od tu za { $size } globlji
the-part-gets-size-shallower-here = rez je od tu za { $size } plitvejši
the-radial-depth-goes-from-from-to-to = radialna globina gre od { $from } na { $to }
the-target-ra-is-moved-and-comes-back-to-to = ciljni Ra se premakne in vrne na { $to }
the-target-ra-goes-from-from-to-to = ciljni Ra gre od { $from } na { $to }
the-reference-force-is-moved-and-comes-back = referenčna sila se premakne in vrne na { $to }
the-reference-force-goes-from-from-to-to = referenčna sila gre od { $from } na { $to }
setting-is-moved-and-comes-back-to-to = { $setting } se premakne in vrne na { $to }
setting-goes-from-from-to-to = { $setting } se spremeni (prej { $from }, zdaj { $to })
first-and-next = { $first }, { $next }
ra-without-dynamics = Ra brez dinamike
the-force = sila
the-force-without-dynamics = sila brez dinamike
stays-within-the-tolerance-held = ostane v toleranci { $held }
leaves-the-tolerance-held = zapusti toleranco { $held }
comes-into-the-tolerance-held = pride v toleranco { $held }
stays-outside-the-tolerance-held = ostane zunaj tolerance { $held }
is-within-the-tolerance-held = je v toleranci { $held }
is-outside-the-tolerance-held = je zunaj tolerance { $held }
leaves-a-surface-that-the-model-cannot-judge = pusti površino, ki je model ne more oceniti { $held }
is-smoother-than-asked-held = da bolj gladko površino od zahtevane { $held }
stays-below-the-tolerance-held = ostane pod toleranco { $held }
is-back-in-the-tolerance-held-after-time-out = se po { $time } zunaj tolerance vrne vanjo { $held }, najdlje { $value }
comes-into-the-tolerance-held-after-time-out = po { $time } zunaj tolerance pride vanjo { $held }, najdlje { $value }
met-furthest-value = { $met }, najdlje { $value }
stays-within-the-tolerance-in-the-mean-held = v povprečju ostane v toleranci { $held }
comes-into-the-tolerance-in-the-mean-held = v povprečju pride v toleranco { $held }
is-within-the-tolerance-in-the-mean-held = je v povprečju v toleranci { $held }
from-to-to = { $from } do { $to }
name-value = ({ $name } { $value })
ra-with-dynamics-with-without-without = (Ra z dinamiko { $with }, brez { $without })
name-from-to-to = ({ $name } { $from } do { $to })
keeps-the-feed-at-feed = ohrani podajanje pri { $feed }
lowers-the-feed-by-size-from-to-to = zmanjša podajanje za { $size } ({ $from } na { $to })
raises-the-feed-by-size-from-to-to = poveča podajanje za { $size } ({ $from } na { $to })
moves-lowers-the-speed-by-size = { $moves }, zmanjša vrtilno hitrost za { $size }
moves-raises-the-speed-by-size = { $moves }, poveča vrtilno hitrost za { $size }
nothing-settles-within-band = v mejah ±{ $band } se nič ne umiri
no-error-remains-without-dynamics = Brez dinamike pogrešek ne ostane
no-error-remains = Pogrešek ne ostane
error-but-name-still-moves-by-swing = { $error }, { $name } pa se še giblje za ±{ $swing }
error-about-which-name-still-moves-by-swing = { $error }, okoli tega se { $name } še giblje za ±{ $swing }
the-law-has-no-integral = zakon nima integrala
it-is-still-on-its-way = Je še na poti.
it-does-not-come-to-rest-in-this-stretch = V tem odseku se ne umiri.
the-remaining-error-is-size-below-the-target = Trajni pogrešek je { $size } pod ciljnim Ra
the-remaining-error-is-size-above-the-target = Trajni pogrešek je { $size } nad ciljnim Ra
without-dynamics-size-below-the-target-ra-re = Brez dinamike ostane { $size } pod ciljnim Ra
without-dynamics-size-above-the-target-ra-re = Brez dinamike ostane { $size } nad ciljnim Ra
the-remaining-error-is-size-below-the-refere = Trajni pogrešek je { $size } pod referenčno silo
the-remaining-error-is-size-above-the-refere = Trajni pogrešek je { $size } nad referenčno silo
without-dynamics-size-below-the-reference-fo = Brez dinamike ostane { $size } pod referenčno silo
without-dynamics-size-above-the-reference-fo = Brez dinamike ostane { $size } nad referenčno silo
begin-so-far-furthest = { $begin }: doslej { $furthest }.
twin-feed-met = { $twin }, { $feed }, { $met }
twin-met = { $twin } { $met }
begin-so-far-does = { $begin }: doslej { $does }.
begin-does = { $begin }: { $does }.
value-ra-at-the-furthest-time-outside-the-to = Ra najdlje { $value }, { $time } zunaj tolerance
value-at-the-furthest-time-outside-the-toler = najdlje { $value }, { $time } zunaj tolerance
it-acts-only-while-feed-or-speed-moves-where = Deluje samo, dokler se podajanje ali vrtilna hitrost spreminja: kjer se v njegovi dolžini nič ne spremeni, se nič ne vidi.
it-acts-only-while-feed-or-speed-moves-it-sh = Deluje samo, dokler se podajanje ali vrtilna hitrost spreminja: najbolj se pokaže ob naslednji spremembi globine, pri { $time }.
it-acts-only-while-feed-or-speed-moves-no-ch = Deluje samo, dokler se podajanje ali vrtilna hitrost spreminja: pred orodjem ni spremembe globine.
the-controller-is-unstable-here-feed-and-for = regulator je tu nestabilen, podajanje in sila nihata, ne da bi izzvenela
the-cut-at-the-programmed-feed-met = rez s programiranim podajanjem { $met }
the-controller-moves-and-met = regulator { $moves } in { $met }
the-controller-met = regulator { $met }
the-tool-is-in-the-air-for-length-no-force-a = Orodje je na dolžini { $length } v zraku: ni sile in ni površine; podajanje gre na { $feed }.
