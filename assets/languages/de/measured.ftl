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

## crates/measured/src/contents/mod.rs

count-records = Datensätze: { $count }
the-number-of-one-as-in-name-1 = die Nummer eines Datensatzes, wie in { $name }[1]
real-numbers = reelle Zahlen
numbers-or-a-record = Zahlen oder ein Datensatz
a-vector-of-numbers-in-it = ein Vektor von Zahlen darin
record-number-of-count-in-name-choose-anothe = Datensatz { $number } von { $count } in `{ $name }`; einen anderen wählt variable={ $name }[{ $count }]
the-file-holds-no-variables = in der Datei sind keine Variablen
the-file-holds-names = in der Datei sind { $names }
a-vector-of-numbers = ein Vektor von Zahlen
name-was-left-out-about = `{ $name }` wurde weggelassen: { $about }

## crates/measured/src/contents/value.rs

size-complex-numbers = { $size } komplexe Zahlen
size-numbers = { $size } Zahlen
the-text-text = der Text { $text }
count-cells = Zellen: { $count }
count-records-of-fields = Datensätze: { $count }, mit { $fields }
there-is-no-name = { $name } gibt es nicht
one-of-names = eines von { $names }
number-part = Nummer { $part }
t-1-to-most = 1 bis { $most }
something-with-a-part-in-it = etwas, in dem { $part } steht

## crates/measured/src/fault.rs

found-expected-is-expected = { $found }; erwartet ist { $expected }
line-line-column-column-name-what = Zeile { $line }, Spalte { $column } ({ $name }): { $what }
byte-byte-what = Byte { $byte }: { $what }

## crates/measured/src/hdf5/arrays.rs

an-array-of-chunks = ein Feld von Stücken
elements-of-kind-kind-with-size-bytes = Elemente der Art { $kind } mit { $size } Byte
those-of-an-array-of-chunks = die eines Feldes von Stücken
numbers-of-bits-bits = Zahlen von { $bits } Bit
at-most-63 = höchstens 63
more-values-than-a-file-of-this-size-can-hav = mehr Werte, als eine Datei dieser Größe haben kann
blocks-of-least-elements = Blöcke von { $least } Elementen
a-power-of-two = eine Zweierpotenz

## crates/measured/src/hdf5/attributes.rs

an-attribute = ein Attribut

## crates/measured/src/hdf5/btree2.rs

a-tree = ein Baum
a-tree-of-kind-kind = ein Baum der Art { $kind }
a-tree-of-depth-depth = ein Baum der Tiefe { $depth }
at-most-most = höchstens { $most }
count-records-in-a-node = { $count } Einträge in einem Knoten
a-node-of-size-bytes = ein Knoten von { $size } Byte

## crates/measured/src/hdf5/chunks.rs

an-array-of-size-bytes = ein Feld von { $size } Byte
a-tree-of-kind-kind-level-level = ein Baum der Art { $kind }, Ebene { $level }
kind-1-below-level-most = Art 1, unter Ebene { $most }

## crates/measured/src/hdf5/datatype.rs

types-more-than-depth-deep-in-each-other = mehr als { $depth }-fach verschachtelte Typen
a-type = ein Typ
a-type-of-no-bytes = ein Typ ohne Bytes
at-least-one = mindestens eine
times = Zeiten
bytes-without-a-meaning = Bytes ohne Bedeutung
references-to-parts-of-arrays = Verweise auf Teile von Feldern
size-bytes = { $size } Byte
complex-numbers = komplexe Zahlen
a-type-of-class-class = ein Typ der Klasse { $class }
t-0-to-11 = 0 bis 11
whole-numbers-of-more-than-64-bits = ganze Zahlen von mehr als 64 Bit
bits-bits-from-bit-shift-on = { $bits } Bit ab Bit { $shift }
within-size-bytes = innerhalb von { $size } Byte
floats-of-an-unusual-form = Gleitkommazahlen ungewöhnlicher Form
bytes-bytes-from-byte-at-on = { $bytes } Byte ab Byte { $at }
count-elements-of-bytes-bytes = { $count } Elemente von { $bytes } Byte

## crates/measured/src/hdf5/decode.rs

elements-that-are-arrays = Elemente, die Felder sind
references-to-other-objects = Verweise auf andere Objekte
texts = Texte
lists-of-different-lengths = Listen verschiedener Länge

## crates/measured/src/hdf5/file.rs

numbers-of-size-bytes = Zahlen von { $size } Byte
at-most-8 = höchstens 8
version-version-of-what = { $what }: Version { $version }
one-that-is-known = eine bekannte
no-signature-of-hdf5 = keine Signatur von HDF5
one-at-byte-0-512-1024 = eine bei Byte 0, 512, 1024, ...
addresses-of-size-bytes = Adressen von { $size } Byte
t-2-4-or-8 = 2, 4 oder 8
hdf5 = HDF5
a-file-of-size-bytes = eine Datei von { $size } Byte
no-root-group = keine Wurzelgruppe
its-address = ihre Adresse
no-address = keine Adresse
one = eine
the-address-address = die Adresse { $address }
the-bytes-bytes = die Bytes { $bytes }
parts-of-the-file-that-name-each-other-again = Teile der Datei, die immer wieder aufeinander zeigen
each-of-them-once = jeder von ihnen einmal
a-part-of-the-file-whose-checksum-does-not-f = ein Teil der Datei, dessen Prüfsumme nicht stimmt
one-that-does = einer, der passt

