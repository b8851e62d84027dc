# Texts of the program, written by its tests: see ARCHITECTURE.md.

## src/app/about.rs

steadycut-simulates-milling-whose-controller = SteadyCut simulates milling whose controller holds the roughness Ra, or the force, by feed and speed.

## src/app/bar.rs

mission-title = Mission: { $title }
mission-title-is-open-what-it-does-not-let-y = Mission “{ $title }” is open: what it does not let you change is locked
the-cut-stays-as-it-is-and-all-of-it-can-be = The cut stays as it is, and all of it can be changed again
leave = Leave
leave-the-mission = Leave the mission
task-hints-and-answer-of-the-mission-on-the = Task, hints and answer of the mission: on the screen Learn
back-to-the-mission = Back to the mission
screen-2 = Screen
screens-keys = Screens ({ $keys }, …)
files-undo-colours-keys-search = Files, undo, colours, keys, search
menu = Menu
find-a-setting-scenario-screen-command-or-wo-2 = Find a setting, scenario, screen, command or word{ $keys }
find = Find
what-this-is-keys-and-gestures = What this is; keys and gestures (?)
keys-and-gestures = Keys and gestures
language = Language
light-colours-right-click-as-the-system-has = Light colours; right-click: as the system has it
light = Light
dark-colours-right-click-as-the-system-has-i = Dark colours; right-click: as the system has it
dark = Dark
open = Open
open-a-scenario-file-one-can-also-be-dropped = Open a scenario file; one can also be dropped here
save = Save
save-the-scenario-with-its-edits = Save the scenario with its edits
save-csv = Save CSV
export-all-signals-of-the-run-as-csv = Export all signals of the run as CSV
link-2 = Link
copy-a-link-that-holds-scenario-and-edits-an = Copy a link that holds scenario and edits, and show it with its QR code, the command line that repeats the run, and the digest
undo = Undo
take-the-last-change-back = Take the last change back
redo = Redo
do-it-again = Do it again

## src/app/execute.rs

name-is-deleted = { $name } is deleted.
the-signals-are-those-up-to-until-the-cut-is = The signals are those up to { $until }: the cut is still being computed. The name of the file says so.
the-chosen-controller-has-no-networks-that-l = The chosen controller has no networks that learn.

## src/app/files/fallback.rs

no-file-dialog-is-available-drag-a-scenario = No file dialog is available: drag a scenario file onto the window, or start with `steadycut --scenario FILE`.

## src/app/files.rs

the-layout-is-remembered-for-files-like-it-b = The layout is remembered for files like it, but not beside this one: { $why }
steadycut-scenario = SteadyCut scenario
unks-networks = UNKS networks
table = Table
part-table-or-g-code = Part: table or G-code
measured-data = Measured data
saved-search = Saved search
model-of-a-formula = Model of a formula
kept-place = Kept: { $place }
name-is-kept-in-this-browser = { $name } is kept in this browser.
name-is-not-kept-why = { $name } is not kept: { $why }
no-file-dialog-is-available-type-the-path-of = No file dialog is available: type the path of the folder.
folder-a-page-has-no-folders = { $folder }: a page has no folders
my-files = My files
saved-as-name = saved as { $name }
not-saved-error = not saved: { $error }
no-file-dialog-is-available-and-name-could-n = No file dialog is available, and { $name } could not be written: { $error }
no-file-dialog-is-available-saved-as-path = No file dialog is available: saved as { $path }
saved-as-name-in-the-browser-s-downloads = saved as { $name } in the browser's downloads
the-browser-did-not-take-name-for-download = the browser did not take { $name } for download
name-could-not-be-read-error = { $name } could not be read: { $error }
name-is-the-result-of-a-mission-steadycut-mi = { $name } is the result of a mission: steadycut mission check { $name } verifies it.
name-is-a-file-of-a-spreadsheet-save-it-ther = { $name } is a file of a spreadsheet: save it there as CSV, which can be opened and dropped here.

## src/app/format.rs

no-contact = no contact
outside-model = outside model
with-before-it-a-value-lies-outside-the-rang = With ≈ before it a value lies outside the range of its model: it is continued beyond what was measured.

## src/app/framed.rs

cannot-be-changed-it-is-locked = Cannot be changed: it is { $locked }.
locked-the-mission-title-does-not-open-it-le = Locked: the mission “{ $title }” does not open it. Leave the mission to change it.
the-address-that-this-was-opened-with-hides = The address that this was opened with hides other screens (hide:screens).
the-address-that-this-was-opened-with-hides-2 = The address that this was opened with hides the search (hide:find).
the-address-that-this-was-opened-with-hides-3 = The address that this was opened with hides files and links (hide:files).

## src/app/jobs/list.rs

t-1-job-at-work = 1 job at work
n-jobs-at-work = { $n } jobs at work
n-at-work = { $n } at work
t-1-job-stopped = 1 job stopped
n-jobs-stopped = { $n } jobs stopped
n-stopped = { $n } stopped
running-at-work-halted-stopped = { $running } at work, { $halted } stopped
jobs-both = jobs: { $both }
what-is-being-worked-out-also-beside-other-s = What is being worked out; also beside other screens
go-on-with-job = Go on with { $job }
goes-on-where-it-was-stopped = Goes on where it was stopped
stop-job = Stop { $job }
stands-still-what-is-found-stays-and-it-can = Stands still; what is found stays, and it can go on from here
stopped-at-progress-what-is-found-stays = stopped at { $progress }: what is found stays
progress-time-left = { $progress }, { $time } left

## src/app/library/folder.rs

name-remove-it-from-its-folder-as-any-other = { $name }: remove it from its folder, as any other file

## src/app/library/page.rs

the-browser-refuses-this-page-its-storage-no = the browser refuses this page its storage: no file is kept here
what-the-browser-has-kept-of-it-is-spoilt = what the browser has kept of it is spoilt
taken-kb-of-most-kb-are-taken-whoever-clears = { $taken } kB of { $most } kB are taken. Whoever clears the browser's data of this page removes these files: download what matters.
it-is-not-kept-any-more = it is not kept any more
it-has-size-kb-at-most-most-kb-of-a-file-are = it has { $size } kB: at most { $most } kB of a file are kept in a browser
n-files-are-kept-already-and-no-more-can-be = { $n } files are kept already, and no more can be: delete some first
taken-kb-of-most-kb-are-taken-and-it-has-siz = { $taken } kB of { $most } kB are taken, and it has { $size } kB: delete some first
the-browser-has-no-room-for-it-or-refuses-it = the browser has no room for it or refuses it; what is kept already is as it was

## src/app/library/present.rs

the-machine-has-the-papers-five-masses = the machine has the papers' five masses
it-is-not-kept-from-here = it is not kept from here
no-script-controls-this-cut = no script controls this cut

## src/app/library/window.rs

no-place-in-a-run-has-the-units-of-its-input = No place in a run has the units of its inputs and of its result.
the-result-of-a-mission-is-verified-by-stead = The result of a mission is verified by steadycut mission check.
take-it-for-a-model-of-plant-and-controller = Take it for a model of plant and controller
open-it-and-cut-it-from-its-start = Open it and cut it from its start
begin-it-on-the-screen-learn = Begin it, on the screen Learn
lay-it-over-the-plots = Lay it over the plots
cut-it-from-a-blank-on-the-screen-workpiece = Cut it from a blank, on the screen Workpiece
search-for-formulas-on-the-screen-identify = Search for formulas, on the screen Identify
use-it-in-the-present-cut-undo-takes-it-back = Use it in the present cut; Undo takes it back
there-is-no-place-for-files-here-the-system = There is no place for files here: the system names none.
files-that-this-browser-keeps-for-this-page = Files that this browser keeps for this page. Drop or open a file, then keep it here.
t-1-other-file-is-of-no-use-here-and-not-liste = 1 other file is of no use here and not listed.
n-other-files-are-of-no-use-here-and-not-lis = { $n } other files are of no use here and not listed.
cutters-materials-machines-parts-and-more-in = Cutters, materials, machines, parts and more in a folder of your own:
another-folder = Another folder…
it-is-read-every-two-seconds-while-this-wind = It is read every two seconds while this window is open
read-again = Read again
its-path = Its path
a-folder-that-is-there-enter-takes-it = a folder that is there; Enter takes it
being-read = Being read…
none-of-these-here-yet-kinds = None of these here yet: { $kinds }.
no-files-here-yet-begin-one-below-or-keep-on = No files here yet: begin one below, or keep one that you opened.
name-in-use = { $name }, in use
in-use = in use
delete-it-for-good = Delete it for good?
delete-it = Delete it
keep-it = Keep it
download = Download
delete = Delete…
take-it-for = Take it for
opened-from-elsewhere = Opened from elsewhere
begin-a-new-one = Begin a new one
a-file-in-which-every-entry-is-explained-not = A file in which every entry is explained; nothing is overwritten
keep-of-the-present-cut = Keep of the present cut

