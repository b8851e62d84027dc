# Deutsch

## crates/study/src/afc.rs

cut-number-is-not-reached-within-run-duratio = Schnitt { $number } wird innerhalb von `run.duration_s`, { $limit } s, nicht erreicht
cut-number-refused = Schnitt { $number }: { $refused }

## crates/study/src/compare/by_hand.rs

your-hand-2 = Ihre Hand
name-alone-holds-it-in-time-s = nur { $name } hält die Toleranz, in { $time } s
count-ways-of-control-hold-it-name-the-faste = { $count } Arten der Regelung halten die Toleranz, am schnellsten { $name } in { $time } s
no-way-of-control-holds-it-either = auch keine Art der Regelung hält die Toleranz
your-cut-did-not-come-to-its-end-so-it-has-n = Ihr Schnitt kam nicht ans Ende und hat daher keinen Rang ({ $why }); { $best }.
nothing-of-your-cut-can-be-judged-so-it-has = Von Ihrem Schnitt ist nichts beurteilbar, er hat daher keinen Rang; { $best }.
you-held-ra-in-tolerance-on-inside-of-the-le = Sie hielten Ra auf { $inside } % der Länge in Toleranz, verlangt sind { $asked } %: kein Rang; { $best }.
you-held-the-force-in-tolerance-on-inside-of = Sie hielten die Kraft auf { $inside } % der Länge in Toleranz, verlangt sind { $asked } %: kein Rang; { $best }.
you-held-ra-in-tolerance-on-inside-of-the-le-2 = Sie hielten Ra auf { $inside } % der Länge in Toleranz
you-held-the-force-in-tolerance-on-inside-of-2 = Sie hielten die Kraft auf { $inside } % der Länge in Toleranz
begin-and-no-way-of-control-holds-it-the-cut = { $begin }, und keine Art der Regelung hält die Toleranz: Der Schnitt gehört Ihnen.
as-fast-as-name = so schnell wie { $name }
time-s-slower-than-name = { $time } s langsamer als { $name }
time-s-faster-than-name = { $time } s schneller als { $name }
begin-and-come-in-as-number-rank-of-the-of-w = { $begin } und sind Nummer { $rank } der { $of }, die sie halten: { $than }, der schnellste Regler.
cuts-2 = Schnitte

## crates/study/src/compare/entrants.rs

conventional = Herkömmlich
division = Division
adjustable-pi = Nachgeführter PI
p-smith-predictor = P, Smith-Prädiktor
mrac-one-gain = MRAC, eine Verstärkung
preview = Vorausschau
tracking = Folgeregler
own-script = Eigenes Skript

## crates/study/src/compare/iterations.rs

runs = Läufe

## crates/study/src/compare/load_step.rs

never-back = nie zurück

## crates/study/src/compare/outcome.rs

periods-2 = Takte
more-is-better = Mehr ist besser.
less-is-better = Weniger ist besser.

## crates/study/src/compare/outside.rs

ra-lies-within-its-tolerance-wherever-it-is = Ra liegt überall, wo es beurteilt wird, in seiner Toleranz
the-force-lies-within-its-tolerance-wherever = die Kraft liegt überall, wo sie beurteilt wird, in ihrer Toleranz
the-machine-s-vibration-leaves-it-without-dy = das hinterlässt die Schwingung der Maschine, ohne Dynamik liegt Ra innerhalb
feed-and-speed-stay-as-programmed-whatever-t = Vorschub und Drehzahl bleiben wie programmiert, was immer der Schnitt tut
it-is-not-taught-in-so-the-feed-stays-as-pro = ohne Lehrschnitt bleibt der Vorschub wie programmiert
on-share-of-that-it-is-unstable-feed-and-for = auf { $share } % davon ist er instabil, Vorschub und Kraft schwingen, ohne abzuklingen
on-share-of-that-a-command-stands-at-its-lim = auf { $share } % davon steht ein Sollwert an seiner Grenze
it-holds-the-force-and-leaves-to-the-model-w = er hält die Kraft und überlässt dem Modell, welches Ra sie ergibt
its-law-does-not-integrate-an-error-remains = sein Gesetz integriert nicht: In Ruhe bleibt eine Regelabweichung
it-takes-time-after-each-change-and-noise-mo = er braucht nach jeder Änderung Zeit, und Rauschen bewegt ihn
it-takes-time-after-each-change = er braucht nach jeder Änderung Zeit
ra-lies-above-its-tolerance-on-above-and-bel = Ra liegt auf { $above } % der Länge über und auf { $below } % unter seiner Toleranz: { $cause }
ra-lies-above-its-tolerance-on-share-of-the = Ra liegt auf { $share } % der Länge über seiner Toleranz: { $cause }
ra-lies-below-its-tolerance-on-share-of-the = Ra liegt auf { $share } % der Länge unter seiner Toleranz: { $cause }
the-force-lies-above-its-tolerance-on-above = die Kraft liegt auf { $above } % der Länge über und auf { $below } % unter ihrer Toleranz: { $cause }
the-force-lies-above-its-tolerance-on-share = die Kraft liegt auf { $share } % der Länge über ihrer Toleranz: { $cause }
the-force-lies-below-its-tolerance-on-share = die Kraft liegt auf { $share } % der Länge unter ihrer Toleranz: { $cause }

## crates/study/src/compare/robustness.rs

no-dead-time = keine Totzeit
dead-time-40-ms = Totzeit 40 ms
dead-time-80-ms = Totzeit 80 ms
t-16mncrsi5-in-place-of-ck45 = 16MnCrSi5 statt Ck45
name-before-and-after-kn = { $name } { $before } und { $after } kN
unks-is-insensitive-to-the-workpiece-s-mater = UNKS ist unempfindlich gegen den Werkstoff des Werkstücks
largest-force-in-ck45-and-in-16mncrsi5-list = größte Kraft in Ck45 und in 16MnCrSi5: { $list }

## crates/study/src/compare/table_1.rs

the-part-eight-candidates-were-tried-convent = das Teil: Acht Kandidaten wurden versucht; die Zeile des herkömmlichen Fräsens ist damit kalibriert, nicht vorhergesagt, ebenso eine bestmögliche Zeit nahe 88 s; die Bahn von 488 mm folgt aus 115 s
inhomogeneity-5-run-out-3-um-air-feed-150-de = Inhomogenität 5 %, Rundlauffehler 3 µm, Luftvorschub 150 %, Totzeit 40 ms: einmal nach Plausibilität gesetzt, mit Blick auf herkömmliches Fräsen und einen idealen Regler
p-kp-1-1-is-the-stability-limit-at-the-heavi = P: Kp = 1,1 ist die Stabilitätsgrenze im schwersten Abschnitt; mit dem Smith-Prädiktor 1,6, von sieben Werten der dem Artikel nächste
mrac-some-25-settings-of-two-structures-were = MRAC: etwa 25 Einstellungen zweier Strukturen wurden versucht; die mitgelieferte mit fünf Parametern ist der Tabelle am nächsten, die mit einer Verstärkung ist die beste und ähnelt ihr nicht; die mit fünf Parametern hebt den Override höchstens 10 % je Takt, da bei 30 % extreme Kraft sie bei 3 von 20 Startwerten stoppte
division-of-three-readings-the-static-one-si = Division: von drei Lesarten die statische, da sie allein stabil ist, etwa 98 s braucht und zugleich ein schlechtes Nsn hat
adjustable-pi-and-unks-first-guesses-kept-af = Nachgeführter PI und UNKS: erste Annahmen, nach 11 und 9 anderen Einstellungen beibehalten; nicht an die Tabelle angepasst, aber ihr Nsn und ihre größte Kraft waren zu sehen, während das Teil gewählt wurde
experiment-1-lengths-and-depths-are-chosen-s = Experiment 1: Längen und Tiefen sind so gewählt, dass der letzte Abschnitt bei 650 N liegt und der Gewinn nahe 27 %
not-used-for-any-choice-dead-times-and-mater = für keine Wahl benutzt: Totzeiten und Werkstoffe der Robustheitstabelle, die rauschfreien Referenzläufe; was nach dem Lastsprung als Wiedereintritt zählt, wurde zweimal neu definiert, da die ersten beiden Definitionen nie eintraten
the-figures-with-the-part-and-the-traces-are = die Abbildungen mit Teil und Verläufen fehlen: Übereinstimmung zeigt, dass die Tabelle mit echten Kraftkonstanten und einer Grenze von 150 % physikalisch möglich ist, nicht mehr
division-0-29-and-1-25-kn-static-division-is = Division 0,29 und 1,25 kN: Statische Division ist von Bau aus glatt; über dem letzten Sollwert schwingt sie stattdessen, und verlangsamt ist sie besser als gedruckt, nicht schlechter
pi-94-s-any-integrating-controller-runs-the = PI 94 s: Jeder integrierende Regler fährt die leichten Abschnitte an der Grenze von 150 % und braucht hier nicht mehr als etwa 89 s; 6 s zwischen PI und UNKS bei fast gleichem Nsn können nicht allein vom Halten der Kraft kommen
mrac-s-time-in-every-run-with-five-parameter = Zeit von MRAC in jedem Lauf: Mit fünf Parametern bricht es aus, und bei manchen Startwerten stoppt eine Überlast; mit einer Verstärkung bricht es nicht aus
p-0-20-kp-1-1-is-all-that-the-dead-time-leav = P 0,20: Kp = 1,1 ist alles, was die Totzeit lässt; mit dem Smith-Prädiktor und 1,6 kommt es nahe heran
mrac-0-90-unks-0-91-and-pi-1-00-kn-reached-o = MRAC 0,90, UNKS 0,91 und PI 1,00 kN: nur an einer glatten Strecke erreicht; Zahn für Zahn setzen Rundlauffehler und Inhomogenität ihre Spitzen auf das Gehaltene
the-time-of-an-optimisation-step-what-was-ti = die Zeit eines Optimierungsschritts: Was gemessen wurde und was seine Iterationen sind, ist nicht gesagt; hier stehen die Kosten einer Aktualisierung und die Regeltakte nach einem Lastsprung
mrac-s-response-8-longer-constant-roughness = um 8 % längere Antwort von MRAC, konstante Rauheit, die Lernkurven: Der Artikel hat keine Daten
no-run-has-given-it = kein Lauf hat es ergeben
name-measure-within-percent-of-wanted = { $name }: { $measure } auf { $percent } % bei { $wanted }
mean-off = { $mean }, { $off } %
mean-off-over-the-finished-of-runs-runs-that = { $mean }, { $off } % über die { $finished } von { $runs } Läufen, die ans Ende kamen
unks-and-pi-the-next-has-next = { $unks } und { $pi }; der nächste hat { $next }
unks-and-adjustable-pi-are-the-two-best-in-n = UNKS und Nachgeführter PI sind die zwei besten nach Nsn
unks-measure-at-most-most = UNKS: { $measure } höchstens { $most }
n-periods-after-the-load-step =
    { $n ->
        [one] , { $n } Takt nach dem Lastsprung
       *[other] , { $n } Takte nach dem Lastsprung
    }
unstable-after-the-load-step = , nach dem Lastsprung instabil
never-back-after-the-load-step = , nach dem Lastsprung nie zurück
name-error-time-s-step = { $name } ({ $error } %, { $time } s{ $step })
nobody-is-within-percent-next-is-next = keiner liegt innerhalb von { $percent } %, der nächste ist { $next }
within-percent-of-it-list = innerhalb von { $percent } % davon { $list }
least-nsn-name-with-error-in-time-s-step-bes = kleinstes Nsn: { $name } mit { $error } in { $time } s{ $step }; { $beside }
measure-in-unit = { $measure } in { $unit }

## crates/study/src/csv_table.rs

there-is-no-line-with-the-names-of-the-colum = es gibt keine Zeile mit den Namen der Spalten
line-line-has-values-values-for-columns-colu = Zeile { $line } hat { $values } Werte für { $columns } Spalten; zwischen Zahlen mit Dezimalkomma gehören Semikolons, wie in `0,5;1,2`
line-line-has-values-values-for-columns-colu-2 = Zeile { $line } hat { $values } Werte für { $columns } Spalten
line-line-name-is-cell-allowed-is-a-finite-n = Zeile { $line }: `{ $name }` ist `{ $cell }`: zulässig ist eine endliche Zahl
line-line-comma-has-a-comma-which-separates = Zeile { $line }: `{ $comma }` hat ein Komma, das die Werte dieser Tabelle trennt: einen Dezimalpunkt schreiben oder die Werte mit Semikolons trennen
line-line-has-comma-line-other-cell-write-al = Zeile { $line } hat `{ $comma }`, Zeile { $other } `{ $cell }`: alle Zahlen mit demselben Dezimalzeichen schreiben und nichts zwischen Tausendern
there-is-no-line-with-the-names-of-the-colum-2 = es gibt keine Zeile mit den Namen der Spalten; nötig sind { $needed }
the-columns-are-found-missing-are-missing-ne = die Spalten sind { $found }; es fehlen { $missing }; nötig sind { $needed }
the-column-name-stands-there-more-than-once = die Spalte { $name } steht mehr als einmal da

## crates/study/src/errata.rs

