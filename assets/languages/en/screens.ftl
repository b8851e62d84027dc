# Texts of the program, written by its tests: see ARCHITECTURE.md.

## src/app/panels/block_diagram/brush.rs

your-own-order-order = your own, order { $order }
low-to-high-whole = { $low } to { $high } %, whole
low-to-high-2 = { $low } to { $high } %
at-most-rate-s = at most { $rate } %/s
hardness-hb-wear-wear = { $hardness } HB, wear { $wear }
off = off
noise-level = noise × { $level }
noise-force-n = noise { $force } N
click-a-wire-to-plot-it-a-block-for-its-equa = Click a wire to plot it, a block for its equations. A full lamp: a limit acts, or a model is used outside its range.

## src/app/panels/block_diagram/card_view.rs

what-is-this = What is this?
set-here = Set here
as-printed-2 = As printed
holds-range = holds: { $range }
outside-range = OUTSIDE: { $range }
plot = Plot:

## src/app/panels/block_diagram/draw.rs

plot-signal = Plot { $signal }
as-it-should-be = as it should be

## src/app/panels/block_diagram.rs

block-diagram = Block diagram
closed-loop = Closed loop
nm-1-and-nm-2-at-the-playhead-learning-curve = NM-1 and NM-2 at the playhead, learning curves, several passes
networks-that-learn = Networks that learn

## src/app/panels/compare/boxes.rs

spread-over-the-seeds = Spread over the seeds:
spread-of-measure = Spread of { $measure }
no-values-yet-run-the-comparison = No values yet: run the comparison.
every-seed-gave-the-same-run-a-box-is-a-line = Every seed gave the same run: a box is a line.
mean = mean
printed-in-table-1 = printed in Table 1
name-most-most-upper-quartile-upper-median-m = 
    { $name }
    most { $most }
    upper quartile { $upper }
    median { $median }
    lower quartile { $lower }
    least { $least }
printed = printed
box-plots-of-title-done-of-n-runs = Box plots of { $title }, { $done } of { $n } runs

## src/app/panels/compare/claims.rs

table-1-of-2005-belongs-to-experiment-2-in-c = Table 1 of 2005 belongs to Experiment 2 in Ck45 at 40 ms dead time: beside anything else its figures are not shown.
beside-table-1-of-2005 = Beside Table 1 of 2005
met-of-n-bands-kept = { $met } of { $n } bands kept
kept = kept
not-reached = not reached
found-found = found { $found }
the-bands-are-judged-when-the-six-methods-of = The bands are judged when the six methods of the table have run.
chosen-with-the-table-in-view = Chosen with the table in view
not-reached-and-why = Not reached, and why
title-figures-of-version-version = { $title } (figures of version { $version })

## src/app/panels/compare/contest.rs

done-of-n-runs-done = { $done } of { $n } runs done
compare-conditions = Compare: conditions
compare-what = Compare: { $what }
the-console-s-cut = The console's cut
the-cut-that-is-open-in-the-console-from-its = The cut that is open in the console, from its start, with the settings that the console shows now.
experiment-2 = Experiment 2
experiment-2-of-2005-five-straight-cuts-one = Experiment 2 of 2005, five straight cuts, one programmed feed: that of Table 1.
experiment-2-feeds-per-cut = Experiment 2, feeds per cut
the-same-with-a-programmed-feed-for-every-cu = The same with a programmed feed for every cut, as the plan finds them for the lightest sections: beyond the paper.
as-it-is = as it is
as-the-part-s-scenario-has-it = As the part's scenario has it.
t-0-ms = 0 ms
none = None.
t-40-ms = 40 ms
t-40-ms-of-the-2013-paper = 40 ms, of the 2013 paper.
t-80-ms = 80 ms
t-80-ms-of-the-2007-paper = 80 ms, of the 2007 paper.
ck45 = Ck45
ck45-2 = Ck45.
t-16mncrsi5 = 16MnCrSi5
t-16mncrsi5-xm = 16MnCrSi5 XM.

## src/app/panels/compare/controls.rs

part = Part
settings-of-the-comparison = Settings of the comparison
run-the-comparison = Run the comparison
pause-the-comparison = Pause the comparison
runs-everybody-on-every-seed-it-goes-on-whil = Runs everybody on every seed; it goes on while other screens are shown
seeds = Seeds
every-seed-is-another-material-and-other-sen-2 = Every seed is another material and other sensor noise, the same for everybody; without noise all seeds give the same run
done = done
load-step-step-of-of-then-n-runs = load step { $step } of { $of }, then { $n } runs
sdnrp-and-tracking-set-feed-and-speed-by-wha = SDNRP and Tracking set feed and speed by what Ra wants; this part of 2005 has a force to hold, and its Table 1 does not know them. Off until they are chosen.
dead-time = Dead time
material = Material
who-takes-part = Who takes part:
compared-is-title-changed-name-from-its-star = Compared is “{ $title }, changed” ({ $name }), from its start, with the settings that the console shows now.
compared-is-title-name-from-its-start-with-t = Compared is “{ $title }” ({ $name }), from its start, with the settings that the console shows now.
not-repeated-at-their-times-changes-what-the = Not repeated at their times: { $changes }. What the console shows at { $time } holds from the start, for everybody.
name-last-at-time = { $name } (last at { $time })
n-more = { $n } more
stands-still-what-is-done-stays = Stands still; what is done stays

## src/app/panels/compare/robust.rs

without-retuning-anything = Without retuning anything
experiment-2-at-other-dead-times-which-the-c = Experiment 2 at other dead times, which the controllers know, and in another steel, which they do not. Below each figure that of an independent prototype of the same equations, where it has one: it is no figure of the paper.
run-the-conditions = Run the conditions
pause-the-conditions = Pause the conditions
runs-everybody-under-every-condition = Runs everybody under every condition
done-of-n-runs = { $done } of { $n } runs
control = Control
n-of-runs-runs-not-finished = { $n } of { $runs } runs not finished

## src/app/panels/compare/step.rs

after-a-load-step = After a load step
done-of-n-done = { $done } of { $n } done
from-a-section-of-before-n-into-one-of-after = From a section of { $before } N into one of { $after } N (static peaks in Ck45 at 100 % override), without noise: control periods of { $period } ms until the mean of four samples is back within 10 % for good. The paper prints iterations of an optimisation step without saying what they are; they are shown beside.
not-run-yet-it-comes-first-when-the-comparis = Not run yet: it comes first when the comparison runs.
periods = Periods
overshoot = Overshoot
left-over = Left over
printed-2 = Printed

## src/app/panels/compare/table.rs

printed-value = printed { $value }
best-within-the-spread = best, within the spread
load = Load
load-name = Load { $name }
opens-the-cut-in-the-console-with-this-way-o = Opens the cut in the console with this way of control, and the seed that is set there
n-of-all-not-finished = { $n } of { $all } not finished
n-of-all-stopped-by-overload = { $n } of { $all } stopped by overload
n-of-all-unstable = { $n } of { $all } unstable
n-of-all-chattered = { $n } of { $all } chattered
why-not-all-hold-the-tolerance = Why not all hold the tolerance
mean-and-standard-deviation-over-the-seeds-a = Mean and standard deviation over the seeds. A star marks the best of a column where it leads by more than both deviations together; with less than three seeds no spread is known, and nobody leads. Nsn: normalised standard error, how far the force strays from its reference, less is better.
columns-are-ranked-only-among-those-that-hol-2 = { $columns } are ranked only among those that hold the tolerance: outside it they are no gain.
afc-has-no-reference-forces-here-it-is-taugh = AFC has no reference forces here: it is taught in, with the feed as programmed. Teach it in in the console's window AFC.
so-far-done-ranking = So far, { $done }: { $ranking }
every-seed-gave-the-same-run-since-nothing-r = Every seed gave the same run, since nothing random acts here: there is no spread.
the-force-strays-least-from-its-reference-wi-3 = the force strays least from its reference with { $controller }: its normalised standard error, Nsn, is { $nsn }, 0 is perfect
of-those-told = Of those, { $told }.
of-those-told-the-lead-is-within-the-spread = Of those, { $told }; the lead is within the spread.
of-all-told = Of all, { $told }.
of-all-told-the-lead-is-within-the-spread = Of all, { $told }; the lead is within the spread.
nobody-is-judged-yet = Nobody is judged yet.
nobody-holds-the-tolerance-on-percent-of-the-2 = Nobody holds the tolerance on { $percent } % of the length.
who-holds-the-tolerance-on-percent-of-the-le = Who holds the tolerance on { $percent } % of the length: { $controllers }.
by-controller = By controller
by-measure = By measure