## src/app/library/work.rs

files = files

## src/app/link/code.rs

this-link-has-bytes-characters-and-a-qr-code = This link has { $bytes } characters, and a QR code holds { $most } at most: send the link itself.
qr-code-of-the-link = QR code of the link

## src/app/link.rs

link-to-this-state = Link to this state
link-to-this-mission = Link to this mission
the-link-is-in-the-clipboard = The link is in the clipboard.
the-link-s-part-from-on-is-in-the-clipboard = The link's part from # on is in the clipboard: append it to the address of SteadyCut's web page.
there-is-no-clipboard-here-copy-the-link-by = There is no clipboard here. Copy the link by hand (Ctrl+C, or a long press):
the-command-line-is-in-the-clipboard = The command line is in the clipboard.
there-is-no-clipboard-here-copy-the-command = There is no clipboard here. Copy the command line by hand (Ctrl+C, or a long press):
command-line = Command line
the-cut-has-changed-since-all-this-is-of-the = The cut has changed since: all this is of the cut as it was.
take-a-new-link = Take a new link
repeats-the-run-on-the-command-line = Repeats the run on the command line:
it-comes-to-the-digest = It comes to the digest
the-digest-comes-here-once-the-cut-is-worked = The digest comes here once the cut is worked out to its end.
it-was-changed-before-it-was-worked-out-to-i = It was changed before it was worked out to its end: no digest.
copy-the-command-line = Copy the command line
copy-the-link = Copy the link
for-a-qr-code-the-address-of-a-page-with-ste = For a QR code: the address of a page with SteadyCut on it
allowed-is-an-address-that-begins-with-https = Allowed is an address that begins with https:// or http://, without #.
make-the-code = Make the code
save-as-svg = Save as SVG
save-as-png = Save as PNG

## src/app/messages.rs

remove-this-message-it-stays-in-the-list-of = Remove this message; it stays in the list of messages
dismiss = Dismiss
what-was-said-so-far = What was said so far
messages = Messages
messages-the-newest-first = Messages, the newest first

## src/app/mirror/mod.rs

name-nothing-can-be-written-there = { $name }: nothing can be written there
this-is-not-shown-any-more = This is not shown any more.
from-least-to-most = from { $least } to { $most }
from-least-on = from { $least } on
up-to-most = up to { $most }
of-any-size = of any size
name-text-is-not-a-number-allowed-is-a-numbe-2 = { $name }: “{ $text }” is not a number: allowed is a number { $range }
name-text-is-not-in-its-range-allowed-is-a-n-2 = { $name }: “{ $text }” is not in its range: allowed is a number { $range }

## src/app/mod.rs

embed-screen-id-allowed-behind-screen-are-al = embed: `screen:{ $id }`: allowed behind screen: are { $allowed }

## src/app/native.rs

no-graphics-adapter-could-be-used-a-driver-f = No graphics adapter could be used. A driver for Vulkan is needed; without a graphics card, Mesa's software driver does (Debian, Ubuntu: apt install mesa-vulkan-drivers).
no-window-could-be-opened-a-display-is-neede = No window could be opened. A display is needed: on Linux, DISPLAY or WAYLAND_DISPLAY must be set, and X11 needs libxkbcommon-x11 (Debian, Ubuntu: apt install libxkbcommon-x11-0). Without a display, `xvfb-run steadycut` opens one that is not seen, and `steadycut run` needs none.
the-console-cannot-be-shown-problem = the console cannot be shown: { $problem }

## src/app/overlay/file.rs

text = Text
tabs-between-the-values = tabs between the values
semicolons-between-the-values = semicolons between the values
commas-between-the-values = commas between the values
blanks-between-the-values = blanks between the values
decimal-point = decimal point
decimal-comma = decimal comma
no-line-with-names = no line with names
names-in-line-line = names in line { $line }
units-in-line-line = units in line { $line }
values-from-line-line-on = values from line { $line } on
times-in-the-column-column = times in the column { $column }
rate-samples-in-a-second = { $rate } samples in a second
each-channel-with-times-of-its-own = each channel with times of its own
no-times = no times

## src/app/overlay/layouts.rs

what-was-said-for-a-file-with-the-same-colum = What was said for a file with the same columns does not go with this one: { $why }

## src/app/overlay/mod.rs

measured-name = measured: { $name }

## src/app/overlay/work.rs

steps = steps
and-n-more = { " " }and { $n } more
file-has-no-channel-name-it-has-channels = { $file } has no channel `{ $name }`: it has { $channels }.

## src/app/panels/console/afc.rs

adaptive-feed-control-teach-in-the-reference = Adaptive feed control: teach in the reference forces, set FMIN and FMAX, and read the log of the cut
the-set-up-was-changed-meanwhile-nothing-is = The set-up was changed meanwhile: nothing is taken over. Teach in again.
taught-in = Taught in.
taught-in-up-to-the-time-limit-the-part-is-l = Taught in up to the time limit; the part is longer.
not-taught-in-why = Not taught in: { $why }
teach-in-cuts-the-part-of-the-set-up-once-at = Teach-in cuts the part of the set-up once at the programmed feed, without the changes of this session, and keeps the peak force of each cut as its reference.
stop-the-teach-in = Stop the teach-in
teach-in-2 = Teach in
teach-in-3 = Teach-in
cut-number-feed-feed-force-of-reference-shar = Cut { $number }: feed { $feed }, { $force } of { $reference } ({ $share } %)
cut-number-feed-feed-force-no-reference = Cut { $number }: feed { $feed }, { $force }, no reference
teach-in-the-feed-stays-as-programmed = Teach-in: the feed stays as programmed.
off-for-this-cut-the-operator-has-turned-the = Off for this cut: the operator has turned the override down.
overload-the-force-stays-over-its-limit-with = Overload: the force stays over its limit with the feed at FMIN.
watching-fmin-and-fmax-are-100-the-feed-stay = Watching: FMIN and FMAX are 100 %, the feed stays as programmed.
out-of-the-cut-feed-in-the-air = Out of the cut: feed in the air.
the-feed-stands-at-fmin = The feed stands at FMIN.
the-feed-stands-at-fmax = The feed stands at FMAX.
the-feed-follows-the-force = The feed follows the force.
log = Log
done-of-n-cuts-done = { $done } of { $n } cuts done
cut = cut
number-of-the-cut = Number of the cut
ref-n = ref. N
reference-force-as-teach-in-has-found-it = Reference force, as teach-in has found it
teach-in-s = teach-in s
time-that-the-cut-takes-at-the-programmed-fe = Time that the cut takes at the programmed feed
control-s = control s
time-that-it-took = Time that it took
diff = diff. %
by-how-much-that-is-longer = By how much that is longer
peak-n = peak N
largest-measured-force = Largest measured force
least = least %
least-feed-of-the-programmed-one = Least feed, of the programmed one
overload = Overload
all = all

## src/app/panels/console/answer.rs

