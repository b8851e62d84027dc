# Slovenščina

## src/app/about.rs

steadycut-simulates-milling-whose-controller = SteadyCut simulira frezanje, pri katerem regulator s podajanjem in vrtilno hitrostjo drži hrapavost Ra ali silo.

## src/app/bar.rs

mission-title = Naloga: { $title }
mission-title-is-open-what-it-does-not-let-y = Naloga »{ $title }« je odprta: česar ne dovoli spreminjati, je zaklenjeno
the-cut-stays-as-it-is-and-all-of-it-can-be = Rez ostane, kot je, in vse na njem je spet mogoče spreminjati
leave = Zapusti
leave-the-mission = Zapusti nalogo
task-hints-and-answer-of-the-mission-on-the = Besedilo, namigi in odgovor naloge: na zaslonu Vadnica
back-to-the-mission = Nazaj k nalogi
screen-2 = Zaslon
screens-keys = Zasloni ({ $keys }, …)
files-undo-colours-keys-search = Datoteke, razveljavitev, barve, tipke, iskanje
menu = Meni
find-a-setting-scenario-screen-command-or-wo-2 = Najdi nastavitev, scenarij, zaslon, ukaz ali besedo{ $keys }
find = Najdi
what-this-is-keys-and-gestures = Kaj je to; tipke in kretnje (?)
keys-and-gestures = Tipke in kretnje
language = Jezik
light-colours-right-click-as-the-system-has = Svetle barve; desni klik: kot v sistemu
light = Svetlo
dark-colours-right-click-as-the-system-has-i = Temne barve; desni klik: kot v sistemu
dark = Temno
open = Odpri
open-a-scenario-file-one-can-also-be-dropped = Odpri datoteko scenarija; lahko jo tudi spustite sem
save = Shrani
save-the-scenario-with-its-edits = Shrani scenarij s spremembami
save-csv = Shrani CSV
export-all-signals-of-the-run-as-csv = Izvozi vse signale simulacije kot CSV
link-2 = Povezava
copy-a-link-that-holds-scenario-and-edits-an = Kopiraj povezavo s scenarijem in spremembami ter jo pokaži s kodo QR, ukazno vrstico, ki ponovi simulacijo, in digestom
undo = Razveljavi
take-the-last-change-back = Vzemi zadnjo spremembo nazaj
redo = Uveljavi
do-it-again = Uveljavi jo spet

## src/app/execute.rs

name-is-deleted = { $name } je izbrisano.
the-signals-are-those-up-to-until-the-cut-is = Signali so tisti do { $until }: rez se še računa. Tako pove tudi ime datoteke.
the-chosen-controller-has-no-networks-that-l = Izbrani regulator nima mrež, ki se učijo.

## src/app/files/fallback.rs

no-file-dialog-is-available-drag-a-scenario = Pogovorno okno za datoteke ni na voljo: povlecite datoteko scenarija na okno ali zaženite s `steadycut --scenario FILE`.

## src/app/files.rs

the-layout-is-remembered-for-files-like-it-b = Ureditev je zapomnjena za podobne datoteke, ne pa ob tej: { $why }
steadycut-scenario = Scenarij SteadyCut
unks-networks = Mreže UNKS
table = Tabela
part-table-or-g-code = Obdelovanec: tabela ali koda G
measured-data = Izmerjeni podatki
saved-search = Shranjeno iskanje
model-of-a-formula = Model formule
kept-place = Shranjeno: { $place }
name-is-kept-in-this-browser = { $name } je shranjeno v tem brskalniku.
name-is-not-kept-why = { $name } ni shranjeno: { $why }
no-file-dialog-is-available-type-the-path-of = Pogovorno okno za datoteke ni na voljo: vtipkajte pot do mape.
folder-a-page-has-no-folders = { $folder }: stran nima map
my-files = Moje datoteke
saved-as-name = shranjeno kot { $name }
not-saved-error = ni shranjeno: { $error }
no-file-dialog-is-available-and-name-could-n = Pogovorno okno za datoteke ni na voljo, { $name } pa ni bilo mogoče zapisati: { $error }
no-file-dialog-is-available-saved-as-path = Pogovorno okno za datoteke ni na voljo: shranjeno kot { $path }
saved-as-name-in-the-browser-s-downloads = shranjeno kot { $name } med prenosi brskalnika
the-browser-did-not-take-name-for-download = brskalnik ni sprejel { $name } za prenos
name-could-not-be-read-error = { $name } ni bilo mogoče prebrati: { $error }
name-is-the-result-of-a-mission-steadycut-mi = { $name } je rezultat naloge: preveri ga steadycut mission check { $name }.
name-is-a-file-of-a-spreadsheet-save-it-ther = { $name } je datoteka preglednice: tam jo shranite kot CSV, ki ga je tu mogoče odpreti in spustiti.

## src/app/format.rs

no-contact = brez stika
outside-model = zunaj modela
with-before-it-a-value-lies-outside-the-rang = Vrednost z znakom ≈ je zunaj veljavnega območja svojega modela: podaljšana je čez izmerjeno.

## src/app/framed.rs

cannot-be-changed-it-is-locked = Ni mogoče spremeniti: { $locked }.
locked-the-mission-title-does-not-open-it-le = Zaklenjeno: naloga »{ $title }« tega ne odpira. Za spremembo zapustite nalogo.
the-address-that-this-was-opened-with-hides = Naslov, s katerim je bilo to odprto, skriva druge zaslone (hide:screens).
the-address-that-this-was-opened-with-hides-2 = Naslov, s katerim je bilo to odprto, skriva iskanje (hide:find).
the-address-that-this-was-opened-with-hides-3 = Naslov, s katerim je bilo to odprto, skriva datoteke in povezave (hide:files).

## src/app/jobs/list.rs

t-1-job-at-work = 1 opravilo v teku
n-jobs-at-work =
    { $n ->
        [one] { $n } opravilo v teku
        [two] { $n } opravili v teku
        [few] { $n } opravila v teku
       *[other] { $n } opravil v teku
    }
n-at-work = { $n } v teku
t-1-job-stopped = 1 opravilo ustavljeno
n-jobs-stopped =
    { $n ->
        [one] { $n } opravilo ustavljeno
        [two] { $n } opravili ustavljeni
        [few] { $n } opravila ustavljena
       *[other] { $n } opravil ustavljenih
    }
n-stopped =
    { $n ->
        [one] { $n } ustavljeno
        [two] { $n } ustavljeni
        [few] { $n } ustavljena
       *[other] { $n } ustavljenih
    }
running-at-work-halted-stopped =
    { $halted ->
        [one] { $running } v teku, { $halted } ustavljeno
        [two] { $running } v teku, { $halted } ustavljeni
        [few] { $running } v teku, { $halted } ustavljena
       *[other] { $running } v teku, { $halted } ustavljenih
    }
jobs-both = opravila: { $both }
what-is-being-worked-out-also-beside-other-s = Kaj se računa; tudi ob drugih zaslonih
go-on-with-job = Nadaljuj: { $job }
goes-on-where-it-was-stopped = Nadaljuje tam, kjer je bilo ustavljeno
stop-job = Ustavi: { $job }
stands-still-what-is-found-stays-and-it-can = Miruje; kar je najdeno, ostane, in od tod lahko nadaljuje
stopped-at-progress-what-is-found-stays = ustavljeno ({ $progress }): kar je najdeno, ostane
progress-time-left = { $progress }, še { $time }

## src/app/library/folder.rs

name-remove-it-from-its-folder-as-any-other = { $name }: odstranite jo iz njene mape kot vsako drugo datoteko

## src/app/library/page.rs

the-browser-refuses-this-page-its-storage-no = brskalnik tej strani ne dovoli shrambe: datoteke se tu ne hranijo
what-the-browser-has-kept-of-it-is-spoilt = kar je brskalnik od nje shranil, je pokvarjeno
taken-kb-of-most-kb-are-taken-whoever-clears = Zasedenih je { $taken } kB od { $most } kB. Kdor v brskalniku počisti podatke te strani, odstrani te datoteke: pomembno prenesite.
it-is-not-kept-any-more = ni več shranjena
it-has-size-kb-at-most-most-kb-of-a-file-are = ima { $size } kB: v brskalniku se hrani največ { $most } kB na datoteko
n-files-are-kept-already-and-no-more-can-be = Shranjenih datotek je že { $n } in več jih ne more biti: najprej katero izbrišite
taken-kb-of-most-kb-are-taken-and-it-has-siz = zasedenih je { $taken } kB od { $most } kB, ta pa ima { $size } kB: najprej katero izbrišite
the-browser-has-no-room-for-it-or-refuses-it = brskalnik zanjo nima prostora ali jo zavrača; že shranjeno je, kot je bilo

## src/app/library/present.rs

the-machine-has-the-papers-five-masses = stroj ima pet mas iz člankov
it-is-not-kept-from-here = od tu se ne shrani
no-script-controls-this-cut = tega reza ne vodi noben skript

## src/app/library/window.rs

