# Deutsch

## assets/missions/depth-step-at-constant-feed.toml

what-ra-is-and-why-one-programmed-feed-canno = Was Ra ist, und warum ein einziger programmierter Vorschub es an einem Teil mit zwei Tiefen nicht halten kann.
the-part-is-not-cut-to-its-end-cut-it-whole = Das Teil ist nicht zu Ende gefräst: ganz durchfräsen.
ra-is-out-of-its-tolerance-on-part-of-the-fa = Ra liegt auf einem Teil der Fläche außerhalb der Toleranz: rauer, wo das Teil tiefer und die Kraft zu groß ist, oder glatter als verlangt, wo der Vorschub überall klein ist. Was kann den Vorschub nur im tieferen Abschnitt senken?
ra-k5-f-f-k4-f-n-a-d-a-d0 = Ra = K5(F),  F = K4(f, n) A_D / A_D0
sdnrp-2007-models-k4-and-k5 = SDNRP 2007, Modelle K4 und K5
roughness-follows-the-cutting-force-and-the = Die Rauheit folgt der Zerspankraft, und die Kraft folgt Schnitttiefe und Vorschub. Wo die Tiefe wächst, muss der Vorschub sinken, wenn Ra bleiben soll. Ein Vorschub für das ganze Teil ist entweder zu schnell für den tiefen Bereich oder zu langsam für alles Übrige.
finish-the-part-with-ra-in-its-tolerance-ove = Das Teil mit Ra in Toleranz über mindestens 95 % der Länge fertigen.
ra-is-the-mean-height-of-the-surface-s-profi = Ra ist die mittlere Höhe des Oberflächenprofils. Es folgt hier der Zerspankraft: Was lässt die Kraft in der Mitte wachsen?
the-depth-cannot-be-changed-the-blank-is-as = Die Tiefe lässt sich nicht ändern: Das Rohteil ist, wie es ist. Was bleibt, um die Kraft zu senken?
a-lower-feed-for-the-whole-part-would-do-and = Ein kleinerer Vorschub für das ganze Teil würde genügen, kostet aber überall Zeit. Ein Regler senkt ihn nur dort, wo es nötig ist: Folgeregler wählen.
what-does-the-surface-do-in-the-deeper-stret = Was geschieht mit der Oberfläche im tieferen Bereich?
it-gets-smoother = Sie wird glatter
a-deeper-cut-takes-more-force-and-a-larger-f = Ein tieferer Schnitt braucht mehr Kraft, und eine größere Kraft hinterlässt eine rauere Oberfläche.
it-stays-the-same-the-feed-is-the-same = Sie bleibt gleich: Der Vorschub ist derselbe
the-feed-is-the-same-the-chip-is-not-the-edg = Der Vorschub ist derselbe, der Span nicht: Die Schneide steht auf größerer Tiefe im Werkstoff, und die Kraft wächst.
it-gets-rougher = Sie wird rauer
the-depth-rises-from-2-0-mm-to-2-3-mm-at-45 = Die Tiefe steigt bei 45 mm von 2,0 mm auf 2,3 mm und fällt bei 85 mm zurück. Der Vorschub bleibt wie programmiert.
predict = Vorhersagen
what-does-ra-come-to-in-the-deeper-stretch-a = Wie groß wird Ra im tieferen Bereich bei konstantem Vorschub?
it-stays-inside-its-tolerance = Es bleibt in seiner Toleranz
it-grows-by-about-a-third = Es wächst um etwa ein Drittel
it-more-than-doubles = Es verdoppelt sich mehr als
cut-from-the-start-at-constant-feed-and-read = Von Anfang an mit konstantem Vorschub fräsen und Ra vor dem Sprung und zwischen 60 und 84 mm ablesen.
watch-the-cut-as-it-comes-and-nothing-change = Den Schnitt ansehen, wie er kommt, ohne etwas zu ändern: Ra und die Kraft vor dem tieferen Bereich und darin.
see-it = Ansehen
change-what-is-open-to-you-and-cut-again = Ändern, was freigegeben ist, und noch einmal fräsen.
mend-it = Beheben
the-drawing-asks-for-ra-0-81-m-on-the-whole = Die Zeichnung verlangt Ra 0,81 µm auf der ganzen Fläche. Das Programm hat einen einzigen Vorschub. In der Mitte ist das Rohteil 0,3 mm dicker, dort geht der Fräser also tiefer.
why-a-deeper-stretch-breaks-constant-feed = Warum konstanter Vorschub am tieferen Bereich scheitert

## assets/missions/gain-leaves-an-error.toml