## src/app/panels/compare.rs

compare = Compare
controllers-ranking-best-seeds-statistics-to = controllers ranking best seeds statistics tournament
nobody-takes-part = Nobody takes part
choose-at-least-one-way-of-control-above = Choose at least one way of control above.

## src/app/panels/equation_cards/live.rs

symbol-c-delayed-by-time-s = { $symbol }_c delayed by { $time } s
in-now-out-then-unit = in { $now }, out { $then } { $unit }
symbol-c-command-gives-symbol-a-actual-unit = { $symbol }_c = { $command } gives { $symbol }_a = { $actual } { $unit }
f-c-command-gives-f-a-feed-mm-min = f_c = { $command } gives f_a = { $feed } mm/min
a-straight-ramp-beyond-error-1-min-of-error = a straight ramp beyond { $error } 1/min of error
level-level-band-band-ripple-ripple-inhomoge = level { $level }: band { $band } %, ripple { $ripple } %, inhomogeneity { $inhomogeneity } %
f-m-symbol-noise-of-deviation-n-standard-dev = F_m = { $symbol } + noise of { $deviation } N (standard deviation)
f-m-measured-n-held-since-the-last-sample-sy = F_m = { $measured } N, held since the last sample; { $symbol } now { $force } N

## src/app/panels/equation_cards/machine.rs

p-f-g-max-g-force-factor-b-u-u-t-g-the-teeth = P = F g / max g - { $force } · { $factor } b (u - u_T), g the teeth's chip, u_T one tooth earlier
u-vibration-um-as-the-last-tooth-made-the-su = u = { $vibration } µm as the last tooth made the surface; velocity { $sound } mm/s over the last second
ra-dyn-ra-ra-marks-ra-marks-without-vibratio = Ra_{ "{" }dyn{ "}" } = Ra + Ra(marks) - Ra(marks without vibration)

## src/app/panels/equation_cards/models.rs

symbol-low-to-high-unit = { $symbol } { $low } to { $high } { $unit }
range-straight-on-beyond = { $range }; straight on beyond
f-d-at-least-force-n = F_d at least { $force } N
f-s-from-force-n-on-below-it-the-feed-is-neg = F_s from { $force } N on; below it the feed is negative
f-s-where-the-feed-is-positive-and-rises-wit = F_s where the feed is positive and rises with it
f-s-up-to-force-n-above-it-there-is-no-root = F_s up to { $force } N; above it there is no root
range-goes-on-beyond = { $range }; goes on beyond
symbol-the-tool-is-in-the-air = { $symbol }: the tool is in the air
no-force-so-no-surface-is-cut = no force, so no surface is cut
range-straight-on-beyond-before-its-pole-at = { $range }; straight on beyond, before its pole at 293 N
range-it-turns-round-at-force-n = { $range }; it turns round at { $force } N

## src/app/panels/equation_cards/overrides.rs

ramp = ramp
round-wanted-to-whole = round({ $wanted }) to whole %
rate-t-rate-s-period-s-step-name-is-on-its-w = rate T = { $rate } %/s · { $period } s = { $step } %: { $name } is on its way
rate-t-rate-s-period-s-step-name-is-arrived = rate T = { $rate } %/s · { $period } s = { $step } %: { $name } is arrived
ramp-limit-wanted-ramp-rate-t-wanted-limit-s = ramp' = limit(wanted - ramp, ± rate T),  wanted = limit({ $symbol } / { $symbol }_p, { $low }..{ $high } %)
name-reaches-what-is-wanted-within-a-period = { $name } reaches what is wanted within a period

## src/app/panels/identify/actions.rs

with-units-and-ranges-as-steadycut-identify = With units and ranges, as `steadycut identify gp --out` writes it
save-as-a-model = Save as a model
copy-as-text = Copy as text
copy-as-latex = Copy as LaTeX
puts-the-formula-into-the-clipboard = Puts the formula into the clipboard
the-formula-is-in-the-clipboard-form = The formula is in the clipboard ({ $form }).
neither-a-model-nor-for-the-cut-because = Neither a model nor for the cut: { $because }.
input-in-unit = `{ $input }` in { $unit }
nothing = nothing
and = { " " }and{ " " }
a-number-without-a-unit = a number without a unit
the-cut-has-no-place-for-it-by-its-units-it = The cut has no place for it by its units: it makes { $makes } of { $made }.
use-in-the-cut-place = Use in the cut: { $place }
in-the-running-cut-place = In the running cut: { $place }.
show-the-cut = Show the cut
plant-and-controller-compute-with-it-from-no = Plant and controller compute with it from now on (calibration: own formulas); Undo takes it back
place-the-formula-stands-in-the-running-cut = { $place }: the formula stands in the running cut, with the calibration own formulas. Undo takes it back.

## src/app/panels/identify/columns.rs

target-and-inputs = Target and inputs
left-out-because = left out: { $because }
units = Units
input = input
target-2 = target
name-low-to-high = { $name }: { $low } to { $high }
unit-of-name = Unit of { $name }
as-mm-min-1-min-n-um-empty-or-1-for-none-the = As mm/min, 1/min, N, um; empty or 1 for none. The ending of the column's name tells it first

## src/app/panels/identify/controls.rs

table-table = Table: { $table }
open-a-csv = Open a CSV…
a-table-with-a-line-of-names-it-can-also-be = A table with a line of names; it can also be dropped here
table-rows-rows-columns-columns = { $table }: { $rows } rows, { $columns } columns.
search = Search
seed = Seed
most-batches = Most batches
it-ends-earlier-where-nothing-is-gained-for = It ends earlier where nothing is gained for 200 batches, or a formula is exact.
known-part-of-the-formula = Known part of the formula
none-or-as-a-b-n-3-t-f = none, or as a + b*n^3 + T(f)
columns-by-their-names-other-names-are-const = Columns by their names; other names are constants that are fitted. T(...) stands for what is searched for, a formula of the columns in its brackets
only-formulas-that-are-right-in-their-units = Only formulas that are right in their units
beside-it-as-searched-in-a-paper = Beside it, as searched in a paper:
paper-s-search-beside-paper = Paper's search beside: { $paper }
its-functions-constants-population-and-proba = Its functions, constants, population and probabilities; the report says which search found the formula of the smaller error

## src/app/panels/identify/facts.rs

constants-with-95-intervals = Constants with 95 % intervals
it-has-none = It has none.
low-to-high = { $low } to { $high }
not-determined-low-to-high = not determined: { $low } to { $high }
not-determined-by-these-rows = not determined by these rows
units-because = Units: { $because }
slope-uncertain = slope uncertain
where-it-holds = Where it holds
name-low-to-high-unit-trend = { $name } { $low } to { $high } { $unit }: { $trend }
or = { " " }or{ " " }
outside-ranges-it-says-nothing = Outside { $ranges } it says nothing.
certain-to-be-finite-from-low-to-high-unit = certain to be finite, from { $low } to { $high } { $unit }
certain-to-be-finite = certain to be finite
not-certain-to-be-finite-why = not certain to be finite: { $why }
not-certain-to-be-finite = not certain to be finite
there-it-is-finite = There it is { $finite }.
with-percent-more-on-each-side-finite = With { $percent } % more on each side: { $finite }.

## src/app/panels/identify/fit/choose.rs

what-is-fitted = What is fitted
fitted-what = Fitted: { $what }
open-a-recording = Open a recording…
text-of-any-layout-matlab-hdf5-tdms-or-parqu-2 = Text of any layout, MATLAB, HDF5, TDMS or Parquet; it can also be dropped here
try-with-sample-data = Try with sample data
simulates-the-recording-that-the-present-sce = Simulates the recording that the present scenario would give, with noise by its seed: what comes out of the fit can be compared with what went in
none-yet = None yet.

## src/app/panels/identify/fit/fields.rs

which-channel-is-which = Which channel is which
options = Options
choose = choose
unit-channel = Unit: { $channel }
the-scenario-s-value = the scenario's: { $value }
clear = Clear

## src/app/panels/identify/fit/found.rs

is-half-a-95-interval-from-what-is-left-if-t = ± is half a 95 % interval, from what is left, if the model is the true one.
use-in-this-scenario = Use in this scenario
sets-these-settings-in-one-step-of-undo-the = Sets these settings, in one step of undo; the cut plays from its start
save-as-a-file = Save as a file
the-file-that-steadycut-identify-id-out-writ = The file that steadycut identify { $id } --out writes, with source and intervals
it-stands-in-the-scenario-undo-takes-it-back = It stands in the scenario. Undo takes it back.
t-1-setting = 1 setting
n-settings = { $n } settings
this-scenario-does-not-take-it-why = This scenario does not take it: { $why }