no-place-in-a-run-has-the-units-of-its-input = Nobeno mesto v poteku nima enot njenih vhodov in rezultata.
the-result-of-a-mission-is-verified-by-stead = Rezultat naloge preveri steadycut mission check.
take-it-for-a-model-of-plant-and-controller = Prevzemi za model procesa in regulatorja
open-it-and-cut-it-from-its-start = Odpri ga in reži od začetka
begin-it-on-the-screen-learn = Začni jo na zaslonu Vadnica
lay-it-over-the-plots = Položi na grafe
cut-it-from-a-blank-on-the-screen-workpiece = Izreži ga iz surovca na zaslonu Obdelovanec
search-for-formulas-on-the-screen-identify = Išči formule na zaslonu Formule
use-it-in-the-present-cut-undo-takes-it-back = Uporabi v tem rezu; Razveljavi vzame nazaj
there-is-no-place-for-files-here-the-system = Tu ni prostora za datoteke: sistem ga ne navaja.
files-that-this-browser-keeps-for-this-page = Datoteke, ki jih ta brskalnik hrani za to stran. Spustite ali odprite datoteko in jo nato tu obdržite.
t-1-other-file-is-of-no-use-here-and-not-liste = 1 druga datoteka tu ni uporabna in ni našteta.
n-other-files-are-of-no-use-here-and-not-lis = Drugih datotek, ki tu niso uporabne in niso naštete: { $n }.
cutters-materials-machines-parts-and-more-in = Frezala, materiali, stroji, obdelovanci in drugo v lastni mapi:
another-folder = Druga mapa…
it-is-read-every-two-seconds-while-this-wind = Bere se vsaki dve sekundi, dokler je to okno odprto
read-again = Preberi znova
its-path = Njena pot
a-folder-that-is-there-enter-takes-it = obstoječa mapa; Enter jo prevzame
being-read = Branje…
none-of-these-here-yet-kinds = Teh tu še ni: { $kinds }.
no-files-here-yet-begin-one-below-or-keep-on = Tu še ni datotek: spodaj začnite novo ali obdržite odprto.
name-in-use = { $name }, v uporabi
in-use = v uporabi
delete-it-for-good = Dokončno izbrisati?
delete-it = Izbriši
keep-it = Obdrži
download = Prenesi
delete = Izbriši…
take-it-for = Prevzemi za
opened-from-elsewhere = Odprto od drugod
begin-a-new-one = Začni novo
a-file-in-which-every-entry-is-explained-not = Datoteka, v kateri je vsak vnos razložen; nič se ne prepiše
keep-of-the-present-cut = Obdrži iz tega reza

## src/app/library/work.rs

files = datotek

## src/app/link/code.rs

this-link-has-bytes-characters-and-a-qr-code = Ta povezava ima { $bytes } znakov, koda QR pa jih sprejme največ { $most }: pošljite samo povezavo.
qr-code-of-the-link = Koda QR povezave

## src/app/link.rs

link-to-this-state = Povezava do tega stanja
link-to-this-mission = Povezava do te naloge
the-link-is-in-the-clipboard = Povezava je v odložišču.
the-link-s-part-from-on-is-in-the-clipboard = Del povezave od # naprej je v odložišču: pripnite ga naslovu spletne strani SteadyCut.
there-is-no-clipboard-here-copy-the-link-by = Odložišča tu ni. Povezavo kopirajte ročno (Ctrl+C ali dolgi pritisk):
the-command-line-is-in-the-clipboard = Ukazna vrstica je v odložišču.
there-is-no-clipboard-here-copy-the-command = Odložišča tu ni. Ukazno vrstico kopirajte ročno (Ctrl+C ali dolgi pritisk):
command-line = Ukazna vrstica
the-cut-has-changed-since-all-this-is-of-the = Rez se je medtem spremenil: vse to je za rez, kakršen je bil.
take-a-new-link = Ustvari novo povezavo
repeats-the-run-on-the-command-line = Ponovi simulacijo v ukazni vrstici:
it-comes-to-the-digest = Njen digest je
the-digest-comes-here-once-the-cut-is-worked = Digest se pokaže tu, ko je rez izračunan do konca.
it-was-changed-before-it-was-worked-out-to-i = Spremenjeno je bilo, preden je bilo izračunano do konca: brez digesta.
copy-the-command-line = Kopiraj ukazno vrstico
copy-the-link = Kopiraj povezavo
for-a-qr-code-the-address-of-a-page-with-ste = Za kodo QR: naslov strani, na kateri je SteadyCut
allowed-is-an-address-that-begins-with-https = Dovoljen je naslov, ki se začne s https:// ali http://, brez #.
make-the-code = Izdelaj kodo
save-as-svg = Shrani kot SVG
save-as-png = Shrani kot PNG

## src/app/messages.rs

remove-this-message-it-stays-in-the-list-of = Odstrani to sporočilo; ostane na seznamu sporočil
dismiss = Zapri
what-was-said-so-far = Dosedanja sporočila
messages = Sporočila
messages-the-newest-first = Sporočila, najnovejša najprej

## src/app/mirror/mod.rs

name-nothing-can-be-written-there = { $name }: tja ni mogoče ničesar zapisati
this-is-not-shown-any-more = To ni več prikazano.
from-least-to-most = od { $least } do { $most }
from-least-on = od { $least } naprej
up-to-most = do { $most }
of-any-size = poljubne velikosti
name-text-is-not-a-number-allowed-is-a-numbe-2 = { $name }: „{ $text }“ ni število: dovoljeno je število { $range }
name-text-is-not-in-its-range-allowed-is-a-n-2 = { $name }: „{ $text }“ ni v svojem območju: dovoljeno je število { $range }

## src/app/mod.rs

embed-screen-id-allowed-behind-screen-are-al = embed: `screen:{ $id }`: za screen: so dovoljeni { $allowed }

## src/app/native.rs

no-graphics-adapter-could-be-used-a-driver-f = Nobenega grafičnega vmesnika ni mogoče uporabiti. Potreben je gonilnik za Vulkan; brez grafične kartice zadošča programski gonilnik Mesa (Debian, Ubuntu: apt install mesa-vulkan-drivers).
no-window-could-be-opened-a-display-is-neede = Okna ni mogoče odpreti. Potreben je prikaz: v Linuxu mora biti nastavljen DISPLAY ali WAYLAND_DISPLAY, X11 pa potrebuje libxkbcommon-x11 (Debian, Ubuntu: apt install libxkbcommon-x11-0). Brez prikaza `xvfb-run steadycut` odpre okno, ki se ne vidi, `steadycut run` pa ne potrebuje nobenega.
the-console-cannot-be-shown-problem = programa ni mogoče prikazati: { $problem }

## src/app/overlay/file.rs

text = Besedilo
tabs-between-the-values = tabulatorji med vrednostmi
semicolons-between-the-values = podpičja med vrednostmi
commas-between-the-values = vejice med vrednostmi
blanks-between-the-values = presledki med vrednostmi
decimal-point = decimalna pika
decimal-comma = decimalna vejica
no-line-with-names = nobena vrstica z imeni
names-in-line-line = imena v vrstici { $line }
units-in-line-line = enote v vrstici { $line }
values-from-line-line-on = vrednosti od vrstice { $line } naprej
times-in-the-column-column = časi v stolpcu { $column }
rate-samples-in-a-second = { $rate } vzorcev v sekundi
no-times = brez časov

## src/app/overlay/layouts.rs

what-was-said-for-a-file-with-the-same-colum = Kar je bilo povedano za datoteko z istimi stolpci, za to ne velja: { $why }

## src/app/overlay/mod.rs

measured-name = izmerjeno: { $name }

## src/app/overlay/work.rs

steps = koraki
and-n-more = { " " }in še { $n }
file-has-no-channel-name-it-has-channels = { $file } nima kanala `{ $name }`: ima { $channels }.

## src/app/panels/console/afc.rs

adaptive-feed-control-teach-in-the-reference = Prilagodljiva regulacija podajanja: naučite referenčne sile, nastavite FMIN in FMAX in preberite dnevnik reza
the-set-up-was-changed-meanwhile-nothing-is = Priprava je bila medtem spremenjena: nič ni prevzeto. Naučite znova.
taught-in = Naučeno.
taught-in-up-to-the-time-limit-the-part-is-l = Naučeno do časovne omejitve; obdelovanec je daljši.
not-taught-in-why = Ni naučeno: { $why }
teach-in-cuts-the-part-of-the-set-up-once-at = Učenje enkrat obdela kos iz priprave s programiranim podajanjem, brez sprememb te seje, in največjo silo vsakega reza ohrani kot njegovo referenco.
stop-the-teach-in = Ustavi učenje
teach-in-2 = Nauči
teach-in-3 = Učenje
cut-number-feed-feed-force-of-reference-shar = Rez { $number }: podajanje { $feed }, { $force } od { $reference } ({ $share } %)
cut-number-feed-feed-force-no-reference = Rez { $number }: podajanje { $feed }, { $force }, brez reference
teach-in-the-feed-stays-as-programmed = Učenje: podajanje ostane, kot je programirano.
off-for-this-cut-the-operator-has-turned-the = Za ta rez izključeno: operater je zmanjšal korekcijo.
overload-the-force-stays-over-its-limit-with = Preobremenitev: sila ostaja nad mejo s podajanjem na FMIN.
watching-fmin-and-fmax-are-100-the-feed-stay = Opazovanje: FMIN in FMAX sta 100 %, podajanje ostane, kot je programirano.
out-of-the-cut-feed-in-the-air = Zunaj reza: podajanje v zraku.
the-feed-stands-at-fmin = Podajanje je na FMIN.
the-feed-stands-at-fmax = Podajanje je na FMAX.
the-feed-follows-the-force = Podajanje sledi sili.
log = Dnevnik
done-of-n-cuts-done = opravljenih rezov: { $done } od { $n }
cut = rez
number-of-the-cut = Številka reza
ref-n = ref. N
reference-force-as-teach-in-has-found-it = Referenčna sila, kot jo je našlo učenje
teach-in-s = učenje s
time-that-the-cut-takes-at-the-programmed-fe = Čas reza s programiranim podajanjem
control-s = regul. s
time-that-it-took = Čas, ki ga je porabil
diff = razl. %
by-how-much-that-is-longer = Za koliko je to dlje
peak-n = konica N
largest-measured-force = Največja izmerjena sila
least = najm. %
least-feed-of-the-programmed-one = Najmanjše podajanje, glede na programirano
overload = Preobremenitev
all = vse

## src/app/panels/console/answer.rs