t-1-0-001024-s-2-0-064-s-1-beside-natural-freq = 1 / (0.001024 s^2 + 0.064 s + 1) neben „natural frequency of 3 Hz and a settling time of 0.4 s“
its-natural-frequency-is-4-97-hz-critically = die Eigenfrequenz ist 4,97 Hz, aperiodischer Grenzfall; 3,2 Hz sind die -3-dB-Bandbreite; auf 2 % eingeschwungen in 0,19 s, auf 0,5 % in 0,24 s
both-are-kept-as-separate-drives-2013-eq1-an = beide bleiben als getrennte Antriebe, 2013_eq1 und measured_3hz
dead-time-2 = Totzeit
the-paper-has-none-2013-has-0-04-s-2007-e-0 = der Artikel hat keine; 2013 hat 0,04 s, 2007 e^(-0.08 s)
t-0-04-s-two-control-periods-papers-paper-2005 = 0,04 s, zwei Regeltakte; `papers --paper 2005 --robustness` zeigt 0, 40 und 80 ms
radial-depth-r-d-4-mm-in-the-english-text-3 = Schnittbreite (radial) R_D: 4 mm im englischen Text, 3 mm im slowenischen
they-differ-and-so-does-the-force-404-agains = sie sind verschieden, und so auch die Kraft: 404 gegen 281 N bei 0,08 mm und A_D = 2 mm
presets-experiment-1-with-4-mm-and-experimen = Szenarien experiment-1 mit 4 mm und experiment-1-sl mit 3 mm; 280 N als Sollkraft gehören zu 3 mm (`steadycut force`)
experiment-1-desired-force-280-n-in-the-set = Experiment 1: Sollkraft 280 N im Aufbau, 650 N in der Diskussion
at-r-d-4-mm-already-the-starting-depth-takes = bei R_D = 4 mm braucht schon die Anfangstiefe 404 N
t-650-n-with-r-d-4-mm-280-n-with-r-d-3-mm = 650 N mit R_D = 4 mm, 280 N mit R_D = 3 mm
experiment-2-desired-force-650-n-in-the-text = Experiment 2: Sollkraft 650 N im Text, 0,665 kN in Tabelle 1
they-differ-by-2 = sie unterscheiden sich um 2 %
t-665-n = 665 N
experiment-1-a-time-saving-of-40-with-one-cu = Experiment 1: „a time saving of 40 % with one cut“
with-an-override-of-at-most-150-no-more-than = mit höchstens 150 % Override sind nicht mehr als 33,3 % möglich, und 27 % mehr Zeitspanvolumen sind 21 % der Zeit
the-gain-in-removal-rate-is-judged-the-time = beurteilt wird der Gewinn an Zeitspanvolumen; die Zeit wird genannt
table-1-times-of-88-to-115-s = Tabelle 1: Zeiten von 88 bis 115 s
t-0-08-mm-two-teeth-and-1591-5-1-min-are-254-6 = 0,08 mm, zwei Zähne und 1591,5 1/min sind 254,65 mm/min, 115 s also eine Bahn von 488 mm und 76,7 s das Mindeste bei 150 %
all-six-times-fit-a-constant-programmed-feed = alle sechs Zeiten passen zu konstantem programmiertem Vorschub: Das Teil hat 488 mm
returns-the-cutting-force-value-to-the-desir = „returns the cutting-force value to the desired value level within four or less iterations“; der slowenische Text fügt 2 ms hinzu
t-0-5-ms-each-cannot-be-samples-of-20-ms = je 0,5 ms können keine Abtastungen von 20 ms sein
read-as-iterations-of-the-internal-loop-with = gelesen als Iterationen der inneren Schleife mit NM-1 innerhalb eines Regeltakts
sampling-time-20-ms-28-8-khz = Abtastzeit 20 ms, 28,8 kHz
t-576-samples-hold-one-tooth-period-of-18-85-m = 576 Abtastungen enthalten eine Zahnperiode von 18,85 ms, der Rundlauffehler macht also eine Spitze hoch und die nächste niedrig
kept-what-is-judged-as-a-transient-is-the-me = beibehalten; was als Einschwingen beurteilt wird, ist das Mittel aus vier Spitzen
fig-5-a-step-of-the-feed-from-0-05-to-2-mm-t = Bild 5: ein Vorschubsprung von 0,05 auf 2 mm/Zahn
t-2-mm-a-tooth-would-break-a-cutter-of-16-mm = 2 mm je Zahn würden einen Fräser von 16 mm zerbrechen
read-as-0-2-mm-tooth = gelesen als 0,2 mm/Zahn
the-optimized-feedrate-would-always-be-equal = „the optimized feedrate would always be equal to the reference peak force“
a-feed-is-no-force-mistranslated = ein Vorschub ist keine Kraft: falsch übersetzt
read-as-the-right-override-would-be-100 = gelesen als: Der richtige Override wäre 100 %
a-d-and-r-d-in-the-english-text = „A_D“ und „R_D“ im englischen Text
in-another-order-than-in-the-slovene = in anderer Reihenfolge als im slowenischen
a-d-is-the-axial-depth-r-d-the-radial-one = A_D ist die axiale Schnitttiefe, R_D die Schnittbreite (radial)
fig-6-0-07-0-35-2-1-0-09-0-37-0-4 = Bild 6: 0.07, 0.35, 2.1, 0.09, 0.37, 0.4
without-names-presumably-learning-rates-and = ohne Namen; vermutlich Lernraten und Momente je Schicht
not-used-the-ranges-of-2013-are = nicht benutzt; benutzt sind die Bereiche von 2013
table-1-optimization-time-and-iterations-0-0 = Tabelle 1: „optimization time“ und „iterations“, 0,001 s / 18 bis 0,012 s / 34
what-was-timed-and-what-was-counted-is-not-s = was gemessen und was gezählt wurde, ist nicht gesagt
beside-them-stand-a-controller-s-cost-per-up = daneben stehen die Kosten einer Aktualisierung des Reglers und seine Regeltakte nach einem Lastsprung
eq-2-the-normalised-standard-error-over-n-20 = Gl. 2, der normierte Standardfehler, über n = 20 Abtastungen
which-20-is-not-said-the-spread-over-seeds-i = welche 20, ist nicht gesagt; die Streuung über Startwerte ist etwa 0,02
over-all-samples-in-contact-the-form-with-20 = über alle Abtastungen im Eingriff; die Form mit 20, gleichmäßig verteilt, steht daneben
t-8-s-time-delay = „t = 8 s: time delay“
the-transfer-functions-have-e-0-08-s = die Übertragungsfunktionen haben e^(-0.08 s)
dead-time-0-08-s = Totzeit 0,08 s
eq-2-s-14-0-s-2-155-s-35500 = Gl. 2: (s + 14.0) + (s^2 + 155 s + 35500)
a-sum-has-no-unit-gain-at-rest = eine Summe hat in Ruhe nicht die Verstärkung eins
a-product-14-x-35500-497000-the-printed-nume = ein Produkt: 14 x 35500 = 497000, der gedruckte Zähler
eq-1-with-the-constants-of-table-1 = Gl. 1 mit den Konstanten von Tabelle 1
gives-582508-s-3-169-0-s-2-38699-7-s-582508 = ergibt 582508 / (s^3 + 169.0 s^2 + 38699.7 s + 582508), mit anderen Polen als Gl. 2
both-are-kept-as-separate-drives-2007-eq1-an = beide bleiben als getrennte Antriebe, 2007_eq1 und 2007_eq2
reference-roughness-0-81-mm = „reference roughness 0.81 mm“
the-unit = die Einheit
t-0-81-um = 0,81 µm
k2-eq-5 = K2, Gl. 5
the-feed-is-negative-for-every-force-below-1 = der Vorschub ist für jede Kraft unter 177,07 N negativ, also für die Hälfte von Tabelle 3
re-identified-the-printed-form-runs-with-its = neu identifiziert; die gedruckte Form läuft mit begrenzten Sollwerten und als außerhalb des Bereichs markiert
k1-eq-4 = K1, Gl. 4
k1-0-81-um-188-0-n-where-table-3-has-178-5-n = K1(0,81 µm) = 188,0 N, wo Tabelle 3 178,5 N hat; bei 0,38 µm 139,7 N gegen 161,4 N
re-identified-from-table-3 = aus Tabelle 3 neu identifiziert
k3-eq-6 = K3, Gl. 6
gives-about-4100-1-min-where-table-3-has-abo = ergibt etwa 4100 1/min, wo Tabelle 3 etwa 2100 1/min hat
k4-eq-7 = K4, Gl. 7
exceeds-the-table-s-final-force-from-the-tab = übersteigt die Endkraft der Tabelle, aus deren eigenem Endvorschub und eigener Enddrehzahl, in den Simulationen 1 bis 9 um 32,8 N
only-the-intercept-is-wrong-253-66-in-place = nur der Achsenabschnitt ist falsch: 253,66 statt 286,44 N trifft alle zehn Zeilen auf 0,75 N
table-3-simulation-10-final-force-195-2-n = Tabelle 3, Simulation 10: Endkraft 195,2 N
from-the-table-s-own-feed-and-speed-the-rest = aus Vorschub und Drehzahl der Tabelle ergibt das berichtigte K4 190,2 N, was auch auf der Kraft-Rauheits-Kurve aller anderen Zeilen liegt
taken-as-a-misprint-of-190-2-n-the-printed-v = als Druckfehler für 190,2 N genommen; der gedruckte Wert steht daneben
k5-eq-8 = K5, Gl. 8
misses-the-table-s-roughness-by-up-to-30 = verfehlt die Rauheit der Tabelle um bis zu 30 %
the-exact-inverse-of-the-re-identified-k1 = das genaue Inverse des neu identifizierten K1
findings-deviation-of-ra-at-most-4-1-of-forc = Ergebnisse: Abweichung von Ra höchstens 4,1 %, der Kraft höchstens 5,2 %
in-the-paper-s-own-table-3-the-final-ra-is-o = in Tabelle 3 des Artikels selbst liegt das End-Ra von +31,6 % (Simulation 1) bis -22,4 % (Simulation 10) neben seinem Sollwert
the-table-s-own-deviations-are-reported = genannt werden die Abweichungen der Tabelle selbst
k1-to-k5-by-genetic-programming-from-185-mea = K1 bis K5 durch genetische Programmierung aus 185 Messungen
the-measurements-were-never-published-and-th = die Messungen wurden nie veröffentlicht, und die Endvorschübe und Enddrehzahlen der Tabelle liegen auf einer Geraden (Korrelation -0,995), woraus keine Formel von beiden folgt
calibration-genetic-k1-k2-k3-and-k5-found-an = Kalibrierung genetic: K1, K2, K3 und K5 durch genetische Programmierung in Tabelle 3 neu gefunden, K4 die gedruckte Form mit angepassten Konstanten (`steadycut identify genetic`); alle 40 Endwerte liegen in ihren Bändern
eq-3-m2-10-05-f-4 = Gl. 3 (M2): „10^05 F^4“
can-only-be-10-5-and-rounded-so-m2-gives-neg = kann nur 10^-5 sein; und so gerundet gibt M2 bei jeder Kraft von Tabelle 1 negative Vorschübe von Tausenden
restored-with-1-426371e-5-f-4-1-015767e-2-f = berichtigt mit 1.426371e-5 F^4 - 1.015767e-2 F^3, was die Endvorschübe von Tabelle 3 von 2007 aus deren Sollkräften ergibt; aus Tabelle 1 neu identifiziert
eq-4-m3-exponent-0-004 = Gl. 4 (M3): Exponent -0.004
gives-about-3700-1-min-where-table-1-has-abo = ergibt etwa 3700 1/min, wo Tabelle 1 etwa 2200 1/min hat
restored-with-0-0071-which-gives-the-final-s = berichtigt mit -0.0071, was die Enddrehzahlen aus den Anfangskräften auf 4,7 % ergibt; neu identifiziert
eq-6-m5-leading-coefficient-0-0001 = Gl. 6 (M5): führender Koeffizient 0.0001
gives-0-11-to-0-14-um-where-table-1-has-0-44 = ergibt 0,11 bis 0,14 µm, wo Tabelle 1 0,44 bis 0,99 µm hat, und kehrt bei 170,5 N um, innerhalb der Tabelle
restored-with-0-00012025-least-squares-which = berichtigt mit 0,00012025 (kleinste Quadrate), was noch um bis zu 0,19 µm verfehlt; neu identifiziert als genaues Inverses von M1
eq-2-m1 = Gl. 2 (M1)
m1-0-40-um-135-6-n-where-table-1-starts-from = M1(0,40 µm) = 135,6 N, wo Tabelle 1 bei 164,5 N beginnt und bei 157,5 N endet; bei 1,11 µm 219,5 N gegen 188,1 N
re-identified-from-table-1 = aus Tabelle 1 neu identifiziert
eq-5-m4 = Gl. 5 (M4)
exceeds-the-table-s-final-force-from-the-tab-2 = übersteigt die Endkraft der Tabelle, aus deren eigenem Endvorschub und eigener Enddrehzahl, um 12 bis 28 N und die Anfangskraft um 27 bis 36 N; kein einzelner Achsenabschnitt behebt das
the-printed-form-with-its-intercept-and-feed = die gedruckte Form mit neu identifiziertem Achsenabschnitt und Vorschubkoeffizienten, Drehzahlkoeffizient wie gedruckt
eq-1-1-0-001024-s-2-0-064-s-1-beside-natural = Gl. 1: 1 / (0.001024 s^2 + 0.064 s + 1) neben „natural frequency of 3 Hz and a settling time of 0.4 s“
its-natural-frequency-is-4-97-hz-critically-2 = die Eigenfrequenz ist 4,97 Hz, aperiodischer Grenzfall; 3,2 Hz sind die -3-dB-Bandbreite
both-are-kept-as-separate-drives = beide bleiben als getrennte Antriebe
neural-network-predictions-were-by-4-closer = „neural network predictions were by 4 % closer to the measurements, compared to 6 %“
the-3500-measurements-were-never-published-r = die 3500 Messungen wurden nie veröffentlicht; gelesen als mittlere Fehler von 4 % und 6 %
networks-and-formulas-are-trained-on-one-dat = Netze und Formeln sind an einem Datensatz aus dem mechanistischen Kraftmodell mit Messrauschen trainiert, die Formel durch genetische Programmierung; ihre Fehler stehen neben denen des Artikels, zutreffend oder nicht (`steadycut papers --paper 2013`)
section-2-1-seven-constraints-are-listed-in = Abschnitt 2.1: „seven constraints are listed in [18]“
the-list-is-not-given = die Liste ist nicht angegeben
the-usual-seven-of-milling-each-marked-as-ch = die üblichen sieben des Fräsens, jede als gewählt markiert, Maschinengrenzen in einer Datei von Platzhaltern
table-1-simulations-6-and-7 = Tabelle 1, Simulationen 6 und 7
the-force-differs-by-1-n-the-roughness-by-0 = die Kraft unterscheidet sich um 1 N, die Rauheit um 0,17 µm: Die Tabelle ist nicht glatt, keine glatte Funktion der Kraft trifft beide
ra-is-judged-within-0-08-um = Ra wird auf 0,08 µm beurteilt
section-2-3-momentum-rates-between-0-008-and = Abschnitt 2.3: „momentum rates between 0.008 and 0.01 are good“ für kleine Fehler, soll aber „not exceed 0.004 if the number of training cycles is also to be minimized“
no-momentum-serves-both = kein Moment dient beidem
steadycut-train-study-prints-both-rates-besi = `steadycut train --study` gibt beide Raten neben anderen aus
m1-to-m5-by-genetic-programming-from-200-mea = M1 bis M5 durch genetische Programmierung aus 200 Messungen
the-measurements-were-never-published-and-th-2 = die Messungen wurden nie veröffentlicht, und die Endvorschübe und Enddrehzahlen der Tabelle liegen auf einer Geraden (Korrelation -0,937)
calibration-genetic-m1-m2-m3-and-m5-found-an = Kalibrierung genetic: M1, M2, M3 und M5 durch genetische Programmierung in Tabelle 1 neu gefunden, M4 die gedruckte Form mit Drehzahlkoeffizient wie gedruckt und den anderen angepasst (`steadycut identify genetic`); alle 32 Endwerte liegen in ihren Bändern

