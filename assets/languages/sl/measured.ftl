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

## crates/measured/src/fault.rs

found-expected-is-expected = { $found }; pričakovano: { $expected }
line-line-column-column-name-what = vrstica { $line }, stolpec { $column } ({ $name }): { $what }
byte-byte-what = bajt { $byte }: { $what }

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

the-bytes-bytes = bajti { $bytes }
the-order-of-bytes-im-or-mi = vrstni red bajtov, `IM` ali `MI`
compressed-bytes-that-are-spoilt = pokvarjeni stisnjeni bajti
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
an-object-of-a-class = objekt razreda
an-array-of-size-values = polje { $size } vrednosti
no-more-than-the-left-bytes-that-follow-hold = ne več, kot gre v preostale bajte ({ $left })
a-sparse-matrix = redka matrika
count-values = vrednosti: { $count }
a-function-or-another-class = funkcija ali drug razred
a-value-type-14 = vrednost (vrsta 14)
names-of-no-length = imena brez dolžine
t-1-to-64-characters = 1 do 64 znakov

## crates/measured/src/matlab/mod.rs

size-complex-numbers = kompleksna števila, { $size }
size-numbers = števila, { $size }
the-text-text = besedilo { $text }
count-cells = celic: { $count }
count-records-of-fields = zapisov: { $count }, s polji { $fields }
there-is-no-name = { $name } ne obstaja
one-of-names = eno od { $names }
number-part = številka { $part }
t-1-to-most = 1 do { $most }
count-records = zapisov: { $count }
the-number-of-one-as-in-name-1 = številka zapisa, kot v { $name }[1]
something-with-a-part-in-it = nekaj, v čemer je { $part }
real-numbers = realna števila
numbers-or-a-record = števila ali zapis
a-vector-of-numbers-in-it = vektor števil v njem
record-number-of-count-in-name-choose-anothe = zapis { $number } od { $count } v `{ $name }`; drugega izbere variable={ $name }[{ $count }]
the-file-holds-no-variables = v datoteki ni spremenljivk
the-file-holds-names = v datoteki so { $names }
a-vector-of-numbers = vektor števil
name-was-left-out-about = `{ $name }` je izpuščen: { $about }

## crates/measured/src/parquet/mod.rs

a-file-without-columns = datoteka brez stolpcev
at-least-one = vsaj eden
name-holds-no-numbers-and-was-left-out = v `{ $name }` ni števil, zato je izpuščen
at-most-most = največ { $most }
an-end-without-par1 = konec brez `PAR1`
a-file-that-was-written-to-its-end = do konca zapisana datoteka
a-description-of-size-bytes = opis, bajtov: { $size }
a-tree-of-columns-that-does-not-fit = drevo stolpcev, ki se ne ujema
one-that-does = tako, ki se ujema
name-has-no-values = `{ $name }` nima vrednosti
some = nekaj
pages-of-name-at-byte-byte = strani `{ $name }` pri bajtu { $byte }
a-page-without-its-size = stran brez velikosti
one = ena
a-page-of-count-values = stran, vrednosti: { $count }

## crates/measured/src/parquet/pages.rs

a-page = stran
a-page-of-size-bytes = stran, bajtov: { $size }
the-compression-name-number-codec = stiskanje { $name } (številka { $codec })
none-snappy-gzip-or-zstandard = nobeno, Snappy, gzip ali Zstandard
numbers-of-bits-bits = števila, bitov: { $bits }
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

text-matlab-v5-tdms-or-parquet = besedilo, MATLAB v5, TDMS ali Parquet
the-file-is-empty = datoteka je prazna
it-is-hdf5-or-matlab-v7-3-save-it-as-matlab = to je HDF5 ali MATLAB v7.3: shranite kot MATLAB v5 (`save -v7`), Parquet ali CSV
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
texts = besedila
numbers-of-16-bytes = števila s 16 bajti
complex-numbers = kompleksna števila
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
