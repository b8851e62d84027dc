# Deutsch

## src/app/about.rs

steadycut-simulates-milling-whose-controller = SteadyCut simuliert Fräsen, bei dem ein Regler die Rauheit Ra oder die Kraft über Vorschub und Drehzahl hält.

## src/app/bar.rs

mission-title = Mission: { $title }
mission-title-is-open-what-it-does-not-let-y = Mission „{ $title }“ ist offen: Was sie nicht freigibt, ist gesperrt
the-cut-stays-as-it-is-and-all-of-it-can-be = Der Schnitt bleibt, wie er ist, und alles lässt sich wieder ändern
leave = Verlassen
leave-the-mission = Mission verlassen
task-hints-and-answer-of-the-mission-on-the = Aufgabe, Hinweise und Antwort der Mission: in der Ansicht Lernen
back-to-the-mission = Zurück zur Mission
screen-2 = Ansicht
screens-keys = Ansichten ({ $keys }, …)
files-undo-colours-keys-search = Dateien, Rückgängig, Farben, Tasten, Suche
menu = Menü
find-a-setting-scenario-screen-command-or-wo-2 = Einstellung, Szenario, Ansicht, Befehl oder Wort suchen{ $keys }
find = Suche
what-this-is-keys-and-gestures = Was das ist; Tasten und Gesten (?)
keys-and-gestures = Tasten und Gesten
language = Sprache
light-colours-right-click-as-the-system-has = Helle Farben; Rechtsklick: wie im System
light = Hell
dark-colours-right-click-as-the-system-has-i = Dunkle Farben; Rechtsklick: wie im System
dark = Dunkel
open = Öffnen
open-a-scenario-file-one-can-also-be-dropped = Eine Szenariodatei öffnen; sie lässt sich auch hier ablegen
save = Speichern
save-the-scenario-with-its-edits = Das Szenario mit seinen Änderungen speichern
save-csv = CSV speichern
export-all-signals-of-the-run-as-csv = Alle Signale des Laufs als CSV exportieren
link-2 = Link
copy-a-link-that-holds-scenario-and-edits-an = Einen Link mit Szenario und Änderungen kopieren und mit QR-Code zeigen, dazu die Befehlszeile, die den Lauf wiederholt, und die Prüfsumme
undo = Rückgängig
take-the-last-change-back = Die letzte Änderung zurücknehmen
redo = Wiederholen
do-it-again = Noch einmal tun

## src/app/execute.rs

name-is-deleted = { $name } ist gelöscht.
the-signals-are-those-up-to-until-the-cut-is = Die Signale reichen bis { $until }: Der Schnitt wird noch gerechnet. Der Name der Datei sagt es.
the-chosen-controller-has-no-networks-that-l = Der gewählte Regler hat keine lernenden Netze.

## src/app/files/fallback.rs

no-file-dialog-is-available-drag-a-scenario = Kein Dateidialog verfügbar: eine Szenariodatei auf das Fenster ziehen oder mit `steadycut --scenario FILE` starten.

## src/app/files.rs

the-layout-is-remembered-for-files-like-it-b = Das Layout ist für ähnliche Dateien gemerkt, aber nicht neben dieser: { $why }
steadycut-scenario = SteadyCut-Szenario
unks-networks = UNKS-Netze
table = Tabelle
part-table-or-g-code = Werkstück: Tabelle oder G-Code
measured-data = Messdaten
saved-search = Gespeicherte Suche
model-of-a-formula = Modell einer Formel
kept-place = Behalten: { $place }
name-is-kept-in-this-browser = { $name } wird in diesem Browser behalten.
name-is-not-kept-why = { $name } wird nicht behalten: { $why }
no-file-dialog-is-available-type-the-path-of = Kein Dateidialog verfügbar: den Pfad des Ordners eintippen.
folder-a-page-has-no-folders = { $folder }: Eine Seite hat keine Ordner
my-files = Eigene Dateien
saved-as-name = gespeichert als { $name }
not-saved-error = nicht gespeichert: { $error }
no-file-dialog-is-available-and-name-could-n = Kein Dateidialog verfügbar, und { $name } ließ sich nicht schreiben: { $error }
no-file-dialog-is-available-saved-as-path = Kein Dateidialog verfügbar: gespeichert als { $path }
saved-as-name-in-the-browser-s-downloads = gespeichert als { $name } in den Downloads des Browsers
the-browser-did-not-take-name-for-download = der Browser nahm { $name } nicht zum Herunterladen an
name-could-not-be-read-error = { $name } ließ sich nicht lesen: { $error }
name-is-the-result-of-a-mission-steadycut-mi = { $name } ist das Ergebnis einer Mission: steadycut mission check { $name } prüft es.
name-is-a-file-of-a-spreadsheet-save-it-ther = { $name } ist eine Datei einer Tabellenkalkulation: dort als CSV speichern, die sich hier öffnen und ablegen lässt.

## src/app/format.rs

no-contact = kein Eingriff
outside-model = außerhalb des Modells
with-before-it-a-value-lies-outside-the-rang = Ein Wert mit ≈ davor liegt außerhalb des Bereichs seines Modells: Er ist über das Gemessene hinaus fortgesetzt.

## src/app/framed.rs

cannot-be-changed-it-is-locked = Nicht änderbar: { $locked }.
locked-the-mission-title-does-not-open-it-le = Gesperrt: Die Mission „{ $title }“ gibt es nicht frei. Zum Ändern die Mission verlassen.
the-address-that-this-was-opened-with-hides = Die Adresse, mit der dies geöffnet wurde, blendet andere Ansichten aus (hide:screens).
the-address-that-this-was-opened-with-hides-2 = Die Adresse, mit der dies geöffnet wurde, blendet die Suche aus (hide:find).
the-address-that-this-was-opened-with-hides-3 = Die Adresse, mit der dies geöffnet wurde, blendet Dateien und Links aus (hide:files).

## src/app/jobs/list.rs

t-1-job-at-work = 1 Auftrag läuft
n-jobs-at-work =
    { $n ->
        [one] { $n } Auftrag läuft
       *[other] { $n } Aufträge laufen
    }
n-at-work =
    { $n ->
        [one] { $n } läuft
       *[other] { $n } laufen
    }
t-1-job-stopped = 1 Auftrag angehalten
n-jobs-stopped =
    { $n ->
        [one] { $n } Auftrag angehalten
       *[other] { $n } Aufträge angehalten
    }
n-stopped = { $n } angehalten
running-at-work-halted-stopped = { $running } laufen, { $halted } angehalten
jobs-both = Aufträge: { $both }
what-is-being-worked-out-also-beside-other-s = Was gerade gerechnet wird; auch neben anderen Ansichten
go-on-with-job = Fortsetzen: { $job }
goes-on-where-it-was-stopped = Geht weiter, wo es angehalten wurde
stop-job = Anhalten: { $job }
stands-still-what-is-found-stays-and-it-can = Hält an; Gefundenes bleibt, und es kann von hier weitergehen
stopped-at-progress-what-is-found-stays = angehalten bei { $progress }: Gefundenes bleibt
progress-time-left = { $progress }, noch { $time }

## src/app/library/folder.rs

name-remove-it-from-its-folder-as-any-other = { $name }: Sie ist aus ihrem Ordner zu entfernen wie jede andere Datei

## src/app/library/page.rs

the-browser-refuses-this-page-its-storage-no = der Browser verweigert dieser Seite seinen Speicher: Hier wird keine Datei behalten
what-the-browser-has-kept-of-it-is-spoilt = was der Browser davon behalten hat, ist verdorben
taken-kb-of-most-kb-are-taken-whoever-clears = { $taken } kB von { $most } kB sind belegt. Wer die Daten dieser Seite im Browser löscht, entfernt diese Dateien: Wichtiges herunterladen.
it-is-not-kept-any-more = sie wird nicht mehr behalten
it-has-size-kb-at-most-most-kb-of-a-file-are = sie hat { $size } kB: in einem Browser werden höchstens { $most } kB je Datei behalten
n-files-are-kept-already-and-no-more-can-be = { $n } Dateien werden schon behalten, und mehr können es nicht sein: zuerst einige löschen
taken-kb-of-most-kb-are-taken-and-it-has-siz = { $taken } kB von { $most } kB sind belegt, und sie hat { $size } kB: zuerst einige löschen
the-browser-has-no-room-for-it-or-refuses-it = der Browser hat keinen Platz dafür oder verweigert ihn; was schon behalten wird, ist, wie es war

## src/app/library/present.rs

the-machine-has-the-papers-five-masses = die Maschine hat die fünf Massen der Veröffentlichungen
it-is-not-kept-from-here = von hier aus wird es nicht behalten
no-script-controls-this-cut = kein Skript regelt diesen Schnitt

## src/app/library/window.rs

no-place-in-a-run-has-the-units-of-its-input = Keine Stelle eines Laufs hat die Einheiten ihrer Eingänge und ihres Ergebnisses.
the-result-of-a-mission-is-verified-by-stead = Das Ergebnis einer Mission prüft steadycut mission check.
take-it-for-a-model-of-plant-and-controller = Für ein Modell von Strecke und Regler übernehmen
open-it-and-cut-it-from-its-start = Öffnen und von Anfang an fräsen
begin-it-on-the-screen-learn = Beginnen, auf dem Bildschirm Lernen
lay-it-over-the-plots = Über die Diagramme legen
cut-it-from-a-blank-on-the-screen-workpiece = Aus einem Rohteil fräsen, auf dem Bildschirm Werkstück
search-for-formulas-on-the-screen-identify = Nach Formeln suchen, auf dem Bildschirm Formeln
use-it-in-the-present-cut-undo-takes-it-back = In diesem Schnitt verwenden; Rückgängig nimmt es zurück
there-is-no-place-for-files-here-the-system = Hier ist kein Platz für Dateien: Das System nennt keinen.
files-that-this-browser-keeps-for-this-page = Dateien, die dieser Browser für diese Seite behält. Eine Datei ablegen oder öffnen, dann hier behalten.
t-1-other-file-is-of-no-use-here-and-not-liste = 1 andere Datei ist hier nicht zu gebrauchen und nicht aufgeführt.
n-other-files-are-of-no-use-here-and-not-lis = { $n } andere Dateien sind hier nicht zu gebrauchen und nicht aufgeführt.
cutters-materials-machines-parts-and-more-in = Fräser, Werkstoffe, Maschinen, Werkstücke und mehr in einem eigenen Ordner:
another-folder = Anderer Ordner…
it-is-read-every-two-seconds-while-this-wind = Er wird alle zwei Sekunden gelesen, solange dieses Fenster offen ist
read-again = Neu lesen
its-path = Sein Pfad
a-folder-that-is-there-enter-takes-it = ein vorhandener Ordner; Enter nimmt ihn
being-read = Wird gelesen…
none-of-these-here-yet-kinds = Davon ist hier noch nichts: { $kinds }.
no-files-here-yet-begin-one-below-or-keep-on = Noch keine Dateien hier: unten eine beginnen oder eine geöffnete behalten.
name-in-use = { $name }, in Gebrauch
in-use = in Gebrauch
delete-it-for-good = Endgültig löschen?
delete-it = Löschen
keep-it = Behalten
download = Herunterladen
delete = Löschen…
take-it-for = Übernehmen für
opened-from-elsewhere = Von anderswo geöffnet
begin-a-new-one = Eine neue beginnen
a-file-in-which-every-entry-is-explained-not = Eine Datei, in der jeder Eintrag erklärt ist; nichts wird überschrieben
keep-of-the-present-cut = Von diesem Schnitt behalten