## crates/study/src/errata_2019.rs

eq-1-row-1-c3-z3-z2-k3-z3-z2 = Gl. 1, Zeile 1: + c3 (z3' - z2') + k3 (z3 - z2)
the-force-between-2-and-3-cannot-act-on-the = die Kraft zwischen 2 und 3 kann nicht auf das Gestell wirken, und ihr Vorzeichen ist das keiner Feder
c5-z5-z1-k5-z5-z1-row-5-of-eq-2-hangs-the-ta = - c5 (z5' - z1') - k5 (z5 - z1): Zeile 5 von Gl. 2 hängt den Tisch mit k5 an das Gestell
eq-1-row-2-no-term-with-k3-c3 = Gl. 1, Zeile 2: kein Glied mit k3, c3
the-tooth-s-spring-ends-on-nothing-momentum = die Feder des Zahns endet im Nichts; der Impuls bleibt nicht erhalten
c3-z3-z2-k3-z3-z2-the-reaction-of-row-3 = - c3 (z3' - z2') - k3 (z3 - z2), die Gegenkraft von Zeile 3
eq-1-row-4-c4-z4-z3-k4-z4-z3 = Gl. 1, Zeile 4: c4 (z4' - z3') + k4 (z4 - z3)
ties-the-slides-to-the-tooth-without-reactio = bindet die Schlitten an den Zahn, ohne Gegenkraft in Zeile 3, und widerspricht Zeile 4 von Gl. 2
c4-z4-z5-k4-z4-z5 = c4 (z4' - z5') + k4 (z4 - z5)
eq-1-row-5-c5-z5-z4-k5-z5-z4 = Gl. 1, Zeile 5: - c5 (z5' - z4') - k5 (z5 - z4)
a-spring-of-negative-stiffness-k4-k5-remains = eine Feder negativer Steifigkeit k4 - k5 bleibt: Gl. 1 wie gedruckt ist instabil, mit einem reellen Pol bei 2 pi x 194,9 rad/s mit korrigierten Zahlen, bei 2 pi x 4057 und 2 pi x 78659 rad/s mit den gedruckten
c5-z5-z1-k5-z5-z1 = + c5 (z5' - z1') + k5 (z5 - z1)
eq-2-row-1-k1-k2-k3-and-k3-i-w-c3-z3 = Gl. 2, Zeile 1: k1 + k2 + k3 und -(k3 + i w c3) z3
not-symmetric-row-3-has-no-z1-row-5-has-one = nicht symmetrisch: Zeile 3 hat kein z1, Zeile 5 hat eines ohne Gegenstück
t-5-for-3-three-times-k1-k2-k5-c1-c2-c5-k5-i-w = 5 statt 3, dreimal: k1 + k2 + k5, c1 + c2 + c5, -(k5 + i w c5) z5
eq-2-row-2-k2-w-2-m2-i-w-c2 = Gl. 2, Zeile 2: (k2 - w^2 m2) + i w c2
the-tooth-s-reaction-is-missing-the-tool-poi = die Gegenkraft des Zahns fehlt: Die Werkzeugspitze hat in Ruhe 5.04e-9 m/N, wo die berichtigte Maschine 1.28e-7 hat, und keine Resonanz der Spindel
k2-k3-w-2-m2-i-w-c2-c3-and-k3-i-w-c3-z3 = (k2 + k3 - w^2 m2) + i w (c2 + c3) und -(k3 + i w c3) z3
eq-2-row-3-k3-i-w-c3-z2-k3-w-2-m3-i-w-c3-z3 = Gl. 2, Zeile 3: [k3 + i w c3] z2 - [(k3 - w^2 m3) + i w c3] z3 = -P
the-left-side-is-that-of-eq-1-times-1-the-ri = die linke Seite ist die von Gl. 1 mal -1, die rechte nicht: Beide Kräfte zeigen in dieselbe Richtung
the-left-side-times-1 = die linke Seite mal -1
eq-2-row-4-c-42 = Gl. 2, Zeile 4: c_42
there-is-no-such-coefficient = diesen Koeffizienten gibt es nicht
c4 = c4
table-1-k4-6-3e12-n-m = Tabelle 1: k4 = 6.3e12 N/m
the-rule-below-the-table-gives-6-26e8-with-6 = die Regel unter der Tabelle ergibt 6.26e8; mit 6.3e12 wäre c4 1.46e7, nicht die gedruckten 1.4e5
exponent-8 = Exponent 8
table-1-c5-2-6e8-n-s-m = Tabelle 1: c5 = 2.6e8 N s/m
the-rule-gives-2-62e5-2-6e8-means-q-0-003 = die Regel ergibt 2.62e5; 2.6e8 bedeutet Q = 0,003
exponent-5 = Exponent 5
table-1-c2-2348-n-s-m-beside-q-17 = Tabelle 1: c2 = 2348 N s/m neben Q = 17
sqrt-k-m-2348-5-00-q-17-needs-691-and-repeat = sqrt(k m) / 2348 = 5,00; Q = 17 braucht 691 und wiederholt die Masse m2 = 17 seiner Spalte
q-5-17-can-be-chosen-machine-spindle-quality = Q = 5; 17 ist wählbar (machine.spindle_quality)
table-1-k3-1-9e8-n-m-c3-0-5-n-s-m-m3-0-3e-6 = Tabelle 1: k3 = 1.9e8 N/m, c3 = 0.5 N s/m, m3 = 0.3e-6 kg
m3-is-rounded-to-one-digit-its-rule-gives-k3 = m3 ist auf eine Stelle gerundet: Seine Regel ergibt k3 = 2.03e8; kein m3, das auf 0.3e-6 rundet, ergibt c3 = 0,5 mit Q = 10
both-by-the-rule-c3-does-not-matter-up-to-30 = beide nach der Regel; c3 spielt bis 3000 Hz keine Rolle
table-1-unit-of-c-n-m-sec = Tabelle 1: Einheit von c N/m/sec
a-damper-s-unit-is-n-s-m = die Einheit eines Dämpfers ist N s/m
n-s-m = N s/m
note-of-table-1-p-cf-107-n = Anmerkung zu Tabelle 1: P_CF = 107 N
may-have-been-10-7-n-which-is-absurd-for-a-c = könnte 10^7 N gewesen sein, was für einen Schnitt absurd ist
t-107-n-the-order-of-the-forces-of-2007-and-20 = 107 N, die Größenordnung der Kräfte von 2007 und 2013
six-differential-equations-1 = „six differential equations (1)“
five-are-printed-for-five-nodes = fünf sind gedruckt, für fünf Knoten
five-table-and-work-piece-are-one-node = fünf; Tisch und Werkstück sind ein Knoten
substitution-xi-tau-xi-a-exp-i-w-tau = „substitution xi(tau) = xi_A exp(i w tau)“
another-symbol-than-zeta-for-the-same-quanti = ein anderes Symbol als zeta für dieselbe Größe
zeta = zeta
section-3-fig-4a-spectra-roughness-figure-3a = Abschnitt 3: „Fig. 4a .. spectra“, „roughness (Figure 3a)“
the-captions-say-the-opposite = die Bildunterschriften sagen das Gegenteil
t-3a-are-the-spectra-4a-is-the-roughness = 3a sind die Spektren, 4a ist die Rauheit
names-of-the-nodes-against-eq-2 = Namen der Knoten gegen Gl. 2
by-the-names-the-slides-carry-the-table-and = nach den Namen tragen die Schlitten den Tisch, und die Kraft wirkt auf den Tisch; nach Zeilen 4 und 5 trägt der Tisch die Schlitten, und die Kraft wirkt auf diese
variant-a-by-the-equations-variant-b-by-the = Variante A nach den Gleichungen, Variante B nach den Namen (machine.variant); G_rel unterscheidet sich um 2,9 %

## crates/study/src/experiment/measure.rs

no-chip-is-cut = es wird kein Span geschnitten
its-ra-lies-beyond-the-end-of-the-plant-s-mo = sein Ra liegt jenseits des Endes des Modells der Strecke

## crates/study/src/experiment/plan.rs

run-run-error = Lauf { $run }: { $error }

## crates/study/src/experiment/way/job.rs

cuts-cuts-is-not-possible-allowed-are-fewest = Schnitte: { $cuts } unzulässig; zulässig: { $fewest } bis { $most }
name-value-is-not-possible-allowed-is-0-to-m = { $name }: { $value } unzulässig; zulässig: 0 bis { $most }
there-are-no-models-yet = es gibt noch keine Modelle
the-table-has-no-such-row = die Tabelle hat keine solche Zeile
the-pilot-cuts-found-nothing = die Probeschnitte fanden nichts
nothing-is-planned = nichts ist geplant
percent-of-the-way-2 = Prozent des Wegs

## crates/study/src/experiment/way/models.rs

its-front-is-empty = ihre Front ist leer
name-none-of-the-count-formulas-found-can-be =
    { $count ->
        [one] { $name }: die { $count } gefundene Formel ist nicht verwendbar: { $why }
       *[other] { $name }: keine der { $count } gefundenen Formeln ist verwendbar: { $why }
    }
formula-is-not-certain-to-rise-with-input-ov = `{ $formula }` steigt über ihre Schnitte nicht sicher mit { $input }
formula-is-not-certain-to-fall-with-input-ov = `{ $formula }` fällt über ihre Schnitte nicht sicher mit { $input }
column-has-no-unit = `{ $column }` hat keine Einheit

## crates/study/src/experiment/way/pilot.rs

pilot-cuts-error-give-another-depth = Probeschnitte: { $error }: eine andere Tiefe angeben
pilot-cuts-no-chip-is-cut-give-other-depths = Probeschnitte: Es wird kein Span geschnitten: andere Tiefen angeben
pilot-cuts-value-gives-force-n-in-place-of-w = Probeschnitte: { $value } ergibt { $force } N statt { $wanted } N: eine andere Tiefe angeben
pilot-cuts-at-depth-mm-feeds-low-to-high-are = Probeschnitte bei { $depth } mm: Vorschübe { $low } bis { $high } sind kein Bereich
pilot-values = Probewerte

## crates/study/src/experiment/way/plant.rs

plant-formula-the-papers-k4-does-not-know-th = plant: formula: Das K4 der Artikel kennt den Fräser { $tool } nicht: zulässig ist { $allowed }
the-papers-k4-with-its-intercept-restored-ti = K4 der Artikel mit berichtigtem Achsenabschnitt, mal dem Faktor von Werkstoff und Härte
tooth-by-tooth-the-mechanistic-model-of-the = Zahn für Zahn, das mechanistische Modell des Fräsers { $tool } in { $material } (Kienzle-Gesetze; Werkstoffe außer Ck45 und 16MnCrSi5 nach dem Verhältnis ihrer Kräfte), sein größter Wert jedes Regeltakts
force-force-ra-what-that-force-leaves-by-the = Kraft: { $force }; Ra: was diese Kraft nach dem K5 der Artikel hinterlässt, was für anderen Fräser oder Werkstoff keine Messung bestätigt

## crates/study/src/experiment/way/state.rs

version-cannot-be-version-allowed-is-allowed = `version`: { $version } unzulässig; zulässig: { $allowed }
it-was-gone-with-other-settings-and-all-but = er wurde mit anderen Einstellungen gegangen, und alle außer der Zahl der Runden müssen gleich sein: mit { $found }, nicht { $own }
searches-cannot-be-count-allowed-is-allowed = `searches`: { $count } unzulässig; zulässig: { $allowed }

## crates/study/src/formula_place.rs

a-run-has-no-use-for-it-because = ein Lauf hat keine Verwendung dafür: { $because }

## crates/study/src/identify/drive/mod.rs

the-recording-has-count-samples-allowed-are = die Aufzeichnung hat { $count } Werte: erlaubt sind { $least } bis { $most }
the-recording-has-samples-that-are-no-number = die Aufzeichnung hat Werte, die keine Zahlen sind
the-command-never-changes-record-a-step = der Sollwert ändert sich nie: einen Sprung aufzeichnen

## crates/study/src/identify/fits/data.rs

