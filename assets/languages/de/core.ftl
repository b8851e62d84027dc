# Deutsch

## crates/core/src/base/files.rs

a-whole-number-from-0-to-4294967295 = eine ganze Zahl von 0 bis 4294967295
a-whole-number-from-0-on = eine ganze Zahl ab 0
a-list = eine Liste
a-list-of-3-numbers = eine Liste von 3 Zahlen
a-table = eine Tabelle
missing-field-field = Feld { $field } fehlt
unknown-field-field-expected-one-of-known = unbekanntes Feld { $field }, erwartet eines von { $known }
unknown-field-field-expected-known = unbekanntes Feld { $field }, erwartet { $known }
invalid-type-found-allowed-is-allowed = ungültiger Typ: { $found }, zulässig: { $allowed }
invalid-type-found-expected-expected = ungültiger Typ: { $found }, erwartet: { $expected }
invalid-value-found-allowed-is-allowed = ungültiger Wert: { $found }, zulässig: { $allowed }
invalid-value-found-expected-expected = ungültiger Wert: { $found }, erwartet: { $expected }
invalid-length-found-allowed-is-allowed = ungültige Länge { $found }, zulässig: { $allowed }
invalid-length-found-expected-expected = ungültige Länge { $found }, erwartet: { $expected }
problem-at-line-line-column-column = { $problem } in Zeile { $line } Spalte { $column }
not-json-problem = kein JSON: { $problem }
problem-at-line-line = { $problem } in Zeile { $line }
not-toml-problem = kein TOML: { $problem }

## crates/core/src/base/formula/certificate.rs

given-ranges-were-given-for-needed-inputs = { $given } Bereiche für { $needed } Eingänge angegeben
the-range-low-high-of-name-is-none-allowed-i = der Bereich { $low }..{ $high } von `{ $name }` ist keiner: zulässig ist unten <= oben
its-slope-may-be-of-either-sign = ihre Steigung kann beide Vorzeichen haben

## crates/core/src/base/formula/error.rs

column-column-problem = Spalte { $column }: { $problem }

## crates/core/src/base/formula/interval.rs

there-is-no-such-input = diesen Eingang gibt es nicht
it-may-be-too-large-for-a-number = sie kann für eine Zahl zu groß sein
the-logarithm-of-0-or-a-negative-number = Logarithmus von 0 oder einer negativen Zahl
the-root-of-a-negative-number = Wurzel einer negativen Zahl
a-division-by-0 = Division durch 0
t-0-to-a-power-that-is-not-positive = 0 hoch einen nicht positiven Exponenten
a-negative-number-to-a-power-that-is-not-who = negative Zahl hoch einen nicht ganzen Exponenten

## crates/core/src/base/formula/mod.rs

the-formula-is-nested-more-than-n-deep =
    { $n ->
        [one] die Formel ist tiefer als { $n } Ebene geschachtelt
       *[other] die Formel ist tiefer als { $n } Ebenen geschachtelt
    }
the-formula-has-n-nodes-allowed-are-most = die Formel hat { $n } Knoten: zulässig sind { $most }
there-is-no-input-input-there-are-n = es gibt keinen Eingang { $input }: es gibt { $n }
the-derivative-by-input-cannot-be-written-pr = die Ableitung nach `{ $input }` lässt sich nicht schreiben: { $problem }
name-is-no-name-of-an-input-allowed-is-any-w = `{ $name }` ist kein Name eines Eingangs: zulässig ist jeder ohne `"`
two-inputs-have-the-name-name = zwei Eingänge heißen `{ $name }`
the-formula-reads-input-input-there-are-n = die Formel liest Eingang { $input }: es gibt { $n }
the-formula-has-the-number-number-allowed-ar = die Formel enthält die Zahl { $number }: zulässig sind endliche
the-constant-name-is-value-allowed-are-finit = die Konstante `{ $name }` ist { $value }: zulässig sind endliche
name-is-an-input-and-a-constant = `{ $name }` ist Eingang und Konstante
a-minus-sign-before-a-number-write-a-negativ = ein Minus vor einer Zahl: eine negative Zahl schreiben

## crates/core/src/base/formula/parse.rs

the-formula-has-n-bytes-allowed-are-most = die Formel hat { $n } Byte: zulässig sind { $most }
expected-an-operator-or-the-end = erwartet: ein Operator (+ - * / ^) oder das Ende
expected-a-number-a-name-a-function-or = erwartet: eine Zahl, ein Name, eine Funktion oder `(`
expected-or-an-operator = erwartet: `)` oder ein Operator (+ - * / ^)
expected-behind-the-function-name = erwartet: `(` hinter der Funktion `{ $name }`
expected-but-the-formula-ends-here = { $expected }, aber die Formel endet hier
expected-but-found-found = { $expected }, aber gefunden: `{ $found }`
a-number-has-a-decimal-point-not-a-comma = eine Zahl hat einen Dezimalpunkt, kein Komma
a-product-needs-its = ein Produkt braucht sein `*`
a-quoted-name-without-its-end = ein Name in Anführungszeichen ohne Ende
sign-has-no-meaning-in-a-formula-allowed-are = `{ $sign }` bedeutet in einer Formel nichts: zulässig sind + - * / ^ ( )
the-number-is-too-large = die Zahl ist zu groß
this-is-no-number = das ist keine Zahl
the-formula-has-more-than-n-nodes = die Formel hat mehr als { $n } Knoten
unknown-function-name-the-natural-logarithm = unbekannte Funktion `{ $name }`: der natürliche Logarithmus ist `ln`
unknown-function-name-did-you-mean-near = unbekannte Funktion `{ $name }`: ist `{ $near }` gemeint?
unknown-name-name-did-you-mean-near = unbekannter Name `{ $name }`: ist `{ $near }` gemeint?
unknown-function-name-known-are-names = unbekannte Funktion `{ $name }`: bekannt sind { $names }
unknown-name-name-known-are-names = unbekannter Name `{ $name }`: bekannt sind { $names }

## crates/core/src/base/formula/unit.rs

the-unit-unit-ends-with = die Einheit `{ $unit }` endet mit `/`
unit-is-no-unit-a-power-is-a-number-as-in-mm = `{ $unit }` ist keine Einheit: eine Potenz ist eine Zahl, wie in mm^2
unit-is-no-unit-known-are-known = `{ $unit }` ist keine Einheit: bekannt sind { $known }

## crates/core/src/base/formula/units.rs

given-units-were-given-for-needed-inputs = { $given } Einheiten für { $needed } Eingänge angegeben
the-formula-has-the-unit-unit-but-its-result = die Formel hat die Einheit { $unit }, ihr Ergebnis soll aber { $wanted } haben
name-needs-a-plain-number-but-this-has-the-u = `{ $name }` braucht eine reine Zahl, dies hat aber die Einheit { $unit }
cannot-add-second-to-first = { $second } lässt sich nicht zu { $first } addieren
cannot-subtract-second-from-first = { $second } lässt sich nicht von { $first } subtrahieren
an-exponent-is-a-plain-number-but-this-has-t = ein Exponent ist eine reine Zahl, dieser hat aber die Einheit { $unit }
with-an-exponent-that-changes-the-base-must = bei veränderlichem Exponenten muss die Basis eine reine Zahl sein, sie hat aber die Einheit { $unit }

## crates/core/src/base/network/file.rs

note-is-n-bytes-long-allowed-is-at-most-most = `note` ist { $n } Byte lang: zulässig sind höchstens { $most }
activation-cannot-be-found-allowed-is-ids = `activation`: { $found } unzulässig; zulässig: { $ids }
low-and-high-must-be-equally-long-found-lows = `{ $low }` und `{ $high }` müssen gleich lang sein, gefunden { $lows } und { $highs }
longer-than-n-bytes = länger als { $n } Byte

## crates/core/src/base/network/mod.rs

sizes-must-be-2-to-layers-layers-of-1-to-neu = `sizes` muss aus 2 bis { $layers } Schichten mit 1 bis { $neurons } Neuronen bestehen
weights-holds-n-numbers-needed-are-needed = `weights` hat { $n } Zahlen, nötig sind { $needed }
weights-index-is-weight-it-must-be-finite = `weights[{ $index }]` ist { $weight }: muss endlich sein

## crates/core/src/base/network/scaling.rs

name-must-hold-needed-values-each-found-foun = `{ $name }` muss je { $needed } Werte haben, gefunden { $found }
xmin-index-and-xmax-index-are-low-and-high-t = `xmin[{ $index }]` und `xmax[{ $index }]` sind { $low } und { $high }: Sie müssen endlich und aufsteigend sein, positiv, wo `ln_inputs` true ist
ymin-index-and-ymax-index-must-be-finite-and = `ymin[{ $index }]` und `ymax[{ $index }]` müssen endlich und aufsteigend sein
norm-lo-norm-hi-and-target-lo-target-hi-must = `norm_lo`, `norm_hi` und `target_lo`, `target_hi` müssen aufsteigen

## crates/core/src/base/settings/error.rs

unknown-setting-path-did-you-mean-near = unbekannte Einstellung `{ $path }`; ist `{ $near }` gemeint?
unknown-setting-path-list-prints-all-setting = unbekannte Einstellung `{ $path }`; `list` zeigt alle Einstellungen
path-cannot-be-value-allowed-is-allowed = `{ $path }`: { $value } unzulässig; zulässig: { $allowed }