## src/app/panels/identify/fit/mod.rs

fit-of-measured-data = Fit of measured data
sample-data = Sample data
no-sample-data-why = No sample data: { $why }
data-options-or-the-cut-were-changed-since-w = Data, options or the cut were changed since: what stands here is of before. Fit asks anew.
open-a-file-first = Open a file first.
stop-the-fit = Stop the fit
gives-this-fit-up = Gives this fit up
fit = Fit
fits-the-model-to-the-data-it-goes-on-while = Fits the model to the data; it goes on while other screens are shown
no-measured-data-yet = No measured data yet
choose-what-is-to-be-fitted-open-a-recording = Choose what is to be fitted, open a recording or drop it here, and say which channel is which; then press Fit. Values with their 95 % intervals, what is left and what the data cannot tell apart are shown before anything is taken into the scenario or saved.
sample-data-sample-on-the-command-line-stead = Sample data: { $sample }. On the command line: steadycut identify { $id }.

## src/app/panels/identify/fit/plots.rs

the-fit = the fit
measured = measured
model-2 = model
what-over-over-measured-against-the-model-n = { $what } over { $over }: measured against the model, { $n } places
measured-over-model = Measured over model
left-over-measured-less-model = Left over: measured less model
left-over-2 = left over
what-the-fit-of-what-leaves-over-over = what the fit of { $what } leaves over { $over }

## src/app/panels/identify/fit_plots.rs

predicted-over-measured = Predicted over measured
upright-lines-the-95-band-in-which-the-true = Upright lines: the 95 % band, in which the true values lie if the formula's form is the true one.
left-over-row-by-row = Left over, row by row
row-row-does-not-fit-target-value-off-off-de = Row { $row } does not fit: { $target } = { $value }, { $off } off, { $deviations } of its own standard deviations.
n-more-rows-do-not-fit = { $n } more rows do not fit.
predicted = predicted
predicted-over-measured-n-rows-apart-of-them = predicted over measured: { $n } rows, { $apart } of them do not fit
row = row
left-over-over-row-n-rows-apart-of-them-do-n = left over over row: { $n } rows, { $apart } of them do not fit
row-that-does-not-fit = row that does not fit

## src/app/panels/identify/form.rs

known-part-nothing-is-left-to-be-searched-fo = known part: nothing is left to be searched for; write T(...) with the columns that the rest may read (the constants alone are fitted by `steadycut identify gp --template`)
the-unit-of-column-is-not-known-write-it-bes = the unit of `{ $column }` is not known: write it beside its name, `1` for none, or let formulas be of any units
unit-of-column-problem = unit of `{ $column }`: { $problem }
open-a-table-or-choose-one-of-the-papers = open a table, or choose one of the papers'
choose-the-column-that-the-formula-is-to-giv = choose the column that the formula is to give
choose-at-least-one-column-that-the-formula = choose at least one column that the formula may read
known-part-problem = known part: { $problem }
collinear-leave-one-of-them-out = { $collinear }; leave one of them out
data = data
inputs = inputs
units-2 = units
known-part = known part
seed-2 = seed
batches = batches
paper-2 = paper
not-opened-because = not opened: { $because }
nothing-was-checked = nothing was checked

## src/app/panels/identify/formula.rs

formula-of-size-size-the-one-chosen = Formula of size { $size }, the one chosen
formula-of-size-size = Formula of size { $size }
formula-of-size-size-so-far = Formula of size { $size }, so far
with-all-digits-formula = With all digits: { $formula }
unsure-doubt = Unsure: { $doubt }.
exact-but-for-rounding = Exact but for rounding.

## src/app/panels/identify/front.rs

front-the-formula-of-the-least-error-of-each = Front: the formula of the least error of each size
no-formula-has-a-finite-value-on-all-rows-ye = No formula has a finite value on all rows yet.
size-2 = size
error = error
left-out = left out
chosen-exact = chosen, exact
chosen = chosen
exact = exact
unsure = unsure
errors-are-root-mean-squares-of-what-is-left = Errors are root mean squares of what is left over. At rows left out they are found once the search is over.
left-out-rows-unsure-more-than-twice-the-lea = Left out: { $rows }. Unsure: more than twice the least error there, or not certain to be finite.
searched-on-searched-of-n-rows-drawn-by-the = Searched on { $searched } of { $n } rows, drawn by the seed; constants are fitted to all.
no-formula = no formula
the-smaller-error-is-that-of-the-paper-searc = The smaller error is that of the paper search.
the-smaller-error-is-that-of-the-default-sea = The smaller error is that of the default search.
stop-at-stop-reached = stop at { $stop } reached
stop-at-stop-not-reached = stop at { $stop } not reached
as-the-paper-of-paper-searched-formula-size = As the paper of { $paper } searched: { $formula }, size { $size }, R2 { $fitness } after { $n } generations, { $reached }.
digest-digest-the-same-on-the-command-line = Digest { $digest }: the same on the command line.

## src/app/panels/identify/front_plot.rs

size-nodes = size [nodes]
at-rows-left-out = at rows left out
looked-at = looked at
front-error-against-size-n-formulas = Front: error against size, { $n } formulas
front-error-in-unit-against-size-n-formulas = Front: error in { $unit } against size, { $n } formulas

## src/app/panels/identify/mod.rs

fit-settings = Fit settings
search-formulas = Search formulas
looks-in-a-table-for-a-formula-of-one-column = Looks in a table for a formula of one column, by genetic programming
fits-drive-forces-structure-noise-wear-or-ma = Fits drive, forces, structure, noise, wear or material to a recording
identify = Identify
no-formula-was-searched-for-yet = No formula was searched for yet
choose-a-table-a-csv-can-be-dropped-here-the = Choose a table (a CSV can be dropped here), the column that the formula is to give, and the columns that it may read; then press Search.
the-front-grows-while-the-search-works-for-e = The front grows while the search works: for every size the formula of the least error. Any of them can be looked at, saved, and put into the running cut.
without-a-table-of-one-s-own-go-the-whole-wa = Without a table of one's own: Go the whole way plans and measures cuts on the simulator, which can then be searched as well.

## src/app/panels/identify/preview.rs

no-numbers = no numbers
unit-not-told = unit not told

## src/app/panels/identify/search.rs

not-certain-to-be-finite-on-the-ranges-of-th = not certain to be finite on the ranges of the rows
at-rows-left-out-more-than-twice-the-least-e = at rows left out more than twice the least error of the front
identify-target = Identify: { $target }
the-front-has-this-formula-no-more = the front has this formula no more

## src/app/panels/identify/symbols.rs

simulation = Simulation
ra = Ra
desired-ra = Desired Ra
ra-produced = Ra produced
force-start = Force, start
force-end = Force, end
feed-start = Feed, start
feed-end = Feed, end
speed-2 = Speed
speed-start = Speed, start
speed-end = Speed, end
axial-depth = Axial depth
radial-depth = Radial depth

## src/app/panels/identify/transport.rs

searches-for-formulas-it-goes-on-while-other = Searches for formulas; it goes on while other screens are shown
stands-still-what-was-found-stays = Stands still; what was found stays
pause-the-search = Pause the search
goes-on-where-it-was-paused = Goes on where it was paused
go-on-with-the-search = Go on with the search
ends-the-search-with-its-last-whole-batch-wh = Ends the search with its last whole batch; what was found is still judged at rows left out
end-here = End here
searches-for-what-is-set-now-and-gives-this = Searches for what is set now, and gives this search up
begin-anew = Begin anew
writes-a-file-to-go-on-with-later-here-or-wi = Writes a file to go on with later, here or with --resume
save-the-search = Save the search
changed-since-this-search-was-begun-changed = Changed since this search was begun: { $changed }. It stays as it was begun; `Begin anew` searches for what is set now.
sets-table-columns-and-numbers-to-those-of-t = Sets table, columns and numbers to those of this search
set-back = Set back
resume = Resume…
goes-on-with-a-saved-search-of-the-same-tabl = Goes on with a saved search of the same table, columns, units and seed; its file can also be dropped here
batch-batch-of-at-most-most = batch { $batch } of at most { $most }
the-paper-s-own-search = the paper's own search
judging-the-front-at-rows-left-out = judging the front at rows left out
done-after-n-batches = done after { $n } batches
n-formulas = { $n } formulas
at-most-left-left = at most { $left } left
paused = paused

## src/app/panels/identify/tree.rs

as-a-tree = As a tree
tree-of-the-formula-n-parts = Tree of the formula, { $n } parts

## src/app/panels/identify/way.rs