with-dynamics-error-within = z dinamiko { $error } znotraj
with-dynamics-error-outside = z dinamiko { $error } zunaj
with-dynamics-error = z dinamiko { $error }
too-short-yet = še prekratko
too-short-to-judge = prekratko za oceno
not-at-rest = se ne umiri
still-on-its-way = še na poti
force-swing = sila ±{ $swing }
period-period-no-rest = perioda { $period }, brez umiritve
no-ra = ni Ra
not-judged = ni ocenjeno
outside-the-model = zunaj modela
ra-outside-its-model = Ra zunaj modela
error-within = { $error } znotraj
error-outside = { $error } zunaj
ra-swings-by-swing = Ra niha za ±{ $swing }
force-swings-by-swing = sila niha za ±{ $swing }
unstable-2 = nestabilno
chattered = drdralo
from-to-to-s-and-before = { $from } do { $to } s in prej
from-to-to-s = { $from } do { $to } s
the-band-is-band-here-the-2-of-the-textbooks = Pas je tu ±{ $band }: učbeniških 2 %, ker noben šum ne premika sile v mirovanju.
the-band-is-band-here-the-2-of-the-textbooks-2 = Pas je tu ±{ $band }: učbeniških 2 % in { $noise } za to, kolikor šum silo še premika v mirovanju.
what-is-held-swings-by-more-than-that-nothin = Vodena veličina niha bolj od tega: tu se nič ne umiri.
no-rest-band = brez umiritve (±{ $band })
does-not-settle-band = se ne umiri (±{ $band })
force-rests-time = umiritev { $time }
force-settles-in-time-band = sila se umiri v { $time } (±{ $band })
force-steady = sila mirna
force-settles-at-once-band = sila se umiri takoj (±{ $band })
no-transient = brez prenihaja
jump-jump = skok { $jump }
jump-jump-no-overshoot = skok { $jump }, brez prenihaja
overshoot-size = prenihaj { $size }
its-overshoot-size = njen prenihaj { $size }

## src/app/panels/console/bands.rs

at-a-limit = Na meji
outside-model-2 = Zunaj modela
in-the-air-2 = V zraku
override-on-its-way = Korekcija na poti
over-the-afc-limit = Nad mejo AFC
controller = Regulator
disturbances = Motnje
none-2 = brez
none-now = zdaj nobene
names-now = zdaj { $names }
no = ne
not-now = zdaj ne
now = zdaj
names-not-now = { $names }, zdaj ne
feed-2 = podajanje
speed = vrtljaji
spindle = vreteno

## src/app/panels/console/cards.rs

safe = varno
safe-feed = varno podajanje
share-over-scrap = { $share }, { $over } % izmeta
ra-now = Ra zdaj
ra-in-tolerance = Ra v toleranci
remaining-error = Trajni pogrešek
with-dynamics-in-tolerance = Z dinamiko v toleranci
error-without-dynamics = Pogrešek brez dinamike
share-no-ra-model = { $share } % brez Ra ({ $model })
share-outside-the-ra-model-model = { $share } % zunaj modela Ra ({ $model })
target-target = cilj { $target }
within-target-target = na cilju { $target }
over-rough-under-smoother = { $over } % grobo, { $under } % bolj gladko
of-the-length-cut = obdelane dolžine
without-dynamics-share = brez dinamike { $share }
share-rest-smoother = { $share }, ostalo bolj gladko
time-of-cut = Čas reza
both-scrap-own-and-over = oba izmet: { $own } in { $over } %
metal-removed = Odvzeto kovine
on-path-of-path = na { $path } poti

## src/app/panels/console/controls.rs

target = Cilj
workpiece = Obdelovanec
what-a-cut-costs = Koliko stane rez
nc-program = Program NC
what-constant-feed-to-compare-with = S katerim stalnim podajanjem primerjati
cnc-and-dead-time = CNC in mrtvi čas
what-the-controller-believes = Kaj predvideva regulator
noise = Šum
plant = Proces
own-formulas-of-the-models = Lastne formule modelov
cutter = Frezalo
wear-over-the-tool-s-life = Obraba skozi obstojnost orodja
feed-drive = Podajalni pogon
spindle-drive = Pogon vretena
machine = Stroj
sound-and-tool-life = Zvok in obstojnost orodja
roughness-profile-2 = Profil hrapavosti
off-line-plan = Načrt pred rezom
run-2 = Simulacija
name = Ime
edit-depths = Uredi globine…
the-depth-from-which-on-this-machine-chatter = Globina, od katere na tem stroju drdra, po vrtilni hitrosti: na zaslonu Stroj
limit-depth-2 = Mejna globina…
the-forces-on-the-tool-at-28-8-khz-over-the = Sile na orodju pri 28,8 kHz v zadnjih vrtljajih pred časovnim kazalcem
within-a-revolution = V enem vrtljaju…
operator-2 = Operater…
more-settings = Več nastavitev
a-measured-file-over-the-plots-text-matlab-h = Izmerjena datoteka nad grafi: besedilo, MATLAB, HDF5, TDMS ali Parquet. Lahko jo tudi spustite sem.
measured-data-2 = Izmerjeni podatki …
scenario-changed = { $scenario }, spremenjen
scenario-scenario = Scenarij: { $scenario }
scenario = Scenarij
the-shipped-scenarios = Priloženi scenariji
the-cut-of-the-mission-title-its-task-is-on = Rez naloge »{ $title }«; njeno besedilo je na zaslonu Vadnica.
as-shipped-about = Kot je priložen: { $about }
without-the-changes-made-in-the-cut-about = Brez sprememb med rezom: { $about }

## src/app/panels/console/disturb.rs

drops-a-disturbance-into-the-cut-a-little-ah = Vstavi motnjo v rez, malo pred orodjem; »Razveljavi« jo odstrani
names-and-sizes-of-disturbances = Imena in velikosti motenj
disturb-the-cut = Zmoti rez…
disturb-the-cut-2 = Zmoti rez
a-press-on-a-name-drops-that-disturbance-a-l = Pritisk na ime vstavi to motnjo malo pred orodjem, tako dolgo in veliko, kot je nastavljeno zraven.
length-of-the-disturbance = Dolžina: { $disturbance }
mm-long = { " " }mm dolžine
size-of-the-disturbance = Velikost: { $disturbance }
least-to-most = { $least } do { $most }

## src/app/panels/console/headline.rs

finding = iskanje …
axial-depth-times-radial-depth-summed-over-t = Aksialna globina krat radialna globina, sešteto vzdolž poti.
without-none = brez: nobenega
without-outside-its-model = brez: zunaj modela
without-ra = brez { $ra }
in-twin-ra = { $twin }: { $ra }.
roughness-produced-at-the-playhead-with-the = Nastala hrapavost pri časovnem kazalcu, s sledmi vibracij stroja: kot mora biti v mejah { $percent } % cilja. Brez: Ra samo po modelu reza, ki ga drži regulator. { $beside }
roughness-produced-at-the-playhead-as-it-sho = Nastala hrapavost pri časovnem kazalcu: kot mora biti v mejah { $percent } % cilja.
swings-target-target = niha, cilj { $target }
above-target-target = nad ciljem { $target }
below-target-target = pod ciljem { $target }
ra-with-dynamics = Ra z dinamiko
force-without-dynamics = Sila brez dinamike
judged-without-dynamics = ocenjeno brez dinamike
the-steady-state-error-how-far-ra-or-the-for-2 = Trajni pogrešek: kako daleč od cilja se Ra, ali sila, kadar se drži sila, umiri po zadnji stopnici in ali je to, skupaj s preostalim nihanjem, v toleranci; umiritveni čas sile, dokler dokončno ne ostane v pasu okoli vrednosti, kjer se umiri, in njen prenihaj čez to vrednost: skok, ki ga naredi sprememba sama, ni prenihaj. Nestabilno: podajanje in sila nihata, ne da bi izzvenela; tak rez tudi pozneje ne velja za dobrega.{ $band }
in-the-air-reference-force = v zraku, referenca { $force }
above-reference-force = nad referenco { $force }
within-reference-force = na referenci { $force }
below-reference-force = pod referenco { $force }
with-dynamics-force = z dinamiko { $force }
force-now = Sila zdaj
maximum-force-at-the-playhead-without-dynami = Največja sila pri časovnem kazalcu, brez dinamike: kot mora biti v mejah { $percent } % reference.
outside-the-ra-model-model = zunaj modela Ra ({ $model })
force-in-tolerance = Sila v toleranci
share-of-the-cut-length-on-which-the-produce = Delež obdelane dolžine, na katerem je nastali Ra v toleranci okoli cilja. Zunaj nje je prehrapav, kar je izmet, ali bolj gladek od zahtevanega, kar ni. Kjer je Ra zunaj svojega modela, se ne ocenjuje: ni niti v njej niti zunaj nje.
share-of-the-cut-length-on-which-ra-with-dyn = Delež obdelane dolžine, na katerem je Ra z dinamiko, ki ostane na obdelovancu, v toleranci okoli cilja. Zunaj nje je prehrapav, kar je izmet, ali bolj gladek od zahtevanega, kar ni. Kjer je Ra zunaj svojega modela, se ne ocenjuje.
share-of-the-cut-length-on-which-the-maximum = Delež obdelane dolžine, na katerem je največja sila v toleranci okoli reference.
so-far-sides = Doslej: { $sides }.
in-twin-sides = { $twin }: { $sides }.
over-too-rough-under-smoother = { $over } % prehrapavo, { $under } % bolj gladko
over-above-under-below = { $over } % nad, { $under } % pod
share-smoother-no-scrap = { $share } % bolj gladko, ni izmet
share-below-no-scrap = { $share } % pod, ni izmet
share-too-rough = { $share } % prehrapavo
share-above = { $share } % nad
share-rest-below = { $share }, ostalo pod
worst-force-deviation = Največje odstopanje sile
largest-deviation-of-the-force-from-the-desi = Največje odstopanje sile od želene po prvi sekundi.
from-desired-force = od želene sile
as-long = enako dolgo
saves-percent = prihrani { $percent } %
percent-longer = { $percent } % dlje
twin-took-for-the-same-length-of-path-time-l = { $twin }: { $took } za enako dolžino poti, izguba { $time }.
twin-took-for-the-same-length-of-path-time-s = { $twin }: { $took } za enako dolžino poti, prihranek { $time }.
twin-took-not-compared-why = { $twin }: { $took }, ni primerjano: { $why }.
it-is-compared-with-the-programmed-feed-sinc = Primerja se s programiranim podajanjem, ker velja: { $why }.
time-since-the-start-of-the-cut-told-times-a = Čas od začetka reza. { $told } Časi se primerjajo samo, kjer oba držita cilj: nad toleranco na največ { $percent } % dolžine. Hitrejši rez, ki je izmet, ni pridobitev; bolj gladka površina od zahtevane ni izmet.{ $none_safe }
twin-over-scrap = { $twin }: { $over } % izmet
twin-over-above = { $twin }: { $over } % nad
this-cut-over-scrap = ta rez: { $over } % izmet
this-cut-over-above = ta rez: { $over } % nad
both-above-own-and-over = oba nad: { $own } in { $over } %
this-cut-share-not-judged = ta rez: { $share } % neocenjeno
twin-share-not-judged = { $twin }: { $share } % neocenjeno
nothing-is-cut-yet = odrezanega še ni nič
neither-is-scrap = nobeden ni izmet
most-is-scrap = ≤ { $most } % je izmet