with-dynamics-error-within = with dynamics { $error } within
with-dynamics-error-outside = with dynamics { $error } outside
with-dynamics-error = with dynamics { $error }
too-short-yet = too short yet
too-short-to-judge = too short to judge
not-at-rest = not at rest
still-on-its-way = still on its way
force-swing = force ±{ $swing }
period-period-no-rest = period { $period }, no rest
no-ra = no Ra
not-judged = not judged
outside-the-model = outside the model
ra-outside-its-model = Ra outside its model
error-within = { $error } within
error-outside = { $error } outside
ra-swings-by-swing = Ra swings by ±{ $swing }
force-swings-by-swing = force swings by ±{ $swing }
unstable-2 = unstable
chattered = chattered
from-to-to-s-and-before = { $from } to { $to } s, and before
from-to-to-s = { $from } to { $to } s
the-band-is-band-here-the-2-of-the-textbooks = The band is ±{ $band } here: the 2 % of the textbooks, since no noise moves the force at rest.
the-band-is-band-here-the-2-of-the-textbooks-2 = The band is ±{ $band } here: the 2 % of the textbooks and { $noise } for what noise still moves the force by at rest.
what-is-held-swings-by-more-than-that-nothin = What is held swings by more than that: nothing settles here.
no-rest-band = no rest (±{ $band })
does-not-settle-band = does not settle (±{ $band })
force-rests-time = force rests { $time }
force-settles-in-time-band = force settles in { $time } (±{ $band })
force-steady = force steady
force-settles-at-once-band = force settles at once (±{ $band })
no-transient = no transient
jump-jump = jump { $jump }
jump-jump-no-overshoot = jump { $jump }, no overshoot
overshoot-size = overshoot { $size }
its-overshoot-size = its overshoot { $size }

## src/app/panels/console/bands.rs

at-a-limit = At a limit
outside-model-2 = Outside model
in-the-air-2 = In the air
override-on-its-way = Override on its way
over-the-afc-limit = Over the AFC limit
controller = Controller
disturbances = Disturbances
none-2 = none
none-now = none now
names-now = { $names } now
no = no
not-now = not now
now = now
names-not-now = { $names }, not now
feed-2 = feed
speed = speed
spindle = spindle

## src/app/panels/console/cards.rs

safe = safe
safe-feed = safe feed
share-over-scrap = { $share }, { $over } % scrap
ra-now = Ra now
ra-in-tolerance = Ra in tolerance
remaining-error = Remaining error
with-dynamics-in-tolerance = With dynamics in tolerance
error-without-dynamics = Error without dynamics
share-no-ra-model = { $share } % no Ra ({ $model })
share-outside-the-ra-model-model = { $share } % outside the Ra model ({ $model })
target-target = target { $target }
within-target-target = within target { $target }
over-rough-under-smoother = { $over } % rough, { $under } % smoother
of-the-length-cut = of the length cut
without-dynamics-share = without dynamics { $share }
share-rest-smoother = { $share }, rest smoother
time-of-cut = Time of cut
both-scrap-own-and-over = both scrap: { $own } and { $over } %
metal-removed = Metal removed
on-path-of-path = on { $path } of path

## src/app/panels/console/controls.rs

target = Target
workpiece = Workpiece
what-a-cut-costs = What a cut costs
nc-program = NC program
what-constant-feed-to-compare-with = What constant feed to compare with
cnc-and-dead-time = CNC and dead time
what-the-controller-believes = What the controller believes
noise = Noise
plant = Plant
own-formulas-of-the-models = Own formulas of the models
cutter = Cutter
wear-over-the-tool-s-life = Wear over the tool's life
feed-drive = Feed drive
spindle-drive = Spindle drive
machine = Machine
sound-and-tool-life = Sound and tool life
roughness-profile-2 = Roughness profile
off-line-plan = Off-line plan
run-2 = Run
name = Name
edit-depths = Edit depths…
the-depth-from-which-on-this-machine-chatter = The depth from which on this machine chatters, over the speed: on the screen Machine
limit-depth-2 = Limit depth…
the-forces-on-the-tool-at-28-8-khz-over-the = The forces on the tool at 28.8 kHz over the last turns before the playhead
within-a-revolution = Within a revolution…
operator-2 = Operator…
more-settings = More settings
a-measured-file-over-the-plots-text-matlab-h = A measured file over the plots: text, MATLAB, HDF5, TDMS or Parquet. It can also be dropped here.
measured-data-2 = Measured data…
scenario-changed = { $scenario }, changed
scenario-scenario = Scenario: { $scenario }
scenario = Scenario
the-shipped-scenarios = The shipped scenarios
the-cut-of-the-mission-title-its-task-is-on = The cut of the mission “{ $title }”; its task is on the screen Learn.
as-shipped-about = As shipped: { $about }
without-the-changes-made-in-the-cut-about = Without the changes made in the cut: { $about }

## src/app/panels/console/disturb.rs

drops-a-disturbance-into-the-cut-a-little-ah = Drops a disturbance into the cut, a little ahead of the tool; Undo takes it back
names-and-sizes-of-disturbances = Names and sizes of disturbances
disturb-the-cut = Disturb the cut…
disturb-the-cut-2 = Disturb the cut
a-press-on-a-name-drops-that-disturbance-a-l = A press on a name drops that disturbance a little ahead of the tool, as long and as large as set beside it.
length-of-the-disturbance = Length of the { $disturbance }
mm-long = { " " }mm long
size-of-the-disturbance = Size of the { $disturbance }
least-to-most = { $least } to { $most }

## src/app/panels/console/headline.rs

finding = finding …
axial-depth-times-radial-depth-summed-over-t = Axial depth times radial depth, summed over the path.
without-none = without: none
without-outside-its-model = without: outside its model
without-ra = without { $ra }
in-twin-ra = In { $twin }: { $ra }.
roughness-produced-at-the-playhead-with-the = Roughness produced at the playhead, with the marks of the machine's vibration: as it should be within { $percent } % of the target. Without is Ra by the model of the cut alone, which a controller holds. { $beside }
roughness-produced-at-the-playhead-as-it-sho = Roughness produced at the playhead: as it should be within { $percent } % of its target.
swings-target-target = swings, target { $target }
above-target-target = above target { $target }
below-target-target = below target { $target }
ra-with-dynamics = Ra with dynamics
force-without-dynamics = Force without dynamics
judged-without-dynamics = judged without dynamics
the-steady-state-error-how-far-ra-or-the-for-2 = The steady-state error: how far Ra, or the force where a force is held, comes to rest from its target after the last step, whether that, with what it still swings by, is within the tolerance; the settling time of the force, until it stays within a band around where it rests for good, and its overshoot beyond where it rests: the jump that the change itself makes is none. Unstable: feed and force swing without dying down; a cut that did so is not called good later on.{ $band }
in-the-air-reference-force = in the air, reference { $force }
above-reference-force = above reference { $force }
within-reference-force = within reference { $force }
below-reference-force = below reference { $force }
with-dynamics-force = with dynamics { $force }
force-now = Force now
maximum-force-at-the-playhead-without-dynami = Maximum force at the playhead, without dynamics: as it should be within { $percent } % of its reference.
outside-the-ra-model-model = outside the Ra model ({ $model })
force-in-tolerance = Force in tolerance
share-of-the-cut-length-on-which-the-produce = Share of the cut length on which the produced Ra lies within the tolerance around its target. Outside it is too rough, which is scrap, or smoother than asked, which is none. Where Ra lies outside its model it is not judged: it is neither within nor outside.
share-of-the-cut-length-on-which-ra-with-dyn = Share of the cut length on which Ra with dynamics, which is what is left on the part, lies within the tolerance around the target. Outside it is too rough, which is scrap, or smoother than asked, which is none. Where Ra lies outside its model it is not judged.
share-of-the-cut-length-on-which-the-maximum = Share of the cut length on which the maximum force lies within the tolerance around its reference.
so-far-sides = So far: { $sides }.
in-twin-sides = In { $twin }: { $sides }.
over-too-rough-under-smoother = { $over } % too rough, { $under } % smoother
over-above-under-below = { $over } % above, { $under } % below
share-smoother-no-scrap = { $share } % smoother, no scrap
share-below-no-scrap = { $share } % below, no scrap
share-too-rough = { $share } % too rough
share-above = { $share } % above
share-rest-below = { $share }, rest below
worst-force-deviation = Worst force deviation
largest-deviation-of-the-force-from-the-desi = Largest deviation of the force from the desired force after the first second.
from-desired-force = from desired force
as-long = as long
saves-percent = saves { $percent } %
percent-longer = { $percent } % longer
twin-took-for-the-same-length-of-path-time-l = { $twin }: { $took } for the same length of path, { $time } lost.
twin-took-for-the-same-length-of-path-time-s = { $twin }: { $took } for the same length of path, { $time } saved.
twin-took-not-compared-why = { $twin }: { $took }, not compared: { $why }.
it-is-compared-with-the-programmed-feed-sinc = It is compared with the programmed feed, since { $why }.
time-since-the-start-of-the-cut-told-times-a = Time since the start of the cut. { $told } Times are compared only where both hold the target: above the tolerance on at most { $percent } % of the length. A faster cut that is scrap is no gain; a surface that is smoother than asked is no scrap.{ $none_safe }
twin-over-scrap = { $twin }: { $over } % scrap
twin-over-above = { $twin }: { $over } % above
this-cut-over-scrap = this cut: { $over } % scrap
this-cut-over-above = this cut: { $over } % above
both-above-own-and-over = both above: { $own } and { $over } %
this-cut-share-not-judged = this cut: { $share } % not judged
twin-share-not-judged = { $twin }: { $share } % not judged
nothing-is-cut-yet = nothing is cut yet
neither-is-scrap = neither is scrap
most-is-scrap = ≤ { $most } % is scrap