identify-the-whole-way = Identify: the whole way
the-open-scenario-s-cutter-is-none-of-the-sh = the open scenario's cutter is none of the shipped: the way is gone with one of those
from-cuts-to-a-controller = From cuts to a controller
with-the-open-scenario-s-cutter-and-material = With the open scenario's cutter and material: { $n } cuts planned and measured on the simulator, models 1 to 5 identified from them, the rows of Table 3 run on the models.
go-the-whole-way = Go the whole way
pause-the-way = Pause the way
go-on-with-the-way = Go on with the way
give-the-way-up = Give the way up
percent-of-the-way-about-left-left = { $percent } % of the way, about { $left } left
percent-of-the-way = { $percent } % of the way
percent-of-the-way-paused = { $percent } % of the way, paused
its-cuts-as-the-table = Its cuts as the table
cuts-of-the-way = cuts of the way
ra-0-81-m-with-tracking-on-the-models-found = Ra 0.81 µm with Tracking on the models found
cut-with-its-models = Cut with its models
the-scenario-of-the-way = The scenario of the way
the-whole-way-tool-in-material = The whole way: { $tool } in { $material }
truth-truth = Truth: { $truth }.
measured-of-n-cuts-measured-axial-mm-deep-an = { $measured } of { $n } cuts measured, { $axial } mm deep and { $radial } mm wide.
cut-run-problem = Cut { $run }: { $problem }.
name-low-to-high-2 = { $name } { $low } to { $high }
error-error-n-cuts-ranges = error { $error }, { $n } cuts, { $ranges }
ra-against-its-target-n-rows-of-table-3 = Ra against its target, { $n } rows of Table 3
digest-digest-that-of-steadycut-experiment-w = Digest { $digest }: that of `steadycut experiment way`.
n-rows-outside-the-ranges-of-the-models = { $n } rows outside the ranges of the models
off-by-worst-at-most-rms-rms = off by { $worst } % at most, { $rms } % rms
n-rows-without-a-ra = { $n } rows without a Ra
controller-on-models = { $controller } on { $models }

## src/app/panels/learn/answer.rs

from-the-start-by-hand-again = From the start, by hand again
from-the-start-with-what-is-set-now = From the start, with what is set now
cut-from-the-start = Cut from the start
marks-the-whole-cut-as-it-is-set-now-and-you = Marks the whole cut as it is set now, and your predictions
check-my-answer = Check my answer
the-cut-still-runs-percent-the-check-runs-it = The cut still runs ({ $percent } %): the check runs it to its end first.
the-cut-is-over-the-check-marks-all-of-it = The cut is over: the check marks all of it.
the-cut-is-being-marked = The cut is being marked
this-was-the-last-mission-leave-leads-to-the = This was the last mission. Leave leads to the list of all.
next-mission-title = Next mission: { $title }
your-name = Your name
if-you-like = if you like
a-file-with-your-answer-and-what-it-came-to = A file with your answer and what it came to; steadycut mission check verifies it
save-result = Save result

## src/app/panels/learn/catalogue.rs

missions = Missions
each-takes-some-minutes-say-what-will-happen = Each takes some minutes: say what will happen, cut, and see whether you were right. What you do is checked by the program that cuts.
begin = Begin
begin-mission = Begin: { $mission }
a-mission-of-your-own-is-a-text-file-steadyc = A mission of your own is a text file: steadycut mission new writes one to begin with. Drop it here.
not-passed-yet = not passed yet
won-of-most-stars = { $won } of { $most } stars
a-link-to-this-mission-with-its-qr-code = A link to this mission, with its QR code
link-mission = Link: { $mission }
stars-are-kept-until-the-program-ends-the-pl = Stars are kept until the program ends: the place for more is refused here.
forget-my-stars = Forget my stars…
all-stars-of-every-mission = All stars, of every mission?
forget-them = Forget them
keep-them = Keep them

## src/app/panels/learn/lesson.rs

marking-of-the-mission = Marking of the mission

## src/app/panels/learn/mod.rs

learn = Learn
predict-first = Predict first
the-cut-begins-and-is-shown-as-soon-as-you-h = The cut begins, and is shown, as soon as you have said what you expect, or gone on without a prediction.

## src/app/panels/learn/pen.rs

sketch-right-and-left-draw-up-and-down-lift = Sketch: right and left draw, up and down lift and lower the pen

## src/app/panels/learn/questions.rs

the-right-answer-is-needed-to-pass = The right answer is needed to pass.
your-prediction = Your prediction
prediction = Prediction

## src/app/panels/learn/sketch.rs

signal-up-to-top-unit = { $signal } up to { $top } { $unit }
value-at-time = { $value } at { $time }
draw-here = Draw here

## src/app/panels/learn/tasks.rs

back-to-all-missions-the-cut-stays-as-it-is = Back to all missions; the cut stays as it is, and all of it can be changed again
story = Story
goal = Goal:
step-step-of-count-title = Step { $step } of { $count }: { $title }
back = Back
next = Next
that-is-my-prediction = That is my prediction
go-on-without-a-prediction = Go on without a prediction
that-is-my-answer = That is my answer
go-on-without-an-answer = Go on without an answer
without-an-answer-there-is-no-third-star-any = Without an answer there is no third star: any guess teaches more than none.
go-on-all-the-same = Go on all the same
your-prediction-stays-as-it-is-the-cut-has-b = Your prediction stays as it is: the cut has been shown.
it-was-left-without-a-prediction-the-cut-has = It was left without a prediction: the cut has been shown.
you-have-seen-this-cut-before-another-answer = You have seen this cut before: another answer than that of the first time counts for passing, not for the third star.
answered-after-the-cut-or-a-check-has-shown = Answered after the cut or a check has shown it: that counts for passing, not for the third star.
what-you-may-change = What you may change
nothing-this-mission-asks-only-for-answers = Nothing: this mission asks only for answers.
given-2 = Given
hint-number = Hint { $number }:
hint-number-of-count = Hint { $number } of { $count }

## src/app/panels/learn/verdict.rs

tries-begun-begun-checked-checked = Tries: begun { $begun }, checked { $checked }
digest-of-the-cut-digest = Digest of the cut: { $digest }
puts-the-result-away-a-check-brings-the-next = Puts the result away; a check brings the next one
close-the-result = Close the result
passed-won-of-most-stars = Passed: { $won } of { $most } stars
not-passed-yet-2 = Not passed yet
this-is-of-before-your-last-change-check-aga = This is of before your last change: check again.
off-the-curve-by-percent-of-its-height = off the curve by { $percent } of its height
within-tolerance-of-the-true-value = within { $tolerance } of the true value
too-low-allowed-is-tolerance-to-either-side = too low; allowed is { $tolerance } to either side
too-high-allowed-is-tolerance-to-either-side = too high; allowed is { $tolerance } to either side
words-the-true-value-is-truth = { $words }; the true value is { $truth }
no-answer-was-given-in-step-step-that-costs = No answer was given in step { $step }: that costs the third star
no-prediction-was-made-in-step-step-that-cos = No prediction was made in step { $step }: that costs the third star
your-answer-in-step-step-is-right-it-came-wh = Your answer in step { $step } is right; it came when the cut had been seen
your-answer-in-step-step-is-wrong = Your answer in step { $step } is wrong
your-prediction-in-step-step-was-right = Your prediction in step { $step } was right
your-prediction-in-step-step-was-wrong = Your prediction in step { $step } was wrong
your-prediction-in-step-step-was-right-off-2 = Your prediction in step { $step } was right ({ $off })
your-prediction-in-step-step-was-wrong-off-2 = Your prediction in step { $step } was wrong ({ $off })
for-all-three-stars = For all three stars:
reached-condition = reached: { $condition }
missed-condition = missed: { $condition }
predictions-that-are-right-made-before-the-c = predictions that are right, made before the cut

## src/app/panels/learning/actions.rs

the-cut-begins-with-networks = The cut begins with networks
learned-before = learned before
begin-the-same-cut-with-what-has-been-learne = Begin the same cut with what has been learned at its end
cut-again-with-what-was-learned = Cut again with what was learned
save-nm-r-nm-1-and-nm-2-as-they-are-at-the-e = Save NM-R, NM-1 and NM-2 as they are at the end of the cut
save-networks = Save networks
begin-with-the-networks-of-a-file-one-can-al = Begin with the networks of a file; one can also be dropped here
load-networks = Load networks

## src/app/panels/learning/curves.rs

