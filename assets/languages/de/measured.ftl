# Deutsch

## crates/measured/src/assemble.rs

the-times-in-name-have-no-unit-taken-to-be-s = die Zeiten in `{ $name }` haben keine Einheit: als s genommen
the-times-in-name-have-the-unit-unit-which-i = die Zeiten in `{ $name }` haben die Einheit `{ $unit }`, die keine der Zeit ist: als s genommen
the-times-in-name-do-not-go-on-at-sample-sam = die Zeiten in `{ $name }` gehen beim Wert { $sample } nicht weiter
key-has-count-entries = Einträge in `{ $key }`: { $count }
one-for-each-of-the-count-columns-names = einer für jede der { $count } Spalten: { $names }
there-is-no-column-name-for-the-times = es gibt keine Spalte { $name } für die Zeiten
none-or-one-of-names = none oder eine von { $names }

## crates/measured/src/bytes.rs

the-file-ends-left-bytes-behind-it = die Datei endet { $left } Byte dahinter
count-bytes = { $count } Byte

## crates/measured/src/fault.rs

found-expected-is-expected = { $found }; erwartet ist { $expected }
line-line-column-column-name-what = Zeile { $line }, Spalte { $column } ({ $name }): { $what }
byte-byte-what = Byte { $byte }: { $what }

## crates/measured/src/layout/entries.rs

the-name-or-number-of-a-column-or-none = Name oder Nummer einer Spalte, oder none
a-number-above-0-at-most-most = eine Zahl über 0, höchstens { $most }
a-list-of-names-none-of-them-empty = eine Liste von Namen, keiner davon leer
one-value-not-a-list = ein Wert, keine Liste
a-layout-has-no-entry-key-did-you-mean-near = ein Aufbau hat keinen Eintrag `{ $key }`; war `{ $near }` gemeint? Es gibt { $list }
a-layout-has-no-entry-key-there-are-list = ein Aufbau hat keinen Eintrag `{ $key }`; es gibt { $list }

## crates/measured/src/layout/file.rs

version-must-be-version = `version` muss { $version } sein
a-list-of-texts = eine Liste von Texten

## crates/measured/src/matlab/element.rs

the-bytes-bytes = die Bytes { $bytes }
the-order-of-bytes-im-or-mi = die Reihenfolge der Bytes, `IM` oder `MI`
compressed-bytes-that-are-spoilt = beschädigte gepackte Bytes
zlib-s-format = das Format von zlib
an-element-of-type-kind = ein Element vom Typ { $kind }
a-variable-type-14-or-15 = eine Variable (Typ 14 oder 15)
a-small-element-of-length-bytes = ein kleines Element von { $length } Byte
at-most-4 = höchstens 4
numbers-types-1-to-9-12-13 = Zahlen (Typen 1 bis 9, 12, 13)
characters-types-1-2-4-16-17 = Zeichen (Typen 1, 2, 4, 16, 17)
a-size-of-size = eine Größe von { $size }
t-0-to-2147483647 = 0 bis 2147483647
structures-more-than-depth-deep-in-each-othe = mehr als { $depth } ineinander liegende Strukturen
an-object-of-a-class = ein Objekt einer Klasse
an-array-of-size-values = ein Feld von { $size } Werten
no-more-than-the-left-bytes-that-follow-hold = nicht mehr, als die folgenden { $left } Byte fassen
a-sparse-matrix = eine dünn besetzte Matrix
count-values = Werte: { $count }
a-function-or-another-class = eine Funktion oder eine andere Klasse
a-value-type-14 = ein Wert (Typ 14)
names-of-no-length = Namen ohne Länge
t-1-to-64-characters = 1 bis 64 Zeichen

## crates/measured/src/matlab/mod.rs

size-complex-numbers = { $size } komplexe Zahlen
size-numbers = { $size } Zahlen
the-text-text = der Text { $text }
count-cells = Zellen: { $count }
count-records-of-fields = Datensätze: { $count }, mit { $fields }
there-is-no-name = { $name } gibt es nicht
one-of-names = eines von { $names }
number-part = Nummer { $part }
t-1-to-most = 1 bis { $most }
count-records = Datensätze: { $count }
the-number-of-one-as-in-name-1 = die Nummer eines Datensatzes, wie in { $name }[1]
something-with-a-part-in-it = etwas, in dem { $part } steht
real-numbers = reelle Zahlen
numbers-or-a-record = Zahlen oder ein Datensatz
a-vector-of-numbers-in-it = ein Vektor von Zahlen darin
record-number-of-count-in-name-choose-anothe = Datensatz { $number } von { $count } in `{ $name }`; einen anderen wählt variable={ $name }[{ $count }]
the-file-holds-no-variables = in der Datei sind keine Variablen
the-file-holds-names = in der Datei sind { $names }
a-vector-of-numbers = ein Vektor von Zahlen
name-was-left-out-about = `{ $name }` wurde weggelassen: { $about }