## src/app/panels/console/measured/layout.rs

search-for-formulas-in-it = Search for formulas in it
as-they-come = as they come
record = Record
none-a-sample-rate = none: a sample rate
time-column = Time column
sample-rate = Sample rate
read-it-otherwise = Read it otherwise
entries-of-the-layout-as-the-command-steadyc = Entries of the layout as the command steadycut measured has them, with blanks between: encoding, separator, decimal, thousands, names_line, units_line, first_line, names, units. Enter reads the file again.
allowed-is-key-value = allowed is KEY=VALUE
as-you-said-for-a-file-with-the-same-columns = As you said for a file with the same columns: { $keys }.
as-the-file-name-beside-it-says-keys = As the file { $name } beside it says: { $keys }.
remembered-in-name-and-for-files-with-the-sa = Remembered in { $name }, and for files with the same columns: { $keys }.
remembered-for-files-with-the-same-columns-k = Remembered for files with the same columns: { $keys }.
read-it-as-it-is-guessed-and-forget-what-is = Read it as it is guessed, and forget what is remembered, beside the file as well
guess-again = Guess again
t-1-channel = 1 channel
n-channels = { $n } channels
channel = channel
samples = samples
least-2 = least
largest = largest

## src/app/panels/console/measured/place.rs

the-channel-is-being-worked-out = The channel is being worked out.
finds-the-shift-at-which-both-go-together-mo = Finds the shift at which both go together most, and there scale and offset, as steadycut measured does
align = Align
shift-0-s-scale-1-offset-0 = Shift 0 s, scale 1, offset 0
as-measured = As measured
shift = Shift
by-so-much-the-measurement-is-later-than-the = By so much the measurement is later than the run: it is drawn earlier by that
scale = Scale
the-run-times-this-is-what-was-measured-the = The run times this is what was measured: the line is drawn divided by it
scale-value-cannot-be-allowed-is-any-number = Scale: { $value } cannot be: allowed is any number but 0, of a size from { $least } on
offset-2 = Offset
what-the-measurement-has-in-addition-after-t = What the measurement has in addition, after the scale
not-aligned-why-it-can-be-moved-by-hand = Not aligned: { $why }. It can be moved by hand.
it-is-aligned-as-soon-as-the-cut-is-worked-o = It is aligned as soon as the cut is worked out.
it-has-nothing-in-common-with-the-cut-here = It has nothing in common with the cut here.
by-hand = by hand
aligned = aligned
how-what-is-left-rms-rest-over-samples-sampl = { $how }: what is left, rms { $rest } over { $samples } samples; correlation { $correlation }

## src/app/panels/console/measured/prepare.rs

preparation = Preparation
low-pass-filter-without-a-shift-in-time = Low-pass filter, without a shift in time
cut-off = Cut-off
zero-before-the-cut = Zero before the cut
before-the-cut = before the cut
drift-by-a-time-behind-the-cut = Drift, by a time behind the cut
behind-the-cut = behind the cut
turn-two-forces-into-the-machine-s-axes = Turn two forces into the machine's axes
force-x-of-the-dynamometer = Force x of the dynamometer
force-y-of-the-dynamometer = Force y of the dynamometer
angle-to-x = Angle to X
largest-force-across-the-tool-in-every-perio = Largest force across the tool in every period
force-along-x = Force along x
force-along-y = Force along y
period = Period
from-time = From, { $time }
to-time = To, { $time }

## src/app/panels/console/measured.rs

name-is-not-shown-there-are-most-measured-ch = { $name } is not shown: there are { $most } measured channels over the plots already. Remove one first.
unfold = Unfold
open-a-file = Open a file…
leaves-a-line-of-it-and-the-plots-in-sight = Leaves a line of it, and the plots in sight
fold-to-a-line = Fold to a line
text-of-any-layout-matlab-hdf5-tdms-or-parqu = Text of any layout, MATLAB, HDF5, TDMS or Parquet; a file can also be dropped onto the plots.
no-part-of-the-scenario-neither-a-file-nor-a = No part of the scenario: neither a file nor a link holds it. Changes of the cut leave it where it is, until it is removed or the program is closed.
remove = Remove
channel-2 = Channel
laid-over = Laid over
as-it-is-not-converted = as it is, not converted
its-unit = Its unit
show-it = Show it
another-channel-of-this-file = Another channel of this file
drive-forces-structure-noise-wear-or-materia = Drive, forces, structure, noise, wear or material of this file, on the screen Identify
fit-settings-to-it = Fit settings to it
channel-over-signal-more = { $channel } over { $signal }{ $more }

## src/app/panels/console/mod.rs

least-override = Least override
largest-override = Largest override
roughness = Roughness
force-2 = Force
feed = Feed
spindle-speed = Spindle speed
override-2 = Override
depth-of-cut = Depth of cut
console = Console
start-home-plots-run-simulation-digest = start home plots run simulation digest
settings = Settings

## src/app/panels/console/operator/figures.rs

mm-min-of-feed = mm/min, of { $feed }
t-1-min-of-speed = 1/min, of { $speed }
mm-min-programmed-feed = mm/min, programmed { $feed }
t-1-min-programmed-speed = 1/min, programmed { $speed }
sent-to-the-machine = sent to the machine
place-in-the-cut = Place in the cut
mm-of-length = mm of { $length }
the-part-the-tool-is-at-place-depth-deep = The part: the tool is at { $place }, { $depth } deep
the-machine-is-paused = The machine is paused.
feeding-not-in-the-cut = Feeding, not in the cut.
cutting = Cutting.
cutting-force-2 = Cutting force
mark-force-n = mark: { $force } N
mark-force-n-which-ra-target-asks-for = mark: { $force } N, which Ra { $target } asks for
mark-force-n-which-is-to-be-held = mark: { $force } N, which is to be held
force-n-stops-the-feed = { $force } N stops the feed
force-n-breaks-a-tooth = { $force } N breaks a tooth
no-force-stops-this-machine-setting-stop-on = No force stops this machine (setting: Stop on overload)
force-force-n-asked-for-asked-n-limit-limit = Force { $force } N, asked for { $asked } N, limit { $limit } N
force-force-n-asked-for-asked-n = Force { $force } N, asked for { $asked } N

## src/app/panels/console/operator/mod.rs

cut-by-hand = Cut by hand
you-hold-the-feed-override-a-knob-what-an-op = You hold the feed override: a knob, what an operator sees and hears, and a score against every controller afterwards
operator = Operator
from-the-start-of-the-part-without-a-control = From the start of the part, without a controller and at 100 %
plots-settings-and-sentences-beside-the-knob = Plots, settings and sentences beside the knob, which an operator does not have
whole-console = Whole console
back-to-the-console-the-cut-goes-on-as-it-is = Back to the console; the cut goes on as it is{ $keys }

## src/app/panels/console/operator/panel.rs

drag-around-it-wheel-and-page-up-and-down = Drag around it, wheel, + and -, Page Up and Down
override-percent-up = Override { $percent } % up
override-percent-down = Override { $percent } % down
the-cut-is-over = The cut is over
you-have-the-feed = You have the feed
controller-has-the-feed = { $controller } has the feed
give-it-back-to-controller = Give it back to { $controller }
give-it-back = Give it back
take-it = Take it
at-the-override-that-is-sent-now-a-turn-of-t = At the override that is sent now; a turn of the knob takes it as well
the-cut-is-over-cut-by-hand-begins-it-again = The cut is over: Cut by hand begins it again
scale-to = Scale to
as-on-a-machine-s-panel = As on a machine's panel
as-far-as-the-cnc-lets-a-controller-go = As far as the CNC lets a controller go
scale-to-percent = Scale to { $percent }