feedback-s-share-of-the-override = Feedback's share of the override [%]
error-of-nm-1-s-prediction = Error of NM-1's prediction [%]
internal-loop-now-iterations-now-mean-on-ave = Internal loop: { $now } iterations now, { $mean } on average so far
means-of-the-size-over-about-a-second-in-con = Means of the size over about a second in contact. The feedback's share is all that the loops add to NM-2, where the override is between its limits.
mean-of-its-size-over-about-a-second-in-cont = Mean of its size over about a second in contact, where the override is between its limits.
playhead = playhead

## src/app/panels/learning/mod.rs

no-networks-at-the-playhead-yet = No networks at the playhead yet.
positive = positive
negative = negative
f-is-the-measured-force-f1-and-f2-what-it-wa = F is the measured force, F1 and F2 what it was one and two control periods ago; a is the override that the feed drive has reached, u the one that is asked for.
a-dot-in-a-neuron-is-its-bias-beside-the-wei = A dot in a neuron is its bias. Beside the weights, a ring marks the neurons that have changed most.
nm-2-is-the-inverse-model-it-asks-for-the-ov = NM-2 is the inverse model: it asks for the override by itself. It begins untrained and asks for 100 %, so at first the feedback does all the work, as the division controller does.
what-the-feedback-adds-is-what-nm-2-has-not = What the feedback adds is what NM-2 has not known: it learns from it, sample by sample (feedback-error learning). As it learns, the feedback's share falls.
nm-1-has-no-part-in-the-cold-start-and-does = NM-1 has no part in the cold start and does not learn.
nm-2-is-the-inverse-model-it-asks-for-the-ov-2 = NM-2 is the inverse model: it asks for the override that gives the wanted force. NM-1 is the forward model: it predicts the force of an override, and an internal loop corrects the override with it before it is sent.
both-were-trained-before-and-go-on-learning = Both were trained before and go on learning in the cut: NM-1 from what the force came to, NM-2 from what the loops have added to it.

## src/app/panels/learning/net.rs

weights = Weights
change-since-the-start = Change since the start
links-as-thick-as-their-weights-rings-mark-w = Links as thick as their weights; rings mark what has changed most
links-as-thick-as-what-the-weights-have-chan = Links as thick as what the weights have changed by in this cut
predicts-the-force = predicts the force
change-of-ln-f = change of ln F
has-no-part-in-the-cold-start = has no part in the cold start
asks-for-the-override = asks for the override
n-lessons-largest-weight-weight-largest-chan = { $n } lessons; largest weight { $weight }, largest change { $change }

## src/app/panels/learning/passes.rs

passes-of-unks = Passes of UNKS
the-same-part-again-and-again = The same part again and again
n-passes-without-the-changes-of-this-session = { $n } passes without the changes of this session, same part, noise and seed; what was learned is carried on.
stop-the-passes = Stop the passes
cut-n-passes = Cut { $n } passes
done-of-n-passes = { $done } of { $n } passes
no-further-pass-because = No further pass: { $because }
made-with-other-settings-than-those-of-now = Made with other settings than those of now.
begin-the-cut-with-the-networks-as-they-are = Begin the cut with the networks as they are after the last pass
use-these-networks = Use these networks
pass = pass
number-of-the-pass = Number of the pass
normalised-standard-error-over-all-samples-i = Normalised standard error over all samples in contact
time-2 = time
time-of-the-cut-s = Time of the cut, s
largest-force = Largest force
feedback = feedback
mean-size-of-the-feedback-s-share-of-the-ove = Mean size of the feedback's share of the override, %
by-quarter-of-the-part-quarters = By quarter of the part: { $quarters } %
nothing-is-learned-every-pass-is-the-same = Nothing is learned: every pass is the same.
the-feedback-s-share-falls-pass-by-pass = The feedback's share falls pass by pass.
the-feedback-s-share-does-not-fall-pass-by-p = The feedback's share does not fall pass by pass.
error-of-the-last-pass-against-the-first-cha = Error of the last pass against the first: { $change } (from a cold start on the whole part: -{ $wanted } %).
error-of-the-last-pass-against-the-first-cha-2 = Error of the last pass against the first: { $change }.

## src/app/panels/machine/controls.rs

machine-and-chip = Machine and chip
wear = Wear
sound-noise-and-prediction = Sound, noise and prediction
the-programmed-feed-speed-and-depth-of-cut-a = The programmed feed, speed and depth of cut are those of the Console.

## src/app/panels/machine/life.rs

trends-over-the-tool-life = Trends over the tool life
life-of-one-tool = Life of one tool

## src/app/panels/machine/mod.rs

stability = Stability
vibration = Vibration
the-masses-moving-the-frequency-response-and = The masses moving, the frequency response and the modes
wear-and-sound = Wear and sound
wear-sound-and-roughness-over-the-tool-s-lif = Wear, sound and roughness over the tool's life, and its predicted life
the-depth-at-which-the-cut-chatters-over-the = The depth at which the cut chatters, over the speed
chatter-stability-lobes-sound-vibration-wear = chatter stability lobes sound vibration wear tool life modes frequency response limit depth
settings-of-the-machine = Settings of the machine

## src/app/panels/machine/picture.rs

five-masses-at-at-parts-scale = Five masses at { $at }: { $parts }. { $scale }
shape-of-a-mode-its-size-means-nothing = Shape of a mode: its size means nothing
movement-drawn-times = Movement drawn ×{ $times }

## src/app/panels/machine/plot.rs

title-from-from-to-to = { $title } from { $from } to { $to }

## src/app/panels/machine/response.rs

g-rel-tooth-to-work = |G_rel| tooth to work
h33-tooth = |H33| tooth
hww-work = |Hww| work
the-frequency-response = the frequency response
frequency-response-unit = Frequency response [{ $unit }]
modes = modes
passing-teeth = passing teeth
cursor-frequency = Cursor frequency
the-cursor-drag-it-here-or-in-the-plot-or-us = The cursor: drag it here or in the plot, or use the arrow keys
to-3000-hz = to 3000 Hz
to-600-hz = to 600 Hz
phase = Phase
at-at-said = At { $at }: { $said }
response = Response
mode-number-at = mode { $number }, { $at }
cursor = cursor

## src/app/panels/machine/sound.rs

the-sound-of-the-cut-as-the-model-gives-it-p = The sound of the cut as the model gives it: passing teeth and random force at this speed, louder with wear. It sounds while the cut plays.
sound-of-the-cut = Sound of the cut
sound-on = Sound on
sound-off = Sound off
volume = Volume
no-sound-problem = No sound: { $problem }.
silent-while-the-cut-is-paused = silent while the cut is paused

## src/app/panels/machine/stability.rs

limit-depth-at-this-speed = Limit depth at this speed
quiet-at-speed-up-to-limit-limit-depth-at-an = Quiet at { $speed } up to { $limit } (limit depth), at any speed up to { $any }.
quiet-at-speed-up-to-highest-at-least-no-lim = Quiet at { $speed } up to { $highest } at least: no limit depth was found; at any speed up to { $any }.
stability-chart = Stability chart
no-chart-can-be-made-of-this-machine = No chart can be made of this machine
charted-cut = Charted: { $cut }.
go-on-with-the-chart = Go on with the chart
structure = Structure
n-measured-modes-at-the-tool-s-tip = { $n } measured modes at the tool's tip
takes-the-measured-modes-away-the-five-masse = Takes the measured modes away: the five masses of 2019 stand again
back-to-the-five-masses = Back to the five masses
spindle-quality = Spindle quality
q-5-by-its-damper = Q 5, by its damper
the-printed-damper-of-2348-n-s-m-belongs-to = The printed damper of 2348 N s/m belongs to it
q-17-as-printed = Q 17, as printed
the-quality-printed-in-the-table-a-third-of = The quality printed in the table: a third of the damping
the-cuts-of-this-run-are-being-judged = The cuts of this run are being judged
chatter-at-speed-and-depth-deep-from-from-to = Chatter at { $speed } and { $depth } deep, from { $from } to { $to } of the path: a disturbance grows ×{ $grown } per tooth
stable-at-speed-and-depth-deep-from-from-to = Stable at { $speed } and { $depth } deep, from { $from } to { $to } of the path, the cut of this run nearest to chatter: a disturbance shrinks to ×{ $grown } per tooth
stable-at-every-speed-up-to-any-by-the-lobes = Stable at every speed up to { $any }, by the lobes.
nothing-can-chatter-the-chip-does-not-feel-t = Nothing can chatter: the chip does not feel the vibration.
depth-deep-it-is-quietest-near-speed-where-t = { $depth } deep it is quietest near { $speed }, where the limit depth is { $limit }.
depth-deep-it-is-quietest-near-speed-where-n = { $depth } deep it is quietest near { $speed }, where no limit depth was found.
depth-deep-it-is-quiet-at-no-speed-of-the-ch = { $depth } deep it is quiet at no speed of the chart.
at-the-playhead-no-cut = At the playhead: no cut.
at-the-playhead-speed-and-depth-deep-chatter = At the playhead, { $speed } and { $depth } deep: chatter, ×{ $grown }.
at-the-playhead-speed-and-depth-deep-no-chat = At the playhead, { $speed } and { $depth } deep: no chatter, ×{ $grown }.
limit-depth = Limit depth
limit-depth-mm-over-the-speed-1-min-quiet-be = Limit depth [mm] over the speed [1/min]: quiet below the line
lobes = lobes
interrupted-cut = interrupted cut
stable-at-every-speed = stable at every speed
furthest-into-chatter-in-the-run = furthest into chatter in the run
nearest-to-chatter-in-the-run = nearest to chatter in the run
the-cut-now = the cut now

