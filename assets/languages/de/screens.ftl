# Deutsch

## src/app/panels/block_diagram/brush.rs

your-own-order-order = eigener, Ordnung { $order }
low-to-high-whole = { $low } bis { $high } %, ganze
low-to-high-2 = { $low } bis { $high } %
at-most-rate-s = höchstens { $rate } %/s
hardness-hb-wear-wear = { $hardness } HB, Verschleiß { $wear }
off = aus
noise-level = Rauschen × { $level }
noise-force-n = Rauschen { $force } N
click-a-wire-to-plot-it-a-block-for-its-equa = Eine Leitung anklicken, um sie zu zeichnen, einen Block für seine Gleichungen. Volle Lampe: Eine Grenze wirkt, oder ein Modell wird außerhalb seines Bereichs benutzt.

## src/app/panels/block_diagram/card_view.rs

what-is-this = Was ist das?
set-here = Hier einstellen
as-printed-2 = Wie gedruckt
holds-range = gilt: { $range }
outside-range = AUSSERHALB: { $range }
plot = Zeichnen:

## src/app/panels/block_diagram/draw.rs

plot-signal = { $signal } zeichnen
as-it-should-be = wie es sein soll

## src/app/panels/block_diagram.rs

block-diagram = Schema
closed-loop = Regelkreis
nm-1-and-nm-2-at-the-playhead-learning-curve = NM-1 und NM-2 an der Abspielmarke, Lernkurven, mehrere Durchgänge
networks-that-learn = Lernende Netze

## src/app/panels/compare/boxes.rs

spread-over-the-seeds = Streuung über die Startwerte:
spread-of-measure = Streuung: { $measure }
no-values-yet-run-the-comparison = Noch keine Werte: den Vergleich ausführen.
every-seed-gave-the-same-run-a-box-is-a-line = Jeder Startwert gab denselben Lauf: Ein Kasten ist ein Strich.
mean = Mittel
printed-in-table-1 = in Tabelle 1 gedruckt
name-most-most-upper-quartile-upper-median-m =
    { $name }
    größter { $most }
    oberes Quartil { $upper }
    Median { $median }
    unteres Quartil { $lower }
    kleinster { $least }
printed = gedruckt
box-plots-of-title-done-of-n-runs = Box-Plots: { $title }, { $done } von { $n } Läufen

## src/app/panels/compare/claims.rs

table-1-of-2005-belongs-to-experiment-2-in-c = Tabelle 1 von 2005 gehört zu Experiment 2 in Ck45 bei 40 ms Totzeit: Neben anderem werden ihre Zahlen nicht gezeigt.
beside-table-1-of-2005 = Neben Tabelle 1 von 2005
met-of-n-bands-kept = { $met } von { $n } Bändern eingehalten
kept = gehalten
not-reached = nicht erreicht
found-found = gefunden { $found }
the-bands-are-judged-when-the-six-methods-of = Die Bänder werden beurteilt, wenn die sechs Verfahren der Tabelle gelaufen sind.
chosen-with-the-table-in-view = Mit Blick auf die Tabelle gewählt
not-reached-and-why = Nicht erreicht, und warum
title-figures-of-version-version = { $title } (Zahlen der Version { $version })

## src/app/panels/compare/contest.rs

done-of-n-runs-done = { $done } von { $n } Läufen fertig
compare-conditions = Vergleich: Bedingungen
compare-what = Vergleich: { $what }
the-console-s-cut = Schnitt der Konsole
the-cut-that-is-open-in-the-console-from-its = Der Schnitt, der in der Konsole offen ist, von Anfang an, mit den Einstellungen, die die Konsole jetzt zeigt.
experiment-2 = Experiment 2
experiment-2-of-2005-five-straight-cuts-one = Experiment 2 von 2005, fünf gerade Schnitte, ein programmierter Vorschub: der von Tabelle 1.
experiment-2-feeds-per-cut = Experiment 2, Vorschübe je Schnitt
the-same-with-a-programmed-feed-for-every-cu = Dasselbe mit einem programmierten Vorschub für jeden Schnitt, wie der Plan sie für die leichtesten Abschnitte findet: über den Artikel hinaus.
as-it-is = wie es ist
as-the-part-s-scenario-has-it = Wie im Szenario des Teils.
t-0-ms = 0 ms
none = Keine.
t-40-ms = 40 ms
t-40-ms-of-the-2013-paper = 40 ms, aus dem Artikel von 2013.
t-80-ms = 80 ms
t-80-ms-of-the-2007-paper = 80 ms, aus dem Artikel von 2007.
ck45 = Ck45
ck45-2 = Ck45.
t-16mncrsi5 = 16MnCrSi5
t-16mncrsi5-xm = 16MnCrSi5 XM.

## src/app/panels/compare/controls.rs

part = Teil
settings-of-the-comparison = Einstellungen des Vergleichs
run-the-comparison = Vergleich ausführen
pause-the-comparison = Vergleich anhalten
runs-everybody-on-every-seed-it-goes-on-whil = Lässt alle mit jedem Startwert laufen; es geht weiter, während andere Ansichten gezeigt werden
seeds = Startwerte
every-seed-is-another-material-and-other-sen-2 = Jeder Startwert ist anderer Werkstoff und anderes Sensorrauschen, für alle gleich; ohne Rauschen geben alle Startwerte denselben Lauf
done = fertig
load-step-step-of-of-then-n-runs =
    { $n ->
        [one] Lastsprung { $step } von { $of }, dann { $n } Lauf
       *[other] Lastsprung { $step } von { $of }, dann { $n } Läufe
    }
sdnrp-and-tracking-set-feed-and-speed-by-wha = SDNRP und der Folgeregler stellen Vorschub und Drehzahl nach Ra; dieses Teil von 2005 hat eine Kraft zu halten, und seine Tabelle 1 kennt sie nicht. Aus, bis sie gewählt werden.
dead-time = Totzeit
material = Werkstoff
who-takes-part = Wer teilnimmt:
compared-is-title-changed-name-from-its-star = Verglichen wird „{ $title }, geändert“ ({ $name }), von Anfang an, mit den Einstellungen, die die Konsole jetzt zeigt.
compared-is-title-name-from-its-start-with-t = Verglichen wird „{ $title }“ ({ $name }), von Anfang an, mit den Einstellungen, die die Konsole jetzt zeigt.
not-repeated-at-their-times-changes-what-the = Nicht zu ihren Zeiten wiederholt: { $changes }. Was die Konsole bei { $time } zeigt, gilt von Anfang an, für alle.
name-last-at-time = { $name } (zuletzt bei { $time })
n-more = { $n } weitere
stands-still-what-is-done-stays = Hält an; Fertiges bleibt

## src/app/panels/compare/robust.rs

without-retuning-anything = Ohne etwas neu einzustellen
experiment-2-at-other-dead-times-which-the-c = Experiment 2 bei anderen Totzeiten, die die Regler kennen, und in anderem Stahl, den sie nicht kennen. Unter jeder Zahl die eines unabhängigen Prototyps derselben Gleichungen, wo er eine hat: Sie stammt nicht aus dem Artikel.
run-the-conditions = Bedingungen ausführen
pause-the-conditions = Bedingungen anhalten
runs-everybody-under-every-condition = Lässt alle unter jeder Bedingung laufen
done-of-n-runs = { $done } von { $n } Läufen
control = Regelung
n-of-runs-runs-not-finished = { $n } von { $runs } Läufen nicht beendet

## src/app/panels/compare/step.rs

after-a-load-step = Nach einem Lastsprung
done-of-n-done = { $done } von { $n } fertig
from-a-section-of-before-n-into-one-of-after = Von einem Abschnitt mit { $before } N in einen mit { $after } N (statische Spitzen in Ck45 bei 100 % Override), ohne Rauschen: Regeltakte von { $period } ms, bis das Mittel aus vier Abtastungen endgültig innerhalb von 10 % liegt. Der Artikel druckt Iterationen eines Optimierungsschritts, ohne zu sagen, was sie sind; sie stehen daneben.
not-run-yet-it-comes-first-when-the-comparis = Noch nicht gelaufen: Es kommt zuerst, wenn der Vergleich läuft.
periods = Takte
overshoot = Überschwingen
left-over = Bleibend
printed-2 = Gedruckt

## src/app/panels/compare/table.rs

printed-value = gedruckt { $value }
best-within-the-spread = bester, innerhalb der Streuung
load = Laden
load-name = { $name } laden
opens-the-cut-in-the-console-with-this-way-o = Öffnet den Schnitt in der Konsole mit dieser Art der Regelung und dem dort eingestellten Startwert
n-of-all-not-finished = { $n } von { $all } nicht beendet
n-of-all-stopped-by-overload = { $n } von { $all } durch Überlast gestoppt
n-of-all-unstable = { $n } von { $all } instabil
n-of-all-chattered = { $n } von { $all } mit Rattern
why-not-all-hold-the-tolerance = Warum nicht alle die Toleranz halten
mean-and-standard-deviation-over-the-seeds-a = Mittelwert und Standardabweichung über die Startwerte. Ein Stern markiert den besten einer Spalte, wo er um mehr als beide Abweichungen zusammen führt; bei weniger als drei Startwerten ist keine Streuung bekannt, und keiner führt. Nsn: normierter Standardfehler, wie weit die Kraft von ihrer Referenz abweicht, weniger ist besser.
columns-are-ranked-only-among-those-that-hol-2 = { $columns }: Rangfolge nur unter denen, die die Toleranz halten; außerhalb sind sie kein Gewinn.
afc-has-no-reference-forces-here-it-is-taugh = AFC hat hier keine Referenzkräfte: Sie macht einen Lehrschnitt mit dem programmierten Vorschub. Den Lehrschnitt im Fenster AFC der Konsole ausführen.
so-far-done-ranking = Bisher, { $done }: { $ranking }
every-seed-gave-the-same-run-since-nothing-r = Jeder Startwert gab denselben Lauf, da hier nichts Zufälliges wirkt: Es gibt keine Streuung.
the-force-strays-least-from-its-reference-wi-3 = weicht die Kraft mit { $controller } am wenigsten von ihrer Referenz ab: ihr normierter Standardfehler Nsn ist { $nsn }, 0 ist vollkommen
of-those-told = Von diesen { $told }.
of-those-told-the-lead-is-within-the-spread = Von diesen { $told }; der Vorsprung liegt in der Streuung.
of-all-told = Von allen { $told }.
of-all-told-the-lead-is-within-the-spread = Von allen { $told }; der Vorsprung liegt in der Streuung.
nobody-is-judged-yet = Noch ist keiner beurteilt.
nobody-holds-the-tolerance-on-percent-of-the-2 = Keiner hält die Toleranz auf { $percent } % der Länge.
who-holds-the-tolerance-on-percent-of-the-le = Die Toleranz auf { $percent } % der Länge halten: { $controllers }.
by-controller = Nach Regler
by-measure = Nach Maß

## src/app/panels/compare.rs

compare = Vergleich
controllers-ranking-best-seeds-statistics-to = Regler Rangfolge bester Startwerte Statistik Wettbewerb vergleichen
nobody-takes-part = Keiner nimmt teil
choose-at-least-one-way-of-control-above = Oben mindestens eine Art der Regelung wählen.

## src/app/panels/equation_cards/live.rs