proportional-control-of-the-force-and-the-er = Proportionale Regelung der Kraft und die Regelabweichung, die sie übrig lässt.
in-the-deeper-stretch-the-mean-force-is-stil = Im tieferen Bereich liegt die mittlere Kraft noch mehr als 7 % über der Sollkraft. Wo der Regelkreis ruhig ist, bringt eine größere Verstärkung sie näher; wo er schwingt, eine kleinere.
the-force-does-not-come-to-rest-in-the-deepe = Die Kraft kommt im tieferen Bereich nicht zur Ruhe: Sie schwingt, und ihr Mittelwert sagt nichts. Die Verstärkung ist größer, als die Totzeit zulässt.
the-loop-overshoots-the-gain-is-more-than-th = Der Regelkreis schwingt über: Die Verstärkung ist größer, als die Totzeit zulässt.
f-set-f-d-kp-f-d-f-m-f-k2-f-set-n-k3-f-set = F_set = F_d + Kp (F_d - F_m),  f = K2(F_set),  n = K3(F_set)
sdnrp-2007-the-controller-s-structure-remain = SDNRP 2007, Struktur des Reglers; bleibende Regelabweichung der P-Regelung: Lehrbuch
proportional-control-needs-an-error-to-act-o = Eine P-Regelung braucht eine Regelabweichung, um einzugreifen, deshalb bleibt eine: je größer die Verstärkung, desto kleiner. Wie groß die Verstärkung sein darf, bestimmt die Totzeit. Die bleibende Regelabweichung ist kein Einstellfehler; sie gehört zu dieser Art von Regler.
bring-the-force-in-the-deeper-stretch-to-wit = Die Kraft im tieferen Bereich allein mit der Verstärkung auf 7 % an die Sollkraft heranbringen, ohne dass sie schwingt.
compare-the-measured-force-with-the-desired = Gemessene Kraft und Sollkraft im tieferen Bereich für zwei Verstärkungen vergleichen.
the-correction-is-kp-times-the-error-without = Die Korrektur ist Kp mal Regelabweichung: Ohne Abweichung gibt es keine. Ein größeres Kp braucht für dieselbe Korrektur eine kleinere Abweichung.
raise-kp-in-steps-and-watch-the-first-instan = Kp schrittweise erhöhen und die ersten Augenblicke des Schnitts beobachten: Überschwingen zeigt, wann es zu viel ist.
where-does-the-force-come-to-rest-in-the-dee = Wo kommt die Kraft im tieferen Bereich zur Ruhe?
exactly-on-the-desired-force = Genau auf der Sollkraft
the-correction-is-proportional-to-the-error = Die Korrektur ist proportional zur Abweichung. Auf der Sollkraft ist die Abweichung null und die Korrektur auch: Wer senkt dann den Vorschub?
above-it-nearer-than-at-constant-feed = Darüber, aber näher als bei konstantem Vorschub
nowhere-it-keeps-swinging = Nirgends: Sie schwingt weiter
kp-is-small-and-so-is-what-a-measured-error = Kp ist klein, und so auch das, was eine gemessene Abweichung bewegt: Der Regelkreis ist hier ruhig. Die Kraft nach dem Sprung ansehen.
kp-is-0-5-the-part-gets-15-deeper-at-45-mm = Kp ist 0,5. Bei 45 mm wird das Teil um 15 % tiefer.
by-how-many-percent-of-the-desired-force-f-d = Um wie viel Prozent der Sollkraft F_d liegt die Kraft F im tieferen Bereich darüber, mit Kp wie vorgegeben (0,5)?
solve-f-1-15-f-d-kp-f-d-f-for-f-f-d = F = 1,15 (F_d + Kp (F_d - F)) nach F / F_d auflösen.
the-models-are-of-the-shallow-part-15-more-d = Die Modelle gelten für das flache Teil: 15 % mehr Tiefe braucht 15 % mehr Kraft, als ihnen vorgegeben wird. Vorgegeben wird die Sollkraft, korrigiert um Kp mal die Abweichung: in Ruhe ist F = 1,15 (F_d + Kp (F_d - F)).
predict-how-far = Vorhersagen, wie weit
find-the-gain-that-meets-the-goal = Die Verstärkung finden, die das Ziel erfüllt.
tune = Einstellen
the-part-is-the-one-with-the-deeper-stretch = Es ist das Teil mit dem tieferen Bereich. Diesmal bewegt SDNRP Vorschub und Drehzahl: Es gibt seinen Modellen eine Kraft vor, korrigiert um Kp mal die Kraftabweichung.
a-gain-comes-near-and-stays-off = Eine Verstärkung kommt nahe heran und bleibt daneben

## assets/missions/integral-action-holds.toml

integral-action-brings-the-force-onto-the-de-2 = Der I-Anteil bringt die Kraft auch bei anderer Tiefe auf die Sollkraft, solange er Spielraum hat.
the-force-does-not-come-to-rest-in-the-deepe-2 = Die Kraft kommt im tieferen Bereich nicht zur Ruhe: Der Regelkreis ist instabil. Die Summe wirkt auf vergangene Abweichungen: Mit weniger Ki oder Kp beruhigt er sich.
the-mean-force-in-the-deeper-stretch-is-not = Die mittlere Kraft im tieferen Bereich ist nicht die Sollkraft. Eine Verstärkung allein lässt eine Abweichung; eine Summe nimmt sie weg, wenn sie Zeit hat, nicht schwingt und der Override an keiner Grenze steht.
ra-is-outside-its-tolerance-over-too-much-of = Ra liegt über zu viel der Länge außerhalb der Toleranz: Nach jedem Sprung kommt die Kraft zu langsam auf die Sollkraft, oder sie schwingt.
u-1-kp-e-ki-sum-e-e-1-f-m-f-ref = u = 1 + Kp e + Ki sum e,  e = 1 - F_m / F_ref
textbook-form-of-pi-control-the-override-loo = Lehrbuchform der PI-Regelung; Override-Regelkreis des kombinierten Systems, 2005
the-sum-of-the-errors-stops-changing-only-wh-2 = Die Summe der Abweichungen hört erst auf, sich zu ändern, wenn die Abweichung null ist. Deshalb hält der I-Anteil die Kraft bei anderer Tiefe oder in anderem Werkstoff, solange dreierlei gilt: Der Override steht an keiner Grenze, der Regelkreis ist stabil, und weniger Vorschub heißt noch weniger Kraft. An einer Grenze steht die Summe still, und die Abweichung bleibt. Sein Preis: Er reagiert auf Vergangenes, eine zu große Verstärkung schwingt also.
let-the-force-in-the-deeper-stretch-rest-wit = Die Kraft soll im tieferen Bereich auf 0,5 % genau bei der Sollkraft zur Ruhe kommen, mit Ra in Toleranz über 95 % der Länge.
what-would-an-override-do-that-keeps-falling = Was bewirkt ein Override, der weiter sinkt, solange es irgendeine Abweichung gibt?
set-the-integral-gain-ki-above-zero-small-it = Die Integralverstärkung Ki größer als null einstellen. Klein: Es dauert Sekunden. Groß: Es schwingt über. Was während des Schnitts geändert wird, wirkt erst ab dort: einstellen, dann von Anfang an fräsen.
set-ki-to-0-2-press-cut-from-the-start-and-c = Ki auf 0,2 setzen, „Von Anfang an fräsen“ drücken und den Schnitt prüfen.
with-an-integral-gain-above-zero-where-does = Wo kommt die Kraft mit einer Integralverstärkung größer als null zur Ruhe?
on-the-desired-force-at-2-3-mm-as-at-2-0-mm = Auf der Sollkraft, bei 2,3 mm wie bei 2,0 mm
on-the-desired-force-at-2-0-mm-only = Nur bei 2,0 mm auf der Sollkraft
the-sum-goes-on-changing-as-long-as-there-is = Die Summe ändert sich, solange es irgendeine Abweichung gibt, auch bei 2,3 mm: Ruhen kann sie nur, wo die Abweichung null ist.
nearer-but-off-as-with-the-gain-alone = Näher, aber daneben, wie mit der Verstärkung allein
a-gain-needs-an-error-to-hold-its-correction = Eine Verstärkung braucht eine Abweichung, um ihre Korrektur zu halten. Eine Summe hält, was sie aufsummiert hat, ohne dass eine Abweichung bleibt.
find-an-integral-gain-ki-that-meets-the-goal = Eine Integralverstärkung Ki finden, die das Ziel erfüllt. Das Teil wird über seine ganze Länge beurteilt, eine Verstärkung, die erst während des Schnitts eingestellt wird, kommt also zu spät: einstellen, dann „Von Anfang an fräsen“ drücken.
the-same-part-again-now-the-controller-is-p = Noch einmal dasselbe Teil. Der Regler ist jetzt P: Er verstellt den Vorschub-Override um seine Verstärkung mal die relative Regelabweichung und lässt, wie gesehen, den Rest stehen. Er kann die Abweichung auch von Abtastung zu Abtastung aufsummieren.
adding-up-the-error-takes-it-away = Aufsummieren beseitigt die Abweichung