one-and-other-have-different-times = `{ $one }` und `{ $other }` haben verschiedene Zeiten
the-samples-of-name-are-not-even-in-time-or = die Werte von `{ $name }` liegen nicht in gleichen Abständen, oder ihre Zeiten sind nicht bekannt: --layout rate_hz= angeben
missing-samples-of-name-are-missing-or-no-nu = { $missing } Werte von `{ $name }` fehlen oder sind keine Zahlen; erwartet werden vollständige Aufzeichnungen

## crates/study/src/identify/fits/drive.rs

feed-measured = Vorschub, gemessen
the-channel-with-the-feed-that-was-measured = Der Kanal mit dem gemessenen Vorschub.
a-feed = ein Vorschub
feed-asked-for = Vorschub, verlangt
the-channel-with-the-feed-that-was-asked-for = Der Kanal mit dem verlangten Vorschub. Was in einer Zeile steht, gilt von der vorigen an, wie in den Zeilen eines Laufs.
a-feed-that-was-asked-for-or-the-step-that-w = ein verlangter Vorschub oder der verlangte Sprung
step-at = Sprung bei
step-from = Sprung von
step-to = Sprung auf
the-step-that-was-asked-for-where-it-was-not = Der verlangte Sprung, wo er nicht aufgezeichnet ist: wann, von welchem und auf welchen Vorschub.
drive = Antrieb
dead-time-order-and-lag-of-the-feed-drive-fo = Totzeit, Ordnung und Verzögerung des Vorschubantriebs; vier Strukturen, verglichen nach den Kriterien von Schwarz und Akaike.
a-recording-of-a-step-of-the-feed-the-feed-t = Die Aufzeichnung eines Vorschubsprungs: der gemessene und der verlangte Vorschub in gleichen Zeitabständen, von vor dem Sprung, bis der Vorschub steht.
lag = Verzögerung
gain = Verstärkung
left-rms = Residuum, RMS
structures-compared-the-one-of-least-bic-is = Verglichene Strukturen; genommen wird die mit dem kleinsten BIC
structure-2 = Struktur
dead-time-s = Totzeit [s]
lag-s = Verzögerung [s]
this-recording-does-not-tell-one-from-other = diese Aufzeichnung unterscheidet nicht zwischen: { $one } und { $other }; ihre BIC liegen { $by } auseinander
samples-samples-period-s-apart-structure = { $samples } Werte im Abstand von { $period } s; { $structure }

## crates/study/src/identify/fits/force.rs

a-force = eine Kraft
force-along-the-feed = Kraft in Vorschubrichtung
the-channel-with-the-force-on-the-tool-along = Der Kanal mit der Kraft auf das Werkzeug in Vorschubrichtung, in N oder kN.
force-across-the-feed = Kraft quer zum Vorschub
the-channel-with-the-force-on-the-tool-acros = Der Kanal mit der Kraft auf das Werkzeug quer zum Vorschub, dorthin, wo die Zähne eintreten.
force-along-the-axis = Kraft längs der Achse
the-channel-with-the-force-on-the-tool-along-2 = Der Kanal mit der Kraft auf das Werkzeug längs seiner Achse, von der Spitze weg.
size-across-the-tool = Betrag quer zum Werkzeug
the-channel-with-the-size-of-the-force-acros = Der Kanal mit dem Betrag der Kraft quer zum Werkzeug, sqrt(Fx^2 + Fy^2), wo ihre Komponenten nicht aufgezeichnet sind.
forces-on-the-workpiece = Kräfte auf das Werkstück
the-forces-are-those-on-the-workpiece-as-of = Die Kräfte sind die auf das Werkstück, wie von einem Dynamometer darunter: Ihre Vorzeichen werden umgekehrt.
another-cutter-than-the-scenario-s = Ein anderer Fräser als der des Szenarios.
the-scenario-s = der des Szenarios
another-feed-than-the-scenario-s-mm-min = Ein anderer Vorschub als der des Szenarios, mm/min.
another-spindle-speed-than-the-scenario-s-1 = Eine andere Spindeldrehzahl als die des Szenarios, 1/min.
another-axial-depth-than-the-scenario-s-mm = Eine andere axiale Schnitttiefe als die des Szenarios, mm.
another-radial-depth-than-the-scenario-s-mm = Eine andere Schnittbreite als die des Szenarios, mm; eine Nut hat die des ganzen Fräsers.
keep-exponents-of-kienzle-s-laws-as-the-stee = Exponenten der Kienzle-Gesetze so lassen, wie der Stahl sie hat, wo der Schnitt sie nicht verrät.
keep-m-c-of-the-steel = m_c des Stahls behalten
keep-m-r-of-the-steel = m_r des Stahls behalten
keep-m-a-of-the-steel = m_a des Stahls behalten
scenario-workpiece-cuts-has-several-sections = { $scenario }: `workpiece.cuts` hat mehrere Abschnitte: --axial-depth und --radial-depth des aufgezeichneten angeben
forces = Kräfte
coefficients-of-the-force-model-tooth-by-too = Koeffizienten des Kraftmodells Zahn für Zahn (Kienzle-Gesetze), der Rundlauffehler jedes Zahns und der Winkel der Spindel.
forces-along-and-across-the-feed-or-along-th = Kräfte in Vorschubrichtung und quer dazu oder längs der Achse in einem gleichmäßigen Schnitt über mindestens eine Spindelumdrehung, etwa 60 Werte je Umdrehung und mehr; das Szenario wird Zahn für Zahn simuliert und hat Fräser und Schnitt.
choose-at-least-one-force = mindestens eine Kraft wählen
the-size-across-the-tool-is-for-recordings-w = der Betrag quer zum Werkzeug ist für Aufzeichnungen ohne Fx und Fy
k-letter-at-at-mm = k_{ $letter } bei { $at } mm
tooth-number-out-of-the-mean = Zahn { $number }, Abstand vom Mittel
shift-of-the-axis = Verschiebung der Achse
first-angle = erster Winkel
angle-of-the-spindle = Winkel der Spindel
condition = Kondition
samples-samples-turns-turns-at-speed-1-min-l = { $samples } Werte, { $turns } Umdrehungen bei { $speed } 1/min, auf { $places } Stellen einer Umdrehung gelegt; Gesetze k h^-m dieses Schnitts, h in mm

## crates/study/src/identify/fits/material.rs

force-largest-of-a-turn = Kraft, größte einer Umdrehung
the-channel-with-the-largest-force-of-a-revo = Der Kanal mit der größten Kraft einer Umdrehung, in N oder kN (`steadycut measured --peak` macht sie aus Komponenten).
the-channel-with-the-feed-mm-min-without-it = Der Kanal mit dem Vorschub, mm/min; ohne ihn gilt das Programm des Szenarios.
the-channel-with-the-spindle-speed-1-min-wit = Der Kanal mit der Spindeldrehzahl, 1/min; ohne ihn gilt das Programm des Szenarios.
a-spindle-speed = eine Spindeldrehzahl
position-along-the-path = Ort längs des Wegs
the-channel-with-the-position-along-the-path = Der Kanal mit dem Ort längs des Wegs, mm, wo das Teil mehrere Tiefen hat.
a-position = ein Ort
the-factor-of-the-material-s-force-over-that = Der Faktor der Kraft des Werkstoffs gegenüber Ck45 bei 200 HB, und die Härte, bei der der Werkstoff des Szenarios ihn hätte.
the-largest-force-of-each-revolution-in-a-cu = Die größte Kraft jeder Umdrehung in einem Schnitt, in gleichen Zeitabständen, 40 Werte und mehr; daneben Vorschub, Drehzahl und Ort, wo sie sich ändern; das Szenario hat Fräser, Teil und ein Kraftmodell, das ein Kennfeld ist, nicht Zahn für Zahn (das passt „Kräfte“ an).
plant-force-model-is-id-tooth-by-tooth-expec = `plant.force_model` ist { $id }, Zahn für Zahn: erwartet wird ein Szenario, dessen Kraft ein Kennfeld ist; die Zähne passt `steadycut identify force` an
hardness-of-material = Härte: { $material }
force-over-that-of-ck45-at-200-hb = Kraft gegenüber Ck45 bei 200 HB
the-model-was-used-outside-its-range-in-perc = das Modell wurde bei { $percent } % der Werte außerhalb seines Bereichs benutzt
one-factor-holds-wear-material-and-hardness = ein Faktor fasst Verschleiß, Werkstoff und Härte zusammen: Kräfte allein unterscheiden sie nicht
samples-samples-in-the-cut = { $samples } Werte im Schnitt

## crates/study/src/identify/fits/noise.rs

the-channel-with-the-force-in-n-or-kn = Der Kanal mit der Kraft, in N oder kN.
times-in-s-between-which-the-tool-was-in-the = Zeiten in s, zwischen denen das Werkzeug in der Luft war: Dort zeigt sich das Rauschen des Sensors.
sizes-of-the-sensor-s-noise-of-band-limited = Größen des Sensorrauschens, des bandbegrenzten Rauschens, der Inhomogenität des Werkstoffs und der Welligkeit beim Zahndurchgang.
the-force-of-a-steady-cut-even-in-time-256-s = Die Kraft eines gleichmäßigen Schnitts in gleichen Zeitabständen, 256 Werte und mehr, besser einige Sekunden bei 1 kHz; das Szenario hat Drehzahl, Zähne und Vorschub des Schnitts.
white-noise = weißes Rauschen
white-noise-in-the-air = weißes Rauschen in der Luft
band-limited-noise-of-the-force = bandbegrenztes Rauschen, von der Kraft
inhomogeneity-of-the-force = Inhomogenität, von der Kraft
ripple-at-tooth-passing-of-the-force = Welligkeit beim Zahndurchgang, von der Kraft
ripple-at-the-spindle-s-turns-of-the-force = Welligkeit mit der Spindelumdrehung, von der Kraft
name-not-seen-the-samples-are-too-far-apart = { $name }: nicht zu sehen, die Werte liegen dafür zu weit auseinander
the-shapes-of-the-noise-are-those-of-the-sce = die Formen des Rauschens sind die des Szenarios: das Band von { $low } bis { $high } Hz, die Korrelation über { $length } mm
noise-in-all-rms = alles Rauschen, RMS
r-of-mean-drift-and-ripple = R² von Mittel, Drift und Welligkeit
drift = Drift
density-of-the-noise = Dichte des Rauschens
frequency = Frequenz
samples-samples-about-mean-n-period-s-apart = { $samples } Werte um { $mean } N im Abstand von { $period } s

## crates/study/src/identify/fits/outcome.rs

value-not-determined = { $value }, nicht bestimmt
left-over-rms = Residuum, RMS
nothing-is-fitted-yet = es ist noch nichts angepasst

## crates/study/src/identify/fits/request.rs

within-2 = Zwischen
takes-the-samples-between-two-times-in-s-alo = Nimmt nur die Werte zwischen zwei Zeiten in s.
value-unit-cannot-be-allowed-is-a-number-fro = { $value } { $unit } geht nicht: erlaubt ist eine Zahl von { $low } bis { $high }
from-from-s-to-to-s-is-no-span-of-time-the-s = von { $from } s bis { $to } s ist keine Zeitspanne: Die zweite Zeit muss hinter der ersten liegen
there-is-no-channel-name-there-are-names = einen Kanal `{ $name }` gibt es nicht; es gibt { $names }
name-is-in-unit-expected-is-what-in-units = `{ $name }` ist in { $unit }; erwartet wird { $what } in { $units }
first-or-last = { $first } oder { $last }
choose-a-channel-expected-is-what = einen Kanal wählen; erwartet wird { $what }

## crates/study/src/identify/fits/structure.rs

frequency-2 = Frequenz
the-column-with-the-frequencies-hz-ascending = Die Spalte mit den Frequenzen, Hz, aufsteigend.
a-frequency = eine Frequenz
displacement-over-force-real-and-imaginary-p = Auslenkung durch Kraft: Real- und Imaginärteil oder Betrag und Phase.
a-displacement-over-a-force = eine Auslenkung durch eine Kraft
real-part = Realteil
imaginary-part = Imaginärteil
magnitude = Betrag
an-angle = ein Winkel
direction = Richtung
whether-the-response-is-along-or-across-the = Ob der Frequenzgang in Vorschubrichtung ist oder quer dazu.
number-of-modes = Anzahl der Moden
number-of-modes-without-it-as-many-as-there = Anzahl der Moden; ohne sie so viele, wie es Spitzen gibt, höchstens 8.
keep-the-other-direction = Die andere Richtung behalten
keeps-the-modes-that-the-scenario-has-in-the = Behält die Moden, die das Szenario in der anderen Richtung hat: So kommen beide aus zwei Aufzeichnungen, eine nach der anderen.
choose-real-and-imaginary-part-or-magnitude = Real- und Imaginärteil oder Betrag und Phase wählen
frequencies-damping-ratios-and-masses-of-the = Frequenzen, Dämpfungsgrade und Massen der Moden an der Werkzeugspitze, aus denen die Stabilität folgt.
a-frequency-response-at-the-tip-as-of-an-imp = Ein Frequenzgang an der Spitze, wie aus einem Klopftest: Frequenz, dazu Real- und Imaginärteil oder Betrag und Phase von Auslenkung durch Kraft; 20 Zeilen und mehr.
problem-where-noise-makes-peaks-say-how-many = { $problem }; wo Rauschen Spitzen macht, angeben, wie viele Moden es sind
mode-number-frequency = Mode { $number }: Frequenz
mode-number-damping-ratio = Mode { $number }: Dämpfungsgrad
mode-number-modal-mass = Mode { $number }: modale Masse
kept-from-the-scenario-n-modes-direction = aus dem Szenario behalten, { $direction }: { $n } Moden
the-machine-does-not-stand-in-the-loop-machi = die Maschine steht nicht im Regelkreis (machine.coupled): Bis dahin wirken die Moden nur in der Stabilitätskarte
flexibility-of-stiffer-modes-flexibility-um = Nachgiebigkeit steiferer Moden { $flexibility } um/N, die keine Mode ist
share-of-the-response = { $share } % des Frequenzgangs