## src/app/panels/console/measured/layout.rs

search-for-formulas-in-it = Išči v njej formule
record = Zapis
none-a-sample-rate = brez: pogostost vzorčenja
time-column = Stolpec s časi
sample-rate = Pogostost vzorčenja
read-it-otherwise = Preberi drugače
entries-of-the-layout-as-the-command-steadyc = Vnosi oblike, kot jih ima ukaz steadycut measured, s presledki vmes: encoding, separator, decimal, thousands, names_line, units_line, first_line, names, units. Enter prebere datoteko znova.
allowed-is-key-value = dovoljeno je KEY=VALUE
as-you-said-for-a-file-with-the-same-columns = Kot ste povedali za datoteko z istimi stolpci: { $keys }.
as-the-file-name-beside-it-says-keys = Kot pove datoteka { $name } ob njej: { $keys }.
remembered-in-name-and-for-files-with-the-sa = Zapomnjeno v { $name } in za datoteke z istimi stolpci: { $keys }.
remembered-for-files-with-the-same-columns-k = Zapomnjeno za datoteke z istimi stolpci: { $keys }.
read-it-as-it-is-guessed-and-forget-what-is = Preberi po ugibanju in pozabi zapomnjeno, tudi ob datoteki
guess-again = Ugani znova
t-1-channel = 1 kanal
n-channels =
    { $n ->
        [one] { $n } kanal
        [two] { $n } kanala
        [few] { $n } kanali
       *[other] { $n } kanalov
    }
channel = kanal
samples = vzorcev
least-2 = najmanjša
largest = maksimum

## src/app/panels/console/measured/place.rs

the-channel-is-being-worked-out = Kanal se pripravlja.
finds-the-shift-at-which-both-go-together-mo = Poišče zamik, pri katerem se oba najbolj ujemata, in tam merilo in odmik, kot to naredi steadycut measured
align = Poravnaj
shift-0-s-scale-1-offset-0 = Zamik 0 s, merilo 1, odmik 0
as-measured = Kot izmerjeno
shift = Zamik
by-so-much-the-measurement-is-later-than-the = Za toliko je meritev poznejša od simulacije: za toliko prej je narisana
scale = Merilo
the-run-times-this-is-what-was-measured-the = Simulacija, pomnožena s tem, je izmerjeno: črta je narisana deljena s tem
scale-value-cannot-be-allowed-is-any-number = Merilo: { $value } ni mogoče: dovoljeno je vsako število razen 0, velikosti vsaj { $least }
offset-2 = Odmik
what-the-measurement-has-in-addition-after-t = Kar ima meritev še poleg, po merilu
not-aligned-why-it-can-be-moved-by-hand = Ni poravnano: { $why }. Lahko ga premaknete ročno.
it-is-aligned-as-soon-as-the-cut-is-worked-o = Poravna se, ko je rez izračunan.
it-has-nothing-in-common-with-the-cut-here = Tu z rezom nima nič skupnega.
by-hand = ročno
aligned = poravnano
how-what-is-left-rms-rest-over-samples-sampl = { $how }: kar ostane, efektivno { $rest } na { $samples } vzorcih; korelacija { $correlation }

## src/app/panels/console/measured/prepare.rs

preparation = Priprava
low-pass-filter-without-a-shift-in-time = Nizkoprepustni filter, brez zamika v času
cut-off = Mejna frekvenca
zero-before-the-cut = Ničla pred rezom
before-the-cut = pred rezom
drift-by-a-time-behind-the-cut = Lezenje, po času za rezom
behind-the-cut = za rezom
turn-two-forces-into-the-machine-s-axes = Zavrti dve sili v osi stroja
force-x-of-the-dynamometer = Sila x dinamometra
force-y-of-the-dynamometer = Sila y dinamometra
angle-to-x = Kot do X
largest-force-across-the-tool-in-every-perio = Največja sila prečno na orodje v vsaki periodi
force-along-x = Sila vzdolž x
force-along-y = Sila vzdolž y
period = Perioda
from-time = Od, { $time }
to-time = Do, { $time }

## src/app/panels/console/measured.rs

name-is-not-shown-there-are-most-measured-ch = { $name } ni prikazana: nad grafi je že { $most } izmerjenih kanalov. Najprej enega odstranite.
unfold = Razpri
open-a-file = Odpri datoteko …
leaves-a-line-of-it-and-the-plots-in-sight = Ostane vrstica, grafi pa so vidni
fold-to-a-line = Zloži v vrstico
text-of-any-layout-matlab-hdf5-tdms-or-parqu = Besedilo katerekoli oblike, MATLAB, HDF5, TDMS ali Parquet; datoteko lahko tudi spustite na grafe.
no-part-of-the-scenario-neither-a-file-nor-a = Ni del scenarija: nima ga ne datoteka ne povezava. Spremembe reza ga pustijo, kjer je, dokler ga ne odstranite ali zaprete programa.
remove = Odstrani
channel-2 = Kanal
laid-over = Leži na
as-it-is-not-converted = kot je, brez pretvorbe
its-unit = Enota
show-it = Pokaži
another-channel-of-this-file = Še en kanal te datoteke
drive-forces-structure-noise-wear-or-materia = Pogon, sile, struktura, šum, obraba ali material iz te datoteke, na zaslonu Formule
fit-settings-to-it = Prilagodi nastavitve
channel-over-signal-more = { $channel } na { $signal }{ $more }

## src/app/panels/console/mod.rs

least-override = Najmanjša korekcija
largest-override = Največja korekcija
roughness = Hrapavost
force-2 = Sila
feed = Podajanje
spindle-speed = Vrtilna hitrost
override-2 = Korekcija
depth-of-cut = Globina rezanja
console = Pult
start-home-plots-run-simulation-digest = začetek domov grafi simulacija digest start run plots
settings = Nastavitve

## src/app/panels/console/operator/figures.rs

mm-min-of-feed = mm/min, od { $feed }
t-1-min-of-speed = 1/min, od { $speed }
mm-min-programmed-feed = mm/min, programirano { $feed }
t-1-min-programmed-speed = 1/min, programirano { $speed }
sent-to-the-machine = poslano stroju
place-in-the-cut = Mesto v rezu
mm-of-length = mm od { $length }
the-part-the-tool-is-at-place-depth-deep = Obdelovanec: orodje je pri { $place }, globina { $depth }
the-machine-is-paused = Stroj je ustavljen.
feeding-not-in-the-cut = Podajanje teče, zunaj reza.
cutting = Reže.
cutting-force-2 = Rezalna sila
mark-force-n = oznaka: { $force } N
mark-force-n-which-ra-target-asks-for = oznaka: { $force } N, ki jih zahteva Ra { $target }
mark-force-n-which-is-to-be-held = oznaka: { $force } N, ki jih je treba držati
force-n-stops-the-feed = { $force } N ustavi podajanje
force-n-breaks-a-tooth = { $force } N zlomi zob
no-force-stops-this-machine-setting-stop-on = Tega stroja ne ustavi nobena sila (nastavitev: Ustavi ob preobremenitvi)
force-force-n-asked-for-asked-n-limit-limit = Sila { $force } N, zahtevano { $asked } N, meja { $limit } N
force-force-n-asked-for-asked-n = Sila { $force } N, zahtevano { $asked } N

## src/app/panels/console/operator/mod.rs

cut-by-hand = Reži ročno
you-hold-the-feed-override-a-knob-what-an-op = V rokah imate korekcijo podajanja: gumb, kar operater vidi in sliši, ter na koncu ocena v primerjavi z vsemi regulatorji
operator = Operater
from-the-start-of-the-part-without-a-control = Od začetka obdelovanca, brez regulatorja in pri 100 %
plots-settings-and-sentences-beside-the-knob = Grafi, nastavitve in stavki ob gumbu, ki jih operater nima
whole-console = Ves pult
back-to-the-console-the-cut-goes-on-as-it-is = Nazaj na pult; rez teče naprej, kot je{ $keys }

## src/app/panels/console/operator/panel.rs

drag-around-it-wheel-and-page-up-and-down = Poteg naokoli, kolesce, + in -, Page Up in Down
override-percent-up = Korekcija { $percent } % več
override-percent-down = Korekcija { $percent } % manj
the-cut-is-over = Rez je končan
you-have-the-feed = Podajanje je vaše
controller-has-the-feed = Podajanje ima { $controller }
give-it-back-to-controller = Vrni: { $controller }
give-it-back = Vrni
take-it = Prevzemi
at-the-override-that-is-sent-now-a-turn-of-t = Pri korekciji, ki se pošilja zdaj; prevzame ga tudi obrat gumba
the-cut-is-over-cut-by-hand-begins-it-again = Rez je končan: Reži ročno ga začne znova
scale-to = Skala do
as-on-a-machine-s-panel = Kot na pultu stroja
as-far-as-the-cnc-lets-a-controller-go = Kolikor CNC dovoli regulatorju
scale-to-percent = Skala do { $percent }