## src/app/library/work.rs

files = Dateien

## src/app/link/code.rs

this-link-has-bytes-characters-and-a-qr-code = Dieser Link hat { $bytes } Zeichen, ein QR-Code fasst höchstens { $most }: den Link selbst senden.
qr-code-of-the-link = QR-Code des Links

## src/app/link.rs

link-to-this-state = Link zu diesem Zustand
link-to-this-mission = Link zu dieser Mission
the-link-is-in-the-clipboard = Der Link ist in der Zwischenablage.
the-link-s-part-from-on-is-in-the-clipboard = Der Teil des Links ab # ist in der Zwischenablage: an die Adresse der Webseite von SteadyCut anhängen.
there-is-no-clipboard-here-copy-the-link-by = Hier gibt es keine Zwischenablage. Den Link von Hand kopieren (Strg+C oder lange drücken):
the-command-line-is-in-the-clipboard = Die Befehlszeile ist in der Zwischenablage.
there-is-no-clipboard-here-copy-the-command = Hier gibt es keine Zwischenablage. Die Befehlszeile von Hand kopieren (Strg+C oder lange drücken):
command-line = Befehlszeile
the-cut-has-changed-since-all-this-is-of-the = Der Schnitt hat sich seither geändert: All dies gehört zum Schnitt, wie er war.
take-a-new-link = Neuen Link holen
repeats-the-run-on-the-command-line = Wiederholt den Lauf auf der Befehlszeile:
it-comes-to-the-digest = Er ergibt die Prüfsumme
the-digest-comes-here-once-the-cut-is-worked = Die Prüfsumme kommt, sobald der Schnitt bis zum Ende gerechnet ist.
it-was-changed-before-it-was-worked-out-to-i = Er wurde geändert, bevor er bis zum Ende gerechnet war: keine Prüfsumme.
copy-the-command-line = Befehlszeile kopieren
copy-the-link = Link kopieren
for-a-qr-code-the-address-of-a-page-with-ste = Für einen QR-Code: die Adresse einer Seite mit SteadyCut
allowed-is-an-address-that-begins-with-https = Zulässig ist eine Adresse, die mit https:// oder http:// beginnt, ohne #.
make-the-code = Code machen
save-as-svg = Als SVG speichern
save-as-png = Als PNG speichern

## src/app/messages.rs

remove-this-message-it-stays-in-the-list-of = Diese Meldung entfernen; sie bleibt in der Liste der Meldungen
dismiss = Verwerfen
what-was-said-so-far = Bisherige Meldungen
messages = Meldungen
messages-the-newest-first = Meldungen, die neueste zuerst

## src/app/mirror/mod.rs

name-nothing-can-be-written-there = { $name }: Hier lässt sich nichts schreiben
this-is-not-shown-any-more = Das wird nicht mehr angezeigt.
from-least-to-most = von { $least } bis { $most }
from-least-on = ab { $least }
up-to-most = bis { $most }
of-any-size = beliebiger Größe
name-text-is-not-a-number-allowed-is-a-numbe-2 = { $name }: „{ $text }“ ist keine Zahl: zulässig ist eine Zahl { $range }
name-text-is-not-in-its-range-allowed-is-a-n-2 = { $name }: „{ $text }“ liegt nicht im Bereich: zulässig ist eine Zahl { $range }

## src/app/mod.rs

embed-screen-id-allowed-behind-screen-are-al = embed: `screen:{ $id }`: hinter screen: zulässig sind { $allowed }

## src/app/native.rs

no-graphics-adapter-could-be-used-a-driver-f = Kein Grafikadapter ließ sich benutzen. Nötig ist ein Treiber für Vulkan; ohne Grafikkarte genügt der Softwaretreiber von Mesa (Debian, Ubuntu: apt install mesa-vulkan-drivers).
no-window-could-be-opened-a-display-is-neede = Kein Fenster ließ sich öffnen. Nötig ist eine Anzeige: Unter Linux muss DISPLAY oder WAYLAND_DISPLAY gesetzt sein, und X11 braucht libxkbcommon-x11 (Debian, Ubuntu: apt install libxkbcommon-x11-0). Ohne Anzeige öffnet `xvfb-run steadycut` eine unsichtbare, und `steadycut run` braucht keine.
the-console-cannot-be-shown-problem = die Konsole lässt sich nicht anzeigen: { $problem }

## src/app/overlay/file.rs

text = Text
tabs-between-the-values = Tabulatoren zwischen den Werten
semicolons-between-the-values = Strichpunkte zwischen den Werten
commas-between-the-values = Kommas zwischen den Werten
blanks-between-the-values = Leerzeichen zwischen den Werten
decimal-point = Dezimalpunkt
decimal-comma = Dezimalkomma
no-line-with-names = keine Zeile mit Namen
names-in-line-line = Namen in Zeile { $line }
units-in-line-line = Einheiten in Zeile { $line }
values-from-line-line-on = Werte ab Zeile { $line }
times-in-the-column-column = Zeiten in der Spalte { $column }
rate-samples-in-a-second = { $rate } Werte in einer Sekunde
no-times = keine Zeiten

## src/app/overlay/layouts.rs

what-was-said-for-a-file-with-the-same-colum = Was für eine Datei mit denselben Spalten gesagt wurde, passt nicht zu dieser: { $why }

## src/app/overlay/mod.rs

measured-name = gemessen: { $name }

## src/app/overlay/work.rs

steps = Schritte
and-n-more = { " " }und { $n } weitere
file-has-no-channel-name-it-has-channels = { $file } hat keinen Kanal `{ $name }`: Es gibt { $channels }.

## src/app/panels/console/afc.rs

adaptive-feed-control-teach-in-the-reference = Adaptive Vorschubregelung: Referenzkräfte im Lehrschnitt lernen, FMIN und FMAX einstellen und das Protokoll des Schnitts lesen
the-set-up-was-changed-meanwhile-nothing-is = Die Einrichtung wurde inzwischen geändert: Nichts wird übernommen. Den Lehrschnitt wiederholen.
taught-in = Gelernt.
taught-in-up-to-the-time-limit-the-part-is-l = Lehrschnitt bis zur Zeitgrenze gelernt; das Teil ist länger.
not-taught-in-why = Kein Lehrschnitt: { $why }
teach-in-cuts-the-part-of-the-set-up-once-at = Der Lehrschnitt fräst das Teil der Einrichtung einmal mit dem programmierten Vorschub, ohne die Änderungen dieser Sitzung, und behält die Spitzenkraft jedes Schnitts als Referenz.
stop-the-teach-in = Lehrschnitt anhalten
teach-in-2 = Lehrschnitt
teach-in-3 = Lehrschnitt
cut-number-feed-feed-force-of-reference-shar = Schnitt { $number }: Vorschub { $feed }, { $force } von { $reference } ({ $share } %)
cut-number-feed-feed-force-no-reference = Schnitt { $number }: Vorschub { $feed }, { $force }, keine Referenz
teach-in-the-feed-stays-as-programmed = Lehrschnitt: Der Vorschub bleibt wie programmiert.
off-for-this-cut-the-operator-has-turned-the = Für diesen Schnitt aus: Der Bediener hat den Override zurückgedreht.
overload-the-force-stays-over-its-limit-with = Überlast: Die Kraft bleibt mit dem Vorschub auf FMIN über ihrer Grenze.
watching-fmin-and-fmax-are-100-the-feed-stay = Überwacht: FMIN und FMAX sind 100 %, der Vorschub bleibt wie programmiert.
out-of-the-cut-feed-in-the-air = Außer Eingriff: Vorschub in der Luft.
the-feed-stands-at-fmin = Der Vorschub steht auf FMIN.
the-feed-stands-at-fmax = Der Vorschub steht auf FMAX.
the-feed-follows-the-force = Der Vorschub folgt der Kraft.
log = Protokoll
done-of-n-cuts-done = { $done } von { $n } Schnitten fertig
cut = Schnitt
number-of-the-cut = Nummer des Schnitts
ref-n = Ref. N
reference-force-as-teach-in-has-found-it = Referenzkraft, wie der Lehrschnitt sie gefunden hat
teach-in-s = Lehrschnitt s
time-that-the-cut-takes-at-the-programmed-fe = Zeit, die der Schnitt mit programmiertem Vorschub braucht
control-s = geregelt s
time-that-it-took = Zeit, die er gebraucht hat
diff = Diff. %
by-how-much-that-is-longer = Um wie viel das länger ist
peak-n = Spitze N
largest-measured-force = Größte gemessene Kraft
least = kleinster %
least-feed-of-the-programmed-one = Kleinster Vorschub, bezogen auf den programmierten
overload = Überlast
all = alle

## src/app/panels/console/answer.rs