## crates/study/src/identify/fits/wear.rs

the-column-with-the-cutting-speed-m-min = Die Spalte mit der Schnittgeschwindigkeit, m/min.
a-cutting-speed = eine Schnittgeschwindigkeit
time-in-the-cut = Zeit im Schnitt
the-column-with-the-time-in-the-cut-min = Die Spalte mit der Zeit im Schnitt, min.
a-time = eine Zeit
the-column-with-the-width-of-the-flank-wear = Die Spalte mit der Verschleißmarkenbreite VB, mm.
a-width = eine Breite
the-column-with-the-feed-per-tooth-mm-where = Die Spalte mit dem Zahnvorschub, mm, wo er verändert wurde.
a-feed-per-tooth = ein Zahnvorschub
the-column-with-the-axial-depth-mm-where-tha = Die Spalte mit der axialen Schnitttiefe, mm, wo sie verändert wurde.
a-depth = eine Tiefe
number-of-the-tool = Nummer des Werkzeugs
the-column-with-the-number-of-the-tool-where = Die Spalte mit der Nummer des Werkzeugs, wo mehrere denselben Schnitt machten.
wear-land-at-the-end = Verschleißmarke am Ende
the-wear-land-at-which-a-tool-s-life-ends-mm = Die Verschleißmarkenbreite, bei der die Standzeit endet, mm.
taylor-s-constants-n-and-c-of-the-tool-s-lif = Die Taylor-Konstanten n und C der Standzeit, und die Exponenten von Vorschub und Tiefe, wo diese verändert wurden.
a-table-with-a-reading-of-the-wear-land-in-e = Eine Tabelle mit einer Ablesung der Verschleißmarke in jeder Zeile, nach der Zeit geordnet: Schnittgeschwindigkeit, Zeit im Schnitt, Verschleißmarkenbreite; Werkzeuge bei mindestens zwei Schnittgeschwindigkeiten, bis zur Grenze verschlissen.
life-at-speed-m-min = Standzeit bei { $speed } m/min
c-of-v-t-n-c = C aus v T^n = C
exponent-of-the-feed = Exponent des Vorschubs
exponent-of-the-depth = Exponent der Tiefe
lives-of-the-tools = Standzeiten der Werkzeuge
life-min = Standzeit [min]
by-the-fit-min = nach der Anpassung [min]
share-of-the-life = { $share } % der Standzeit
deviation-of-the-lives = Abweichung der Standzeiten
not-told-as-many-constants-as-lives = nicht bekannt: so viele Konstanten wie Standzeiten
r-of-the-logarithms = R² der Logarithmen
life = Standzeit
count-lives-to-a-wear-land-of-land-mm = { $count } Standzeiten bis zu einer Verschleißmarke von { $land } mm

## crates/study/src/identify/force/fit.rs

the-run-out = Rundlauffehler
the-angle = Winkel
no-place-to-begin-the-fit = die Anpassung hat keinen Anfang
the-model-gives-no-forces-in-this-cut = das Modell ergibt in diesem Schnitt keine Kräfte

## crates/study/src/identify/force/fold.rs

axis-is-value-n-throughout-no-cut-was-record = { $axis } ist durchweg { $value } N: es wurde kein Schnitt aufgezeichnet; erwartet wird eine Kraft, die sich mit den Zähnen ändert
the-samples-do-not-fill-places-places-of-a-t = die Werte füllen { $places } Stellen einer Umdrehung nicht: erwartet wird eine längere Aufzeichnung oder mehr Werte je Umdrehung als { $count }
the-forces-do-not-repeat-with-the-turns-of-t = die Kräfte wiederholen sich nicht mit den Umdrehungen der Spindel bei { $speed } 1/min: erwartet wird ein gleichmäßiger Schnitt mit dieser Drehzahl

## crates/study/src/identify/force/mod.rs

these-forces-tell-nothing-of-k-letter-and-m = diese Kräfte sagen nichts über k_{ $letter } und m_{ $letter }: es sind die des Stahls, mit dem die Anpassung begann
this-cut-cannot-tell-names-apart-condition-c = dieser Schnitt kann { $names } nicht trennen (Kondition { $condition }): eine weitere Komponente oder einen anderen Vorschub aufzeichnen, oder einen Exponenten festhalten
a-tooth-stands-rest-um-off-what-a-shift-of-t = ein Zahn steht { $rest } um neben dem, was eine Verschiebung der Achse ergibt: der Fräser des Programms hat nur diese
what-is-left-repeats-from-turn-to-turn-place = was übrig bleibt, wiederholt sich von Umdrehung zu Umdrehung ({ $place } N): der Schnitt weicht vom Modell ab, und Werte können außerhalb ihrer Intervalle liegen
spindle-speed-2 = Spindeldrehzahl
axial-depth-2 = axiale Schnitttiefe
radial-depth-2 = Schnittbreite
slice-height-2 = Scheibenhöhe
the-name-is-value-unit-nothing-is-cut-expect = { $name }: { $value } { $unit }, es wird nichts geschnitten; erwartet wird eine Zahl über 0
axis-sample-sample-is-no-number = { $axis }: Wert { $sample } ist keine Zahl
the-recording-has-turns-turns-of-the-spindle = die Aufzeichnung hat { $turns } Umdrehungen der Spindel: erwartet wird mindestens eine
the-model-explains-share-of-the-forces-expec = das Modell erklärt { $share } % der Kräfte: erwartet werden Kräfte auf das Werkzeug in N, längs (Fx) und quer (Fy) zum Vorschub oder längs der Achse (Fz), aus dem angegebenen Schnitt

## crates/study/src/identify/force/settings.rs

plant-force-model-is-id-expected-is-a-scenar = `plant.force_model` ist { $id }: erwartet wird ein Szenario, dessen Kraft Zahn für Zahn simuliert wird, mechanistic

## crates/study/src/identify/genetic.rs

models = Modelle

## crates/study/src/identify/gp/columns.rs

no-rows-below-the-names-of-the-columns = keine Zeilen unter den Namen der Spalten
there-is-one-column = es gibt eine Spalte
a-target-and-an-input-need-two-columns-of-nu = Ziel und Eingang brauchen zwei Spalten mit Zahlen: { $which }

## crates/study/src/identify/gp/constants.rs

the-formula-is-too-large = die Formel ist zu groß
constants-constants-cannot-be-fitted-to-rows =
    { $constants ->
        [one] { $constants } Konstante lässt sich nicht an { $rows } Zeilen anpassen
       *[other] { $constants } Konstanten lassen sich nicht an { $rows } Zeilen anpassen
    }
the-formula-has-no-finite-value-on-some-row = die Formel hat in einer Zeile keinen endlichen Wert
a-constant-is-not-finite = eine Konstante ist nicht endlich

## crates/study/src/identify/gp/declared.rs

no-start-has-a-value-on-all-rows = kein Start hat in allen Zeilen einen Wert

## crates/study/src/identify/gp/folds.rs

the-search-repeated-without-each-row = die Suche ohne jede einzelne Zeile wiederholt
the-constants-fitted-without-each-row = die Konstanten ohne jede einzelne Zeile angepasst
the-constants-fitted-without-each-tenth-of-t = die Konstanten ohne je ein Zehntel der Zeilen angepasst

## crates/study/src/identify/gp/paper.rs

generations = Generationen

## crates/study/src/identify/gp/problem.rs

t-1-row-at-least-fewest-are-needed = 1 Zeile: mindestens { $fewest } sind nötig
rows-rows-at-least-fewest-are-needed = { $rows } Zeilen: mindestens { $fewest } sind nötig
count-inputs-allowed-are-1-to-most =
    { $count ->
        [one] { $count } Eingang: zulässig sind 1 bis { $most }
       *[other] { $count } Eingänge: zulässig sind 1 bis { $most }
    }
input-is-the-target-and-an-input = `{ $input }` ist Ziel und Eingang
the-input-input-is-named-twice = der Eingang `{ $input }` ist zweimal genannt
the-unit-of-column-is-not-known-give-it-with = die Einheit von `{ $column }` ist nicht bekannt: mit `--unit { $column }=UNIT` angeben, `1` für keine
name-is-value-in-every-row-nothing-can-be-to = `{ $name }` ist in jeder Zeile { $value }: Daraus folgt nichts
name-has-values-above-1e100-choose-another-u = `{ $name }` hat Werte über 1e100: eine andere Einheit wählen
a-and-b-lie-on-one-line-correlation-correlat = `{ $a }` und `{ $b }` liegen auf einer Geraden (Korrelation { $correlation }, Varianzinflation { $inflation }): Diese Zeilen trennen ihre Wirkungen nicht, und eine freie Formel von beiden wäre Zufall

## crates/study/src/identify/gp/range.rs

constant = konstant
rising = steigend
falling = fallend
turning = umkehrend
uncertain = unsicher

## crates/study/src/identify/gp/report.rs

the-constants-fitted-without-some-of-the-row = die Konstanten ohne einen Teil der Zeilen angepasst

## crates/study/src/identify/gp/search.rs

the-saved-search-has-formulas-that-cannot-be = die gespeicherte Suche hat Formeln, die es nicht geben kann

## crates/study/src/identify/gp/state.rs

the-search-was-of-another-table-of-other-col = die Suche galt anderer Tabelle, anderen Spalten, Einheiten oder anderem Startwert: Alle müssen sein, wie sie waren

## crates/study/src/identify/gp/template.rs

t-stands-there-twice-allowed-is-once = T steht zweimal da: zulässig ist einmal
the-bracket-of-t-is-not-closed = die Klammer von T ist nicht geschlossen
count-constants-allowed-are-most = { $count } Konstanten: zulässig sind { $most }
there-is-neither-a-constant-to-fit-nor-t-to = es gibt weder eine Konstante anzupassen noch T zu suchen
t-name-name-is-no-input-inputs-are-list = T({ $name }): `{ $name }` ist kein Eingang; Eingänge sind { $list }
part-beside-t-every-part-needs-one-constant = `{ $part }`: Neben T braucht jeder Teil eine Konstante, die ihn multipliziert, und keine andere
t-has-to-stand-in-the-sum-by-itself-as-in-a = T muss in der Summe für sich stehen, wie in `a + b*n^3 + T(f)`
a-part-of-the-template-has-no-finite-value-o = ein Teil der Vorlage hat in einer Zeile keinen endlichen Wert

## crates/study/src/identify/material.rs

the-recording-has-count-samples-of-the-force = die Aufzeichnung hat { $count } Werte der Kraft: erwartet werden mindestens { $least } und ebenso viele von Vorschub, Drehzahl und Position
force = Kraft
position-2 = Position
name-sample-sample-is-no-number = { $name }: Wert { $sample } ist keine Zahl
the-position-falls-expected-is-that-along-th = die Position fällt: erwartet wird die längs der Bahn
the-model-has-a-force-in-count-samples-expec = das Modell hat in { $count } Werten eine Kraft: erwartet werden mindestens { $least } im Schnitt, mit Vorschub in mm/min und Drehzahl in 1/min
the-forces-are-not-above-0-expected-is-the-s = die Kräfte liegen nicht über 0: erwartet wird der Betrag der Kraft

## crates/study/src/identify/noise.rs

what-count-samples-allowed-are-least-to-most = { $what }: { $count } Werte: erlaubt sind { $least } bis { $most }
what-sample-sample-is-no-number = { $what }: Wert { $sample } ist keine Zahl
the-cut-2 = Schnitt
expected-are-a-period-speed-feed-corners-of = erwartet werden Abtastzeit, Drehzahl, Vorschub, Eckfrequenzen des Bandes und Korrelationslänge über 0 und ein Zahn
the-force-does-not-vary-nothing-is-told-of-i = die Kraft ändert sich nicht: über ihr Rauschen sagt sie nichts
the-mean-force-is-mean-n-expected-is-a-cut-w = die mittlere Kraft ist { $mean } N: erwartet wird ein Schnitt mit einer Kraft über 0
at-rest = in Ruhe

## crates/study/src/identify/response/fit.rs

the-response-has-no-resonance-im-has-no-peak = der Frequenzgang hat keine Resonanz: -Im hat keine Spitze über 0; ist es Weg durch Kraft?

## crates/study/src/identify/response/table.rs

its-columns-are-names-wanted-are-frequency-h = ihre Spalten sind { $names }: gebraucht werden frequency_hz mit real_m_n und imaginary_m_n oder mit magnitude_m_n und phase_deg; _um_n für um/N
the-response-has-count-points-allowed-are-le = der Frequenzgang hat { $count } Punkte: erlaubt sind { $least } bis { $most }
the-frequencies-do-not-ascend-from-above-0-h = die Frequenzen steigen nicht von über 0 Hz an

## crates/study/src/identify/wear.rs

there-is-no-column-name-there-are-names = eine Spalte `{ $name }` gibt es nicht; es gibt { $names }
reading-number-expected-are-a-speed-feed-and = Ablesung { $number }: erwartet werden Geschwindigkeit, Vorschub und Schnitttiefe über 0, Zeit und Verschleißmarke von mindestens 0
reading-number-its-time-time-min-is-not-behi = Ablesung { $number }: ihre Zeit, { $time } min, liegt nicht hinter der Ablesung davor bei { $speed } m/min: eine Spalte mit der Nummer des Werkzeugs angeben
speed-m-min = { $speed } m/min
a-limit-of-land-mm-expected-is-a-number-abov = eine Grenze von { $land } mm: erwartet wird eine Zahl über 0
at-cut-the-first-reading-is-already-above-th = bei { $cut } liegt schon die erste Ablesung über der Grenze: die Standzeit liegt auf der Geraden vom neuen Werkzeug
at-cut-the-wear-land-does-not-come-to-land-m = bei { $cut } erreicht die Verschleißmarke { $land } mm nicht: weggelassen
count-tools-came-to-land-mm-all-at-one-cutti = { $count } Werkzeuge erreichten { $land } mm, alle bei einer Schnittgeschwindigkeit: erwartet werden mindestens zwei
count-tools-came-to-land-mm-expected-are-at = { $count } Werkzeuge erreichten { $land } mm: erwartet werden mindestens { $least }, eines je Konstante
speed-feed-and-depth-were-varied-only-togeth = Geschwindigkeit, Vorschub und Schnitttiefe wurden nur gemeinsam geändert: erwartet werden Schnitte, in denen sich eines allein ändert
the-life-does-not-fall-with-the-cutting-spee = die Standzeit fällt nicht mit der Schnittgeschwindigkeit: erwartet werden die Spalten mit Geschwindigkeit, Zeit und Verschleißmarke
depth-2 = Schnitttiefe
the-name-was-not-varied-its-exponent-stays-a = { $name } wurde nicht geändert: der Exponent bleibt, wie er im Szenario ist