## src/app/panels/console/operator/score.rs

score-of-the-cut-by-hand = Ocena ročnega reza
your-hand-against-every-controller = Vaša roka proti vsem regulatorjem
your-last-cut-by-hand-against-every-controll = Vaš zadnji ročni rez proti vsem regulatorjem
the-same-part-and-noise-for-everybody-ranked = Isti obdelovanec in šum za vse. Po času so razvrščeni tisti, ki držijo toleranco na { $percent } % dolžine.
a-force-of-force-tolerance = sila { $force } ± { $tolerance } %
everybody-else-cuts-the-same-part-now = Vsi drugi zdaj režejo isti obdelovanec.
this-cut-was-not-driven-by-hand-button-begin = Ta rez ni bil voden ročno. { $button } ga začne od začetka: med rezom vrtite gumb.
asked-for-is-asked-hold-the-force-at-its-mar = Zahteva se { $asked }. Silo držite na oznaki: počasneje, kjer je rez globlji ali trši, hitreje, kjer je lažji. Gumb se odzove po mrtvem času. Ko je rez končan, se oceni v primerjavi z vsemi regulatorji na istem obdelovancu.
ra-in-tol = Ra v tol. %
force-in-tol = sila v tol. %
rank = mesto
by-time-among-those-who-hold-the-tolerance = Po času, med tistimi, ki držijo toleranco
who = kdo
your-hand-and-every-way-of-control = Vaša roka in vsi regulatorji
share-of-the-length-on-which-what-is-asked-f = Delež dolžine, na katerem se drži zahtevano
time-s = čas s
time-of-the-cut-none-if-it-did-not-come-to-i = Čas reza; brez, če ni prišel do konca
greatest-force = Največja sila
travel-s = gibanje %/s
way-of-the-feed-override-in-a-second = Pot korekcije podajanja v sekundi
cut-2 = Reži
cut-by-controller = Reži: { $controller }
cuts-the-part-this-way-with-your-hand-drawn = Obdela kos na ta način, z vašo roko, vrisano v grafe

## src/app/panels/console/revolution/plot.rs

before-the-last-change-the-new-picture-is-be = Pred zadnjo spremembo; nova slika nastaja.
peak-of-the-control-period = Konica regulacijske periode
forces-from-from-to-to = Sile od { $from } do { $to }
n-samples-up-to-time-s = vzorcev { $n } do { $time } s
n-samples-up-to-time-s-peak-of-the-last-cont = vzorcev { $n } do { $time } s. Konica zadnje regulacijske periode (osenčeno): { $force } pri { $angle }; s šumom senzorja je to tisto, kar vidi regulator.

## src/app/panels/console/revolution.rs

within-a-revolution-2 = V enem vrtljaju
desired-force = Želena sila
fxy-across-the-tool = Fxy, prečno na orodje
fx-along-the-feed = Fx, vzdolž podajanja
fy-across-the-feed = Fy, prečno na podajanje
fz-along-the-tool = Fz, vzdolž orodja
the-run-is-being-repeated-up-to-this-moment = Simulacija se ponavlja do tega trenutka.
t-1-turn = 1 vrtljaj
t-2-turns = 2 vrtljaja
angle = Kot
time = Čas
save-these-samples-as-csv-time-angle-fx-fy-f = Shrani te vzorce kot CSV: čas, kot, Fx, Fy, Fz, Fxy
the-revolution = vrtljaj
the-force-was-not-simulated-tooth-by-tooth-a = V tem trenutku simulacije sila ni bila simulirana zob za zobom.
the-force-of-this-cut-is-the-maximum-that-a = Sila tega reza je maksimum, ki ga da formula ali mreža.
to-look-into-a-revolution-the-force-has-to-b = Za pogled v vrtljaj mora biti sila simulirana zob za zobom: mehanistični model kroglastega frezala, pri 28,8 kHz.
simulate-tooth-by-tooth = Simuliraj zob za zobom
load-experiment-2 = Naloži preizkus 2
both-can-be-undone-the-first-keeps-this-scen = Oboje je mogoče razveljaviti. Prvo ohrani ta scenarij in spremeni njegov proces.

## src/app/panels/console/story.rs

a-burst-of-chatter-begins-here-3-times-over = Tu se začne izbruh drdranja: 3 × sila na dolžini 5,0 mm, vsiljen: varno stalno podajanje zapusti toleranco (Ra 0,45 µm do 0,88 µm), regulator zmanjša podajanje za 16,1 % (319 na 299 mm/min), poveča vrtilno hitrost za 14,6 % in zapusti toleranco (Ra 0,77 µm do 1,23 µm). Trajni pogrešek je 51 % nad ciljnim Ra, okoli tega se Ra še giblje za ±13,2 %; zakon nima integrala.
the-spindle-speed-command-stands-at-its-uppe-2 = Ukaz vrtilne hitrosti vretena je na zgornji meji, 2500 1/min (korekcija 150 %), 60 % tega časa: medtem je Ra 12,3 % nad ciljem, zunaj tolerance.
ahead-of-the-playhead-not-cut-yet-a-click-go = Pred časovnim kazalcem, še ni odrezano: klik gre tja
each-click-goes-to-the-next-of-them = Vsak klik gre na naslednjega od njih.
remove-this-line-shows-it-again = Odstrani to vrstico; `?` jo spet pokaže
close-the-introduction = Zapri uvod
the-depths-and-speeds-at-which-this-machine = Globine in vrtilne hitrosti, pri katerih ta stroj drdra, in stikalo za njegov zvok
stability-and-sound = Stabilnost in zvok

## src/app/panels/console/workpiece/hand.rs

tap-what-then-drag-its-dot = Tapnite: { $what }; nato povlecite piko.
drag-what = Povlecite: { $what }.
nothing-chosen = Nič ni izbrano
depth-number = Globina { $number }
end-of-number = Konec { $number }
wall-number = Stena { $number }

## src/app/panels/console/workpiece/material.rs

material-even-noise-and-inhomogeneity-above-2 = Material: enakomeren. „Šum“ in „Nehomogenost“ nad 0 ga po semenu naredita neenakomernega.
material-under-seed-seed-force-low-to-high-a = Material pri semenu { $seed }: sila { $low } do { $high } vzdolž tega reza
change-at-place = { $change } pri { $place }

## src/app/panels/console/workpiece/picture.rs

depths-drawn-times-times-larger-than-lengths = globine narisane { $times }-krat večje od dolžin
to-scale = v merilu
from-the-side-axial-depths-in-mm-scale-help = S strani, aksialne globine v mm, { $scale }. { $help }
a-floor-or-an-end = dno ali konec
cut-from-the-side-depths = Rez s strani: { $depths }
a-wall = stena
from-above-radial-depths-in-mm-help = Od zgoraj, radialne globine v mm. { $help }
cut-from-above-depths = Rez od zgoraj: { $depths }

## src/app/panels/console/workpiece/table.rs

no-2 = Št.
duplicate-section-number = Podvoji odsek { $number }
remove-section-number = Odstrani odsek { $number }
length-mm-2 = Dolžina mm
axial-mm = Aksialno mm
wall-mm = Stena mm
r-d-mm = R_D mm
length-of-section-number = Dolžina odseka { $number }
axial-depth-of-section-number = Aksialna globina odseka { $number }
wall-of-section-number = Stena odseka { $number }
add-a-section = Dodaj odsek
at-most-n-sections-in-a-cut = Največ { $n } odsekov v rezu
wall-place-of-the-side-wall-across-the-cut-f = Stena: mesto stranske stene prečno na rez, od osi orodja. R_D: od stene do mesta, kjer frezalo pri tej globini sreča površino.
air = zrak
the-tool-meets-no-material-here = Orodje tu ne sreča materiala
stretch-number-why = Odsek { $number }: { $why }.
it-is-cut-and-its-depth-stays-a-change-of-it = je odrezan in njegova globina ostane; njena sprememba bi delovala tam, kjer je orodje zdaj
n-stretches-each-with-its-axial-and-its-radi = Odseki, vsak s svojo aksialno in radialno globino: { $n }
one-axial-and-one-radial-depth-along-the-who = Ena aksialna in ena radialna globina vzdolž vse poti, tisti z njenega začetka
take-the-profiles-away = Odstrani profila
from-mm = Od mm
axial-depth-of-stretch-number = Aksialna globina odseka { $number }
start-of-stretch-number = Začetek odseka { $number }
remove-stretch-number = Odstrani odsek { $number }
add-a-stretch = Dodaj odsek

## src/app/panels/console/workpiece.rs

experiment-1 = Preizkus 1
the-part-from-the-side-drag-its-depths-and-i = Obdelovanec s strani: povlecite njegove globine in konce ali jih vtipkajte v tabelo
cut-number-tool = Rez { $number }, orodje
cut-number = Rez { $number }
at-most-n-cuts = Največ { $n } rezov
add-a-cut = Dodaj rez
duplicate-cut-number = Podvoji rez { $number }
remove-cut-number = Odstrani rez { $number }
the-last-cut-stays-one-path-goes-without-cut-2 = Zadnji rez ostane: „Ena pot“ gre brez rezov
these-depths-are-profiles-of-a-file-take-the = Te globine so profila iz datoteke: odstranite ju, da lahko vlečete globino.
back-to-the-start = Nazaj na začetek
what-is-grey-is-cut-already-at-the-start-of = Kar je sivo, je že odrezano: na začetku reza je mogoče spremeniti vsak odsek
the-tool-is-at-at-changed-depths-act-from-th = Orodje je pri { $at }: spremenjene globine delujejo od tam in od zdaj naprej. Odsek, ki se začne prej, velja le za svoj še neodrezani del; kar je odrezano, ostane.
the-cut-is-over-changed-depths-are-those-of = Rez je končan: spremenjene globine veljajo za ves obdelovanec, ki se reže znova od začetka.
still-to-be-cut = še za rezanje
cut-already = že odrezano
the-tool-comes-in-from-the-air = orodje prihaja iz zraka
tool-at-place = orodje pri { $place }
length-long-place = dolžina { $length }, { $place }
take-the-part-of = Vzemi obdelovanec iz
takes-over-the-cuts-alone-the-scenario-of-th = Prevzame samo reze; scenarij s tem imenom nastavi tudi regulator, šum in podajanje
one-straight-cut-with-this-path-s-depths-the = En raven rez z globinami te poti, orodje prihaja iz zraka
make-cuts-of-the-path = Iz poti naredi reze
no-cuts-the-path-with-its-length-depths-and = Brez rezov: pot s svojo dolžino, globinami in profilom globine
one-path = Ena pot