## src/app/panels/console/operator/score.rs

score-of-the-cut-by-hand = Score of the cut by hand
your-hand-against-every-controller = Your hand against every controller
your-last-cut-by-hand-against-every-controll = Your last cut by hand against every controller
the-same-part-and-noise-for-everybody-ranked = The same part and noise for everybody. Ranked by time is who holds the tolerance on { $percent } % of the length.
a-force-of-force-tolerance = a force of { $force } ± { $tolerance } %
everybody-else-cuts-the-same-part-now = Everybody else cuts the same part now.
this-cut-was-not-driven-by-hand-button-begin = This cut was not driven by hand. { $button } begins it from its start: turn the knob while it cuts.
asked-for-is-asked-hold-the-force-at-its-mar = Asked for is { $asked }. Hold the force at its mark: slower where the part gets deeper or harder, faster where it gets easier. The knob answers after the dead time. When the cut is over it is scored against every controller on the same part.
ra-in-tol = Ra in tol. %
force-in-tol = force in tol. %
rank = rank
by-time-among-those-who-hold-the-tolerance = By time, among those who hold the tolerance
who = who
your-hand-and-every-way-of-control = Your hand, and every way of control
share-of-the-length-on-which-what-is-asked-f = Share of the length on which what is asked for is held
time-s = time s
time-of-the-cut-none-if-it-did-not-come-to-i = Time of the cut; none if it did not come to its end
greatest-force = Greatest force
travel-s = travel %/s
way-of-the-feed-override-in-a-second = Way of the feed override in a second
cut-2 = Cut
cut-by-controller = Cut by { $controller }
cuts-the-part-this-way-with-your-hand-drawn = Cuts the part this way, with your hand drawn in the plots

## src/app/panels/console/revolution/plot.rs

before-the-last-change-the-new-picture-is-be = Before the last change; the new picture is being made.
peak-of-the-control-period = Peak of the control period
forces-from-from-to-to = Forces from { $from } to { $to }
n-samples-up-to-time-s = { $n } samples up to { $time } s
n-samples-up-to-time-s-peak-of-the-last-cont = { $n } samples up to { $time } s. Peak of the last control period (shaded): { $force } at { $angle }; with the sensor's noise it is what the controller sees.

## src/app/panels/console/revolution.rs

within-a-revolution-2 = Within a revolution
desired-force = Desired force
fxy-across-the-tool = Fxy, across the tool
fx-along-the-feed = Fx, along the feed
fy-across-the-feed = Fy, across the feed
fz-along-the-tool = Fz, along the tool
the-run-is-being-repeated-up-to-this-moment = The run is being repeated up to this moment.
t-1-turn = 1 turn
t-2-turns = 2 turns
angle = Angle
time = Time
save-these-samples-as-csv-time-angle-fx-fy-f = Save these samples as CSV: time, angle, Fx, Fy, Fz, Fxy
the-revolution = the revolution
the-force-was-not-simulated-tooth-by-tooth-a = The force was not simulated tooth by tooth at this moment of the run.
the-force-of-this-cut-is-the-maximum-that-a = The force of this cut is the maximum that a formula or a network gives.
to-look-into-a-revolution-the-force-has-to-b = To look into a revolution, the force has to be simulated tooth by tooth: the mechanistic model of the ball-end mill, at 28.8 kHz.
simulate-tooth-by-tooth = Simulate tooth by tooth
load-experiment-2 = Load Experiment 2
both-can-be-undone-the-first-keeps-this-scen = Both can be undone. The first keeps this scenario and changes its plant.

## src/app/panels/console/story.rs

a-burst-of-chatter-begins-here-3-times-over = A burst of chatter begins here: 3 times over 5.0 mm, imposed: safe constant feed leaves the tolerance (Ra 0.45 µm to 0.88 µm), the controller lowers the feed by 16.1 % (319 to 299 mm/min), raises the speed by 14.6 % and leaves the tolerance (Ra 0.77 µm to 1.23 µm). The remaining error is 51 % above the target Ra, about which Ra still moves by ±13.2 %; the law has no integral.
the-spindle-speed-command-stands-at-its-uppe-2 = The spindle speed command stands at its upper limit, 2500 1/min (150 % override), 60 % of this time: meanwhile Ra is 12.3 % above its target, outside the tolerance.
ahead-of-the-playhead-not-cut-yet-a-click-go = Ahead of the playhead, not cut yet: a click goes there
each-click-goes-to-the-next-of-them = Each click goes to the next of them.
remove-this-line-shows-it-again = Remove this line; `?` shows it again
close-the-introduction = Close the introduction
the-depths-and-speeds-at-which-this-machine = The depths and speeds at which this machine chatters, and the switch of its sound
stability-and-sound = Stability and sound

## src/app/panels/console/workpiece/hand.rs

tap-what-then-drag-its-dot = Tap { $what }, then drag its dot.
drag-what = Drag { $what }.
nothing-chosen = Nothing chosen
depth-number = Depth { $number }
end-of-number = End of { $number }
wall-number = Wall { $number }

## src/app/panels/console/workpiece/material.rs

material-even-noise-and-inhomogeneity-above-2 = Material: even. “Noise” and “Inhomogeneity” above 0 make it uneven, by the seed.
material-under-seed-seed-force-low-to-high-a = Material under seed { $seed }: force { $low } to { $high } along this cut
change-at-place = { $change } at { $place }

## src/app/panels/console/workpiece/picture.rs

depths-drawn-times-times-larger-than-lengths = depths drawn { $times } times larger than lengths
to-scale = to scale
from-the-side-axial-depths-in-mm-scale-help = From the side, axial depths in mm, { $scale }. { $help }
a-floor-or-an-end = a floor or an end
cut-from-the-side-depths = Cut from the side: { $depths }
a-wall = a wall
from-above-radial-depths-in-mm-help = From above, radial depths in mm. { $help }
cut-from-above-depths = Cut from above: { $depths }

## src/app/panels/console/workpiece/table.rs

no-2 = No.
duplicate-section-number = Duplicate section { $number }
remove-section-number = Remove section { $number }
length-mm-2 = Length mm
axial-mm = Axial mm
wall-mm = Wall mm
r-d-mm = R_D mm
length-of-section-number = Length of section { $number }
axial-depth-of-section-number = Axial depth of section { $number }
wall-of-section-number = Wall of section { $number }
add-a-section = Add a section
at-most-n-sections-in-a-cut = At most { $n } sections in a cut
wall-place-of-the-side-wall-across-the-cut-f = Wall: place of the side wall across the cut, from the tool's axis. R_D: from the wall to where the cutter meets the surface at that depth.
air = air
the-tool-meets-no-material-here = The tool meets no material here
stretch-number-why = Stretch { $number }: { $why }.
it-is-cut-and-its-depth-stays-a-change-of-it = it is cut, and its depth stays; a change of it would act where the tool is now
n-stretches-each-with-its-axial-and-its-radi = { $n } stretches, each with its axial and its radial depth
one-axial-and-one-radial-depth-along-the-who = One axial and one radial depth along the whole path, those of its start
take-the-profiles-away = Take the profiles away
from-mm = From mm
axial-depth-of-stretch-number = Axial depth of stretch { $number }
start-of-stretch-number = Start of stretch { $number }
remove-stretch-number = Remove stretch { $number }
add-a-stretch = Add a stretch

## src/app/panels/console/workpiece.rs