## crates/core/src/base/settings/kind.rs

a-number-from-min-to-max-unit = eine Zahl von { $min } bis { $max }{ $unit }
a-whole-number-from-min-to-max-unit = eine ganze Zahl von { $min } bis { $max }{ $unit }
true-or-false = true oder false
one-of-ids = eines von { $ids }
text-of-at-most-n-characters = Text von höchstens { $n } Zeichen

## crates/core/src/base/text.rs

it-is-utf-32-save-it-as-utf-8 = es ist UTF-32: als UTF-8 speichern
it-is-utf-16-with-half-a-character-in-it-sav = es ist UTF-16 mit einem halben Zeichen darin: als UTF-8 speichern
it-is-no-text-but-an-archive-or-a-spreadshee = es ist kein Text, sondern ein Archiv oder eine Tabellenkalkulation: die Tabelle als CSV speichern
it-is-no-text-byte-0x-byte-in-line-line = es ist kein Text: Byte 0x{ $byte } in Zeile { $line }
it-is-not-utf-8-byte-0x-byte-in-line-line-bu = es ist kein UTF-8 (Byte 0x{ $byte } in Zeile { $line }), vielleicht aber Latin-1 oder Windows-1252, wo es { $letter } ist: als UTF-8 speichern
it-is-not-utf-8-byte-0x-byte-in-line-line-bu-2 = es ist kein UTF-8 (Byte 0x{ $byte } in Zeile { $line }), vielleicht aber Windows-1252: als UTF-8 speichern
it-is-utf-16-little-endian-without-a-byte-or = es ist UTF-16 (Little Endian) ohne Byte Order Mark: als UTF-8 speichern
it-is-utf-16-big-endian-without-a-byte-order = es ist UTF-16 (Big Endian) ohne Byte Order Mark: als UTF-8 speichern

## crates/core/src/blocks/cnc/overload.rs

the-machine-stopped-at-time-s-position-mm-fo = Die Maschine hielt bei { $time } s, { $position } mm: { $force } N, zulässig { $limit } N; das Werkzeug ist vom Werkstück abgehoben
the-machine-stopped-at-time-s-position-mm-fo-2 = Die Maschine hielt bei { $time } s, { $position } mm: { $force } N, zulässig { $limit } N

## crates/core/src/blocks/control/adjustable_pi.rs

stute-and-goetz-cited-in-combined-system-200 = Stute und Goetz, zitiert in Kombiniertes System 2005; Verstärkungen gewählt, K durch rekursive kleinste Quadrate mit Vergessen

## crates/core/src/blocks/control/afc/mod.rs

after-heidenhain-s-adaptive-feed-control-afc = nach Heidenhains adaptiver Vorschubregelung (AFC), nur in Worten; F_1 aus dem Lehrschnitt, Raten, Luft- und Eintrittsvorschub gewählt
f-m-measured-n-no-reference-for-cut-cut = F_m = { $measured } N; keine Referenz für Schnitt { $cut }
teach-in = Lehrschnitt
watching = überwacht
u-goes-to-limit-f-1-f-m-low-high = u geht nach limit(F_1 / F_m, { $low } %, { $high } %)

## crates/core/src/blocks/control/constant_feed.rs

conventional-milling-which-every-paper-compa = herkömmliches Fräsen, mit dem jeder Artikel vergleicht

## crates/core/src/blocks/control/division.rs

combined-system-2005-divisional-controller-i = Kombiniertes System 2005, Divisionsregler, nur in Worten: die Lesart, die stabil und so ungenau wie in seiner Tabelle 1 ist
chosen-the-divisional-controller-of-2005-ove = gewählt: der Divisionsregler von 2005 über dem erreichten Vorschub
chosen-the-divisional-controller-of-2005-ove-2 = gewählt: der Divisionsregler von 2005 über seinem letzten Sollwert

## crates/core/src/blocks/control/mrac.rs

landau-and-lozano-s-direct-form-as-daneshmen = direkte Form nach Landau und Lozano, wie Daneshmend und Pak und Tomizuka, zitiert in Kombiniertes System 2005, sie verwendeten; Zahlen gewählt
chosen-model-reference-adaptive-control-of-c = gewählt: adaptive Regelung mit Referenzmodell aus Kombiniertes System 2005 mit einer Verstärkung
u-from-five-adapted-parameters = u aus fünf adaptierten Parametern θ φ

## crates/core/src/blocks/control/preview/mod.rs

chosen-a-kalman-filter-of-the-gain-g-over-th = gewählt: ein Kalman-Filter der Verstärkung g über dem angenommenen Teil; kein Artikel druckt es

## crates/core/src/blocks/control/proportional.rs

tlusty-and-elbestawi-cited-in-combined-syste = Tlusty und Elbestawi, zitiert in Kombiniertes System 2005; Verstärkungen gewählt

## crates/core/src/blocks/control/script/mod.rs

update-gave-kind-allowed-is-a-number-the-fee = `update` gab `{ $kind }`: erlaubt ist eine Zahl, der Vorschub-Override in Prozent, oder eine Zuordnung mit { $names }
name-that-update-gave-is-no-number = `{ $name }`, das `update` gab, ist keine Zahl
update-gave-name-which-nothing-takes-allowed = `update` gab `{ $name }`, das nichts annimmt: erlaubt sind { $names }
name-came-to-value-which-is-no-finite-number = `{ $name }` ergab { $value }, das ist keine endliche Zahl
more-than-n-steps-in-one-control-period-an-e = mehr als { $n } Schritte in einer Regelperiode: eine Endlosschleife?
a-script-of-one-s-own = ein eigenes Skript

## crates/core/src/blocks/control/script/program.rs

line-line-what = Zeile { $line }: { $what }
it-has-n-bytes-at-most-most-are-allowed = es hat { $n } Bytes: höchstens { $most } sind erlaubt
function-name-has-n-parameters-one-is-allowe = die Funktion `{ $name }` hat { $n } Parameter: erlaubt ist einer, `{ $name }({ $parameter })`
there-is-no-function-update-now-which-gives = es fehlt die Funktion `update(now)`, die den Befehl gibt
something-stands-outside-of-its-functions-no = etwas steht außerhalb der Funktionen: erlaubt sind nur Funktionen
a-script-with-a-function-update-now-at-most = ein Skript mit einer Funktion `update(now)`, höchstens { $n } Bytes
this-script-problem = dieses Skript ({ $problem })

## crates/core/src/blocks/control/sdnrp.rs

sdnrp-2007-figures-lost-the-reading-that-fit = SDNRP 2007, Abbildungen verloren: die Lesart, die zu Text und Tabelle 3 passt
control-strategy-2013-steps-5-to-7-in-words = Regelungsstrategie 2013, Schritte 5 bis 7, nur in Worten: gelesen wie in SDNRP 2007

## crates/core/src/blocks/control/tracking.rs

chosen-internal-model-control-with-a-smith-p = gewählt: Internal Model Control mit Smith-Prädiktor; kein Artikel druckt es
g-follows-f-m-model-predicted-f-n-with-a-tim = g folgt F_m / { $model }(vorhergesagte f, n) mit einer Zeitkonstante von { $time } s
f-c-n-c-from-model-4-f-c-n-c-u-on-the-line-o = f_c, n_c aus { $model_4 }(f_c, n_c) = u auf der Linie von { $model_2 } und { $model_3 }
model-3-and-the-inverse-of-model-4-within-th = { $model_3 } und das Inverse von { $model_4 } in ihren Bereichen
what-rounding-to-whole-takes-is-added-to-the = was das Runden auf ganze % nimmt, kommt zur nächsten Forderung hinzu: Das Mittel ist wie gefordert
t-1-is-feed-mm-min-and-speed-1-min = 1 % sind { $feed } mm/min und { $speed } 1/min
gain-gain = Verstärkung { $gain }

## crates/core/src/blocks/control/unks/mod.rs

combined-system-2005-unks-after-kawato-s-hie = Kombiniertes System 2005: UNKS, nach Kawatos hierarchischem Schema; Gewichte und Raten wurden nie veröffentlicht
feedback-error-learning-miyamoto-kawato-seto = Feedback-Error-Learning (Miyamoto, Kawato, Setoyama, Suzuki 1988), auf dem UNKS aus Kombiniertes System 2005 beruht

## crates/core/src/blocks/cutting/breakage.rs

the-tool-broke-at-time-s-position-mm-by-too = Das Werkzeug brach bei { $time } s, { $position } mm durch zu dicken Span, { $load } mm: Es hält { $stands } mm aus
the-tool-broke-at-time-s-position-mm-by-too-2 = Das Werkzeug brach bei { $time } s, { $position } mm durch zu große Kraft, { $load } N: Es hält { $stands } N aus

## crates/core/src/blocks/cutting/crash.rs

the-tool-crashed-at-time-s-position-mm-a-fee = Das Werkzeug kollidierte bei { $time } s, { $position } mm: Ein Vorschub von { $feed } mm/min bei { $speed } 1/min ist je Zahn mehr als der Radius des Fräsers, { $radius } mm

## crates/core/src/blocks/cutting/force_model/formula.rs