with-dynamics-error-within = mit Dynamik { $error } in Tol.
with-dynamics-error-outside = mit Dynamik { $error } außer Tol.
with-dynamics-error = mit Dynamik { $error }
too-short-yet = noch zu kurz
too-short-to-judge = zu kurz zum Beurteilen
not-at-rest = nicht in Ruhe
still-on-its-way = noch unterwegs
force-swing = Kraft ±{ $swing }
period-period-no-rest = Periode { $period }, keine Ruhe
no-ra = kein Ra
not-judged = nicht beurteilt
outside-the-model = außerhalb des Modells
ra-outside-its-model = Ra außerhalb des Modells
error-within = { $error } in Tol.
error-outside = { $error } außer Tol.
ra-swings-by-swing = Ra schwankt um ±{ $swing }
force-swings-by-swing = Kraft schwankt um ±{ $swing }
unstable-2 = instabil
chattered = ratterte
from-to-to-s-and-before = { $from } bis { $to } s, und davor
from-to-to-s = { $from } bis { $to } s
the-band-is-band-here-the-2-of-the-textbooks = Das Band ist hier ±{ $band }: die 2 % der Lehrbücher, da kein Rauschen die Kraft in Ruhe bewegt.
the-band-is-band-here-the-2-of-the-textbooks-2 = Das Band ist hier ±{ $band }: die 2 % der Lehrbücher und { $noise } dafür, wie Rauschen die Kraft in Ruhe noch bewegt.
what-is-held-swings-by-more-than-that-nothin = Die geregelte Größe schwankt stärker: Hier regelt sich nichts ein.
no-rest-band = keine Ruhe (±{ $band })
does-not-settle-band = regelt sich nicht ein (±{ $band })
force-rests-time = Kraft ruht { $time }
force-settles-in-time-band = Kraft ausgeregelt in { $time } (±{ $band })
force-steady = Kraft ruhig
force-settles-at-once-band = Kraft sofort ausgeregelt (±{ $band })
no-transient = kein Einschwingen
jump-jump = Sprung { $jump }
jump-jump-no-overshoot = Sprung { $jump }, kein Überschwingen
overshoot-size = Überschwingen { $size }
its-overshoot-size = ihr Überschwingen { $size }

## src/app/panels/console/bands.rs

at-a-limit = An einer Grenze
outside-model-2 = Außerhalb des Modells
in-the-air-2 = In der Luft
override-on-its-way = Override unterwegs
over-the-afc-limit = Über der AFC-Grenze
controller = Regler
disturbances = Störungen
none-2 = keine
none-now = jetzt keine
names-now = jetzt: { $names }
no = nein
not-now = jetzt nicht
now = jetzt
names-not-now = { $names }, jetzt nicht
feed-2 = Vorschub
speed = Drehzahl
spindle = Spindel

## src/app/panels/console/cards.rs

safe = sicher
safe-feed = sicherer Vorschub
share-over-scrap = { $share }, { $over } % Ausschuss
ra-now = Ra jetzt
ra-in-tolerance = Ra in Toleranz
remaining-error = Bleibende Abweichung
with-dynamics-in-tolerance = Mit Dynamik in Toleranz
error-without-dynamics = Abweichung ohne Dynamik
share-no-ra-model = { $share } % kein Ra ({ $model })
share-outside-the-ra-model-model = { $share } % außerhalb des Ra-Modells ({ $model })
target-target = Soll { $target }
within-target-target = am Soll { $target }
over-rough-under-smoother = { $over } % rau, { $under } % glatter
of-the-length-cut = der gefrästen Länge
without-dynamics-share = ohne Dynamik { $share }
share-rest-smoother = { $share }, Rest glatter
time-of-cut = Schnittzeit
both-scrap-own-and-over = beide Ausschuss: { $own } und { $over } %
metal-removed = Zerspantes Volumen
on-path-of-path = auf { $path } Bahn

## src/app/panels/console/controls.rs

target = Sollwert
workpiece = Werkstück
what-a-cut-costs = Was ein Schnitt kostet
nc-program = NC-Programm
what-constant-feed-to-compare-with = Mit welchem konstanten Vorschub verglichen wird
cnc-and-dead-time = CNC und Totzeit
what-the-controller-believes = Was der Regler annimmt
noise = Rauschen
plant = Strecke
own-formulas-of-the-models = Eigene Formeln der Modelle
cutter = Fräser
wear-over-the-tool-s-life = Verschleiß über die Standzeit
feed-drive = Vorschubantrieb
spindle-drive = Spindelantrieb
machine = Maschine
sound-and-tool-life = Geräusch und Standzeit
roughness-profile-2 = Rauheitsprofil
off-line-plan = Offline-Plan
run-2 = Lauf
name = Name
edit-depths = Tiefen bearbeiten…
the-depth-from-which-on-this-machine-chatter = Die Tiefe, ab der es auf dieser Maschine rattert, über der Drehzahl: in der Ansicht Maschine
limit-depth-2 = Grenztiefe…
the-forces-on-the-tool-at-28-8-khz-over-the = Die Kräfte am Werkzeug mit 28,8 kHz über die letzten Umdrehungen vor der Abspielmarke
within-a-revolution = In einer Umdrehung…
operator-2 = Bediener…
more-settings = Mehr Einstellungen
a-measured-file-over-the-plots-text-matlab-h = Eine Messdatei über den Diagrammen: Text, MATLAB, HDF5, TDMS oder Parquet. Sie kann auch hierher gezogen werden.
measured-data-2 = Messdaten …
scenario-changed = { $scenario }, geändert
scenario-scenario = Szenario: { $scenario }
scenario = Szenario
the-shipped-scenarios = Die mitgelieferten Szenarien
the-cut-of-the-mission-title-its-task-is-on = Der Schnitt der Mission „{ $title }“; ihre Aufgabe steht auf dem Bildschirm Lernen.
as-shipped-about = Wie mitgeliefert: { $about }
without-the-changes-made-in-the-cut-about = Ohne die Änderungen während des Schnitts: { $about }

## src/app/panels/console/disturb.rs

drops-a-disturbance-into-the-cut-a-little-ah = Setzt eine Störung in den Schnitt, etwas vor dem Werkzeug; Rückgängig nimmt sie zurück
names-and-sizes-of-disturbances = Namen und Größen der Störungen
disturb-the-cut = Den Schnitt stören…
disturb-the-cut-2 = Den Schnitt stören
a-press-on-a-name-drops-that-disturbance-a-l = Ein Druck auf einen Namen setzt diese Störung etwas vor das Werkzeug, so lang und so groß wie daneben eingestellt.
length-of-the-disturbance = Länge: { $disturbance }
mm-long = { " " }mm lang
size-of-the-disturbance = Größe: { $disturbance }
least-to-most = { $least } bis { $most }

## src/app/panels/console/headline.rs

finding = wird gesucht …
axial-depth-times-radial-depth-summed-over-t = Schnitttiefe mal Schnittbreite, über die Bahn summiert.
without-none = ohne: keines
without-outside-its-model = ohne: außerhalb des Modells
without-ra = ohne { $ra }
in-twin-ra = Zum Vergleich, { $twin }: { $ra }.
roughness-produced-at-the-playhead-with-the = An der Abspielmarke erzeugte Rauheit, mit den Marken der Maschinenschwingung: wie sie sein soll innerhalb { $percent } % vom Sollwert. Ohne ist Ra nach dem Modell des Schnitts allein, das ein Regler hält. { $beside }
roughness-produced-at-the-playhead-as-it-sho = An der Abspielmarke erzeugte Rauheit: wie sie sein soll innerhalb { $percent } % vom Sollwert.
swings-target-target = schwankt, Soll { $target }
above-target-target = über Soll { $target }
below-target-target = unter Soll { $target }
ra-with-dynamics = Ra mit Dynamik
force-without-dynamics = Kraft ohne Dynamik
judged-without-dynamics = ohne Dynamik beurteilt
the-steady-state-error-how-far-ra-or-the-for-2 = Die bleibende Regelabweichung: wie weit Ra, oder die Kraft, wo eine gehalten wird, nach dem letzten Sprung neben dem Sollwert zur Ruhe kommt, und ob das mit dem, um das es noch schwankt, in der Toleranz liegt; die Ausregelzeit der Kraft, bis sie endgültig in einem Band um ihre Ruhelage bleibt, und ihr Überschwingen darüber: der Sprung, den die Änderung selbst macht, ist keines. Instabil: Vorschub und Kraft schwingen, ohne abzuklingen; ein solcher Schnitt heißt später nicht mehr gut.{ $band }
in-the-air-reference-force = in der Luft, Referenz { $force }
above-reference-force = über Referenz { $force }
within-reference-force = an Referenz { $force }
below-reference-force = unter Referenz { $force }
with-dynamics-force = mit Dynamik { $force }
force-now = Kraft jetzt
maximum-force-at-the-playhead-without-dynami = Größte Kraft an der Abspielmarke, ohne Dynamik: wie sie sein soll innerhalb { $percent } % von ihrer Referenz.
outside-the-ra-model-model = außerhalb des Ra-Modells ({ $model })
force-in-tolerance = Kraft in Toleranz
share-of-the-cut-length-on-which-the-produce = Anteil der gefrästen Länge, auf dem das erzeugte Ra in der Toleranz um seinen Sollwert liegt. Außerhalb ist es zu rau, was Ausschuss ist, oder glatter als verlangt, was keiner ist. Wo Ra außerhalb seines Modells liegt, wird es nicht beurteilt: Es liegt weder innerhalb noch außerhalb.
share-of-the-cut-length-on-which-ra-with-dyn = Anteil der gefrästen Länge, auf dem Ra mit Dynamik, das auf dem Teil bleibt, in der Toleranz um den Sollwert liegt. Außerhalb ist es zu rau, was Ausschuss ist, oder glatter als verlangt, was keiner ist. Wo Ra außerhalb seines Modells liegt, wird es nicht beurteilt.
share-of-the-cut-length-on-which-the-maximum = Anteil der gefrästen Länge, auf dem die größte Kraft in der Toleranz um ihre Referenz liegt.
so-far-sides = Bisher: { $sides }.
in-twin-sides = Zum Vergleich, { $twin }: { $sides }.
over-too-rough-under-smoother = { $over } % zu rau, { $under } % glatter
over-above-under-below = { $over } % darüber, { $under } % darunter
share-smoother-no-scrap = { $share } % glatter, kein Ausschuss
share-below-no-scrap = { $share } % darunter, kein Ausschuss
share-too-rough = { $share } % zu rau
share-above = { $share } % darüber
share-rest-below = { $share }, Rest darunter
worst-force-deviation = Größte Kraftabweichung
largest-deviation-of-the-force-from-the-desi = Größte Abweichung der Kraft von der Sollkraft nach der ersten Sekunde.
from-desired-force = von der Sollkraft
as-long = gleich lang
saves-percent = spart { $percent } %
percent-longer = { $percent } % länger
twin-took-for-the-same-length-of-path-time-l = { $twin }: { $took } für dieselbe Bahnlänge, { $time } verloren.
twin-took-for-the-same-length-of-path-time-s = { $twin }: { $took } für dieselbe Bahnlänge, { $time } gespart.
twin-took-not-compared-why = { $twin }: { $took }, nicht verglichen: { $why }.
it-is-compared-with-the-programmed-feed-sinc = Verglichen wird mit dem programmierten Vorschub, denn: { $why }.
time-since-the-start-of-the-cut-told-times-a = Zeit seit Beginn des Schnitts. { $told } Zeiten werden nur verglichen, wo beide den Sollwert halten: auf höchstens { $percent } % der Länge über der Toleranz. Ein schnellerer Schnitt, der Ausschuss ist, ist kein Gewinn; eine glattere Oberfläche als verlangt ist kein Ausschuss.{ $none_safe }
twin-over-scrap = { $twin }: { $over } % Ausschuss
twin-over-above = { $twin }: { $over } % darüber
this-cut-over-scrap = dieser Schnitt: { $over } % Ausschuss
this-cut-over-above = dieser Schnitt: { $over } % darüber
both-above-own-and-over = beide darüber: { $own } und { $over } %
this-cut-share-not-judged = dieser Schnitt: { $share } % nicht beurteilt
twin-share-not-judged = { $twin }: { $share } % nicht beurteilt
nothing-is-cut-yet = noch ist nichts gefräst
neither-is-scrap = keiner ist Ausschuss
most-is-scrap = ≤ { $most } % sind Ausschuss