symbol-c-delayed-by-time-s = { $symbol }_c um { $time } s verzögert
in-now-out-then-unit = ein { $now }, aus { $then } { $unit }
symbol-c-command-gives-symbol-a-actual-unit = { $symbol }_c = { $command } ergibt { $symbol }_a = { $actual } { $unit }
f-c-command-gives-f-a-feed-mm-min = f_c = { $command } ergibt f_a = { $feed } mm/min
a-straight-ramp-beyond-error-1-min-of-error = eine gerade Rampe jenseits von { $error } 1/min Abweichung
level-level-band-band-ripple-ripple-inhomoge = Pegel { $level }: Band { $band } %, Welligkeit { $ripple } %, Inhomogenität { $inhomogeneity } %
f-m-symbol-noise-of-deviation-n-standard-dev = F_m = { $symbol } + Rauschen von { $deviation } N (Standardabweichung)
f-m-measured-n-held-since-the-last-sample-sy = F_m = { $measured } N, seit der letzten Abtastung gehalten; { $symbol } jetzt { $force } N

## src/app/panels/equation_cards/machine.rs

p-f-g-max-g-force-factor-b-u-u-t-g-the-teeth = P = F g / max g - { $force } · { $factor } b (u - u_T), g der Span der Zähne, u_T einen Zahn früher
u-vibration-um-as-the-last-tooth-made-the-su = u = { $vibration } µm, als der letzte Zahn die Oberfläche erzeugte; Geschwindigkeit { $sound } mm/s über die letzte Sekunde
ra-dyn-ra-ra-marks-ra-marks-without-vibratio = Ra_{ "{" }dyn{ "}" } = Ra + Ra(Marken) - Ra(Marken ohne Schwingung)

## src/app/panels/equation_cards/models.rs

symbol-low-to-high-unit = { $symbol } { $low } bis { $high } { $unit }
range-straight-on-beyond = { $range }; darüber hinaus geradlinig
f-d-at-least-force-n = F_d mindestens { $force } N
f-s-from-force-n-on-below-it-the-feed-is-neg = F_s ab { $force } N; darunter ist der Vorschub negativ
f-s-where-the-feed-is-positive-and-rises-wit = F_s, wo der Vorschub positiv ist und mit ihr steigt
f-s-up-to-force-n-above-it-there-is-no-root = F_s bis { $force } N; darüber gibt es keine Wurzel
range-goes-on-beyond = { $range }; geht darüber hinaus weiter
symbol-the-tool-is-in-the-air = { $symbol }: Das Werkzeug ist in der Luft
no-force-so-no-surface-is-cut = keine Kraft, also wird keine Oberfläche gefräst
range-straight-on-beyond-before-its-pole-at = { $range }; darüber hinaus geradlinig, vor dem Pol bei 293 N
range-it-turns-round-at-force-n = { $range }; kehrt bei { $force } N um

## src/app/panels/equation_cards/overrides.rs

ramp = Rampe
round-wanted-to-whole = round({ $wanted }) auf ganze %
rate-t-rate-s-period-s-step-name-is-on-its-w = Rate T = { $rate } %/s · { $period } s = { $step } %: { $name } ist unterwegs
rate-t-rate-s-period-s-step-name-is-arrived = Rate T = { $rate } %/s · { $period } s = { $step } %: { $name } ist angekommen
ramp-limit-wanted-ramp-rate-t-wanted-limit-s = Rampe' = limit(Ziel - Rampe, ± Rate T),  Ziel = limit({ $symbol } / { $symbol }_p, { $low }..{ $high } %)
name-reaches-what-is-wanted-within-a-period = { $name } erreicht das Ziel innerhalb eines Takts

## src/app/panels/identify/actions.rs

with-units-and-ranges-as-steadycut-identify = Mit Einheiten und Bereichen, wie `steadycut identify gp --out` es schreibt
save-as-a-model = Als Modell speichern
copy-as-text = Als Text kopieren
copy-as-latex = Als LaTeX kopieren
puts-the-formula-into-the-clipboard = Legt die Formel in die Zwischenablage
the-formula-is-in-the-clipboard-form = Die Formel ist in der Zwischenablage ({ $form }).
neither-a-model-nor-for-the-cut-because = Weder Modell noch für den Schnitt: { $because }.
input-in-unit = `{ $input }` in { $unit }
nothing = nichts
and = { " " }und{ " " }
a-number-without-a-unit = Zahl ohne Einheit
the-cut-has-no-place-for-it-by-its-units-it = Nach den Einheiten hat der Schnitt keinen Platz dafür: { $makes } aus { $made }.
use-in-the-cut-place = Im Schnitt verwenden: { $place }
in-the-running-cut-place = Im laufenden Schnitt: { $place }.
show-the-cut = Den Schnitt zeigen
plant-and-controller-compute-with-it-from-no = Strecke und Regler rechnen ab jetzt damit (Kalibrierung: eigene Formeln); Rückgängig nimmt es zurück
place-the-formula-stands-in-the-running-cut = { $place }: Die Formel steht im laufenden Schnitt, mit der Kalibrierung eigene Formeln. Rückgängig nimmt es zurück.

## src/app/panels/identify/columns.rs

target-and-inputs = Ziel und Eingänge
left-out-because = ausgelassen: { $because }
units = Einheiten
input = Eingang
target-2 = Ziel
name-low-to-high = { $name }: { $low } bis { $high }
unit-of-name = Einheit von { $name }
as-mm-min-1-min-n-um-empty-or-1-for-none-the = Wie mm/min, 1/min, N, um; leer oder 1 für keine. Zuerst sagt es die Endung des Spaltennamens

## src/app/panels/identify/controls.rs

table-table = Tabelle: { $table }
open-a-csv = CSV öffnen…
a-table-with-a-line-of-names-it-can-also-be = Eine Tabelle mit einer Zeile von Namen; sie lässt sich auch hier ablegen
table-rows-rows-columns-columns = { $table }: { $rows } Zeilen, { $columns } Spalten.
search = Suchen
seed = Startwert
most-batches = Max. Runden
it-ends-earlier-where-nothing-is-gained-for = Sie endet früher, wenn 200 Runden nichts bringen oder eine Formel genau ist.
known-part-of-the-formula = Bekannter Teil der Formel
none-or-as-a-b-n-3-t-f = keiner, oder wie a + b*n^3 + T(f)
columns-by-their-names-other-names-are-const = Spalten mit ihren Namen; andere Namen sind Konstanten, die angepasst werden. T(...) steht für das Gesuchte, eine Formel der Spalten in seinen Klammern
only-formulas-that-are-right-in-their-units = Nur Formeln, deren Einheiten stimmen
beside-it-as-searched-in-a-paper = Daneben, wie in einem Artikel gesucht:
paper-s-search-beside-paper = Suche eines Artikels daneben: { $paper }
its-functions-constants-population-and-proba = Dessen Funktionen, Konstanten, Population und Wahrscheinlichkeiten; der Bericht sagt, welche Suche die Formel mit dem kleineren Fehler fand

## src/app/panels/identify/facts.rs

constants-with-95-intervals = Konstanten mit 95-%-Intervallen
it-has-none = Sie hat keine.
low-to-high = { $low } bis { $high }
not-determined-low-to-high = nicht bestimmt: { $low } bis { $high }
not-determined-by-these-rows = durch diese Zeilen nicht bestimmt
units-because = Einheiten: { $because }
slope-uncertain = Steigung unsicher
where-it-holds = Wo sie gilt
name-low-to-high-unit-trend = { $name } { $low } bis { $high } { $unit }: { $trend }
or = { " " }oder{ " " }
outside-ranges-it-says-nothing = Außerhalb von { $ranges } sagt sie nichts.
certain-to-be-finite-from-low-to-high-unit = sicher endlich, von { $low } bis { $high } { $unit }
certain-to-be-finite = sicher endlich
not-certain-to-be-finite-why = nicht sicher endlich: { $why }
not-certain-to-be-finite = nicht sicher endlich
there-it-is-finite = Dort ist sie { $finite }.
with-percent-more-on-each-side-finite = Mit { $percent } % mehr auf jeder Seite: { $finite }.

## src/app/panels/identify/fit/choose.rs

what-is-fitted = Was angepasst wird
fitted-what = Angepasst: { $what }
open-a-recording = Aufzeichnung öffnen…
text-of-any-layout-matlab-hdf5-tdms-or-parqu-2 = Text beliebigen Aufbaus, MATLAB, HDF5, TDMS oder Parquet; sie kann auch hierher gezogen werden
try-with-sample-data = Mit Beispieldaten versuchen
simulates-the-recording-that-the-present-sce = Simuliert die Aufzeichnung, die das jetzige Szenario gäbe, mit Rauschen nach seinem Startwert: Was die Anpassung findet, lässt sich mit dem vergleichen, was hineinging
none-yet = Noch keine.

## src/app/panels/identify/fit/fields.rs

which-channel-is-which = Welcher Kanal was ist
options = Optionen
choose = wählen
unit-channel = Einheit: { $channel }
the-scenario-s-value = im Szenario: { $value }
clear = Leeren

## src/app/panels/identify/fit/found.rs

is-half-a-95-interval-from-what-is-left-if-t = ± ist ein halbes 95-%-Intervall, aus dem Residuum, wenn das Modell das wahre ist.
use-in-this-scenario = In diesem Szenario verwenden
sets-these-settings-in-one-step-of-undo-the = Setzt diese Einstellungen in einem Schritt des Rückgängigmachens; der Schnitt läuft vom Anfang
save-as-a-file = Als Datei speichern
the-file-that-steadycut-identify-id-out-writ = Die Datei, die steadycut identify { $id } --out schreibt, mit Quelle und Intervallen
it-stands-in-the-scenario-undo-takes-it-back = Es steht im Szenario. Rückgängig nimmt es zurück.
n-settings = { $n } Einstellungen
this-scenario-does-not-take-it-why = Dieses Szenario nimmt es nicht: { $why }

## src/app/panels/identify/fit/mod.rs

fit-of-measured-data = Anpassung an Messdaten
sample-data = Beispieldaten
no-sample-data-why = Keine Beispieldaten: { $why }
data-options-or-the-cut-were-changed-since-w = Daten, Optionen oder der Schnitt wurden seither geändert: Was hier steht, ist von vorher. Anpassen fragt neu.
open-a-file-first = Zuerst eine Datei öffnen.
stop-the-fit = Anpassung abbrechen
gives-this-fit-up = Gibt diese Anpassung auf
fit = Einpassen
fits-the-model-to-the-data-it-goes-on-while = Passt das Modell an die Daten an; das läuft auch weiter, während andere Ansichten gezeigt werden
no-measured-data-yet = Noch keine Messdaten
choose-what-is-to-be-fitted-open-a-recording = Wählen, was angepasst werden soll, eine Aufzeichnung öffnen oder hierher ziehen und sagen, welcher Kanal was ist; dann Anpassen drücken. Werte mit ihren 95-%-Intervallen, das Residuum und was die Daten nicht unterscheiden, stehen da, bevor etwas ins Szenario übernommen oder gespeichert wird.
sample-data-sample-on-the-command-line-stead = Beispieldaten: { $sample }. Auf der Befehlszeile: steadycut identify { $id }.

## src/app/panels/identify/fit/plots.rs