## src/app/playback.rs

as-fast-as-possible = kar se da hitro

## src/app/search.rs

screen = zaslon
search-formulas-in-a-table-of-one-s-own = Išči formule v lastni tabeli
open-a-part-of-one-s-own-table-or-g-code = Odpri lasten obdelovanec: tabela ali koda G
lay-measured-data-over-the-plots = Položi izmerjene podatke na grafe
my-files-cutters-materials-machines-parts-an = Moje datoteke: lastna frezala, materiali, stroji, obdelovanci in drugo
fit-settings-to-measured-data = Prilagodi nastavitve izmerjenim podatkom
open-measured-data-to-fit-settings-to = Odpri izmerjene podatke za prilagajanje nastavitev
go-on-with-a-saved-search-for-a-formula = Nadaljuj shranjeno iskanje formule
open-networks-of-unks = Odpri mreže UNKS
save-the-networks-of-unks = Shrani mreže UNKS
light-colours = Svetle barve
dark-colours = Temne barve
colours-as-the-system-has-them = Barve kot v sistemu
large-type-for-a-projector = Velika pisava, za projektor
type-of-the-usual-size = Običajna velikost pisave
less-motion = Manj gibanja
motion-as-usual = Običajno gibanje
identify-own-recording-measurements-drive-de = identifikacija lastni posnetek meritve pogon mrtvi čas zakasnitev stopnica sila koeficienti kienzle opletanje struktura nihajne oblike udarec frekvenčni odziv šum valovitost obraba taylor material trdota
load-toml-data-own = naloži uvozi toml podatki lastno load
download-keep-toml = prenesi ohrani toml save
save-table-data-results-measurements-downloa = shrani tabela podatki rezultati meritve prenos preglednica save
qr-code-class-phone-digest-share-address-url = koda qr razred telefon digest deli naslov url ukazna vrstica terminal ponovi pošlji share link
identify-own-data-measured-measurements-csv = identifikacija lastni podatki izmerjeno meritve csv naloži uvozi identify
workpiece-cam-nc-gcode-program-csv-depths-im = obdelovanec cam nc gcode program csv globine uvoz lasten surovec
own-data-measurements-csv-matlab-mat-tdms-la = lastni podatki meritve csv matlab mat tdms labview parquet hdf5 dinamometer kanal prekrivanje primerjava uvoz
identify-resume-json = identifikacija nadaljuj json resume
neural-learning-weights-json = nevronske učenje uteži json neural
help-about-introduction-keyboard-shortcuts-h = pomoč o programu uvod bližnjice tipkovnica dotik poteg ščip prst help about shortcuts
theme-contrast-mode = tema kontrast način theme
zoom-big-font-size-beamer-class-letters = povečava velika pisava črke projektor razred zoom font
language-sprache-jezik-slovene-slovenian-ger = jezik slovenščina language sprache jezik slovene slovenian german deutsch en sl de
animation-reduced-accessibility-still = animacija manj dostopnost mirno animation
back-retry-repeat-breakage-scrap-stop-crash = nazaj znova ponovi lom izmet ustavitev trk zlomljeno nezgoda retry
playback-transport = predvajanje prenos playback
restart-repeat-from-the-start-rerun-begin-an = začni znova ponovi od začetka ohrani nastavitve restart rerun
disturb-disturbance-fault-trouble-error-hurt = moti motnja napaka težava nezgoda okvara disturb fault
operator-override-manual-hand-knob-panel-han = operater korekcija ročno roka gumb pult kolo kolesce vodi sam premagaj override manual knob
library-folder-tool-material-machine-structu = knjižnica mapa orodje frezalo material stroj struktura obdelovanec skript lastno hrani katalog
setting-scenario-screen-command-or-word = Nastavitev, scenarij, zaslon, ukaz ali beseda
type-a-word-dead-time-kp-chatter-noise-csv = Vtipkajte besedo: mrtvi čas, Kp, drdranje, šum, CSV …
nothing-has-these-words-fewer-or-shorter-one = Ni zadetkov. Manj ali krajše besede najdejo več.
more-more-another-word-narrows-them-down = še { $more }: dodatna beseda zoži izbor.
in-group-path = v { $group }: { $path }
scenario-2 = scenarij
command = ukaz
control-by-controller = Krmili z { $controller }

## src/app/session/change.rs

locked-by-the-address-that-this-was-opened-w = zaklenjeno z naslovom, s katerim je bilo to odprto
no-other-scenario-is-opened-here-settings-ar = Drug scenarij se tu ne odpre: nastavitve je zaklenil naslov, s katerim je bilo to odprto.
predict-first-the-cut-begins-as-soon-as-you = Najprej napovejte: rez se začne, ko poveste, kaj pričakujete, ali nadaljujete brez napovedi.
name-is-open-it-is-cut-from-its-start = { $name } je odprt: reže se od začetka.
name-controls-this-cut-now = { $name } zdaj vodi ta rez.
set-for-the-whole-cut-now-first-second-third = { " " }Zdaj nastavljeno za ves rez: { $first }, { $second }, { $third } in še { $more }.
set-for-the-whole-cut-now-list = { " " }Zdaj nastavljeno za ves rez: { $list }.
the-change-made-during-the-cut-is-not-repeat = Sprememba med rezom se ne ponovi; Razveljavi jo vrne.
the-n-changes-made-during-the-cut-are-not-re =
    { $n ->
        [one] { $n } sprememba med rezom se ne ponovi; Razveljavi jo vrne.
        [two] { $n } spremembi med rezom se ne ponovita; Razveljavi ju vrne.
        [few] { $n } spremembe med rezom se ne ponovijo; Razveljavi jih vrne.
       *[other] { $n } sprememb med rezom se ne ponovi; Razveljavi jih vrne.
    }
cut-from-its-start-names-of-edits = Reže se od začetka.{ $names } { $of_edits }
setting-cannot-be-changed-it-is-why = Nastavitve »{ $setting }« ni mogoče spremeniti: { $why }.
the-mission-title-is-open-it-locks-all-setti = Odprta je naloga »{ $title }«: zaklepa vse nastavitve, tudi »{ $setting }«. Za spremembo zapustite nalogo.
the-mission-title-is-open-and-locks-setting = Odprta je naloga »{ $title }« in zaklepa »{ $setting }«. Spremenite lahko: { $open }. Za vse drugo zapustite nalogo.
the-mission-title-is-left = Naloga »{ $title }« je zapuščena.
the-mission-title-is-open-of-setting-it-offe = Odprta je naloga »{ $title }«. Pri »{ $setting }« ponuja: { $list }. Za drugo izbiro zapustite nalogo.
the-cut-is-over-setting-is-set-for-the-whole = Rez je končan: nastavitev »{ $setting }« velja za ves obdelovanec, ki se reže znova od začetka. »Razveljavi« vrne prejšnji rez; sprememba med rezanjem deluje od tam naprej.
name-is-the-part-now-length-mm-long-air-mm-o = { $name } je zdaj obdelovanec: dolg { $length } mm, od tega { $air } mm zraka.
title-is-taken-as-the-kind-of-this-cut = { $title } je prevzeto za ta rez ({ $kind })

## src/app/session/disturb.rs

no-kind-at-place-the-cut-goes-from-0-to-end-2 = Motnje ({ $kind }) pri { $place } ni mogoče vstaviti: rez gre od 0 do { $end }. Najprej pojdite nazaj v času ali jo postavite na obdelovanec.
what-undo-takes-it-back = { $what }. »Razveljavi« to prekliče.
what-behind-the-tool-the-cut-is-done-again-u = { $what }, za orodjem: rez se ponovi. »Razveljavi« to prekliče.
kind-at-place = { $kind } pri { $place }
kind-at-place-size = { $kind } pri { $place }: { $size }
kind-at-place-over-length = { $kind } pri { $place }: na dolžini { $length }
kind-at-place-size-over-length = { $kind } pri { $place }: { $size } na dolžini { $length }

## src/app/session/foreign.rs

what-was-opened-brings-a-controller-s-script = Odprto prinaša lasten skript regulatorja, { $n } bajtov: ne teče, dokler ne pritisnete Predvajaj. Prebrati ga je mogoče pod Skript.

## src/app/session/hand/drive.rs

there-is-no-way-of-control-id = Regulatorja `{ $id }` ni.
wanted-is-refused-the-override-cnc-override = { $wanted } % je zavrnjeno: korekcija (cnc.override_min_percent) se konča pri { $end } %.
wanted-is-refused-the-override-cnc-override-2 = { $wanted } % je zavrnjeno: korekcija (cnc.override_max_percent) se konča pri { $end } %.
wanted-is-refused-the-scale-of-the-panel-end = { $wanted } % je zavrnjeno: skala pulta se konča pri { $end } %.
the-cut-is-over-cut-by-hand-begins-it-again-2 = Rez je končan: »Reži ročno« ga začne znova.
you-have-the-feed-undo-gives-it-back-to-befo = Podajanje vodite vi. Razveljavi ga vrne: { $before }.
no-controller-had-the-feed-in-this-cut = V tem rezu podajanja ni vodil noben regulator.

## src/app/session/hand.rs