## src/app/panels/console/measured/layout.rs

search-for-formulas-in-it = Formeln darin suchen
record = Datensatz
none-a-sample-rate = keine: eine Abtastrate
time-column = Spalte der Zeiten
sample-rate = Abtastrate
read-it-otherwise = Anders lesen
entries-of-the-layout-as-the-command-steadyc = Einträge des Aufbaus, wie sie der Befehl steadycut measured hat, mit Leerzeichen dazwischen: encoding, separator, decimal, thousands, names_line, units_line, first_line, names, units. Enter liest die Datei neu.
allowed-is-key-value = erlaubt ist KEY=VALUE
as-you-said-for-a-file-with-the-same-columns = Wie für eine Datei mit denselben Spalten gesagt: { $keys }.
as-the-file-name-beside-it-says-keys = Wie die Datei { $name } daneben sagt: { $keys }.
remembered-in-name-and-for-files-with-the-sa = Gemerkt in { $name } und für Dateien mit denselben Spalten: { $keys }.
remembered-for-files-with-the-same-columns-k = Gemerkt für Dateien mit denselben Spalten: { $keys }.
read-it-as-it-is-guessed-and-forget-what-is = So lesen, wie es geraten wird, und das Gemerkte vergessen, auch neben der Datei
guess-again = Neu raten
t-1-channel = 1 Kanal
n-channels = { $n } Kanäle
channel = Kanal
samples = Werte
least-2 = kleinster
largest = größter

## src/app/panels/console/measured/place.rs

the-channel-is-being-worked-out = Der Kanal wird vorbereitet.
finds-the-shift-at-which-both-go-together-mo = Findet die Verschiebung, bei der beide am besten zusammengehen, und dort Maßstab und Versatz, wie steadycut measured es tut
align = Ausrichten
shift-0-s-scale-1-offset-0 = Verschiebung 0 s, Maßstab 1, Versatz 0
as-measured = Wie gemessen
shift = Verschiebung
by-so-much-the-measurement-is-later-than-the = Um so viel ist die Messung später als die Simulation: Um das wird sie früher gezeichnet
scale = Maßstab
the-run-times-this-is-what-was-measured-the = Die Simulation mal diesem Wert ist das Gemessene: Die Linie ist dadurch geteilt gezeichnet
scale-value-cannot-be-allowed-is-any-number = Maßstab: { $value } kann nicht sein: Erlaubt ist jede Zahl außer 0, mit einem Betrag ab { $least }
offset-2 = Versatz
what-the-measurement-has-in-addition-after-t = Was die Messung nach dem Maßstab noch dazu hat
not-aligned-why-it-can-be-moved-by-hand = Nicht ausgerichtet: { $why }. Es kann von Hand verschoben werden.
it-is-aligned-as-soon-as-the-cut-is-worked-o = Es wird ausgerichtet, sobald der Schnitt berechnet ist.
it-has-nothing-in-common-with-the-cut-here = Hier hat es mit dem Schnitt nichts gemeinsam.
by-hand = von Hand
aligned = ausgerichtet
how-what-is-left-rms-rest-over-samples-sampl = { $how }: was bleibt, effektiv { $rest } über { $samples } Werte; Korrelation { $correlation }

## src/app/panels/console/measured/prepare.rs

preparation = Vorbereitung
low-pass-filter-without-a-shift-in-time = Tiefpass, ohne Verschiebung in der Zeit
cut-off = Grenzfrequenz
zero-before-the-cut = Null vor dem Schnitt
before-the-cut = vor dem Schnitt
drift-by-a-time-behind-the-cut = Drift, nach einer Zeit hinter dem Schnitt
behind-the-cut = hinter dem Schnitt
turn-two-forces-into-the-machine-s-axes = Zwei Kräfte in die Achsen der Maschine drehen
force-x-of-the-dynamometer = Kraft x des Dynamometers
force-y-of-the-dynamometer = Kraft y des Dynamometers
angle-to-x = Winkel zu X
largest-force-across-the-tool-in-every-perio = Größte Kraft quer zum Werkzeug in jeder Periode
force-along-x = Kraft längs x
force-along-y = Kraft längs y
period = Periode
from-time = Von, { $time }
to-time = Bis, { $time }

## src/app/panels/console/measured.rs

name-is-not-shown-there-are-most-measured-ch = { $name } wird nicht gezeigt: Über den Diagrammen liegen schon { $most } gemessene Kanäle. Entfernen Sie zuerst einen.
unfold = Aufklappen
open-a-file = Datei öffnen …
leaves-a-line-of-it-and-the-plots-in-sight = Lässt eine Zeile davon übrig und die Diagramme sichtbar
fold-to-a-line = Einklappen
text-of-any-layout-matlab-hdf5-tdms-or-parqu = Text in beliebigem Aufbau, MATLAB, HDF5, TDMS oder Parquet; eine Datei kann auch auf die Diagramme gezogen werden.
no-part-of-the-scenario-neither-a-file-nor-a = Kein Teil des Szenarios: Weder eine Datei noch ein Link enthält es. Änderungen des Schnitts lassen es, wo es ist, bis es entfernt oder das Programm geschlossen wird.
remove = Entfernen
channel-2 = Kanal
laid-over = Liegt über
as-it-is-not-converted = wie sie ist, nicht umgerechnet
its-unit = Einheit
show-it = Zeigen
another-channel-of-this-file = Noch ein Kanal dieser Datei
drive-forces-structure-noise-wear-or-materia = Antrieb, Kräfte, Struktur, Rauschen, Verschleiß oder Werkstoff aus dieser Datei, in der Ansicht Formeln
fit-settings-to-it = Einstellungen daran anpassen
channel-over-signal-more = { $channel } über { $signal }{ $more }

## src/app/panels/console/mod.rs

least-override = Kleinster Override
largest-override = Größter Override
roughness = Rauheit
force-2 = Kraft
feed = Vorschub
spindle-speed = Spindeldrehzahl
override-2 = Override
depth-of-cut = Schnitttiefe
console = Konsole
start-home-plots-run-simulation-digest = Start Anfang Diagramme Lauf Simulation Prüfsumme
settings = Einstellungen

## src/app/panels/console/operator/figures.rs

mm-min-of-feed = mm/min, von { $feed }
t-1-min-of-speed = 1/min, von { $speed }
mm-min-programmed-feed = mm/min, programmiert { $feed }
t-1-min-programmed-speed = 1/min, programmiert { $speed }
sent-to-the-machine = an die Maschine gesendet
place-in-the-cut = Ort im Schnitt
mm-of-length = mm von { $length }
the-part-the-tool-is-at-place-depth-deep = Das Teil: Das Werkzeug steht bei { $place }, { $depth } tief
the-machine-is-paused = Die Maschine steht (Pause).
feeding-not-in-the-cut = Der Vorschub läuft, außerhalb des Schnitts.
cutting = Im Schnitt.
cutting-force-2 = Zerspankraft
mark-force-n = Marke: { $force } N
mark-force-n-which-ra-target-asks-for = Marke: { $force } N, von Ra { $target } verlangt
mark-force-n-which-is-to-be-held = Marke: { $force } N, zu halten
force-n-stops-the-feed = { $force } N halten den Vorschub an
force-n-breaks-a-tooth = { $force } N brechen einen Zahn
no-force-stops-this-machine-setting-stop-on = Keine Kraft hält diese Maschine an (Einstellung: Stopp bei Überlast)
force-force-n-asked-for-asked-n-limit-limit = Kraft { $force } N, verlangt { $asked } N, Grenze { $limit } N
force-force-n-asked-for-asked-n = Kraft { $force } N, verlangt { $asked } N

## src/app/panels/console/operator/mod.rs

cut-by-hand = Von Hand fräsen
you-hold-the-feed-override-a-knob-what-an-op = Sie führen den Vorschub-Override: ein Drehknopf, was ein Bediener sieht und hört, und danach eine Wertung gegen jeden Regler
operator = Bediener
from-the-start-of-the-part-without-a-control = Vom Anfang des Teils, ohne Regler und bei 100 %
plots-settings-and-sentences-beside-the-knob = Diagramme, Einstellungen und Sätze neben dem Knopf, die ein Bediener nicht hat
whole-console = Ganze Konsole
back-to-the-console-the-cut-goes-on-as-it-is = Zurück zur Konsole; der Schnitt geht weiter, wie er ist{ $keys }

## src/app/panels/console/operator/panel.rs

drag-around-it-wheel-and-page-up-and-down = Im Kreis ziehen, Mausrad, + und -, Bild auf und ab
override-percent-up = Override { $percent } % höher
override-percent-down = Override { $percent } % tiefer
the-cut-is-over = Der Schnitt ist zu Ende
you-have-the-feed = Sie haben den Vorschub
controller-has-the-feed = { $controller } hat den Vorschub
give-it-back-to-controller = Zurückgeben an { $controller }
give-it-back = Zurückgeben
take-it = Übernehmen
at-the-override-that-is-sent-now-a-turn-of-t = Mit dem jetzt gesendeten Override; ein Dreh am Knopf übernimmt ihn auch
the-cut-is-over-cut-by-hand-begins-it-again = Der Schnitt ist zu Ende: Von Hand fräsen beginnt ihn neu
scale-to = Skala bis
as-on-a-machine-s-panel = Wie am Bedienfeld einer Maschine
as-far-as-the-cnc-lets-a-controller-go = So weit die CNC einen Regler lässt
scale-to-percent = Skala bis { $percent }

## src/app/panels/console/operator/score.rs