the-fit = die Anpassung
measured = gemessen
model-2 = Modell
what-over-over-measured-against-the-model-n = { $what } über { $over }: gemessen gegen das Modell, { $n } Stellen
measured-over-model = Gemessen geteilt durch Modell
left-over-measured-less-model = Residuum: gemessen minus Modell
left-over-2 = Residuum
what-the-fit-of-what-leaves-over-over = was die Anpassung von { $what } über { $over } lässt

## src/app/panels/identify/fit_plots.rs

predicted-over-measured = Vorhergesagt über gemessen
upright-lines-the-95-band-in-which-the-true = Senkrechte Striche: das 95-%-Band, in dem die wahren Werte liegen, wenn die Form der Formel die wahre ist.
left-over-row-by-row = Residuen, Zeile für Zeile
row-row-does-not-fit-target-value-off-off-de = Zeile { $row } passt nicht: { $target } = { $value }, { $off } daneben, das { $deviations }-Fache ihrer eigenen Standardabweichung.
n-more-rows-do-not-fit =
    { $n ->
        [one] { $n } weitere Zeile passt nicht.
       *[other] { $n } weitere Zeilen passen nicht.
    }
predicted = vorhergesagt
predicted-over-measured-n-rows-apart-of-them =
    { $n ->
        [one] vorhergesagt über gemessen: { $n } Zeile, davon passen { $apart } nicht
       *[other] vorhergesagt über gemessen: { $n } Zeilen, davon passen { $apart } nicht
    }
row = Zeile
left-over-over-row-n-rows-apart-of-them-do-n =
    { $n ->
        [one] Residuum über Zeile: { $n } Zeile, davon passen { $apart } nicht
       *[other] Residuum über Zeile: { $n } Zeilen, davon passen { $apart } nicht
    }
row-that-does-not-fit = Zeile, die nicht passt

## src/app/panels/identify/form.rs

known-part-nothing-is-left-to-be-searched-fo = bekannter Teil: Es bleibt nichts zu suchen; T(...) mit den Spalten schreiben, die der Rest lesen darf (die Konstanten allein passt `steadycut identify gp --template` an)
the-unit-of-column-is-not-known-write-it-bes = die Einheit von `{ $column }` ist nicht bekannt: sie neben den Namen schreiben, `1` für keine, oder Formeln beliebiger Einheiten zulassen
unit-of-column-problem = Einheit von `{ $column }`: { $problem }
open-a-table-or-choose-one-of-the-papers = eine Tabelle öffnen oder eine der Artikel wählen
choose-the-column-that-the-formula-is-to-giv = die Spalte wählen, die die Formel liefern soll
choose-at-least-one-column-that-the-formula = mindestens eine Spalte wählen, die die Formel lesen darf
known-part-problem = bekannter Teil: { $problem }
collinear-leave-one-of-them-out = { $collinear }; eine davon weglassen
data = Daten
inputs = Eingänge
units-2 = Einheiten
known-part = bekannter Teil
seed-2 = Startwert
batches = Runden
paper-2 = Artikel
not-opened-because = nicht geöffnet: { $because }
nothing-was-checked = nichts wurde geprüft

## src/app/panels/identify/formula.rs

formula-of-size-size-the-one-chosen = Formel der Größe { $size }, die gewählte
formula-of-size-size = Formel der Größe { $size }
formula-of-size-size-so-far = Formel der Größe { $size }, bisher
with-all-digits-formula = Mit allen Ziffern: { $formula }
unsure-doubt = Unsicher: { $doubt }.
exact-but-for-rounding = Genau bis auf Rundung.

## src/app/panels/identify/front.rs

front-the-formula-of-the-least-error-of-each = Front: die Formel mit dem kleinsten Fehler jeder Größe
no-formula-has-a-finite-value-on-all-rows-ye = Noch hat keine Formel in allen Zeilen einen endlichen Wert.
size-2 = Größe
error = Fehler
left-out = ausgelassen
chosen-exact = gewählt, genau
chosen = gewählt
exact = genau
unsure = unsicher
errors-are-root-mean-squares-of-what-is-left = Fehler sind Effektivwerte der Residuen. An ausgelassenen Zeilen werden sie bestimmt, sobald die Suche vorbei ist.
left-out-rows-unsure-more-than-twice-the-lea = Ausgelassen: { $rows }. Unsicher: mehr als das Doppelte des kleinsten Fehlers dort oder nicht sicher endlich.
searched-on-searched-of-n-rows-drawn-by-the =
    { $n ->
        [one] Gesucht an { $searched } von { $n } Zeile, nach dem Startwert gezogen; Konstanten sind an alle angepasst.
       *[other] Gesucht an { $searched } von { $n } Zeilen, nach dem Startwert gezogen; Konstanten sind an alle angepasst.
    }
no-formula = keine Formel
the-smaller-error-is-that-of-the-paper-searc = Den kleineren Fehler hat die Suche des Artikels.
the-smaller-error-is-that-of-the-default-sea = Den kleineren Fehler hat die übliche Suche.
stop-at-stop-reached = Abbruch bei { $stop } erreicht
stop-at-stop-not-reached = Abbruch bei { $stop } nicht erreicht
as-the-paper-of-paper-searched-formula-size =
    { $n ->
        [one] Wie der Artikel von { $paper } suchte: { $formula }, Größe { $size }, R2 { $fitness } nach { $n } Generation, { $reached }.
       *[other] Wie der Artikel von { $paper } suchte: { $formula }, Größe { $size }, R2 { $fitness } nach { $n } Generationen, { $reached }.
    }
digest-digest-the-same-on-the-command-line = Prüfsumme { $digest }: auf der Befehlszeile dieselbe.

## src/app/panels/identify/front_plot.rs

size-nodes = Größe [Knoten]
at-rows-left-out = an ausgelassenen Zeilen
looked-at = angesehen
front-error-against-size-n-formulas =
    { $n ->
        [one] Front: Fehler über Größe, { $n } Formel
       *[other] Front: Fehler über Größe, { $n } Formeln
    }
front-error-in-unit-against-size-n-formulas =
    { $n ->
        [one] Front: Fehler in { $unit } über Größe, { $n } Formel
       *[other] Front: Fehler in { $unit } über Größe, { $n } Formeln
    }

## src/app/panels/identify/mod.rs

fit-settings = Einstellungen anpassen
search-formulas = Formeln suchen
looks-in-a-table-for-a-formula-of-one-column = Sucht in einer Tabelle eine Formel für eine Spalte, durch genetische Programmierung
fits-drive-forces-structure-noise-wear-or-ma = Passt Antrieb, Kräfte, Struktur, Rauschen, Verschleiß oder Werkstoff an eine Aufzeichnung an
identify = Formeln
no-formula-was-searched-for-yet = Noch wurde keine Formel gesucht
choose-a-table-a-csv-can-be-dropped-here-the = Eine Tabelle wählen (eine CSV lässt sich hier ablegen), die Spalte, die die Formel liefern soll, und die Spalten, die sie lesen darf; dann Suchen drücken.
the-front-grows-while-the-search-works-for-e = Die Front wächst, während die Suche arbeitet: für jede Größe die Formel mit dem kleinsten Fehler. Jede lässt sich ansehen, speichern und in den laufenden Schnitt setzen.
without-a-table-of-one-s-own-go-the-whole-wa = Ohne eigene Tabelle: Den ganzen Weg gehen plant und misst Schnitte am Simulator, die dann auch durchsucht werden können.

## src/app/panels/identify/preview.rs

no-numbers = keine Zahlen
unit-not-told = Einheit nicht genannt

## src/app/panels/identify/search.rs

not-certain-to-be-finite-on-the-ranges-of-th = auf den Bereichen der Zeilen nicht sicher endlich
at-rows-left-out-more-than-twice-the-least-e = an ausgelassenen Zeilen mehr als das Doppelte des kleinsten Fehlers der Front
identify-target = Identifikation: { $target }
the-front-has-this-formula-no-more = die Front hat diese Formel nicht mehr

## src/app/panels/identify/symbols.rs

simulation = Simulation
ra = Ra
desired-ra = Soll-Ra
ra-produced = Erzeugtes Ra
force-start = Kraft, Anfang
force-end = Kraft, Ende
feed-start = Vorschub, Anfang
feed-end = Vorschub, Ende
speed-2 = Drehzahl
speed-start = Drehzahl, Anfang
speed-end = Drehzahl, Ende
axial-depth = Schnitttiefe
radial-depth = Schnittbreite

## src/app/panels/identify/transport.rs

searches-for-formulas-it-goes-on-while-other = Sucht Formeln; es geht weiter, während andere Ansichten gezeigt werden
stands-still-what-was-found-stays = Hält an; Gefundenes bleibt
pause-the-search = Suche anhalten
goes-on-where-it-was-paused = Geht weiter, wo angehalten wurde
go-on-with-the-search = Suche fortsetzen
ends-the-search-with-its-last-whole-batch-wh = Beendet die Suche mit ihrer letzten ganzen Runde; Gefundenes wird noch an ausgelassenen Zeilen beurteilt
end-here = Hier beenden
searches-for-what-is-set-now-and-gives-this = Sucht nach dem, was jetzt eingestellt ist, und gibt diese Suche auf
begin-anew = Neu beginnen
writes-a-file-to-go-on-with-later-here-or-wi = Schreibt eine Datei, um später fortzufahren, hier oder mit --resume
save-the-search = Suche speichern
changed-since-this-search-was-begun-changed = Seit Beginn dieser Suche geändert: { $changed }. Sie bleibt, wie sie begonnen wurde; `Neu beginnen` sucht nach dem, was jetzt eingestellt ist.
sets-table-columns-and-numbers-to-those-of-t = Setzt Tabelle, Spalten und Zahlen auf die dieser Suche
set-back = Zurücksetzen
resume = Fortsetzen…
goes-on-with-a-saved-search-of-the-same-tabl = Setzt eine gespeicherte Suche mit derselben Tabelle, denselben Spalten, Einheiten und Startwert fort; ihre Datei lässt sich auch hier ablegen
batch-batch-of-at-most-most = Runde { $batch } von höchstens { $most }
the-paper-s-own-search = Suche des Artikels selbst
judging-the-front-at-rows-left-out = beurteilt die Front an ausgelassenen Zeilen
done-after-n-batches =
    { $n ->
        [one] fertig nach { $n } Runde
       *[other] fertig nach { $n } Runden
    }
n-formulas =
    { $n ->
        [one] { $n } Formel
       *[other] { $n } Formeln
    }
at-most-left-left = noch höchstens { $left }
paused = angehalten

## src/app/panels/identify/tree.rs

as-a-tree = Als Baum
tree-of-the-formula-n-parts =
    { $n ->
        [one] Baum der Formel, { $n } Teil
       *[other] Baum der Formel, { $n } Teile
    }

## src/app/panels/identify/way.rs