sdnrp-2007-eq-7-ck45-a-d-2-mm-r-d-3-mm-sharp = SDNRP 2007, Gl. 7 (Ck45, A_D 2 mm, R_D 3 mm, scharfes Werkzeug)
control-strategy-2013-eq-5-the-paper-then-ta = Regelungsstrategie 2013, Gl. 5; der Artikel nimmt dann sein neuronales Netz an ihrer Stelle
a-formula = eine Formel
f-from-feed-mm-min-on-its-least-force-n-from = f ab { $feed } mm/min (ihre kleinste Kraft), n ab { $speed } 1/min
of-the-papers-cutter-alone = nur des Fräsers der Artikel
of-the-cutter-cutter-alone = nur des Fräsers { $cutter }
f-least-feed-to-most-feed-mm-min-n-least-spe = f { $least_feed } bis { $most_feed } mm/min, n { $least_speed } bis { $most_speed } 1/min; darüber hinaus geradlinig

## crates/core/src/blocks/cutting/force_model/mechanistic.rs

combined-system-2005-fig-3-lost-as-ball-end = Kombiniertes System 2005, Bild 3 (verloren), als Kugelfräsergeometrie nach Lee und Altintas
combined-system-2005-eq-1-compliance-with-th = Kombiniertes System 2005, Gl. 1: Nachgiebigkeit mit der Verzögerung einer Zahnperiode
kienzle-s-laws-tangential-radial-and-axial-c = Kienzle-Gesetze, tangential, radial und axial (Konstanten aus veröffentlichten Tabellen, zum Teil gewählt)
by-teeth = nach Zähnen
f-t-feed-teeth-speed-chip-mm-run-out-runout = f_t = { $feed } / ({ $teeth } · { $speed }) = { $chip } mm, Rundlauffehler ± { $runout } mm
f-largest-f-x-2-f-y-2-of-a-control-period = F = größte √(F_x^2 + F_y^2) eines Regeltakts
f-force-n-with-vibration-shaken-n-a-d-axial = F = { $force } N; mit Schwingung { $shaken } N  (A_D { $axial } mm, R_D { $radial } mm)

## crates/core/src/blocks/cutting/force_model/network_card.rs

f-x-f-y-f-z-factor-nn-inputs = F_x, F_y, F_z = { $factor }NN(Eingänge)
f-xy-f-x-2-f-y-2-at-the-instant-of-its-large = F_{ "{" }xy{ "}" } = √(F_x^2 + F_y^2), im Augenblick ihres größten Werts
f-feed-mm-min-n-speed-1-min-r-d-radial-mm-a = f { $feed } mm/min, n { $speed } 1/min, R_D { $radial } mm, A_D { $axial } mm, Werkstoff { $material }, { $hardness } HB, D { $diameter } mm, Geometrie { $geometry }
feed-per-tooth-2 = Zahnvorschub
cutting-speed-2 = Schnittgeschwindigkeit
geometry = Geometrie
name-value-unit-trained-on-range = { $name } { $value } { $unit }, trainiert auf { $range }
this-cutter-trained-on-ball-ends-with-two-te = dieser Fräser, trainiert auf Kugelfräsern mit zwei Zähnen und dem Drall der Artikel
material-at-hardness-hb-trained-on-materials = { $material } bei { $hardness } HB, trainiert auf { $materials }
rows-rows-epochs-epochs-seed-seed = { $rows } Zeilen, { $epochs } Epochen, Startwert { $seed }

## crates/core/src/blocks/cutting/force_model/neural.rs

control-strategy-2013-section-2-3-8-inputs-1 = Regelungsstrategie 2013, Abschnitt 2.3: 8 Eingänge, 15 verdeckte Neuronen, 3 Ausgänge; seine Gewichte wurden nie veröffentlicht

## crates/core/src/models/disturbances/mod.rs

factor = Faktor
times-the-force = { " " }mal die Kraft
change-2 = Änderung
mm-deeper = { " " }mm tiefer
wear-land = Verschleißmarke
mm-more-vb = { " " }mm mehr VB
amplitude = Amplitude
of-the-force = { " " }% der Kraft
offset = Versatz
n-in-the-end = { " " }N am Ende
addition = Zuschlag
s-longer = { " " }s länger
override = Override
of-the-feed = { " " }% des Vorschubs

## crates/core/src/models/disturbances/placed.rs

position-mm = Position mm
positions-ascending-from-0-to-most-mm = Positionen aufsteigend von 0 bis { $most } mm
length-mm = Länge mm
lengths-from-least-to-most-mm = Längen von { $least } bis { $most } mm
size-from-least-to-most-unit = { $size } von { $least } bis { $most } { $unit }
at-most-n-lists-entries-ranges =
    { $n ->
        [one] höchstens { $n } Liste [{ $entries }], { $ranges }
       *[other] höchstens { $n } Listen [{ $entries }], { $ranges }
    }

## crates/core/src/models/formula_model/file.rs

tool-cannot-be-id-allowed-is-one-of-ids = `tool`: `{ $id }` unzulässig; zulässig: eines von { $ids }
n-bytes-at-most-most-are-read = { $n } Byte; höchstens { $most } werden gelesen
version-cannot-be-version-allowed-is-known = `version`: { $version } unzulässig; zulässig: { $known }
inputs-index-the-range-low-to-high-of-name-i = `inputs[{ $index }]`: Der Bereich { $low } bis { $high } von `{ $name }` ist keiner: zulässig ist unten kleiner als oben

## crates/core/src/models/formula_model/fit.rs

rows-cannot-be-rows-allowed-is-more-than-the = `rows`: { $rows } unzulässig; zulässig: mehr als die { $n } Konstanten
deviation-cannot-be-deviation-allowed-is-0-o = `deviation`: { $deviation } unzulässig; zulässig: 0 oder mehr
constants-cannot-have-constant-allowed-are-n = `constants`: { $constant } unzulässig; zulässig: Zahlen der Formel, von links nach rechts
covariance-is-none-of-n-constants-allowed-is = `covariance` passt nicht zu { $n } Konstanten: zulässig ist ein unteres Dreieck endlicher Zahlen, auf der Diagonale keine unter 0

## crates/core/src/models/formula_model/mod.rs

n-inputs-allowed-are-at-most-most = { $n } Eingänge: zulässig sind höchstens { $most }
the-inputs-are-not-those-of-the-formula = die Eingänge sind nicht die der Formel
first-and-last = { $first } und { $last }
the-formula-has-no-bounds-on-its-ranges = die Formel hat auf ihren Bereichen keine Schranken
its-slope-by-input-slope-has-no-bounds-on-it = ihre Steigung nach `{ $input }`, { $slope }, hat auf ihren Bereichen keine Schranken
name-from-low-to-high = `{ $name }` von { $low } bis { $high }
the-formula-is-not-certain-to-have-a-finite = die Formel hat auf ihren Bereichen nicht sicher einen endlichen Wert: für { $place }, { $why }
its-slope-by-input-slope-is-not-certain-to-h = ihre Steigung nach `{ $input }`, { $slope }, hat auf ihren Bereichen nicht sicher einen endlichen Wert: für { $place }, { $why }

## crates/core/src/models/formula_model/setting.rs

name-in-unit = `{ $name }` in { $unit }
it-makes-output-of-inputs-allowed-is-wanted = { $output } aus { $inputs }: zulässig ist { $wanted } aus { $of }
nothing-or-the-text-of-a-formula-s-model-fil = nichts oder der Text der Modelldatei einer Formel: { $wanted } aus { $of }, endlich auf ihren Bereichen
this-text-problem = dieser Text ({ $problem })

## crates/core/src/models/genetic/model_file.rs

name-turns-round-within-low-high-allowed-is = `{ $name }` kehrt innerhalb { $low }..{ $high } um: zulässig ist eine monotone Kurve
name-field-cannot-be-value-allowed-is-a-fini = `{ $name }.{ $field }`: { $value } unzulässig; zulässig: eine endliche Zahl

## crates/core/src/models/neural_force/mod.rs

sizes-cannot-be-sizes-allowed-is-8-1-to-most = `sizes`: { $sizes } unzulässig; zulässig: 8, 1 bis { $most } und 3 Neuronen

## crates/core/src/models/part/shapes.rs

at-most-n-pairs-position-mm-depth-mm-positio =
    { $n ->
        [one] höchstens { $n } Paar [Position mm, Tiefe mm], Positionen aufsteigend von 0 bis { $position }, Tiefen von 0 bis { $depth }
       *[other] höchstens { $n } Paare [Position mm, Tiefe mm], Positionen aufsteigend von 0 bis { $position }, Tiefen von 0 bis { $depth }
    }
at-most-n-cuts-of-1-to-sections-sections-len =
    { $n ->
        [one] höchstens { $n } Schnitt mit 1 bis { $sections } Abschnitten [Länge mm, axiale Schnitttiefe mm, Wand mm], Längen von { $shortest } bis { $length }, Tiefen von 0 bis { $depth }, Wände von -{ $depth } bis { $depth }
       *[other] höchstens { $n } Schnitte mit 1 bis { $sections } Abschnitten [Länge mm, axiale Schnitttiefe mm, Wand mm], Längen von { $shortest } bis { $length }, Tiefen von 0 bis { $depth }, Wände von -{ $depth } bis { $depth }
    }
at-most-n-numbers-one-for-each-cut-from-min =
    { $n ->
        [one] höchstens { $n } Zahl, eine je Schnitt, von { $min } bis { $max }{ $unit }
       *[other] höchstens { $n } Zahlen, eine je Schnitt, von { $min } bis { $max }{ $unit }
    }

## crates/core/src/models/structure/parameters.rs

