# Texts of the program, written by its tests: see ARCHITECTURE.md.

## crates/study/src/afc.rs

cut-number-is-not-reached-within-run-duratio = cut { $number } is not reached within `run.duration_s`, { $limit } s
cut-number-refused = cut { $number }: { $refused }

## crates/study/src/compare/by_hand.rs

your-hand-2 = Your hand
name-alone-holds-it-in-time-s = { $name } alone holds it, in { $time } s
count-ways-of-control-hold-it-name-the-faste = { $count } ways of control hold it, { $name } the fastest in { $time } s
no-way-of-control-holds-it-either = no way of control holds it either
your-cut-did-not-come-to-its-end-so-it-has-n = Your cut did not come to its end, so it has no rank ({ $why }); { $best }.
nothing-of-your-cut-can-be-judged-so-it-has = Nothing of your cut can be judged, so it has no rank; { $best }.
you-held-ra-in-tolerance-on-inside-of-the-le = You held Ra in tolerance on { $inside } % of the length, and { $asked } % are asked for: no rank; { $best }.
you-held-the-force-in-tolerance-on-inside-of = You held the force in tolerance on { $inside } % of the length, and { $asked } % are asked for: no rank; { $best }.
you-held-ra-in-tolerance-on-inside-of-the-le-2 = You held Ra in tolerance on { $inside } % of the length
you-held-the-force-in-tolerance-on-inside-of-2 = You held the force in tolerance on { $inside } % of the length
begin-and-no-way-of-control-holds-it-the-cut = { $begin }, and no way of control holds it: the cut is yours.
as-fast-as-name = as fast as { $name }
time-s-slower-than-name = { $time } s slower than { $name }
time-s-faster-than-name = { $time } s faster than { $name }
begin-and-come-in-as-number-rank-of-the-of-w = { $begin } and come in as number { $rank } of the { $of } who hold it: { $than }, the fastest of the controllers.
cuts-2 = cuts

## crates/study/src/compare/entrants.rs

conventional = Conventional
division = Division
adjustable-pi = Adjustable PI
p-smith-predictor = P, Smith predictor
mrac-one-gain = MRAC, one gain
preview = Preview
tracking = Tracking
own-script = Own script

## crates/study/src/compare/iterations.rs

runs = runs

## crates/study/src/compare/load_step.rs

never-back = never back

## crates/study/src/compare/outcome.rs

periods-2 = periods
more-is-better = More is better.
less-is-better = Less is better.

## crates/study/src/compare/outside.rs

ra-lies-within-its-tolerance-wherever-it-is = Ra lies within its tolerance wherever it is judged
the-force-lies-within-its-tolerance-wherever = the force lies within its tolerance wherever it is judged
the-machine-s-vibration-leaves-it-without-dy = the machine's vibration leaves it, without dynamics Ra is inside
feed-and-speed-stay-as-programmed-whatever-t = feed and speed stay as programmed, whatever the cut does
it-is-not-taught-in-so-the-feed-stays-as-pro = it is not taught in, so the feed stays as programmed
on-share-of-that-it-is-unstable-feed-and-for = on { $share } % of that it is unstable, feed and force swing without dying down
on-share-of-that-a-command-stands-at-its-lim = on { $share } % of that a command stands at its limit
it-holds-the-force-and-leaves-to-the-model-w = it holds the force, and leaves to the model what Ra that gives
its-law-does-not-integrate-an-error-remains = its law does not integrate: an error remains at rest
it-takes-time-after-each-change-and-noise-mo = it takes time after each change, and noise moves it
it-takes-time-after-each-change = it takes time after each change
ra-lies-above-its-tolerance-on-above-and-bel = Ra lies above its tolerance on { $above } % and below its tolerance on { $below } % of the length: { $cause }
ra-lies-above-its-tolerance-on-share-of-the = Ra lies above its tolerance on { $share } % of the length: { $cause }
ra-lies-below-its-tolerance-on-share-of-the = Ra lies below its tolerance on { $share } % of the length: { $cause }
the-force-lies-above-its-tolerance-on-above = the force lies above its tolerance on { $above } % and below its tolerance on { $below } % of the length: { $cause }
the-force-lies-above-its-tolerance-on-share = the force lies above its tolerance on { $share } % of the length: { $cause }
the-force-lies-below-its-tolerance-on-share = the force lies below its tolerance on { $share } % of the length: { $cause }

## crates/study/src/compare/robustness.rs

no-dead-time = no dead time
dead-time-40-ms = dead time 40 ms
dead-time-80-ms = dead time 80 ms
t-16mncrsi5-in-place-of-ck45 = 16MnCrSi5 in place of Ck45
name-before-and-after-kn = { $name } { $before } and { $after } kN
unks-is-insensitive-to-the-workpiece-s-mater = UNKS is insensitive to the workpiece's material
largest-force-in-ck45-and-in-16mncrsi5-list = largest force in Ck45 and in 16MnCrSi5: { $list }

## crates/study/src/compare/table_1.rs

the-part-eight-candidates-were-tried-convent = the part: eight candidates were tried; conventional milling's row is calibrated by it, not predicted, and so is a best possible time near 88 s; the path of 488 mm follows from 115 s
inhomogeneity-5-run-out-3-um-air-feed-150-de = inhomogeneity 5 %, run-out 3 um, air feed 150 %, dead time 40 ms: set once by plausibility, looking at conventional milling and at an ideal controller
p-kp-1-1-is-the-stability-limit-at-the-heavi = P: Kp = 1.1 is the stability limit at the heaviest section; with the Smith predictor 1.6, of seven values the one nearest to the paper
mrac-some-25-settings-of-two-structures-were = MRAC: some 25 settings of two structures were tried; the five-parameter one shipped is the one nearest to the table, the one-gain one is the best and does not resemble it; the five-parameter one raises the override by at most 10 % a period, since with 30 % extreme force stopped it with 3 of 20 seeds
division-of-three-readings-the-static-one-si = division: of three readings the static one, since it alone is stable, takes some 98 s and is poor in Nsn at once
adjustable-pi-and-unks-first-guesses-kept-af = adjustable PI and UNKS: first guesses, kept after 11 and 9 other settings; not fitted to the table, but their Nsn and largest force could be seen while the part was chosen
experiment-1-lengths-and-depths-are-chosen-s = Experiment 1: lengths and depths are chosen so that the last section sits at 650 N and the gain comes near 27 %
not-used-for-any-choice-dead-times-and-mater = not used for any choice: dead times and materials of the robustness table, the noise-free reference runs; what counts as re-entering after the load step was defined anew twice, since the first two definitions never came about
the-figures-with-the-part-and-the-traces-are = the figures with the part and the traces are missing: agreement shows that the table is physically possible with real force constants and a cap of 150 %, no more
division-0-29-and-1-25-kn-static-division-is = division 0.29 and 1.25 kN: static division is smooth by construction; on the last command it oscillates instead, and slowed down it is better than printed, not worse
pi-94-s-any-integrating-controller-runs-the = PI 94 s: any integrating controller runs the light sections at the cap of 150 % and needs no more than some 89 s here; 6 s between PI and UNKS at nearly equal Nsn cannot come from holding the force alone
mrac-s-time-in-every-run-with-five-parameter = MRAC's time in every run: with five parameters it bursts, and with some seeds an overload stops it; with one gain it does not burst
p-0-20-kp-1-1-is-all-that-the-dead-time-leav = P 0.20: Kp = 1.1 is all that the dead time leaves; with the Smith predictor and 1.6 it comes near
mrac-0-90-unks-0-91-and-pi-1-00-kn-reached-o = MRAC 0.90, UNKS 0.91 and PI 1.00 kN: reached on a smooth plant only; tooth by tooth, run-out and inhomogeneity put their peaks on top of what is held
the-time-of-an-optimisation-step-what-was-ti = the time of an optimisation step: what was timed, and what its iterations are, is not said; reported here are the cost of an update and the control periods after a load step
mrac-s-response-8-longer-constant-roughness = MRAC's response 8 % longer, constant roughness, the learning curves: the paper has no data
no-run-has-given-it = no run has given it
name-measure-within-percent-of-wanted = { $name }: { $measure } within { $percent } % of { $wanted }
mean-off = { $mean }, { $off } %
mean-off-over-the-finished-of-runs-runs-that = { $mean }, { $off } % over the { $finished } of { $runs } runs that came to the end
unks-and-pi-the-next-has-next = { $unks } and { $pi }; the next has { $next }
unks-and-adjustable-pi-are-the-two-best-in-n = UNKS and adjustable PI are the two best in Nsn
unks-measure-at-most-most = UNKS: { $measure } at most { $most }
n-periods-after-the-load-step = , { $n } periods after the load step
unstable-after-the-load-step = , unstable after the load step
never-back-after-the-load-step = , never back after the load step
name-error-time-s-step = { $name } ({ $error } %, { $time } s{ $step })
nobody-is-within-percent-next-is-next = nobody is within { $percent } %, next is { $next }
within-percent-of-it-list = within { $percent } % of it { $list }
least-nsn-name-with-error-in-time-s-step-bes = least Nsn: { $name } with { $error } in { $time } s{ $step }; { $beside }
measure-in-unit = { $measure } in { $unit }

## crates/study/src/csv_table.rs

there-is-no-line-with-the-names-of-the-colum = there is no line with the names of the columns
line-line-has-values-values-for-columns-colu = line { $line } has { $values } values for { $columns } columns; numbers with decimal commas need semicolons between them, as in `0,5;1,2`
line-line-has-values-values-for-columns-colu-2 = line { $line } has { $values } values for { $columns } columns
line-line-name-is-cell-allowed-is-a-finite-n = line { $line }: `{ $name }` is `{ $cell }`: allowed is a finite number
line-line-comma-has-a-comma-which-separates = line { $line }: `{ $comma }` has a comma, which separates the values of this table: write a decimal point, or separate the values by semicolons
line-line-has-comma-line-other-cell-write-al = line { $line } has `{ $comma }`, line { $other } `{ $cell }`: write all numbers with the same decimal sign, and nothing between thousands
there-is-no-line-with-the-names-of-the-colum-2 = there is no line with the names of the columns; needed are { $needed }
the-columns-are-found-missing-are-missing-ne = the columns are { $found }; missing are { $missing }; needed are { $needed }
the-column-name-stands-there-more-than-once = the column { $name } stands there more than once

## crates/study/src/errata.rs