identify-the-whole-way = Identifikation: der ganze Weg
the-open-scenario-s-cutter-is-none-of-the-sh = der Fräser des offenen Szenarios ist keiner der mitgelieferten: Der Weg wird mit einem von diesen gegangen
from-cuts-to-a-controller = Von Schnitten zum Regler
with-the-open-scenario-s-cutter-and-material =
    { $n ->
        [one] Mit Fräser und Werkstoff des offenen Szenarios: { $n } Schnitt am Simulator geplant und gemessen, daraus Modelle 1 bis 5 identifiziert, die Zeilen von Tabelle 3 mit den Modellen gerechnet.
       *[other] Mit Fräser und Werkstoff des offenen Szenarios: { $n } Schnitte am Simulator geplant und gemessen, daraus Modelle 1 bis 5 identifiziert, die Zeilen von Tabelle 3 mit den Modellen gerechnet.
    }
go-the-whole-way = Den ganzen Weg gehen
pause-the-way = Den Weg anhalten
go-on-with-the-way = Den Weg fortsetzen
give-the-way-up = Den Weg aufgeben
percent-of-the-way-about-left-left = { $percent } % des Wegs, noch etwa { $left }
percent-of-the-way = { $percent } % des Wegs
percent-of-the-way-paused = { $percent } % des Wegs, angehalten
its-cuts-as-the-table = Seine Schnitte als Tabelle
cuts-of-the-way = Schnitte des Wegs
ra-0-81-m-with-tracking-on-the-models-found = Ra 0,81 µm mit Folgeregler an den gefundenen Modellen
cut-with-its-models = Mit seinen Modellen fräsen
the-scenario-of-the-way = Das Szenario des Wegs
the-whole-way-tool-in-material = Der ganze Weg: { $tool } in { $material }
truth-truth = Wahrheit: { $truth }.
measured-of-n-cuts-measured-axial-mm-deep-an =
    { $n ->
        [one] { $measured } von { $n } Schnitt gemessen, { $axial } mm tief und { $radial } mm breit.
       *[other] { $measured } von { $n } Schnitten gemessen, { $axial } mm tief und { $radial } mm breit.
    }
cut-run-problem = Schnitt { $run }: { $problem }.
name-low-to-high-2 = { $name } { $low } bis { $high }
error-error-n-cuts-ranges =
    { $n ->
        [one] Fehler { $error }, { $n } Schnitt, { $ranges }
       *[other] Fehler { $error }, { $n } Schnitte, { $ranges }
    }
ra-against-its-target-n-rows-of-table-3 =
    { $n ->
        [one] Ra gegen seinen Sollwert, { $n } Zeile von Tabelle 3
       *[other] Ra gegen seinen Sollwert, { $n } Zeilen von Tabelle 3
    }
digest-digest-that-of-steadycut-experiment-w = Prüfsumme { $digest }: die von `steadycut experiment way`.
n-rows-outside-the-ranges-of-the-models =
    { $n ->
        [one] { $n } Zeile außerhalb der Bereiche der Modelle
       *[other] { $n } Zeilen außerhalb der Bereiche der Modelle
    }
off-by-worst-at-most-rms-rms = höchstens { $worst } % daneben, { $rms } % effektiv
n-rows-without-a-ra =
    { $n ->
        [one] { $n } Zeile ohne Ra
       *[other] { $n } Zeilen ohne Ra
    }
controller-on-models = { $controller } an { $models }

## src/app/panels/learn/answer.rs

from-the-start-by-hand-again = Von Anfang an, noch einmal von Hand
from-the-start-with-what-is-set-now = Von Anfang an, mit dem, was jetzt eingestellt ist
cut-from-the-start = Von Anfang an fräsen
marks-the-whole-cut-as-it-is-set-now-and-you = Bewertet den ganzen Schnitt, wie er jetzt eingestellt ist, und die Vorhersagen
check-my-answer = Antwort prüfen
the-cut-still-runs-percent-the-check-runs-it = Der Schnitt läuft noch ({ $percent } %): Die Prüfung fräst ihn zuerst zu Ende.
the-cut-is-over-the-check-marks-all-of-it = Der Schnitt ist zu Ende: Geprüft wird der ganze.
the-cut-is-being-marked = Der Schnitt wird bewertet
this-was-the-last-mission-leave-leads-to-the = Das war die letzte Mission. „Verlassen“ führt zur Liste aller Missionen.
next-mission-title = Nächste Mission: { $title }
your-name = Ihr Name
if-you-like = freiwillig
a-file-with-your-answer-and-what-it-came-to = Eine Datei mit der Antwort und ihrem Ergebnis; steadycut mission check prüft sie nach
save-result = Ergebnis speichern

## src/app/panels/learn/catalogue.rs

missions = Missionen
each-takes-some-minutes-say-what-will-happen = Jede dauert einige Minuten: vorhersagen, fräsen und sehen, ob es stimmt. Geprüft wird mit demselben Programm, das fräst.
begin = Beginnen
begin-mission = Beginnen: { $mission }
a-mission-of-your-own-is-a-text-file-steadyc = Eine eigene Mission ist eine Textdatei: steadycut mission new schreibt eine Vorlage. Die Datei lässt sich hier ablegen.
not-passed-yet = noch nicht bestanden
won-of-most-stars = { $won } von { $most } Sternen
a-link-to-this-mission-with-its-qr-code = Ein Link zu dieser Mission, mit QR-Code
link-mission = Link: { $mission }
stars-are-kept-until-the-program-ends-the-pl = Sterne bleiben nur bis zum Ende des Programms erhalten: Dauerhaftes Speichern ist hier nicht erlaubt.
forget-my-stars = Sterne vergessen…
all-stars-of-every-mission = Alle Sterne, von jeder Mission?
forget-them = Vergessen
keep-them = Behalten

## src/app/panels/learn/lesson.rs

marking-of-the-mission = Bewertung der Mission

## src/app/panels/learn/mod.rs

learn = Lernen
predict-first = Zuerst vorhersagen
the-cut-begins-and-is-shown-as-soon-as-you-h = Der Schnitt beginnt und erscheint, sobald Sie gesagt haben, was Sie erwarten, oder ohne Vorhersage weitergegangen sind.

## src/app/panels/learn/pen.rs

sketch-right-and-left-draw-up-and-down-lift = Skizze: rechts und links zeichnen, auf und ab heben und senken den Stift

## src/app/panels/learn/questions.rs

the-right-answer-is-needed-to-pass = Zum Bestehen ist die richtige Antwort nötig.
your-prediction = Ihre Vorhersage
prediction = Vorhersage

## src/app/panels/learn/sketch.rs

signal-up-to-top-unit = { $signal } bis { $top } { $unit }
value-at-time = { $value } bei { $time }
draw-here = Hier zeichnen

## src/app/panels/learn/tasks.rs

back-to-all-missions-the-cut-stays-as-it-is = Zurück zu allen Missionen; der Schnitt bleibt, wie er ist, und alles lässt sich wieder ändern
story = Geschichte
goal = Ziel:
step-step-of-count-title = Schritt { $step } von { $count }: { $title }
back = Zurück
next = Weiter
that-is-my-prediction = Das ist meine Vorhersage
go-on-without-a-prediction = Weiter ohne Vorhersage
that-is-my-answer = Das ist meine Antwort
go-on-without-an-answer = Weiter ohne Antwort
without-an-answer-there-is-no-third-star-any = Ohne Antwort gibt es keinen dritten Stern: Jede Vermutung lehrt mehr als keine.
go-on-all-the-same = Trotzdem weiter
your-prediction-stays-as-it-is-the-cut-has-b = Die Vorhersage bleibt, wie sie ist: Der Schnitt wurde gezeigt.
it-was-left-without-a-prediction-the-cut-has = Es blieb ohne Vorhersage: Der Schnitt wurde gezeigt.
you-have-seen-this-cut-before-another-answer = Dieser Schnitt wurde schon gesehen: Eine andere Antwort als beim ersten Mal zählt zum Bestehen, nicht für den dritten Stern.
answered-after-the-cut-or-a-check-has-shown = Beantwortet, nachdem Schnitt oder Prüfung es gezeigt haben: Das zählt zum Bestehen, nicht für den dritten Stern.
what-you-may-change = Was Sie ändern können
nothing-this-mission-asks-only-for-answers = Nichts: Diese Mission verlangt nur Antworten.
given-2 = Gegeben
hint-number = Hinweis { $number }:
hint-number-of-count = Hinweis { $number } von { $count }

## src/app/panels/learn/verdict.rs

tries-begun-begun-checked-checked = Versuche: begonnen { $begun }, geprüft { $checked }
digest-of-the-cut-digest = Prüfsumme des Schnitts: { $digest }
puts-the-result-away-a-check-brings-the-next = Schließt das Ergebnis; die nächste Prüfung bringt ein neues
close-the-result = Ergebnis schließen
passed-won-of-most-stars = Bestanden: { $won } von { $most } Sternen
not-passed-yet-2 = Noch nicht bestanden
this-is-of-before-your-last-change-check-aga = Das gilt für den Stand vor der letzten Änderung: noch einmal prüfen.
off-the-curve-by-percent-of-its-height = um { $percent } ihrer Höhe neben der Kurve
within-tolerance-of-the-true-value = innerhalb { $tolerance } um den wahren Wert
too-low-allowed-is-tolerance-to-either-side = zu niedrig; erlaubt sind { $tolerance } nach beiden Seiten
too-high-allowed-is-tolerance-to-either-side = zu hoch; erlaubt sind { $tolerance } nach beiden Seiten
words-the-true-value-is-truth = { $words }; der wahre Wert ist { $truth }
no-answer-was-given-in-step-step-that-costs = In Schritt { $step } wurde nicht geantwortet: Das kostet den dritten Stern
no-prediction-was-made-in-step-step-that-cos = In Schritt { $step } wurde nichts vorhergesagt: Das kostet den dritten Stern
your-answer-in-step-step-is-right-it-came-wh = Die Antwort in Schritt { $step } ist richtig; sie kam, nachdem der Schnitt zu sehen war
your-answer-in-step-step-is-wrong = Die Antwort in Schritt { $step } ist falsch
your-prediction-in-step-step-was-right = Die Vorhersage in Schritt { $step } war richtig
your-prediction-in-step-step-was-wrong = Die Vorhersage in Schritt { $step } war falsch
your-prediction-in-step-step-was-right-off-2 = Die Vorhersage in Schritt { $step } war richtig ({ $off })
your-prediction-in-step-step-was-wrong-off-2 = Die Vorhersage in Schritt { $step } war falsch ({ $off })
for-all-three-stars = Für alle drei Sterne:
reached-condition = erreicht: { $condition }
missed-condition = verfehlt: { $condition }
predictions-that-are-right-made-before-the-c = richtige Vorhersagen vor dem Schnitt

## src/app/panels/learning/actions.rs

the-cut-begins-with-networks = Der Schnitt beginnt mit Netzen
learned-before = vorher gelernt
begin-the-same-cut-with-what-has-been-learne = Denselben Schnitt mit dem beginnen, was an seinem Ende gelernt war
cut-again-with-what-was-learned = Mit dem Gelernten neu fräsen
save-nm-r-nm-1-and-nm-2-as-they-are-at-the-e = NM-R, NM-1 und NM-2 speichern, wie sie am Ende des Schnitts sind
save-networks = Netze speichern
begin-with-the-networks-of-a-file-one-can-al = Mit den Netzen einer Datei beginnen; sie lässt sich auch hier ablegen
load-networks = Netze laden

## src/app/panels/learning/curves.rs