base-console = Gestell
tooth = Zahn
slides = Schlitten
table-2 = Tisch

## crates/core/src/models/structure/reduction.rs

n-modes-across-the-feed-in-a-running-cut = { $n } Moden quer zum Vorschub im laufenden Schnitt
t-1-to-4-modes-across-the-feed-which-the-surfa = 1 bis 4 Moden quer zum Vorschub, die die Oberfläche sieht

## crates/core/src/models/tip_modes/file.rs

structure-file = Strukturdatei
line-line-entry-cannot-be-value-allowed-is-a = Zeile { $line }: `{ $entry }` kann nicht { $value } sein: erlaubt ist { $allowed }
x-or-y = x oder y
mode-place-one-of-mass-kg-and-stiffness-n-m = Mode { $place }: genau eines von `mass_kg` und `stiffness_n_m` wird gebraucht
what-makes-a-modal-mass-from-low-to-high-kg = was bei dieser Frequenz eine modale Masse von { $low } bis { $high } kg ergibt
a-number-from-low-to-high = eine Zahl von { $low } bis { $high }
text-of-n-characters = ein Text von { $n } Zeichen
text-of-1-to-n-characters = ein Text von 1 bis { $n } Zeichen
there-is-no-mode-at-least-one-mode-is-wanted = es gibt keine Mode: mindestens ein `[[mode]]` wird gebraucht

## crates/core/src/models/tip_modes/mod.rs

n-modes-allowed-are-at-most-most = { $n } Moden: erlaubt sind höchstens { $most }
mode-place-entry-cannot-be-value-allowed-is = Mode { $place }: `{ $entry }` kann nicht { $value } sein: erlaubt ist eine Zahl von { $low } bis { $high }
at-most-n-lists-axis-frequency-damping-ratio = höchstens { $n } Listen [Achse, Frequenz, Dämpfungsgrad, modale Masse]: Achse 0 für x oder 1 für y, { $f0 } bis { $f1 } Hz, { $d0 } bis { $d1 }, { $m0 } bis { $m1 } kg

## crates/core/src/models/tool/file.rs

tool-file = Werkzeugdatei
key-must-be-text-of-1-to-n-characters = `{ $key }` muss ein Text mit 1 bis { $n } Zeichen sein
key-is-missing = `{ $key }` fehlt
version-version-is-missing = `version = { $version }` fehlt
key-is-missing-allowed = `{ $key }` fehlt: { $allowed }
unknown-entry-key-there-are-version-title-so = unbekannter Eintrag `{ $key }`; es gibt version, title, source, { $known }
line-line-corner-radius-mm-cannot-be-radius = Zeile { $line }: `corner_radius_mm` kann nicht { $radius } mm sein: erlaubt ist höchstens die Hälfte von `diameter_mm`, { $most } mm

## crates/core/src/models/transfer/setting.rs

stable-poles-real-parts-from-slowest-down-to = stabile Pole: Realteile von { $slowest } bis { $fastest } rad/s, Imaginärteile von 0 bis { $largest } rad/s, Ordnung höchstens { $n }
pole-place-cannot-be-re-and-im-rad-s-allowed = Pol { $place } kann nicht { $re } und { $im } rad/s sein: erlaubt ist { $allowed }
the-order-cannot-be-order-allowed-is-allowed = die Ordnung kann nicht { $order } sein: erlaubt ist { $allowed }
lists-real-imaginary-of-poles = Listen [Realteil, Imaginärteil]: { $poles }

## crates/core/src/models/unks/stored.rs

start-cannot-be-found-allowed-is-one-of-ids = `start`: { $found } unzulässig; zulässig: eines von { $ids }
sizes-cannot-be-sizes-allowed-is-allowed = `sizes`: { $sizes } unzulässig; zulässig: { $allowed }
nothing-or-the-text-of-a-file-that-steadycut = nichts oder der Text einer Datei, die `steadycut unks --save` schreibt: endliche Gewichte von NM-R 2-12-1, NM-1 4-8-1, NM-2 4-8-1

## crates/core/src/models/unks.rs

name-sizes-cannot-be-sizes-allowed-is-allowe = { $name }: `sizes`: { $sizes } unzulässig; zulässig: { $allowed }

## crates/core/src/run/closed_loop/mod.rs

signal-is-not-finite-at-tick-tick-the-run-en = `{ $signal }` ist bei Schritt { $tick } nicht endlich: Der Lauf endet
the-script-failed-at-time-s-problem-the-run = Das Skript ist bei { $time } s gescheitert, { $problem }: Der Lauf endet

## crates/core/src/run/constant_feed_twin.rs

safe-constant-feed = sicherer konstanter Vorschub

## crates/core/src/run/diagram/mod.rs

reference = Führungsgröße
turns-the-target-roughness-into-the-cutting = Macht aus der Soll-Rauheit die Zerspankraft, die sie hinterlässt. Der Regelkreis hält dann diese Kraft: Eine konstante Kraft hält die Oberfläche konstant.
compares-the-measured-force-with-the-desired = Vergleicht in jedem Regeltakt die gemessene Kraft mit der Sollkraft und fordert Vorschub und Drehzahl. Die Modelle, mit denen er rechnet, sind seine Annahme: Es müssen nicht die des Schnitts sein.
limit-2 = Grenze
override-limits = Override-Grenzen
the-cnc-takes-commands-as-percent-of-the-pro = Die CNC nimmt Befehle als Prozent des programmierten Vorschubs (DNCFRO) und der Drehzahl (DNCSPO), innerhalb von Grenzen. Was der Regler darüber hinaus fordert, wird abgeschnitten; die Lampe zeigt es. Eine echte CNC nimmt ganze Prozent und geht mit einer Rate auf einen neuen Override: Beides lässt sich einschalten.
rate = Rate
the-plc-of-the-machine-passes-every-command = Die SPS der Maschine gibt jeden Befehl nach einer festen Zeit weiter. Jeder Punkt ist ein Befehl unterwegs; seine Höhe zeigt seine Größe neben den anderen.
the-servo-system-follows-the-command-with-th = Das Servosystem folgt dem Befehl mit der Verzögerung seiner Übertragungsfunktion, in jedem Schritt exakt berechnet.
the-spindle-follows-its-command-as-a-first-o = Die Spindel folgt ihrem Sollwert als Verzögerung erster Ordnung, die die Drehzahl nicht schneller als ihre Ratengrenze ändern kann.
cutting-process = Zerspanprozess
the-true-cut-maximum-cutting-force-from-feed = Der wahre Schnitt: größte Zerspankraft aus Vorschub und Drehzahl, mal dem, was das Modell nicht kennt: Werkstoff und Härte, Querschnitt des Schnitts, Werkzeugverschleiß.
dynamic-component = Dynamische Komponente
what-a-real-force-adds-to-the-model-band-lim = Was eine echte Kraft zum Modell hinzufügt: bandbegrenztes Rauschen, die Welligkeit der Zähne, langsame Änderungen des Werkstoffs entlang der Bahn; jede mit eigener Zufallsfolge.
contact = Kontakt
dynamometer = Dynamometer
the-force-sensor-reads-the-dynamic-force-onc = Der Kraftsensor: liest einmal je Regeltakt die dynamische Kraft und fügt sein eigenes Rauschen hinzu. Nur das sieht der Regler.
surface = Oberfläche
the-roughness-that-the-force-leaves-on-the-p = Die Rauheit, die die Kraft auf dem Teil hinterlässt, ohne Maschinendynamik. Identifizierte Modelle kehren das der Führungsgröße genau um, sodass eine auf dem Sollwert gehaltene Kraft die Soll-Rauheit hinterlässt.
the-roughness-with-machine-dynamics-the-same = Die Rauheit mit Maschinendynamik: dieselbe Gleichung, gespeist mit der Kraft und ihrer dynamischen Komponente.

## crates/core/src/run/diagram/names.rs

the-controller-s-belief = die Annahme des Reglers
the-plant = die Strecke
own-formula = eigene Formel
now-whose-force = Jetzt, { $whose }: { $force }
now-whose-models-origin = Jetzt, { $whose }: { $models }, { $origin }
now-2 = Jetzt
force-for-a-target-ra-2 = Kraft zu einem Soll-Ra
feed-for-a-force-2 = Vorschub zu einer Kraft
speed-for-a-force-2 = Drehzahl zu einer Kraft
cutting-force = Zerspankraft
model-outside-its-range = { $model } außerhalb seines Bereichs

## crates/core/src/run/diagram/printed.rs