## crates/study/src/library/facts.rs

names-and-more-more = { $names } und { $more } weitere
length-mm-long-at-most-depth-mm-deep = { $length } mm lang, höchstens { $depth } mm tief
n-moves = { $n } Bewegungen
n-lines = { $n } Zeilen
controller-length-mm = { $controller }, { $length } mm
it-is-none-of-the-files-that-this-program-re = es ist keine der Dateien, die dieses Programm liest
shape-1-tooth-d-mm = { $shape }, 1 Zahn, { $d } mm
shape-n-teeth-d-mm = { $shape }, { $n } Zähne, { $d } mm
t-1-mode-hz-hz = 1 Eigenschwingung, { $hz } Hz
n-modes-low-to-high-hz = { $n } Eigenschwingungen, { $low } bis { $high } Hz
k-c1-1-kc11-n-mm-m-c-mc-hb-hb = k_c1.1 { $kc11 } N/mm², m_c { $mc }, { $hb } HB
feed-drive-of-order-n = Vorschubantrieb der Ordnung { $n }
spindle-drive-of-order-n = Spindelantrieb der Ordnung { $n }
dead-time-s-s = Totzeit { $s } s
limits-at-most-feed-mm-min = Grenzen, höchstens { $feed } mm/min
limits = Grenzen

## crates/study/src/library/kind.rs

cutters = Fräser
materials = Werkstoffe
machines = Maschinen
structures-at-the-tool-s-tip = Strukturen an der Werkzeugspitze
parts = Werkstücke
programs-g-code = Programme (G-Code)
scripts = Skripte
scenarios = Szenarien
formulas = Formeln
tables = Tabellen
networks-of-unks = Netze von UNKS
saved-searches = Gespeicherte Suchen
results-of-missions = Ergebnisse von Missionen
not-readable = Nicht lesbar

## crates/study/src/library/mod.rs

size-mb-not-looked-into = { $size } MB, nicht angesehen
size-mb-files-of-its-kind-have-at-most-most = { $size } MB: Dateien dieser Art haben höchstens { $most } MB

## crates/study/src/machine_life/adaptive.rs

percent-of-the-life = Prozent der Standzeit

## crates/study/src/machine_life/mod.rs

sound-trend-and-roughness-trend-are-identica = Geräuschtrend und Rauheitstrend sind identisch (keine Zahl gedruckt)
calculated-and-measured-sound-trend-r-0-993 = berechneter und gemessener Geräuschtrend: R = 0,993; keine Messung veröffentlicht
calculated-and-measured-sound-spectrum-r-0-6 = berechnetes und gemessenes Geräuschspektrum: R = 0,684; keine Messung veröffentlicht
points-of-time = Zeitpunkte

## crates/study/src/machine_life/monte_carlo.rs

tools = Werkzeuge

## crates/study/src/mission/answer.rs

predictions-step-step-allowed-is-one-of-choi = `predictions`, Schritt { $step }: zulässig ist eines von choice, number und curve
predictions-step-step-is-answered-twice = `predictions`: Schritt { $step } ist zweimal beantwortet
path-is-set-to-value-the-mission-opens-open = `{ $path }` ist auf { $value } gesetzt: Die Mission gibt { $open } frei
path-is-changed-at-time-s-the-mission-opens = `{ $path }` ist bei { $time } s geändert: Die Mission gibt { $open } frei
the-change-of-path-at-time-s-is-part-of-the = die Änderung von `{ $path }` bei { $time } s gehört zur Mission und fehlt
predictions-step-step-asks-nothing-steps-tha = `predictions`: Schritt { $step } fragt nichts; Schritte, die fragen: { $all }
predictions-step-step = `predictions`, Schritt { $step }
entry-choice-is-number-allowed-is-1-to-most = { $entry }: choice ist { $number }: zulässig ist 1 bis { $most }
entry-number-is-number-allowed-are-finite-on = { $entry }: number ist { $number }: zulässig sind endliche Zahlen
entry-allowed-is-a-choice = { $entry }: zulässig ist eine Auswahl
entry-allowed-is-a-number = { $entry }: zulässig ist eine Zahl
entry-allowed-is-a-curve = { $entry }: zulässig ist eine Kurve
entry-curve-has-count-points-allowed-are-2-t =
    { $count ->
        [one] { $entry }: curve hat { $count } Punkt: zulässig sind 2 bis { $most }
       *[other] { $entry }: curve hat { $count } Punkte: zulässig sind 2 bis { $most }
    }
entry-curve-has-a-number-that-is-not-finite = { $entry }: curve hat eine Zahl, die nicht endlich ist
entry-the-times-of-the-curve-do-not-ascend = { $entry }: Die Zeiten der Kurve steigen nicht
bytes-bytes-at-most-most-are-read = { $bytes } Byte; höchstens { $most } werden gelesen
version-is-version-allowed-is-allowed = `version` ist { $version }: zulässig ist { $allowed }
mission-is-found-this-mission-is-own = `mission` ist `{ $found }`: Diese Mission ist `{ $own }`
link-holds-settings-and-changes-allowed-is-a = `link` enthält Einstellungen und Änderungen: zulässig ist ein Link oder set und edits

## crates/study/src/mission/condition.rs

allowed-is-one-of-list-between-two-formulas = zulässig ist eines von { $list } zwischen zwei Formeln
text-compares-twice-allowed-write-two-condit = `{ $text }` vergleicht zweimal: { $allowed }; zwei Bedingungen schreiben
text-compares-nothing-allowed = `{ $text }` vergleicht nichts: { $allowed }

## crates/study/src/mission/cut.rs

set-or-edits-error = `set` oder `edits`: { $error }
allowed-are-tables-of-settings-as-in-a-scena = zulässig sind Tabellen von Einstellungen, wie in einer Szenariodatei

## crates/study/src/mission/file/controls.rs

is-not-open-allowed-are-settings-of-controls = ist nicht offen: zulässig sind Einstellungen aus `controls.open`: { $open }
is-no-choice-allowed-are-settings-with-optio = ist keine Auswahl: zulässig sind Einstellungen mit Optionen
offers-count-options-allowed-are-2-at-least = bietet { $count } Optionen: zulässig sind mindestens 2 aus { $list }
lacks-own-that-of-the-mission-s-own-cut-is-a = ohne `{ $own }`: Die Option des eigenen Schnitts der Mission gehört zu den angebotenen

## crates/study/src/mission/file.rs

entry-at-line-line-problem = `{ $entry }` in Zeile { $line }: { $problem }
entry-has-count-entries-allowed-are-most = `{ $entry }` hat { $count } Einträge: zulässig sind { $most }
checks-is-empty-a-mission-checks-at-least-on = `checks` ist leer: Eine Mission prüft mindestens eine Bedingung
is-id-allowed-are-1-to-60-of-a-to-z-0-to-9-a = ist `{ $id }`: zulässig sind 1 bis 60 Zeichen aus a bis z, 0 bis 9 und -
is-empty-a-mission-has-a-title = ist leer: Eine Mission hat einen Titel
is-the-name-of-a-metric-allowed-is-another-n = ist der Name einer Kenngröße: zulässig ist ein anderer Name
allowed-is-one-of-options-number-and-curve = zulässig ist eines von options, number und curve
is-value-allowed-is-above-0-to-100 = ist { $value }: zulässig ist über 0 bis 100 %
has-count-options-allowed-are-2-to-most =
    { $count ->
        [one] hat { $count } Option: zulässig sind 2 bis { $most }
       *[other] hat { $count } Optionen: zulässig sind 2 bis { $most }
    }
has-right-and-right-if-allowed-is-one-of-the = hat `right` und `right_if`: zulässig ist eines davon
no-option-is-right-at-least-one-has-right-tr = keine Option ist richtig: mindestens eine hat right = true oder right_if
allowed-is-one-of-metric-signal-setting-chan = zulässig ist eines von metric, signal, setting, changes, prediction und ended
has-take-from-or-to-allowed-with-a-signal-on = hat take, from oder to: zulässig nur mit einem Signal
has-a-run-allowed-with-a-metric-a-signal-or = hat run: zulässig nur mit einer Kenngröße, einem Signal oder einem Ende
is-step-allowed-is-the-number-of-a-step-1-to = ist { $step }: zulässig ist die Nummer eines Schritts, 1 bis { $most }
is-empty = ist leer
entry-ended-no-end-id = `{ $entry }.ended`: kein Ende `{ $id }`
goes-from-from-to-to-allowed-is-from-0-on-an = geht von { $from } bis { $to }: zulässig ist ab 0, und from unter to
entry-signal-no-signal-id = `{ $entry }.signal`: kein Signal `{ $id }`
there-is-no-id-did-you-mean-near-allowed-is = es gibt kein `{ $id }` (ist `{ $near }` gemeint?): zulässig ist eines von { $list }
there-is-no-id-allowed-is-one-of-list = es gibt kein `{ $id }`: zulässig ist eines von { $list }
there-is-no-value-or-metric-name-did-you-mea = es gibt keinen Wert und keine Kenngröße `{ $name }` (ist `{ $near }` gemeint?): zulässig sind die aus [values] und { $list }
there-is-no-value-or-metric-name-allowed-are = es gibt keinen Wert und keine Kenngröße `{ $name }`: zulässig sind die aus [values] und { $list }

## crates/study/src/mission/link.rs

its-link-problem = ihr Link: { $problem }

## crates/study/src/mission/mod.rs

mission = Mission
answer = Antwort
path-is-set-to-value-the-mission-offers-list = `{ $path }` steht auf { $value }: Die Mission bietet { $list }

## crates/study/src/mission/result.rs

format-is-format-allowed-is-allowed = `format` ist `{ $format }`: zulässig ist `{ $allowed }`
mission-digest-is-found-this-mission-s-is-ow = `mission.digest` ist { $found }: Diese Mission hat { $own }; sie unterscheiden sich in mehr als Kommentaren
entry-says-said-the-answer-gives-found = `{ $entry }` sagt { $said }: Die Antwort ergibt { $found }

## crates/study/src/mission/shipped.rs

there-is-none-with-the-id-id-there-are-list = es gibt keine mit der id `{ $id }`; es gibt { $list }

## crates/study/src/mission/words.rs

left-at-most-right = { $left }: höchstens { $right }
left-at-least-right = { $left }: mindestens { $right }
left-the-same-as-right = { $left }: gleich { $right }
left-other-than-right = { $left }: ungleich { $right }
left-less-than-right = { $left }: weniger als { $right }
left-more-than-right = { $left }: mehr als { $right }
there-is-no-such-value = einen solchen Wert gibt es nicht
yours-is-off-by-percent = Ihrer weicht um { $percent } ab
yours-value = Ihrer: { $value }
yours-value-the-limit-limit = Ihrer: { $value }, die Grenze: { $limit }
value-within-percent-of-wanted = { $value }: innerhalb { $percent } von { $wanted }
the-value-of-the-cut-as-given = Wert des gegebenen Schnitts
the-value-at-constant-feed-as-programmed = Wert bei konstantem Vorschub wie programmiert
the-value-with-controller = Wert mit { $controller }
changes-during-the-cut = Änderungen während des Schnitts
changes-during-the-cut-2 = Änderungen während des Schnitts
prediction-in-step-step = Vorhersage in Schritt { $step }
of-the-cut-as-given = des vorgegebenen Schnitts
at-constant-feed-as-programmed = bei konstantem Vorschub wie programmiert
from-from-unit-on = ab { $from } { $unit }
from-to-to-unit = { $from } bis { $to } { $unit }
largest-value = größter Wert
least-value = kleinster Wert
largest-less-least-value = größter minus kleinster Wert
first-value = erster Wert
last-value = letzter Wert
ra-at-the-end = Ra am Ende
ra-at-the-end-off-its-target = Abweichung von Ra vom Sollwert am Ende
share-of-the-length-in-tolerance = Anteil der Länge in Toleranz
share-of-the-length-above-the-tolerance = Anteil der Länge über der Toleranz
share-of-the-length-in-tolerance-with-dynami = Anteil der Länge in Toleranz mit Dynamik
share-of-the-length-above-the-tolerance-with = Anteil der Länge über der Toleranz mit Dynamik
share-of-the-length-that-is-not-judged = Anteil der Länge, der nicht beurteilt wird
force-at-the-end = Kraft am Ende
force-at-the-end-off-its-reference = Abweichung der Kraft von ihrer Referenz am Ende
largest-deviation-of-the-force-from-its-refe = Größte Abweichung der Kraft von ihrer Referenz
feed-at-the-end = Vorschub am Ende
spindle-speed-at-the-end = Spindeldrehzahl am Ende
normalised-standard-error = Normierter Standardfehler
normalised-standard-error-over-20-samples = Normierter Standardfehler aus 20 Abtastungen
settling-time-of-the-force = Ausregelzeit der Kraft
overshoot-of-the-force = Überschwingen der Kraft
length-of-path-done = Gefahrene Bahnlänge
length-of-scrap = Länge des Ausschusses
cost-of-the-scrap = Kosten des Ausschusses
cost-of-the-cut = Kosten des Schnitts
share-of-the-time-at-a-limit = Anteil der Zeit an einer Grenze
share-of-the-time-with-a-model-outside-its-r = Anteil der Zeit mit einem Modell außerhalb seines Bereichs