feedback-s-share-of-the-override = Anteil der Rückführung am Override [%]
error-of-nm-1-s-prediction = Fehler der Vorhersage von NM-1 [%]
internal-loop-now-iterations-now-mean-on-ave = Innere Schleife: jetzt { $now } Iterationen, bisher im Mittel { $mean }
means-of-the-size-over-about-a-second-in-con = Mittel des Betrags über etwa eine Sekunde im Eingriff. Der Anteil der Rückführung ist alles, was die Schleifen zu NM-2 hinzufügen, wo der Override zwischen seinen Grenzen liegt.
mean-of-its-size-over-about-a-second-in-cont = Mittel des Betrags über etwa eine Sekunde im Eingriff, wo der Override zwischen seinen Grenzen liegt.
playhead = Abspielmarke

## src/app/panels/learning/mod.rs

no-networks-at-the-playhead-yet = Noch keine Netze an der Abspielmarke.
positive = positiv
negative = negativ
f-is-the-measured-force-f1-and-f2-what-it-wa = F ist die gemessene Kraft, F1 und F2 sind die vor einem und zwei Regeltakten; a ist der Override, den der Vorschubantrieb erreicht hat, u der geforderte.
a-dot-in-a-neuron-is-its-bias-beside-the-wei = Ein Punkt in einem Neuron ist sein Bias. Neben den Gewichten markiert ein Ring die Neuronen, die sich am meisten geändert haben.
nm-2-is-the-inverse-model-it-asks-for-the-ov = NM-2 ist das inverse Modell: Es fordert den Override allein. Es beginnt untrainiert und fordert 100 %, anfangs tut also die Rückführung alle Arbeit, wie beim Divisionsregler.
what-the-feedback-adds-is-what-nm-2-has-not = Was die Rückführung hinzufügt, hat NM-2 nicht gewusst: Es lernt daraus, Abtastung für Abtastung (Feedback-Error-Learning). Während es lernt, sinkt der Anteil der Rückführung.
nm-1-has-no-part-in-the-cold-start-and-does = NM-1 hat am Kaltstart keinen Anteil und lernt nicht.
nm-2-is-the-inverse-model-it-asks-for-the-ov-2 = NM-2 ist das inverse Modell: Es fordert den Override, der die gewünschte Kraft ergibt. NM-1 ist das Vorwärtsmodell: Es sagt die Kraft eines Overrides vorher, und eine innere Schleife korrigiert damit den Override, bevor er gesendet wird.
both-were-trained-before-and-go-on-learning = Beide wurden vorher trainiert und lernen im Schnitt weiter: NM-1 aus der eingetretenen Kraft, NM-2 aus dem, was die Schleifen hinzugefügt haben.

## src/app/panels/learning/net.rs

weights = Gewichte
change-since-the-start = Änderung seit Anfang
links-as-thick-as-their-weights-rings-mark-w = Verbindungen so dick wie ihre Gewichte; Ringe markieren die größten Änderungen
links-as-thick-as-what-the-weights-have-chan = Verbindungen so dick wie die Änderung der Gewichte in diesem Schnitt
predicts-the-force = sagt die Kraft vorher
change-of-ln-f = Änderung von ln F
has-no-part-in-the-cold-start = hat am Kaltstart keinen Anteil
asks-for-the-override = fordert den Override
n-lessons-largest-weight-weight-largest-chan =
    { $n ->
        [one] { $n } Lektion; größtes Gewicht { $weight }, größte Änderung { $change }
       *[other] { $n } Lektionen; größtes Gewicht { $weight }, größte Änderung { $change }
    }

## src/app/panels/learning/passes.rs

passes-of-unks = Durchgänge von UNKS
the-same-part-again-and-again = Dasselbe Teil immer wieder
n-passes-without-the-changes-of-this-session =
    { $n ->
        [one] { $n } Durchgang ohne die Änderungen dieser Sitzung, dasselbe Teil, Rauschen und Startwert; Gelerntes wird mitgenommen.
       *[other] { $n } Durchgänge ohne die Änderungen dieser Sitzung, dasselbe Teil, Rauschen und Startwert; Gelerntes wird mitgenommen.
    }
stop-the-passes = Durchgänge anhalten
cut-n-passes =
    { $n ->
        [one] { $n } Durchgang fräsen
       *[other] { $n } Durchgänge fräsen
    }
done-of-n-passes = { $done } von { $n } Durchgängen
no-further-pass-because = Kein weiterer Durchgang: { $because }
made-with-other-settings-than-those-of-now = Mit anderen Einstellungen als den jetzigen gemacht.
begin-the-cut-with-the-networks-as-they-are = Den Schnitt mit den Netzen nach dem letzten Durchgang beginnen
use-these-networks = Diese Netze verwenden
pass = Durchgang
number-of-the-pass = Nummer des Durchgangs
normalised-standard-error-over-all-samples-i = Normierter Standardfehler über alle Abtastungen im Eingriff
time-2 = Zeit
time-of-the-cut-s = Schnittzeit, s
largest-force = Größte Kraft
feedback = Rückführung
mean-size-of-the-feedback-s-share-of-the-ove = Mittlerer Betrag des Anteils der Rückführung am Override, %
by-quarter-of-the-part-quarters = Nach Vierteln des Teils: { $quarters } %
nothing-is-learned-every-pass-is-the-same = Nichts wird gelernt: Jeder Durchgang ist gleich.
the-feedback-s-share-falls-pass-by-pass = Der Anteil der Rückführung sinkt von Durchgang zu Durchgang.
the-feedback-s-share-does-not-fall-pass-by-p = Der Anteil der Rückführung sinkt nicht von Durchgang zu Durchgang.
error-of-the-last-pass-against-the-first-cha = Fehler des letzten Durchgangs gegen den ersten: { $change } (nach Kaltstart am ganzen Teil: -{ $wanted } %).
error-of-the-last-pass-against-the-first-cha-2 = Fehler des letzten Durchgangs gegen den ersten: { $change }.

## src/app/panels/machine/controls.rs

machine-and-chip = Maschine und Span
wear = Verschleiß
sound-noise-and-prediction = Geräusch, Rauschen und Vorhersage
the-programmed-feed-speed-and-depth-of-cut-a = Programmierter Vorschub, Drehzahl und Schnitttiefe sind die der Konsole.

## src/app/panels/machine/life.rs

trends-over-the-tool-life = Verläufe über die Standzeit
life-of-one-tool = Leben eines Werkzeugs

## src/app/panels/machine/mod.rs

stability = Stabilität
vibration = Schwingung
the-masses-moving-the-frequency-response-and = Die bewegten Massen, der Frequenzgang und die Moden
wear-and-sound = Verschleiß und Geräusch
wear-sound-and-roughness-over-the-tool-s-lif = Verschleiß, Geräusch und Rauheit über die Standzeit und die vorhergesagte Standzeit
the-depth-at-which-the-cut-chatters-over-the = Die Tiefe, bei der der Schnitt rattert, über der Drehzahl
chatter-stability-lobes-sound-vibration-wear = Rattern Stabilität Rattersack Geräusch Schwingung Verschleiß Standzeit Moden Frequenzgang Grenztiefe
settings-of-the-machine = Einstellungen der Maschine

## src/app/panels/machine/picture.rs

five-masses-at-at-parts-scale = Fünf Massen bei { $at }: { $parts }. { $scale }
shape-of-a-mode-its-size-means-nothing = Form einer Mode: Ihre Größe bedeutet nichts
movement-drawn-times = Bewegung ×{ $times } gezeichnet

## src/app/panels/machine/plot.rs

title-from-from-to-to = { $title } von { $from } bis { $to }

## src/app/panels/machine/response.rs

g-rel-tooth-to-work = |G_rel| Zahn–Werkstück
h33-tooth = |H33| Zahn
hww-work = |Hww| Werkstück
the-frequency-response = der Frequenzgang
frequency-response-unit = Frequenzgang [{ $unit }]
modes = Moden
passing-teeth = Zahneingriffe
cursor-frequency = Cursorfrequenz
the-cursor-drag-it-here-or-in-the-plot-or-us = Der Cursor: hier oder im Diagramm ziehen oder die Pfeiltasten benutzen
to-3000-hz = bis 3000 Hz
to-600-hz = bis 600 Hz
phase = Phase
at-at-said = Bei { $at }: { $said }
response = Frequenzgang
mode-number-at = Mode { $number }, { $at }
cursor = Cursor

## src/app/panels/machine/sound.rs

the-sound-of-the-cut-as-the-model-gives-it-p = Das Schnittgeräusch, wie das Modell es angibt: Zahneingriffe und Zufallskraft bei dieser Drehzahl, mit Verschleiß lauter. Es klingt, während der Schnitt läuft.
sound-of-the-cut = Schnittgeräusch
sound-on = Ton ein
sound-off = Ton aus
volume = Lautstärke
no-sound-problem = Kein Ton: { $problem }.
silent-while-the-cut-is-paused = stumm, während der Schnitt angehalten ist

## src/app/panels/machine/stability.rs

limit-depth-at-this-speed = Grenztiefe bei dieser Drehzahl
quiet-at-speed-up-to-limit-limit-depth-at-an = Bei { $speed } ruhig bis { $limit } (Grenztiefe), bei jeder Drehzahl bis { $any }.
quiet-at-speed-up-to-highest-at-least-no-lim = Bei { $speed } ruhig bis mindestens { $highest }: keine Grenztiefe gefunden; bei jeder Drehzahl bis { $any }.
stability-chart = Stabilitätskarte
no-chart-can-be-made-of-this-machine = Von dieser Maschine lässt sich keine Karte machen
charted-cut = Karte: { $cut }.
go-on-with-the-chart = Mit der Karte fortfahren
structure = Struktur
n-measured-modes-at-the-tool-s-tip = { $n } gemessene Moden an der Werkzeugspitze
takes-the-measured-modes-away-the-five-masse = Nimmt die gemessenen Moden weg: die fünf Massen von 2019 gelten wieder
back-to-the-five-masses = Zurück zu den fünf Massen
spindle-quality = Güte der Spindel
q-5-by-its-damper = Q 5, nach ihrem Dämpfer
the-printed-damper-of-2348-n-s-m-belongs-to = Der gedruckte Dämpfer von 2348 N s/m gehört dazu
q-17-as-printed = Q 17, wie gedruckt
the-quality-printed-in-the-table-a-third-of = Die in der Tabelle gedruckte Güte: ein Drittel der Dämpfung
the-cuts-of-this-run-are-being-judged = Die Schnitte dieses Laufs werden beurteilt
chatter-at-speed-and-depth-deep-from-from-to = Rattern bei { $speed } und { $depth } Tiefe, von { $from } bis { $to } der Bahn: Eine Störung wächst je Zahn auf das { $grown }-Fache
stable-at-speed-and-depth-deep-from-from-to = Stabil bei { $speed } und { $depth } Tiefe, von { $from } bis { $to } der Bahn, dem Schnitt dieses Laufs, der Rattern am nächsten ist: Eine Störung schrumpft je Zahn auf das { $grown }-Fache
stable-at-every-speed-up-to-any-by-the-lobes = Stabil bei jeder Drehzahl bis { $any }, nach den Rattersäcken.
nothing-can-chatter-the-chip-does-not-feel-t = Nichts kann rattern: Der Span spürt die Schwingung nicht.
depth-deep-it-is-quietest-near-speed-where-t = Bei { $depth } Tiefe ist es um { $speed } am ruhigsten, wo die Grenztiefe { $limit } ist.
depth-deep-it-is-quietest-near-speed-where-n = Bei { $depth } Tiefe ist es um { $speed } am ruhigsten, wo keine Grenztiefe gefunden wurde.
depth-deep-it-is-quiet-at-no-speed-of-the-ch = Bei { $depth } Tiefe ist es bei keiner Drehzahl des Diagramms ruhig.
at-the-playhead-no-cut = An der Abspielmarke: kein Schnitt.
at-the-playhead-speed-and-depth-deep-chatter = An der Abspielmarke, { $speed } und { $depth } Tiefe: Rattern, ×{ $grown }.
at-the-playhead-speed-and-depth-deep-no-chat = An der Abspielmarke, { $speed } und { $depth } Tiefe: kein Rattern, ×{ $grown }.
limit-depth = Grenztiefe
limit-depth-mm-over-the-speed-1-min-quiet-be = Grenztiefe [mm] über der Drehzahl [1/min]: unter der Linie ruhig
lobes = Rattersäcke
interrupted-cut = unterbrochener Schnitt
stable-at-every-speed = bei jeder Drehzahl stabil
furthest-into-chatter-in-the-run = am weitesten im Rattern im Lauf
nearest-to-chatter-in-the-run = im Lauf dem Rattern am nächsten
the-cut-now = der Schnitt jetzt