t-0-to-120-as-on-a-panel = 0 do 120 %, kot na pultu
to-120-as-on-a-machine-s-panel = Do 120 %, kot na pultu stroja.
as-far-as-controllers-may = kolikor smejo regulatorji
as-far-as-the-override-of-the-cnc-goes-which = Kolikor sega korekcija CNC, ki jo smejo uporabiti regulatorji.

## src/app/session/mishap.rs

nothing-has-gone-wrong-so-far-no-tooth-broke = Doslej ni šlo nič narobe: noben zob se ni zlomil, nič ni ustavilo podajanja, nobena površina ni izmet.

## src/app/session/safe.rs

constant-feed-2 = stalno podajanje
const = stalno
feeds-mm-min-at-speed-1-min = { $feeds } mm/min pri { $speed } 1/min
safe-feed-from-start-at = varno podajanje od začetka: { $at }
safe-constant-feed-at = varno stalno podajanje: { $at }
safe-constant-feed-finding = varno stalno podajanje: iskanje …
constant-feed-as-programmed-at = stalno podajanje, kot programirano: { $at }
none-is-safe-constant-feed-as-programmed-at = nobeno ni varno; stalno podajanje, kot programirano: { $at }
name-finding = { $name }: iskanje …
name-none-is-safe-at = { $name }, varnega ni: { $at }
the-cut-is-compared-with-constant-feed-as-pr = Rez se zdaj primerja s programiranim stalnim podajanjem: { $why }.
the-cut-is-compared-with-a-safe-constant-fee = Rez se spet primerja z varnim stalnim podajanjem.

## src/app/session.rs

left-out-first = Izpuščeno: { $first }
left-out-and-more-more-first = Izpuščeno (in še { $more }): { $first }
the-change-that-came-later-in-the-cut-is-gon = Sprememba, ki je prišla pozneje v rezu, je odstranjena: od tu naprej se reže na novo. Razveljavi jo vrne.
the-change-of-the-same-setting-during-the-cu = Sprememba iste nastavitve med rezom je odstranjena: nova vrednost velja za ves rez. Razveljavi jo vrne.
n-changes-that-came-later-in-the-cut-are-gon = Spremembe, ki so prišle pozneje v rezu ({ $n }), so odstranjene: od tu naprej se reže na novo. Razveljavi jih vrne.
n-changes-of-the-same-settings-during-the-cu = Spremembe istih nastavitev med rezom ({ $n }) so odstranjene: nove vrednosti veljajo za ves rez. Razveljavi jih vrne.

## src/app/shortcuts/named.rs

ctrl-key = Ctrl
shift-key = Shift
left-key = Levo
right-key = Desno
up-key = Gor
down-key = Dol
space-key = preslednica
home-key = Home
end-key = End
pageup-key = Page Up
pagedown-key = Page Down
backspace-key = vračalka

## src/app/shortcuts/sheet.rs

this-sheet = Ta seznam
close-what-lies-on-top = Zapri, kar je na vrhu
tab-enter = Tab, Enter
the-next-control-press-it-or-end-a-number = Naslednji element; pritisk nanj ali konec vnosa števila
arrow-keys = Smerne tipke
move-the-slider-or-turn-the-knob-that-has-th = Premakni drsnik ali zavrti gumb, ki je izbran
wheel-or-a-drag-around = Kolesce ali poteg naokoli
turn-the-operator-s-knob-under-the-pointer = Zavrti operaterjev gumb pod kazalcem
double-click-on-a-plot = Dvoklik na graf
drag-on-a-plot = Poteg po grafu
zoom = Povečava
right-click-on-a-setting = Desni klik na nastavitev
back-to-its-default = Nazaj na privzeto
swipe = Poteg s prstom
scroll-wherever-it-begins = Drsenje po strani, kjer koli se poteg začne
drag-across = Vodoraven poteg
move-a-slider-or-a-number = Premakni drsnik ali število
drag-around = Poteg naokoli
turn-the-operator-s-knob = Zavrti operaterjev gumb
pinch-a-plot = Ščip na grafu
double-tap-a-plot = Dvojni dotik grafa
long-press = Dolgi pritisk
what-it-means-the-menu-of-a-setting = Kaj pomeni; meni nastavitve
the-first-screens-the-others-by-their-tabs = Prvi zasloni; drugi z njihovimi zavihki
the-screens = Zasloni
version-number = Različica { $number }
windows-and-lists-come-without-gliding-the-m = Okna in seznami se odpirajo brez drsenja; mase stroja mirujejo, dokler jih ne poženete. Rez teče naprej: ustavi ga preslednica.
fingers = Prsti
keys = Tipke
esc-then-tab = Esc, nato Tab
out-of-the-console-to-the-browser = Iz programa v brskalnik
the-browser-s-own-the-page-before = V brskalniku: prejšnja stran

## src/app/shortcuts.rs

drop-a-hard-spot-into-the-cut = Vstavi trdo mesto v rez
drop-a-gap-into-the-cut = Vstavi vrzel v rez
drop-a-depth-step-into-the-cut = Vstavi stopnico globine v rez
let-the-wear-jump = Povzroči skok obrabe
break-a-tooth = Zlomi zob
drop-a-burst-of-chatter-into-the-cut = Vstavi izbruh drdranja v rez
let-the-sensor-drop-out = Povzroči izpad senzorja
let-the-sensor-drift = Povzroči lezenje senzorja
make-the-dead-time-longer-for-a-while = Za nekaj časa podaljšaj mrtvi čas
turn-the-override-by-hand-for-a-while = Za nekaj časa ročno zavrti korekcijo
drive-the-cut-by-hand-the-operator-s-knob-on = Vodi rez ročno: operaterjev gumb vključen ali izključen
turn-the-operator-s-knob-up = Zavrti operaterjev gumb navzgor
turn-the-operator-s-knob-down = Zavrti operaterjev gumb navzdol
turn-the-operator-s-knob-far-up = Zavrti operaterjev gumb precej navzgor
turn-the-operator-s-knob-far-down = Zavrti operaterjev gumb precej navzdol
back-to-before-it-went-wrong = Nazaj, preden je šlo narobe
apply-from-the-start = Uveljavi od začetka
play-or-pause-after-the-end-again = Predvajaj ali ustavi; po koncu: znova
one-control-sample-on = En regulacijski vzorec naprej
one-control-sample-back = En regulacijski vzorec nazaj
t-1-s-on = 1 s naprej
t-1-s-back = 1 s nazaj
t-0-1-s-on = 0,1 s naprej
t-0-1-s-back = 0,1 s nazaj
to-the-start = Na začetek
find-a-setting-scenario-screen-command-or-wo = Najdi nastavitev, scenarij, zaslon, ukaz ali besedo
open-a-scenario-file = Odpri datoteko scenarija
export-all-signals-as-csv = Izvozi vse signale kot CSV
copy-a-link-to-this-state = Kopiraj povezavo do tega stanja

## src/app/speaker/native.rs

this-computer-has-no-sound-output = ta računalnik nima zvočnega izhoda
the-sound-output-cannot-be-used-error = zvočnega izhoda ni mogoče uporabiti: { $error }
the-sound-output-takes-only-kind-samples = zvočni izhod sprejema samo vzorce { $kind }
the-sound-output-has-failed-error = zvočni izhod je odpovedal: { $error }

## src/app/speaker/page.rs

the-browser-gives-no-sound-output-said = brskalnik ne da zvočnega izhoda { $said }

## src/app/speaker/piped.rs

no-player-was-found-pacat-pulseaudio-pw-cat = predvajalnika ni bilo mogoče najti: pacat (PulseAudio), pw-cat (PipeWire) ali aplay (ALSA; Debian: apt install alsa-utils)
the-sound-system-s-player-has-ended-is-there = predvajalnik zvočnega sistema se je končal: ali obstaja zvočni izhod?

## src/app/timeline.rs

again-from-the-start = Znova od začetka
again-from-the-start-with-the-change-at-its = Znova od začetka, s spremembo ob njenem času
again-from-the-start-with-n-changes-at-their =
    { $n ->
        [one] Znova od začetka, z { $n } spremembo ob njenem času
        [two] Znova od začetka, z { $n } spremembama ob njunih časih
        [few] Znova od začetka, s { $n } spremembami ob njihovih časih
       *[other] Znova od začetka, s { $n } spremembami ob njihovih časih
    }
restart = Znova
pause = Premor
pause-space = Premor (preslednica)
play = Predvajaj
play-space = Predvajaj (preslednica)
one-control-sample-on-keys = En regulacijski vzorec naprej{ $keys }
to-the-end-of-the-cut-end = Na konec reza (End)
end = Konec
plots-show-the-last-seconds-before-the-playh = Grafi kažejo zadnje sekunde pred časovnim kazalcem, na koncu pa vso simulacijo; sicer vedno vso.
follow = Sledi
target-not-held-share-in-tolerance = , cilj ni dosežen: { $share } v toleranci
play-again = Še enkrat
from-the-start-with-the-settings-at-the-play = Od začetka, z nastavitvami pri časovnem kazalcu kot lastnimi nastavitvami scenarija{ $keys }. Znova spremembe med rezom ponovi ob njihovih časih; to jih ne.
nothing-was-changed-during-the-cut-restart-d = Med rezom ni bilo nič spremenjeno: Znova naredi isto
back-to-2-s-before-the-last-broken-tooth-sto = Nazaj na 2 s pred zadnjim zlomom zoba, ustavitvijo ali izmetom{ $keys }; naslednja sprememba se tam odcepi
max = maks.
speed-speed = Hitrost { $speed }
speed-of-the-playhead = Hitrost časovnega kazalca
space-does-the-same = Preslednica naredi isto
computing-percent = računa se, { $percent } %
held-2 = doseženo
not-held-2 = ni doseženo
share-in-tolerance = , { $share } v toleranci
target-held-share-in-tolerance = , cilj dosežen: { $share } v toleranci
reference-held-share-in-tolerance = , referenca dosežena: { $share } v toleranci
reference-not-held-share-in-tolerance = , referenca ni dosežena: { $share } v toleranci
target-held-share-in-tolerance-with-dynamics = , cilj dosežen: { $share } v toleranci z dinamiko
target-not-held-share-in-tolerance-with-dyna = , cilj ni dosežen: { $share } v toleranci z dinamiko
reference-held-share-in-tolerance-with-dynam = , referenca dosežena: { $share } v toleranci z dinamiko
reference-not-held-share-in-tolerance-with-d = , referenca ni dosežena: { $share } v toleranci z dinamiko
share-not-judged = , { $share } ni ocenjeno
unstable-3 = , nestabilno
chattered-2 = , drdralo
unstable-chattered = , nestabilno, drdralo
playhead-2 = Časovni kazalec
the-whole-run-drag-to-look-back = Vsa simulacija: povlecite za pogled nazaj
the-whole-run-drag-to-look-back-the-mark-is = Vsa simulacija: povlecite za pogled nazaj. Oznaka je sprememba med rezom
the-whole-run-drag-to-look-back-the-marks-ar =
    { $n ->
        [one] Vsa simulacija: povlecite za pogled nazaj. Oznaka kaže { $n } spremembo
        [two] Vsa simulacija: povlecite za pogled nazaj. Oznake kažejo { $n } spremembi
        [few] Vsa simulacija: povlecite za pogled nazaj. Oznake kažejo { $n } spremembe
       *[other] Vsa simulacija: povlecite za pogled nazaj. Oznake kažejo { $n } sprememb
    }