## assets/missions/dead-time-against-gain.toml

a-gain-that-is-good-at-a-short-dead-time-swi = Eine Verstärkung, die bei kurzer Totzeit gut ist, schwingt bei langer.
ra-leaves-its-tolerance-on-more-than-a-tenth = Ra verlässt seine Toleranz auf mehr als einem Zehntel der Länge: Es schwingt oder kriecht. Was von beidem ist zu sehen?
k-l-pi-2-k-rate-of-the-integrator-with-all-t = K L < pi / 2,  K: Rate des Integrators mit allem, was ihm folgt, 1/s,  L: Totzeit, s
textbook-stability-limit-of-an-integrator-be = Lehrbuch: Stabilitätsgrenze eines Integrators hinter einer Totzeit
within-the-dead-time-the-loop-is-blind-what = Während der Totzeit ist der Regelkreis blind: Was er in dieser Zeit nachlegt, legt er nach, ohne die Wirkung zu sehen. Begrenzt ist also Verstärkung mal Totzeit. Die doppelte Totzeit lässt etwa die halbe Verstärkung zu.
find-the-largest-integral-gain-that-still-ho = Die größte Integralverstärkung finden, die Ra bei 160 ms Totzeit noch über 90 % der Länge hält.
for-160-ms-the-controller-goes-on-asking-for = Der Regler fordert 160 ms lang immer mehr, da er von dem, was er gefordert hat, nichts sieht. Wie weit kann er in dieser Zeit zu weit gehen?
halve-the-gain-and-look-at-the-overshoot = Die Verstärkung halbieren und das Überschwingen ansehen.
the-edge-for-a-good-cut-lies-between-0-2-and = Die Grenze für einen guten Schnitt liegt zwischen 0,2 und 0,35.
what-will-the-cut-do = Wie verläuft der Schnitt?
the-same-80-ms-later = Genauso, nur 80 ms später
the-command-is-late-in-every-round-of-the-lo = Der Befehl ist in jeder Runde des Regelkreises verspätet, nicht einmal: Der Regler korrigiert eine Abweichung, die er schon korrigiert hat.
it-swings-and-ra-with-it = Er schwingt, und Ra mit ihm
it-gets-slower-and-stays-calm = Er wird langsamer und bleibt ruhig
a-slower-answer-would-need-a-smaller-gain-th = Eine langsamere Antwort bräuchte eine kleinere Verstärkung. Die Verstärkung ist dieselbe: Nur was er sieht, ist alt.
the-integral-gain-is-0-8-as-on-the-machine-w = Die Integralverstärkung ist 0,8 wie auf der Maschine mit 80 ms, wo sie gut war.
lower-the-gain-until-the-cut-is-good-and-no = Die Verstärkung senken, bis der Schnitt gut ist, und nicht weiter als nötig.
find-the-edge = Die Grenze finden
on-this-machine-the-plc-passes-the-override = Auf dieser Maschine gibt die SPS den Override doppelt so langsam weiter: 160 ms, nachdem er gefordert wurde. Die Verstärkungen wurden auf der anderen Maschine eingestellt, und nun wackelt der Tisch.
dead-time-against-gain-find-the-edge = Totzeit gegen Verstärkung: die Grenze finden

## assets/missions/smith-predictor.toml

why-a-predictor-helps-against-dead-time-and = Warum ein Prädiktor gegen Totzeit hilft und was eine falsche Totzeit in ihm anrichtet.
it-still-swings-the-predictor-has-to-know-ho = Es schwingt noch. Der Prädiktor muss wissen, wie lange der Befehl wirklich braucht.
y-y-u-0-u-a-u-a-with-and-u-0-without-the-ass = y* = y u_0 / u_a,  u_a mit und u_0 ohne die angenommene Totzeit
o-j-m-smith-1957-here-in-multiplicative-form = O. J. M. Smith 1957; hier in multiplikativer Form, da die Kraft mit dem Vorschub geht
the-predictor-takes-the-measured-force-for-w = Der Prädiktor rechnet die gemessene Kraft mit einem Modell vom Weg des Overrides auf den Wert ohne Totzeit um. Mit der richtigen Totzeit lässt sich der Regelkreis einstellen, als gäbe es keine. Mit einer viel zu langen korrigiert er, was keine Abweichung ist, und schwingt; eine etwas zu kurze schadet weniger. Ein Modell taugt so viel, wie es zutrifft.
keep-the-integral-gain-at-0-8-and-hold-ra-ov = Die Integralverstärkung bei 0,8 lassen und Ra über 88 % der Länge halten.
switch-the-smith-predictor-on-and-look-at-th = Den Smith-Prädiktor einschalten und die Kraft ansehen: Ist sie ruhig?
the-predictor-assumes-a-dead-time-which-one = Der Prädiktor nimmt eine Totzeit an. Welche nimmt er hier an, und welche hat die Maschine?
set-the-assumed-dead-time-to-0-16-s = Die angenommene Totzeit auf 0,16 s setzen.
you-switch-the-predictor-on-and-change-nothi = Der Prädiktor wird eingeschaltet und sonst nichts geändert. Was geschieht?
the-cut-is-as-calm-as-without-dead-time = Der Schnitt ist so ruhig wie ohne Totzeit
it-would-be-if-its-model-were-true-it-expect = Das wäre er, wenn sein Modell stimmte. Er erwartet nach 300 ms eine Antwort, die nach 160 ms kommt, und hält, was früh kommt, für eine Störung.
it-still-swings-the-model-is-wrong = Er schwingt noch: Das Modell ist falsch
the-part-is-cut-with-a-constant-feed = Das Teil wird mit konstantem Vorschub gefräst
the-predictor-changes-what-the-controller-se = Der Prädiktor ändert, was der Regler sieht, nicht, ob er eingreift.
the-predictor-assumes-a-dead-time-of-300-ms = Der Prädiktor nimmt eine Totzeit von 300 ms an; die Maschine hat 160 ms.
make-the-controller-s-belief-fit-the-machine = Die Annahme des Reglers mit der Maschine in Einklang bringen.
make-it-true = Berichtigen
the-machine-with-160-ms-again-the-gain-must = Wieder die Maschine mit 160 ms. Die Verstärkung muss hoch bleiben, denn der Chef will kurze Zeiten. Der Regler kann ein Modell vom Weg des Befehls bekommen: Dann weiß er, was er gefordert und noch nicht gesehen hat.
a-model-that-waits-the-smith-predictor = Ein Modell, das wartet: der Smith-Prädiktor

## assets/missions/noise-against-tolerance.toml

