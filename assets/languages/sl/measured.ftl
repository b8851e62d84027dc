# Slovenščina

## crates/measured/src/assemble.rs

the-times-in-name-have-no-unit-taken-to-be-s = časi v `{ $name }` nimajo enote: vzeti kot s
the-times-in-name-have-the-unit-unit-which-i = časi v `{ $name }` imajo enoto `{ $unit }`, ki ni enota časa: vzeti kot s
the-times-in-name-do-not-go-on-at-sample-sam = časi v `{ $name }` pri vzorcu { $sample } ne gredo naprej
key-has-count-entries = vnosov v `{ $key }`: { $count }
one-for-each-of-the-count-columns-names = eden za vsakega od stolpcev ({ $count }): { $names }
there-is-no-column-name-for-the-times = ni stolpca { $name } za čase
none-or-one-of-names = none ali eden od { $names }

## crates/measured/src/bytes.rs

the-file-ends-left-bytes-behind-it = datoteka se konča že za tem (bajtov: { $left })
count-bytes = bajtov: { $count }

## crates/measured/src/contents/mod.rs

count-records = zapisov: { $count }
the-number-of-one-as-in-name-1 = številka zapisa, kot v { $name }[1]
real-numbers = realna števila
numbers-or-a-record = števila ali zapis
a-vector-of-numbers-in-it = vektor števil v njem
record-number-of-count-in-name-choose-anothe = zapis { $number } od { $count } v `{ $name }`; drugega izbere variable={ $name }[{ $count }]
the-file-holds-no-variables = v datoteki ni spremenljivk
the-file-holds-names = v datoteki so { $names }
a-vector-of-numbers = vektor števil
name-was-left-out-about = `{ $name }` je izpuščen: { $about }

## crates/measured/src/contents/value.rs

size-complex-numbers = kompleksna števila, { $size }
size-numbers = števila, { $size }
the-text-text = besedilo { $text }
count-cells = celic: { $count }
count-records-of-fields = zapisov: { $count }, s polji { $fields }
there-is-no-name = { $name } ne obstaja
one-of-names = eno od { $names }
number-part = številka { $part }
t-1-to-most = 1 do { $most }
something-with-a-part-in-it = nekaj, v čemer je { $part }

## crates/measured/src/fault.rs

found-expected-is-expected = { $found }; pričakovano: { $expected }
line-line-column-column-name-what = vrstica { $line }, stolpec { $column } ({ $name }): { $what }
byte-byte-what = bajt { $byte }: { $what }

## crates/measured/src/hdf5/arrays.rs

an-array-of-chunks = polje kosov
elements-of-kind-kind-with-size-bytes = elementi vrste { $kind }, bajtov: { $size }
those-of-an-array-of-chunks = elementi polja kosov
numbers-of-bits-bits = števila, bitov: { $bits }
at-most-63 = največ 63
more-values-than-a-file-of-this-size-can-hav = več vrednosti, kot jih lahko ima tako velika datoteka
blocks-of-least-elements = bloki, elementov: { $least }
a-power-of-two = potenca števila dve

## crates/measured/src/hdf5/attributes.rs

an-attribute = atribut

## crates/measured/src/hdf5/btree2.rs

a-tree = drevo
a-tree-of-kind-kind = drevo vrste { $kind }
a-tree-of-depth-depth = drevo globine { $depth }
at-most-most = največ { $most }
count-records-in-a-node = zapisov v vozlišču: { $count }
a-node-of-size-bytes = vozlišče, bajtov: { $size }

## crates/measured/src/hdf5/chunks.rs

an-array-of-size-bytes = polje, bajtov: { $size }
a-tree-of-kind-kind-level-level = drevo vrste { $kind }, raven { $level }
kind-1-below-level-most = vrsta 1, pod ravnijo { $most }

## crates/measured/src/hdf5/datatype.rs

types-more-than-depth-deep-in-each-other = tipi, vgnezdeni globlje od { $depth }
a-type = tip
a-type-of-no-bytes = tip brez bajtov
at-least-one = vsaj eden
times = časi
bytes-without-a-meaning = bajti brez pomena
references-to-parts-of-arrays = sklici na dele polj
size-bytes = bajtov: { $size }
complex-numbers = kompleksna števila
a-type-of-class-class = tip razreda { $class }
t-0-to-11 = 0 do 11
whole-numbers-of-more-than-64-bits = cela števila z več kot 64 biti
bits-bits-from-bit-shift-on = bitov: { $bits }, od bita { $shift }
within-size-bytes = znotraj bajtov: { $size }
floats-of-an-unusual-form = števila s plavajočo vejico nenavadne oblike
bytes-bytes-from-byte-at-on = bajtov: { $bytes }, od bajta { $at }
count-elements-of-bytes-bytes = elementov: { $count }, bajtov v vsakem: { $bytes }