## src/app/panels/machine/vibration.rs

stop-the-masses = Massen anhalten
move-the-masses = Massen bewegen
the-contact-force-at-the-frequency-of-the-cu = Die Kontaktkraft mit der Frequenz des Cursors
at-the-cursor = Am Cursor
passing-teeth-2 = Zahneingriffe
the-contact-force-at-harmonic-times-the-toot = Die Kontaktkraft mit dem { $harmonic }-Fachen der jetzigen Zahneingriffsfrequenz
passing-teeth-harmonic = Zahneingriffe ×{ $harmonic }
mode-number-at-shown-at-slow-hz = Mode { $number }: { $at }, gezeigt mit { $slow } Hz
force-at-at-shown-at-slow-hz = { $force } bei { $at }, gezeigt mit { $slow } Hz
modes-2 = Moden
the-eigenvalues-of-this-machine-do-not-conve = Die Eigenwerte dieser Maschine konvergieren nicht.
mode = Mode
damping = Dämpfung
moves-most = am meisten bewegt
mode-number = Mode { $number }
let-it-swing = Schwingen lassen

## src/app/panels/machine/wear.rs

tool-life-used = Verbrauchte Standzeit
share-of-the-tool-s-life = Anteil der Standzeit
fraction-t-of-the-tool-s-life-that-is-drawn = Anteil τ/T der Standzeit, der gezeichnet und hörbar gemacht wird
the-tool-of-the-running-cut-which-wears-in-i = Das Werkzeug des laufenden Schnitts, das darin verschleißt
as-in-the-cut = Wie im Schnitt
go-on = Fortfahren
wear-land-land-force-force-sound-sound-ra-ra = Verschleißmarke { $land }, Kraft { $force }, Geräusch { $sound }, Ra { $ra }
wear-land-vb = Verschleißmarke VB
over-the-fraction-of-life = über dem Anteil der Standzeit
the-tool-of-the-running-cut-by-the-sound-of = Das Werkzeug des laufenden Schnitts, nach dem Geräusch der schwingenden Maschine
in-the-cut = Im Schnitt
remaining-left-at-the-programmed-cut-worn-ou = noch { $remaining } beim programmierten Schnitt, nach dem Geräusch verschlissen
remaining-left-at-the-programmed-cut = noch { $remaining } beim programmierten Schnitt
no-estimate-yet = noch keine Schätzung
estimated-once-the-cut-is-simulated = geschätzt, sobald der Schnitt simuliert ist
every-ten-minutes-the-cutting-speed-is-set-s = Alle zehn Minuten wird die Schnittgeschwindigkeit so gesetzt, dass das Werkzeug die gewünschte Standzeit erreicht, soweit sein Geräusch es zeigt
adjust-the-speed = Drehzahl anpassen
worn-out-after-time-at-last-speed = verschlissen nach { $time }, zuletzt { $speed }
not-worn-out-in-ten-times-the-desired-tool-l = nicht verschlissen in der zehnfachen gewünschten Standzeit, zuletzt { $speed }
cutting-minute-minute-at-last-speed = im Schnitt: Minute { $minute }, zuletzt { $speed }
sound-spectrum = Geräuschspektrum
sharp-tool = scharfes Werkzeug
worn-out = verschlissen
trends-over-the-life-each-from-0-to-1 = Verläufe über die Standzeit, jeder von 0 bis 1
sound-e-s = Geräusch E_S
roughness-ra = Rauheit Ra
predicted-life = Vorhergesagte Standzeit
t-90-of-the-belief = 90 % der Annahme
from-the-sound = aus dem Geräusch
desired = gewünscht
true = wahr
the-equations-are-being-solved-for-every-sec = Die Gleichungen werden für jede Sekunde gelöst.
here-found-r-r-largest-difference-difference = Hier: gefunden R = { $r }, größter Unterschied { $difference }.
here-with-the-noise-of-the-settings-r-r = Hier: mit dem Rauschen der Einstellungen R = { $r }.
the-paper-claim = Der Artikel: { $claim }.

## src/app/panels/papers/calibrations.rs

met-of-all-worst = { $met } von { $all }, { $worst }
sim = Sim
met-of-all = { $met } von { $all }
the-calibrations-side-by-side = Die Kalibrierungen nebeneinander
in-each-cell-final-values-of-the-row-within = In jeder Zelle: Endwerte der Zeile innerhalb ihrer Bänder und das größte Residuum in Bändern. Strecke und Regler haben dieselbe Kalibrierung, die Kraft der Strecke ist die der Formel.
progress-done = { $progress } fertig.

## src/app/panels/papers/claim.rs

model = Modell
claimed = behauptet
median = Median
the-claim-about-forces-4-against-6 = Die Behauptung über Kräfte: 4 % gegen 6 %
the-paper-claim-errors-of-the-force-here-ove = Der Artikel: { $claim }. Fehler der Kraft hier über dieselben { $n } neuen Zeilen.

## src/app/panels/papers/deviations.rs

ra-printed = Ra gedruckt
ra-run = Ra Lauf
force-printed = Kraft gedruckt
printed-read-corrected =
    { $printed }
    (korrigiert { $read })
force-run = Kraft Lauf
the-findings-speak-of-at-most-4-1-in-ra-and = Die Ergebnisse sprechen von höchstens 4,1 % in Ra und 5,2 % in der Kraft. Tabelle 3 selbst, Endwert gegen Sollwert, sagt mehr: { $extremes }. Proportionale Rückführung lässt eine bleibende Regelabweichung. Mit den identifizierten Modellen lassen die Läufe dieselbe.
section-4-makes-the-difference-between-desir = Abschnitt 4 macht den Unterschied zwischen gewünschtem und simuliertem Ra zum Kriterium und findet das Modell „efficient at gaining the desired surface roughness“, ohne Zahl dafür. Tabelle 1 selbst gibt eine: { $extremes }. Proportionale Rückführung lässt eine bleibende Regelabweichung. Mit den identifizierten Modellen lassen die Läufe eine derselben Art: zu rau in den feinen Schnitten, zu fein in den rauen.
ra-is-off-by-high-in-simulation-first-to-low = Ra weicht von { $high } in Simulation { $first } bis { $low } in Simulation { $second } ab
the-paper-s-own-deviations = Abweichungen des Artikels selbst

## src/app/panels/papers/machine.rs

springs-k-m-2-f-dampers-c-k-m-q-printed-then = Federn k = m (2 π f)², Dämpfer c = √(k m) / Q: gedruckt, dann nach der Regel.
node = Knoten
verdict = Urteil
printed-rule-rule = { $printed }, Regel { $rule }
open-machine = Maschine öffnen
what-the-equations-give = Was die Gleichungen ergeben
reproduced = Reproduziert
not-reproduced-and-why = Nicht reproduziert, und warum

## src/app/panels/papers/table.rs

start-feed = Startvorschub
start-speed = Startdrehzahl
final-force = Endkraft
final-feed = Endvorschub
final-speed = Enddrehzahl
produced-ra = Erzeugtes Ra
opens-the-scenario-name-in-the-console = Öffnet das Szenario { $name } in der Konsole
given = vorgegeben
residual-met = { $residual } erfüllt
residual-missed = { $residual } verfehlt
printed-compared-with-read = { $printed } (verglichen mit { $read })
at-the-end-of-simulation-number-states = Am Ende von Simulation { $number }: { $states }.
simulation-number-note = Simulation { $number }: { $note }.
force-without-a-verdict-the-paper-does-not-s = { $force }: ohne Urteil, der Artikel sagt nicht, wie er es erhält.
in-each-cell-printed-then-run-below-residual = In jeder Zelle: gedruckt, dann Lauf; darunter: Residuum und Urteil.
run = Lauf
residual = Residuum
simulation-number = Simulation { $number }

## src/app/panels/papers.rs

papers = Artikel
tables-errata-reproduction-published-calibra = Artikel Tabellen Errata Reproduktion veröffentlicht Kalibrierungen
calibration-of-plant-and-controller = Kalibrierung von Strecke und Regler:
plant-s-force-from = Kraft der Strecke aus:
papers-paper = Artikel: { $paper }
calibrations-paper = Kalibrierungen: { $paper }
claim-about-forces = Behauptung über Kräfte
combined-system-2005-table-1 = Kombiniertes System 2005, Tabelle 1
dynamic-model-2019-table-1 = Dynamisches Modell 2019, Tabelle 1
paper = Artikel:
table-1-compares-six-ways-of-control-on-expe = Tabelle 1 vergleicht sechs Arten der Regelung an Experiment 2. Ihre Zahlen stehen neben Läufen über viele Startwerte, mit dem, was im Blick auf sie gewählt wurde, in der Ansicht Vergleich.
open-compare = Vergleich öffnen
load-experiment-1 = Experiment 1 laden
load-the-five-steps = Die fünf Schritte laden
on-the-command-line-steadycut-papers-paper-2 = Auf der Befehlszeile: steadycut papers --paper 2005, mit --robustness und --beyond.
go-on-with-the-table = Mit der Tabelle fortfahren
final-values-as-they-are-the-table-s-forces = Endwerte, wie sie sind: Die Kräfte der Tabelle stammen aus der Formel, ein anderes Kraftmodell der Strecke gibt naturgemäß andere
no-simulation-is-done-yet = Noch ist keine Simulation fertig
each-row-is-run-in-time-from-its-printed-sta = Jede Zeile läuft in der Zeit von ihren gedruckten Startwerten aus, Rauschen aus, SDNRP; die Endwerte sind Mittel über die letzte von 15 s.
met-force-within-force-feed-feed-speed-speed = Erfüllt: Kraft innerhalb { $force } %, Vorschub { $feed } %, Drehzahl { $speed } %, Ra { $ra }.
errata = Errata
here-resolution = Hier: { $resolution }
met-of-n-final-values-met = { $met } von { $n } Endwerten erfüllt
met-of-n-final-values-met-so-far = { $met } von { $n } Endwerten bisher erfüllt
met-of-n-final-values-met-by-models-fitted-t = { $met } von { $n } Endwerten erfüllt, mit an ebendiese Zeilen angepassten Modellen
met-of-n-final-values-met-so-far-by-models-f = { $met } von { $n } Endwerten bisher erfüllt, mit an ebendiese Zeilen angepassten Modellen
met-of-n-final-values-met-by-formulas-of-one = { $met } von { $n } Endwerten erfüllt, mit eigenen Formeln
met-of-n-final-values-met-so-far-by-formulas = { $met } von { $n } Endwerten bisher erfüllt, mit eigenen Formeln