scatter-of-the-force-becomes-scatter-of-ra-a = Aus Streuung der Kraft wird Streuung von Ra; eine Toleranz muss dafür Platz lassen.
less-than-80-of-the-length-is-in-the-toleran = Weniger als 80 % der Länge liegen in der verlangten Toleranz. Ist es die Antwort des Reglers auf das Rauschen oder das Rauschen selbst?
so-wide-a-tolerance-will-not-be-granted-at-m = Eine so weite Toleranz wird nicht bewilligt: höchstens 25 %. Erst den Regler beruhigen.
ra-k5-f-an-error-of-1-in-the-force-is-one-of = Ra = K5(F): eine Abweichung von 1 % in der Kraft sind mehrere Prozent in Ra
sdnrp-2007-table-3-force-and-ra-of-the-same = SDNRP 2007, Tabelle 3 (Kraft und Ra derselben Zeilen); Bode-Integral für die Grenzen der Rückführung
feedback-corrects-what-lasts-longer-than-its = Eine Rückführung korrigiert, was länger dauert als ihre Totzeit. Was sich schneller ändert, kann sie nicht korrigieren, und ein schneller Regler verstärkt es noch. Der Rest ist Sache des Prozesses: Eine Toleranz muss Platz für seine Streuung lassen.
tune-the-controller-for-this-noise-and-find = Den Regler für dieses Rauschen einstellen und die Toleranz finden, um die der Konstrukteur zu bitten ist: die kleinste, die über 80 % der Länge gehalten wird.
how-much-do-the-force-and-ra-scatter-while-n = Wie stark streuen Kraft und Ra, während sich sonst nichts ändert?
a-controller-that-answers-each-wiggle-adds-t = Ein Regler, der auf jedes Zucken antwortet, verstärkt es: Er kommt um die Totzeit zu spät. Langsamer antworten lassen.
try-a-response-time-of-1-to-3-s-then-widen-t = Eine Ansprechzeit von 1 bis 3 s versuchen, dann die Toleranz Schritt für Schritt weiten.
you-make-the-controller-answer-faster-what-d = Der Regler soll schneller antworten. Wie ändert sich der Anteil der Fläche in Toleranz?
it-grows-errors-are-corrected-sooner = Er steigt: Abweichungen werden früher korrigiert
errors-that-last-are-noise-has-changed-its-s = Abweichungen, die dauern, ja. Rauschen hat sein Vorzeichen gewechselt, bevor die Korrektur kommt, 80 ms und die Verzögerung eines Antriebs später.
it-falls-or-stays-it-answers-noise-with-nois = Er sinkt oder bleibt: Auf Rauschen folgt Rauschen
first-the-response-time-then-the-tolerance = Erst die Ansprechzeit, dann die Toleranz.
tune-then-ask = Erst einstellen, dann fragen
steel-is-not-the-same-from-place-to-place-ed = Stahl ist nicht überall gleich, die Schneiden laufen unrund, der Sensor rauscht. Die Zeichnung erlaubt 10 % um Ra 0,81 µm. Der Meister fragt, warum bestenfalls ein Fünftel der Fläche außerhalb der Toleranz liegt, und das mit einem viel gelobten Regler.
what-no-controller-can-hold-noise-against-to = Was kein Regler halten kann: Rauschen gegen Toleranz

## assets/missions/another-material.toml

a-model-based-controller-on-a-material-that = Ein modellbasierter Regler an einem Werkstoff, für den seine Modelle nicht gemacht sind.
ra-is-not-held-the-controller-s-models-are-t = Ra wird nicht gehalten. Die Modelle des Reglers gehören zu einem anderen Stahl: Welcher Regler merkt das von selbst?
gain-estimate-f-m-f-modelled = Schätzwert der Verstärkung = F_m / F_Modell
tracking-controller-observer-of-the-gain-mat = Folgeregler (Beobachter der Verstärkung); Werkstoffe: spezifische Schnittkräfte wie im Programm aufgeführt
a-model-is-a-belief-what-corrects-it-is-meas = Ein Modell ist eine Annahme. Was sie berichtigt, ist die Messung: Das Verhältnis von gemessener zu Modellkraft sagt, wie falsch sie ist, und ein Regler, der diesem Verhältnis folgt oder die Abweichung aufsummiert, braucht keine Konstanten des neuen Stahls.
hold-ra-over-at-least-90-of-the-length-witho = Ra über mindestens 90 % der Länge halten, ohne die Konstanten des neuen Stahls zu kennen.
the-controller-s-models-believe-in-ck45-what = Die Modelle des Reglers nehmen Ck45 an. Was sagt ihm, dass sie falsch sind?
sdnrp-corrects-its-models-answer-by-a-gain-y = SDNRP korrigiert die Antwort seiner Modelle mit einer Verstärkung. Was eine Verstärkung übrig lässt, ist bekannt.
tracking-estimates-how-much-larger-the-force = Der Folgeregler schätzt, wie viel größer die Kraft ist als im Modell; Nachgeführter PI und P mit Integralverstärkung summieren die Abweichung auf.
what-roughness-will-the-part-have-at-the-end = Welche Rauheit in µm hat das Teil am Ende, wo 0,81 verlangt ist?
the-force-of-this-steel-is-larger-by-a-fifth = Die Kraft dieses Stahls ist um ein Fünftel und mehr größer. Wenige Prozent Kraft sind einige zehn Prozent Ra: einmal fräsen und ansehen.
sdnrp-with-kp-0-5-its-models-belong-to-ck45 = SDNRP mit Kp = 0,5; seine Modelle gehören zu Ck45.
choose-what-does-not-need-to-know-the-steel = Einen Regler wählen, der den Stahl nicht kennen muss.
hold-it = Halten
the-store-has-run-out-of-ck45-and-brings-16m = Dem Lager ist Ck45 ausgegangen, es bringt 16MnCrSi5. Programm, Modelle und Verstärkung bleiben, wie sie sind: Die Modelle sagen, alles sei in Ordnung.
another-steel-under-a-model-that-does-not-kn = Ein anderer Stahl unter einem Modell, das ihn nicht kennt

## assets/missions/wear-heard-and-seen.toml