## crates/measured/src/hdf5/decode.rs

elements-that-are-arrays = elementi, ki so polja
references-to-other-objects = sklici na druge objekte
texts = besedila
lists-of-different-lengths = seznami različnih dolžin

## crates/measured/src/hdf5/file.rs

numbers-of-size-bytes = števila, bajtov: { $size }
at-most-8 = največ 8
version-version-of-what = { $what }: različica { $version }
one-that-is-known = znana
no-signature-of-hdf5 = ni podpisa HDF5
one-at-byte-0-512-1024 = podpis pri bajtu 0, 512, 1024, ...
addresses-of-size-bytes = naslovi, bajtov: { $size }
t-2-4-or-8 = 2, 4 ali 8
hdf5 = HDF5
a-file-of-size-bytes = datoteka, bajtov: { $size }
no-root-group = ni korenske skupine
its-address = njen naslov
no-address = ni naslova
one = ena
the-address-address = naslov { $address }
the-bytes-bytes = bajti { $bytes }
parts-of-the-file-that-name-each-other-again = deli datoteke, ki vedno znova kažejo drug na drugega
each-of-them-once = vsak enkrat
a-part-of-the-file-whose-checksum-does-not-f = del datoteke z napačno kontrolno vsoto
one-that-does = tako, ki se ujema

## crates/measured/src/hdf5/filters.rs

a-list-of-filters = seznam filtrov
compressed-by-szip-which-is-not-read = stisnjeno s szip, ki se ne bere
compressed-by-blosc-which-is-not-read = stisnjeno z Blosc, ki se ne bere
compressed-in-a-way-that-is-not-read = stisnjeno na način, ki se ne bere
compressed-bytes-that-are-spoilt = pokvarjeni stisnjeni bajti
a-chunk = kos
a-chunk-of-size-bytes = kos, bajtov: { $size }
values-whose-checksum-does-not-fit = vrednosti z napačno kontrolno vsoto
those-that-were-written = vrednosti, kot so bile zapisane

## crates/measured/src/hdf5/header.rs

an-object-s-header = glava objekta
a-message-that-is-shared = skupno sporočilo
a-message-in-the-heap-of-messages-that-are-s = sporočilo v kopici skupnih sporočil
one-in-an-object-s-header = sporočilo v glavi objekta
an-object-without-the-message-that-it-should = objekt brez sporočila, ki naj bi ga delil
one-with-it = objekt z njim

## crates/measured/src/hdf5/heaps.rs

a-name-without-an-end = ime brez konca
a-zero-behind-it = ničla za njim
a-text-of-length-bytes = besedilo, bajtov: { $length }
one-that-the-heap-has = tako, ki je v kopici
a-heap = kopica
blocks-of-a-heap-whose-sizes-do-not-fit = bloki kopice, katerih velikosti se ne ujemajo
powers-of-two = potence števila dve
kept-in-a-heap-in-a-way-that-is-not-read = shranjeno v kopici na način, ki se ne bere
byte-at-of-a-heap = bajt { $at } kopice
one-that-it-has = tak, ki ga ima

## crates/measured/src/hdf5/layout.rs

an-array-s-size = velikost polja
rank-dimensions = razsežnosti: { $rank }
a-value-for-what-was-never-written = vrednost za nezapisano
a-layout-of-class-class = razporeditev razreda { $class }
t-0-1-or-2 = 0, 1 ali 2
an-index-of-kind-kind = kazalo vrste { $kind }
t-1-to-5 = 1 do 5
parts-of-arrays-in-other-places-a-virtual-ar = deli polj na drugih mestih (navidezno polje)
a-layout = razporeditev
chunks-of-rank-dimensions = kosi, razsežnosti: { $rank }
rank-none-of-them-0 = { $rank }, nobena 0

## crates/measured/src/hdf5/links.rs

kind-0-below-level-most = vrsta 0, pod ravnijo { $most }
a-link = povezava

## crates/measured/src/hdf5/matlab.rs

structures-too-deep-in-each-other = pregloboko vgnezdene strukture
an-object-of-a-class = objekt razreda
a-sparse-matrix = redka matrika
a-function-or-another-class = funkcija ali drug razred
cells-that-are-no-references = celice, ki niso sklici
records-with-fields-of-different-lengths = zapisi s polji različnih dolžin

## crates/measured/src/hdf5/tree.rs

groups-too-deep-in-each-other = pregloboko vgnezdene skupine
an-array-without-a-type = polje brez tipa