sdnrp-2007-eq-4 = SDNRP 2007, Gl. 4
sdnrp-2007-eq-5 = SDNRP 2007, Gl. 5
sdnrp-2007-eq-6 = SDNRP 2007, Gl. 6
sdnrp-2007-eq-8 = SDNRP 2007, Gl. 8
control-strategy-2013-eq-2 = Regelungsstrategie 2013, Gl. 2
control-strategy-2013-eq-3-10-05-can-only-be = Regelungsstrategie 2013, Gl. 3 („10^05“ kann nur 10^-5 sein)
control-strategy-2013-eq-4 = Regelungsstrategie 2013, Gl. 4
control-strategy-2013-eq-6 = Regelungsstrategie 2013, Gl. 6
a-drive-of-your-own-by-its-poles-and-gain = ein eigener Antrieb, nach Polen und Verstärkung
the-dead-time-of-the-command-channel-the-dri = die Totzeit des Befehlskanals; der Antrieb ist ein eigener
sdnrp-2007-eq-1-with-the-constants-of-its-ta = SDNRP 2007, Gl. 1, mit den Konstanten seiner Tabelle 1
sdnrp-2007-eq-2-the-sum-is-a-misprint-a-prod = SDNRP 2007, Gl. 2 (die Summe ist ein Druckfehler: Ein Produkt hat die Verstärkung 1)
sdnrp-2007-eq-3-the-drive-that-the-paper-sim = SDNRP 2007, Gl. 3: der Antrieb, mit dem der Artikel simuliert
control-strategy-2013-eq-1-natural-frequency = Regelungsstrategie 2013, Gl. 1 („natural frequency of 3 Hz“ passt nicht dazu)
second-order-natural-frequency-3-hz-settling = zweite Ordnung, Eigenfrequenz 3 Hz, Ausregelzeit 0,4 s
control-strategy-2013-section-2-2-measured-s = Regelungsstrategie 2013, Abschnitt 2.2: gemessene Sprungantworten, nur in Worten
sdnrp-2007-eq-2-and-3-the-text-s-t-8-s-is-a = SDNRP 2007, Gl. 2 und 3 („t = 8 s“ im Text ist ein Druckfehler)
control-strategy-2013-section-2-2-below-eq-1 = Regelungsstrategie 2013, Abschnitt 2.2, unter Gl. 1
control-strategy-2013-section-2-whole-percen = Regelungsstrategie 2013, Abschnitt 2; ganze Prozent und Rate: CNC-Praxis, gewählt
chosen-no-paper-gives-a-spindle-drive = gewählt: kein Artikel gibt einen Spindelantrieb an
sdnrp-2007-fig-10-lost-random-sized-like-mea = SDNRP 2007, Bild 10 (verloren): zufällig, bemessen wie gemessene Schwingungen; Form gewählt
sdnrp-2007-section-1-kistler-force-transduce = SDNRP 2007, Abschnitt 1: Kraftaufnehmer von Kistler; Rauschen gewählt

## crates/core/src/run/diagram/wires.rs

signal-after-dead-time = { $signal }, nach der Totzeit
symbol-delayed = { $symbol } verzögert

## crates/core/src/run/edits.rs

the-change-at-at-s-does-not-fit-any-more-rea = die Änderung bei { $at } s passt nicht mehr: { $reason }
changed-again = erneute Änderung
at-most-100000-changes-in-a-run = höchstens 100000 Änderungen in einem Lauf
a-change-of-the-scenario-itself-it-belongs-t = eine Änderung des Szenarios selbst: Es gehört zur Einrichtung
changed-during-the-run = Änderung während des Laufs
a-time-from-0-to-before-end-s = eine Zeit von 0 bis vor { $end } s
changed-at-at-s = Änderung bei { $at } s

## crates/core/src/run/explanation.rs

name-low-to-high-unit = { $name } { $low } bis { $high } { $unit }
straight-on-beyond = darüber hinaus geradlinig

## crates/core/src/run/job.rs

done-of-total-unit = { $unit }: { $done } von { $total }

## crates/core/src/run/packed.rs

its-packed-part-is-not-url-safe-base64-probl = ihr gepackter Teil ist kein URL-sicheres Base64: { $problem }
its-packed-part-unpacks-to-more-than-n-bytes = ihr gepackter Teil ergibt mehr als { $n } Byte, mehr wird nicht gelesen
its-packed-part-is-not-whole = ihr gepackter Teil ist nicht vollständig
text-that-is-not-utf-8 = Text, der kein UTF-8 ist

## crates/core/src/run/presets.rs

preset-name = Szenario `{ $name }`
there-is-none-of-this-name-there-are-names = keines heißt so; es gibt { $names }

## crates/core/src/run/scenario/rules.rs

formula-without-a-formula-for-the-plant = formula ohne Formel für die Strecke
formula-together-with-formula-force-or-formu = formula zusammen mit `formula.force` oder `formula.ra`: beides zugleich setzen, oder zuerst die Formel, und sie zuletzt wegnehmen
formula-without-a-formula = formula ohne Formel
formula-together-with-one-of-formula-force-o = formula zusammen mit einer von `formula.force_of_ra`, `formula.feed`, `formula.speed`, `formula.force`, `formula.ra`: beides zugleich setzen, oder zuerst die Formel, und sie zuletzt wegnehmen
at-most-cnc-speed-max-rpm-most-1-min = höchstens `cnc.speed_max_rpm`, { $most } 1/min
model-with-plant-steps-of-step-s = { $model } mit Streckenschritten von { $step } s
plant-steps-of-at-most-longest-s-run-steps-p = Streckenschritte von höchstens { $longest } s: `run.steps_per_control` ab { $steps } (576 ergeben 28,8 kHz)
n-modes-across-the-feed-with-machine-coupled = { $n } Moden quer zum Vorschub mit `machine.coupled` = true
t-1-to-4-modes-across-the-feed-axis-1-there-of = dort 1 bis 4 Moden quer zum Vorschub (Achse 1) mit höchstens { $most } Hz: zehn Schritte von 0,1 ms je Periode
parameters-with-machine-coupled-true-overdam = { $parameters } mit `machine.coupled` = true (überdämpfte Moden)
d-or-t-in-a-coupled-run = D oder T in einem gekoppelten Lauf
true-without-the-machine-s-sound = true ohne das Geräusch der Maschine
true-with-machine-coupled-true = true mit `machine.coupled` = true
networks-of-the-start-start = Netze des Starts `{ $start }`
networks-of-controller-unks-start-wanted-or = Netze von `controller.unks.start`, { $wanted }, oder keine; beides zugleich setzen
at-most-half-of-tool-diameter-mm-half-mm = höchstens die Hälfte von `tool.diameter_mm`, { $half } mm
at-most-tool-diameter-mm-diameter-mm = höchstens `tool.diameter_mm`, { $diameter } mm
n-broken-teeth =
    { $n ->
        [one] { $n } gebrochener Zahn
       *[other] { $n } gebrochene Zähne
    }
at-most-most-one-fewer-than-tool-teeth-teeth = höchstens { $most }, einer weniger als `tool.teeth`, { $teeth }
n-with-machine-coupled-true = { $n } mit `machine.coupled` = true
none-there-the-machine-s-regeneration-and-th = dort keine: Die Regeneration der Maschine und die Marken der Zähne zählen jeden Zahn
frequency-hz-with-bursts-and-plant-steps-of = { $frequency } Hz mit Ratterstößen und Streckenschritten von { $step } s
at-most-most-hz-three-steps-to-a-period-more = höchstens { $most } Hz, drei Schritte je Periode; mehr `run.steps_per_control` erlauben mehr
so-much-the-cut-would-be-deepest-mm-deep = so viel (der Schnitt wäre { $deepest } mm tief)
what-leaves-it-at-most-most-mm-deep-everywhe = was ihn überall höchstens { $most } mm tief lässt, mit `workpiece.axial_depth_mm` oder der Tiefe der Schnitte
below-noise-band-high-hz-high-hz = unter `noise.band_high_hz`, { $high } Hz
a-divisor-of-run-steps-per-control-steps-eve = ein Teiler von `run.steps_per_control`, { $steps }: Jede Abtastung wird aufgezeichnet
at-most-longest-s-with-a-row-every-row-s-row = höchstens { $longest } s bei einer Zeile alle { $row } s ({ $rows } Zeilen); mit `run.record_every` seltener aufzeichnen

## crates/core/src/run/scenario/unused.rs