what-force-sound-and-roughness-do-from-a-sha = Wie sich Kraft, Geräusch und Rauheit von der scharfen bis zur verschlissenen Schneide ändern.
the-part-is-not-finished-its-tool-was-worn-o = Das Teil ist nicht fertig: Das Werkzeug war verschlissen oder die Zeit war um. Ein kürzeres wählen.
at-its-end-the-surface-is-more-than-three-ti = Am Ende ist die Oberfläche mehr als dreimal so rau wie am Anfang. Das Werkzeug muss früher gewechselt werden.
f-f-sharp-1-growth-wear-used-life = F = F_scharf (1 + Zuwachs * Verschleiß(verbrauchte Standzeit))
machine-model-2019-wear-sound-and-tool-life = Maschinenmodell 2019: Verschleiß, Geräusch und Standzeit
wear-goes-in-three-parts-break-in-steady-gro = Verschleiß verläuft in drei Teilen: Einlauf, stetiges Wachsen, Ausfall. Kraft, Geräusch und Rauheit steigen gemeinsam; deshalb kann das Geräusch den Zeitpunkt des Werkzeugwechsels melden, bevor ihn die Oberfläche zeigt.
say-what-becomes-of-sound-and-roughness-and = Vorhersagen, was aus Geräusch und Rauheit wird, und ein Teil fräsen, das endet, solange sein Ra höchstens das Dreifache des anfänglichen ist.
look-at-force-sound-and-ra-over-the-whole-li = Kraft, Geräusch und Ra über die ganze Standzeit ansehen. Welche Teile lassen sich unterscheiden?
break-in-is-short-then-it-grows-steadily-the = Der Einlauf ist kurz, dann wächst er stetig, dann schnell.
a-shorter-part-ends-before-the-end-of-the-li = Ein kürzeres Teil ist vor dem Ende der Standzeit fertig: Wozu lässt sich die Länge ändern?
from-the-sharp-tool-to-the-worn-one-what-doe = Wie ändert sich das Schnittgeräusch vom scharfen bis zum verschlissenen Werkzeug?
it-gets-louder = Es wird lauter
it-stays-the-same = Es bleibt gleich
the-force-grows-with-the-wear-and-a-larger-f = Die Kraft wächst mit dem Verschleiß, und eine größere Kraft erschüttert die Maschine mehr. Das Geräusch nach 5 s mit dem am Ende vergleichen.
it-gets-quieter = Es wird leiser
a-worn-edge-does-not-cut-it-presses-that-tak = Eine verschlissene Schneide schneidet nicht, sie drückt: Das braucht mehr Kraft. Das Geräusch nach 5 s mit dem am Ende vergleichen.
choose-a-length-that-is-cut-before-the-surfa = Eine Länge wählen, die gefräst ist, bevor die Oberfläche verdorben ist.
stop-in-time = Rechtzeitig aufhören
a-tool-cuts-from-its-first-to-its-last-minut = Ein Werkzeug schneidet von seiner ersten bis zu seiner letzten Minute, gezeigt in 52 Sekunden: Eine Sekunde steht für sechs Minuten. Der Lehrling meint, man höre nichts.
a-tool-s-life-heard-and-seen = Ein Werkzeugleben, gehört und gesehen

## assets/missions/choose-for-the-2005-part.toml

five-cuts-of-changing-depth-and-width-which = Fünf Schnitte wechselnder Tiefe und Breite: welcher Regler, wie eingestellt?
it-takes-too-long-on-light-sections-the-feed = Es dauert zu lange. In leichten Abschnitten muss der Vorschub steigen.
the-largest-force-is-above-1050-n-feedback-s = Die größte Kraft liegt über 1050 N. Die Rückführung sieht einen schwereren Abschnitt erst, wenn das Werkzeug darin ist: Was kennt ihn vorher?
u-f-ref-f-modelled-1-exponent-corrected-by-t = u = (F_ref / F_Modell)^(1 / Exponent), korrigiert durch die gemessene Kraft
combined-system-2005-experiment-2-and-its-ta = Kombiniertes System 2005, Experiment 2 und seine Tabelle 1; Vorausschau: eigener Regler dieses Programms
feedback-answers-what-has-happened-on-a-part = Eine Rückführung antwortet auf das, was geschehen ist. An einem Teil mit bekannten Abschnitten senkt die Vorsteuerung den Vorschub, bevor der Abschnitt kommt, und die Rückführung korrigiert, worin das Modell irrte. Beide zusammen schlagen jede für sich.
cut-the-part-in-less-than-92-s-with-no-force = Das Teil in weniger als 92 s fräsen, ohne eine Kraft über 1050 N.
where-does-the-largest-force-come-from-from = Woher kommt die größte Kraft? Von dort, wo der Fräser in einen tieferen oder breiteren Abschnitt eintritt, ehe eine Messung es zeigen kann.
what-could-a-controller-know-before-the-sect = Was könnte ein Regler wissen, bevor der Abschnitt kommt?
preview-reads-the-part-s-program = Vorausschau liest das Programm des Teils.
the-feed-is-lowered-by-feedback-from-the-mea = Der Vorschub wird durch Rückführung der gemessenen Kraft gesenkt. Wo ist die größte Kraft?
in-the-middle-of-the-deepest-section = In der Mitte des tiefsten Abschnitts
there-the-controller-has-had-time-to-lower-t = Dort hatte der Regler Zeit, den Vorschub zu senken. Die ersten Augenblicke eines Abschnitts ansehen.
where-a-heavier-section-begins = Wo ein schwererer Abschnitt beginnt
at-the-end-of-each-cut = Am Ende jedes Schnitts
the-engagement-does-not-grow-there-look-at-w = Dort wächst der Eingriff nicht. Ansehen, wo ein schwererer Abschnitt beginnt.
choose-and-tune = Wählen und einstellen
five-straight-cuts-of-different-depth-and-wi = Fünf gerade Schnitte verschiedener Tiefe und Breite, Zahn für Zahn, die Kraft auf 665 N zu halten. Bei konstantem Vorschub ist die größte Kraft mehr als doppelt so groß. Der Kunde zahlt nach Minuten; das Werkzeug bricht nach Newton.
choose-and-tune-for-the-part-of-2005 = Für das Teil von 2005 wählen und einstellen

## assets/missions/beat-it-by-hand.toml