t-1-0-001024-s-2-0-064-s-1-beside-natural-freq = 1 / (0.001024 s^2 + 0.064 s + 1) beside "natural frequency of 3 Hz and a settling time of 0.4 s"
its-natural-frequency-is-4-97-hz-critically = its natural frequency is 4.97 Hz, critically damped; 3.2 Hz is its -3 dB bandwidth; it settles to 2 % in 0.19 s, to 0.5 % in 0.24 s
both-are-kept-as-separate-drives-2013-eq1-an = both are kept as separate drives, 2013_eq1 and measured_3hz
dead-time-2 = dead time
the-paper-has-none-2013-has-0-04-s-2007-e-0 = the paper has none; 2013 has 0.04 s, 2007 e^(-0.08 s)
t-0-04-s-two-control-periods-papers-paper-2005 = 0.04 s, two control periods; `papers --paper 2005 --robustness` shows 0, 40 and 80 ms
radial-depth-r-d-4-mm-in-the-english-text-3 = radial depth R_D: 4 mm in the English text, 3 mm in the Slovene
they-differ-and-so-does-the-force-404-agains = they differ, and so does the force: 404 against 281 N at 0.08 mm and A_D = 2 mm
presets-experiment-1-with-4-mm-and-experimen = presets experiment-1 with 4 mm and experiment-1-sl with 3 mm; 280 N as desired force belongs to 3 mm (`steadycut force`)
experiment-1-desired-force-280-n-in-the-set = Experiment 1: desired force 280 N in the set-up, 650 N in the discussion
at-r-d-4-mm-already-the-starting-depth-takes = at R_D = 4 mm already the starting depth takes 404 N
t-650-n-with-r-d-4-mm-280-n-with-r-d-3-mm = 650 N with R_D = 4 mm, 280 N with R_D = 3 mm
experiment-2-desired-force-650-n-in-the-text = Experiment 2: desired force 650 N in the text, 0.665 kN in Table 1
they-differ-by-2 = they differ by 2 %
t-665-n = 665 N
experiment-1-a-time-saving-of-40-with-one-cu = Experiment 1: "a time saving of 40 % with one cut"
with-an-override-of-at-most-150-no-more-than = with an override of at most 150 % no more than 33.3 % is possible, and 27 % more removal rate is 21 % of time
the-gain-in-removal-rate-is-judged-the-time = the gain in removal rate is judged; the time is reported
table-1-times-of-88-to-115-s = Table 1: times of 88 to 115 s
t-0-08-mm-two-teeth-and-1591-5-1-min-are-254-6 = 0.08 mm, two teeth and 1591.5 1/min are 254.65 mm/min, so 115 s are a path of 488 mm and 76.7 s the least at 150 %
all-six-times-fit-a-constant-programmed-feed = all six times fit a constant programmed feed: the part has 488 mm
returns-the-cutting-force-value-to-the-desir = "returns the cutting-force value to the desired value level within four or less iterations"; the Slovene text adds 2 ms
t-0-5-ms-each-cannot-be-samples-of-20-ms = 0.5 ms each cannot be samples of 20 ms
read-as-iterations-of-the-internal-loop-with = read as iterations of the internal loop with NM-1 inside a control period
sampling-time-20-ms-28-8-khz = sampling time 20 ms, 28.8 kHz
t-576-samples-hold-one-tooth-period-of-18-85-m = 576 samples hold one tooth period of 18.85 ms, so run-out makes one peak high and the next one low
kept-what-is-judged-as-a-transient-is-the-me = kept; what is judged as a transient is the mean of four peaks
fig-5-a-step-of-the-feed-from-0-05-to-2-mm-t = Fig. 5: a step of the feed from 0.05 to 2 mm/tooth
t-2-mm-a-tooth-would-break-a-cutter-of-16-mm = 2 mm a tooth would break a cutter of 16 mm
read-as-0-2-mm-tooth = read as 0.2 mm/tooth
the-optimized-feedrate-would-always-be-equal = "the optimized feedrate would always be equal to the reference peak force"
a-feed-is-no-force-mistranslated = a feed is no force: mistranslated
read-as-the-right-override-would-be-100 = read as: the right override would be 100 %
a-d-and-r-d-in-the-english-text = "A_D" and "R_D" in the English text
in-another-order-than-in-the-slovene = in another order than in the Slovene
a-d-is-the-axial-depth-r-d-the-radial-one = A_D is the axial depth, R_D the radial one
fig-6-0-07-0-35-2-1-0-09-0-37-0-4 = Fig. 6: 0.07, 0.35, 2.1, 0.09, 0.37, 0.4
without-names-presumably-learning-rates-and = without names; presumably learning rates and momenta by layer
not-used-the-ranges-of-2013-are = not used; the ranges of 2013 are
table-1-optimization-time-and-iterations-0-0 = Table 1: "optimization time" and "iterations", 0.001 s / 18 to 0.012 s / 34
what-was-timed-and-what-was-counted-is-not-s = what was timed and what was counted is not said
beside-them-stand-a-controller-s-cost-per-up = beside them stand a controller's cost per update and its control periods after a load step
eq-2-the-normalised-standard-error-over-n-20 = eq. 2, the normalised standard error, over n = 20 samples
which-20-is-not-said-the-spread-over-seeds-i = which 20 is not said; the spread over seeds is some 0.02
over-all-samples-in-contact-the-form-with-20 = over all samples in contact; the form with 20, evenly spaced, stands beside it
t-8-s-time-delay = "t = 8 s: time delay"
the-transfer-functions-have-e-0-08-s = the transfer functions have e^(-0.08 s)
dead-time-0-08-s = dead time 0.08 s
eq-2-s-14-0-s-2-155-s-35500 = eq. 2: (s + 14.0) + (s^2 + 155 s + 35500)
a-sum-has-no-unit-gain-at-rest = a sum has no unit gain at rest
a-product-14-x-35500-497000-the-printed-nume = a product: 14 x 35500 = 497000, the printed numerator
eq-1-with-the-constants-of-table-1 = eq. 1 with the constants of Table 1
gives-582508-s-3-169-0-s-2-38699-7-s-582508 = gives 582508 / (s^3 + 169.0 s^2 + 38699.7 s + 582508), with other poles than eq. 2
both-are-kept-as-separate-drives-2007-eq1-an = both are kept as separate drives, 2007_eq1 and 2007_eq2
reference-roughness-0-81-mm = "reference roughness 0.81 mm"
the-unit = the unit
t-0-81-um = 0.81 um
k2-eq-5 = K2, eq. 5
the-feed-is-negative-for-every-force-below-1 = the feed is negative for every force below 177.07 N, that is for half of Table 3
re-identified-the-printed-form-runs-with-its = re-identified; the printed form runs with its commands limited and marked out of range
k1-eq-4 = K1, eq. 4
k1-0-81-um-188-0-n-where-table-3-has-178-5-n = K1(0.81 um) = 188.0 N where Table 3 has 178.5 N; at 0.38 um 139.7 N against 161.4 N
re-identified-from-table-3 = re-identified from Table 3
k3-eq-6 = K3, eq. 6
gives-about-4100-1-min-where-table-3-has-abo = gives about 4100 1/min where Table 3 has about 2100 1/min
k4-eq-7 = K4, eq. 7
exceeds-the-table-s-final-force-from-the-tab = exceeds the table's final force, from the table's own final feed and speed, by 32.8 N in simulations 1 to 9
only-the-intercept-is-wrong-253-66-in-place = only the intercept is wrong: 253.66 in place of 286.44 N meets all ten rows within 0.75 N
table-3-simulation-10-final-force-195-2-n = Table 3, simulation 10: final force 195.2 N
from-the-table-s-own-feed-and-speed-the-rest = from the table's own feed and speed the restored K4 gives 190.2 N, which also lies on the force-roughness curve of all other rows
taken-as-a-misprint-of-190-2-n-the-printed-v = taken as a misprint of 190.2 N; the printed value is shown beside it
k5-eq-8 = K5, eq. 8
misses-the-table-s-roughness-by-up-to-30 = misses the table's roughness by up to 30 %
the-exact-inverse-of-the-re-identified-k1 = the exact inverse of the re-identified K1
findings-deviation-of-ra-at-most-4-1-of-forc = findings: deviation of Ra at most 4.1 %, of force at most 5.2 %
in-the-paper-s-own-table-3-the-final-ra-is-o = in the paper's own Table 3 the final Ra is off its target by +31.6 % (simulation 1) to -22.4 % (simulation 10)
the-table-s-own-deviations-are-reported = the table's own deviations are reported
k1-to-k5-by-genetic-programming-from-185-mea = K1 to K5 by genetic programming from 185 measurements
the-measurements-were-never-published-and-th = the measurements were never published, and the table's final feeds and speeds lie on one line (correlation -0.995), which tells no formula of both
calibration-genetic-k1-k2-k3-and-k5-found-an = calibration genetic: K1, K2, K3 and K5 found anew in Table 3 by genetic programming, K4 the printed form with its constants fitted (`steadycut identify genetic`); all 40 final values lie within their bands
eq-3-m2-10-05-f-4 = eq. 3 (M2): "10^05 F^4"
can-only-be-10-5-and-rounded-so-m2-gives-neg = can only be 10^-5; and rounded so, M2 gives negative feeds of thousands at every force of Table 1
restored-with-1-426371e-5-f-4-1-015767e-2-f = restored with 1.426371e-5 F^4 - 1.015767e-2 F^3, which gives the final feeds of Table 3 of 2007 from its desired forces; re-identified from Table 1
eq-4-m3-exponent-0-004 = eq. 4 (M3): exponent -0.004
gives-about-3700-1-min-where-table-1-has-abo = gives about 3700 1/min where Table 1 has about 2200 1/min
restored-with-0-0071-which-gives-the-final-s = restored with -0.0071, which gives the final speeds from the initial forces within 4.7 %; re-identified
eq-6-m5-leading-coefficient-0-0001 = eq. 6 (M5): leading coefficient 0.0001
gives-0-11-to-0-14-um-where-table-1-has-0-44 = gives 0.11 to 0.14 um where Table 1 has 0.44 to 0.99 um, and turns round at 170.5 N, inside the table
restored-with-0-00012025-least-squares-which = restored with 0.00012025 (least squares), which still misses by up to 0.19 um; re-identified as the exact inverse of M1
eq-2-m1 = eq. 2 (M1)
m1-0-40-um-135-6-n-where-table-1-starts-from = M1(0.40 um) = 135.6 N where Table 1 starts from 164.5 N and ends at 157.5 N; at 1.11 um 219.5 N against 188.1 N
re-identified-from-table-1 = re-identified from Table 1
eq-5-m4 = eq. 5 (M4)
exceeds-the-table-s-final-force-from-the-tab-2 = exceeds the table's final force, from the table's own final feed and speed, by 12 to 28 N, and the initial force by 27 to 36 N; there is no one intercept that mends it
the-printed-form-with-its-intercept-and-feed = the printed form with its intercept and feed coefficient re-identified, its speed coefficient as printed
eq-1-1-0-001024-s-2-0-064-s-1-beside-natural = eq. 1: 1 / (0.001024 s^2 + 0.064 s + 1) beside "natural frequency of 3 Hz and a settling time of 0.4 s"
its-natural-frequency-is-4-97-hz-critically-2 = its natural frequency is 4.97 Hz, critically damped; 3.2 Hz is its -3 dB bandwidth
both-are-kept-as-separate-drives = both are kept as separate drives
neural-network-predictions-were-by-4-closer = "neural network predictions were by 4 % closer to the measurements, compared to 6 %"
the-3500-measurements-were-never-published-r = the 3500 measurements were never published; read as mean errors of 4 % and 6 %
networks-and-formulas-are-trained-on-one-dat = networks and formulas are trained on one data set from the mechanistic force model with measurement noise, the formula by genetic programming; their errors stand beside the paper's, true or not (`steadycut papers --paper 2013`)
section-2-1-seven-constraints-are-listed-in = section 2.1: "seven constraints are listed in [18]"
the-list-is-not-given = the list is not given
the-usual-seven-of-milling-each-marked-as-ch = the usual seven of milling, each marked as chosen, machine limits in a file of placeholders
table-1-simulations-6-and-7 = Table 1, simulations 6 and 7
the-force-differs-by-1-n-the-roughness-by-0 = the force differs by 1 N, the roughness by 0.17 um: the table is not smooth, no smooth function of force meets both
ra-is-judged-within-0-08-um = Ra is judged within 0.08 um
section-2-3-momentum-rates-between-0-008-and = section 2.3: "momentum rates between 0.008 and 0.01 are good" for small errors, but should "not exceed 0.004 if the number of training cycles is also to be minimized"
no-momentum-serves-both = no momentum serves both
steadycut-train-study-prints-both-rates-besi = `steadycut train --study` prints both rates beside others
m1-to-m5-by-genetic-programming-from-200-mea = M1 to M5 by genetic programming from 200 measurements
the-measurements-were-never-published-and-th-2 = the measurements were never published, and the table's final feeds and speeds lie on one line (correlation -0.937)
calibration-genetic-m1-m2-m3-and-m5-found-an = calibration genetic: M1, M2, M3 and M5 found anew in Table 1 by genetic programming, M4 the printed form with its speed coefficient as printed and the others fitted (`steadycut identify genetic`); all 32 final values lie within their bands