experiment-1 = Experiment 1
the-part-from-the-side-drag-its-depths-and-i = The part from the side: drag its depths and its ends, or type them in a table
cut-number-tool = Cut { $number }, tool
cut-number = Cut { $number }
at-most-n-cuts = At most { $n } cuts
add-a-cut = Add a cut
duplicate-cut-number = Duplicate cut { $number }
remove-cut-number = Remove cut { $number }
the-last-cut-stays-one-path-goes-without-cut-2 = The last cut stays: “One path” goes without cuts
these-depths-are-profiles-of-a-file-take-the = These depths are profiles of a file: take them away to drag a depth.
back-to-the-start = Back to the start
what-is-grey-is-cut-already-at-the-start-of = What is grey is cut already: at the start of the cut every stretch can be changed
the-tool-is-at-at-changed-depths-act-from-th = The tool is at { $at }: changed depths act from there and from now on. A stretch that begins before it holds only for what of it is still to be cut; what is cut stays.
the-cut-is-over-changed-depths-are-those-of = The cut is over: changed depths are those of the whole part, which is cut anew from its start.
still-to-be-cut = still to be cut
cut-already = cut already
the-tool-comes-in-from-the-air = the tool comes in from the air
tool-at-place = tool at { $place }
length-long-place = { $length } long, { $place }
take-the-part-of = Take the part of
takes-over-the-cuts-alone-the-scenario-of-th = Takes over the cuts alone; the scenario of this name also sets controller, noise and feed
one-straight-cut-with-this-path-s-depths-the = One straight cut with this path's depths, the tool coming in from the air
make-cuts-of-the-path = Make cuts of the path
no-cuts-the-path-with-its-length-depths-and = No cuts: the path with its length, depths and depth profile
one-path = One path

## src/app/playback.rs

as-fast-as-possible = as fast as possible

## src/app/search.rs

screen = screen
search-formulas-in-a-table-of-one-s-own = Search formulas in a table of one's own
open-a-part-of-one-s-own-table-or-g-code = Open a part of one's own: table or G-code
lay-measured-data-over-the-plots = Lay measured data over the plots
my-files-cutters-materials-machines-parts-an = My files: cutters, materials, machines, parts and more of one's own
fit-settings-to-measured-data = Fit settings to measured data
open-measured-data-to-fit-settings-to = Open measured data to fit settings to
go-on-with-a-saved-search-for-a-formula = Go on with a saved search for a formula
open-networks-of-unks = Open networks of UNKS
save-the-networks-of-unks = Save the networks of UNKS
light-colours = Light colours
dark-colours = Dark colours
colours-as-the-system-has-them = Colours as the system has them
large-type-for-a-projector = Large type, for a projector
type-of-the-usual-size = Type of the usual size
less-motion = Less motion
motion-as-usual = Motion as usual
identify-own-recording-measurements-drive-de = identify own recording measurements drive dead time lag step force coefficients kienzle run-out structure modes impact frequency response noise ripple wear taylor material hardness
load-toml-data-own = load toml data own
download-keep-toml = download keep toml
save-table-data-results-measurements-downloa = save table data results measurements download spreadsheet
qr-code-class-phone-digest-share-address-url = qr code class phone digest share address url command line terminal headless repeat reproduce send
identify-own-data-measured-measurements-csv = identify own data measured measurements csv upload import
workpiece-cam-nc-gcode-program-csv-depths-im = workpiece cam nc gcode program csv depths import own blank
own-data-measurements-csv-matlab-mat-tdms-la = own data measurements csv matlab mat tdms labview parquet hdf5 dynamometer channel overlay compare import
identify-resume-json = identify resume json
neural-learning-weights-json = neural learning weights json
help-about-introduction-keyboard-shortcuts-h = help about introduction keyboard shortcuts hotkeys touch swipe pinch finger
theme-contrast-mode = theme contrast mode
zoom-big-font-size-beamer-class-letters = zoom big font size beamer class letters
language-sprache-jezik-slovene-slovenian-ger = language sprache jezik slovene slovenian german deutsch en sl de
animation-reduced-accessibility-still = animation reduced accessibility still
back-retry-repeat-breakage-scrap-stop-crash = back retry repeat breakage scrap stop crash broken mishap rewind
playback-transport = playback transport
restart-repeat-from-the-start-rerun-begin-an = restart repeat from the start rerun begin anew keep settings
disturb-disturbance-fault-trouble-error-hurt = disturb disturbance fault trouble error hurt accident upset damage
operator-override-manual-hand-knob-panel-han = operator override manual hand knob panel handwheel wheel drive myself score beat
library-folder-tool-material-machine-structu = library folder tool material machine structure part script own keep catalogue kept
setting-scenario-screen-command-or-word = Setting, scenario, screen, command or word
type-a-word-dead-time-kp-chatter-noise-csv = Type a word: dead time, Kp, chatter, noise, CSV …
nothing-has-these-words-fewer-or-shorter-one = Nothing has these words. Fewer or shorter ones find more.
more-more-another-word-narrows-them-down = { $more } more: another word narrows them down.
in-group-path = in { $group }: { $path }
scenario-2 = scenario
command = command
control-by-controller = Control by { $controller }

## src/app/session/change.rs

locked-by-the-address-that-this-was-opened-w = locked by the address that this was opened with
no-other-scenario-is-opened-here-settings-ar = No other scenario is opened here: settings are locked by the address that this was opened with.
predict-first-the-cut-begins-as-soon-as-you = Predict first: the cut begins as soon as you have said what you expect, or gone on without a prediction.
name-is-open-it-is-cut-from-its-start = { $name } is open: it is cut from its start.
name-controls-this-cut-now = { $name } controls this cut now.
set-for-the-whole-cut-now-first-second-third = { " " }Set for the whole cut now: { $first }, { $second }, { $third }, { $more } more.
set-for-the-whole-cut-now-list = { " " }Set for the whole cut now: { $list }.
the-change-made-during-the-cut-is-not-repeat = The change made during the cut is not repeated; Undo brings it back.
the-n-changes-made-during-the-cut-are-not-re = The { $n } changes made during the cut are not repeated; Undo brings them back.
cut-from-its-start-names-of-edits = Cut from its start.{ $names } { $of_edits }
setting-cannot-be-changed-it-is-why = “{ $setting }” cannot be changed: it is { $why }.
the-mission-title-is-open-it-locks-all-setti = The mission “{ $title }” is open: it locks all settings, and so “{ $setting }”. Leave the mission to change it.
the-mission-title-is-open-and-locks-setting = The mission “{ $title }” is open and locks “{ $setting }”. It lets you change: { $open }. Leave the mission to change anything else.
the-mission-title-is-left = The mission “{ $title }” is left.
the-mission-title-is-open-of-setting-it-offe = The mission “{ $title }” is open. Of “{ $setting }” it offers: { $list }. Leave the mission to choose anything else.
the-cut-is-over-setting-is-set-for-the-whole = The cut is over: { $setting } is set for the whole part, which is cut anew from its start. Undo brings the cut of before back; a change while it is cut acts from there on.
name-is-the-part-now-length-mm-long-air-mm-o = { $name } is the part now: { $length } mm long, { $air } mm of it air.
title-is-taken-as-the-kind-of-this-cut = { $title } is taken as the { $kind } of this cut

## src/app/session/disturb.rs

no-kind-at-place-the-cut-goes-from-0-to-end-2 = No { $kind } at { $place }: the cut goes from 0 to { $end }. Go back in time first, or place it on the part.
what-undo-takes-it-back = { $what }. Undo takes it back.
what-behind-the-tool-the-cut-is-done-again-u = { $what }, behind the tool: the cut is done again. Undo takes it back.
kind-at-place = { $kind } at { $place }
kind-at-place-size = { $kind } at { $place }: { $size }
kind-at-place-over-length = { $kind } at { $place }: over { $length }
kind-at-place-size-over-length = { $kind } at { $place }: { $size } over { $length }

## src/app/session/foreign.rs

what-was-opened-brings-a-controller-s-script = What was opened brings a controller's script of its own, { $n } bytes: it is not run before you press Play. It can be read under Script.

## src/app/session/hand/drive.rs

there-is-no-way-of-control-id = There is no way of control `{ $id }`.
wanted-is-refused-the-override-cnc-override = { $wanted } % is refused: the override (cnc.override_min_percent) ends at { $end } %.
wanted-is-refused-the-override-cnc-override-2 = { $wanted } % is refused: the override (cnc.override_max_percent) ends at { $end } %.
wanted-is-refused-the-scale-of-the-panel-end = { $wanted } % is refused: the scale of the panel ends at { $end } %.
the-cut-is-over-cut-by-hand-begins-it-again-2 = The cut is over: “Cut by hand” begins it again.
you-have-the-feed-undo-gives-it-back-to-befo = You have the feed. Undo gives it back to { $before }.
no-controller-had-the-feed-in-this-cut = No controller had the feed in this cut.