you-are-the-controller-the-operator-s-knob-i = Der Regler ist diesmal der Mensch: mit dem Drehknopf des Bedieners.
the-knob-was-not-turned-during-the-cut-one-f = Der Knopf wurde während des Schnitts nicht gedreht. Ein Vorschub für das ganze Teil ist hier nicht gefragt.
the-override-went-beyond-120-where-a-machine = Der Override ging über 120 %, wo das Bedienfeld einer Maschine endet.
ra-is-out-of-tolerance-on-more-than-15-of-th = Ra liegt auf mehr als 15 % der Länge außerhalb der Toleranz. Beachten, wo sich die Tiefe ändert, und einen Augenblick vorher da sein.
sdnrp-holds-more-of-the-length-than-you-did = SDNRP hält mehr von der Länge als Ihre Hand.
f-u-f-n-2-3-mm-f-f-n-2-0-mm-solved-for-the-o = F(u f, n, 2,3 mm) = F(f, n, 2,0 mm), nach dem Override u aufgelöst
sdnrp-2007-override-control-2005-combined-sy = SDNRP 2007 (Override-Regelung); kombiniertes System 2005 (Rückführung gegen Vorsteuerung)
a-person-who-knows-the-part-does-what-feedfo = Wer das Teil kennt, tut, was eine Vorsteuerung tut: vor dem Sprung handeln. Ermüdend ist, es den ganzen Tag zu tun, an jedem Teil. Ein Regler mit Rückführung kennt das Teil nicht und ermüdet nicht; einer mit Vorausschau kann beides.
turn-the-knob-during-the-cut-so-that-ra-is-i = Den Knopf während des Schnitts so drehen, dass Ra über 85 % der Länge in Toleranz liegt, besser als bei SDNRP.
at-45-mm-the-part-gets-deeper-at-85-mm-it-ge = Bei 45 mm wird das Teil tiefer, bei 85 mm flacher. Wo sollte der Override dazwischen stehen?
the-command-arrives-80-ms-later-and-the-driv = Der Befehl kommt 80 ms später an, und der Antrieb braucht seine Zeit: etwas früher beginnen.
about-60-in-the-deeper-stretch-holds-ra-befo = Etwa 60 % im tieferen Bereich halten Ra; davor und danach 100 %. Der Knopf rastet alle 2 %.
which-override-holds-ra-in-the-deeper-stretc = Welcher Override hält Ra im tieferen Bereich, in Prozent von 300 mm/min?
read-the-feed-in-the-deeper-stretch-when-a-c = Den Vorschub im tieferen Bereich ablesen, wenn ein Regler fährt, oder ausprobieren: 15 % mehr Tiefe brauchen viel weniger Vorschub, da die Kraft nur schwach mit dem Vorschub geht.
cut-and-turn-the-knob-while-it-cuts-pausing = Fräsen und dabei den Knopf drehen. Anhalten und Zurückgehen sind erlaubt: Was dort gedreht wird, ersetzt das Folgende.
forty-years-ago-this-was-done-by-ear-with-a = Vor vierzig Jahren ging das nach Gehör, mit der Hand am Override. Das Teil hat einen tieferen Bereich, und Sie haben den Knopf des Vorschub-Overrides: um ihn herum ziehen, mit Mausrad, den Tasten + und - oder dem Finger drehen. Die Ansicht Konsole zeigt, was ein Bediener sieht, und bewertet danach im Vergleich mit jedem Regler.
beat-the-controller-by-hand = Den Regler von Hand schlagen

## assets/missions/teach-in-feed-control.toml

a-control-that-learns-the-force-of-a-good-cu = Eine Regelung, die die Kraft eines guten Schnitts lernt und nachgibt, wenn das Werkzeug nicht mehr so schneidet.
the-reference-of-the-first-cut-is-not-the-pe = Die Referenz des ersten Schnitts ist nicht die Spitzenkraft eines guten. Den Lehrschnitt mit dem Schnitt wie eingerichtet ausführen: Die Schneide bricht erst während des Schnitts aus.
the-feed-was-never-lowered-with-fmin-at-100 = Der Vorschub wurde nie gesenkt: Mit FMIN bei 100 % überwacht die Regelung nur und tut nichts.
with-the-chipped-edge-there-is-hardly-less-f = Mit der ausgebrochenen Schneide ist die Kraft kaum kleiner als ohne Regelung. Ist FMIN klein genug, und stammen die Referenzen von einem guten Schnitt?
u-limit-f-1-f-m-fmin-fmax-f-m-1-3-f-1-u-0-6 = u = begrenzt(F_1 / F_m, FMIN, FMAX),  F_m = 1,3 F_1 u^0,6
adaptive-feed-control-afc-as-machine-control = Adaptive Vorschubregelung (AFC), wie Maschinensteuerungen sie haben; Raten und Schwellen gewählt
teach-in-needs-no-model-the-good-part-is-the = Der Lehrschnitt braucht kein Modell: Das gute Teil ist das Modell. Deshalb funktioniert er auf jeder Maschine, und deshalb muss das erste Teil gut sein. Die Regelung senkt die Kraft, sie hält sie nicht: Der kleinere Vorschub senkt, was sie misst, und so kommt sie auf halbem Weg zur Ruhe. Und sie kann eine ausgebrochene Schneide nicht von einem härteren Teil unterscheiden: Bei beiden gibt sie nach, und das Protokoll zeigt es.
teach-in-the-good-part-then-let-the-control = Das gute Teil im Lehrschnitt lernen, dann die Regelung den Vorschub senken lassen, wenn die Schneide ausbricht: im tiefsten Bereich mindestens 7 % weniger Kraft als ohne sie, das Teil ganz gefräst.
the-reference-is-the-force-of-a-good-cut-wha = Die Referenz ist die Kraft eines guten Schnitts. Was wäre sie nach einem Lehrschnitt mit ausgebrochener Schneide?
on-the-screen-console-the-button-afc-opens-t = In der Ansicht Konsole öffnet die Schaltfläche AFC... das Fenster der Regelung. „Lehrschnitt“ fräst das Teil einmal wie eingerichtet, mit dem scharfen Werkzeug, und trägt ein, was er gefunden hat.
fmin-says-how-far-the-feed-may-go-down-with = FMIN sagt, wie weit der Vorschub sinken darf: Mit 50 % ist Spielraum. FMIN und FMAX bei 100 % überwachen nur.
the-references-are-taught-in-fmin-and-fmax-a = Die Referenzen sind gelernt, FMIN und FMAX sind beide 100 %. Was tut die Regelung, wenn die Schneide ausbricht?
it-lowers-the-feed-until-the-force-is-that-o = Sie senkt den Vorschub, bis die Kraft die der Referenz ist
it-may-go-no-lower-than-fmin-and-that-is-100 = Sie darf nicht unter FMIN gehen, und das ist hier 100 %.
it-watches-the-feed-stays-and-an-overload-is = Sie überwacht: Der Vorschub bleibt, und eine Überlast wird gemeldet
it-stops-the-machine-at-once = Sie hält die Maschine sofort an
an-overload-has-to-last-for-more-than-a-seco = Eine Überlast muss länger als eine Sekunde dauern, und was dann geschieht, ist gewählt: Meldung, Stopp, Rückzug und Stopp.
where-does-the-feed-come-to-rest-in-the-deep = Wo kommt der Vorschub im tiefsten Bereich des dritten Schnitts, dessen Kraft seine Referenz ist, zur Ruhe, in Prozent des programmierten?
t-1-1-3-would-be-77-but-at-a-lower-feed-the-fo = 1 / 1.3 ergäbe 77 %. Aber bei kleinerem Vorschub ist auch die Kraft kleiner und damit, was die Regelung misst: u = 1 / (1.3 u^0.6).
the-control-sets-the-feed-to-reference-over = Die Regelung stellt den Vorschub auf Referenz geteilt durch gemessene Kraft. Bei gleichem Vorschub braucht die ausgebrochene Schneide 30 % mehr Kraft; und die Kraft geht etwa mit der Potenz 0,6 des Vorschubs.
teach-in-with-the-window-afc-of-the-screen-c = Den Lehrschnitt im Fenster AFC der Ansicht Konsole ausführen, FMIN und FMAX dort oder hier einstellen und das Teil fräsen.
teach-in-set-fmin-and-cut = Lehrschnitt, FMIN einstellen, fräsen
the-machine-s-control-has-adaptive-feed-cont-2 =
    Die Steuerung der Maschine hat eine adaptive Vorschubregelung, AFC: Das erste Teil wird mit dem programmierten Vorschub gefräst, und die Spitzenkraft jedes Schnitts wird seine Referenz. Von da an folgt der Vorschub der Kraft. Gestern brach im zweiten Schnitt eine Schneide aus, und niemand merkte es, bis das Werkzeug brach. Heute geschieht nach 12 s dasselbe.
    Die Regelung kann noch zweierlei. Sie meldet eine Überlast, wenn die Kraft mehr als 1 s über ihrer Grenze bleibt, während der Vorschub schon auf FMIN steht: Weiter nachgeben kann sie nicht. Und sie schaltet sich für den Rest des Schnitts ab, wenn der Bediener den Override um mehr als 10 % zurückdreht: Dann führt die Hand den Vorschub.