help-percent-is-computed-the-line-below = { $help }. { $percent } % je izračunano: črta spodaj

## src/app/widgets/chart/content.rs

it-is-drawn-at-the-same-place-of-the-part-it = Narisan je na istem mestu obdelovanca: njegove stopnice in spremembe pridejo tam kot pri rezu. Premika se z drugim podajanjem, zato je do tja potreboval drug čas. Katero stalno podajanje je, piše v Več nastavitev, pod tem, s čim se primerja.
the-same-part-cut-at-the-programmed-feed-wit-3 = Isti obdelovanec s programiranim podajanjem, brez regulatorja: kar članki imenujejo običajno in kar regulator Običajno (stalno podajanje) reže pri 100 %.
the-same-part-cut-without-a-controller-at-th-2 = Isti obdelovanec brez regulatorja, z največjim stalnim podajanjem, ki ni nikjer nad toleranco: kdor jo mora držati povsod, izbere podajanje po najglobljem in najtršem mestu. Najdeno z rezanjem pri številnih podajanjih. Regulator Običajno (stalno podajanje) pa reže s programiranim podajanjem, kot običajno frezanje v člankih.
the-largest-constant-feed-that-is-nowhere-ab = Išče se največje stalno podajanje, ki ni nikjer nad toleranco: obdelovanec se reže pri številnih podajanjih.
the-same-part-cut-at-the-programmed-feed-wit-2 = Isti obdelovanec s programiranim podajanjem, brez regulatorja: { $why }.
ra-and-force-are-drawn-without-dynamics = Ra in sila sta narisana brez dinamike.
before = prej
the-run-as-it-went-on-before-the-last-change = Simulacija, kot je tekla pred zadnjo spremembo.
its-thin-line-is-that-with-dynamics-of-ra-an = Njegova tanka črta je tista z dinamiko, za Ra in za silo.
your-hand = vaša roka
the-same-part-as-you-cut-it-last-by-hand-dra = Isti obdelovanec, kot ste ga nazadnje rezali ročno, narisan na istih mestih obdelovanca.
from-now-on = od zdaj naprej
what-the-run-does-after-the-last-change-ahea = Kaj počne simulacija po zadnji spremembi, pred časovnim kazalcem.

## src/app/widgets/chart/reading.rs

signal-at-the-playhead-value = { $signal } pri časovnem kazalcu: { $value }

## src/app/widgets/chart.rs

chart-from-from-to-to = { $chart } od { $from } do { $to }
all-plots = vsi grafi

## src/app/widgets/drop.rs

drop-disturbance = Vstavi: { $disturbance }

## src/app/widgets/knob.rs

feed-override-by-hand = Ročna korekcija podajanja
turn-it-by-a-drag-around-it-by-the-wheel-or = Zavrtite ga s potegom naokoli, s kolescem ali prstom; + in -, Page Up in Page Down ga vrtijo od koder koli

## src/app/widgets/legend.rs

lines-of-title = Črte: { $title }
show-this-line = Pokaži to črto
hide-this-line = Skrij to črto

## src/app/widgets/my_files.rs

cutters-materials-machines-structures-parts = Lastna frezala, materiali, stroji, strukture, obdelovanci, skripti in drugo: uporaba, hranjenje, nove datoteke
my-files-2 = Moje datoteke…

## src/app/widgets/number.rs

allowed-is-a-number-from-min-to-max-unit = dovoljeno je število od { $min } do { $max } { $unit }
name-text-is-not-a-number-allowed-2 = { $name }: „{ $text }“ ni število: { $allowed }
name-text-was-limited-to-taken-allowed-2 = { $name }: „{ $text }“ je omejeno na { $taken }: { $allowed }

## src/app/widgets/save_table.rs

afc-log = dnevnik AFC
changed-conditions = spremenjeni pogoji
comparison = primerjava
front = fronta
load-step = stopnica obremenitve
passes = prehodi
plan-2 = načrt
table-paper = preglednica { $paper }
claim-paper = trditev { $paper }
deviations-paper = odstopanja { $paper }
calibrations-paper-2 = umeritve { $paper }
save-table-as-csv = Shrani kot CSV: { $table }
there-is-no-row-yet = Vrstic še ni
name-not-whole-yet-done = { $name }, še ni cela: { $done }
the-table-is-not-whole-yet-done-the-name-of = Tabela še ni cela: { $done }. Tako povesta tudi ime datoteke in njen stolpec »Partial«.

## src/app/widgets/setting/formula.rs

typed-in-the-console = vtipkano v pultu
range-of-input-text-is-not-a-number = območje za { $input }: `{ $text }` ni število
range-of-input-low-is-not-below-high = območje za { $input }: { $low } ni pod { $high }
change = Spremeni
type = Vtipkaj
write-the-formula-and-the-ranges-of-its-inpu = Vpis formule in območij njenih vhodov
a-file-of-a-formula-s-model-as-steadycut-for = Datoteka modela formule, kot jo zapiše `steadycut formula --save`
the-built-in-model-again = Spet vgrajeni model
a-number = število
input-low-to-high-unit = { $input } { $low } do { $high } { $unit }
unit-of-meaning = { $unit } ({ $meaning })
formula-setting = Formula: { $setting }
from = od
to = do
gives-low-to-high-unit-there = tam da { $low } do { $high } { $unit }
use = Uporabi
from-now-on-in-the-running-cut-too = Odslej, tudi v tekočem rezu
cancel = Prekliči
as-it-was-before = Kot je bilo prej

## src/app/widgets/setting/script.rs

begin-from = Začni iz
it-can-be-read-it-runs-once-it-is-used = Berljiv je; teče, ko ga uporabite.
it-runs-at-most-n-steps-in-a-control-period = Teče: največ { $n } korakov v regulacijski periodi.
use-this-script = Uporabi ta skript
in-the-running-cut-from-here-on-with-a-state = V tekočem rezu od tu naprej, z lastnim stanjem
discard = Zavrzi

## src/app/widgets/setting/structured.rs

begin-with-those-of-the-start-again = Spet začni s tistimi iz začetka
remove-setting = Odstrani: { $setting }
column-of-row-number = { $column }: { $row } { $number }
remove-row-number = Odstrani: { $row } { $number }
add-a-row = Dodaj: { $row }
the-same-for-every-each = enako za vse ({ $each })
remove-setting-of-each-number = Odstrani: { $setting }, { $each } { $number }
add-one-for-each-number = Dodaj za { $each } { $number }
t-1-cut = 1 rez
n-cuts =
    { $n ->
        [one] { $n } rez
        [two] { $n } reza
        [few] { $n } rezi
       *[other] { $n } rezov
    }

## src/app/widgets/setting.rs

reset-to-default-unit = Ponastavi na { $default } { $unit }
locked = Zaklenjeno
not-used-now-because = Zdaj ni v uporabi: { $because }.
allowed-allowed = Dovoljeno: { $allowed }.
acts-at-once-also-during-the-cut = deluje takoj, tudi med rezom
belongs-to-the-set-up = spada k pripravi

## src/app/widgets/standing.rs

the-best = najboljše
to-be-looked-at = velja preveriti
not-as-it-should-be = ni, kot mora biti

## src/app/widgets/target.rs

iso-1302-grade-grade-ra-ra-um-m = ISO 1302, razred { $grade }: Ra { $ra_um } µm

## src/app/widgets/window.rs

close-window = Zapri okno

## src/disk/own_folder.rs

folder-the-path-is-no-plain-text = { $folder }: pot ni navadno besedilo
folder-allowed-is-a-path-from-the-root-on-as = { $folder }: dovoljena je pot od korena naprej, kot { $root }…
folder-there-is-no-such-folder = { $folder }: take mape ni
the-choice-of-the-folder-is-not-kept-why = izbira mape se ni shranila: { $why }
folder-it-is-no-folder = { $folder }: to ni mapa
there-are-more-than-n-entries-in-this-folder = V tej mapi je več kot { $n } vnosov: drugi niso pregledani.
its-name-is-no-text = njeno ime ni besedilo
name-is-a-link-to-a-folder-which-is-not-foll = { $name } je povezava na mapo, ki ji program ne sledi.
name-lies-more-than-n-folders-deep-and-is-no = { $name } leži globlje kot { $n } map in ni pregledano.
there-are-n-files-in-this-folder-the-first-m = Datotek v tej mapi: { $n }; po imenu je naštetih prvih { $most }.
it-is-a-pipe-or-a-device-no-file = to je cev ali naprava, ne datoteka
each-channel-with-times-of-its-own = vsak kanal s svojimi časi
as-they-come = kakor so v datoteki