## crates/measured/src/layout/entries.rs

the-name-or-number-of-a-column-or-none = ime ali številka stolpca ali none
a-number-above-0-at-most-most = število nad 0, največ { $most }
a-list-of-names-none-of-them-empty = seznam imen, nobeno ni prazno
one-value-not-a-list = ena vrednost, ne seznam
a-layout-has-no-entry-key-did-you-mean-near = postavitev nima vnosa `{ $key }`; ste mislili `{ $near }`? Na voljo so { $list }
a-layout-has-no-entry-key-there-are-list = postavitev nima vnosa `{ $key }`; na voljo so { $list }

## crates/measured/src/layout/file.rs

version-must-be-version = `version` mora biti { $version }
a-list-of-texts = seznam besedil

## crates/measured/src/matlab/element.rs

the-order-of-bytes-im-or-mi = vrstni red bajtov, `IM` ali `MI`
zlib-s-format = zapis zlib
an-element-of-type-kind = element vrste { $kind }
a-variable-type-14-or-15 = spremenljivka (vrsta 14 ali 15)
a-small-element-of-length-bytes = majhen element, bajtov: { $length }
at-most-4 = največ 4
numbers-types-1-to-9-12-13 = števila (vrste 1 do 9, 12, 13)
characters-types-1-2-4-16-17 = znaki (vrste 1, 2, 4, 16, 17)
a-size-of-size = velikost { $size }
t-0-to-2147483647 = 0 do 2147483647
structures-more-than-depth-deep-in-each-othe = strukture, vgnezdene globlje kot { $depth }
an-array-of-size-values = polje { $size } vrednosti
no-more-than-the-left-bytes-that-follow-hold = ne več, kot gre v preostale bajte ({ $left })
count-values = vrednosti: { $count }
a-value-type-14 = vrednost (vrsta 14)
names-of-no-length = imena brez dolžine
t-1-to-64-characters = 1 do 64 znakov

## crates/measured/src/parquet/mod.rs

a-file-without-columns = datoteka brez stolpcev
name-holds-no-numbers-and-was-left-out = v `{ $name }` ni števil, zato je izpuščen
an-end-without-par1 = konec brez `PAR1`
a-file-that-was-written-to-its-end = do konca zapisana datoteka
a-description-of-size-bytes = opis, bajtov: { $size }
a-tree-of-columns-that-does-not-fit = drevo stolpcev, ki se ne ujema
name-has-no-values = `{ $name }` nima vrednosti
some = nekaj
pages-of-name-at-byte-byte = strani `{ $name }` pri bajtu { $byte }
a-page-without-its-size = stran brez velikosti
a-page-of-count-values = stran, vrednosti: { $count }

## crates/measured/src/parquet/pages.rs

a-page = stran
a-page-of-size-bytes = stran, bajtov: { $size }
the-compression-name-number-codec = stiskanje { $name } (številka { $codec })
none-snappy-gzip-or-zstandard = nobeno, Snappy, gzip ali Zstandard
at-most-64 = največ 64
a-run-of-no-values = niz brez vrednosti
no-packed-numbers = nobenih pakiranih števil
a-number-that-the-dictionary-does-not-have = številka, ki je v slovarju ni
below-count = pod { $count }
the-encoding-encoding = kodiranje { $encoding }
plain-dictionary-runs-differences-or-split-b = navadno, slovar, nizi, razlike ali razdeljeni bajti
count-values-in-parts-parts = vrednosti: { $count }, delov: { $parts }

## crates/measured/src/parquet/thrift.rs

a-number-of-more-than-64-bits = število z več kot 64 biti
a-value-of-type-kind = vrednost vrste { $kind }
types-1-to-12 = vrste 1 do 12

## crates/measured/src/reader.rs

text-matlab-v5-or-v7-3-hdf5-tdms-or-parquet = besedilo, MATLAB v5 ali v7.3, HDF5, TDMS ali Parquet
the-file-is-empty = datoteka je prazna
it-is-the-index-of-a-tdms-file-give-the-file = to je kazalo datoteke TDMS: navedite samo datoteko
key-means-nothing-for-a-file-of-the-format-f = `{ $key }` nima pomena za datoteko vrste { $format }
the-file-has-no-column-with-numbers = datoteka nima stolpca s števili

## crates/measured/src/signal/align.rs

count-samples-to-align = vzorcev za poravnavo: { $count }
at-least-least = vsaj { $least }
two-series-that-nowhere-go-together = niza, ki se nikjer ne ujemata
some-shift-at-which-one-rises-where-the-othe = zamik, pri katerem en niz raste tam kot drugi

## crates/measured/src/signal/drift.rs