## src/app/panels/plan/answer.rs

the-search-was-stopped-move-the-swarm-goes-o = Die Suche wurde angehalten; „Schwarm bewegen“ setzt sie fort.
the-swarm-is-still-searching-to-the-end-shor = Der Schwarm sucht noch; „Zum Ende“ kürzt es ab.
not-programmed-why = Nicht programmiert: { $why }.
the-plan-is-programmed-feed-and-speed-the-pa = Der Plan ist programmiert, { $feed } und { $speed }: Das Teil wird von Anfang an gefräst, mit konstantem Vorschub.
the-plan-is-programmed-feed-and-speed-the-pa-2 = Der Plan ist programmiert, { $feed } und { $speed }: Das Teil wird von Anfang an gefräst, { $controller } verstellt den Vorschub von dort aus.
best-so-far = Bisher bester
optimum = Optimum
no-optimum = Kein Optimum
the-network-does-not-know-this-cut-material = Das Netz kennt diesen Schnitt nicht: Werkstoff, Härte oder Tiefen liegen außerhalb seiner Trainingsdaten, und die Kraft ist fortgesetzt.
cut-it-at-constant-feed = Mit konstantem Vorschub fräsen
programs-this-feed-and-speed-switches-the-co = Programmiert diesen Vorschub und diese Drehzahl, schaltet den Regler auf konstanten Vorschub und fräst in der Konsole von Anfang an: der Schnitt, der hier geplant ist. Ein Schritt Rückgängig.
use-as-programmed-values = Werte programmieren
programs-this-feed-and-speed-keeps-all-else = Programmiert diesen Vorschub und diese Drehzahl, lässt alles andere und fräst in der Konsole von Anfang an. Konstanter Vorschub wie programmiert ist dann dieser; ein Regler, der den Vorschub nach eigenen Modellen stellt, geht auf denselben wie vorher. Ein Schritt Rückgängig.
controller-moves-the-feed-on-from-the-progra = { $controller } verstellt den Vorschub vom programmierten aus sofort.
the-console-s-force-at-the-playhead-is-force-2 = Die Kraft der Konsole an der Abspielmarke ist { $force }, { $off } gegen die des Plans bei ihrer Tiefe, { $depth }.
feed-per-tooth = Zahnvorschub
cutting-speed = Schnittgeschwindigkeit
removal = Zeitspanvol.
time-at-this-feed = Zeit bei diesem Vorschub
with-tool-changes = mit Werkzeugwechseln
cost-of-cut-your-currency = Kosten des Schnitts, in Ihrer Währung
objective = Zielfunktion

## src/app/panels/plan/controls.rs

changed-during-the-cut-after-its-start-names = Während des Schnitts, nach seinem Anfang geändert: { $names }.
makes-the-values-at-the-playhead-those-of-th = Macht die Werte an der Abspielmarke zu denen des Anfangs und plant für sie
plan-for-the-values-now = Für die jetzigen Werte planen
what-is-sought = Was gesucht wird
the-heavier-a-weight-beside-the-others-the-m = Je schwerer ein Gewicht neben den anderen, desto mehr geht der Plan dorthin: Eine große Kraft ist eine nahe ihrer Grenze und braucht größeren Vorschub. Ein Gewicht allein ändert durch seine Größe nichts.
the-cut = Der Schnitt
swarm = Schwarm
costs-and-times = Kosten und Zeiten
a-plan-is-made-before-the-cut-changes-here-h = Ein Plan wird vor dem Schnitt gemacht: Änderungen hier gelten ab dessen Anfang.

## src/app/panels/plan/convergence.rs

mean-of-all-particles = Mittel aller Partikel
best-allowed = bester zulässiger
particles-at-an-allowed-place = Partikel an zulässigem Ort [%]
allowed = Zulässig

## src/app/panels/plan/legend.rs

the-map = die Karte
equal-force = gleiche Kraft
particles-full-allowed = Partikel (voll: zulässig)
their-own-bests = ihre eigenen besten
best-of-all = bester von allen
the-speed-searched = die gesuchte Drehzahl
outside-the-map = Außerhalb der Karte:
constraint-violated = { $constraint } (verletzt)
placeholder-no-public-data-of-this-machine-w = Platzhalter: keine öffentlichen Daten dieser Maschine gefunden
a-chosen-limit-of-the-process = gewählte Grenze des Prozesses
given-by-the-settings-or-a-data-sheet = durch Einstellungen oder Datenblatt gegeben
limit-limits-unit-source = Grenze: { $limits } { $unit } ({ $source }).
the-constraint-is-origin = Herkunft der Nebenbedingung: { $origin }.

## src/app/panels/plan/map.rs

cutting-speed-m-min = Schnittgeschwindigkeit [m/min]
feed-per-tooth-mm = Zahnvorschub [mm]
zoom-to-allowed = Auf Zulässiges zoomen
shows-the-part-of-the-map-that-holds-allowed = Zeigt den Teil der Karte mit zulässigen Schnitten
there-are-none-on-the-map = Auf der Karte gibt es keine
shows-the-whole-map-as-a-double-click-on-it = Zeigt die ganze Karte, wie ein Doppelklick darauf; Ziehen zoomt sie
whole-map = Ganze Karte
force-over-cutting-speed-and-feed-per-tooth = Kraft über Schnittgeschwindigkeit und Zahnvorschub; Optimum bei { $speed } und { $feed }
force-over-cutting-speed-and-feed-per-tooth-2 = Kraft über Schnittgeschwindigkeit und Zahnvorschub; bisher bester bei { $speed } und { $feed }

## src/app/panels/plan/readout.rs

force-by-the-network = Kraft nach dem Netz
force-in-the-run = Kraft im Lauf
ra-of-feed-marks = Ra der Vorschubmarken
spindle-power = Spindelleistung
deflection = Durchbiegung
tool-life = Standzeit
in-the-run-held = Im Lauf: { $held }
allowed-by-the-plan = nach dem Plan zulässig
violated-by-the-plan-s-own-forces-constraint = nach den Kräften des Plans verletzt: { $constraints }
let-go-of-this-place = Diesen Ort loslassen
force-by-the-plan-s-network-in-colour-where = Kraft nach dem Netz des Plans: farbig, wo der Schnitt zulässig ist, grau, wo eine Nebenbedingung ihn verbietet

## src/app/panels/plan/recommended.rs

recommended-conditions = Empfohlene Bedingungen
by-r-d-engagement = nach R_D: { $engagement }
engagement = Eingriff
engagement-how-the-cutter-stands-in-the-mate = Eingriff: wie der Fräser im Werkstoff steht
for-hardness-hb-a-cutter-of-diameter-engagem = Für { $hardness } HB, einen Fräser mit { $diameter }, { $engagement }:
speed-feed-a-tooth = { $speed }, { $feed } je Zahn
inside-the-table = in der Tabelle
outside-the-table-its-edge-answers = außerhalb der Tabelle: Ihr Rand antwortet
programs-these-values-as-a-start-for-the-pla = Programmiert diese Werte, als Anfang für Plan und Schnitt. Ein Schritt Rückgängig.
start-from-it = Damit beginnen
the-table-note = Die Tabelle: { $note }.

## src/app/panels/plan/relief.rs

turns-the-surface-so-does-a-drag-with-the-mo = Dreht die Fläche; Ziehen mit der Maus auch
turn-left = Links drehen
turn-right = Rechts drehen
force-surface-in-space-turned-by-turn-seen-t = Kraftfläche im Raum, um { $turn }° gedreht, aus { $tilt }° von oben gesehen

## src/app/panels/plan/search.rs

plan-search-of-the-swarm = Plan: Suche des Schwarms

## src/app/panels/plan/steps.rs

no-plan = kein Plan
nothing-feasible-values = nichts zulässig: { $values }
found-values = gefunden: { $values }
best-so-far-values = bisher bester: { $values }
values-the-optimum = { $values }, das Optimum
values-not-the-optimum = { $values }, nicht das Optimum
the-optimal-cutting-conditions-are-found-by = Die optimalen Schnittbedingungen werden mit PSO-NN gefunden
they-are-programmed = Sie werden programmiert
the-desired-roughness-is-set = Die gewünschte Rauheit wird gesetzt
the-reference-force-follows-from-letter-1 = Die Referenzkraft folgt aus { $letter }1
feed-and-speed-are-commanded-controller = Vorschub und Drehzahl werden vorgegeben ({ $controller })
the-measured-force-is-compared-with-the-refe = Die gemessene Kraft wird mit der Referenz verglichen
in-the-air = in der Luft
the-overrides-go-back-to-the-machine = Die Overrides gehen zurück an die Maschine
steps-5-to-7-are-repeated-to-the-end = Schritte 5 bis 7 werden bis zum Ende wiederholt
control-sample-number-of-all = Abtastung { $number } von { $all }
the-strategy-in-eight-steps = Die Strategie in acht Schritten
control-strategy-2013-section-2-values-at-th = Regelungsstrategie 2013, Abschnitt 2; Werte an der Abspielmarke des Laufs.

## src/app/panels/plan/table.rs

the-seven-constraints-there-at-depth-depth = Die sieben Nebenbedingungen dort, bei { $depth } Tiefe
the-list-is-origin = Herkunft der Liste: { $origin }.
constraint = Nebenbedingung
value = Wert
limit = Grenze
margin = Reserve
n-limits-of-the-machine-are-placeholders-no =
    { $n ->
        [one] { "*" } { $n } Grenze der Maschine ist ein Platzhalter: keine öffentlichen Daten gefunden.
       *[other] { "*" } { $n } Grenzen der Maschine sind Platzhalter: keine öffentlichen Daten gefunden.
    }
explain-constraint = { $constraint } erklären
binding = bindend

## src/app/panels/plan/transport.rs

again-from-the-same-random-start = Noch einmal vom selben Zufallsstart
search-again = Erneut suchen
the-swarm-stands-still = Der Schwarm steht still
pause-the-swarm = Schwarm anhalten
the-swarm-moves-on-at-its-end-again-from-the = Der Schwarm bewegt sich weiter; an seinem Ende: noch einmal von Anfang an
move-the-swarm = Schwarm bewegen
one-iteration-of-the-swarm = Eine Iteration des Schwarms
one-iteration = Eine Iteration
to-the-end-of-the-search = Zum Ende der Suche
to-the-end = Zum Ende
another-seed-another-random-start-and-nearly = Ein anderer Startwert: ein anderer Zufallsstart und fast dasselbe Optimum
other-seed = Anderer Startwert
done-iteration-iteration-of-at-most-most = fertig: Iteration { $iteration } von höchstens { $most }
stopped-iteration-iteration-of-at-most-most = angehalten: Iteration { $iteration } von höchstens { $most }
searching-iteration-iteration-of-at-most-mos = sucht: Iteration { $iteration } von höchstens { $most }
n-evaluations-of-the-force-surface =
    { $n ->
        [one] { $n } Auswertung der Kraftfläche
       *[other] { $n } Auswertungen der Kraftfläche
    }