## crates/measured/src/parquet/mod.rs

a-file-without-columns = eine Datei ohne Spalten
at-least-one = mindestens eine
name-holds-no-numbers-and-was-left-out = in `{ $name }` stehen keine Zahlen, es wurde weggelassen
at-most-most = höchstens { $most }
an-end-without-par1 = ein Ende ohne `PAR1`
a-file-that-was-written-to-its-end = eine bis zum Ende geschriebene Datei
a-description-of-size-bytes = eine Beschreibung von { $size } Byte
a-tree-of-columns-that-does-not-fit = ein Baum von Spalten, der nicht passt
one-that-does = einer, der passt
name-has-no-values = `{ $name }` hat keine Werte
some = welche
pages-of-name-at-byte-byte = Seiten von `{ $name }` bei Byte { $byte }
a-page-without-its-size = eine Seite ohne ihre Größe
one = eine
a-page-of-count-values = eine Seite von { $count } Werten

## crates/measured/src/parquet/pages.rs

a-page = eine Seite
a-page-of-size-bytes = eine Seite von { $size } Byte
the-compression-name-number-codec = die Packung { $name } (Nummer { $codec })
none-snappy-gzip-or-zstandard = keine, Snappy, gzip oder Zstandard
numbers-of-bits-bits = Zahlen von { $bits } Bit
at-most-64 = höchstens 64
a-run-of-no-values = eine Folge ohne Werte
no-packed-numbers = keine gepackten Zahlen
a-number-that-the-dictionary-does-not-have = eine Nummer, die das Wörterbuch nicht hat
below-count = unter { $count }
the-encoding-encoding = die Kodierung { $encoding }
plain-dictionary-runs-differences-or-split-b = einfach, Wörterbuch, Folgen, Differenzen oder geteilte Bytes
count-values-in-parts-parts = Werte: { $count }, Teile: { $parts }

## crates/measured/src/parquet/thrift.rs

a-number-of-more-than-64-bits = eine Zahl von mehr als 64 Bit
a-value-of-type-kind = ein Wert vom Typ { $kind }
types-1-to-12 = Typen 1 bis 12

## crates/measured/src/reader.rs

text-matlab-v5-tdms-or-parquet = Text, MATLAB v5, TDMS oder Parquet
the-file-is-empty = die Datei ist leer
it-is-hdf5-or-matlab-v7-3-save-it-as-matlab = es ist HDF5 oder MATLAB v7.3: als MATLAB v5 (`save -v7`), Parquet oder CSV speichern
it-is-the-index-of-a-tdms-file-give-the-file = es ist der Index einer TDMS-Datei: die Datei selbst angeben
key-means-nothing-for-a-file-of-the-format-f = `{ $key }` bedeutet nichts für eine Datei des Formats { $format }
the-file-has-no-column-with-numbers = die Datei hat keine Spalte mit Zahlen

## crates/measured/src/signal/align.rs

count-samples-to-align = Werte zum Ausrichten: { $count }
at-least-least = mindestens { $least }
two-series-that-nowhere-go-together = zwei Reihen, die nirgends miteinander gehen
some-shift-at-which-one-rises-where-the-othe = eine Verschiebung, bei der die eine steigt, wo die andere steigt

## crates/measured/src/signal/drift.rs

no-sample-from-from-to-to-s = kein Wert von { $from } bis { $to } s
times-from-from-to-to-s = Zeiten von { $from } bis { $to } s
a-sample-rate-rate-hz-in-the-layout = eine Abtastrate: rate_hz im Aufbau
twice-the-time-time-s = zweimal die Zeit { $time } s
two-times-apart = zwei verschiedene Zeiten

## crates/measured/src/signal/low_pass.rs

a-cut-off-of-cut-off-hz = eine Grenzfrequenz von { $cut_off } Hz
above-0-and-below-most-hz = über 0 und unter { $most } Hz

## crates/measured/src/signal/mod.rs