controller-kind-is-another-one = `controller.kind` ist ein anderer
the-controller-does-not-ask-for-it-as-its-ot = der Regler fragt nicht danach, wie seine anderen Einstellungen stehen
the-controller-as-it-is-set-does-not-ask-for = der Regler, wie er eingestellt ist, fragt nicht danach
wear-curve-gives-the-wear-over-the-life = `wear.curve` gibt den Verschleiß über die Standzeit
wear-force-curve-gives-the-force-over-the-we = `wear.force_curve` gibt die Kraft über dem Verschleiß
wear-stiffness-curve-gives-the-stiffness-ove = `wear.stiffness_curve` gibt die Steifigkeit über dem Verschleiß
wear-life-curve-gives-the-life-over-the-cut = `wear.life_curve` gibt die Standzeit über dem Schnitt
target-reference-is-force = `target.reference` ist force
target-reference-is-ra = `target.reference` ist ra
belief-model-set-is-milling-2005-which-has-o = `belief.model_set` ist milling_2005, mit nur einer Kalibrierung
plant-model-set-is-milling-2005-which-has-on = `plant.model_set` ist milling_2005, mit nur einer Kalibrierung
belief-calibration-is-not-formula-or-belief = `belief.calibration` ist nicht formula, oder `belief.model_set` ist milling_2005
neither-belief-calibration-nor-plant-calibra = weder `belief.calibration` noch `plant.calibration`, wo `plant.force_model` formula ist, ist formula
neither-belief-calibration-nor-plant-calibra-2 = weder `belief.calibration` noch `plant.calibration` ist formula
tool-shape-is-no-bull-nose = `tool.shape` ist nicht bull_nose
only-the-off-line-plan-bends-the-cutter = nur der Offline-Plan biegt den Fräser
plant-force-model-is-a-map-not-mechanistic = `plant.force_model` ist ein Kennfeld, nicht mechanistic
machine-coupled-is-true-the-machine-is-what = `machine.coupled` ist true: Die Maschine gibt nach
plant-force-model-is-mechanistic-the-teeth-s = `plant.force_model` ist mechanistic: Die Kraft der Zähne hat keinen Achsenabschnitt
noise-level-is-0 = `noise.level` ist 0
noise-band-percent-is-0 = `noise.band_percent` ist 0
noise-inhomogeneity-percent-is-0 = `noise.inhomogeneity_percent` ist 0
nothing-is-random-noise-level-or-every-size = nichts ist zufällig: `noise.level` oder jede Rauschgröße ist 0
cnc-override-rate-limited-is-false = `cnc.override_rate_limited` ist false
feed-drive-poles-gives-the-drive = `feed_drive.poles` gibt den Antrieb an
feed-drive-poles-is-empty-the-papers-drives = `feed_drive.poles` ist leer: die Antriebe der Aufsätze haben die Verstärkung 1
spindle-drive-poles-gives-the-drive = `spindle_drive.poles` gibt den Antrieb an
spindle-drive-poles-is-empty-lag-and-rate-li = `spindle_drive.poles` ist leer: Verzögerung und Ratenbegrenzung haben die Verstärkung 1
cnc-force-stop-is-false = `cnc.force_stop` ist false
workpiece-cuts-is-empty = `workpiece.cuts` ist leer
program-cut-feeds-mm-min-programs-every-cut = `program.cut_feeds_mm_min` programmiert jeden Schnitt
workpiece-cuts-gives-lengths-and-depths = `workpiece.cuts` gibt Längen und Tiefen
machine-coupled-is-false-the-cut-does-not-fe = `machine.coupled` ist false: Der Schnitt spürt die Maschine nicht
machine-tip-modes-gives-the-machine = `machine.tip_modes` gibt die Maschine an
only-the-stability-chart-of-measured-modes-h = nur die Stabilitätskarte gemessener Moden hat es
machine-tip-modes-gives-the-machine-its-toot = `machine.tip_modes` gibt die Maschine an: ihr Zahn ist starr
wear-model-is-fixed = `wear.model` ist fixed
wear-model-is-fixed-the-tool-is-worn-by-dist = `wear.model` ist fixed: Das Werkzeug verschleißt nur durch `disturbances.wear_jumps`
machine-coupled-is-false-nothing-vibrates = `machine.coupled` ist false: Nichts schwingt
disturbances-chatter-bursts-is-empty = `disturbances.chatter_bursts` ist leer
wear-life-curve-gives-the-life-over-the-cut-2 = `wear.life_curve` gibt die Standzeit über dem Schnitt, und nichts passt die Drehzahl an
wear-indentation-n-mm3-is-0 = `wear.indentation_n_mm3` ist 0
wear-adjust-speed-is-false-or-wear-model-fix = `wear.adjust_speed` ist false, oder `wear.model` ist fixed
only-trends-over-the-tool-s-life-have-it-a-r = nur Verläufe über die Standzeit haben es; ein Lauf hat die Kraft seines eigenen Schnitts
ra-with-dynamics-in-the-running-cut-leaves-o = Ra mit Dynamik im laufenden Schnitt lässt Wellen unter 50 µm weg, was auch eingestellt ist
no-vibration-of-a-coupled-machine-makes-ra-w = keine Schwingung einer gekoppelten Maschine ergibt Ra mit Dynamik (`machine.coupled`, `machine.roughness_from`)
the-off-line-plan-has-it-not-a-run = der Offline-Plan hat es, kein Lauf
it-chooses-what-a-cut-is-compared-with-and-m = es wählt, womit ein Schnitt verglichen wird, und bewegt keinen

## crates/core/src/run/scenario_file.rs

scenario-file = Szenariodatei
version-is-version-this-program-reads-known = `version` ist { $version }; dieses Programm liest { $known }
path-and-now-are-one-setting-keep-now = `{ $path }` und `{ $now }` sind eine Einstellung; `{ $now }` behalten
edits-must-be-a-list-of-tables-with-at-s-a-n = `edits` muss eine Liste von Tabellen mit `at_s` (eine Zahl), `path` (Text) und `value` sein
unknown-field-edits-key-use-at-s-path-value = unbekanntes Feld `edits.{ $key }`; zulässig: at_s, path, value

## crates/core/src/run/scenario_link/series.rs

the-series-of-path-has-n-parts-not-4 =
    { $n ->
        [one] die Reihe von `{ $path }` hat { $n } Teil, nicht 4
       *[other] die Reihe von `{ $path }` hat { $n } Teile, nicht 4
    }
the-series-of-path-has-times-times-and-value = die Reihe von `{ $path }` hat { $times } Zeiten und { $values } Werte
the-series-of-path-has-decimals-decimals-all = die Reihe von `{ $path }` hat `{ $decimals }` Dezimalstellen; zulässig sind 0 bis { $most }
the-series-of-path-has-step-where-a-whole-nu = die Reihe von `{ $path }` hat `{ $step }`, wo eine ganze Zahl stehen muss

## crates/core/src/run/scenario_link.rs

it-is-packed-twice = er ist doppelt gepackt
link = Link
a-without-two-hexadecimal-digits = ein % ohne zwei Hexadezimalziffern
part-is-not-name-value = `{ $part }` ist nicht name=value
version-version-this-program-reads-known = Version { $version }; dieses Programm liest { $known }
v-version-is-missing = `v={ $version }` fehlt
at-key-names-no-setting = `at.{ $key }` nennt keine Einstellung
at-key-has-no-time-in-seconds = `at.{ $key }` hat keine Zeit in Sekunden

## crates/core/src/run/signals.rs

feed-at-a-limit = Vorschub an einer Grenze
speed-at-a-limit = Drehzahl an einer Grenze
feed-override-at-its-rate = Vorschub-Override an seiner Rate
spindle-override-at-its-rate = Spindel-Override an seiner Rate
tooth-out-of-contact = Zahn außer Eingriff
force-over-the-controller-s-limit = Kraft über der Grenze des Reglers
control-switched-off = Regelung ausgeschaltet
tooth-broken = Zahn gebrochen

## crates/core/src/run/story/changes.rs

on = ein
another-one = eine andere

## crates/core/src/run/story/effects.rs

it-was-unstable-stretches = Instabil war es { $stretches }.
it-chattered-stretches = Gerattert hat es { $stretches }.
the-cut-is-finished-length-of-path = Der Schnitt ist beendet: { $length } Bahn.
the-time-limit-ends-the-run-with-done-of-who = Die Zeitgrenze beendet den Lauf, { $done } von { $whole } gefräst.

## crates/core/src/run/story/mod.rs

start = Start
contact-2 = Kontakt
air-2 = Luft
depth-step-2 = Tiefensprung
disturbance = Störung
setting = Einstellung
chatter = Rattern
unstable = Instabil

## crates/core/src/run/story/words/lasting.rs