score-of-the-cut-by-hand = Wertung des Schnitts von Hand
your-hand-against-every-controller = Ihre Hand gegen jeden Regler
your-last-cut-by-hand-against-every-controll = Ihr letzter Schnitt von Hand gegen jeden Regler
the-same-part-and-noise-for-everybody-ranked = Dasselbe Teil und Rauschen für alle. Nach Zeit gereiht ist, wer die Toleranz auf { $percent } % der Länge hält.
a-force-of-force-tolerance = eine Kraft von { $force } ± { $tolerance } %
everybody-else-cuts-the-same-part-now = Alle anderen fräsen jetzt dasselbe Teil.
this-cut-was-not-driven-by-hand-button-begin = Dieser Schnitt wurde nicht von Hand gefahren. { $button } beginnt ihn von Anfang an: den Knopf drehen, während er fräst.
asked-for-is-asked-hold-the-force-at-its-mar = Verlangt ist { $asked }. Die Kraft an ihrer Marke halten: langsamer, wo das Teil tiefer oder härter wird, schneller, wo es leichter wird. Der Knopf wirkt nach der Totzeit. Am Ende wird der Schnitt gegen jeden Regler am selben Teil gewertet.
ra-in-tol = Ra in Tol. %
force-in-tol = Kraft in Tol. %
rank = Rang
by-time-among-those-who-hold-the-tolerance = Nach Zeit, unter denen, die die Toleranz halten
who = wer
your-hand-and-every-way-of-control = Ihre Hand und jede Art der Regelung
share-of-the-length-on-which-what-is-asked-f = Anteil der Länge, auf dem das Verlangte gehalten wird
time-s = Zeit s
time-of-the-cut-none-if-it-did-not-come-to-i = Schnittzeit; keine, wenn er nicht ans Ende kam
greatest-force = Größte Kraft
travel-s = Weg %/s
way-of-the-feed-override-in-a-second = Weg des Vorschub-Overrides in einer Sekunde
cut-2 = Fräsen
cut-by-controller = Fräsen mit { $controller }
cuts-the-part-this-way-with-your-hand-drawn = Fräst das Teil auf diese Art, mit Ihrer Hand in den Diagrammen

## src/app/panels/console/revolution/plot.rs

before-the-last-change-the-new-picture-is-be = Vor der letzten Änderung; das neue Bild wird gemacht.
peak-of-the-control-period = Spitze des Regeltakts
forces-from-from-to-to = Kräfte von { $from } bis { $to }
n-samples-up-to-time-s =
    { $n ->
        [one] { $n } Abtastung bis { $time } s
       *[other] { $n } Abtastungen bis { $time } s
    }
n-samples-up-to-time-s-peak-of-the-last-cont =
    { $n ->
        [one] { $n } Abtastung bis { $time } s. Spitze des letzten Regeltakts (schattiert): { $force } bei { $angle }; mit dem Sensorrauschen ist sie, was der Regler sieht.
       *[other] { $n } Abtastungen bis { $time } s. Spitze des letzten Regeltakts (schattiert): { $force } bei { $angle }; mit dem Sensorrauschen ist sie, was der Regler sieht.
    }

## src/app/panels/console/revolution.rs

within-a-revolution-2 = In einer Umdrehung
desired-force = Sollkraft
fxy-across-the-tool = Fxy, quer zum Werkzeug
fx-along-the-feed = Fx, in Vorschubrichtung
fy-across-the-feed = Fy, quer zum Vorschub
fz-along-the-tool = Fz, entlang des Werkzeugs
the-run-is-being-repeated-up-to-this-moment = Der Lauf wird bis zu diesem Augenblick wiederholt.
t-1-turn = 1 Umdrehung
t-2-turns = 2 Umdrehungen
angle = Winkel
time = Zeit
save-these-samples-as-csv-time-angle-fx-fy-f = Diese Abtastungen als CSV speichern: Zeit, Winkel, Fx, Fy, Fz, Fxy
the-revolution = die Umdrehung
the-force-was-not-simulated-tooth-by-tooth-a = Die Kraft wurde in diesem Augenblick des Laufs nicht Zahn für Zahn simuliert.
the-force-of-this-cut-is-the-maximum-that-a = Die Kraft dieses Schnitts ist das Maximum, das eine Formel oder ein Netz gibt.
to-look-into-a-revolution-the-force-has-to-b = Um in eine Umdrehung zu sehen, muss die Kraft Zahn für Zahn simuliert werden: mit dem mechanistischen Modell des Kugelfräsers, bei 28,8 kHz.
simulate-tooth-by-tooth = Zahn für Zahn simulieren
load-experiment-2 = Experiment 2 laden
both-can-be-undone-the-first-keeps-this-scen = Beides lässt sich rückgängig machen. Das Erste behält dieses Szenario und ändert seine Strecke.

## src/app/panels/console/story.rs

a-burst-of-chatter-begins-here-3-times-over = Ein Ratterstoß beginnt hier: 3 % der Kraft über 5,0 mm, aufgeprägt: sicherer konstanter Vorschub verlässt die Toleranz (Ra von 0,45 µm auf 0,88 µm), der Regler senkt den Vorschub um 16,1 % (von 319 auf 299 mm/min), erhöht die Drehzahl um 14,6 % und verlässt die Toleranz (Ra von 0,77 µm auf 1,23 µm). Die bleibende Regelabweichung ist 51 % über dem Soll-Ra, Ra schwankt darum noch mit ±13,2 %; das Regelgesetz hat keinen I-Anteil.
the-spindle-speed-command-stands-at-its-uppe-2 = Der Drehzahlsollwert steht an seiner oberen Grenze, 2500 1/min (150 % Override), 60 % dieser Zeit: dabei liegt Ra 12,3 % über dem Sollwert, außerhalb der Toleranz.
ahead-of-the-playhead-not-cut-yet-a-click-go = Vor der Abspielmarke, noch nicht gefräst: Ein Klick geht dorthin
each-click-goes-to-the-next-of-them = Jeder Klick geht zur nächsten.
remove-this-line-shows-it-again = Diese Zeile entfernen; `?` zeigt sie wieder
close-the-introduction = Die Einführung schließen
the-depths-and-speeds-at-which-this-machine = Die Tiefen und Drehzahlen, bei denen diese Maschine rattert, und der Schalter ihres Tons
stability-and-sound = Stabilität und Geräusch

## src/app/panels/console/workpiece/hand.rs

tap-what-then-drag-its-dot = Antippen und am Punkt ziehen: { $what }.
drag-what = Ziehen: { $what }.
nothing-chosen = Nichts gewählt
depth-number = Tiefe { $number }
end-of-number = Ende von { $number }
wall-number = Wand { $number }

## src/app/panels/console/workpiece/material.rs

material-even-noise-and-inhomogeneity-above-2 = Werkstoff: gleichmäßig. „Rauschen“ und „Inhomogenität“ über 0 machen ihn ungleichmäßig, nach dem Startwert.
material-under-seed-seed-force-low-to-high-a = Werkstoff mit Startwert { $seed }: Kraft { $low } bis { $high } entlang dieses Schnitts
change-at-place = { $change } bei { $place }

## src/app/panels/console/workpiece/picture.rs

depths-drawn-times-times-larger-than-lengths = Tiefen { $times }-mal größer gezeichnet als Längen
to-scale = maßstäblich
from-the-side-axial-depths-in-mm-scale-help = Von der Seite, axiale Schnitttiefen in mm, { $scale }. { $help }
a-floor-or-an-end = ein Boden oder ein Ende
cut-from-the-side-depths = Schnitt von der Seite: { $depths }
a-wall = eine Wand
from-above-radial-depths-in-mm-help = Von oben, Schnittbreiten (radial) in mm. { $help }
cut-from-above-depths = Schnitt von oben: { $depths }

## src/app/panels/console/workpiece/table.rs

no-2 = Nr.
duplicate-section-number = Abschnitt { $number } verdoppeln
remove-section-number = Abschnitt { $number } entfernen
length-mm-2 = Länge mm
axial-mm = Axial mm
wall-mm = Wand mm
r-d-mm = R_D mm
length-of-section-number = Länge von Abschnitt { $number }
axial-depth-of-section-number = Axiale Schnitttiefe von Abschnitt { $number }
wall-of-section-number = Wand von Abschnitt { $number }
add-a-section = Neuer Abschnitt
at-most-n-sections-in-a-cut =
    { $n ->
        [one] Höchstens { $n } Abschnitt je Schnitt
       *[other] Höchstens { $n } Abschnitte je Schnitt
    }
wall-place-of-the-side-wall-across-the-cut-f = Wand: Lage der Seitenwand quer zum Schnitt, von der Werkzeugachse aus. R_D: von der Wand bis dorthin, wo der Fräser bei dieser Tiefe auf die Oberfläche trifft.
air = Luft
the-tool-meets-no-material-here = Das Werkzeug trifft hier auf keinen Werkstoff
stretch-number-why = Bereich { $number }: { $why }.
it-is-cut-and-its-depth-stays-a-change-of-it = er ist gefräst, und seine Tiefe bleibt; eine Änderung würde wirken, wo das Werkzeug jetzt ist
n-stretches-each-with-its-axial-and-its-radi = { $n } Abschnitte, jeder mit seiner axialen Schnitttiefe und Schnittbreite
one-axial-and-one-radial-depth-along-the-who = Eine axiale Schnitttiefe und eine Schnittbreite entlang der ganzen Bahn, die ihres Anfangs
take-the-profiles-away = Profile entfernen
from-mm = Ab mm
axial-depth-of-stretch-number = Axiale Schnitttiefe von Bereich { $number }
start-of-stretch-number = Anfang von Bereich { $number }
remove-stretch-number = Bereich { $number } entfernen
add-a-stretch = Neuer Bereich

## src/app/panels/console/workpiece.rs

experiment-1 = Experiment 1
the-part-from-the-side-drag-its-depths-and-i = Das Teil von der Seite: seine Tiefen und Enden ziehen oder in eine Tabelle eintippen
cut-number-tool = Schnitt { $number }, Werkzeug
cut-number = Schnitt { $number }
at-most-n-cuts =
    { $n ->
        [one] Höchstens { $n } Schnitt
       *[other] Höchstens { $n } Schnitte
    }