## src/app/panels/machine/vibration.rs

stop-the-masses = Stop the masses
move-the-masses = Move the masses
the-contact-force-at-the-frequency-of-the-cu = The contact force at the frequency of the cursor
at-the-cursor = At the cursor
passing-teeth-2 = Passing teeth
the-contact-force-at-harmonic-times-the-toot = The contact force at { $harmonic } times the tooth passing of now
passing-teeth-harmonic = Passing teeth ×{ $harmonic }
mode-number-at-shown-at-slow-hz = Mode { $number }: { $at }, shown at { $slow } Hz
force-at-at-shown-at-slow-hz = { $force } at { $at }, shown at { $slow } Hz
modes-2 = Modes
the-eigenvalues-of-this-machine-do-not-conve = The eigenvalues of this machine do not converge.
mode = mode
damping = damping
moves-most = moves most
mode-number = Mode { $number }
let-it-swing = Let it swing

## src/app/panels/machine/wear.rs

tool-life-used = Tool life used
share-of-the-tool-s-life = Share of the tool's life
fraction-t-of-the-tool-s-life-that-is-drawn = Fraction τ/T of the tool's life that is drawn and sounded
the-tool-of-the-running-cut-which-wears-in-i = The tool of the running cut, which wears in it
as-in-the-cut = As in the cut
go-on = Go on
wear-land-land-force-force-sound-sound-ra-ra = wear land { $land }, force { $force }, sound { $sound }, Ra { $ra }
wear-land-vb = Wear land VB
over-the-fraction-of-life = over the fraction of life
the-tool-of-the-running-cut-by-the-sound-of = The tool of the running cut, by the sound of the vibrating machine
in-the-cut = In the cut
remaining-left-at-the-programmed-cut-worn-ou = { $remaining } left at the programmed cut, worn out by its sound
remaining-left-at-the-programmed-cut = { $remaining } left at the programmed cut
no-estimate-yet = no estimate yet
estimated-once-the-cut-is-simulated = estimated once the cut is simulated
every-ten-minutes-the-cutting-speed-is-set-s = Every ten minutes the cutting speed is set so that the tool reaches the desired tool life, as far as its sound shows it
adjust-the-speed = Adjust the speed
worn-out-after-time-at-last-speed = worn out after { $time }, at last { $speed }
not-worn-out-in-ten-times-the-desired-tool-l = not worn out in ten times the desired tool life, at last { $speed }
cutting-minute-minute-at-last-speed = cutting: minute { $minute }, at last { $speed }
sound-spectrum = Sound spectrum
sharp-tool = sharp tool
worn-out = worn out
trends-over-the-life-each-from-0-to-1 = Trends over the life, each from 0 to 1
sound-e-s = sound E_S
roughness-ra = roughness Ra
predicted-life = Predicted life
t-90-of-the-belief = 90 % of the belief
from-the-sound = from the sound
desired = desired
true = true
the-equations-are-being-solved-for-every-sec = The equations are being solved for every second.
here-found-r-r-largest-difference-difference = Here: found R = { $r }, largest difference { $difference }.
here-with-the-noise-of-the-settings-r-r = Here: with the noise of the settings R = { $r }.
the-paper-claim = The paper: { $claim }.

## src/app/panels/papers/calibrations.rs

met-of-all-worst = { $met } of { $all }, { $worst }
sim = Sim
met-of-all = { $met } of { $all }
the-calibrations-side-by-side = The calibrations side by side
in-each-cell-final-values-of-the-row-within = In each cell: final values of the row within their bands, and the largest residual in bands. Plant and controller have the same calibration, the plant's force is the formula's.
progress-done = { $progress } done.

## src/app/panels/papers/claim.rs

model = Model
claimed = claimed
median = median
the-claim-about-forces-4-against-6 = The claim about forces: 4 % against 6 %
the-paper-claim-errors-of-the-force-here-ove = The paper: { $claim }. Errors of the force here over the same { $n } fresh rows.

## src/app/panels/papers/deviations.rs

ra-printed = Ra printed
ra-run = Ra run
force-printed = force printed
printed-read-corrected = 
    { $printed }
    ({ $read } corrected)
force-run = force run
the-findings-speak-of-at-most-4-1-in-ra-and = The findings speak of at most 4.1 % in Ra and 5.2 % in force. Table 3 itself, final value against desired value, says more: { $extremes }. Proportional feedback leaves a steady-state error. With the identified models the runs leave the same one.
section-4-makes-the-difference-between-desir = Section 4 makes the difference between desired and simulated Ra the criterion and finds the model "efficient at gaining the desired surface roughness", without a figure for it. Table 1 itself gives one: { $extremes }. Proportional feedback leaves a steady-state error. With the identified models the runs leave one of the same kind: too rough in the fine cuts, too fine in the rough ones.
ra-is-off-by-high-in-simulation-first-to-low = Ra is off by { $high } in simulation { $first } to { $low } in simulation { $second }
the-paper-s-own-deviations = The paper's own deviations

## src/app/panels/papers/machine.rs

springs-k-m-2-f-dampers-c-k-m-q-printed-then = Springs k = m (2 π f)², dampers c = √(k m) / Q: printed, then by the rule.
node = Node
verdict = Verdict
printed-rule-rule = { $printed }, rule { $rule }
open-machine = Open Machine
what-the-equations-give = What the equations give
reproduced = Reproduced
not-reproduced-and-why = Not reproduced, and why

## src/app/panels/papers/table.rs

start-feed = Start feed
start-speed = Start speed
final-force = Final force
final-feed = Final feed
final-speed = Final speed
produced-ra = Produced Ra
opens-the-scenario-name-in-the-console = Opens the scenario { $name } in the console
given = given
residual-met = { $residual } met
residual-missed = { $residual } missed
printed-compared-with-read = { $printed } (compared with { $read })
at-the-end-of-simulation-number-states = At the end of simulation { $number }: { $states }.
simulation-number-note = Simulation { $number }: { $note }.
force-without-a-verdict-the-paper-does-not-s = { $force }: without a verdict, the paper does not say how it gets it.
in-each-cell-printed-then-run-below-residual = In each cell: printed, then run; below: residual and verdict.
run = run
residual = residual
simulation-number = Simulation { $number }

## src/app/panels/papers.rs

papers = Papers
tables-errata-reproduction-published-calibra = tables errata reproduction published calibrations
calibration-of-plant-and-controller = Calibration of plant and controller:
plant-s-force-from = Plant's force from:
papers-paper = Papers: { $paper }
calibrations-paper = Calibrations: { $paper }
claim-about-forces = Claim about forces
combined-system-2005-table-1 = Combined system 2005, Table 1
dynamic-model-2019-table-1 = Dynamic model 2019, Table 1
paper = Paper:
table-1-compares-six-ways-of-control-on-expe = Table 1 compares six ways of control on Experiment 2. Its figures stand beside runs over many seeds, with what was chosen in view of them, on the screen Compare.
open-compare = Open Compare
load-experiment-1 = Load Experiment 1
load-the-five-steps = Load the five steps
on-the-command-line-steadycut-papers-paper-2 = On the command line: steadycut papers --paper 2005, with --robustness and --beyond.
go-on-with-the-table = Go on with the table
final-values-as-they-are-the-table-s-forces = Final values as they are: the table's forces come from the formula, another force model of the plant gives others by nature
no-simulation-is-done-yet = No simulation is done yet
each-row-is-run-in-time-from-its-printed-sta = Each row is run in time from its printed start values, noise off, SDNRP; the final values are means over the last of 15 s.
met-force-within-force-feed-feed-speed-speed = Met: force within { $force } %, feed { $feed } %, speed { $speed } %, Ra { $ra }.
errata = Errata
here-resolution = Here: { $resolution }
met-of-n-final-values-met = { $met } of { $n } final values met
met-of-n-final-values-met-so-far = { $met } of { $n } final values met so far
met-of-n-final-values-met-by-models-fitted-t = { $met } of { $n } final values met, by models fitted to these very rows
met-of-n-final-values-met-so-far-by-models-f = { $met } of { $n } final values met so far, by models fitted to these very rows
met-of-n-final-values-met-by-formulas-of-one = { $met } of { $n } final values met, by formulas of one's own
met-of-n-final-values-met-so-far-by-formulas = { $met } of { $n } final values met so far, by formulas of one's own