set-up-feed-control-by-teach-in = Vorschubregelung mit Lehrschnitt einrichten

## assets/missions/quiet-speed.toml

at-one-speed-a-depth-chatters-at-another-the = Bei einer Drehzahl rattert eine Tiefe, bei einer anderen ist dieselbe Tiefe ruhig.
it-still-chatters-in-the-deeper-stretch-the = Es rattert im tieferen Bereich noch. Die Karte zeigt, bei welchen Drehzahlen 2 mm unter der Grenze liegen.
b-lim-1-2-k-s-mu-re-g-omega-min = b_lim = -1 / (2 K_s mu Re[G(omega)]_min)
tobias-and-fishwick-1958-tlusty-and-polacek = Tobias und Fishwick 1958, Tlusty und Polacek 1963; Maschine von 2019
a-tooth-cuts-into-the-wave-that-the-tooth-be = Ein Zahn schneidet in die Welle, die der Zahn vor ihm hinterlassen hat. Trifft er sie in Phase, ist der Span gleichmäßig und der Schnitt ruhig; wenn nicht, schwankt die Spanungsdicke und nährt die Schwingung. Die Phase hängt von der Drehzahl ab, so liegen ruhige Drehzahlen zwischen den Rattersäcken.
find-a-spindle-speed-at-which-the-deeper-str = Eine Spindeldrehzahl finden, bei der der tiefere Bereich ohne Rattern gefräst wird, mit dem Vorschub wie programmiert.
the-stability-chart-on-screen-machine-shows = Die Stabilitätskarte in der Ansicht Maschine zeigt, welche Tiefe bei welcher Drehzahl ruhig ist.
chatter-depends-on-where-in-its-vibration-th = Rattern hängt davon ab, wo in seiner Schwingung der Zahn auf die Welle trifft, die der letzte hinterlassen hat: Das ist eine Frage der Drehzahl, in Rattersäcken.
look-for-a-place-where-the-limit-is-above-2 = Eine Stelle suchen, wo die Grenze über 2 mm liegt: Nahe 1571 1/min gibt es eine.
what-helps = Was hilft?
only-a-lower-speed = Nur eine kleinere Drehzahl
lower-is-not-quieter-as-such-below-each-quie = Kleiner ist nicht von selbst ruhiger: Unter jeder ruhigen Drehzahl liegt ein weiterer Rattersack.
only-a-higher-speed = Nur eine größere Drehzahl
higher-is-not-quieter-as-such-at-1900-1-min = Größer ist nicht von selbst ruhiger: Bei 1900 1/min rattert es wie bei 1800. Die Karte ansehen.
a-certain-speed-there-are-quiet-ones-between = Eine bestimmte Drehzahl: Zwischen den Rattersäcken gibt es ruhige
at-1800-1-min-the-stretch-of-2-mm-chatters = Bei 1800 1/min rattert der Bereich mit 2 mm.
choose-a-speed-by-the-chart-and-cut = Eine Drehzahl nach der Karte wählen und fräsen.
find-it = Finden
the-deeper-stretch-sings-and-its-marks-can-b = Der tiefere Bereich singt, und seine Marken sind zu fühlen. Die Tiefe steht in der Zeichnung, also bleibt sie. „Langsamer“, sagt der eine. „Schneller“, sagt der andere.
a-quiet-speed-between-two-lobes = Eine ruhige Drehzahl zwischen zwei Rattersäcken

## assets/missions/plan-and-what-binds.toml

the-fastest-cut-within-seven-limits-which-of = Der schnellste Schnitt innerhalb von sieben Grenzen: Welche davon bremsen ihn?
the-programmed-feed-is-not-that-of-the-optim = Der programmierte Vorschub ist nicht der des Optimums.
the-programmed-speed-is-not-that-of-the-opti = Die programmierte Drehzahl ist nicht die des Optimums.
least-time-within-g-i-f-n-0-i-1-to-7 = kürzeste Zeit innerhalb g_i(f, n) <= 0, i = 1 bis 7
control-strategy-2013-particle-swarm-the-lim = Regelungsstrategie 2013 (Partikelschwarm); die Grenzen selbst sind gewählt, der Artikel gibt seine Liste nicht an
an-optimum-within-limits-lies-on-some-of-the = Ein Optimum innerhalb von Grenzen liegt auf einigen von ihnen. Die bindenden sagen, wofür es sich zu zahlen lohnt: hier die Kraft, die für die Rauheit steht, und die Standzeit der Schneide. Die zehnfache Leistung würde keine Sekunde sparen.
plan-the-cut-program-what-the-plan-found-and = Den Schnitt planen, das Ergebnis des Plans programmieren und sagen, welche Grenzen binden.
screen-plan-shows-the-limits-as-lines-over-f = Die Ansicht Plan zeigt die Grenzen als Linien über Vorschub und Drehzahl und in einer Tabelle, was von jeder noch übrig ist.
a-limit-binds-where-nothing-is-left-of-it-th = Eine Grenze bindet, wo nichts von ihr übrig ist: Das Optimum liegt auf ihrer Linie.
use-the-plan-s-button-to-program-the-optimum = Mit der Schaltfläche des Plans das Optimum programmieren: etwa 167 mm/min bei 2196 1/min.
which-limits-bind-at-the-optimum = Welche Grenzen binden im Optimum?
spindle-power-and-spindle-speed = Spindelleistung und Spindeldrehzahl
look-at-what-is-left-of-them-in-the-table-ne = In der Tabelle ansehen, was von ihnen übrig ist: fast die ganze Leistung, die halbe Drehzahl. Eine stärkere Spindel würde nichts ändern.
cutting-force-and-tool-life = Zerspankraft und Standzeit
cutter-deflection-and-feed = Fräserdurchbiegung und Vorschub
look-at-what-is-left-of-them-in-the-table-mo = In der Tabelle ansehen, was von ihnen übrig ist: von beiden das meiste. Sie bremsen den Schnitt nicht.
run-the-plan-on-screen-plan = Den Plan in der Ansicht Plan rechnen lassen.
program-the-optimum-and-cut-the-part = Das Optimum programmieren und das Teil fräsen.
program-it = Programmieren
before-the-first-chip-the-swarm-looks-for-th = Vor dem ersten Span sucht der Schwarm Vorschub und Drehzahl, die das Teil innerhalb von sieben Grenzen am schnellsten fräsen. Der Werkleiter fragt: Was sollen wir kaufen, um schneller zu sein, eine stärkere Spindel oder eine bessere Schneide?
plan-a-cut-and-say-what-binds = Einen Schnitt planen und sagen, was bindet