## crates/study/src/errata_2019.rs

eq-1-row-1-c3-z3-z2-k3-z3-z2 = eq. 1, row 1: + c3 (z3' - z2') + k3 (z3 - z2)
the-force-between-2-and-3-cannot-act-on-the = the force between 2 and 3 cannot act on the base, and its sign is that of no spring
c5-z5-z1-k5-z5-z1-row-5-of-eq-2-hangs-the-ta = - c5 (z5' - z1') - k5 (z5 - z1): row 5 of eq. 2 hangs the table on the base by k5
eq-1-row-2-no-term-with-k3-c3 = eq. 1, row 2: no term with k3, c3
the-tooth-s-spring-ends-on-nothing-momentum = the tooth's spring ends on nothing; momentum is not conserved
c3-z3-z2-k3-z3-z2-the-reaction-of-row-3 = - c3 (z3' - z2') - k3 (z3 - z2), the reaction of row 3
eq-1-row-4-c4-z4-z3-k4-z4-z3 = eq. 1, row 4: c4 (z4' - z3') + k4 (z4 - z3)
ties-the-slides-to-the-tooth-without-reactio = ties the slides to the tooth, without reaction in row 3, and contradicts row 4 of eq. 2
c4-z4-z5-k4-z4-z5 = c4 (z4' - z5') + k4 (z4 - z5)
eq-1-row-5-c5-z5-z4-k5-z5-z4 = eq. 1, row 5: - c5 (z5' - z4') - k5 (z5 - z4)
a-spring-of-negative-stiffness-k4-k5-remains = a spring of negative stiffness k4 - k5 remains: eq. 1 as printed is unstable, with a real pole at 2 pi x 194.9 rad/s with corrected numbers, at 2 pi x 4057 and 2 pi x 78659 rad/s with the printed ones
c5-z5-z1-k5-z5-z1 = + c5 (z5' - z1') + k5 (z5 - z1)
eq-2-row-1-k1-k2-k3-and-k3-i-w-c3-z3 = eq. 2, row 1: k1 + k2 + k3 and -(k3 + i w c3) z3
not-symmetric-row-3-has-no-z1-row-5-has-one = not symmetric: row 3 has no z1, row 5 has one without partner
t-5-for-3-three-times-k1-k2-k5-c1-c2-c5-k5-i-w = 5 for 3 three times: k1 + k2 + k5, c1 + c2 + c5, -(k5 + i w c5) z5
eq-2-row-2-k2-w-2-m2-i-w-c2 = eq. 2, row 2: (k2 - w^2 m2) + i w c2
the-tooth-s-reaction-is-missing-the-tool-poi = the tooth's reaction is missing: the tool point has 5.04e-9 m/N at rest where the mended machine has 1.28e-7, and no resonance of the spindle
k2-k3-w-2-m2-i-w-c2-c3-and-k3-i-w-c3-z3 = (k2 + k3 - w^2 m2) + i w (c2 + c3), and -(k3 + i w c3) z3
eq-2-row-3-k3-i-w-c3-z2-k3-w-2-m3-i-w-c3-z3 = eq. 2, row 3: [k3 + i w c3] z2 - [(k3 - w^2 m3) + i w c3] z3 = -P
the-left-side-is-that-of-eq-1-times-1-the-ri = the left side is that of eq. 1 times -1, the right side is not: both forces point the same way
the-left-side-times-1 = the left side times -1
eq-2-row-4-c-42 = eq. 2, row 4: c_42
there-is-no-such-coefficient = there is no such coefficient
c4 = c4
table-1-k4-6-3e12-n-m = Table 1: k4 = 6.3e12 N/m
the-rule-below-the-table-gives-6-26e8-with-6 = the rule below the table gives 6.26e8; with 6.3e12 c4 would be 1.46e7, not the printed 1.4e5
exponent-8 = exponent 8
table-1-c5-2-6e8-n-s-m = Table 1: c5 = 2.6e8 N s/m
the-rule-gives-2-62e5-2-6e8-means-q-0-003 = the rule gives 2.62e5; 2.6e8 means Q = 0.003
exponent-5 = exponent 5
table-1-c2-2348-n-s-m-beside-q-17 = Table 1: c2 = 2348 N s/m beside Q = 17
sqrt-k-m-2348-5-00-q-17-needs-691-and-repeat = sqrt(k m) / 2348 = 5.00; Q = 17 needs 691 and repeats the mass m2 = 17 of its column
q-5-17-can-be-chosen-machine-spindle-quality = Q = 5; 17 can be chosen (machine.spindle_quality)
table-1-k3-1-9e8-n-m-c3-0-5-n-s-m-m3-0-3e-6 = Table 1: k3 = 1.9e8 N/m, c3 = 0.5 N s/m, m3 = 0.3e-6 kg
m3-is-rounded-to-one-digit-its-rule-gives-k3 = m3 is rounded to one digit: its rule gives k3 = 2.03e8; no m3 that rounds to 0.3e-6 gives c3 = 0.5 with Q = 10
both-by-the-rule-c3-does-not-matter-up-to-30 = both by the rule; c3 does not matter up to 3000 Hz
table-1-unit-of-c-n-m-sec = Table 1: unit of c N/m/sec
a-damper-s-unit-is-n-s-m = a damper's unit is N s/m
n-s-m = N s/m
note-of-table-1-p-cf-107-n = note of Table 1: P_CF = 107 N
may-have-been-10-7-n-which-is-absurd-for-a-c = may have been 10^7 N, which is absurd for a cut
t-107-n-the-order-of-the-forces-of-2007-and-20 = 107 N, the order of the forces of 2007 and 2013
six-differential-equations-1 = "six differential equations (1)"
five-are-printed-for-five-nodes = five are printed, for five nodes
five-table-and-work-piece-are-one-node = five; table and work piece are one node
substitution-xi-tau-xi-a-exp-i-w-tau = "substitution xi(tau) = xi_A exp(i w tau)"
another-symbol-than-zeta-for-the-same-quanti = another symbol than zeta for the same quantity
zeta = zeta
section-3-fig-4a-spectra-roughness-figure-3a = section 3: "Fig. 4a .. spectra", "roughness (Figure 3a)"
the-captions-say-the-opposite = the captions say the opposite
t-3a-are-the-spectra-4a-is-the-roughness = 3a are the spectra, 4a is the roughness
names-of-the-nodes-against-eq-2 = names of the nodes against eq. 2
by-the-names-the-slides-carry-the-table-and = by the names the slides carry the table and the force acts on the table; by rows 4 and 5 the table carries the slides and the force acts on these
variant-a-by-the-equations-variant-b-by-the = variant A by the equations, variant B by the names (machine.variant); G_rel differs by 2.9 %

## crates/study/src/experiment/measure.rs

no-chip-is-cut = no chip is cut
its-ra-lies-beyond-the-end-of-the-plant-s-mo = its Ra lies beyond the end of the plant's model

## crates/study/src/experiment/plan.rs

run-run-error = run { $run }: { $error }

## crates/study/src/experiment/way/job.rs

cuts-cuts-is-not-possible-allowed-are-fewest = cuts: { $cuts } is not possible: allowed are { $fewest } to { $most }
name-value-is-not-possible-allowed-is-0-to-m = { $name }: { $value } is not possible: allowed is 0 to { $most }
there-are-no-models-yet = there are no models yet
the-table-has-no-such-row = the table has no such row
the-pilot-cuts-found-nothing = the pilot cuts found nothing
nothing-is-planned = nothing is planned
percent-of-the-way-2 = percent of the way

## crates/study/src/experiment/way/models.rs

its-front-is-empty = its front is empty
name-none-of-the-count-formulas-found-can-be = { $name }: none of the { $count } formulas found can be used: { $why }
formula-is-not-certain-to-rise-with-input-ov = `{ $formula }` is not certain to rise with { $input } over its cuts
formula-is-not-certain-to-fall-with-input-ov = `{ $formula }` is not certain to fall with { $input } over its cuts
column-has-no-unit = `{ $column }` has no unit

## crates/study/src/experiment/way/pilot.rs

pilot-cuts-error-give-another-depth = pilot cuts: { $error }: give another depth
pilot-cuts-no-chip-is-cut-give-other-depths = pilot cuts: no chip is cut: give other depths
pilot-cuts-value-gives-force-n-in-place-of-w = pilot cuts: { $value } gives { $force } N in place of { $wanted } N: give another depth
pilot-cuts-at-depth-mm-feeds-low-to-high-are = pilot cuts at { $depth } mm: feeds { $low } to { $high } are no range
pilot-values = pilot values

## crates/study/src/experiment/way/plant.rs