add-a-cut = Neuer Schnitt
duplicate-cut-number = Schnitt { $number } verdoppeln
remove-cut-number = Schnitt { $number } entfernen
the-last-cut-stays-one-path-goes-without-cut-2 = Der letzte Schnitt bleibt: „Eine Bahn“ geht ohne Schnitte
these-depths-are-profiles-of-a-file-take-the = Diese Tiefen sind Profile einer Datei: entfernen Sie sie, um eine Tiefe zu ziehen.
back-to-the-start = Zurück zum Anfang
what-is-grey-is-cut-already-at-the-start-of = Was grau ist, ist schon geschnitten: am Anfang des Schnitts lässt sich jeder Abschnitt ändern
the-tool-is-at-at-changed-depths-act-from-th = Das Werkzeug steht bei { $at }: Geänderte Tiefen wirken ab dort und ab jetzt. Ein Bereich, der davor beginnt, gilt nur für das, was von ihm noch zu fräsen ist; Gefrästes bleibt.
the-cut-is-over-changed-depths-are-those-of = Der Schnitt ist zu Ende: Geänderte Tiefen gelten für das ganze Teil, das von Anfang an neu gefräst wird.
still-to-be-cut = noch zu fräsen
cut-already = schon gefräst
the-tool-comes-in-from-the-air = das Werkzeug kommt aus der Luft
tool-at-place = Werkzeug bei { $place }
length-long-place = { $length } lang, { $place }
take-the-part-of = Das Teil übernehmen von
takes-over-the-cuts-alone-the-scenario-of-th = Übernimmt nur die Schnitte; das Szenario dieses Namens setzt auch Regler, Rauschen und Vorschub
one-straight-cut-with-this-path-s-depths-the = Ein gerader Schnitt mit den Tiefen dieser Bahn, das Werkzeug kommt aus der Luft
make-cuts-of-the-path = Schnitte aus der Bahn machen
no-cuts-the-path-with-its-length-depths-and = Keine Schnitte: die Bahn mit ihrer Länge, ihren Tiefen und ihrem Tiefenprofil
one-path = Eine Bahn

## src/app/playback.rs

as-fast-as-possible = so schnell wie möglich

## src/app/search.rs

screen = Ansicht
search-formulas-in-a-table-of-one-s-own = Formeln in einer eigenen Tabelle suchen
open-a-part-of-one-s-own-table-or-g-code = Ein eigenes Werkstück öffnen: Tabelle oder G-Code
lay-measured-data-over-the-plots = Messdaten über die Diagramme legen
my-files-cutters-materials-machines-parts-an = Eigene Dateien: Fräser, Werkstoffe, Maschinen, Werkstücke und mehr
fit-settings-to-measured-data = Einstellungen an Messdaten anpassen
open-measured-data-to-fit-settings-to = Messdaten öffnen, an die Einstellungen angepasst werden
go-on-with-a-saved-search-for-a-formula = Eine gespeicherte Formelsuche fortsetzen
open-networks-of-unks = Netze von UNKS öffnen
save-the-networks-of-unks = Netze von UNKS speichern
light-colours = Helle Farben
dark-colours = Dunkle Farben
colours-as-the-system-has-them = Farben wie im System
large-type-for-a-projector = Große Schrift, für einen Projektor
type-of-the-usual-size = Schrift in üblicher Größe
less-motion = Weniger Bewegung
motion-as-usual = Bewegung wie üblich
identify-own-recording-measurements-drive-de = identifizieren eigene Aufzeichnung Messungen Antrieb Totzeit Verzögerung Sprung Kraft Koeffizienten Kienzle Rundlauf Struktur Moden Klopftest Frequenzgang Rauschen Welligkeit Verschleiß Taylor Werkstoff Härte
load-toml-data-own = laden toml daten eigene
download-keep-toml = herunterladen behalten toml
save-table-data-results-measurements-downloa = speichern tabelle daten ergebnisse messungen herunterladen tabellenkalkulation
qr-code-class-phone-digest-share-address-url = qr code klasse telefon prüfsumme teilen adresse url befehlszeile terminal headless wiederholen reproduzieren senden
identify-own-data-measured-measurements-csv = identifikation eigene daten gemessen messungen csv hochladen importieren
workpiece-cam-nc-gcode-program-csv-depths-im = werkstück cam nc gcode programm csv tiefen import eigen rohteil
own-data-measurements-csv-matlab-mat-tdms-la = eigene daten messungen csv matlab mat tdms labview parquet hdf5 dynamometer kanal überlagern vergleichen import
identify-resume-json = identifikation fortsetzen json
neural-learning-weights-json = neuronal lernen gewichte json
help-about-introduction-keyboard-shortcuts-h = hilfe über einführung tastatur tastenkürzel tippen wischen spreizen finger
theme-contrast-mode = thema kontrast modus
zoom-big-font-size-beamer-class-letters = zoom groß schriftgröße beamer klasse buchstaben
language-sprache-jezik-slovene-slovenian-ger = sprache language jezik slovene slovenian german deutsch en sl de
animation-reduced-accessibility-still = animation reduziert barrierefreiheit ruhig
back-retry-repeat-breakage-scrap-stop-crash = zurück noch einmal wiederholen bruch ausschuss stopp kollision gebrochen missgeschick
playback-transport = abspielen transport wiedergabe
restart-repeat-from-the-start-rerun-begin-an = neustart wiederholen von anfang an neu beginnen einstellungen behalten
disturb-disturbance-fault-trouble-error-hurt = stören störung fehler panne unfall schaden
operator-override-manual-hand-knob-panel-han = bediener override von hand manuell knopf bedienfeld handrad rad selbst fahren wertung schlagen
library-folder-tool-material-machine-structu = bibliothek ordner werkzeug fräser werkstoff maschine struktur werkstück skript eigene behalten katalog
setting-scenario-screen-command-or-word = Einstellung, Szenario, Ansicht, Befehl oder Wort
type-a-word-dead-time-kp-chatter-noise-csv = Ein Wort eintippen: Totzeit, Kp, Rattern, Rauschen, CSV …
nothing-has-these-words-fewer-or-shorter-one = Kein Treffer. Weniger oder kürzere Wörter finden mehr.
more-more-another-word-narrows-them-down = { $more } weitere: Ein weiteres Wort grenzt sie ein.
in-group-path = in { $group }: { $path }
scenario-2 = Szenario
command = Befehl
control-by-controller = Mit { $controller } regeln

## src/app/session/change.rs

locked-by-the-address-that-this-was-opened-w = gesperrt durch die Adresse, mit der dies geöffnet wurde
no-other-scenario-is-opened-here-settings-ar = Kein anderes Szenario wird hier geöffnet: Einstellungen sind durch die Adresse gesperrt, mit der dies geöffnet wurde.
predict-first-the-cut-begins-as-soon-as-you = Zuerst vorhersagen: Der Schnitt beginnt, sobald Sie gesagt haben, was Sie erwarten, oder ohne Vorhersage weitergegangen sind.
name-is-open-it-is-cut-from-its-start = { $name } ist offen: Es wird von Anfang an gefräst.
name-controls-this-cut-now = { $name } regelt jetzt diesen Schnitt.
set-for-the-whole-cut-now-first-second-third = { " " }Jetzt für den ganzen Schnitt gesetzt: { $first }, { $second }, { $third }, { $more } weitere.
set-for-the-whole-cut-now-list = { " " }Jetzt für den ganzen Schnitt gesetzt: { $list }.
the-change-made-during-the-cut-is-not-repeat = Die Änderung während des Schnitts wird nicht wiederholt; Rückgängig bringt sie zurück.
the-n-changes-made-during-the-cut-are-not-re =
    { $n ->
        [one] Die { $n } Änderung während des Schnitts wird nicht wiederholt; Rückgängig bringt sie zurück.
       *[other] Die { $n } Änderungen während des Schnitts werden nicht wiederholt; Rückgängig bringt sie zurück.
    }
cut-from-its-start-names-of-edits = Von Anfang an gefräst.{ $names } { $of_edits }
setting-cannot-be-changed-it-is-why = „{ $setting }“ lässt sich nicht ändern: { $why }.
the-mission-title-is-open-it-locks-all-setti = Die Mission „{ $title }“ ist offen: Sie sperrt alle Einstellungen, auch „{ $setting }“. Zum Ändern die Mission verlassen.
the-mission-title-is-open-and-locks-setting = Die Mission „{ $title }“ ist offen und sperrt „{ $setting }“. Ändern lässt sich: { $open }. Für alles andere die Mission verlassen.
the-mission-title-is-left = Die Mission „{ $title }“ ist verlassen.
the-mission-title-is-open-of-setting-it-offe = Die Mission „{ $title }“ ist offen. Für „{ $setting }“ bietet sie: { $list }. Für eine andere Wahl die Mission verlassen.
the-cut-is-over-setting-is-set-for-the-whole = Der Schnitt ist zu Ende: „{ $setting }“ gilt für das ganze Werkstück, das von Anfang an neu gefräst wird. „Rückgängig“ bringt den vorigen Schnitt zurück; eine Änderung während des Schnitts wirkt von dort an.
name-is-the-part-now-length-mm-long-air-mm-o = { $name } ist jetzt das Werkstück: { $length } mm lang, davon { $air } mm Luft.
title-is-taken-as-the-kind-of-this-cut = { $title } gilt für diesen Schnitt ({ $kind })

## src/app/session/disturb.rs

no-kind-at-place-the-cut-goes-from-0-to-end-2 = { $kind } bei { $place } nicht möglich: Der Schnitt geht von 0 bis { $end }. Zuerst in der Zeit zurückgehen oder auf das Werkstück setzen.
what-undo-takes-it-back = { $what }. „Rückgängig“ nimmt es zurück.
what-behind-the-tool-the-cut-is-done-again-u = { $what }, hinter dem Werkzeug: Der Schnitt wird neu gerechnet. „Rückgängig“ nimmt es zurück.
kind-at-place = { $kind } bei { $place }
kind-at-place-size = { $kind } bei { $place }: { $size }
kind-at-place-over-length = { $kind } bei { $place }: über { $length }
kind-at-place-size-over-length = { $kind } bei { $place }: { $size } über { $length }

## src/app/session/foreign.rs

what-was-opened-brings-a-controller-s-script = Das Geöffnete bringt ein eigenes Skript eines Reglers mit, { $n } Bytes: Es läuft nicht, bevor Abspielen gedrückt wird. Zu lesen ist es unter Skript.

## src/app/session/hand/drive.rs

there-is-no-way-of-control-id = Es gibt keine Art der Regelung `{ $id }`.
wanted-is-refused-the-override-cnc-override = { $wanted } % abgelehnt: Der Override (cnc.override_min_percent) endet bei { $end } %.
wanted-is-refused-the-override-cnc-override-2 = { $wanted } % abgelehnt: Der Override (cnc.override_max_percent) endet bei { $end } %.
wanted-is-refused-the-scale-of-the-panel-end = { $wanted } % abgelehnt: Die Skala des Bedienfelds endet bei { $end } %.
the-cut-is-over-cut-by-hand-begins-it-again-2 = Der Schnitt ist zu Ende: „Von Hand fräsen“ beginnt ihn neu.
you-have-the-feed-undo-gives-it-back-to-befo = Sie führen den Vorschub. „Rückgängig“ gibt ihn an { $before } zurück.
no-controller-had-the-feed-in-this-cut = Kein Regler führte in diesem Schnitt den Vorschub.