## src/app/panels/plan/answer.rs

the-search-was-stopped-move-the-swarm-goes-o = The search was stopped; “Move the swarm” goes on with it.
the-swarm-is-still-searching-to-the-end-shor = The swarm is still searching; “To the end” shortens it.
not-programmed-why = Not programmed: { $why }.
the-plan-is-programmed-feed-and-speed-the-pa = The plan is programmed, { $feed } and { $speed }: the part is cut from its start, at constant feed.
the-plan-is-programmed-feed-and-speed-the-pa-2 = The plan is programmed, { $feed } and { $speed }: the part is cut from its start, { $controller } moves the feed on from there.
best-so-far = Best so far
optimum = Optimum
no-optimum = No optimum
the-network-does-not-know-this-cut-material = The network does not know this cut: material, hardness or depths lie outside its training data, and the force is continued.
cut-it-at-constant-feed = Cut it at constant feed
programs-this-feed-and-speed-switches-the-co = Programs this feed and speed, switches the controller to constant feed, and cuts from the start on the console: the cut that is planned here. One step of undo.
use-as-programmed-values = Use as programmed values
programs-this-feed-and-speed-keeps-all-else = Programs this feed and speed, keeps all else, and cuts from the start on the console. Constant feed as programmed is then this feed; a controller that sets the feed by its own models goes to the same feed as before. One step of undo.
controller-moves-the-feed-on-from-the-progra = { $controller } moves the feed on from the programmed one at once.
the-console-s-force-at-the-playhead-is-force-2 = The console's force at the playhead is { $force }, { $off } against the plan's at its depth, { $depth }.
feed-per-tooth = Feed per tooth
cutting-speed = Cutting speed
removal = Removal
time-at-this-feed = Time at this feed
with-tool-changes = with tool changes
cost-of-cut-your-currency = Cost of cut, your currency
objective = Objective

## src/app/panels/plan/controls.rs

changed-during-the-cut-after-its-start-names = Changed during the cut, after its start: { $names }.
makes-the-values-at-the-playhead-those-of-th = Makes the values at the playhead those of the start, and plans for them
plan-for-the-values-now = Plan for the values now
what-is-sought = What is sought
the-heavier-a-weight-beside-the-others-the-m = The heavier a weight beside the others, the more the plan goes that way: a large force is one near its limit, and takes a larger feed. A weight that stands alone changes nothing by its size.
the-cut = The cut
swarm = Swarm
costs-and-times = Costs and times
a-plan-is-made-before-the-cut-changes-here-h = A plan is made before the cut: changes here hold from its start on.

## src/app/panels/plan/convergence.rs

mean-of-all-particles = mean of all particles
best-allowed = best allowed
particles-at-an-allowed-place = particles at an allowed place [%]
allowed = Allowed

## src/app/panels/plan/legend.rs

the-map = the map
equal-force = equal force
particles-full-allowed = particles (full: allowed)
their-own-bests = their own bests
best-of-all = best of all
the-speed-searched = the speed searched
outside-the-map = Outside the map:
constraint-violated = { $constraint } (violated)
placeholder-no-public-data-of-this-machine-w = placeholder: no public data of this machine were found
a-chosen-limit-of-the-process = a chosen limit of the process
given-by-the-settings-or-a-data-sheet = given by the settings or a data sheet
limit-limits-unit-source = Limit: { $limits } { $unit } ({ $source }).
the-constraint-is-origin = The constraint is { $origin }.

## src/app/panels/plan/map.rs

cutting-speed-m-min = cutting speed [m/min]
feed-per-tooth-mm = feed per tooth [mm]
zoom-to-allowed = Zoom to allowed
shows-the-part-of-the-map-that-holds-allowed = Shows the part of the map that holds allowed cuts
there-are-none-on-the-map = There are none on the map
shows-the-whole-map-as-a-double-click-on-it = Shows the whole map, as a double-click on it does; a drag on it zooms
whole-map = Whole map
force-over-cutting-speed-and-feed-per-tooth = Force over cutting speed and feed per tooth; optimum at { $speed } and { $feed }
force-over-cutting-speed-and-feed-per-tooth-2 = Force over cutting speed and feed per tooth; best so far at { $speed } and { $feed }

## src/app/panels/plan/readout.rs

force-by-the-network = Force by the network
force-in-the-run = Force in the run
ra-of-feed-marks = Ra of feed marks
spindle-power = Spindle power
deflection = Deflection
tool-life = Tool life
in-the-run-held = In the run: { $held }
allowed-by-the-plan = allowed by the plan
violated-by-the-plan-s-own-forces-constraint = violated by the plan's own forces: { $constraints }
let-go-of-this-place = Let go of this place
force-by-the-plan-s-network-in-colour-where = Force by the plan's network: in colour where the cut is allowed, grey where a constraint forbids it

## src/app/panels/plan/recommended.rs

recommended-conditions = Recommended conditions
by-r-d-engagement = by R_D: { $engagement }
engagement = Engagement
engagement-how-the-cutter-stands-in-the-mate = Engagement: how the cutter stands in the material
for-hardness-hb-a-cutter-of-diameter-engagem = For { $hardness } HB, a cutter of { $diameter }, { $engagement }:
speed-feed-a-tooth = { $speed }, { $feed } a tooth
inside-the-table = inside the table
outside-the-table-its-edge-answers = outside the table: its edge answers
programs-these-values-as-a-start-for-the-pla = Programs these values, as a start for the plan and the cut. One step of undo.
start-from-it = Start from it
the-table-note = The table: { $note }.

## src/app/panels/plan/relief.rs

turns-the-surface-so-does-a-drag-with-the-mo = Turns the surface; so does a drag with the mouse
turn-left = Turn left
turn-right = Turn right
force-surface-in-space-turned-by-turn-seen-t = Force surface in space, turned by { $turn }°, seen { $tilt }° from above

## src/app/panels/plan/search.rs

plan-search-of-the-swarm = Plan: search of the swarm

## src/app/panels/plan/steps.rs

no-plan = no plan
nothing-feasible-values = nothing feasible: { $values }
found-values = found: { $values }
best-so-far-values = best so far: { $values }
values-the-optimum = { $values }, the optimum
values-not-the-optimum = { $values }, not the optimum
the-optimal-cutting-conditions-are-found-by = The optimal cutting conditions are found by PSO-NN
they-are-programmed = They are programmed
the-desired-roughness-is-set = The desired roughness is set
the-reference-force-follows-from-letter-1 = The reference force follows from { $letter }1
feed-and-speed-are-commanded-controller = Feed and speed are commanded ({ $controller })
the-measured-force-is-compared-with-the-refe = The measured force is compared with the reference
in-the-air = in the air
the-overrides-go-back-to-the-machine = The overrides go back to the machine
steps-5-to-7-are-repeated-to-the-end = Steps 5 to 7 are repeated to the end
control-sample-number-of-all = control sample { $number } of { $all }
the-strategy-in-eight-steps = The strategy in eight steps
control-strategy-2013-section-2-values-at-th = Control strategy 2013, section 2; values at the playhead of the run.

## src/app/panels/plan/table.rs

the-seven-constraints-there-at-depth-depth = The seven constraints there, at { $depth } depth
the-list-is-origin = The list is { $origin }.
constraint = Constraint
value = Value
limit = Limit
margin = Margin
n-limits-of-the-machine-are-placeholders-no = { "*" } { $n } limits of the machine are placeholders: no public data were found.
explain-constraint = Explain { $constraint }
binding = binding

## src/app/panels/plan/transport.rs

again-from-the-same-random-start = Again from the same random start
search-again = Search again
the-swarm-stands-still = The swarm stands still
pause-the-swarm = Pause the swarm
the-swarm-moves-on-at-its-end-again-from-the = The swarm moves on; at its end: again from the start
move-the-swarm = Move the swarm
one-iteration-of-the-swarm = One iteration of the swarm
one-iteration = One iteration
to-the-end-of-the-search = To the end of the search
to-the-end = To the end
another-seed-another-random-start-and-nearly = Another seed: another random start, and nearly the same optimum
other-seed = Other seed
done-iteration-iteration-of-at-most-most = done: iteration { $iteration } of at most { $most }
stopped-iteration-iteration-of-at-most-most = stopped: iteration { $iteration } of at most { $most }
searching-iteration-iteration-of-at-most-mos = searching: iteration { $iteration } of at most { $most }
n-evaluations-of-the-force-surface = { $n } evaluations of the force surface
at-once = at once
speed-of-the-swarm = Speed of the swarm