samples-that-are-not-even-in-time-or-whose-t = Werte in ungleichen Abständen oder ohne bekannte Zeiten
no-samples = keine Werte

## crates/measured/src/signal/periods.rs

a-period-of-period-s = eine Periode von { $period } s
above-0 = über 0
times-that-are-not-known-or-do-not-go-on = Zeiten, die nicht bekannt sind oder nicht weitergehen
count-samples = Werte: { $count }
other-times-than-those-of-name = andere Zeiten als die von `{ $name }`
the-same = dieselben

## crates/measured/src/signal/prepare.rs

drift-without-a-time-before-the-cut = Drift ohne eine Zeit vor dem Schnitt
two-times = zwei Zeiten
x-and-y = `{ $x }` und `{ $y }`
two-forces-of-one-length-and-an-angle = zwei Kräfte gleicher Länge und ein Winkel
peaks-without-a-period = Spitzen ohne eine Periode
a-period-in-s = eine Periode in s
there-is-no-channel-name = es gibt keinen Kanal { $name }

## crates/measured/src/tdms/mod.rs

count-numbers = Zahlen: { $count }
there-is-no-name-with-numbers = { $name } mit Zahlen gibt es nicht
a-group-or-one-of-names = eine Gruppe oder eines von { $names }
name-has-the-scale-scale-which-is-not-applie = `{ $name }` hat die Skalierung { $scale }, die nicht angewandt wird

## crates/measured/src/tdms/segments.rs

a-segment-which-begins-with-tdsm = ein Segment, das mit `TDSm` beginnt
raw-data-bytes-bytes-behind = Rohdaten { $bytes } Byte dahinter
no-length-of-raw-data-before-it = keine Länge von Rohdaten davor
raw-values-of-daqmx-which-are-scaled-elsewhe = Rohwerte von DAQmx, die anderswo skaliert werden
values-that-labview-has-converted-or-csv = von LabVIEW umgerechnete Werte, oder CSV
an-array-of-count-dimensions = ein Feld von { $count } Dimensionen
values-of-type-kind = Werte vom Typ { $kind }
numbers-texts-or-times = Zahlen, Texte oder Zeiten
fewer = weniger
texts = Texte
numbers-of-16-bytes = Zahlen von 16 Byte
complex-numbers = komplexe Zahlen
texts-between-numbers-value-by-value = Texte zwischen Zahlen, Wert für Wert
numbers-alone = nur Zahlen

## crates/measured/src/text/encoding.rs

byte-byte-is-no-utf-8 = das Byte { $byte } ist kein UTF-8
utf-8-or-another-encoding-latin-1 = UTF-8, oder eine andere Kodierung: latin-1
byte-byte-stands-in-no-text = das Byte { $byte } steht in keinem Text
half-a-character-of-utf-16 = ein halbes Zeichen von UTF-16
utf-16-or-another-encoding-utf-8-or-latin-1 = UTF-16, oder eine andere Kodierung: utf-8 oder latin-1
a-whole-one = ein ganzes

## crates/measured/src/text/mod.rs

more-than-most-values = mehr als { $most } Werte
at-most-most-columns = höchstens { $most } Spalten
the-values-may-also-be-meant-with-separator = die Werte können auch mit separator={ $separator } decimal={ $decimal } gemeint sein
line-line-breaks-off-and-was-left-out = Zeile { $line } bricht ab und wurde weggelassen
lines-of-numbers-separated-by-tabs-semicolon = Zeilen von Zahlen, getrennt durch Tabulatoren, Strichpunkte, Kommas oder Leerzeichen
no-line-with-numbers-from-here-on-line = von hier an keine Zeile mit Zahlen: { $line }
the-text-ends-after-count-lines = der Text endet nach { $count } Zeilen
key-is-line = `{ $key }` ist { $line }
a-line-above-the-values-which-begin-in-line = eine Zeile über den Werten, die in Zeile { $line } beginnen

## crates/measured/src/text/rows.rs

the-value-value = der Wert { $value }
no-more-than-count-values = höchstens { $count } Werte
a-date-a-time-of-day-or-both = ein Datum, eine Uhrzeit oder beides
a-number-with-a-decimal-point-or-nothing = eine Zahl mit Dezimalpunkt, oder nichts
a-number-with-a-decimal-comma-or-nothing = eine Zahl mit Dezimalkomma, oder nichts
number-thousands-parted-by-sign = { $number }, Tausender getrennt durch { $sign }