## src/app/session/hand.rs

t-0-to-120-as-on-a-panel = 0 bis 120 %, wie am Bedienfeld
to-120-as-on-a-machine-s-panel = Bis 120 %, wie am Bedienfeld einer Maschine.
as-far-as-controllers-may = so weit wie Regler dürfen
as-far-as-the-override-of-the-cnc-goes-which = So weit der Override der CNC reicht, den Regler benutzen dürfen.

## src/app/session/mishap.rs

nothing-has-gone-wrong-so-far-no-tooth-broke = Bisher ging nichts schief: Kein Zahn brach, nichts hielt den Vorschub an, keine Oberfläche ist Ausschuss.

## src/app/session/safe.rs

constant-feed-2 = konstanter Vorschub
const = konst.
feeds-mm-min-at-speed-1-min = { $feeds } mm/min bei { $speed } 1/min
safe-feed-from-start-at = sicherer Vorschub ab Beginn: { $at }
safe-constant-feed-at = sicherer konstanter Vorschub: { $at }
safe-constant-feed-finding = sicherer konstanter Vorschub: wird gesucht …
constant-feed-as-programmed-at = konstanter Vorschub wie programmiert: { $at }
none-is-safe-constant-feed-as-programmed-at = keiner ist sicher; konstanter Vorschub wie programmiert: { $at }
name-finding = { $name }: Suche läuft …
name-none-is-safe-at = { $name }, keiner ist sicher: { $at }
the-cut-is-compared-with-constant-feed-as-pr = Verglichen wird jetzt mit dem konstanten Vorschub wie programmiert: { $why }.
the-cut-is-compared-with-a-safe-constant-fee = Verglichen wird wieder mit einem sicheren konstanten Vorschub.

## src/app/session.rs

left-out-first = Ausgelassen: { $first }
left-out-and-more-more-first = Ausgelassen (und { $more } weitere): { $first }
the-change-that-came-later-in-the-cut-is-gon = Die Änderung weiter hinten im Schnitt entfällt: Ab hier wird neu gefräst. Rückgängig bringt sie zurück.
the-change-of-the-same-setting-during-the-cu = Die Änderung derselben Einstellung während des Schnitts entfällt: Der neue Wert gilt für den ganzen Schnitt. Rückgängig bringt sie zurück.
n-changes-that-came-later-in-the-cut-are-gon = { $n } Änderungen weiter hinten im Schnitt entfallen: Ab hier wird neu gefräst. Rückgängig bringt sie zurück.
n-changes-of-the-same-settings-during-the-cu = { $n } Änderungen derselben Einstellungen während des Schnitts entfallen: Die neuen Werte gelten für den ganzen Schnitt. Rückgängig bringt sie zurück.

## src/app/shortcuts/named.rs

ctrl-key = Strg
shift-key = Umschalt
left-key = Links
right-key = Rechts
up-key = Auf
down-key = Ab
space-key = Leertaste
home-key = Pos1
end-key = Ende
pageup-key = Bild auf
pagedown-key = Bild ab
backspace-key = Rücktaste

## src/app/shortcuts/sheet.rs

this-sheet = Diese Übersicht
close-what-lies-on-top = Schließen, was zuoberst liegt
tab-enter = Tab, Enter
the-next-control-press-it-or-end-a-number = Das nächste Bedienelement; es drücken oder eine Zahl abschließen
arrow-keys = Pfeiltasten
move-the-slider-or-turn-the-knob-that-has-th = Den Schieber oder Knopf mit dem Fokus verstellen
wheel-or-a-drag-around = Mausrad oder im Kreis ziehen
turn-the-operator-s-knob-under-the-pointer = Den Knopf des Bedieners unter dem Zeiger drehen
double-click-on-a-plot = Doppelklick im Diagramm
drag-on-a-plot = Ziehen im Diagramm
zoom = Zoomen
right-click-on-a-setting = Rechtsklick auf eine Einstellung
back-to-its-default = Zurück zur Vorgabe
swipe = Wischen
scroll-wherever-it-begins = Blättern, gleich wo es beginnt
drag-across = Waagerecht ziehen
move-a-slider-or-a-number = Einen Schieber oder eine Zahl verstellen
drag-around = Im Kreis ziehen
turn-the-operator-s-knob = Den Knopf des Bedieners drehen
pinch-a-plot = Diagramm spreizen
double-tap-a-plot = Diagramm zweimal antippen
long-press = Lange drücken
what-it-means-the-menu-of-a-setting = Was es bedeutet; das Menü einer Einstellung
the-first-screens-the-others-by-their-tabs = Die ersten Ansichten; die anderen über ihre Reiter
the-screens = Die Ansichten
version-number = Version { $number }
windows-and-lists-come-without-gliding-the-m = Fenster und Listen erscheinen ohne Gleiten; die Massen der Maschine stehen, bis sie in Bewegung gesetzt werden. Der Schnitt läuft weiter: Die Leertaste hält ihn an.
fingers = Finger
keys = Tasten
esc-then-tab = Esc, dann Tab
out-of-the-console-to-the-browser = Aus der Konsole hinaus zum Browser
the-browser-s-own-the-page-before = Vom Browser selbst: die vorige Seite

## src/app/shortcuts.rs

drop-a-hard-spot-into-the-cut = Eine harte Stelle in den Schnitt setzen
drop-a-gap-into-the-cut = Eine Lücke in den Schnitt setzen
drop-a-depth-step-into-the-cut = Einen Tiefensprung in den Schnitt setzen
let-the-wear-jump = Den Verschleiß springen lassen
break-a-tooth = Einen Zahn brechen
drop-a-burst-of-chatter-into-the-cut = Einen Ratterstoß in den Schnitt setzen
let-the-sensor-drop-out = Den Sensor ausfallen lassen
let-the-sensor-drift = Den Sensor driften lassen
make-the-dead-time-longer-for-a-while = Die Totzeit eine Weile verlängern
turn-the-override-by-hand-for-a-while = Den Override eine Weile von Hand drehen
drive-the-cut-by-hand-the-operator-s-knob-on = Von Hand fahren: den Knopf des Bedieners ein- oder ausschalten
turn-the-operator-s-knob-up = Den Knopf des Bedieners höher drehen
turn-the-operator-s-knob-down = Den Knopf des Bedieners tiefer drehen
turn-the-operator-s-knob-far-up = Den Knopf des Bedieners viel höher drehen
turn-the-operator-s-knob-far-down = Den Knopf des Bedieners viel tiefer drehen
back-to-before-it-went-wrong = Zurück, bevor es schiefging
apply-from-the-start = Von Anfang an anwenden
play-or-pause-after-the-end-again = Abspielen oder anhalten; nach dem Ende: noch einmal
one-control-sample-on = Eine Abtastung vor
one-control-sample-back = Eine Abtastung zurück
t-1-s-on = 1 s vor
t-1-s-back = 1 s zurück
t-0-1-s-on = 0,1 s vor
t-0-1-s-back = 0,1 s zurück
to-the-start = Zum Anfang
find-a-setting-scenario-screen-command-or-wo = Einstellung, Szenario, Ansicht, Befehl oder Wort suchen
open-a-scenario-file = Eine Szenariodatei öffnen
export-all-signals-as-csv = Alle Signale als CSV exportieren
copy-a-link-to-this-state = Einen Link zu diesem Zustand kopieren

## src/app/speaker/native.rs

this-computer-has-no-sound-output = dieser Computer hat keine Tonausgabe
the-sound-output-cannot-be-used-error = die Tonausgabe lässt sich nicht benutzen: { $error }
the-sound-output-takes-only-kind-samples = die Tonausgabe nimmt nur Abtastwerte vom Typ { $kind }
the-sound-output-has-failed-error = die Tonausgabe ist ausgefallen: { $error }

## src/app/speaker/page.rs

the-browser-gives-no-sound-output-said = der Browser gibt keine Tonausgabe { $said }

## src/app/speaker/piped.rs

no-player-was-found-pacat-pulseaudio-pw-cat = kein Abspielprogramm gefunden: pacat (PulseAudio), pw-cat (PipeWire) oder aplay (ALSA; Debian: apt install alsa-utils)
the-sound-system-s-player-has-ended-is-there = das Abspielprogramm des Tonsystems hat sich beendet: Gibt es eine Tonausgabe?

## src/app/timeline.rs

again-from-the-start = Noch einmal von Anfang an
again-from-the-start-with-the-change-at-its = Noch einmal von Anfang an, mit der Änderung zu ihrer Zeit
again-from-the-start-with-n-changes-at-their =
    { $n ->
        [one] Noch einmal von Anfang an, mit { $n } Änderung zu ihrer Zeit
       *[other] Noch einmal von Anfang an, mit { $n } Änderungen zu ihren Zeiten
    }
restart = Neustart
pause = Pause
pause-space = Pause (Leertaste)
play = Abspielen
play-space = Abspielen (Leertaste)
one-control-sample-on-keys = Eine Abtastung vor{ $keys }
to-the-end-of-the-cut-end = Zum Ende des Schnitts (Ende)
end = Ende
plots-show-the-last-seconds-before-the-playh = Diagramme zeigen die letzten Sekunden vor der Abspielmarke und am Ende den ganzen Lauf; sonst immer den ganzen Lauf.
follow = Folgen
target-not-held-share-in-tolerance = , Sollwert nicht gehalten: { $share } in Toleranz
play-again = Noch einmal
from-the-start-with-the-settings-at-the-play = Von Anfang an, mit den Einstellungen an der Abspielmarke als denen des Szenarios{ $keys }. Neustart wiederholt die Änderungen des Schnitts zu ihren Zeiten; dies nicht.
nothing-was-changed-during-the-cut-restart-d = Während des Schnitts wurde nichts geändert: Neustart tut dasselbe
back-to-2-s-before-the-last-broken-tooth-sto = Zurück auf 2 s vor dem letzten Zahnbruch, Stopp oder Ausschuss{ $keys }; die nächste Änderung zweigt dort ab
max = max
speed-speed = Tempo { $speed }
speed-of-the-playhead = Tempo der Abspielmarke
space-does-the-same = Die Leertaste tut dasselbe
computing-percent = wird berechnet, { $percent } %
held-2 = gehalten
not-held-2 = nicht gehalten
share-in-tolerance = , { $share } in Toleranz
target-held-share-in-tolerance = , Sollwert gehalten: { $share } in Toleranz
reference-held-share-in-tolerance = , Referenz gehalten: { $share } in Toleranz
reference-not-held-share-in-tolerance = , Referenz nicht gehalten: { $share } in Toleranz
target-held-share-in-tolerance-with-dynamics = , Sollwert gehalten: { $share } in Toleranz mit Dynamik
target-not-held-share-in-tolerance-with-dyna = , Sollwert nicht gehalten: { $share } in Toleranz mit Dynamik
reference-held-share-in-tolerance-with-dynam = , Referenz gehalten: { $share } in Toleranz mit Dynamik
reference-not-held-share-in-tolerance-with-d = , Referenz nicht gehalten: { $share } in Toleranz mit Dynamik
share-not-judged = , { $share } nicht beurteilt
unstable-3 = , instabil
chattered-2 = , ratterte
unstable-chattered = , instabil, ratterte
playhead-2 = Abspielmarke
the-whole-run-drag-to-look-back = Der ganze Lauf: ziehen, um zurückzusehen
the-whole-run-drag-to-look-back-the-mark-is = Der ganze Lauf: ziehen, um zurückzusehen. Die Marke ist eine Änderung während des Schnitts
the-whole-run-drag-to-look-back-the-marks-ar =
    { $n ->
        [one] Der ganze Lauf: ziehen, um zurückzusehen. Die Marke ist { $n } Änderung
       *[other] Der ganze Lauf: ziehen, um zurückzusehen. Die Marken sind { $n } Änderungen
    }