## src/app/panels/plan.rs

plan = Plan
optimise-optimum-cutting-conditions-swarm-co = optimise optimum cutting conditions swarm constraints feed speed particle
settings-of-the-plan = Settings of the plan
programmed-now = programmed now
programmed-now-outside-the-map = programmed now: outside the map
the-force-as-a-surface-in-space-cut-by-the-p = The force as a surface in space, cut by the plane of its limit
n-iterations-of-the-swarm = { $n } iterations of the swarm
no-plan-can-be-made = No plan can be made
the-settings-are-beside-or-below = The settings are beside or below.

## src/app/panels/workpiece/blank.rs

the-part-is-another-one-than-that-of-name-no = The part is another one than that of { $name } now: its blank is not shown.
the-blank-of-name-is-not-shown-why = The blank of { $name } is not shown: { $why }.
name-was-cut-with-another-cutter-cut-it-from = { $name } was cut with another cutter: cut it from the blank again to see that.
in-the-air-line-line = in the air, line { $line }
axial-deep-radial-wide-line-line = { $axial } deep, { $radial } wide, line { $line }
this-part-is-a-table-of-depths-along-its-way = This part is a table of depths along its way, which has no shape in space: shown is the strip along the way. A part that is made of a program here is shown as its blank, too.
the-blank-in-space-as-it-is-cut-up-to-the-pl = The blank in space, as it is cut up to the playhead
blank = Blank
the-way-made-straight-with-the-fine-surface = The way made straight, with the fine surface of the finished wall
strip-along-the-way = Strip along the way
blank-in-space-place = Blank in space, { $place }
blank-x-y-z-mm = blank { $x } × { $y } × { $z } mm

## src/app/panels/workpiece/judged.rs

within = within
too-rough-up-to-twice-as-far-off = too rough, up to twice as far off
rougher-still = rougher still
smoother-than-asked = smoother than asked
too-large-up-to-twice-as-far-off = too large, up to twice as far off
larger-still = larger still
smaller-than-asked = smaller than asked

## src/app/panels/workpiece/picture.rs

heights = heights ×
part-in-space-place-heights-drawn-times-time = Part in space, { $place }, heights drawn { $times } times larger
tool-length-before-the-part = tool { $length } before the part
tool-at-place-of-length-mm = tool at { $place } of { $length } mm
cut-number-of-all-tool = cut { $number } of { $all }, { $tool }

## src/app/panels/workpiece/placed.rs

that-is-beside-the-part = That is beside the part.
kind-press-on-the-part-to-place-it-escape-le = { $kind }: press on the part to place it; Escape leaves
choose-one-then-press-on-the-part-where-it-i-2 = Choose one, then press on the part where it is to begin; behind the tool the cut is done again. With Shift held the next press places another one.
disturb-the-part = Disturb the part
choose-one-then-press-on-the-part = Choose one, then press on the part
then-press-on-the-part = Then press on the part.

## src/app/panels/workpiece/profile_chart.rs

as-the-teeth-left-it = as the teeth left it
roughness-profile = roughness profile
profile-m = Profile [µm]
name-height-along-along-the-line = 
    { $name }: { $height }
    { $along } along the line
profile-from-from-to-to-along-the-line = Profile from { $from } to { $to } along the line

## src/app/panels/workpiece/profilometer/fields.rs

a-drag = A drag
draws-the-line = draws the line
turns-the-part = turns the part
no-tooth-has-been-in-this-cut-yet-there-is-n = No tooth has been in this cut yet: there is no surface to measure.
from-x = From x
from-y = From y
to-x = To x
to-y = To y
five-sampling-lengths-along-the-feed-as-the = Five sampling lengths along the feed, as the tool goes on
behind-the-tool = Behind the tool
length-long = { $length } long
over-one-sampling-length-of-long-the-standar = Over one sampling length of { $long }; the standard takes five.
over-n-sampling-lengths-of-long-the-standard = Over { $n } sampling lengths of { $long }; the standard takes five.
over-n-sampling-lengths-of-long = Over { $n } sampling lengths of { $long }.
the-run-s-ra-with-dynamics-is-ra-along-the-l = The run's Ra with dynamics is { $ra } along the line on average.
simulated-tooth-by-tooth-k5-gives-no-ra-here = Simulated tooth by tooth, K5 gives no Ra here: feed marks and run-out alone.

## src/app/panels/workpiece/program/picture.rs

what-is-left-of-the-blank-from-above-with-th = What is left of the blank, from above, with the way of the tool

## src/app/panels/workpiece/program.rs

part-of-a-program = Part of a program
name-n-moves = { $name }: { $n } moves
size-and-corner-of-the-rectangular-blank-in = Size and corner of the rectangular blank in the coordinates of the program; at first it lies about the feed moves, with 5 mm below the deepest one.
cut-it-from-the-blank = Cut it from the blank
with-the-cutter-of-the-scenario = With the cutter of the scenario
size = Size
size-of-the-blank-along-axis = Size of the blank along { $axis }
least-corner = Least corner
least-corner-of-the-blank-along-axis = Least corner of the blank along { $axis }
step = Step
step-along-the-way = Step along the way
milling-name = Milling: { $name }
length-long-air-of-it-air-up-to-axial-deep-a = { $length } long, { $air } of it air; up to { $axial } deep and { $radial } wide
make-it-the-part = Make it the part
it-was-cut-with-another-cutter-cut-it-again = It was cut with another cutter: cut it again

## src/app/panels/workpiece/view.rs

whole-part = Whole part
all-of-the-present-cut = All of the present cut
at-the-tool = At the tool
goes-along-with-the-tool = Goes along with the tool
the-surface-right-behind-the-tool-near-enoug = The surface right behind the tool, near enough to see each tooth's mark
close-up = Close up
nearer = Nearer
nearer-so-does-the-wheel = Nearer; so does the wheel
farther = Farther
farther-so-does-the-wheel = Farther; so does the wheel
turns-the-picture-so-does-a-drag-over-it = Turns the picture; so does a drag over it
higher = Higher
lower = Lower
follow-the-tool = Follow the tool
fingers-on-the-picture-turn-the-part-otherwi = Fingers on the picture turn the part; otherwise they scroll the page
turn-by-touch = Turn by touch
a-factor-of-your-own-otherwise-as-the-distan = A factor of your own; otherwise as the distance wants it
own-factor = Own factor

## src/app/panels/workpiece.rs

part-surface-3d-profile-roughness-profilomet = part surface 3d profile roughness profilometer picture
a-table-of-depths-along-a-path-csv-or-a-prog = A table of depths along a path (CSV), or a program (G-code) that is cut from a blank; both can be dropped onto the window, too
part-from-a-file = Part from a file…
a-stylus-drawn-along-a-line-over-the-machine = A stylus drawn along a line over the machined surface: its profile, Ra, Rq, Rz
profilometer = Profilometer
colour-ra-against-its-tolerance = Colour: Ra against its tolerance
colour-ra-with-dynamics-against-its-toleranc = Colour: Ra with dynamics against its tolerance
colour-force-against-its-tolerance = Colour: force against its tolerance
colour-force-without-dynamics-against-its-to = Colour: force without dynamics against its tolerance
outside-the-model-not-judged = outside the model: not judged
disturbances-along-the-edges-of-the-part = disturbances, along the edges of the part
cutting-edges = cutting edges
scrap-length-mm-at-a-cost-of-cost = Scrap: { $length } mm, at a cost of { $cost }
length-of-the-way-beyond-the-tolerance-on-th = Length of the way beyond the tolerance on the bad side, by `economics.scrap_cost_per_mm`
the-cutter-is-drawn-turning-times-times-slow-2 = The cutter is drawn turning { $times } times slower.
the-blank-has-its-true-size-what-is-cut-has = The blank has its true size; what is cut has the colour of the moment in which the cutter was there last.
too-rough-is-rework-or-scrap-smoother-than-a = Too rough is rework or scrap; smoother than asked is neither.
what-stands-in-front-of-the-wall-was-taken-b = What stands in front of the wall was taken by an earlier cut.
simulated-tooth-by-tooth-k5-s-ra-does-not-ho = Simulated tooth by tooth, K5's Ra does not hold: the surface shows feed marks and run-out alone.