## src/app/session/hand.rs

t-0-to-120-as-on-a-panel = 0 to 120 %, as on a panel
to-120-as-on-a-machine-s-panel = To 120 %, as on a machine's panel.
as-far-as-controllers-may = as far as controllers may
as-far-as-the-override-of-the-cnc-goes-which = As far as the override of the CNC goes, which controllers may use.

## src/app/session/mishap.rs

nothing-has-gone-wrong-so-far-no-tooth-broke = Nothing has gone wrong so far: no tooth broke, nothing stopped the feed, no surface is scrap.

## src/app/session/safe.rs

constant-feed-2 = constant feed
const = const.
feeds-mm-min-at-speed-1-min = { $feeds } mm/min at { $speed } 1/min
safe-feed-from-start-at = safe feed from start: { $at }
safe-constant-feed-at = safe constant feed: { $at }
safe-constant-feed-finding = safe constant feed: finding …
constant-feed-as-programmed-at = constant feed as programmed: { $at }
none-is-safe-constant-feed-as-programmed-at = none is safe; constant feed as programmed: { $at }
name-finding = { $name }: finding …
name-none-is-safe-at = { $name }, none is safe: { $at }
the-cut-is-compared-with-constant-feed-as-pr = The cut is compared with constant feed as programmed now: { $why }.
the-cut-is-compared-with-a-safe-constant-fee = The cut is compared with a safe constant feed again.

## src/app/session.rs

left-out-first = Left out: { $first }
left-out-and-more-more-first = Left out (and { $more } more): { $first }
the-change-that-came-later-in-the-cut-is-gon = The change that came later in the cut is gone: from here on it is cut anew. Undo brings it back.
the-change-of-the-same-setting-during-the-cu = The change of the same setting during the cut is gone: the new value holds for the whole cut. Undo brings it back.
n-changes-that-came-later-in-the-cut-are-gon = { $n } changes that came later in the cut are gone: from here on it is cut anew. Undo brings them back.
n-changes-of-the-same-settings-during-the-cu = { $n } changes of the same settings during the cut are gone: the new values hold for the whole cut. Undo brings them back.

## src/app/shortcuts/named.rs

ctrl-key = Ctrl (key)
shift-key = Shift (key)
left-key = Left (key)
right-key = Right (key)
up-key = Up (key)
down-key = Down (key)
space-key = Space (key)
home-key = Home (key)
end-key = End (key)
pageup-key = PageUp (key)
pagedown-key = PageDown (key)
backspace-key = Backspace (key)

## src/app/shortcuts/sheet.rs

this-sheet = This sheet
close-what-lies-on-top = Close what lies on top
tab-enter = Tab, Enter
the-next-control-press-it-or-end-a-number = The next control; press it, or end a number
arrow-keys = Arrow keys
move-the-slider-or-turn-the-knob-that-has-th = Move the slider or turn the knob that has the focus
wheel-or-a-drag-around = Wheel, or a drag around
turn-the-operator-s-knob-under-the-pointer = Turn the operator's knob under the pointer
double-click-on-a-plot = Double-click on a plot
drag-on-a-plot = Drag on a plot
zoom = Zoom
right-click-on-a-setting = Right-click on a setting
back-to-its-default = Back to its default
swipe = Swipe
scroll-wherever-it-begins = Scroll, wherever it begins
drag-across = Drag across
move-a-slider-or-a-number = Move a slider or a number
drag-around = Drag around
turn-the-operator-s-knob = Turn the operator's knob
pinch-a-plot = Pinch a plot
double-tap-a-plot = Double tap a plot
long-press = Long press
what-it-means-the-menu-of-a-setting = What it means; the menu of a setting
the-first-screens-the-others-by-their-tabs = The first screens; the others by their tabs
the-screens = The screens
version-number = Version { $number }
windows-and-lists-come-without-gliding-the-m = Windows and lists come without gliding; the masses of the machine stand until they are set in motion. The cut goes on: Space stops it.
fingers = Fingers
keys = Keys
esc-then-tab = Esc, then Tab
out-of-the-console-to-the-browser = Out of the console, to the browser
the-browser-s-own-the-page-before = The browser's own: the page before

## src/app/shortcuts.rs

drop-a-hard-spot-into-the-cut = Drop a hard spot into the cut
drop-a-gap-into-the-cut = Drop a gap into the cut
drop-a-depth-step-into-the-cut = Drop a depth step into the cut
let-the-wear-jump = Let the wear jump
break-a-tooth = Break a tooth
drop-a-burst-of-chatter-into-the-cut = Drop a burst of chatter into the cut
let-the-sensor-drop-out = Let the sensor drop out
let-the-sensor-drift = Let the sensor drift
make-the-dead-time-longer-for-a-while = Make the dead time longer for a while
turn-the-override-by-hand-for-a-while = Turn the override by hand for a while
drive-the-cut-by-hand-the-operator-s-knob-on = Drive the cut by hand: the operator's knob, on or off
turn-the-operator-s-knob-up = Turn the operator's knob up
turn-the-operator-s-knob-down = Turn the operator's knob down
turn-the-operator-s-knob-far-up = Turn the operator's knob far up
turn-the-operator-s-knob-far-down = Turn the operator's knob far down
back-to-before-it-went-wrong = Back to before it went wrong
apply-from-the-start = Apply from the start
play-or-pause-after-the-end-again = Play or pause; after the end: again
one-control-sample-on = One control sample on
one-control-sample-back = One control sample back
t-1-s-on = 1 s on
t-1-s-back = 1 s back
t-0-1-s-on = 0.1 s on
t-0-1-s-back = 0.1 s back
to-the-start = To the start
find-a-setting-scenario-screen-command-or-wo = Find a setting, scenario, screen, command or word
open-a-scenario-file = Open a scenario file
export-all-signals-as-csv = Export all signals as CSV
copy-a-link-to-this-state = Copy a link to this state

## src/app/speaker/native.rs

this-computer-has-no-sound-output = this computer has no sound output
the-sound-output-cannot-be-used-error = the sound output cannot be used: { $error }
the-sound-output-takes-only-kind-samples = the sound output takes only { $kind } samples
the-sound-output-has-failed-error = the sound output has failed: { $error }

## src/app/speaker/page.rs

the-browser-gives-no-sound-output-said = the browser gives no sound output { $said }

## src/app/speaker/piped.rs

no-player-was-found-pacat-pulseaudio-pw-cat = no player was found: pacat (PulseAudio), pw-cat (PipeWire) or aplay (ALSA; Debian: apt install alsa-utils)
the-sound-system-s-player-has-ended-is-there = the sound system's player has ended: is there a sound output?

## src/app/timeline.rs

again-from-the-start = Again from the start
again-from-the-start-with-the-change-at-its = Again from the start, with the change at its time
again-from-the-start-with-n-changes-at-their = Again from the start, with { $n } changes at their times
restart = Restart
pause = Pause
pause-space = Pause (Space)
play = Play
play-space = Play (Space)
one-control-sample-on-keys = One control sample on{ $keys }
to-the-end-of-the-cut-end = To the end of the cut (End)
end = End
plots-show-the-last-seconds-before-the-playh = Plots show the last seconds before the playhead, and the whole run at its end; otherwise always the whole run.
follow = Follow
target-not-held-share-in-tolerance = , target not held: { $share } in tolerance
play-again = Play again
from-the-start-with-the-settings-at-the-play = From the start, with the settings at the playhead as the scenario's own{ $keys }. Restart repeats the changes made during the cut at their times; this does not.
nothing-was-changed-during-the-cut-restart-d = Nothing was changed during the cut: Restart does the same
back-to-2-s-before-the-last-broken-tooth-sto = Back to 2 s before the last broken tooth, stop or scrap{ $keys }; the next change branches there
max = max
speed-speed = Speed { $speed }
speed-of-the-playhead = Speed of the playhead
space-does-the-same = Space does the same
computing-percent = computing, { $percent } %
held-2 = held
not-held-2 = not held
share-in-tolerance = , { $share } in tolerance
target-held-share-in-tolerance = , target held: { $share } in tolerance
reference-held-share-in-tolerance = , reference held: { $share } in tolerance
reference-not-held-share-in-tolerance = , reference not held: { $share } in tolerance
target-held-share-in-tolerance-with-dynamics = , target held: { $share } in tolerance with dynamics
target-not-held-share-in-tolerance-with-dyna = , target not held: { $share } in tolerance with dynamics
reference-held-share-in-tolerance-with-dynam = , reference held: { $share } in tolerance with dynamics
reference-not-held-share-in-tolerance-with-d = , reference not held: { $share } in tolerance with dynamics
share-not-judged = , { $share } not judged
unstable-3 = , unstable
chattered-2 = , chattered
unstable-chattered = , unstable, chattered
playhead-2 = Playhead
the-whole-run-drag-to-look-back = The whole run: drag to look back
the-whole-run-drag-to-look-back-the-mark-is = The whole run: drag to look back. The mark is a change during the cut
the-whole-run-drag-to-look-back-the-marks-ar = The whole run: drag to look back. The marks are { $n } changes
help-percent-is-computed-the-line-below = { $help }. { $percent } % is computed: the line below