## crates/study/src/opening/frame.rs

embed-flag-allowed-behind-hide-are-list = embed: `{ $flag }`: hinter hide: zulässig sind { $list }
embed-flag-allowed-behind-lock-are-all-a-set = embed: `{ $flag }`: hinter lock: zulässig sind all, eine Einstellung oder eine Gruppe von Einstellungen: { $list }
embed-flag-allowed-behind-screen-is-the-name = embed: `{ $flag }`: hinter screen: zulässig ist der Name einer Ansicht
embed-flag-allowed-behind-lang-are-list = embed: `{ $flag }`: hinter lang: zulässig sind { $list }
embed-flag-allowed-are-hide-lock-screen-and = embed: `{ $flag }`: zulässig sind hide, lock, screen und lang, je mit Doppelpunkt und Wert

## crates/study/src/opening/mod.rs

the-link-was-not-used-title-is-open-instead = Der Link wurde nicht benutzt, stattdessen ist „{ $title }“ offen. { $error }
embed-error = embed: { $error }
the-mission-title-begins-anew-the-cut-of-the = Die Mission „{ $title }“ beginnt neu: Der Schnitt des Links wurde nicht benutzt. { $problem }

## crates/study/src/own_file/entry.rs

line-line-problem = Zeile { $line }: { $problem }

## crates/study/src/own_file/limits.rs

at-most-speed-max-rpm-most-1-min = höchstens `speed_max_rpm`, { $most } 1/min
spindle-drive-stands-in-the-place-of-lag-and = { "[" }spindle_drive] steht an der Stelle von Verzögerung und Ratengrenze
there-is-nothing-in-limits = in [limits] steht nichts

## crates/study/src/own_file/machine.rs

machine-file = Maschinendatei
the-pole-re-and-im-rad-s-lacks-its-conjugate = dem Pol { $re } und { $im } rad/s fehlt der konjugierte, { $re } und { $other }
t-2-to-n-coefficients-above-0-a0-first-with-an = 2 bis { $n } Koeffizienten über 0, a0 zuerst: mit anderem Vorzeichen ist kein Antrieb stabil
one-of-poles-and-denominator-is-wanted-besid = daneben wird genau eines von `poles` und `denominator` gebraucht
a-drive-has-at-least-one-pole = ein Antrieb hat mindestens einen Pol
it-stands-without-poles = es steht ohne `poles`
the-feed-drive-stands-in-feed-drive-already = der Vorschubantrieb steht schon in [feed_drive]
there-is-nothing-in-it-dead-time-s-feed-driv-2 = darin steht nichts: dead_time_s, [feed_drive], [spindle_drive] oder [limits]

## crates/study/src/own_file/material.rs

material-file = Werkstoffdatei

## crates/study/src/own_file/mod.rs

file-of-your-own = eigene Datei
it-is-none-of-a-cutter-diameter-mm-teeth-a-s-2 = es ist weder ein Fräser (diameter_mm, teeth) noch eine Struktur ([[mode]]), ein Werkstoff (kc11_n_mm2) oder eine Maschine ([feed_drive], poles oder [limits])

## crates/study/src/papers/calibrations.rs

calibrations = Kalibrierungen

## crates/study/src/papers/table_job.rs

simulations = Simulationen

## crates/study/src/papers.rs

the-paper-prints-a-final-force-of-195-2-n-mo = der Aufsatz druckt eine Endkraft von 195,2 N, höchstwahrscheinlich ein Druckfehler für 190,2 N: Der Lauf wird mit 190,2 N verglichen. Das Modell K4 (berichtigt) ergibt für Vorschub und Drehzahl dieser Zeile 190,2 N, und mit dieser Kraft passt ihr Ra zu denen aller anderen Zeilen

## crates/study/src/papers_2019.rs

natural-frequencies-without-damping-list-hz = Eigenfrequenzen ohne Dämpfung: { $list } Hz
one-resonance-between-tooth-and-work-from-0 = eine Resonanz zwischen Zahn und Werkstück von 0 bis 3000 Hz: { $peak } m/N bei { $frequency } Hz
eq-1-as-printed-is-unstable-real-poles-at-co = Gl. 1 wie gedruckt ist instabil: reelle Pole bei +{ $corrected } 1/s mit korrigierten Zahlen, bei +{ $printed } 1/s mit den gedruckten
eq-2-as-printed-tool-point-printed-m-n-at-re = Gl. 2 wie gedruckt: Werkzeugspitze { $printed } m/N in Ruhe und { $moving } bei 110 Hz; korrigiert { $corrected } in Ruhe, { $times }-mal so nachgiebig
table-1-s-springs-and-dampers-from-its-rules = Federn und Dämpfer von Tabelle 1 aus ihren Regeln, außer den Einträgen der Errata
the-solution-of-eq-2-by-gauss-from-0-to-3000 = die Lösung von Gl. 2 nach Gauß von 0 bis 3000 Hz in Schritten von 10 Hz (`steadycut machine frf`)
no-published-curve-the-figures-are-not-avail = keine veröffentlichte Kurve: Die Abbildungen liegen nicht als Daten vor, daher stehen Spektren, Geräuschtrend, Rauheitsprofil und Rauheitstrend neben keiner Messung
the-correlations-0-684-and-0-993-compare-wit = die Korrelationen 0,684 und 0,993 vergleichen mit unveröffentlichten Messungen; Rauschen lässt sich so wählen, dass es sie ergibt, was nichts bestätigt
how-wear-changes-springs-and-dampers-is-not = wie Verschleiß Federn und Dämpfer ändert, ist nicht gesagt; jedes Verschleißgesetz hier ist eine Annahme
absolute-amplitudes-a-force-of-107-n-at-ever = absolute Amplituden: eine Kraft von 107 N bei jeder Linie des Spektrums ist die formale Lesart von Gl. 2
parameters-of-the-tool-life-prediction-its-e = Parameter der Standzeitvorhersage: Ihre Gleichungen stehen nicht im Artikel

## crates/study/src/part/blank.rs

the-blank-s-size-along-axis-is-size-mm-allow = die Größe des Rohteils entlang { $axis } ist { $size } mm: erlaubt ist { $least } bis { $most } mm
the-blank-s-corner-has-to-be-three-numbers-i = die Ecke des Rohteils müssen drei Zahlen in mm sein
a-grid-of-cell-mm-over-the-blank-has-n-cells = ein Gitter von { $cell } mm über dem Rohteil hat { $n } Zellen: erlaubt sind { $most }; ein größerer Schritt hat weniger

## crates/study/src/part/carved.rs

the-program-has-no-feed-move-nothing-is-cut = das Programm hat keine Vorschubbewegung: nichts wird geschnitten
the-way-has-n-pieces-at-most-most-are-drawn = der Weg hat { $n } Stücke: Höchstens { $most } werden gezeichnet

## crates/study/src/part/columns.rs

column-name-the-unit-is-unit-allowed-is-all = Spalte `{ $name }`: die Einheit ist `{ $unit }`: erlaubt ist { $all }
the-columns-name-and-other-mean-the-same = die Spalten `{ $name }` und `{ $other }` bedeuten dasselbe
s-or-x-and-y = s (oder x und y)
the-columns-are-found-missing-are-missing = die Spalten sind { $found }; es fehlen { $missing }
line-line-column-name-cell-allowed-is-a-numb = Zeile { $line }, Spalte `{ $name }`: `{ $cell }`: erlaubt ist eine Zahl von { $least } bis { $most } { $unit }
line-line-the-path-begins-at-s-mm-allowed-is = Zeile { $line }: die Bahn beginnt bei { $s } mm: erlaubt ist 0
line-line-the-path-is-at-s-mm-allowed-is-mor = Zeile { $line }: die Bahn ist bei { $s } mm: erlaubt ist mehr als die { $before } mm der Zeile davor
the-table-has-n-rows-allowed-is-2-or-more-fr = die Tabelle hat { $n } Zeilen: erlaubt sind 2 oder mehr, vom Anfang der Bahn bis zu ihrem Ende
the-path-is-length-mm-long-allowed-is-at-mos = die Bahn ist { $length } mm lang: erlaubt sind höchstens { $most } mm
columns-that-are-not-used-names = Nicht verwendete Spalten: { $names }.

## crates/study/src/part/gcode/arc.rs

the-arc-s-radius-is-first-mm-at-its-start-an = der Radius des Bogens ist am Anfang { $first } mm und am Ende { $last } mm: erlaubt ist der gleiche, über 0
an-arc-of-radius-radius-mm-does-not-join-poi = ein Bogen vom Radius { $radius } mm verbindet keine Punkte im Abstand { $way } mm: erlaubt ist ein Radius der Hälfte davon oder mehr und zwei verschiedene Punkte

## crates/study/src/part/gcode/reader.rs

at-most-n-lines-are-read = höchstens { $n } Zeilen werden gelesen
letter-stands-there-twice = `{ $letter }` steht zweimal da
two-kinds-of-motion-in-one-line = zwei Arten der Bewegung in einer Zeile
word-changes-where-the-tool-goes-in-a-way-th = { $word } ändert den Weg des Werkzeugs auf eine Weise, der nicht gefolgt wird
word-allowed-is-0-or-more = { $word }: erlaubt ist 0 oder mehr
word-subprograms-are-not-followed = { $word }: Unterprogrammen wird nicht gefolgt
word-only-x-y-z-i-j-and-r-say-where-the-tool = { $word }: nur X, Y, Z, I, J und R sagen, wohin das Werkzeug geht
axis-is-relative-and-where-the-tool-is-along = `{ $axis }` ist relativ, und wo das Werkzeug entlang ihr steht, ist nicht bekannt
a-place-without-a-motion-g0-g1-g2-or-g3-come = ein Ort ohne Bewegung: erst kommt G0, G1, G2 oder G3
a-feed-move-from-a-place-that-is-not-known-r = eine Vorschubbewegung von einem unbekannten Ort: erst kommen Eilgänge nach X, Y und Z
i-j-and-r-belong-to-arcs-g2-and-g3 = I, J und R gehören zu Bögen, G2 und G3
an-arc-has-i-and-j-or-r-not-both = ein Bogen hat I und J oder R, nicht beides
an-arc-without-i-j-or-r = ein Bogen ohne I, J oder R

## crates/study/src/part/gcode/words.rs

a-comment-has-no-end = ein Kommentar hat kein Ende
code-sign-is-no-letter-of-a-word-variables-e = `{ $code }`: `{ $sign }` ist kein Buchstabe eines Wortes; Variablen, Ausdrücken, ausgeblendeten Sätzen und O-Wörtern wird nicht gefolgt
letter-is-followed-by-number-allowed-is-a-nu = auf `{ $letter }` folgt `{ $number }`: erlaubt ist eine Zahl

## crates/study/src/part/milling.rs

the-step-is-step-mm-allowed-is-least-to-most = der Schritt ist { $step } mm: erlaubt ist { $least } bis { $most } mm
a-way-of-length-mm-in-steps-of-step-mm-allow = ein Weg von { $length } mm in Schritten von { $step } mm: erlaubt sind { $most } Schritte; ein größerer Schritt hat weniger
mm-of-the-way = mm des Weges
rapid-moves-through-material-lines-lines = Eilgänge durch Material: Zeilen { $lines }.
straight-down-into-material-lines-lines = Gerade nach unten ins Material: Zeilen { $lines }.
not-acted-on-word-lines-lines = Nicht befolgt: { $word }, Zeilen { $lines }.
behind-the-end-of-the-program-n-lines-not-re = Hinter dem Ende des Programms: { $n } Zeilen, nicht gelesen.
there-are-feed-moves-before-the-first-f-thei = Es gibt Vorschubbewegungen vor dem ersten F: ihr Vorschub ist nicht bekannt.

## crates/study/src/part/path.rs

the-part-has-n-cuts-with-air-between-them-on = das Werkstück hat { $n } Schnitte mit Luft dazwischen: nur eine Bahn ist eine Tabelle von Tiefen

## crates/study/src/part/taken.rs

the-depths-change-at-n-places-allowed-are-mo = die Tiefen ändern sich an { $n } Stellen: erlaubt sind { $most }, wobei Unterschiede bis { $same } mm nicht zählen; ein größerer Schritt oder ein Teil der Bahn hat weniger
differences-of-depth-up-to-same-mm-are-taken = Unterschiede der Tiefe bis { $same } mm zählen nicht, damit das Werkstück in ein Szenario passt.
the-time-limit-is-time-s-now-run-duration-s = Die Zeitgrenze ist jetzt { $time } s (`run.duration_s`), das Doppelte dessen, was die Bahn bei programmiertem Vorschub dauert.
it-would-take-wanted-s-a-run-has-most-s-at-m = Es würde { $wanted } s dauern; eine Simulation hat höchstens { $most } s und kann vor der Bahn enden.
one-row-is-recorded-per-control-period-run-r = Je Regelperiode wird eine Zeile aufgezeichnet (`run.record_every`): die Simulation ist lang.
the-file-programs-feeds-from-low-to-high-mm = Die Datei programmiert Vorschübe von { $low } bis { $high } mm/min; die Simulation programmiert { $feed } mm/min (`program.feed_mm_min`).
the-file-programs-speeds-from-low-to-high-1 = Die Datei programmiert Drehzahlen von { $low } bis { $high } 1/min; die Simulation programmiert { $speed } 1/min (`program.spindle_rpm`).

## crates/study/src/plan/constraints.rs