no-sample-from-from-to-to-s = ni vzorca od { $from } do { $to } s
times-from-from-to-to-s = časi od { $from } do { $to } s
a-sample-rate-rate-hz-in-the-layout = frekvenca vzorčenja: rate_hz v postavitvi
twice-the-time-time-s = dvakrat čas { $time } s
two-times-apart = dva različna časa

## crates/measured/src/signal/low_pass.rs

a-cut-off-of-cut-off-hz = mejna frekvenca { $cut_off } Hz
above-0-and-below-most-hz = nad 0 in pod { $most } Hz

## crates/measured/src/signal/mod.rs

samples-that-are-not-even-in-time-or-whose-t = vzorci, ki niso enakomerni v času ali katerih časi niso znani
no-samples = ni vzorcev

## crates/measured/src/signal/periods.rs

a-period-of-period-s = perioda { $period } s
above-0 = nad 0
times-that-are-not-known-or-do-not-go-on = časi, ki niso znani ali ne gredo naprej
count-samples = vzorcev: { $count }
other-times-than-those-of-name = drugi časi kot pri `{ $name }`
the-same = isti

## crates/measured/src/signal/prepare.rs

drift-without-a-time-before-the-cut = lezenje brez časa pred rezom
two-times = dva časa
x-and-y = `{ $x }` in `{ $y }`
two-forces-of-one-length-and-an-angle = dve enako dolgi sili in kot
peaks-without-a-period = konice brez periode
a-period-in-s = perioda v s
there-is-no-channel-name = ni kanala { $name }

## crates/measured/src/tdms/mod.rs

count-numbers = števil: { $count }
there-is-no-name-with-numbers = { $name } s števili ne obstaja
a-group-or-one-of-names = skupina ali eno od { $names }
name-has-the-scale-scale-which-is-not-applie = `{ $name }` ima lestvico { $scale }, ki ni upoštevana

## crates/measured/src/tdms/segments.rs

a-segment-which-begins-with-tdsm = segment, ki se začne s `TDSm`
raw-data-bytes-bytes-behind = surovi podatki zadaj (bajtov: { $bytes })
no-length-of-raw-data-before-it = pred tem ni dolžine surovih podatkov
raw-values-of-daqmx-which-are-scaled-elsewhe = surove vrednosti DAQmx, ki se merijo drugje
values-that-labview-has-converted-or-csv = vrednosti, ki jih je pretvoril LabVIEW, ali CSV
an-array-of-count-dimensions = polje, razsežnosti: { $count }
values-of-type-kind = vrednosti vrste { $kind }
numbers-texts-or-times = števila, besedila ali časi
fewer = manj
numbers-of-16-bytes = števila s 16 bajti
texts-between-numbers-value-by-value = besedila med števili, vrednost za vrednostjo
numbers-alone = samo števila

## crates/measured/src/text/encoding.rs

byte-byte-is-no-utf-8 = bajt { $byte } ni UTF-8
utf-8-or-another-encoding-latin-1 = UTF-8 ali drugo kodiranje: latin-1
byte-byte-stands-in-no-text = bajta { $byte } ni v nobenem besedilu
half-a-character-of-utf-16 = pol znaka UTF-16
utf-16-or-another-encoding-utf-8-or-latin-1 = UTF-16 ali drugo kodiranje: utf-8 ali latin-1
a-whole-one = cel

## crates/measured/src/text/mod.rs

more-than-most-values = več kot { $most } vrednosti
at-most-most-columns = največ { $most } stolpcev
the-values-may-also-be-meant-with-separator = vrednosti so lahko mišljene tudi s separator={ $separator } decimal={ $decimal }
line-line-breaks-off-and-was-left-out = vrstica { $line } je prekinjena in izpuščena
lines-of-numbers-separated-by-tabs-semicolon = vrstice s števili, ločenimi s tabulatorji, podpičji, vejicami ali presledki
no-line-with-numbers-from-here-on-line = od tod naprej ni vrstice s števili: { $line }
the-text-ends-after-count-lines = besedilo se konča prej (vrstic: { $count })
key-is-line = `{ $key }` je { $line }
a-line-above-the-values-which-begin-in-line = vrstica nad vrednostmi, ki se začnejo v vrstici { $line }

## crates/measured/src/text/rows.rs

the-value-value = vrednost { $value }
no-more-than-count-values = največ { $count } vrednosti
a-date-a-time-of-day-or-both = datum, ura ali oboje
a-number-with-a-decimal-point-or-nothing = število z decimalno piko ali nič
a-number-with-a-decimal-comma-or-nothing = število z decimalno vejico ali nič
number-thousands-parted-by-sign = { $number }, tisočice loči { $sign }