## assets/missions/outside-its-range.toml

what-a-controller-promises-with-models-that = Was ein Regler mit Modellen verspricht, die dort niemand erprobt hat.
for-more-than-half-of-the-cut-a-model-is-out = Mehr als die Hälfte des Schnitts liegt ein Modell außerhalb seines Bereichs: Was es dort sagt, hat niemand gemessen.
the-target-is-not-held-over-85-of-the-length = Der Sollwert wird nicht über 85 % der Länge gehalten.
k1-k5-valid-between-the-least-and-largest-va = K1..K5: gültig zwischen den kleinsten und größten Werten von Tabelle 3
a-formula-answers-everywhere-it-is-known-onl = Eine Formel antwortet überall; bekannt ist sie nur, wo gemessen wurde. Außerhalb geht dieses Programm mit der Steigung am Ende weiter und sagt es. Eine Lampe, die „außerhalb“ sagt, ist mehr wert als eine Zahl mit drei Stellen.
find-the-roughest-target-that-is-held-over-8 = Den rauesten Sollwert finden, der über 85 % der Länge gehalten wird, mit den Modellen den größten Teil des Schnitts in ihrem Bereich.
the-chips-for-k1-to-k5-say-which-model-is-ou = Die Lampen K1 bis K5 sagen, welches Modell außerhalb des Bereichs ist, aus dem es stammt.
table-3-of-2007-has-targets-from-0-38-to-1-5 = Tabelle 3 von 2007 hat Sollwerte von 0,38 bis 1,52 µm. Darüber hinaus gehen die Formeln nur mit ihren Endsteigungen weiter.
try-1-2-m-then-go-up-until-the-lamps-light-f = 1,2 µm versuchen, dann höher gehen, bis die Lampen mehr als die Hälfte des Schnitts leuchten.
what-roughness-does-the-part-get-at-the-end = Welche Rauheit in µm bekommt das Teil am Ende?
the-feed-that-the-model-asks-for-is-more-tha = Der Vorschub, den das Modell verlangt, ist größer, als der Override zulässt: Der Sollwert bleibt an seiner Grenze und Ra mit ihm.
the-target-is-4-m = Der Sollwert ist 4 µm.
lower-the-target-until-the-models-can-be-bel = Den Sollwert senken, bis den Modellen zu glauben ist.
find-the-end-of-what-is-known = Das Ende des Bekannten finden
for-a-roughing-cut-somebody-sets-the-target = Für einen Schruppschnitt setzt jemand den Sollwert auf Ra 4 µm. Der Regler hat dafür eine Formel, wie für alles: Formeln antworten immer.
a-model-outside-its-range = Ein Modell außerhalb seines Bereichs

## assets/missions/read-the-errata.toml

why-the-printed-equation-cannot-have-made-th = Warum die gedruckte Gleichung nicht die gedruckte Tabelle ergeben haben kann.
the-force-after-15-s-is-not-within-1-of-the = Die Kraft nach 15 s liegt nicht auf 1 % bei den 166,5 N, die Tabelle 3 nennt.
k2-f-0-for-f-177-07-n-as-printed-table-3-has = K2(F) < 0 für F < 177,07 N, wie gedruckt; Tabelle 3 hat Kräfte ab 166,5 N
sdnrp-2007-equation-5-and-table-3-errata-of = SDNRP 2007, Gleichung 5 und Tabelle 3; Errata dieses Programms
printed-constants-lose-digits-signs-and-unit = Gedruckte Konstanten verlieren unterwegs Ziffern, Vorzeichen und Einheiten. Wer ein Ergebnis nachrechnet, prüft, ob Gleichung und Tabelle zusammenpassen, und sagt, welcher von beiden er geglaubt hat und warum.
find-the-calibration-with-which-simulation-1 = Die Kalibrierung finden, mit der Simulation 1 aus Tabelle 3 wie gedruckt herauskommt: 166,5 N nach 15 s.
cut-simulation-1-with-the-models-as-printed = Simulation 1 mit den Modellen wie gedruckt fräsen und die Kraft nach 15 s ansehen.
k2-as-printed-gives-the-feed-for-a-force-put = K2 wie gedruckt gibt den Vorschub zu einer Kraft. 166 N einsetzen: Was kommt heraus?
the-calibration-identified-takes-its-constan = Die Kalibrierung `identified` nimmt ihre Konstanten aus der Tabelle selbst, da die gedruckten nicht stimmen können.
why-can-k2-as-printed-not-have-made-table-3 = Warum kann K2 wie gedruckt nicht Tabelle 3 ergeben haben?
it-gives-forces-that-are-too-small = Es gibt zu kleine Kräfte
k2-gives-a-feed-not-a-force-read-its-erratum = K2 gibt einen Vorschub, keine Kraft. Sein Erratum noch einmal lesen.
its-feed-is-negative-for-half-of-the-forces = Sein Vorschub ist für die Hälfte der Kräfte in der Tabelle negativ
its-unit-is-wrong-mm-instead-of-m = Seine Einheit ist falsch: mm statt µm
that-is-another-erratum-of-the-reference-rou = Das ist ein anderes Erratum, das der Soll-Rauheit. K2 suchen, Gleichung 5.
open-the-errata-on-screen-papers-and-the-car = Die Errata in der Ansicht Artikel öffnen und die Karte von K2.
read = Lesen
choose-the-calibration-that-repeats-the-row = Die Kalibrierung wählen, die die Zeile wiedergibt.
repeat-the-table = Die Tabelle nachrechnen
you-are-asked-to-build-what-a-paper-describe = Es soll gebaut werden, was ein Artikel beschreibt. Seine Gleichungen sind gedruckt, seine Ergebnisse auch. Die ersten in die zweiten eingesetzt, und nichts passt.
read-the-errata = Die Errata lesen