chosen-the-papers-cite-their-list-of-seven-w = gewählt: Die Artikel zitieren ihre Liste von sieben, ohne sie anzugeben
the-spindle-turns-neither-slower-nor-faster = Die Spindel dreht weder langsamer noch schneller.
the-feed-drives-move-neither-slower-nor-fast = Die Vorschubantriebe fahren weder langsamer noch schneller.
f-sqrt-f-x-2-f-y-2-from-the-network = F = sqrt(F_x^2 + F_y^2), aus dem Netz
roughness-follows-the-force-above-the-refere = Die Rauheit folgt der Kraft: Über der Referenzkraft des Soll-Ra (oder einer eigenen Grenze) wird die Oberfläche rauer, als sie soll.
the-spindle-motor-must-turn-the-cutter-again = Der Spindelmotor muss den Fräser gegen die Kraft drehen.
roughness-of-the-feed-marks = Rauheit der Vorschubmarken
feed-marks-grow-with-the-square-of-the-feed = Vorschubmarken wachsen mit dem Quadrat des Vorschubs. 318 f^2 / (4 D) ist die Form von Tolouei-Rad und Bidhendi; der Faktor 5 und z f_z (Rundlauffehler: Ein Zahn schneidet alles) sind gewählt.
cutter-deflection = Fräserdurchbiegung
a-bent-cutter-leaves-the-contour = Ein gebogener Fräser verlässt die Kontur.
the-edges-must-last-taylor-s-law-with-the-co = Die Schneiden müssen halten. Taylor-Gesetz mit den Konstanten des Satzes table_2005.

## crates/study/src/plan/machine.rs

placeholder = Platzhalter

## crates/study/src/plan/mod.rs

iterations-2 = Iterationen

## crates/study/src/plan/optimum.rs

feasible-at-depth-mm-depth-by-the-plan-s-net = nach dem Netz des Plans zulässig bei { $depth } mm Tiefe; keine Nebenbedingung bindet
feasible-at-depth-mm-depth-by-the-plan-s-net-2 = nach dem Netz des Plans zulässig bei { $depth } mm Tiefe; bindend: { $names }
nothing-is-feasible-in-the-range-searched-at = im durchsuchten Bereich ist bei { $depth } mm Tiefe nichts zulässig; gezeigt ist die kleinste Verletzung, verletzt: { $names }

## crates/study/src/plan/over_depths.rs

in-tolerance-2 = in der Toleranz
above-its-tolerance = über der Toleranz
below-its-tolerance = unter der Toleranz
not-judged-outside-the-model = nicht beurteilt, außerhalb des Modells
verdict-not-places = { $verdict }; nicht { $places }
verdict-at-the-part-s-other-depths-too = { $verdict }; auch in den anderen Tiefen des Werkstücks
verdict-the-part-has-no-such-depth = { $verdict }; das Werkstück hat diese Tiefe nicht
at-depth-broken = bei { $depth }: { $broken }
depth-plan-n-by-the-network-no-force-in-the = { $depth }: { $plan } N nach dem Netz, im Lauf keine Kraft
depth-plan-n-by-the-network-run-n-in-the-run = { $depth }: { $plan } N nach dem Netz, { $run } N im Lauf ({ $more } %), { $held }
violated-names = ; verletzt: { $names }
outside-the-network-s-training-data = ; außerhalb der Trainingsdaten des Netzes
at-this-feed-kept-constant-without-noise-and = Bei diesem Vorschub, konstant gehalten, ohne Rauschen und Schwingung
at-this-feed-kept-constant-without-noise-and-2 = Bei diesem Vorschub, konstant gehalten, ohne Rauschen und Schwingung; { $n } Tiefen dazwischen sind nicht beurteilt

## crates/study/src/plan/problem.rs

at-least-least-mm-for-a-plan = mindestens { $least } mm für einen Plan
above-0-for-at-least-one-of-weight-force-wei = über 0 für mindestens eines von weight_force, weight_removal_rate, weight_time und weight_cost
above-0-or-plan-tool-cost-above-0-where-cost = über 0, oder `plan.tool_cost` über 0, wo Kosten gesucht werden

## crates/study/src/plan/remarks.rs

times-removal-rate-and-cost-are-those-of-thi = Zeiten, Zeitspanvolumen und Kosten gelten für diesen Vorschub, durch den ganzen Schnitt gehalten: { $controller } ändert den Vorschub im Schnitt und damit alle
the-plan-s-force-is-that-of-the-network-plan = Die Kraft des Plans ist die des Netzes ({ $plan }), die des Laufs kommt aus: { $run }; sie unterscheiden sich, der Lauf beginnt also nicht bei der geplanten Kraft
chatter-is-none-of-the-constraints-and-this = Rattern gehört nicht zu den Bedingungen, und diese Maschine schwingt im Schnitt: Ob geplante Drehzahl und Tiefe ruhig sind, sagt ihr Stabilitätsdiagramm
the-constraints-are-judged-at-the-programmed = Die Nebenbedingungen sind bei den programmierten Werten beurteilt: Ein adaptiver Regler hält dann die Kraft und bewegt Vorschub und Drehzahl entlang seiner Modelle, was immer das mit Standzeit und Leistung macht

## crates/study/src/profilometer.rs

the-line-s-ends-must-be-numbers-in-mm = die Enden der Linie müssen Zahlen in mm sein
no-tooth-has-cut-anything-yet = noch hat kein Zahn etwas geschnitten
the-line-is-length-mm-long-with-these-cut-of = die Linie ist { $length } mm lang: Mit diesen Grenzwellenlängen braucht sie mindestens { $least } mm (Vor- und Nachlaufstrecke und eine Einzelmessstrecke) und höchstens { $most } mm
the-line-leaves-the-machined-surface-at-x-x = die Linie verlässt die bearbeitete Oberfläche bei x = { $x } mm, y = { $y } mm: { $beside }
there-y-reaches-from-low-to-high-mm = y reicht dort von { $low } bis { $high } mm
x-reaches-from-first-to-last-mm-so-far = x reicht bisher von { $first } bis { $last } mm

## crates/study/src/published.rs

initial-force = Anfangskraft

## crates/study/src/recommend/learned.rs

input-first-engagement-second = { $input } { $first }, Eingriff { $second }
low = niedrig
middle = mittel
high = hoch

## crates/study/src/recommend/mod.rs

a-recommendation-interpolates-a-table-it-is = Eine Empfehlung interpoliert eine Tabelle; sie ist kein Wissen über den Schnitt.
hardness-2 = Härte
diameter-2 = Durchmesser

## crates/study/src/recommend/table.rs

synthetic-formulas-that-imitate-a-maker-s-ta = synthetisch: Formeln, die eine Herstellertabelle nachahmen, mit 3 % Rauschen; keine Herstellerdaten

## crates/study/src/safe_feed/mod.rs

no-constant-feed-is-safe-even-at-feed-mm-min = kein konstanter Vorschub ist sicher: Selbst bei { $feed } mm/min und { $speed } 1/min gilt: { $broken }
speeds = Drehzahlen

## crates/study/src/safe_feed/trial.rs

ra-is-value-um-at-place-mm-rougher-than-allo = Ra ist { $value } µm bei { $place } mm, rauer als erlaubt
the-force-is-value-n-at-place-mm-above-its-t = die Kraft ist { $value } N bei { $place } mm, über ihrer Toleranz
ra-is-value-um-with-vibration-at-place-mm-ro = Ra ist mit Schwingung { $value } µm bei { $place } mm, rauer als erlaubt
the-part-is-not-cut-to-its-end-end = das Teil ist nicht zu Ende gefräst ({ $end })
the-part-is-not-cut-to-its-end-the-machine-d = das Teil ist nicht zu Ende gefräst: Die Maschine erreicht den Vorschub nicht
ra-lies-outside-its-model-on-the-whole-part = Ra liegt am ganzen Teil außerhalb seines Modells, nichts ist also beurteilbar

## crates/study/src/stability/chart.rs

curves = Kurven

## crates/study/src/stability/mod.rs

r-d-radial-mm-of-a-cutter-of-diameter-mm-wit = R_D { $radial } mm eines Fräsers mit { $diameter } mm und { $teeth } Zähnen: Jeder schneidet über { $angle } Grad
above-0-mm-for-a-stability-chart = über 0 mm für eine Stabilitätskarte

## crates/study/src/stability/tip/mod.rs

r-d-radial-mm-of-a-cutter-of-diameter-mm-wit-2 = R_D { $radial } mm eines Fräsers von { $diameter } mm mit { $teeth } Zähnen: jeder schneidet von { $from } bis { $to } Grad, { $way }
down-milling = Gleichlauf
up-milling = Gegenlauf

## crates/study/src/train/claim.rs

neural-network-predictions-were-by-4-closer-2 = „neural network predictions were by 4 % closer to the measurements, compared to 6 %“ der besten Formel, gelesen als mittlere Fehler
literal-network = wörtliches Netz
inputs-activation-and-learning-as-the-paper = Eingänge, Aktivierung und Lernen wie im Artikel
improved-network = verbessertes Netz
logarithms-of-the-inputs-other-learning = Logarithmen der Eingänge, anderes Lernen
genetic-programming = genetische Programmierung
a-formula-of-the-same-inputs-found-here = eine Formel derselben Eingänge, hier gefunden
the-network-is-closer-than-the-formula-own-a = { $network }: näher als die Formel, { $own } % gegen { $formula } %
name-own-where-the-paper-has-paper-within-ne = { $name }: { $own } %, wo der Artikel { $paper } % hat, auf { $near } Prozentpunkt genau

## crates/study/src/train/comparison.rs

networks = Netze

## crates/study/src/train/data.rs

the-papers-3500-measurements-were-never-publ = Die 3500 Messungen der Artikel wurden nie veröffentlicht: Die Trainingsdaten stammen aus dem mechanistischen Kugelfräsermodell (Latin Hypercube, Rundlauffehler 3 µm, Scheiben von 0,25 mm) mit Rauschen von 3 % und 3 N.
rows = Zeilen

## crates/study/src/train/mod.rs

epochs = Epochen

## crates/study/src/uses/mod.rs

it-reads-list = gelesen wird { $list }

## crates/study/src/uses/reads.rs

only-run-prints-it = nur `run` gibt es aus
only-metrics-judge-by-it-and-this-prints-non = nur Kenngrößen urteilen danach, und hier wird keine davon ausgegeben
it-prints-no-cost = hier werden keine Kosten ausgegeben
a-row-is-recorded-for-every-control-period = für jeden Regeltakt wird eine Zeile aufgezeichnet
the-controller-is-always-unks = der Regler ist immer UNKS
ra-is-not-among-what-this-prints = Ra wird hier nicht ausgegeben
plant-force-model-is-no-formula-and-ra-is-no = `plant.force_model` ist nicht formula, und Ra wird hier nicht ausgegeben
twin-kind-is-programmed = `twin.kind` ist programmed
plan-force-limit-is-not-fixed = `plan.force_limit` ist nicht fixed
plan-force-limit-is-fixed = `plan.force_limit` ist fixed
plan-free-speed-is-true-the-speed-is-searche = `plan.free_speed` ist true: Die Drehzahl wird gesucht
machine-tip-modes-gives-the-machine-and-the = `machine.tip_modes` gibt die Maschine an, die Winkel der Zähne die Richtung
machine-tip-modes-is-empty-the-five-masses-h = `machine.tip_modes` ist leer: die fünf Massen haben eine Richtung
workpiece-cuts-gives-the-radial-depths = `workpiece.cuts` gibt die Schnittbreiten
workpiece-radial-depth-mm-is-the-width-of-th = `workpiece.radial_depth_mm` ist die Breite des Schnitts, welche Form die Stirn auch hat
plant-calibration-is-not-formula = `plant.calibration` ist nicht formula
it-tells-how-a-run-goes-and-this-is-no-run = es sagt, wie ein Lauf verläuft, und dies ist kein Lauf

## choices of the studies

met = erfüllt
missed = VERFEHLT
first-order = erste Ordnung
second-order-critically-damped = zweite Ordnung, aperiodischer Grenzfall
second-order = zweite Ordnung
third-order = dritte Ordnung
slot = Nut
heavy-side-cut = schwerer Seitenschnitt
light-side-cut = leichter Seitenschnitt
finishing = Schlichten
as-the-rules-say = wie die Regeln sagen
q-wrong-the-damper-shows-5-not-17 = Q falsch: Der Dämpfer ergibt 5, nicht 17
m3-rounded-to-one-digit-damper-wrong = m3 auf eine Stelle gerundet; Dämpfer falsch
exponent-of-the-spring-wrong-8-not-12 = Exponent der Feder falsch: 8, nicht 12
exponent-of-the-damper-wrong-5-not-8 = Exponent des Dämpfers falsch: 5, nicht 8
not-as-the-rules-say = nicht wie die Regeln sagen
nsn = Nsn
nsn-20-samples = Nsn, 20 Abtastwerte
in-tolerance = In Toleranz
force-within-10 = Kraft auf 10 %
longest-overload = Längste Überlast
override-travel = Override-Weg
the-papers-models = Modelle der Artikel
the-models-found = gefundene Modelle
sdnrp-2007-table-3 = SDNRP 2007, Tabelle 3
control-strategy-2013-table-1 = Regelungsstrategie 2013, Tabelle 1
feasible = zulässig
nothing-is-feasible = nichts ist zulässig
at-most = höchstens
at-least = mindestens
the-same-as = gleich
other-than = ungleich
less-than = kleiner als
more-than = größer als
largest-less-least = größter minus kleinster
first = erster
last = letzter
x-along-the-feed = x, in Vorschubrichtung
y-across-the-feed = y, quer zum Vorschub
holds = trifft zu
holds-in-part = trifft zum Teil zu
does-not-hold = trifft nicht zu
no-run-yet = noch kein Lauf
k4-of-the-papers = K4 der Artikel
tooth-by-tooth-2 = Zahn für Zahn
lines-lines-direction-modes-n = { $lines } Zeilen { $direction }; Moden: { $n }