plant-formula-the-papers-k4-does-not-know-th = plant: formula: the papers' K4 does not know the cutter { $tool }: allowed is { $allowed }
the-papers-k4-with-its-intercept-restored-ti = the papers' K4 with its intercept restored, times the factor of material and hardness
tooth-by-tooth-the-mechanistic-model-of-the = tooth by tooth, the mechanistic model of the cutter { $tool } in { $material } (Kienzle's laws; materials but Ck45 and 16MnCrSi5 by the ratio of their forces), its largest value of each control period
force-force-ra-what-that-force-leaves-by-the = force: { $force }; Ra: what that force leaves by the papers' K5, which no measurement confirms for another cutter or material

## crates/study/src/experiment/way/state.rs

version-cannot-be-version-allowed-is-allowed = `version` cannot be { $version }: allowed is { $allowed }
it-was-gone-with-other-settings-and-all-but = it was gone with other settings, and all but the number of batches have to be as they were: with { $found }, not { $own }
searches-cannot-be-count-allowed-is-allowed = `searches` cannot be { $count }: allowed is { $allowed }

## crates/study/src/formula_place.rs

a-run-has-no-use-for-it-because = a run has no use for it: { $because }

## crates/study/src/identify/drive/mod.rs

the-recording-has-count-samples-allowed-are = the recording has { $count } samples: allowed are { $least } to { $most }
the-recording-has-samples-that-are-no-number = the recording has samples that are no numbers
the-command-never-changes-record-a-step = the command never changes: record a step

## crates/study/src/identify/fits/data.rs

one-and-other-have-different-times = `{ $one }` and `{ $other }` have different times
the-samples-of-name-are-not-even-in-time-or = the samples of `{ $name }` are not even in time, or their times are not known: give --layout rate_hz=
missing-samples-of-name-are-missing-or-no-nu = { $missing } samples of `{ $name }` are missing or no numbers; expected are whole records

## crates/study/src/identify/fits/drive.rs

feed-measured = Feed, measured
the-channel-with-the-feed-that-was-measured = The channel with the feed that was measured.
a-feed = a feed
feed-asked-for = Feed, asked for
the-channel-with-the-feed-that-was-asked-for = The channel with the feed that was asked for. What a sample has holds from the sample before on, as in the rows of a run.
a-feed-that-was-asked-for-or-the-step-that-w = a feed that was asked for, or the step that was
step-at = Step at
step-from = Step from
step-to = Step to
the-step-that-was-asked-for-where-it-was-not = The step that was asked for, where it was not recorded: when, from and to which feed.
drive = Drive
dead-time-order-and-lag-of-the-feed-drive-fo = Dead time, order and lag of the feed drive, four structures compared by Schwarz's and Akaike's criteria.
a-recording-of-a-step-of-the-feed-the-feed-t = A recording of a step of the feed: the feed that was measured and the one that was asked for, even in time, from before the step until the feed is steady.
lag = lag
gain = gain
left-rms = left, rms
structures-compared-the-one-of-least-bic-is = Structures compared; the one of least BIC is taken
structure-2 = structure
dead-time-s = dead time [s]
lag-s = lag [s]
this-recording-does-not-tell-one-from-other = this recording does not tell { $one } from { $other }: their BIC differ by { $by }
samples-samples-period-s-apart-structure = { $samples } samples, { $period } s apart; { $structure }

## crates/study/src/identify/fits/force.rs

a-force = a force
force-along-the-feed = Force along the feed
the-channel-with-the-force-on-the-tool-along = The channel with the force on the tool along the feed, in N or kN.
force-across-the-feed = Force across the feed
the-channel-with-the-force-on-the-tool-acros = The channel with the force on the tool across the feed, towards where teeth enter the cut.
force-along-the-axis = Force along the axis
the-channel-with-the-force-on-the-tool-along-2 = The channel with the force on the tool along its axis, away from the tip.
size-across-the-tool = Size across the tool
the-channel-with-the-size-of-the-force-acros = The channel with the size of the force across the tool, sqrt(Fx^2 + Fy^2), where its components were not recorded.
forces-on-the-workpiece = Forces on the workpiece
the-forces-are-those-on-the-workpiece-as-of = The forces are those on the workpiece, as of a dynamometer below it: their signs are turned.
another-cutter-than-the-scenario-s = Another cutter than the scenario's.
the-scenario-s = the scenario's
another-feed-than-the-scenario-s-mm-min = Another feed than the scenario's, mm/min.
another-spindle-speed-than-the-scenario-s-1 = Another spindle speed than the scenario's, 1/min.
another-axial-depth-than-the-scenario-s-mm = Another axial depth than the scenario's, mm.
another-radial-depth-than-the-scenario-s-mm = Another radial depth than the scenario's, mm; a slot has that of the whole cutter.
keep-exponents-of-kienzle-s-laws-as-the-stee = Keep exponents of Kienzle's laws as the steel has them, where the cut does not tell them.
keep-m-c-of-the-steel = Keep m_c of the steel
keep-m-r-of-the-steel = Keep m_r of the steel
keep-m-a-of-the-steel = Keep m_a of the steel
scenario-workpiece-cuts-has-several-sections = { $scenario }: `workpiece.cuts` has several sections: give --axial-depth and --radial-depth of the one that was recorded
forces = Forces
coefficients-of-the-force-model-tooth-by-too = Coefficients of the force model tooth by tooth (Kienzle's laws), the run-out of every tooth and the angle of the spindle.
forces-along-and-across-the-feed-or-along-th = Forces along and across the feed, or along the axis, of a steady cut over one turn of the spindle at least, some 60 samples a turn and more; the scenario is simulated tooth by tooth and has the cutter and the cut.
choose-at-least-one-force = choose at least one force
the-size-across-the-tool-is-for-recordings-w = the size across the tool is for recordings without Fx and Fy
k-letter-at-at-mm = k_{ $letter } at { $at } mm
tooth-number-out-of-the-mean = tooth { $number } out of the mean
shift-of-the-axis = shift of the axis
first-angle = first angle
angle-of-the-spindle = angle of the spindle
condition = condition
samples-samples-turns-turns-at-speed-1-min-l = { $samples } samples, { $turns } turns at { $speed } 1/min, laid over { $places } places of a turn; laws k h^-m of this cut, h in mm

## crates/study/src/identify/fits/material.rs

force-largest-of-a-turn = Force, largest of a turn
the-channel-with-the-largest-force-of-a-revo = The channel with the largest force of a revolution, in N or kN (`steadycut measured --peak` makes it of components).
the-channel-with-the-feed-mm-min-without-it = The channel with the feed, mm/min; without it the scenario's program holds.
the-channel-with-the-spindle-speed-1-min-wit = The channel with the spindle speed, 1/min; without it the scenario's program holds.
a-spindle-speed = a spindle speed
position-along-the-path = Position along the path
the-channel-with-the-position-along-the-path = The channel with the position along the path, mm, where the part has several depths.
a-position = a position
the-factor-of-the-material-s-force-over-that = The factor of the material's force over that of Ck45 at 200 HB, and the hardness that the scenario's material would have it at.
the-largest-force-of-each-revolution-in-a-cu = The largest force of each revolution in a cut, even in time, 40 samples and more; feed, speed and position beside it where they change; the scenario has cutter, part and a force model that is a map, not tooth by tooth (Forces fits that).
plant-force-model-is-id-tooth-by-tooth-expec = `plant.force_model` is { $id }, tooth by tooth: expected is a scenario whose force is a map; `steadycut identify force` fits the teeth
hardness-of-material = hardness of { $material }
force-over-that-of-ck45-at-200-hb = force over that of Ck45 at 200 HB
the-model-was-used-outside-its-range-in-perc = the model was used outside its range in { $percent } % of the samples
one-factor-holds-wear-material-and-hardness = one factor holds wear, material and hardness together: forces alone do not tell them apart
samples-samples-in-the-cut = { $samples } samples in the cut

## crates/study/src/identify/fits/noise.rs

the-channel-with-the-force-in-n-or-kn = The channel with the force, in N or kN.
times-in-s-between-which-the-tool-was-in-the = Times in s between which the tool was in the air: the sensor's noise is told there.
sizes-of-the-sensor-s-noise-of-band-limited = Sizes of the sensor's noise, of band-limited noise, of the material's inhomogeneity and of the ripple at tooth passing.
the-force-of-a-steady-cut-even-in-time-256-s = The force of a steady cut, even in time, 256 samples and more, better some seconds at 1 kHz; the scenario has speed, teeth and feed of the cut.
white-noise = white noise
white-noise-in-the-air = white noise in the air
band-limited-noise-of-the-force = band-limited noise, of the force
inhomogeneity-of-the-force = inhomogeneity, of the force
ripple-at-tooth-passing-of-the-force = ripple at tooth passing, of the force
ripple-at-the-spindle-s-turns-of-the-force = ripple at the spindle's turns, of the force
name-not-seen-the-samples-are-too-far-apart = { $name }: not seen, the samples are too far apart for it
the-shapes-of-the-noise-are-those-of-the-sce = the shapes of the noise are those of the scenario: its band from { $low } to { $high } Hz, its correlation over { $length } mm
noise-in-all-rms = noise in all, rms
r-of-mean-drift-and-ripple = R² of mean, drift and ripple
drift = drift
density-of-the-noise = Density of the noise
frequency = frequency
samples-samples-about-mean-n-period-s-apart = { $samples } samples about { $mean } N, { $period } s apart

## crates/study/src/identify/fits/outcome.rs

value-not-determined = { $value }, not determined
left-over-rms = left over, rms
nothing-is-fitted-yet = nothing is fitted yet

## crates/study/src/identify/fits/request.rs

within-2 = Within
takes-the-samples-between-two-times-in-s-alo = Takes the samples between two times in s alone.
value-unit-cannot-be-allowed-is-a-number-fro = { $value } { $unit } cannot be: allowed is a number from { $low } to { $high }
from-from-s-to-to-s-is-no-span-of-time-the-s = from { $from } s to { $to } s is no span of time: the second is to be behind the first
there-is-no-channel-name-there-are-names = there is no channel `{ $name }`; there are { $names }
name-is-in-unit-expected-is-what-in-units = `{ $name }` is in { $unit }; expected is { $what } in { $units }
first-or-last = { $first } or { $last }
choose-a-channel-expected-is-what = choose a channel: expected is { $what }

## crates/study/src/identify/fits/structure.rs

frequency-2 = Frequency
the-column-with-the-frequencies-hz-ascending = The column with the frequencies, Hz, ascending.
a-frequency = a frequency
displacement-over-force-real-and-imaginary-p = Displacement over force: real and imaginary part, or magnitude and phase.
a-displacement-over-a-force = a displacement over a force
real-part = Real part
imaginary-part = Imaginary part
magnitude = Magnitude
an-angle = an angle
direction = Direction
whether-the-response-is-along-or-across-the = Whether the response is along or across the feed.
number-of-modes = Number of modes
number-of-modes-without-it-as-many-as-there = Number of modes; without it as many as there are peaks, up to 8.
keep-the-other-direction = Keep the other direction
keeps-the-modes-that-the-scenario-has-in-the = Keeps the modes that the scenario has in the other direction: so both come from two recordings, one after the other.
choose-real-and-imaginary-part-or-magnitude = choose real and imaginary part, or magnitude and phase
frequencies-damping-ratios-and-masses-of-the = Frequencies, damping ratios and masses of the modes at the tool's tip, from which stability follows.
a-frequency-response-at-the-tip-as-of-an-imp = A frequency response at the tip, as of an impact test: frequency, and real and imaginary part or magnitude and phase of displacement over force; 20 lines and more.
problem-where-noise-makes-peaks-say-how-many = { $problem }; where noise makes peaks, say how many modes there are
mode-number-frequency = mode { $number }: frequency
mode-number-damping-ratio = mode { $number }: damping ratio
mode-number-modal-mass = mode { $number }: modal mass
kept-from-the-scenario-n-modes-direction = kept from the scenario: { $n } modes { $direction }
the-machine-does-not-stand-in-the-loop-machi = the machine does not stand in the loop (machine.coupled): the modes act in the stability chart until it does
flexibility-of-stiffer-modes-flexibility-um = flexibility of stiffer modes { $flexibility } um/N, which is no mode
share-of-the-response = { $share } % of the response
lines-lines-direction-modes-n = { $lines } lines { $direction }; modes: { $n }

## crates/study/src/identify/fits/wear.rs

the-column-with-the-cutting-speed-m-min = The column with the cutting speed, m/min.
a-cutting-speed = a cutting speed
time-in-the-cut = Time in the cut
the-column-with-the-time-in-the-cut-min = The column with the time in the cut, min.
a-time = a time
the-column-with-the-width-of-the-flank-wear = The column with the width of the flank wear land VB, mm.
a-width = a width
the-column-with-the-feed-per-tooth-mm-where = The column with the feed per tooth, mm, where that was varied.
a-feed-per-tooth = a feed per tooth
the-column-with-the-axial-depth-mm-where-tha = The column with the axial depth, mm, where that was varied.
a-depth = a depth
number-of-the-tool = Number of the tool
the-column-with-the-number-of-the-tool-where = The column with the number of the tool, where several made the same cut.
wear-land-at-the-end = Wear land at the end
the-wear-land-at-which-a-tool-s-life-ends-mm = The wear land at which a tool's life ends, mm.
taylor-s-constants-n-and-c-of-the-tool-s-lif = Taylor's constants n and C of the tool's life, and the exponents of feed and depth where these were varied.
a-table-with-a-reading-of-the-wear-land-in-e = A table with a reading of the wear land in every row, in order of time: cutting speed, time in the cut, width of the wear land; tools at two cutting speeds at least that were worn to the limit.
life-at-speed-m-min = life at { $speed } m/min
c-of-v-t-n-c = C of v T^n = C
exponent-of-the-feed = exponent of the feed
exponent-of-the-depth = exponent of the depth
lives-of-the-tools = Lives of the tools
life-min = life [min]
by-the-fit-min = by the fit [min]
share-of-the-life = { $share } % of the life
deviation-of-the-lives = deviation of the lives
not-told-as-many-constants-as-lives = not told: as many constants as lives
r-of-the-logarithms = R² of the logarithms
life = Life
count-lives-to-a-wear-land-of-land-mm = { $count } lives to a wear land of { $land } mm

## crates/study/src/identify/force/fit.rs

the-run-out = the run-out
the-angle = the angle
no-place-to-begin-the-fit = no place to begin the fit
the-model-gives-no-forces-in-this-cut = the model gives no forces in this cut

## crates/study/src/identify/force/fold.rs

axis-is-value-n-throughout-no-cut-was-record = { $axis } is { $value } N throughout: no cut was recorded; expected is a force that changes as the teeth pass
the-samples-do-not-fill-places-places-of-a-t = the samples do not fill { $places } places of a turn: expected is a longer recording, or more samples a turn than { $count }
the-forces-do-not-repeat-with-the-turns-of-t = the forces do not repeat with the turns of the spindle at { $speed } 1/min: expected is a steady cut at this speed

## crates/study/src/identify/force/mod.rs

these-forces-tell-nothing-of-k-letter-and-m = these forces tell nothing of k_{ $letter } and m_{ $letter }: they are those of the steel that the fit began with
this-cut-cannot-tell-names-apart-condition-c = this cut cannot tell { $names } apart (condition { $condition }): record another component, another feed, or hold an exponent
a-tooth-stands-rest-um-off-what-a-shift-of-t = a tooth stands { $rest } um off what a shift of the axis gives it: the program's own cutter has only that shift
what-is-left-repeats-from-turn-to-turn-place = what is left repeats from turn to turn ({ $place } N): the cut differs from the model, and values may be off by more than their intervals
spindle-speed-2 = spindle speed
axial-depth-2 = axial depth
radial-depth-2 = radial depth
slice-height-2 = slice height
the-name-is-value-unit-nothing-is-cut-expect = the { $name } is { $value } { $unit }: nothing is cut; expected is a number above 0
axis-sample-sample-is-no-number = { $axis }: sample { $sample } is no number
the-recording-has-turns-turns-of-the-spindle = the recording has { $turns } turns of the spindle: expected is at least one
the-model-explains-share-of-the-forces-expec = the model explains { $share } % of the forces: expected are forces on the tool in N, along (Fx) and across (Fy) the feed or along the axis (Fz), of the cut that is given

## crates/study/src/identify/force/settings.rs

plant-force-model-is-id-expected-is-a-scenar = `plant.force_model` is { $id }: expected is a scenario whose force is simulated tooth by tooth, mechanistic

## crates/study/src/identify/genetic.rs

models = models

## crates/study/src/identify/gp/columns.rs

no-rows-below-the-names-of-the-columns = no rows below the names of the columns
there-is-one-column = there is one column
a-target-and-an-input-need-two-columns-of-nu = a target and an input need two columns of numbers: { $which }

## crates/study/src/identify/gp/constants.rs

the-formula-is-too-large = the formula is too large
constants-constants-cannot-be-fitted-to-rows = { $constants } constants cannot be fitted to { $rows } rows
the-formula-has-no-finite-value-on-some-row = the formula has no finite value on some row
a-constant-is-not-finite = a constant is not finite

## crates/study/src/identify/gp/declared.rs

no-start-has-a-value-on-all-rows = no start has a value on all rows

## crates/study/src/identify/gp/folds.rs

the-search-repeated-without-each-row = the search repeated without each row
the-constants-fitted-without-each-row = the constants fitted without each row
the-constants-fitted-without-each-tenth-of-t = the constants fitted without each tenth of the rows

## crates/study/src/identify/gp/paper.rs

generations = generations

## crates/study/src/identify/gp/problem.rs

t-1-row-at-least-fewest-are-needed = 1 row: at least { $fewest } are needed
rows-rows-at-least-fewest-are-needed = { $rows } rows: at least { $fewest } are needed
count-inputs-allowed-are-1-to-most = { $count } inputs: allowed are 1 to { $most }
input-is-the-target-and-an-input = `{ $input }` is the target and an input
the-input-input-is-named-twice = the input `{ $input }` is named twice
the-unit-of-column-is-not-known-give-it-with = the unit of `{ $column }` is not known: give it with `--unit { $column }=UNIT`, `1` for none
name-is-value-in-every-row-nothing-can-be-to = `{ $name }` is { $value } in every row: nothing can be told by it
name-has-values-above-1e100-choose-another-u = `{ $name }` has values above 1e100: choose another unit
a-and-b-lie-on-one-line-correlation-correlat = `{ $a }` and `{ $b }` lie on one line (correlation { $correlation }, variance inflation { $inflation }): these rows do not tell their effects apart, and a free formula of both would be an accident

## crates/study/src/identify/gp/range.rs

constant = constant
rising = rising
falling = falling
turning = turning
uncertain = uncertain

## crates/study/src/identify/gp/report.rs

the-constants-fitted-without-some-of-the-row = the constants fitted without some of the rows

## crates/study/src/identify/gp/search.rs

the-saved-search-has-formulas-that-cannot-be = the saved search has formulas that cannot be

## crates/study/src/identify/gp/state.rs

the-search-was-of-another-table-of-other-col = the search was of another table, of other columns, units or another seed: all of these have to be as they were

## crates/study/src/identify/gp/template.rs

t-stands-there-twice-allowed-is-once = T stands there twice: allowed is once
the-bracket-of-t-is-not-closed = the bracket of T is not closed
count-constants-allowed-are-most = { $count } constants: allowed are { $most }
there-is-neither-a-constant-to-fit-nor-t-to = there is neither a constant to fit nor T to search for
t-name-name-is-no-input-inputs-are-list = T({ $name }): `{ $name }` is no input; inputs are { $list }
part-beside-t-every-part-needs-one-constant = `{ $part }`: beside T, every part needs one constant that multiplies it, and no other
t-has-to-stand-in-the-sum-by-itself-as-in-a = T has to stand in the sum by itself, as in `a + b*n^3 + T(f)`
a-part-of-the-template-has-no-finite-value-o = a part of the template has no finite value on some row

## crates/study/src/identify/material.rs

the-recording-has-count-samples-of-the-force = the recording has { $count } samples of the force: expected are at least { $least }, and as many of feed, speed and position
force = force
position-2 = position
name-sample-sample-is-no-number = { $name }: sample { $sample } is no number
the-position-falls-expected-is-that-along-th = the position falls: expected is that along the path
the-model-has-a-force-in-count-samples-expec = the model has a force in { $count } samples: expected are at least { $least } in the cut, with feed in mm/min and speed in 1/min
the-forces-are-not-above-0-expected-is-the-s = the forces are not above 0: expected is the size of the force

## crates/study/src/identify/noise.rs

what-count-samples-allowed-are-least-to-most = { $what }: { $count } samples: allowed are { $least } to { $most }
what-sample-sample-is-no-number = { $what }: sample { $sample } is no number
the-cut-2 = the cut
expected-are-a-period-speed-feed-corners-of = expected are a period, speed, feed, corners of the band and a correlation length above 0, and a tooth
the-force-does-not-vary-nothing-is-told-of-i = the force does not vary: nothing is told of its noise
the-mean-force-is-mean-n-expected-is-a-cut-w = the mean force is { $mean } N: expected is a cut, with a force above 0
at-rest = at rest

## crates/study/src/identify/response/fit.rs

the-response-has-no-resonance-im-has-no-peak = the response has no resonance: -Im has no peak above 0; is it displacement over force?

## crates/study/src/identify/response/table.rs

its-columns-are-names-wanted-are-frequency-h = its columns are { $names }: wanted are frequency_hz with real_m_n and imaginary_m_n, or with magnitude_m_n and phase_deg; _um_n for um/N
the-response-has-count-points-allowed-are-le = the response has { $count } points: allowed are { $least } to { $most }
the-frequencies-do-not-ascend-from-above-0-h = the frequencies do not ascend from above 0 Hz

## crates/study/src/identify/wear.rs

there-is-no-column-name-there-are-names = there is no column `{ $name }`; there are { $names }
reading-number-expected-are-a-speed-feed-and = reading { $number }: expected are a speed, feed and depth above 0, a time and a wear land of at least 0
reading-number-its-time-time-min-is-not-behi = reading { $number }: its time, { $time } min, is not behind that of the reading before it at { $speed } m/min: give a column with the tool's number
speed-m-min = { $speed } m/min
a-limit-of-land-mm-expected-is-a-number-abov = a limit of { $land } mm: expected is a number above 0
at-cut-the-first-reading-is-already-above-th = at { $cut } the first reading is already above the limit: its life is on the line from a new tool
at-cut-the-wear-land-does-not-come-to-land-m = at { $cut } the wear land does not come to { $land } mm: left out
count-tools-came-to-land-mm-all-at-one-cutti = { $count } tools came to { $land } mm, all at one cutting speed: expected are at least two speeds
count-tools-came-to-land-mm-expected-are-at = { $count } tools came to { $land } mm: expected are at least { $least }, one for each constant
speed-feed-and-depth-were-varied-only-togeth = speed, feed and depth were varied only together: expected are cuts in which one of them changes alone
the-life-does-not-fall-with-the-cutting-spee = the life does not fall with the cutting speed: expected are the columns of speed, time and wear land
depth-2 = depth
the-name-was-not-varied-its-exponent-stays-a = the { $name } was not varied: its exponent stays as it is in the scenario

## crates/study/src/library/facts.rs

names-and-more-more = { $names } and { $more } more
length-mm-long-at-most-depth-mm-deep = { $length } mm long, at most { $depth } mm deep
n-moves = { $n } moves
n-lines = { $n } lines
controller-length-mm = { $controller }, { $length } mm
it-is-none-of-the-files-that-this-program-re = it is none of the files that this program reads
shape-1-tooth-d-mm = { $shape }, 1 tooth, { $d } mm
shape-n-teeth-d-mm = { $shape }, { $n } teeth, { $d } mm
t-1-mode-hz-hz = 1 mode, { $hz } Hz
n-modes-low-to-high-hz = { $n } modes, { $low } to { $high } Hz
k-c1-1-kc11-n-mm-m-c-mc-hb-hb = k_c1.1 { $kc11 } N/mm², m_c { $mc }, { $hb } HB
feed-drive-of-order-n = feed drive of order { $n }
spindle-drive-of-order-n = spindle drive of order { $n }
dead-time-s-s = dead time { $s } s
limits-at-most-feed-mm-min = limits, at most { $feed } mm/min
limits = limits

## crates/study/src/library/kind.rs

cutters = Cutters
materials = Materials
machines = Machines
structures-at-the-tool-s-tip = Structures at the tool's tip
parts = Parts
programs-g-code = Programs (G-code)
scripts = Scripts
scenarios = Scenarios
formulas = Formulas
tables = Tables
networks-of-unks = Networks of UNKS
saved-searches = Saved searches
results-of-missions = Results of missions
not-readable = Not readable

## crates/study/src/library/mod.rs

size-mb-not-looked-into = { $size } MB, not looked into
size-mb-files-of-its-kind-have-at-most-most = { $size } MB: files of its kind have at most { $most } MB

## crates/study/src/machine_life/adaptive.rs

percent-of-the-life = percent of the life

## crates/study/src/machine_life/mod.rs

sound-trend-and-roughness-trend-are-identica = sound trend and roughness trend are identical (no figure is printed)
calculated-and-measured-sound-trend-r-0-993 = calculated and measured sound trend: R = 0.993; no measurement is published
calculated-and-measured-sound-spectrum-r-0-6 = calculated and measured sound spectrum: R = 0.684; no measurement is published
points-of-time = points of time

## crates/study/src/machine_life/monte_carlo.rs

tools = tools

## crates/study/src/mission/answer.rs

predictions-step-step-allowed-is-one-of-choi = `predictions`, step { $step }: allowed is one of choice, number and curve
predictions-step-step-is-answered-twice = `predictions`: step { $step } is answered twice
path-is-set-to-value-the-mission-opens-open = `{ $path }` is set to { $value }: the mission opens { $open }
path-is-changed-at-time-s-the-mission-opens = `{ $path }` is changed at { $time } s: the mission opens { $open }
the-change-of-path-at-time-s-is-part-of-the = the change of `{ $path }` at { $time } s is part of the mission and is missing
predictions-step-step-asks-nothing-steps-tha = `predictions`: step { $step } asks nothing; steps that ask: { $all }
predictions-step-step = `predictions`, step { $step }
entry-choice-is-number-allowed-is-1-to-most = { $entry }: choice is { $number }: allowed is 1 to { $most }
entry-number-is-number-allowed-are-finite-on = { $entry }: number is { $number }: allowed are finite ones
entry-allowed-is-a-choice = { $entry }: allowed is a choice
entry-allowed-is-a-number = { $entry }: allowed is a number
entry-allowed-is-a-curve = { $entry }: allowed is a curve
entry-curve-has-count-points-allowed-are-2-t = { $entry }: curve has { $count } points: allowed are 2 to { $most }
entry-curve-has-a-number-that-is-not-finite = { $entry }: curve has a number that is not finite
entry-the-times-of-the-curve-do-not-ascend = { $entry }: the times of the curve do not ascend
bytes-bytes-at-most-most-are-read = { $bytes } bytes; at most { $most } are read
version-is-version-allowed-is-allowed = `version` is { $version }: allowed is { $allowed }
mission-is-found-this-mission-is-own = `mission` is `{ $found }`: this mission is `{ $own }`
link-holds-settings-and-changes-allowed-is-a = `link` holds settings and changes: allowed is a link, or set and edits

## crates/study/src/mission/condition.rs

allowed-is-one-of-list-between-two-formulas = allowed is one of { $list } between two formulas
text-compares-twice-allowed-write-two-condit = `{ $text }` compares twice: { $allowed }; write two conditions
text-compares-nothing-allowed = `{ $text }` compares nothing: { $allowed }

## crates/study/src/mission/cut.rs

set-or-edits-error = `set` or `edits`: { $error }
allowed-are-tables-of-settings-as-in-a-scena = allowed are tables of settings, as in a scenario file

## crates/study/src/mission/file/controls.rs

is-not-open-allowed-are-settings-of-controls = is not open: allowed are settings of `controls.open`: { $open }
is-no-choice-allowed-are-settings-with-optio = is no choice: allowed are settings with options
offers-count-options-allowed-are-2-at-least = offers { $count } options: allowed are 2 at least, of { $list }
lacks-own-that-of-the-mission-s-own-cut-is-a = lacks `{ $own }`: that of the mission's own cut is among those that are offered

## crates/study/src/mission/file.rs

entry-at-line-line-problem = `{ $entry }` at line { $line }: { $problem }
entry-has-count-entries-allowed-are-most = `{ $entry }` has { $count } entries: allowed are { $most }
checks-is-empty-a-mission-checks-at-least-on = `checks` is empty: a mission checks at least one condition
is-id-allowed-are-1-to-60-of-a-to-z-0-to-9-a = is `{ $id }`: allowed are 1 to 60 of a to z, 0 to 9 and -
is-empty-a-mission-has-a-title = is empty: a mission has a title
is-the-name-of-a-metric-allowed-is-another-n = is the name of a metric: allowed is another name
allowed-is-one-of-options-number-and-curve = allowed is one of options, number and curve
is-value-allowed-is-above-0-to-100 = is { $value }: allowed is above 0 to 100 %
has-count-options-allowed-are-2-to-most = has { $count } options: allowed are 2 to { $most }
has-right-and-right-if-allowed-is-one-of-the = has `right` and `right_if`: allowed is one of them
no-option-is-right-at-least-one-has-right-tr = no option is right: at least one has right = true or right_if
allowed-is-one-of-metric-signal-setting-chan = allowed is one of metric, signal, setting, changes, prediction and ended
has-take-from-or-to-allowed-with-a-signal-on = has take, from or to: allowed with a signal only
has-a-run-allowed-with-a-metric-a-signal-or = has a run: allowed with a metric, a signal or an end only
is-step-allowed-is-the-number-of-a-step-1-to = is { $step }: allowed is the number of a step, 1 to { $most }
is-empty = is empty
entry-ended-no-end-id = `{ $entry }.ended`: no end `{ $id }`
goes-from-from-to-to-allowed-is-from-0-on-an = goes from { $from } to { $to }: allowed is from 0 on, and from below to
entry-signal-no-signal-id = `{ $entry }.signal`: no signal `{ $id }`
there-is-no-id-did-you-mean-near-allowed-is = there is no `{ $id }` (did you mean `{ $near }`?): allowed is one of { $list }
there-is-no-id-allowed-is-one-of-list = there is no `{ $id }`: allowed is one of { $list }
there-is-no-value-or-metric-name-did-you-mea = there is no value or metric `{ $name }` (did you mean `{ $near }`?): allowed are those of [values] and { $list }
there-is-no-value-or-metric-name-allowed-are = there is no value or metric `{ $name }`: allowed are those of [values] and { $list }

## crates/study/src/mission/link.rs

its-link-problem = its link: { $problem }

## crates/study/src/mission/mod.rs

mission = mission
answer = answer
path-is-set-to-value-the-mission-offers-list = `{ $path }` is set to { $value }: the mission offers { $list }

## crates/study/src/mission/result.rs

format-is-format-allowed-is-allowed = `format` is `{ $format }`: allowed is `{ $allowed }`
mission-digest-is-found-this-mission-s-is-ow = `mission.digest` is { $found }: this mission's is { $own }; they differ in more than comments
entry-says-said-the-answer-gives-found = `{ $entry }` says { $said }: the answer gives { $found }

## crates/study/src/mission/shipped.rs

there-is-none-with-the-id-id-there-are-list = there is none with the id `{ $id }`; there are { $list }

## crates/study/src/mission/words.rs

left-at-most-right = { $left }: at most { $right }
left-at-least-right = { $left }: at least { $right }
left-the-same-as-right = { $left }: the same as { $right }
left-other-than-right = { $left }: other than { $right }
left-less-than-right = { $left }: less than { $right }
left-more-than-right = { $left }: more than { $right }
there-is-no-such-value = there is no such value
yours-is-off-by-percent = yours is off by { $percent }
yours-value = yours: { $value }
yours-value-the-limit-limit = yours: { $value }, the limit: { $limit }
value-within-percent-of-wanted = { $value }: within { $percent } of { $wanted }
the-value-of-the-cut-as-given = the value of the cut as given
the-value-at-constant-feed-as-programmed = the value at constant feed as programmed
the-value-with-controller = the value with { $controller }
changes-during-the-cut = changes during the cut
changes-during-the-cut-2 = Changes during the cut
prediction-in-step-step = Prediction in step { $step }
of-the-cut-as-given = of the cut as given
at-constant-feed-as-programmed = at constant feed as programmed
from-from-unit-on = from { $from } { $unit } on
from-to-to-unit = { $from } to { $to } { $unit }
largest-value = largest value
least-value = least value
largest-less-least-value = largest less least value
first-value = first value
last-value = last value
ra-at-the-end = Ra at the end
ra-at-the-end-off-its-target = Ra at the end, off its target
share-of-the-length-in-tolerance = Share of the length in tolerance
share-of-the-length-above-the-tolerance = Share of the length above the tolerance
share-of-the-length-in-tolerance-with-dynami = Share of the length in tolerance with dynamics
share-of-the-length-above-the-tolerance-with = Share of the length above the tolerance with dynamics
share-of-the-length-that-is-not-judged = Share of the length that is not judged
force-at-the-end = Force at the end
force-at-the-end-off-its-reference = Force at the end, off its reference
largest-deviation-of-the-force-from-its-refe = Largest deviation of the force from its reference
feed-at-the-end = Feed at the end
spindle-speed-at-the-end = Spindle speed at the end
normalised-standard-error = Normalised standard error
normalised-standard-error-over-20-samples = Normalised standard error over 20 samples
settling-time-of-the-force = Settling time of the force
overshoot-of-the-force = Overshoot of the force
length-of-path-done = Length of path done
length-of-scrap = Length of scrap
cost-of-the-scrap = Cost of the scrap
cost-of-the-cut = Cost of the cut
share-of-the-time-at-a-limit = Share of the time at a limit
share-of-the-time-with-a-model-outside-its-r = Share of the time with a model outside its range

## crates/study/src/opening/frame.rs

embed-flag-allowed-behind-hide-are-list = embed: `{ $flag }`: allowed behind hide: are { $list }
embed-flag-allowed-behind-lock-are-all-a-set = embed: `{ $flag }`: allowed behind lock: are all, a setting, or a group of settings: { $list }
embed-flag-allowed-behind-screen-is-the-name = embed: `{ $flag }`: allowed behind screen: is the name of one
embed-flag-allowed-behind-lang-are-list = embed: `{ $flag }`: allowed behind lang: are { $list }
embed-flag-allowed-are-hide-lock-screen-and = embed: `{ $flag }`: allowed are hide, lock, screen and lang, each with a colon and its value

## crates/study/src/opening/mod.rs

the-link-was-not-used-title-is-open-instead = The link was not used, “{ $title }” is open instead. { $error }
embed-error = embed: { $error }
the-mission-title-begins-anew-the-cut-of-the = The mission “{ $title }” begins anew: the cut of the link was not used. { $problem }

## crates/study/src/own_file/entry.rs

line-line-problem = line { $line }: { $problem }

## crates/study/src/own_file/limits.rs

at-most-speed-max-rpm-most-1-min = at most `speed_max_rpm`, { $most } 1/min
spindle-drive-stands-in-the-place-of-lag-and = { "[" }spindle_drive] stands in the place of lag and rate limit
there-is-nothing-in-limits = there is nothing in [limits]

## crates/study/src/own_file/machine.rs

machine-file = machine file
the-pole-re-and-im-rad-s-lacks-its-conjugate = the pole { $re } and { $im } rad/s lacks its conjugate, { $re } and { $other }
t-2-to-n-coefficients-above-0-a0-first-with-an = 2 to { $n } coefficients above 0, a0 first: with another sign no drive is stable
one-of-poles-and-denominator-is-wanted-besid = one of `poles` and `denominator` is wanted beside it, not both and not neither
a-drive-has-at-least-one-pole = a drive has at least one pole
it-stands-without-poles = it stands without `poles`
the-feed-drive-stands-in-feed-drive-already = the feed drive stands in [feed_drive] already
there-is-nothing-in-it-dead-time-s-feed-driv-2 = there is nothing in it: dead_time_s, [feed_drive], [spindle_drive] or [limits]

## crates/study/src/own_file/material.rs

material-file = material file

## crates/study/src/own_file/mod.rs

file-of-your-own = file of your own
it-is-none-of-a-cutter-diameter-mm-teeth-a-s-2 = it is none of a cutter (diameter_mm, teeth), a structure ([[mode]]), a material (kc11_n_mm2), a machine ([feed_drive], poles or [limits])

## crates/study/src/papers/calibrations.rs

calibrations = calibrations

## crates/study/src/papers/table_job.rs

simulations = simulations

## crates/study/src/papers.rs

the-paper-prints-a-final-force-of-195-2-n-mo = the paper prints a final force of 195.2 N, most likely a misprint of 190.2 N: the run is compared with 190.2 N. Model K4 (restored) gives 190.2 N for the feed and speed of this row, and with that force its Ra fits those of all other rows

## crates/study/src/papers_2019.rs

natural-frequencies-without-damping-list-hz = natural frequencies without damping: { $list } Hz
one-resonance-between-tooth-and-work-from-0 = one resonance between tooth and work from 0 to 3000 Hz: { $peak } m/N at { $frequency } Hz
eq-1-as-printed-is-unstable-real-poles-at-co = eq. 1 as printed is unstable: real poles at +{ $corrected } 1/s with corrected numbers, at +{ $printed } 1/s with the printed ones
eq-2-as-printed-tool-point-printed-m-n-at-re = eq. 2 as printed: tool point { $printed } m/N at rest and { $moving } at 110 Hz; corrected { $corrected } at rest, { $times } times as soft
table-1-s-springs-and-dampers-from-its-rules = Table 1's springs and dampers from its rules, but for the entries of the errata
the-solution-of-eq-2-by-gauss-from-0-to-3000 = the solution of eq. 2 by Gauss from 0 to 3000 Hz in steps of 10 Hz (`steadycut machine frf`)
no-published-curve-the-figures-are-not-avail = no published curve: the figures are not available as data, so spectra, sound trend, roughness profile and roughness trend stand beside no measurement
the-correlations-0-684-and-0-993-compare-wit = the correlations 0.684 and 0.993 compare with measurements that were not published; noise can be chosen that gives them, which validates nothing
how-wear-changes-springs-and-dampers-is-not = how wear changes springs and dampers is not stated; every law of wear here is an assumption
absolute-amplitudes-a-force-of-107-n-at-ever = absolute amplitudes: a force of 107 N at every line of the spectrum is the formal reading of eq. 2
parameters-of-the-tool-life-prediction-its-e = parameters of the tool-life prediction: its equations are not in the paper

## crates/study/src/part/blank.rs

the-blank-s-size-along-axis-is-size-mm-allow = the blank's size along { $axis } is { $size } mm: allowed is { $least } to { $most } mm
the-blank-s-corner-has-to-be-three-numbers-i = the blank's corner has to be three numbers in mm
a-grid-of-cell-mm-over-the-blank-has-n-cells = a grid of { $cell } mm over the blank has { $n } cells: allowed are { $most }; a larger step has fewer

## crates/study/src/part/carved.rs

the-program-has-no-feed-move-nothing-is-cut = the program has no feed move: nothing is cut
the-way-has-n-pieces-at-most-most-are-drawn = the way has { $n } pieces: at most { $most } are drawn

## crates/study/src/part/columns.rs

column-name-the-unit-is-unit-allowed-is-all = column `{ $name }`: the unit is `{ $unit }`: allowed is { $all }
the-columns-name-and-other-mean-the-same = the columns `{ $name }` and `{ $other }` mean the same
s-or-x-and-y = s (or x and y)
the-columns-are-found-missing-are-missing = the columns are { $found }; missing are { $missing }
line-line-column-name-cell-allowed-is-a-numb = line { $line }, column `{ $name }`: `{ $cell }`: allowed is a number from { $least } to { $most } { $unit }
line-line-the-path-begins-at-s-mm-allowed-is = line { $line }: the path begins at { $s } mm: allowed is 0
line-line-the-path-is-at-s-mm-allowed-is-mor = line { $line }: the path is at { $s } mm: allowed is more than the { $before } mm of the row before
the-table-has-n-rows-allowed-is-2-or-more-fr = the table has { $n } rows: allowed is 2 or more, from the start of the path to its end
the-path-is-length-mm-long-allowed-is-at-mos = the path is { $length } mm long: allowed is at most { $most } mm
columns-that-are-not-used-names = Columns that are not used: { $names }.

## crates/study/src/part/gcode/arc.rs

the-arc-s-radius-is-first-mm-at-its-start-an = the arc's radius is { $first } mm at its start and { $last } mm at its end: allowed is the same, above 0
an-arc-of-radius-radius-mm-does-not-join-poi = an arc of radius { $radius } mm does not join points { $way } mm apart: allowed is a radius of half of that or more, and two different points

## crates/study/src/part/gcode/reader.rs

at-most-n-lines-are-read = at most { $n } lines are read
letter-stands-there-twice = `{ $letter }` stands there twice
two-kinds-of-motion-in-one-line = two kinds of motion in one line
word-changes-where-the-tool-goes-in-a-way-th = { $word } changes where the tool goes in a way that is not followed
word-allowed-is-0-or-more = { $word }: allowed is 0 or more
word-subprograms-are-not-followed = { $word }: subprograms are not followed
word-only-x-y-z-i-j-and-r-say-where-the-tool = { $word }: only X, Y, Z, I, J and R say where the tool goes
axis-is-relative-and-where-the-tool-is-along = `{ $axis }` is relative, and where the tool is along it is not known
a-place-without-a-motion-g0-g1-g2-or-g3-come = a place without a motion: G0, G1, G2 or G3 comes first
a-feed-move-from-a-place-that-is-not-known-r = a feed move from a place that is not known: rapid moves to X, Y and Z come first
i-j-and-r-belong-to-arcs-g2-and-g3 = I, J and R belong to arcs, G2 and G3
an-arc-has-i-and-j-or-r-not-both = an arc has I and J, or R, not both
an-arc-without-i-j-or-r = an arc without I, J or R

## crates/study/src/part/gcode/words.rs

a-comment-has-no-end = a comment has no end
code-sign-is-no-letter-of-a-word-variables-e = `{ $code }`: `{ $sign }` is no letter of a word; variables, expressions, block skips and O-words are not followed
letter-is-followed-by-number-allowed-is-a-nu = `{ $letter }` is followed by `{ $number }`: allowed is a number

## crates/study/src/part/milling.rs

the-step-is-step-mm-allowed-is-least-to-most = the step is { $step } mm: allowed is { $least } to { $most } mm
a-way-of-length-mm-in-steps-of-step-mm-allow = a way of { $length } mm in steps of { $step } mm: allowed are { $most } steps; a larger step has fewer
mm-of-the-way = mm of the way
rapid-moves-through-material-lines-lines = Rapid moves through material: lines { $lines }.
straight-down-into-material-lines-lines = Straight down into material: lines { $lines }.
not-acted-on-word-lines-lines = Not acted on: { $word }, lines { $lines }.
behind-the-end-of-the-program-n-lines-not-re = Behind the end of the program: { $n } lines, not read.
there-are-feed-moves-before-the-first-f-thei = There are feed moves before the first F: their feed is not known.

## crates/study/src/part/path.rs

the-part-has-n-cuts-with-air-between-them-on = the part has { $n } cuts with air between them: only one path is a table of depths

## crates/study/src/part/taken.rs

the-depths-change-at-n-places-allowed-are-mo = the depths change at { $n } places: allowed are { $most }, with differences up to { $same } mm taken for none; a larger step or a part of the path has fewer
differences-of-depth-up-to-same-mm-are-taken = Differences of depth up to { $same } mm are taken for none, so that the part fits into a scenario.
the-time-limit-is-time-s-now-run-duration-s = The time limit is { $time } s now (`run.duration_s`), twice what the path takes at the programmed feed.
it-would-take-wanted-s-a-run-has-most-s-at-m = It would take { $wanted } s; a run has { $most } s at most, and may end before the path does.
one-row-is-recorded-per-control-period-run-r = One row is recorded per control period (`run.record_every`): the run is long.
the-file-programs-feeds-from-low-to-high-mm = The file programs feeds from { $low } to { $high } mm/min; the run programs { $feed } mm/min (`program.feed_mm_min`).
the-file-programs-speeds-from-low-to-high-1 = The file programs speeds from { $low } to { $high } 1/min; the run programs { $speed } 1/min (`program.spindle_rpm`).

## crates/study/src/plan/constraints.rs

chosen-the-papers-cite-their-list-of-seven-w = chosen: the papers cite their list of seven without giving it
the-spindle-turns-neither-slower-nor-faster = The spindle turns neither slower nor faster.
the-feed-drives-move-neither-slower-nor-fast = The feed drives move neither slower nor faster.
f-sqrt-f-x-2-f-y-2-from-the-network = F = sqrt(F_x^2 + F_y^2), from the network
roughness-follows-the-force-above-the-refere = Roughness follows the force: above the reference force of the target Ra (or a limit of one's own) the surface gets rougher than it should.
the-spindle-motor-must-turn-the-cutter-again = The spindle motor must turn the cutter against the force.
roughness-of-the-feed-marks = Roughness of the feed marks
feed-marks-grow-with-the-square-of-the-feed = Feed marks grow with the square of the feed. 318 f^2 / (4 D) is the form of Tolouei-Rad and Bidhendi; the factor 5 and z f_z (run-out: one tooth cuts it all) are chosen.
cutter-deflection = Cutter deflection
a-bent-cutter-leaves-the-contour = A bent cutter leaves the contour.
the-edges-must-last-taylor-s-law-with-the-co = The edges must last. Taylor's law with the constants of the preset table_2005.

## crates/study/src/plan/machine.rs

placeholder = placeholder

## crates/study/src/plan/mod.rs

iterations-2 = iterations

## crates/study/src/plan/optimum.rs

feasible-at-depth-mm-depth-by-the-plan-s-net = feasible at { $depth } mm depth by the plan's network; no constraint binds
feasible-at-depth-mm-depth-by-the-plan-s-net-2 = feasible at { $depth } mm depth by the plan's network; binding: { $names }
nothing-is-feasible-in-the-range-searched-at = nothing is feasible in the range searched at { $depth } mm depth; least violation shown, violated: { $names }

## crates/study/src/plan/over_depths.rs

in-tolerance-2 = in tolerance
above-its-tolerance = above its tolerance
below-its-tolerance = below its tolerance
not-judged-outside-the-model = not judged, outside the model
verdict-not-places = { $verdict }; not { $places }
verdict-at-the-part-s-other-depths-too = { $verdict }; at the part's other depths too
verdict-the-part-has-no-such-depth = { $verdict }; the part has no such depth
at-depth-broken = at { $depth }: { $broken }
depth-plan-n-by-the-network-no-force-in-the = { $depth }: { $plan } N by the network, no force in the run
depth-plan-n-by-the-network-run-n-in-the-run = { $depth }: { $plan } N by the network, { $run } N in the run ({ $more } %), { $held }
violated-names = ; violated: { $names }
outside-the-network-s-training-data = ; outside the network's training data
at-this-feed-kept-constant-without-noise-and = At this feed, kept constant, without noise and vibration
at-this-feed-kept-constant-without-noise-and-2 = At this feed, kept constant, without noise and vibration; { $n } depths between are not judged

## crates/study/src/plan/problem.rs

at-least-least-mm-for-a-plan = at least { $least } mm for a plan
above-0-for-at-least-one-of-weight-force-wei = above 0 for at least one of weight_force, weight_removal_rate, weight_time and weight_cost
above-0-or-plan-tool-cost-above-0-where-cost = above 0, or `plan.tool_cost` above 0, where cost is sought

## crates/study/src/plan/remarks.rs

times-removal-rate-and-cost-are-those-of-thi = Times, removal rate and cost are those of this feed, kept through the whole cut: { $controller } changes the feed in the cut, and with it all of them
the-plan-s-force-is-that-of-the-network-plan = The plan's force is that of the network ({ $plan }), the run's comes from: { $run }; they differ, so the run does not begin at the planned force
chatter-is-none-of-the-constraints-and-this = Chatter is none of the constraints, and this machine vibrates in the cut: whether the planned speed and depth are quiet, its stability chart says
the-constraints-are-judged-at-the-programmed = The constraints are judged at the programmed values: an adaptive controller then holds the force and moves feed and speed along its models, whatever that does to tool life and power

## crates/study/src/profilometer.rs

the-line-s-ends-must-be-numbers-in-mm = the line's ends must be numbers in mm
no-tooth-has-cut-anything-yet = no tooth has cut anything yet
the-line-is-length-mm-long-with-these-cut-of = the line is { $length } mm long: with these cut-offs it takes at least { $least } mm (a run-up on each side and one sampling length), and at most { $most } mm
the-line-leaves-the-machined-surface-at-x-x = the line leaves the machined surface at x = { $x } mm, y = { $y } mm: { $beside }
there-y-reaches-from-low-to-high-mm = there y reaches from { $low } to { $high } mm
x-reaches-from-first-to-last-mm-so-far = x reaches from { $first } to { $last } mm so far

## crates/study/src/published.rs

initial-force = Initial force

## crates/study/src/recommend/learned.rs

input-first-engagement-second = { $input } { $first }, engagement { $second }
low = low
middle = middle
high = high

## crates/study/src/recommend/mod.rs

a-recommendation-interpolates-a-table-it-is = A recommendation interpolates a table; it is not knowledge of the cut.
hardness-2 = hardness
diameter-2 = diameter

## crates/study/src/recommend/table.rs

synthetic-formulas-that-imitate-a-maker-s-ta = synthetic: formulas that imitate a maker's table, with 3 % noise; no maker's data

## crates/study/src/safe_feed/mod.rs

no-constant-feed-is-safe-even-at-feed-mm-min = no constant feed is safe: even at { $feed } mm/min and { $speed } 1/min { $broken }
speeds = speeds

## crates/study/src/safe_feed/trial.rs

ra-is-value-um-at-place-mm-rougher-than-allo = Ra is { $value } um at { $place } mm, rougher than allowed
the-force-is-value-n-at-place-mm-above-its-t = the force is { $value } N at { $place } mm, above its tolerance
ra-is-value-um-with-vibration-at-place-mm-ro = Ra is { $value } um with vibration at { $place } mm, rougher than allowed
the-part-is-not-cut-to-its-end-end = the part is not cut to its end ({ $end })
the-part-is-not-cut-to-its-end-the-machine-d = the part is not cut to its end: the machine does not reach the feed
ra-lies-outside-its-model-on-the-whole-part = Ra lies outside its model on the whole part, so nothing can be judged

## crates/study/src/stability/chart.rs

curves = curves

## crates/study/src/stability/mod.rs

r-d-radial-mm-of-a-cutter-of-diameter-mm-wit = R_D { $radial } mm of a cutter of { $diameter } mm with { $teeth } teeth: each cuts over { $angle } degrees
above-0-mm-for-a-stability-chart = above 0 mm for a stability chart

## crates/study/src/stability/tip/mod.rs

r-d-radial-mm-of-a-cutter-of-diameter-mm-wit-2 = R_D { $radial } mm of a cutter of { $diameter } mm with { $teeth } teeth: each cuts from { $from } to { $to } degrees, { $way }
down-milling = down-milling
up-milling = up-milling

## crates/study/src/train/claim.rs

neural-network-predictions-were-by-4-closer-2 = "neural network predictions were by 4 % closer to the measurements, compared to 6 %" of the best formula, read as mean errors
literal-network = literal network
inputs-activation-and-learning-as-the-paper = inputs, activation and learning as the paper has them
improved-network = improved network
logarithms-of-the-inputs-other-learning = logarithms of the inputs, other learning
genetic-programming = genetic programming
a-formula-of-the-same-inputs-found-here = a formula of the same inputs, found here
the-network-is-closer-than-the-formula-own-a = the { $network } is closer than the formula: { $own } % against { $formula } %
name-own-where-the-paper-has-paper-within-ne = { $name }: { $own } % where the paper has { $paper } %, within { $near } percentage point

## crates/study/src/train/comparison.rs

networks = networks

## crates/study/src/train/data.rs

the-papers-3500-measurements-were-never-publ = The papers' 3500 measurements were never published: the training data come from the mechanistic ball-end model (Latin hypercube, run-out 3 um, slices of 0.25 mm) with noise of 3 % and 3 N.
rows = rows

## crates/study/src/train/mod.rs

epochs = epochs

## crates/study/src/uses/mod.rs

it-reads-list = it reads { $list }

## crates/study/src/uses/reads.rs

only-run-prints-it = only `run` prints it
only-metrics-judge-by-it-and-this-prints-non = only metrics judge by it, and this prints none of those
it-prints-no-cost = it prints no cost
a-row-is-recorded-for-every-control-period = a row is recorded for every control period
the-controller-is-always-unks = the controller is always UNKS
ra-is-not-among-what-this-prints = Ra is not among what this prints
plant-force-model-is-no-formula-and-ra-is-no = `plant.force_model` is no formula, and Ra is not among what this prints
twin-kind-is-programmed = `twin.kind` is programmed
plan-force-limit-is-not-fixed = `plan.force_limit` is not fixed
plan-force-limit-is-fixed = `plan.force_limit` is fixed
plan-free-speed-is-true-the-speed-is-searche = `plan.free_speed` is true: the speed is searched
machine-tip-modes-gives-the-machine-and-the = `machine.tip_modes` gives the machine, and the teeth's angles the direction
machine-tip-modes-is-empty-the-five-masses-h = `machine.tip_modes` is empty: the five masses have one direction
workpiece-cuts-gives-the-radial-depths = `workpiece.cuts` gives the radial depths
workpiece-radial-depth-mm-is-the-width-of-th = `workpiece.radial_depth_mm` is the width of the cut whatever the end's shape is
plant-calibration-is-not-formula = `plant.calibration` is not formula
it-tells-how-a-run-goes-and-this-is-no-run = it tells how a run goes, and this is no run

## choices of the studies

met = met
missed = MISSED
first-order = first order
second-order-critically-damped = second order, critically damped
second-order = second order
third-order = third order
slot = slot
heavy-side-cut = heavy side cut
light-side-cut = light side cut
finishing = finishing
as-the-rules-say = as the rules say
q-wrong-the-damper-shows-5-not-17 = Q wrong: the damper shows 5, not 17
m3-rounded-to-one-digit-damper-wrong = m3 rounded to one digit; damper wrong
exponent-of-the-spring-wrong-8-not-12 = exponent of the spring wrong: 8, not 12
exponent-of-the-damper-wrong-5-not-8 = exponent of the damper wrong: 5, not 8
not-as-the-rules-say = not as the rules say
nsn = Nsn
nsn-20-samples = Nsn, 20 samples
in-tolerance = In tolerance
force-within-10 = Force within 10 %
longest-overload = Longest overload
override-travel = Override travel
the-papers-models = the papers' models
the-models-found = the models found
sdnrp-2007-table-3 = SDNRP 2007, Table 3
control-strategy-2013-table-1 = Control strategy 2013, Table 1
feasible = feasible
nothing-is-feasible = nothing is feasible
at-most = at most
at-least = at least
the-same-as = the same as
other-than = other than
less-than = less than
more-than = more than
largest-less-least = largest less least
first = first
last = last
x-along-the-feed = x, along the feed
y-across-the-feed = y, across the feed
holds = holds
holds-in-part = holds in part
does-not-hold = does not hold
no-run-yet = no run yet
k4-of-the-papers = K4 of the papers
tooth-by-tooth-2 = tooth by tooth