the-command-answers-command-after-the-start = Der Befehl antwortet { $command } nach dem Start, der Vorschub erst nach { $feed }, da der Befehlskanal { $dead } Totzeit hat
the-command-answers-command-after-contact-th = Der Befehl antwortet { $command } nach dem Kontakt, der Vorschub erst nach { $feed }, da der Befehlskanal { $dead } Totzeit hat
the-command-answers-command-after-the-step-t = Der Befehl antwortet { $command } nach dem Sprung, der Vorschub erst nach { $feed }, da der Befehlskanal { $dead } Totzeit hat
the-command-answers-command-after-the-change = Der Befehl antwortet { $command } nach der Änderung, der Vorschub erst nach { $feed }, da der Befehlskanal { $dead } Totzeit hat
the-command-answers-command-after-it-the-fee = Der Befehl antwortet { $command } danach, der Vorschub erst nach { $feed }, da der Befehlskanal { $dead } Totzeit hat
the-command-answers-command-after-this-the-f = Der Befehl antwortet { $command } danach, der Vorschub erst nach { $feed }, da der Befehlskanal { $dead } Totzeit hat
until-then-name-goes-size-below-its-target = bis dahin sinkt { $name } { $size } unter den Sollwert
until-then-name-goes-size-above-its-target = bis dahin steigt { $name } { $size } über den Sollwert
the-feed-command-stands-at-its-upper-limit-v = Der Vorschubsollwert steht an seiner oberen Grenze, { $value } ({ $share } % Override)
the-feed-command-stands-at-its-lower-limit-v = Der Vorschubsollwert steht an seiner unteren Grenze, { $value } ({ $share } % Override)
the-spindle-speed-command-stands-at-its-uppe = Der Drehzahlsollwert steht an seiner oberen Grenze, { $value } ({ $share } % Override)
the-spindle-speed-command-stands-at-its-lowe = Der Drehzahlsollwert steht an seiner unteren Grenze, { $value } ({ $share } % Override)
at-share-of-this-time = { $at }, { $share } % dieser Zeit
name-is-outside-the-model-meanwhile = { $name } liegt dabei außerhalb des Modells
meanwhile-name-is-size-below-its-target-with = dabei liegt { $name } { $size } unter dem Sollwert, innerhalb der Toleranz
meanwhile-name-is-size-below-its-target-outs = dabei liegt { $name } { $size } unter dem Sollwert, außerhalb der Toleranz
meanwhile-name-is-size-above-its-target-with = dabei liegt { $name } { $size } über dem Sollwert, innerhalb der Toleranz
meanwhile-name-is-size-above-its-target-outs = dabei liegt { $name } { $size } über dem Sollwert, außerhalb der Toleranz
meanwhile-ra-with-dynamics-is-size-below-its = dabei liegt Ra mit Dynamik { $size } unter dem Sollwert, innerhalb der Toleranz
meanwhile-ra-with-dynamics-is-size-below-its-2 = dabei liegt Ra mit Dynamik { $size } unter dem Sollwert, außerhalb der Toleranz
meanwhile-ra-with-dynamics-is-size-above-its = dabei liegt Ra mit Dynamik { $size } über dem Sollwert, innerhalb der Toleranz
meanwhile-ra-with-dynamics-is-size-above-its-2 = dabei liegt Ra mit Dynamik { $size } über dem Sollwert, außerhalb der Toleranz
meanwhile-ra-with-dynamics-is-outside-the-mo = dabei liegt Ra mit Dynamik außerhalb des Modells statt am Sollwert
without-dynamics-size-below-it = ohne Dynamik { $size } darunter
without-dynamics-size-above-it = ohne Dynamik { $size } darüber
the-model-of-the-force-for-a-target-ra-model = Das Modell der Kraft zu einem Soll-Ra ({ $model }) wird außerhalb dessen benutzt, wofür es gemacht ist: Seine Antwort ist eine Vermutung.
the-model-of-the-feed-for-a-force-model-is-u = Das Modell des Vorschubs zu einer Kraft ({ $model }) wird außerhalb dessen benutzt, wofür es gemacht ist: Seine Antwort ist eine Vermutung.
the-model-of-the-speed-for-a-force-model-is = Das Modell der Drehzahl zu einer Kraft ({ $model }) wird außerhalb dessen benutzt, wofür es gemacht ist: Seine Antwort ist eine Vermutung.
the-model-of-the-cutting-force-model-is-used = Das Modell der Zerspankraft ({ $model }) wird außerhalb dessen benutzt, wofür es gemacht ist: Seine Antwort ist eine Vermutung.
the-model-of-ra-model-is-used-outside-what-i = Das Modell von Ra ({ $model }) wird außerhalb dessen benutzt, wofür es gemacht ist: Seine Antwort ist eine Vermutung.
the-model-of-ra-with-dynamics-model-is-used = Das Modell von Ra mit Dynamik ({ $model }) wird außerhalb dessen benutzt, wofür es gemacht ist: Seine Antwort ist eine Vermutung.
the-model-of-the-force-for-a-target-ra-model-2 = Das Modell der Kraft zu einem Soll-Ra ({ $model }) wird außerhalb seines Bereichs benutzt
the-model-of-the-feed-for-a-force-model-is-u-2 = Das Modell des Vorschubs zu einer Kraft ({ $model }) wird außerhalb seines Bereichs benutzt
the-model-of-the-speed-for-a-force-model-is-2 = Das Modell der Drehzahl zu einer Kraft ({ $model }) wird außerhalb seines Bereichs benutzt
the-model-of-the-cutting-force-model-is-used-2 = Das Modell der Zerspankraft ({ $model }) wird außerhalb seines Bereichs benutzt
the-model-of-ra-model-is-used-outside-its-ra = Das Modell von Ra ({ $model }) wird außerhalb seines Bereichs benutzt
the-model-of-ra-with-dynamics-model-is-used-2 = Das Modell von Ra mit Dynamik ({ $model }) wird außerhalb seines Bereichs benutzt
the-target-ra-goes-to-value = das Soll-Ra geht auf { $value }
the-force-asked-for-goes-to-value = die Kraftvorgabe geht auf { $value }
the-feed-goes-to-value = der Vorschub geht auf { $value }
the-spindle-speed-goes-to-value = die Spindeldrehzahl geht auf { $value }
the-force-goes-to-value = die Kraft geht auf { $value }
the-force-with-dynamics-goes-to-value = die Kraft mit Dynamik geht auf { $value }
it-holds-from-low-to-high-unit = gültig von { $low } bis { $high } { $unit }
it-holds-from-low-unit-on = gültig ab { $low } { $unit }
it-holds-up-to-high-unit = gültig bis { $high } { $unit }
it-holds-elsewhere = gültig anderswo
it-ends-where-the-depth-changes = Es endet, wo sich die Tiefe ändert.
it-ends-where-the-tool-leaves-the-part = Es endet, wo das Werkzeug das Teil verlässt.
it-ends-while-the-depth-stays-the-same = Es endet bei gleich bleibender Tiefe.
it-goes-on-to-the-end = Es dauert bis zum Ende.
it-still-goes-on = Es dauert noch an.
chatter-at-depth-depth-and-speed-teeth-jump = Rattern bei { $depth } Tiefe und { $speed }: Zähne springen aus dem Schnitt, und die Kraft geht auf { $largest }, wo sie ohne Schwingung { $mean } wäre
chatter-at-depth-depth-and-speed-the-teeth-k = Rattern bei { $depth } Tiefe und { $speed }: Die Zähne bleiben im Eingriff, aber die Schwingung klingt nicht ab und hinterlässt Marken, bis ±{ $marks } µm von Zahn zu Zahn, und die Kraft geht auf { $largest }, wo sie ohne Schwingung { $mean } wäre
ra-is-with-where-it-would-be-without-without = Ra ist { $with }, wo es ohne sie { $without } wäre
the-tool-wears-from-from-to-to-of-its-life-s = Das Werkzeug verschleißt bisher von { $from } auf { $to } % seiner Standzeit
the-tool-wears-from-from-to-to-of-its-life-i = Das Werkzeug verschleißt in diesem Lauf von { $from } auf { $to } % seiner Standzeit
here-it-falls-by-size = hier sinkt sie um { $size }
here-it-grows-by-size = hier steigt sie um { $size }
the-force-falls-by-size = die Kraft sinkt um { $size }
the-force-grows-by-size = die Kraft steigt um { $size }
force-with-the-feed-kept-at-feed = { $force } bei gleich bleibendem Vorschub von { $feed }
force-while-the-feed-goes-from-from-to-to = { $force }, während der Vorschub von { $from } auf { $to } geht
at-safe-constant-feed-the-force-falls-by-siz = bei sicherem konstantem Vorschub sinkt die Kraft um { $size }
at-safe-constant-feed-the-force-grows-by-siz = bei sicherem konstantem Vorschub steigt die Kraft um { $size }
at-constant-feed-the-force-falls-by-size = bei konstantem Vorschub sinkt die Kraft um { $size }
at-constant-feed-the-force-grows-by-size = bei konstantem Vorschub steigt die Kraft um { $size }
unstable-feed-and-force-swing-without-dying = Instabil: Vorschub und Kraft schwingen, ohne abzuklingen (ein Grenzzyklus), mit einer Periode von { $period }, dem { $times }-Fachen der Totzeit von { $dead }; die Kraft um ±{ $force }, der Vorschub um ±{ $feed }.
unstable-feed-and-force-swing-without-dying-2 = Instabil: Vorschub und Kraft schwingen, ohne abzuklingen (ein Grenzzyklus), mit einer Periode von { $period }; die Kraft um ±{ $force }, der Vorschub um ±{ $feed }.
from-from-to-to-s = von { $from } bis { $to } s
n-times-first-up-to-last = { $n }-mal, zuerst { $first }, zuletzt { $last }
on-share-of-the-time-a-model-was-used-outsid = Auf { $share } der Zeit wurde ein Modell außerhalb seines Bereichs benutzt, wo es über das Gemessene hinaus fortgesetzt ist.
ra-lies-outside-its-model-on-the-whole-lengt = Ra liegt auf der ganzen Länge außerhalb seines Modells: Ob das Ziel gehalten wurde, ist nicht bekannt.
ra-with-dynamics-was-within-tolerance-of-its = Ra mit Dynamik lag auf { $share } der Länge innerhalb von ±{ $tolerance } % um den Sollwert
ra-without-dynamics-was-within-tolerance-of = Ra ohne Dynamik lag auf { $share } der Länge innerhalb von ±{ $tolerance } % um den Sollwert
ra-was-within-tolerance-of-its-target-on-sha = Ra lag auf { $share } der Länge innerhalb von ±{ $tolerance } % um den Sollwert
the-force-without-dynamics-was-within-tolera = Die Kraft ohne Dynamik lag auf { $share } der Länge innerhalb von ±{ $tolerance } % um ihre Referenz
the-force-was-within-tolerance-of-its-refere = Die Kraft lag auf { $share } der Länge innerhalb von ±{ $tolerance } % um ihre Referenz
within-without-dynamics-on-share = { $within } (ohne Dynamik auf { $share })
within-and-outside-for-time-at-the-longest = { $within }, und höchstens { $time } am Stück außerhalb
the-target-was-held-that-takes-share = der Sollwert wurde gehalten (dazu braucht es { $share } %)
the-target-was-not-held-that-takes-share = der Sollwert wurde nicht gehalten (dazu braucht es { $share } %)
with-unknown-of-it-outside-the-model-whether-3 = { $unknown } davon liegen außerhalb des Modells, ob der Sollwert gehalten wurde, ist nicht bekannt (dazu braucht es { $share } %)
the-reference-was-held-that-takes-share = die Referenz wurde gehalten (dazu braucht es { $share } %)
the-reference-was-not-held-that-takes-share = die Referenz wurde nicht gehalten (dazu braucht es { $share } %)
with-unknown-of-it-outside-the-model-whether-4 = { $unknown } davon liegen außerhalb des Modells, ob die Referenz gehalten wurde, ist nicht bekannt (dazu braucht es { $share } %)
too-rough-on-share-alone-elsewhere-smoother = zu rau nur auf { $share }, sonst glatter als verlangt