## src/app/widgets/chart/content.rs

it-is-drawn-at-the-same-place-of-the-part-it = It is drawn at the same place of the part: its steps and changes come where those of the cut do. It moves at another feed, so it took another time to get there. Which constant feed it is stands in More settings, under what to compare with.
the-same-part-cut-at-the-programmed-feed-wit-3 = The same part cut at the programmed feed, without a controller: what the papers call conventional, and what the controller Conventional (constant feed) cuts at 100 %.
the-same-part-cut-without-a-controller-at-th-2 = The same part cut without a controller, at the largest constant feed that is nowhere above the tolerance: who must keep it everywhere chooses the feed by the deepest, hardest place. Found by cutting the part at many feeds. The controller Conventional (constant feed) cuts at the programmed feed instead, as the papers' conventional milling does.
the-largest-constant-feed-that-is-nowhere-ab = The largest constant feed that is nowhere above the tolerance is being found: the part is cut at many feeds.
the-same-part-cut-at-the-programmed-feed-wit-2 = The same part cut at the programmed feed, without a controller: { $why }.
ra-and-force-are-drawn-without-dynamics = Ra and force are drawn without dynamics.
before = before
the-run-as-it-went-on-before-the-last-change = The run as it went on before the last change.
its-thin-line-is-that-with-dynamics-of-ra-an = Its thin line is that with dynamics, of Ra and of the force.
your-hand = your hand
the-same-part-as-you-cut-it-last-by-hand-dra = The same part as you cut it last by hand, drawn at the same places of the part.
from-now-on = from now on
what-the-run-does-after-the-last-change-ahea = What the run does after the last change, ahead of the playhead.

## src/app/widgets/chart/reading.rs

signal-at-the-playhead-value = { $signal } at the playhead: { $value }

## src/app/widgets/chart.rs

chart-from-from-to-to = { $chart } from { $from } to { $to }
all-plots = all plots

## src/app/widgets/drop.rs

drop-disturbance = Drop { $disturbance }

## src/app/widgets/knob.rs

feed-override-by-hand = Feed override by hand
turn-it-by-a-drag-around-it-by-the-wheel-or = Turn it by a drag around it, by the wheel, or with a finger; + and -, Page Up and Page Down turn it from anywhere

## src/app/widgets/legend.rs

lines-of-title = Lines of { $title }
show-this-line = Show this line
hide-this-line = Hide this line

## src/app/widgets/my_files.rs

cutters-materials-machines-structures-parts = Cutters, materials, machines, structures, parts, scripts and more of your own: used, kept, begun
my-files-2 = My files…

## src/app/widgets/number.rs

allowed-is-a-number-from-min-to-max-unit = allowed is a number from { $min } to { $max } { $unit }
name-text-is-not-a-number-allowed-2 = { $name }: “{ $text }” is not a number: { $allowed }
name-text-was-limited-to-taken-allowed-2 = { $name }: “{ $text }” was limited to { $taken }: { $allowed }

## src/app/widgets/save_table.rs

afc-log = afc log
changed-conditions = changed conditions
comparison = comparison
front = front
load-step = load step
passes = passes
plan-2 = plan
table-paper = table { $paper }
claim-paper = claim { $paper }
deviations-paper = deviations { $paper }
calibrations-paper-2 = calibrations { $paper }
save-table-as-csv = Save { $table } as CSV
there-is-no-row-yet = There is no row yet
name-not-whole-yet-done = { $name }, not whole yet: { $done }
the-table-is-not-whole-yet-done-the-name-of = The table is not whole yet: { $done }. The name of the file and its column “Partial” say so.

## src/app/widgets/setting/formula.rs

typed-in-the-console = typed in the console
range-of-input-text-is-not-a-number = range of { $input }: `{ $text }` is not a number
range-of-input-low-is-not-below-high = range of { $input }: { $low } is not below { $high }
change = Change
type = Type
write-the-formula-and-the-ranges-of-its-inpu = Write the formula and the ranges of its inputs
a-file-of-a-formula-s-model-as-steadycut-for = A file of a formula's model, as `steadycut formula --save` writes it
the-built-in-model-again = The built-in model again
a-number = a number
input-low-to-high-unit = { $input } { $low } to { $high } { $unit }
unit-of-meaning = { $unit } of { $meaning }
formula-setting = Formula: { $setting }
from = from
to = to
gives-low-to-high-unit-there = gives { $low } to { $high } { $unit } there
use = Use
from-now-on-in-the-running-cut-too = From now on, in the running cut too
cancel = Cancel
as-it-was-before = As it was before

## src/app/widgets/setting/script.rs

begin-from = Begin from
it-can-be-read-it-runs-once-it-is-used = It can be read; it runs once it is used.
it-runs-at-most-n-steps-in-a-control-period = It runs: at most { $n } steps in a control period.
use-this-script = Use this script
in-the-running-cut-from-here-on-with-a-state = In the running cut from here on, with a state of its own
discard = Discard

## src/app/widgets/setting/structured.rs

begin-with-those-of-the-start-again = Begin with those of the start again
remove-setting = Remove: { $setting }
column-of-row-number = { $column } of { $row } { $number }
remove-row-number = Remove { $row } { $number }
add-a-row = Add a { $row }
the-same-for-every-each = the same for every { $each }
remove-setting-of-each-number = Remove { $setting } of { $each } { $number }
add-one-for-each-number = Add one for { $each } { $number }
t-1-cut = 1 cut
n-cuts = { $n } cuts

## src/app/widgets/setting.rs

reset-to-default-unit = Reset to { $default } { $unit }
locked = Locked
not-used-now-because = Not used now: { $because }.
allowed-allowed = Allowed: { $allowed }.
acts-at-once-also-during-the-cut = acts at once, also during the cut
belongs-to-the-set-up = belongs to the set-up

## src/app/widgets/standing.rs

the-best = the best
to-be-looked-at = to be looked at
not-as-it-should-be = not as it should be

## src/app/widgets/target.rs

iso-1302-grade-grade-ra-ra-um-m = ISO 1302 grade { $grade }: Ra { $ra_um } µm

## src/app/widgets/window.rs

close-window = Close window

## src/disk/own_folder.rs

folder-the-path-is-no-plain-text = { $folder }: the path is no plain text
folder-allowed-is-a-path-from-the-root-on-as = { $folder }: allowed is a path from the root on, as { $root }…
folder-there-is-no-such-folder = { $folder }: there is no such folder
the-choice-of-the-folder-is-not-kept-why = the choice of the folder is not kept: { $why }
folder-it-is-no-folder = { $folder }: it is no folder
there-are-more-than-n-entries-in-this-folder = There are more than { $n } entries in this folder: the others are not looked at.
its-name-is-no-text = its name is no text
name-is-a-link-to-a-folder-which-is-not-foll = { $name } is a link to a folder, which is not followed.
name-lies-more-than-n-folders-deep-and-is-no = { $name } lies more than { $n } folders deep and is not looked into.
there-are-n-files-in-this-folder-the-first-m = There are { $n } files in this folder: the first { $most } by name are listed.
it-is-a-pipe-or-a-device-no-file = it is a pipe or a device, no file