help-percent-is-computed-the-line-below = { $help }. { $percent } % sind berechnet: die Linie darunter

## src/app/widgets/chart/content.rs

it-is-drawn-at-the-same-place-of-the-part-it = Es ist an denselben Orten des Teils gezeichnet: Sprünge und Änderungen liegen, wo die des Schnitts liegen. Es fährt mit anderem Vorschub, hat also andere Zeit bis dorthin gebraucht. Welcher konstante Vorschub es ist, steht in Mehr Einstellungen, unter dem, womit verglichen wird.
the-same-part-cut-at-the-programmed-feed-wit-3 = Dasselbe Teil, mit dem programmierten Vorschub gefräst, ohne Regler: was die Artikel herkömmlich nennen und was der Regler Herkömmlich (konstanter Vorschub) bei 100 % fräst.
the-same-part-cut-without-a-controller-at-th-2 = Dasselbe Teil, ohne Regler gefräst, mit dem größten konstanten Vorschub, der nirgends über der Toleranz liegt: Wer sie überall halten muss, wählt den Vorschub nach der tiefsten, härtesten Stelle. Gefunden, indem das Teil mit vielen Vorschüben gefräst wurde. Der Regler Herkömmlich (konstanter Vorschub) fräst stattdessen mit dem programmierten, wie das herkömmliche Fräsen der Artikel.
the-largest-constant-feed-that-is-nowhere-ab = Der größte konstante Vorschub, der nirgends über der Toleranz liegt, wird gesucht: Das Teil wird mit vielen Vorschüben gefräst.
the-same-part-cut-at-the-programmed-feed-wit-2 = Dasselbe Teil, mit dem programmierten Vorschub gefräst, ohne Regler: { $why }.
ra-and-force-are-drawn-without-dynamics = Ra und Kraft sind ohne Dynamik gezeichnet.
before = vorher
the-run-as-it-went-on-before-the-last-change = Der Lauf, wie er vor der letzten Änderung weiterging.
its-thin-line-is-that-with-dynamics-of-ra-an = Die dünne Linie ist die mit Dynamik, von Ra und von der Kraft.
your-hand = Ihre Hand
the-same-part-as-you-cut-it-last-by-hand-dra = Dasselbe Teil, wie Sie es zuletzt von Hand gefräst haben, an denselben Orten des Teils gezeichnet.
from-now-on = ab jetzt
what-the-run-does-after-the-last-change-ahea = Was der Lauf nach der letzten Änderung tut, vor der Abspielmarke.

## src/app/widgets/chart/reading.rs

signal-at-the-playhead-value = { $signal } an der Abspielmarke: { $value }

## src/app/widgets/chart.rs

chart-from-from-to-to = { $chart } von { $from } bis { $to }
all-plots = alle Diagramme

## src/app/widgets/drop.rs

drop-disturbance = Setzen: { $disturbance }

## src/app/widgets/knob.rs

feed-override-by-hand = Vorschub-Override von Hand
turn-it-by-a-drag-around-it-by-the-wheel-or = Drehen durch Ziehen im Kreis, mit dem Mausrad oder dem Finger; + und -, Bild auf und Bild ab drehen ihn von überall

## src/app/widgets/legend.rs

lines-of-title = Linien von { $title }
show-this-line = Diese Linie zeigen
hide-this-line = Diese Linie ausblenden

## src/app/widgets/my_files.rs

cutters-materials-machines-structures-parts = Eigene Fräser, Werkstoffe, Maschinen, Strukturen, Werkstücke, Skripte und mehr: verwenden, behalten, beginnen
my-files-2 = Eigene Dateien…

## src/app/widgets/number.rs

allowed-is-a-number-from-min-to-max-unit = zulässig ist eine Zahl von { $min } bis { $max } { $unit }
name-text-is-not-a-number-allowed-2 = { $name }: „{ $text }“ ist keine Zahl: { $allowed }
name-text-was-limited-to-taken-allowed-2 = { $name }: „{ $text }“ wurde auf { $taken } begrenzt: { $allowed }

## src/app/widgets/save_table.rs

afc-log = AFC-Protokoll
changed-conditions = geänderte Bedingungen
comparison = Vergleich
front = Front
load-step = Lastsprung
passes = Durchgänge
plan-2 = Plan
table-paper = Tabelle { $paper }
claim-paper = Behauptung { $paper }
deviations-paper = Abweichungen { $paper }
calibrations-paper-2 = Kalibrierungen { $paper }
save-table-as-csv = Als CSV speichern: { $table }
there-is-no-row-yet = Noch keine Zeile vorhanden
name-not-whole-yet-done = { $name }, noch nicht vollständig: { $done }
the-table-is-not-whole-yet-done-the-name-of = Die Tabelle ist noch nicht vollständig: { $done }. Der Name der Datei und ihre Spalte „Partial“ sagen es.

## src/app/widgets/setting/formula.rs

typed-in-the-console = in der Konsole eingetippt
range-of-input-text-is-not-a-number = Bereich von { $input }: `{ $text }` ist keine Zahl
range-of-input-low-is-not-below-high = Bereich von { $input }: { $low } ist nicht kleiner als { $high }
change = Ändern
type = Eintippen
write-the-formula-and-the-ranges-of-its-inpu = Die Formel und die Bereiche ihrer Eingänge schreiben
a-file-of-a-formula-s-model-as-steadycut-for = Eine Datei mit dem Modell einer Formel, wie `steadycut formula --save` sie schreibt
the-built-in-model-again = Wieder das eingebaute Modell
a-number = eine Zahl
input-low-to-high-unit = { $input } { $low } bis { $high } { $unit }
unit-of-meaning = { $unit } aus { $meaning }
formula-setting = Formel: { $setting }
from = von
to = bis
gives-low-to-high-unit-there = ergibt dort { $low } bis { $high } { $unit }
use = Verwenden
from-now-on-in-the-running-cut-too = Ab jetzt, auch im laufenden Schnitt
cancel = Abbrechen
as-it-was-before = Wie vorher

## src/app/widgets/setting/script.rs

begin-from = Beginnen mit
it-can-be-read-it-runs-once-it-is-used = Es ist lesbar; es läuft, sobald es verwendet wird.
it-runs-at-most-n-steps-in-a-control-period = Es läuft: höchstens { $n } Schritte in einer Regelperiode.
use-this-script = Dieses Skript verwenden
in-the-running-cut-from-here-on-with-a-state = Im laufenden Schnitt ab hier, mit eigenem Zustand
discard = Verwerfen

## src/app/widgets/setting/structured.rs

begin-with-those-of-the-start-again = Wieder mit denen des Starts beginnen
remove-setting = Entfernen: { $setting }
column-of-row-number = { $column }: { $row } { $number }
remove-row-number = Entfernen: { $row } { $number }
add-a-row = Hinzufügen: { $row }
the-same-for-every-each = gleich für alle: { $each }
remove-setting-of-each-number = { $setting } entfernen: { $each } { $number }
add-one-for-each-number = Einen hinzufügen: { $each } { $number }
t-1-cut = 1 Schnitt
n-cuts =
    { $n ->
        [one] { $n } Schnitt
       *[other] { $n } Schnitte
    }

## src/app/widgets/setting.rs

reset-to-default-unit = Zurücksetzen auf { $default } { $unit }
locked = Gesperrt
not-used-now-because = Jetzt nicht verwendet: { $because }.
allowed-allowed = Zulässig: { $allowed }.
acts-at-once-also-during-the-cut = wirkt sofort, auch während des Schnitts
belongs-to-the-set-up = gehört zur Einrichtung

## src/app/widgets/standing.rs

the-best = am besten
to-be-looked-at = zu beachten
not-as-it-should-be = nicht, wie es sein soll

## src/app/widgets/target.rs

iso-1302-grade-grade-ra-ra-um-m = Rauheitsklasse { $grade } nach ISO 1302: Ra { $ra_um } µm

## src/app/widgets/window.rs

close-window = Fenster schließen

## src/disk/own_folder.rs

folder-the-path-is-no-plain-text = { $folder }: Der Pfad ist kein einfacher Text
folder-allowed-is-a-path-from-the-root-on-as = { $folder }: erlaubt ist ein Pfad von der Wurzel an, wie { $root }…
folder-there-is-no-such-folder = { $folder }: Diesen Ordner gibt es nicht
the-choice-of-the-folder-is-not-kept-why = die Wahl des Ordners wurde nicht behalten: { $why }
folder-it-is-no-folder = { $folder }: Das ist kein Ordner
there-are-more-than-n-entries-in-this-folder = In diesem Ordner sind mehr als { $n } Einträge: Die anderen werden nicht angesehen.
its-name-is-no-text = ihr Name ist kein Text
name-is-a-link-to-a-folder-which-is-not-foll = { $name } ist eine Verknüpfung zu einem Ordner; ihr wird nicht gefolgt.
name-lies-more-than-n-folders-deep-and-is-no = { $name } liegt tiefer als { $n } Ordner und wird nicht angesehen.
there-are-n-files-in-this-folder-the-first-m = In diesem Ordner sind { $n } Dateien: Die ersten { $most } nach Namen sind aufgeführt.
it-is-a-pipe-or-a-device-no-file = es ist eine Pipe oder ein Gerät, keine Datei
each-channel-with-times-of-its-own = jeder Kanal mit eigenen Zeiten
as-they-come = wie sie in der Datei stehen