## crates/measured/src/hdf5/filters.rs

a-list-of-filters = eine Liste von Filtern
compressed-by-szip-which-is-not-read = mit szip gepackt, das nicht gelesen wird
compressed-by-blosc-which-is-not-read = mit Blosc gepackt, das nicht gelesen wird
compressed-in-a-way-that-is-not-read = auf eine Weise gepackt, die nicht gelesen wird
compressed-bytes-that-are-spoilt = beschädigte gepackte Bytes
a-chunk = ein Stück
a-chunk-of-size-bytes = ein Stück von { $size } Byte
values-whose-checksum-does-not-fit = Werte, deren Prüfsumme nicht stimmt
those-that-were-written = die geschriebenen

## crates/measured/src/hdf5/header.rs

an-object-s-header = der Kopf eines Objekts
a-message-that-is-shared = eine geteilte Nachricht
a-message-in-the-heap-of-messages-that-are-s = eine Nachricht im Speicher der geteilten Nachrichten
one-in-an-object-s-header = eine im Kopf eines Objekts
an-object-without-the-message-that-it-should = ein Objekt ohne die Nachricht, die es teilen soll
one-with-it = eines mit ihr

## crates/measured/src/hdf5/heaps.rs

a-name-without-an-end = ein Name ohne Ende
a-zero-behind-it = eine Null dahinter
a-text-of-length-bytes = ein Text von { $length } Byte
one-that-the-heap-has = einer, den der Speicher hat
a-heap = ein Speicher
blocks-of-a-heap-whose-sizes-do-not-fit = Blöcke eines Speichers, deren Größen nicht passen
powers-of-two = Zweierpotenzen
kept-in-a-heap-in-a-way-that-is-not-read = auf eine Weise gespeichert, die nicht gelesen wird
byte-at-of-a-heap = Byte { $at } eines Speichers
one-that-it-has = eines, das er hat

## crates/measured/src/hdf5/layout.rs

an-array-s-size = die Größe eines Feldes
rank-dimensions = { $rank } Dimensionen
a-value-for-what-was-never-written = ein Wert für nie Geschriebenes
a-layout-of-class-class = eine Anordnung der Klasse { $class }
t-0-1-or-2 = 0, 1 oder 2
an-index-of-kind-kind = ein Verzeichnis der Art { $kind }
t-1-to-5 = 1 bis 5
parts-of-arrays-in-other-places-a-virtual-ar = Teile von Feldern an anderen Orten (ein virtuelles Feld)
a-layout = eine Anordnung
chunks-of-rank-dimensions = Stücke mit { $rank } Dimensionen
rank-none-of-them-0 = { $rank }, keine davon 0

## crates/measured/src/hdf5/links.rs

kind-0-below-level-most = Art 0, unter Ebene { $most }
a-link = eine Verknüpfung

## crates/measured/src/hdf5/matlab.rs

structures-too-deep-in-each-other = zu tief verschachtelte Strukturen
an-object-of-a-class = ein Objekt einer Klasse
a-sparse-matrix = eine dünn besetzte Matrix
a-function-or-another-class = eine Funktion oder eine andere Klasse
cells-that-are-no-references = Zellen, die keine Verweise sind
records-with-fields-of-different-lengths = Datensätze mit Feldern verschiedener Länge

## crates/measured/src/hdf5/tree.rs

groups-too-deep-in-each-other = zu tief verschachtelte Gruppen
an-array-without-a-type = ein Feld ohne Typ

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

the-order-of-bytes-im-or-mi = die Reihenfolge der Bytes, `IM` oder `MI`
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
an-array-of-size-values = ein Feld von { $size } Werten
no-more-than-the-left-bytes-that-follow-hold = nicht mehr, als die folgenden { $left } Byte fassen
count-values = Werte: { $count }
a-value-type-14 = ein Wert (Typ 14)
names-of-no-length = Namen ohne Länge
t-1-to-64-characters = 1 bis 64 Zeichen

## crates/measured/src/parquet/mod.rs

a-file-without-columns = eine Datei ohne Spalten
name-holds-no-numbers-and-was-left-out = in `{ $name }` stehen keine Zahlen, es wurde weggelassen
an-end-without-par1 = ein Ende ohne `PAR1`
a-file-that-was-written-to-its-end = eine bis zum Ende geschriebene Datei
a-description-of-size-bytes = eine Beschreibung von { $size } Byte
a-tree-of-columns-that-does-not-fit = ein Baum von Spalten, der nicht passt
name-has-no-values = `{ $name }` hat keine Werte
some = welche
pages-of-name-at-byte-byte = Seiten von `{ $name }` bei Byte { $byte }
a-page-without-its-size = eine Seite ohne ihre Größe
a-page-of-count-values = eine Seite von { $count } Werten

## crates/measured/src/parquet/pages.rs

a-page = eine Seite
a-page-of-size-bytes = eine Seite von { $size } Byte
the-compression-name-number-codec = die Packung { $name } (Nummer { $codec })
none-snappy-gzip-or-zstandard = keine, Snappy, gzip oder Zstandard
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

text-matlab-v5-or-v7-3-hdf5-tdms-or-parquet = Text, MATLAB v5 oder v7.3, HDF5, TDMS oder Parquet
the-file-is-empty = die Datei ist leer
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
numbers-of-16-bytes = Zahlen von 16 Byte
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