## crates/core/src/run/story/words.rs

a-hard-spot-begins-here-size-times-the-force = eine harte Stelle beginnt hier: das { $size }-Fache der Kraft über { $length }
a-gap-begins-here-over-length = eine Lücke beginnt hier: über { $length }
a-depth-step-begins-here-size-mm-deeper-over = ein Tiefensprung beginnt hier: { $size } mm tiefer über { $length }
the-tool-s-wear-jumps-here-size-mm-more-vb = der Verschleiß des Werkzeugs springt hier: { $size } mm mehr VB
a-tooth-breaks-here-the-next-one-cuts-its-fe = ein Zahn bricht hier: Der nächste schneidet seinen Vorschub mit
a-chatter-burst-begins-here-size-of-the-forc = ein Ratterstoß beginnt hier: { $size } % der Kraft über { $length }, aufgeprägt
the-sensor-drops-out-here-and-reads-0-over-l = der Sensor fällt hier aus und zeigt 0 über { $length }
a-sensor-drift-begins-here-size-n-in-the-end = eine Sensordrift beginnt hier: am Ende { $size } N über { $length }
a-longer-dead-time-begins-here-size-s-longer = eine längere Totzeit beginnt hier: { $size } s länger über { $length }
an-operator-s-override-begins-here-size-of-t = ein Override des Bedieners beginnt hier: { $size } % des Vorschubs über { $length }
the-hard-spot-ends-here = die harte Stelle endet hier
the-gap-ends-here = die Lücke endet hier
the-depth-step-ends-here = der Tiefensprung endet hier
the-wear-jump-has-grown-to-its-end-here = der Verschleißsprung ist hier voll ausgewachsen
the-broken-tooth-has-grown-to-its-end-here = der Zahnbruch ist hier voll ausgewachsen
the-chatter-burst-ends-here = der Ratterstoß endet hier
the-sensor-dropout-ends-here = der Sensorausfall endet hier
the-sensor-drift-has-grown-to-its-end-here = die Sensordrift ist hier voll ausgewachsen
the-longer-dead-time-ends-here = die längere Totzeit endet hier
the-operator-s-override-ends-here = der Override des Bedieners endet hier
the-cut-begins-at-the-programmed-feed-and-sp = der Schnitt beginnt mit den programmierten { $feed } und { $speed }
the-tool-meets-the-part = das Werkzeug trifft auf das Teil
the-tool-leaves-the-part = das Werkzeug verlässt das Teil
the-part-gets-size-deeper-here = das Teil wird hier { $size } tiefer
the-part-gets-size-shallower-here = das Teil wird hier { $size } flacher
the-radial-depth-goes-from-from-to-to = die Schnittbreite geht von { $from } auf { $to }
the-target-ra-is-moved-and-comes-back-to-to = das Soll-Ra wird verstellt und kommt auf { $to } zurück
the-target-ra-goes-from-from-to-to = das Soll-Ra geht von { $from } auf { $to }
the-reference-force-is-moved-and-comes-back = die Referenzkraft wird verstellt und kommt auf { $to } zurück
the-reference-force-goes-from-from-to-to = die Referenzkraft geht von { $from } auf { $to }
setting-is-moved-and-comes-back-to-to = { $setting } wird verstellt und kommt auf { $to } zurück
setting-goes-from-from-to-to = { $setting } geht von { $from } auf { $to }
first-and-next = { $first }, und { $next }
ra-without-dynamics = Ra ohne Dynamik
the-force = die Kraft
the-force-without-dynamics = die Kraft ohne Dynamik
stays-within-the-tolerance-held = bleibt in der Toleranz { $held }
leaves-the-tolerance-held = verlässt die Toleranz { $held }
comes-into-the-tolerance-held = kommt in die Toleranz { $held }
stays-outside-the-tolerance-held = bleibt außerhalb der Toleranz { $held }
is-within-the-tolerance-held = liegt in der Toleranz { $held }
is-outside-the-tolerance-held = liegt außerhalb der Toleranz { $held }
leaves-a-surface-that-the-model-cannot-judge = hinterlässt eine für das Modell nicht beurteilbare Oberfläche { $held }
is-smoother-than-asked-held = ist glatter als verlangt { $held }
stays-below-the-tolerance-held = bleibt unter der Toleranz { $held }
is-back-in-the-tolerance-held-after-time-out = kommt nach { $time } außerhalb in die Toleranz zurück { $held }, am weitesten { $value }
comes-into-the-tolerance-held-after-time-out = kommt nach { $time } außerhalb in die Toleranz { $held }, am weitesten { $value }
met-furthest-value = { $met }, am weitesten { $value }
stays-within-the-tolerance-in-the-mean-held = bleibt im Mittel in der Toleranz { $held }
comes-into-the-tolerance-in-the-mean-held = kommt im Mittel in die Toleranz { $held }
is-within-the-tolerance-in-the-mean-held = liegt im Mittel in der Toleranz { $held }
from-to-to = von { $from } auf { $to }
name-value = ({ $name } { $value })
ra-with-dynamics-with-without-without = (Ra mit Dynamik { $with }, ohne { $without })
name-from-to-to = ({ $name } von { $from } auf { $to })
keeps-the-feed-at-feed = hält den Vorschub bei { $feed }
lowers-the-feed-by-size-from-to-to = senkt den Vorschub um { $size } (von { $from } auf { $to })
raises-the-feed-by-size-from-to-to = erhöht den Vorschub um { $size } (von { $from } auf { $to })
moves-lowers-the-speed-by-size = { $moves }, senkt die Drehzahl um { $size }
moves-raises-the-speed-by-size = { $moves }, erhöht die Drehzahl um { $size }
nothing-settles-within-band = nichts kommt innerhalb von ±{ $band } zur Ruhe
no-error-remains-without-dynamics = Ohne Dynamik bleibt keine Regelabweichung
no-error-remains = Es bleibt keine Regelabweichung
error-but-name-still-moves-by-swing = { $error }, aber { $name } schwankt noch um ±{ $swing }
error-about-which-name-still-moves-by-swing = { $error }, { $name } schwankt darum noch mit ±{ $swing }
the-law-has-no-integral = das Regelgesetz hat keinen I-Anteil
it-is-still-on-its-way = Es ist noch unterwegs.
it-does-not-come-to-rest-in-this-stretch = In diesem Bereich kommt es nicht zur Ruhe.
the-remaining-error-is-size-below-the-target = Die bleibende Regelabweichung ist { $size } unter dem Soll-Ra
the-remaining-error-is-size-above-the-target = Die bleibende Regelabweichung ist { $size } über dem Soll-Ra
without-dynamics-size-below-the-target-ra-re = Ohne Dynamik bleiben { $size } unter dem Soll-Ra
without-dynamics-size-above-the-target-ra-re = Ohne Dynamik bleiben { $size } über dem Soll-Ra
the-remaining-error-is-size-below-the-refere = Die bleibende Regelabweichung ist { $size } unter der Referenzkraft
the-remaining-error-is-size-above-the-refere = Die bleibende Regelabweichung ist { $size } über der Referenzkraft
without-dynamics-size-below-the-reference-fo = Ohne Dynamik bleiben { $size } unter der Referenzkraft
without-dynamics-size-above-the-reference-fo = Ohne Dynamik bleiben { $size } über der Referenzkraft
begin-so-far-furthest = { $begin }: bisher { $furthest }.
twin-feed-met = { $twin }, { $feed }, { $met }
twin-met = { $twin } { $met }
begin-so-far-does = { $begin }, bisher: { $does }.
begin-does = { $begin }: { $does }.
value-ra-at-the-furthest-time-outside-the-to = Ra am weitesten bei { $value }, { $time } außerhalb der Toleranz
value-at-the-furthest-time-outside-the-toler = am weitesten bei { $value }, { $time } außerhalb der Toleranz
it-acts-only-while-feed-or-speed-moves-where = Sie wirkt nur, solange sich Vorschub oder Drehzahl ändern: Wo sich auf ihrer Länge nichts ändert, sieht man nichts.
it-acts-only-while-feed-or-speed-moves-it-sh = Es wirkt nur, während sich Vorschub oder Drehzahl ändern: Am meisten zeigt es sich bei der nächsten Tiefenänderung, bei { $time }.
it-acts-only-while-feed-or-speed-moves-no-ch = Es wirkt nur, während sich Vorschub oder Drehzahl ändern: Eine Tiefenänderung steht nicht mehr bevor.
the-controller-is-unstable-here-feed-and-for = der Regler ist hier instabil, Vorschub und Kraft schwingen, ohne abzuklingen
the-cut-at-the-programmed-feed-met = der Schnitt mit dem programmierten Vorschub { $met }
the-controller-moves-and-met = der Regler { $moves } und { $met }
the-controller-met = der Regler { $met }
the-tool-is-in-the-air-for-length-no-force-a = Das Werkzeug ist { $length } lang in der Luft: keine Kraft und keine Oberfläche; der Vorschub geht auf { $feed }.