at-once = sofort
speed-of-the-swarm = Tempo des Schwarms

## src/app/panels/plan.rs

plan = Plan
optimise-optimum-cutting-conditions-swarm-co = optimieren Optimum Schnittbedingungen Schwarm Nebenbedingungen Vorschub Drehzahl Partikel
settings-of-the-plan = Einstellungen des Plans
programmed-now = jetzt programmiert
programmed-now-outside-the-map = jetzt programmiert: außerhalb der Karte
the-force-as-a-surface-in-space-cut-by-the-p = Die Kraft als Fläche im Raum, von der Ebene ihrer Grenze geschnitten
n-iterations-of-the-swarm =
    { $n ->
        [one] { $n } Iteration des Schwarms
       *[other] { $n } Iterationen des Schwarms
    }
no-plan-can-be-made = Kein Plan möglich
the-settings-are-beside-or-below = Die Einstellungen stehen daneben oder darunter.

## src/app/panels/workpiece/blank.rs

the-part-is-another-one-than-that-of-name-no = Das Werkstück ist jetzt ein anderes als das von { $name }: Sein Rohteil wird nicht gezeigt.
the-blank-of-name-is-not-shown-why = Das Rohteil von { $name } wird nicht gezeigt: { $why }.
name-was-cut-with-another-cutter-cut-it-from = { $name } wurde mit einem anderen Fräser geschnitten: Schneiden Sie es neu aus dem Rohteil, um es zu sehen.
in-the-air-line-line = in der Luft, Zeile { $line }
axial-deep-radial-wide-line-line = { $axial } tief, { $radial } breit, Zeile { $line }
this-part-is-a-table-of-depths-along-its-way = Dieses Werkstück ist eine Tabelle von Tiefen entlang seines Wegs und hat keine Form im Raum: Gezeigt wird der Streifen entlang des Wegs. Ein Werkstück, das hier aus einem Programm entsteht, wird auch als Rohteil gezeigt.
the-blank-in-space-as-it-is-cut-up-to-the-pl = Das Rohteil im Raum, geschnitten bis zur Abspielmarke
blank = Rohteil
the-way-made-straight-with-the-fine-surface = Der Weg geradegezogen, mit der feinen Oberfläche der fertigen Wand
strip-along-the-way = Streifen entlang des Wegs
blank-in-space-place = Rohteil im Raum, { $place }
blank-x-y-z-mm = Rohteil { $x } × { $y } × { $z } mm

## src/app/panels/workpiece/judged.rs

within = innerhalb
too-rough-up-to-twice-as-far-off = zu rau, bis doppelt so weit daneben
rougher-still = noch rauer
smoother-than-asked = glatter als verlangt
too-large-up-to-twice-as-far-off = zu groß, bis doppelt so weit daneben
larger-still = noch größer
smaller-than-asked = kleiner als verlangt

## src/app/panels/workpiece/picture.rs

heights = Höhen ×
part-in-space-place-heights-drawn-times-time = Teil im Raum, { $place }, Höhen { $times }-fach vergrößert
tool-length-before-the-part = Werkzeug { $length } vor dem Teil
tool-at-place-of-length-mm = Werkzeug bei { $place } von { $length } mm
cut-number-of-all-tool = Schnitt { $number } von { $all }, { $tool }

## src/app/panels/workpiece/placed.rs

that-is-beside-the-part = Das ist neben dem Werkstück.
kind-press-on-the-part-to-place-it-escape-le = { $kind }: auf das Werkstück drücken, wo es liegen soll; Escape beendet
choose-one-then-press-on-the-part-where-it-i-2 = Eine wählen, dann auf das Teil drücken, wo sie beginnen soll; hinter dem Werkzeug wird neu gefräst. Mit gehaltener Umschalttaste setzt der nächste Druck eine weitere.
disturb-the-part = Das Teil stören
choose-one-then-press-on-the-part = Eine wählen, dann auf das Teil drücken
then-press-on-the-part = Dann auf das Teil drücken.

## src/app/panels/workpiece/profile_chart.rs

as-the-teeth-left-it = wie die Zähne es hinterließen
roughness-profile = Rauheitsprofil
profile-m = Profil [µm]
name-height-along-along-the-line =
    { $name }: { $height }
    { $along } entlang der Linie
profile-from-from-to-to-along-the-line = Profil von { $from } bis { $to } entlang der Linie

## src/app/panels/workpiece/profilometer/fields.rs

a-drag = Ziehen
draws-the-line = zeichnet die Linie
turns-the-part = dreht das Teil
no-tooth-has-been-in-this-cut-yet-there-is-n = In diesem Schnitt war noch kein Zahn: Es gibt keine Oberfläche zu messen.
from-x = Von x
from-y = Von y
to-x = Bis x
to-y = Bis y
five-sampling-lengths-along-the-feed-as-the = Fünf Einzelmessstrecken in Vorschubrichtung, mit dem Werkzeug mitlaufend
behind-the-tool = Hinter dem Werkzeug
length-long = { $length } lang
over-one-sampling-length-of-long-the-standar = Über eine Einzelmessstrecke von { $long }; die Norm nimmt fünf.
over-n-sampling-lengths-of-long-the-standard =
    { $n ->
        [one] Über { $n } Einzelmessstrecke von { $long }; die Norm nimmt fünf.
       *[other] Über { $n } Einzelmessstrecken von { $long }; die Norm nimmt fünf.
    }
over-n-sampling-lengths-of-long =
    { $n ->
        [one] Über { $n } Einzelmessstrecke von { $long }.
       *[other] Über { $n } Einzelmessstrecken von { $long }.
    }
the-run-s-ra-with-dynamics-is-ra-along-the-l = Ra mit Dynamik des Laufs ist entlang der Linie im Mittel { $ra }.
simulated-tooth-by-tooth-k5-gives-no-ra-here = Zahn für Zahn simuliert, ergibt K5 hier kein Ra: Vorschubmarken und Rundlauffehler allein.

## src/app/panels/workpiece/program/picture.rs

what-is-left-of-the-blank-from-above-with-th = Was vom Rohteil bleibt, von oben, mit dem Weg des Werkzeugs

## src/app/panels/workpiece/program.rs

part-of-a-program = Werkstück eines Programms
name-n-moves = { $name }: { $n } Bewegungen
size-and-corner-of-the-rectangular-blank-in = Größe und Ecke des rechteckigen Rohteils in den Koordinaten des Programms; zuerst liegt es um die Vorschubbewegungen, mit 5 mm unter der tiefsten.
cut-it-from-the-blank = Aus dem Rohteil schneiden
with-the-cutter-of-the-scenario = Mit dem Fräser des Szenarios
size = Größe
size-of-the-blank-along-axis = Größe des Rohteils entlang { $axis }
least-corner = Kleinste Ecke
least-corner-of-the-blank-along-axis = Kleinste Ecke des Rohteils entlang { $axis }
step = Schritt
step-along-the-way = Schritt entlang des Weges
milling-name = Fräsen: { $name }
length-long-air-of-it-air-up-to-axial-deep-a = { $length } lang, davon { $air } Luft; bis zu { $axial } tief und { $radial } breit
make-it-the-part = Zum Werkstück machen
it-was-cut-with-another-cutter-cut-it-again = Es wurde mit einem anderen Fräser geschnitten: noch einmal schneiden

## src/app/panels/workpiece/view.rs

whole-part = Ganzes Teil
all-of-the-present-cut = Der ganze jetzige Schnitt
at-the-tool = Am Werkzeug
goes-along-with-the-tool = Geht mit dem Werkzeug mit
the-surface-right-behind-the-tool-near-enoug = Die Oberfläche gleich hinter dem Werkzeug, nah genug, um die Marke jedes Zahns zu sehen
close-up = Nahaufnahme
nearer = Näher
nearer-so-does-the-wheel = Näher; das Mausrad auch
farther = Weiter weg
farther-so-does-the-wheel = Weiter weg; das Mausrad auch
turns-the-picture-so-does-a-drag-over-it = Dreht das Bild; Ziehen darüber auch
higher = Höher
lower = Tiefer
follow-the-tool = Dem Werkzeug folgen
fingers-on-the-picture-turn-the-part-otherwi = Finger auf dem Bild drehen das Teil; sonst blättern sie die Seite
turn-by-touch = Mit Finger drehen
a-factor-of-your-own-otherwise-as-the-distan = Ein eigener Faktor; sonst, wie der Abstand es verlangt
own-factor = Eigener Faktor

## src/app/panels/workpiece.rs

part-surface-3d-profile-roughness-profilomet = Teil Oberfläche 3D Profil Rauheit Profilometer Bild
a-table-of-depths-along-a-path-csv-or-a-prog = Eine Tabelle von Tiefen entlang einer Bahn (CSV) oder ein Programm (G-Code), das aus einem Rohteil geschnitten wird; beides kann auch auf das Fenster gezogen werden
part-from-a-file = Werkstück aus einer Datei…
a-stylus-drawn-along-a-line-over-the-machine = Eine Tastspitze, entlang einer Linie über die bearbeitete Oberfläche gezogen: ihr Profil, Ra, Rq, Rz
profilometer = Profilometer
colour-ra-against-its-tolerance = Farbe: Ra gegen seine Toleranz
colour-ra-with-dynamics-against-its-toleranc = Farbe: Ra mit Dynamik gegen seine Toleranz
colour-force-against-its-tolerance = Farbe: Kraft gegen ihre Toleranz
colour-force-without-dynamics-against-its-to = Farbe: Kraft ohne Dynamik gegen ihre Toleranz
outside-the-model-not-judged = außerhalb des Modells: nicht beurteilt
disturbances-along-the-edges-of-the-part = Störungen, an den Kanten des Teils
cutting-edges = Schneiden
scrap-length-mm-at-a-cost-of-cost = Ausschuss: { $length } mm, Kosten { $cost }
length-of-the-way-beyond-the-tolerance-on-th = Länge des Wegs jenseits der Toleranz auf der schlechten Seite, mal `economics.scrap_cost_per_mm`
the-cutter-is-drawn-turning-times-times-slow-2 = Der Fräser ist { $times }-mal langsamer drehend gezeichnet.
the-blank-has-its-true-size-what-is-cut-has = Das Rohteil hat seine wahre Größe; was geschnitten ist, hat die Farbe des Augenblicks, in dem der Fräser zuletzt dort war.
too-rough-is-rework-or-scrap-smoother-than-a = Zu rau ist Nacharbeit oder Ausschuss; glatter als verlangt ist keines von beiden.
what-stands-in-front-of-the-wall-was-taken-b = Was vor der Wand steht, hat ein früherer Schnitt weggenommen.
simulated-tooth-by-tooth-k5-s-ra-does-not-ho = Zahn für Zahn simuliert, gilt das Ra von K5 nicht: Die Oberfläche zeigt Vorschubmarken und Rundlauffehler allein.
t-1-setting = 1 Einstellung
