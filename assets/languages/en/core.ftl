# Texts of the program, written by its tests: see ARCHITECTURE.md.

## crates/core/src/base/files.rs

a-whole-number-from-0-to-4294967295 = a whole number from 0 to 4294967295
a-whole-number-from-0-on = a whole number from 0 on
a-list = a list
a-list-of-3-numbers = a list of 3 numbers
a-table = a table
missing-field-field = missing field { $field }
unknown-field-field-expected-one-of-known = unknown field { $field }, expected one of { $known }
unknown-field-field-expected-known = unknown field { $field }, expected { $known }
invalid-type-found-allowed-is-allowed = invalid type: { $found }, allowed is { $allowed }
invalid-type-found-expected-expected = invalid type: { $found }, expected { $expected }
invalid-value-found-allowed-is-allowed = invalid value: { $found }, allowed is { $allowed }
invalid-value-found-expected-expected = invalid value: { $found }, expected { $expected }
invalid-length-found-allowed-is-allowed = invalid length { $found }, allowed is { $allowed }
invalid-length-found-expected-expected = invalid length { $found }, expected { $expected }
problem-at-line-line-column-column = { $problem } at line { $line } column { $column }
not-json-problem = not JSON: { $problem }
problem-at-line-line = { $problem } at line { $line }
not-toml-problem = not TOML: { $problem }

## crates/core/src/base/formula/certificate.rs

given-ranges-were-given-for-needed-inputs = { $given } ranges were given for { $needed } inputs
the-range-low-high-of-name-is-none-allowed-i = the range { $low }..{ $high } of `{ $name }` is none: allowed is low <= high
its-slope-may-be-of-either-sign = its slope may be of either sign

## crates/core/src/base/formula/error.rs

column-column-problem = column { $column }: { $problem }

## crates/core/src/base/formula/interval.rs

there-is-no-such-input = there is no such input
it-may-be-too-large-for-a-number = it may be too large for a number
the-logarithm-of-0-or-a-negative-number = the logarithm of 0 or a negative number
the-root-of-a-negative-number = the root of a negative number
a-division-by-0 = a division by 0
t-0-to-a-power-that-is-not-positive = 0 to a power that is not positive
a-negative-number-to-a-power-that-is-not-who = a negative number to a power that is not whole

## crates/core/src/base/formula/mod.rs

the-formula-is-nested-more-than-n-deep = the formula is nested more than { $n } deep
the-formula-has-n-nodes-allowed-are-most = the formula has { $n } nodes: allowed are { $most }
there-is-no-input-input-there-are-n = there is no input { $input }: there are { $n }
the-derivative-by-input-cannot-be-written-pr = the derivative by `{ $input }` cannot be written: { $problem }
name-is-no-name-of-an-input-allowed-is-any-w = `{ $name }` is no name of an input: allowed is any without `"`
two-inputs-have-the-name-name = two inputs have the name `{ $name }`
the-formula-reads-input-input-there-are-n = the formula reads input { $input }: there are { $n }
the-formula-has-the-number-number-allowed-ar = the formula has the number { $number }: allowed are finite ones
the-constant-name-is-value-allowed-are-finit = the constant `{ $name }` is { $value }: allowed are finite ones
name-is-an-input-and-a-constant = `{ $name }` is an input and a constant
a-minus-sign-before-a-number-write-a-negativ = a minus sign before a number: write a negative number

## crates/core/src/base/formula/parse.rs

the-formula-has-n-bytes-allowed-are-most = the formula has { $n } bytes: allowed are { $most }
expected-an-operator-or-the-end = expected an operator (+ - * / ^) or the end
expected-a-number-a-name-a-function-or = expected a number, a name, a function or `(`
expected-or-an-operator = expected `)` or an operator (+ - * / ^)
expected-behind-the-function-name = expected `(` behind the function `{ $name }`
expected-but-the-formula-ends-here = { $expected }, but the formula ends here
expected-but-found-found = { $expected }, but found `{ $found }`
a-number-has-a-decimal-point-not-a-comma = a number has a decimal point, not a comma
a-product-needs-its = a product needs its `*`
a-quoted-name-without-its-end = a quoted name without its end
sign-has-no-meaning-in-a-formula-allowed-are = `{ $sign }` has no meaning in a formula: allowed are + - * / ^ ( )
the-number-is-too-large = the number is too large
this-is-no-number = this is no number
the-formula-has-more-than-n-nodes = the formula has more than { $n } nodes
unknown-function-name-the-natural-logarithm = unknown function `{ $name }`: the natural logarithm is `ln`
unknown-function-name-did-you-mean-near = unknown function `{ $name }`: did you mean `{ $near }`?
unknown-name-name-did-you-mean-near = unknown name `{ $name }`: did you mean `{ $near }`?
unknown-function-name-known-are-names = unknown function `{ $name }`: known are { $names }
unknown-name-name-known-are-names = unknown name `{ $name }`: known are { $names }

## crates/core/src/base/formula/unit.rs

the-unit-unit-ends-with = the unit `{ $unit }` ends with `/`
unit-is-no-unit-a-power-is-a-number-as-in-mm = `{ $unit }` is no unit: a power is a number, as in mm^2
unit-is-no-unit-known-are-known = `{ $unit }` is no unit: known are { $known }

## crates/core/src/base/formula/units.rs

given-units-were-given-for-needed-inputs = { $given } units were given for { $needed } inputs
the-formula-has-the-unit-unit-but-its-result = the formula has the unit { $unit }, but its result is to have { $wanted }
name-needs-a-plain-number-but-this-has-the-u = `{ $name }` needs a plain number, but this has the unit { $unit }
cannot-add-second-to-first = cannot add { $second } to { $first }
cannot-subtract-second-from-first = cannot subtract { $second } from { $first }
an-exponent-is-a-plain-number-but-this-has-t = an exponent is a plain number, but this has the unit { $unit }
with-an-exponent-that-changes-the-base-must = with an exponent that changes, the base must be a plain number, but this has the unit { $unit }

## crates/core/src/base/network/file.rs

note-is-n-bytes-long-allowed-is-at-most-most = `note` is { $n } bytes long: allowed is at most { $most }
activation-cannot-be-found-allowed-is-ids = `activation` cannot be { $found }: allowed is { $ids }
low-and-high-must-be-equally-long-found-lows = `{ $low }` and `{ $high }` must be equally long, found { $lows } and { $highs }
longer-than-n-bytes = longer than { $n } bytes

## crates/core/src/base/network/mod.rs

sizes-must-be-2-to-layers-layers-of-1-to-neu = `sizes` must be 2 to { $layers } layers of 1 to { $neurons } neurons
weights-holds-n-numbers-needed-are-needed = `weights` holds { $n } numbers, needed are { $needed }
weights-index-is-weight-it-must-be-finite = `weights[{ $index }]` is { $weight }: it must be finite

## crates/core/src/base/network/scaling.rs

name-must-hold-needed-values-each-found-foun = `{ $name }` must hold { $needed } values each, found { $found }
xmin-index-and-xmax-index-are-low-and-high-t = `xmin[{ $index }]` and `xmax[{ $index }]` are { $low } and { $high }: they must be finite and ascending, positive where `ln_inputs` is true
ymin-index-and-ymax-index-must-be-finite-and = `ymin[{ $index }]` and `ymax[{ $index }]` must be finite and ascending
norm-lo-norm-hi-and-target-lo-target-hi-must = `norm_lo`, `norm_hi` and `target_lo`, `target_hi` must ascend

## crates/core/src/base/settings/error.rs

unknown-setting-path-did-you-mean-near = unknown setting `{ $path }`; did you mean `{ $near }`?
unknown-setting-path-list-prints-all-setting = unknown setting `{ $path }`; `list` prints all settings
path-cannot-be-value-allowed-is-allowed = `{ $path }` cannot be { $value }: allowed is { $allowed }

## crates/core/src/base/settings/kind.rs

a-number-from-min-to-max-unit = a number from { $min } to { $max }{ $unit }
a-whole-number-from-min-to-max-unit = a whole number from { $min } to { $max }{ $unit }
true-or-false = true or false
one-of-ids = one of { $ids }
text-of-at-most-n-characters = text of at most { $n } characters

## crates/core/src/base/text.rs

it-is-utf-32-save-it-as-utf-8 = it is UTF-32: save it as UTF-8
it-is-utf-16-with-half-a-character-in-it-sav = it is UTF-16 with half a character in it: save it as UTF-8
it-is-no-text-but-an-archive-or-a-spreadshee = it is no text but an archive or a spreadsheet: save its table as CSV
it-is-no-text-byte-0x-byte-in-line-line = it is no text: byte 0x{ $byte } in line { $line }
it-is-not-utf-8-byte-0x-byte-in-line-line-bu = it is not UTF-8 (byte 0x{ $byte } in line { $line }) but perhaps Latin-1 or Windows-1252, where it is { $letter }: save it as UTF-8
it-is-not-utf-8-byte-0x-byte-in-line-line-bu-2 = it is not UTF-8 (byte 0x{ $byte } in line { $line }) but perhaps Windows-1252: save it as UTF-8
it-is-utf-16-little-endian-without-a-byte-or = it is UTF-16 (little endian) without a byte order mark: save it as UTF-8
it-is-utf-16-big-endian-without-a-byte-order = it is UTF-16 (big endian) without a byte order mark: save it as UTF-8

## crates/core/src/blocks/cnc/overload.rs

the-machine-stopped-at-time-s-position-mm-fo = The machine stopped at { $time } s, { $position } mm: { $force } N, allowed { $limit } N; the tool is lifted off the work
the-machine-stopped-at-time-s-position-mm-fo-2 = The machine stopped at { $time } s, { $position } mm: { $force } N, allowed { $limit } N

## crates/core/src/blocks/control/adjustable_pi.rs

stute-and-goetz-cited-in-combined-system-200 = Stute and Goetz, cited in Combined system 2005; gains chosen, K by recursive least squares with forgetting

## crates/core/src/blocks/control/afc/mod.rs

after-heidenhain-s-adaptive-feed-control-afc = after Heidenhain's adaptive feed control (AFC), in words only; F_1 by teach-in, rates, air and entry feed chosen
f-m-measured-n-no-reference-for-cut-cut = F_m = { $measured } N; no reference for cut { $cut }
teach-in = teach-in
watching = watching
u-goes-to-limit-f-1-f-m-low-high = u goes to limit(F_1 / F_m, { $low } %, { $high } %)

## crates/core/src/blocks/control/constant_feed.rs

conventional-milling-which-every-paper-compa = conventional milling, which every paper compares with

## crates/core/src/blocks/control/division.rs

combined-system-2005-divisional-controller-i = Combined system 2005, divisional controller, in words only: the reading that is stable and as poor in accuracy as its Table 1
chosen-the-divisional-controller-of-2005-ove = chosen: the divisional controller of 2005 over the feed that was reached
chosen-the-divisional-controller-of-2005-ove-2 = chosen: the divisional controller of 2005 over its last command

## crates/core/src/blocks/control/mrac.rs

landau-and-lozano-s-direct-form-as-daneshmen = Landau and Lozano's direct form, as Daneshmend and Pak and Tomizuka, cited in Combined system 2005, used it; numbers chosen
chosen-model-reference-adaptive-control-of-c = chosen: model-reference adaptive control of Combined system 2005 with one gain
u-from-five-adapted-parameters = u from five adapted parameters θ φ

## crates/core/src/blocks/control/preview/mod.rs

chosen-a-kalman-filter-of-the-gain-g-over-th = chosen: a Kalman filter of the gain g over the believed part; no paper prints it

## crates/core/src/blocks/control/proportional.rs

tlusty-and-elbestawi-cited-in-combined-syste = Tlusty and Elbestawi, cited in Combined system 2005; gains chosen

## crates/core/src/blocks/control/script/mod.rs

update-gave-kind-allowed-is-a-number-the-fee = `update` gave `{ $kind }`: allowed is a number, the feed override in percent, or a map of { $names }
name-that-update-gave-is-no-number = `{ $name }` that `update` gave is no number
update-gave-name-which-nothing-takes-allowed = `update` gave `{ $name }`, which nothing takes: allowed are { $names }
name-came-to-value-which-is-no-finite-number = `{ $name }` came to { $value }, which is no finite number
more-than-n-steps-in-one-control-period-an-e = more than { $n } steps in one control period: an endless loop?
a-script-of-one-s-own = a script of one's own

## crates/core/src/blocks/control/script/program.rs

line-line-what = line { $line }: { $what }
it-has-n-bytes-at-most-most-are-allowed = it has { $n } bytes: at most { $most } are allowed
function-name-has-n-parameters-one-is-allowe = function `{ $name }` has { $n } parameters: one is allowed, `{ $name }({ $parameter })`
there-is-no-function-update-now-which-gives = there is no function `update(now)`, which gives the command
something-stands-outside-of-its-functions-no = something stands outside of its functions: nothing but functions is allowed
a-script-with-a-function-update-now-at-most = a script with a function `update(now)`, at most { $n } bytes
this-script-problem = this script ({ $problem })

## crates/core/src/blocks/control/sdnrp.rs

sdnrp-2007-figures-lost-the-reading-that-fit = SDNRP 2007, figures lost: the reading that fits text and Table 3
control-strategy-2013-steps-5-to-7-in-words = Control strategy 2013, steps 5 to 7, in words only: read as in SDNRP 2007

## crates/core/src/blocks/control/tracking.rs

chosen-internal-model-control-with-a-smith-p = chosen: internal model control with a Smith predictor; no paper prints it
g-follows-f-m-model-predicted-f-n-with-a-tim = g follows F_m / { $model }(predicted f, n) with a time constant of { $time } s
f-c-n-c-from-model-4-f-c-n-c-u-on-the-line-o = f_c, n_c from { $model_4 }(f_c, n_c) = u on the line of { $model_2 } and { $model_3 }
model-3-and-the-inverse-of-model-4-within-th = { $model_3 } and the inverse of { $model_4 } within their ranges
what-rounding-to-whole-takes-is-added-to-the = what rounding to whole % takes is added to the next request: the mean is as asked
t-1-is-feed-mm-min-and-speed-1-min = 1 % is { $feed } mm/min and { $speed } 1/min
gain-gain = gain { $gain }

## crates/core/src/blocks/control/unks/mod.rs

combined-system-2005-unks-after-kawato-s-hie = Combined system 2005: UNKS, after Kawato's hierarchical scheme; weights and rates were never published
feedback-error-learning-miyamoto-kawato-seto = feedback-error learning (Miyamoto, Kawato, Setoyama, Suzuki 1988), on which UNKS of Combined system 2005 rests

## crates/core/src/blocks/cutting/breakage.rs

the-tool-broke-at-time-s-position-mm-by-too = The tool broke at { $time } s, { $position } mm by too thick a chip, { $load } mm: it stands { $stands } mm
the-tool-broke-at-time-s-position-mm-by-too-2 = The tool broke at { $time } s, { $position } mm by too large a force, { $load } N: it stands { $stands } N

## crates/core/src/blocks/cutting/crash.rs

the-tool-crashed-at-time-s-position-mm-a-fee = The tool crashed at { $time } s, { $position } mm: a feed of { $feed } mm/min at { $speed } 1/min is more than the cutter's radius, { $radius } mm, for each tooth

## crates/core/src/blocks/cutting/force_model/formula.rs

sdnrp-2007-eq-7-ck45-a-d-2-mm-r-d-3-mm-sharp = SDNRP 2007, eq. 7 (Ck45, A_D 2 mm, R_D 3 mm, sharp tool)
control-strategy-2013-eq-5-the-paper-then-ta = Control strategy 2013, eq. 5; the paper then takes its neural network in place of it
a-formula = a formula
f-from-feed-mm-min-on-its-least-force-n-from = f from { $feed } mm/min on (its least force), n from { $speed } 1/min on
of-the-papers-cutter-alone = of the papers' cutter alone
of-the-cutter-cutter-alone = of the cutter { $cutter } alone
f-least-feed-to-most-feed-mm-min-n-least-spe = f { $least_feed } to { $most_feed } mm/min, n { $least_speed } to { $most_speed } 1/min; straight on beyond

## crates/core/src/blocks/cutting/force_model/mechanistic.rs

combined-system-2005-fig-3-lost-as-ball-end = Combined system 2005, Fig. 3 (lost), as ball-end geometry after Lee and Altintas
combined-system-2005-eq-1-compliance-with-th = Combined system 2005, eq. 1: compliance with the delay of one tooth period
kienzle-s-laws-tangential-radial-and-axial-c = Kienzle's laws, tangential, radial and axial (constants of published tables, in part chosen)
by-teeth = by teeth
f-t-feed-teeth-speed-chip-mm-run-out-runout = f_t = { $feed } / ({ $teeth } · { $speed }) = { $chip } mm, run-out ± { $runout } mm
f-largest-f-x-2-f-y-2-of-a-control-period = F = largest √(F_x^2 + F_y^2) of a control period
f-force-n-with-vibration-shaken-n-a-d-axial = F = { $force } N; with vibration { $shaken } N  (A_D { $axial } mm, R_D { $radial } mm)

## crates/core/src/blocks/cutting/force_model/network_card.rs

f-x-f-y-f-z-factor-nn-inputs = F_x, F_y, F_z = { $factor }NN(inputs)
f-xy-f-x-2-f-y-2-at-the-instant-of-its-large = F_{ "{" }xy{ "}" } = √(F_x^2 + F_y^2), at the instant of its largest value
f-feed-mm-min-n-speed-1-min-r-d-radial-mm-a = f { $feed } mm/min, n { $speed } 1/min, R_D { $radial } mm, A_D { $axial } mm, material { $material }, { $hardness } HB, D { $diameter } mm, geometry { $geometry }
feed-per-tooth-2 = feed per tooth
cutting-speed-2 = cutting speed
geometry = geometry
name-value-unit-trained-on-range = { $name } { $value } { $unit }, trained on { $range }
this-cutter-trained-on-ball-ends-with-two-te = this cutter, trained on ball ends with two teeth and the papers' helix
material-at-hardness-hb-trained-on-materials = { $material } at { $hardness } HB, trained on { $materials }
rows-rows-epochs-epochs-seed-seed = { $rows } rows, { $epochs } epochs, seed { $seed }

## crates/core/src/blocks/cutting/force_model/neural.rs

control-strategy-2013-section-2-3-8-inputs-1 = Control strategy 2013, section 2.3: 8 inputs, 15 hidden neurons, 3 outputs; its weights were never published

## crates/core/src/models/disturbances/mod.rs

factor = factor
times-the-force = { " " }times the force
change-2 = change
mm-deeper = { " " }mm deeper
wear-land = wear land
mm-more-vb = { " " }mm more VB
amplitude = amplitude
of-the-force = { " " }% of the force
offset = offset
n-in-the-end = { " " }N in the end
addition = addition
s-longer = { " " }s longer
override = override
of-the-feed = { " " }% of the feed

## crates/core/src/models/disturbances/placed.rs

position-mm = position mm
positions-ascending-from-0-to-most-mm = positions ascending from 0 to { $most } mm
length-mm = length mm
lengths-from-least-to-most-mm = lengths from { $least } to { $most } mm
size-from-least-to-most-unit = { $size } from { $least } to { $most } { $unit }
at-most-n-lists-entries-ranges = at most { $n } lists [{ $entries }], { $ranges }

## crates/core/src/models/formula_model/file.rs

tool-cannot-be-id-allowed-is-one-of-ids = `tool` cannot be `{ $id }`: allowed is one of { $ids }
n-bytes-at-most-most-are-read = { $n } bytes; at most { $most } are read
version-cannot-be-version-allowed-is-known = `version` cannot be { $version }: allowed is { $known }
inputs-index-the-range-low-to-high-of-name-i = `inputs[{ $index }]`: the range { $low } to { $high } of `{ $name }` is none: allowed is low below high

## crates/core/src/models/formula_model/fit.rs

rows-cannot-be-rows-allowed-is-more-than-the = `rows` cannot be { $rows }: allowed is more than the { $n } constants
deviation-cannot-be-deviation-allowed-is-0-o = `deviation` cannot be { $deviation }: allowed is 0 or more
constants-cannot-have-constant-allowed-are-n = `constants` cannot have { $constant }: allowed are numbers of the formula, from left to right
covariance-is-none-of-n-constants-allowed-is = `covariance` is none of { $n } constants: allowed is a lower triangle of finite numbers, none below 0 on the diagonal

## crates/core/src/models/formula_model/mod.rs

n-inputs-allowed-are-at-most-most = { $n } inputs: allowed are at most { $most }
the-inputs-are-not-those-of-the-formula = the inputs are not those of the formula
first-and-last = { $first } and { $last }
the-formula-has-no-bounds-on-its-ranges = the formula has no bounds on its ranges
its-slope-by-input-slope-has-no-bounds-on-it = its slope by `{ $input }`, { $slope }, has no bounds on its ranges
name-from-low-to-high = `{ $name }` from { $low } to { $high }
the-formula-is-not-certain-to-have-a-finite = the formula is not certain to have a finite value on its ranges: for { $place }, { $why }
its-slope-by-input-slope-is-not-certain-to-h = its slope by `{ $input }`, { $slope }, is not certain to have a finite value on its ranges: for { $place }, { $why }

## crates/core/src/models/formula_model/setting.rs

name-in-unit = `{ $name }` in { $unit }
it-makes-output-of-inputs-allowed-is-wanted = it makes { $output } of { $inputs }: allowed is { $wanted } of { $of }
nothing-or-the-text-of-a-formula-s-model-fil = nothing, or the text of a formula's model file: { $wanted } of { $of }, finite on its ranges
this-text-problem = this text ({ $problem })

## crates/core/src/models/genetic/model_file.rs

name-turns-round-within-low-high-allowed-is = `{ $name }` turns round within { $low }..{ $high }: allowed is a monotone curve
name-field-cannot-be-value-allowed-is-a-fini = `{ $name }.{ $field }` cannot be { $value }: allowed is a finite number

## crates/core/src/models/neural_force/mod.rs

sizes-cannot-be-sizes-allowed-is-8-1-to-most = `sizes` cannot be { $sizes }: allowed is 8, 1 to { $most } and 3 neurons

## crates/core/src/models/part/shapes.rs

at-most-n-pairs-position-mm-depth-mm-positio = at most { $n } pairs [position mm, depth mm], positions ascending from 0 to { $position }, depths from 0 to { $depth }
at-most-n-cuts-of-1-to-sections-sections-len = at most { $n } cuts of 1 to { $sections } sections [length mm, axial depth mm, wall mm], lengths from { $shortest } to { $length }, depths from 0 to { $depth }, walls from -{ $depth } to { $depth }
at-most-n-numbers-one-for-each-cut-from-min = at most { $n } numbers, one for each cut, from { $min } to { $max }{ $unit }

## crates/core/src/models/structure/parameters.rs

base-console = base console
tooth = tooth
slides = slides
table-2 = table

## crates/core/src/models/structure/reduction.rs

n-modes-across-the-feed-in-a-running-cut = { $n } modes across the feed in a running cut
t-1-to-4-modes-across-the-feed-which-the-surfa = 1 to 4 modes across the feed, which the surface sees

## crates/core/src/models/tip_modes/file.rs

structure-file = structure file
line-line-entry-cannot-be-value-allowed-is-a = line { $line }: `{ $entry }` cannot be { $value }: allowed is { $allowed }
x-or-y = x or y
mode-place-one-of-mass-kg-and-stiffness-n-m = mode { $place }: one of `mass_kg` and `stiffness_n_m` is wanted, not both and not neither
what-makes-a-modal-mass-from-low-to-high-kg = what makes a modal mass from { $low } to { $high } kg at this frequency
a-number-from-low-to-high = a number from { $low } to { $high }
text-of-n-characters = text of { $n } characters
text-of-1-to-n-characters = text of 1 to { $n } characters
there-is-no-mode-at-least-one-mode-is-wanted = there is no mode: at least one `[[mode]]` is wanted

## crates/core/src/models/tip_modes/mod.rs

n-modes-allowed-are-at-most-most = { $n } modes: allowed are at most { $most }
mode-place-entry-cannot-be-value-allowed-is = mode { $place }: `{ $entry }` cannot be { $value }: allowed is a number from { $low } to { $high }
at-most-n-lists-axis-frequency-damping-ratio = at most { $n } lists [axis, frequency, damping ratio, modal mass]: axis 0 for x or 1 for y, { $f0 } to { $f1 } Hz, { $d0 } to { $d1 }, { $m0 } to { $m1 } kg

## crates/core/src/models/tool/file.rs

tool-file = tool file
key-must-be-text-of-1-to-n-characters = `{ $key }` must be text of 1 to { $n } characters
key-is-missing = `{ $key }` is missing
version-version-is-missing = `version = { $version }` is missing
key-is-missing-allowed = `{ $key }` is missing: { $allowed }
unknown-entry-key-there-are-version-title-so = unknown entry `{ $key }`; there are version, title, source, { $known }
line-line-corner-radius-mm-cannot-be-radius = line { $line }: `corner_radius_mm` cannot be { $radius } mm: allowed is at most half of `diameter_mm`, { $most } mm

## crates/core/src/models/transfer/setting.rs

stable-poles-real-parts-from-slowest-down-to = stable poles: real parts from { $slowest } down to { $fastest } rad/s, imaginary parts from 0 to { $largest } rad/s, order at most { $n }
pole-place-cannot-be-re-and-im-rad-s-allowed = pole { $place } cannot be { $re } and { $im } rad/s: allowed is { $allowed }
the-order-cannot-be-order-allowed-is-allowed = the order cannot be { $order }: allowed is { $allowed }
lists-real-imaginary-of-poles = lists [real, imaginary] of { $poles }

## crates/core/src/models/unks/stored.rs

start-cannot-be-found-allowed-is-one-of-ids = `start` cannot be { $found }: allowed is one of { $ids }
sizes-cannot-be-sizes-allowed-is-allowed = `sizes` cannot be { $sizes }: allowed is { $allowed }
nothing-or-the-text-of-a-file-that-steadycut = nothing, or the text of a file that `steadycut unks --save` writes: finite weights of NM-R 2-12-1, NM-1 4-8-1, NM-2 4-8-1

## crates/core/src/models/unks.rs

name-sizes-cannot-be-sizes-allowed-is-allowe = { $name }: `sizes` cannot be { $sizes }: allowed is { $allowed }

## crates/core/src/run/closed_loop/mod.rs

signal-is-not-finite-at-tick-tick-the-run-en = `{ $signal }` is not finite at tick { $tick }: the run ends
the-script-failed-at-time-s-problem-the-run = The script failed at { $time } s, { $problem }: the run ends

## crates/core/src/run/constant_feed_twin.rs

safe-constant-feed = safe constant feed

## crates/core/src/run/diagram/mod.rs

reference = Reference
turns-the-target-roughness-into-the-cutting = Turns the target roughness into the cutting force that leaves it. The loop then holds this force: a constant force keeps the finish constant.
compares-the-measured-force-with-the-desired = Compares the measured force with the desired one every control period and asks for feed and spindle speed. The models it computes with are its belief: they need not be those of the cut.
limit-2 = limit
override-limits = Override limits
the-cnc-takes-commands-as-percent-of-the-pro = The CNC takes commands as percent of the programmed feed (DNCFRO) and speed (DNCSPO), within limits. What the controller asks beyond them is cut off; the lamp shows it. A real CNC takes whole percents and moves to a new override at a rate: both can be switched on.
rate = rate
the-plc-of-the-machine-passes-every-command = The PLC of the machine passes every command on after a fixed time. Each dot is one command under way; its height shows its size against the others.
the-servo-system-follows-the-command-with-th = The servo system follows the command with the lag of its transfer function, computed exactly at every step.
the-spindle-follows-its-command-as-a-first-o = The spindle follows its command as a first-order lag that cannot change speed faster than its rate limit.
cutting-process = Cutting process
the-true-cut-maximum-cutting-force-from-feed = The true cut: maximum cutting force from feed and speed, times what the model does not know: material and hardness, cross-section of the cut, tool wear.
dynamic-component = Dynamic component
what-a-real-force-adds-to-the-model-band-lim = What a real force adds to the model: band-limited noise, the ripple of the teeth, slow changes of the material along the path; each with its own seeded stream.
contact = contact
dynamometer = Dynamometer
the-force-sensor-reads-the-dynamic-force-onc = The force sensor: reads the dynamic force once per control period and adds its own noise. The controller sees only this.
surface = Surface
the-roughness-that-the-force-leaves-on-the-p = The roughness that the force leaves on the part, without machine dynamics. Identified models invert that of the reference exactly, so that a force held at its desired value leaves the desired roughness.
the-roughness-with-machine-dynamics-the-same = The roughness with machine dynamics: the same equation, fed with the force and its dynamic component.

## crates/core/src/run/diagram/names.rs

the-controller-s-belief = the controller's belief
the-plant = the plant
own-formula = own formula
now-whose-force = Now, { $whose }: { $force }
now-whose-models-origin = Now, { $whose }: { $models }, { $origin }
now-2 = Now
force-for-a-target-ra-2 = force for a target Ra
feed-for-a-force-2 = feed for a force
speed-for-a-force-2 = speed for a force
cutting-force = cutting force
model-outside-its-range = { $model } outside its range

## crates/core/src/run/diagram/printed.rs

sdnrp-2007-eq-4 = SDNRP 2007, eq. 4
sdnrp-2007-eq-5 = SDNRP 2007, eq. 5
sdnrp-2007-eq-6 = SDNRP 2007, eq. 6
sdnrp-2007-eq-8 = SDNRP 2007, eq. 8
control-strategy-2013-eq-2 = Control strategy 2013, eq. 2
control-strategy-2013-eq-3-10-05-can-only-be = Control strategy 2013, eq. 3 ("10^05" can only be 10^-5)
control-strategy-2013-eq-4 = Control strategy 2013, eq. 4
control-strategy-2013-eq-6 = Control strategy 2013, eq. 6
a-drive-of-your-own-by-its-poles-and-gain = a drive of your own, by its poles and gain
the-dead-time-of-the-command-channel-the-dri = the dead time of the command channel; the drive is your own
sdnrp-2007-eq-1-with-the-constants-of-its-ta = SDNRP 2007, eq. 1, with the constants of its Table 1
sdnrp-2007-eq-2-the-sum-is-a-misprint-a-prod = SDNRP 2007, eq. 2 (the sum is a misprint: a product has the gain 1)
sdnrp-2007-eq-3-the-drive-that-the-paper-sim = SDNRP 2007, eq. 3: the drive that the paper simulates with
control-strategy-2013-eq-1-natural-frequency = Control strategy 2013, eq. 1 ("natural frequency of 3 Hz" does not fit it)
second-order-natural-frequency-3-hz-settling = second order, natural frequency 3 Hz, settling time 0.4 s
control-strategy-2013-section-2-2-measured-s = Control strategy 2013, section 2.2: measured step responses, in words only
sdnrp-2007-eq-2-and-3-the-text-s-t-8-s-is-a = SDNRP 2007, eq. 2 and 3 (the text's "t = 8 s" is a misprint)
control-strategy-2013-section-2-2-below-eq-1 = Control strategy 2013, section 2.2, below eq. 1
control-strategy-2013-section-2-whole-percen = Control strategy 2013, section 2; whole percents and rate: CNC practice, chosen
chosen-no-paper-gives-a-spindle-drive = chosen: no paper gives a spindle drive
sdnrp-2007-fig-10-lost-random-sized-like-mea = SDNRP 2007, Fig. 10 (lost): random, sized like measured oscillations; form chosen
sdnrp-2007-section-1-kistler-force-transduce = SDNRP 2007, section 1: Kistler force transducer; noise chosen

## crates/core/src/run/diagram/wires.rs

signal-after-dead-time = { $signal }, after dead time
symbol-delayed = { $symbol } delayed

## crates/core/src/run/edits.rs

the-change-at-at-s-does-not-fit-any-more-rea = the change at { $at } s does not fit any more: { $reason }
changed-again = changed again
at-most-100000-changes-in-a-run = at most 100000 changes in a run
a-change-of-the-scenario-itself-it-belongs-t = a change of the scenario itself: it belongs to the set-up
changed-during-the-run = changed during the run
a-time-from-0-to-before-end-s = a time from 0 to before { $end } s
changed-at-at-s = changed at { $at } s

## crates/core/src/run/explanation.rs

name-low-to-high-unit = { $name } { $low } to { $high } { $unit }
straight-on-beyond = straight on beyond

## crates/core/src/run/job.rs

done-of-total-unit = { $done } of { $total } { $unit }

## crates/core/src/run/packed.rs

its-packed-part-is-not-url-safe-base64-probl = its packed part is not URL-safe Base64: { $problem }
its-packed-part-unpacks-to-more-than-n-bytes = its packed part unpacks to more than { $n } bytes, the most that are read
its-packed-part-is-not-whole = its packed part is not whole
text-that-is-not-utf-8 = text that is not UTF-8

## crates/core/src/run/presets.rs

preset-name = preset `{ $name }`
there-is-none-of-this-name-there-are-names = there is none of this name; there are { $names }

## crates/core/src/run/scenario/rules.rs

formula-without-a-formula-for-the-plant = formula without a formula for the plant
formula-together-with-formula-force-or-formu = formula together with `formula.force` or `formula.ra`: set both at once, or first the formula and last take it away
formula-without-a-formula = formula without a formula
formula-together-with-one-of-formula-force-o = formula together with one of `formula.force_of_ra`, `formula.feed`, `formula.speed`, `formula.force`, `formula.ra`: set both at once, or first the formula and last take it away
at-most-cnc-speed-max-rpm-most-1-min = at most `cnc.speed_max_rpm`, { $most } 1/min
model-with-plant-steps-of-step-s = { $model } with plant steps of { $step } s
plant-steps-of-at-most-longest-s-run-steps-p = plant steps of at most { $longest } s: `run.steps_per_control` from { $steps } on (576 give 28.8 kHz)
n-modes-across-the-feed-with-machine-coupled = { $n } modes across the feed with `machine.coupled` = true
t-1-to-4-modes-across-the-feed-axis-1-there-of = 1 to 4 modes across the feed (axis 1) there, of at most { $most } Hz: ten steps of 0.1 ms to a period
parameters-with-machine-coupled-true-overdam = { $parameters } with `machine.coupled` = true (overdamped modes)
d-or-t-in-a-coupled-run = D or T in a coupled run
true-without-the-machine-s-sound = true without the machine's sound
true-with-machine-coupled-true = true with `machine.coupled` = true
networks-of-the-start-start = networks of the start `{ $start }`
networks-of-controller-unks-start-wanted-or = networks of `controller.unks.start`, { $wanted }, or none; set both together
at-most-half-of-tool-diameter-mm-half-mm = at most half of `tool.diameter_mm`, { $half } mm
at-most-tool-diameter-mm-diameter-mm = at most `tool.diameter_mm`, { $diameter } mm
n-broken-teeth = { $n } broken teeth
at-most-most-one-fewer-than-tool-teeth-teeth = at most { $most }, one fewer than `tool.teeth`, { $teeth }
n-with-machine-coupled-true = { $n } with `machine.coupled` = true
none-there-the-machine-s-regeneration-and-th = none there: the machine's regeneration and the marks of the teeth count every tooth
frequency-hz-with-bursts-and-plant-steps-of = { $frequency } Hz with bursts and plant steps of { $step } s
at-most-most-hz-three-steps-to-a-period-more = at most { $most } Hz, three steps to a period; more `run.steps_per_control` allow more
so-much-the-cut-would-be-deepest-mm-deep = so much: the cut would be { $deepest } mm deep
what-leaves-it-at-most-most-mm-deep-everywhe = what leaves it at most { $most } mm deep everywhere, with `workpiece.axial_depth_mm` or the depth of the cuts
below-noise-band-high-hz-high-hz = below `noise.band_high_hz`, { $high } Hz
a-divisor-of-run-steps-per-control-steps-eve = a divisor of `run.steps_per_control`, { $steps }: every control sample is recorded
at-most-longest-s-with-a-row-every-row-s-row = at most { $longest } s with a row every { $row } s ({ $rows } rows); record less often with `run.record_every`

## crates/core/src/run/scenario/unused.rs

controller-kind-is-another-one = `controller.kind` is another one
the-controller-does-not-ask-for-it-as-its-ot = the controller does not ask for it as its other settings stand
the-controller-as-it-is-set-does-not-ask-for = the controller, as it is set, does not ask for it
wear-curve-gives-the-wear-over-the-life = `wear.curve` gives the wear over the life
wear-force-curve-gives-the-force-over-the-we = `wear.force_curve` gives the force over the wear
wear-stiffness-curve-gives-the-stiffness-ove = `wear.stiffness_curve` gives the stiffness over the wear
wear-life-curve-gives-the-life-over-the-cut = `wear.life_curve` gives the life over the cut
target-reference-is-force = `target.reference` is force
target-reference-is-ra = `target.reference` is ra
belief-model-set-is-milling-2005-which-has-o = `belief.model_set` is milling_2005, which has one calibration
plant-model-set-is-milling-2005-which-has-on = `plant.model_set` is milling_2005, which has one calibration
belief-calibration-is-not-formula-or-belief = `belief.calibration` is not formula, or `belief.model_set` milling_2005
neither-belief-calibration-nor-plant-calibra = neither `belief.calibration` nor `plant.calibration`, where `plant.force_model` is formula, is formula
neither-belief-calibration-nor-plant-calibra-2 = neither `belief.calibration` nor `plant.calibration` is formula
tool-shape-is-no-bull-nose = `tool.shape` is no bull_nose
only-the-off-line-plan-bends-the-cutter = only the off-line plan bends the cutter
plant-force-model-is-a-map-not-mechanistic = `plant.force_model` is a map, not mechanistic
machine-coupled-is-true-the-machine-is-what = `machine.coupled` is true: the machine is what gives way
plant-force-model-is-mechanistic-the-teeth-s = `plant.force_model` is mechanistic: the teeth's force has no intercept
noise-level-is-0 = `noise.level` is 0
noise-band-percent-is-0 = `noise.band_percent` is 0
noise-inhomogeneity-percent-is-0 = `noise.inhomogeneity_percent` is 0
nothing-is-random-noise-level-or-every-size = nothing is random: `noise.level` or every size of noise is 0
cnc-override-rate-limited-is-false = `cnc.override_rate_limited` is false
feed-drive-poles-gives-the-drive = `feed_drive.poles` gives the drive
feed-drive-poles-is-empty-the-papers-drives = `feed_drive.poles` is empty: the papers' drives have a gain of 1
spindle-drive-poles-gives-the-drive = `spindle_drive.poles` gives the drive
spindle-drive-poles-is-empty-lag-and-rate-li = `spindle_drive.poles` is empty: lag and rate limit have a gain of 1
cnc-force-stop-is-false = `cnc.force_stop` is false
workpiece-cuts-is-empty = `workpiece.cuts` is empty
program-cut-feeds-mm-min-programs-every-cut = `program.cut_feeds_mm_min` programs every cut
workpiece-cuts-gives-lengths-and-depths = `workpiece.cuts` gives lengths and depths
machine-coupled-is-false-the-cut-does-not-fe = `machine.coupled` is false: the cut does not feel the machine
machine-tip-modes-gives-the-machine = `machine.tip_modes` gives the machine
only-the-stability-chart-of-measured-modes-h = only the stability chart of measured modes has it
machine-tip-modes-gives-the-machine-its-toot = `machine.tip_modes` gives the machine: its tooth is stiff
wear-model-is-fixed = `wear.model` is fixed
wear-model-is-fixed-the-tool-is-worn-by-dist = `wear.model` is fixed: the tool is worn by `disturbances.wear_jumps` alone
machine-coupled-is-false-nothing-vibrates = `machine.coupled` is false: nothing vibrates
disturbances-chatter-bursts-is-empty = `disturbances.chatter_bursts` is empty
wear-life-curve-gives-the-life-over-the-cut-2 = `wear.life_curve` gives the life over the cut, and nothing adjusts the speed
wear-indentation-n-mm3-is-0 = `wear.indentation_n_mm3` is 0
wear-adjust-speed-is-false-or-wear-model-fix = `wear.adjust_speed` is false, or `wear.model` fixed
only-trends-over-the-tool-s-life-have-it-a-r = only trends over the tool's life have it; a run has the force of its own cut
ra-with-dynamics-in-the-running-cut-leaves-o = Ra with dynamics in the running cut leaves out waves below 50 um whatever is set
no-vibration-of-a-coupled-machine-makes-ra-w = no vibration of a coupled machine makes Ra with dynamics (`machine.coupled`, `machine.roughness_from`)
the-off-line-plan-has-it-not-a-run = the off-line plan has it, not a run
it-chooses-what-a-cut-is-compared-with-and-m = it chooses what a cut is compared with, and moves none

## crates/core/src/run/scenario_file.rs

scenario-file = scenario file
version-is-version-this-program-reads-known = `version` is { $version }; this program reads { $known }
path-and-now-are-one-setting-keep-now = `{ $path }` and `{ $now }` are one setting; keep `{ $now }`
edits-must-be-a-list-of-tables-with-at-s-a-n = `edits` must be a list of tables with `at_s` (a number), `path` (text) and `value`
unknown-field-edits-key-use-at-s-path-value = unknown field `edits.{ $key }`; use at_s, path, value

## crates/core/src/run/scenario_link/series.rs

the-series-of-path-has-n-parts-not-4 = the series of `{ $path }` has { $n } parts, not 4
the-series-of-path-has-times-times-and-value = the series of `{ $path }` has { $times } times and { $values } values
the-series-of-path-has-decimals-decimals-all = the series of `{ $path }` has `{ $decimals }` decimals; allowed are 0 to { $most }
the-series-of-path-has-step-where-a-whole-nu = the series of `{ $path }` has `{ $step }` where a whole number must stand

## crates/core/src/run/scenario_link.rs

it-is-packed-twice = it is packed twice
link = link
a-without-two-hexadecimal-digits = a % without two hexadecimal digits
part-is-not-name-value = `{ $part }` is not name=value
version-version-this-program-reads-known = version { $version }; this program reads { $known }
v-version-is-missing = `v={ $version }` is missing
at-key-names-no-setting = `at.{ $key }` names no setting
at-key-has-no-time-in-seconds = `at.{ $key }` has no time in seconds

## crates/core/src/run/signals.rs

feed-at-a-limit = feed at a limit
speed-at-a-limit = speed at a limit
feed-override-at-its-rate = feed override at its rate
spindle-override-at-its-rate = spindle override at its rate
tooth-out-of-contact = tooth out of contact
force-over-the-controller-s-limit = force over the controller's limit
control-switched-off = control switched off
tooth-broken = tooth broken

## crates/core/src/run/story/changes.rs

on = on
another-one = another one

## crates/core/src/run/story/effects.rs

it-was-unstable-stretches = It was unstable { $stretches }.
it-chattered-stretches = It chattered { $stretches }.
the-cut-is-finished-length-of-path = The cut is finished: { $length } of path.
the-time-limit-ends-the-run-with-done-of-who = The time limit ends the run with { $done } of { $whole } cut.

## crates/core/src/run/story/mod.rs

start = Start
contact-2 = Contact
air-2 = Air
depth-step-2 = Depth step
disturbance = Disturbance
setting = Setting
chatter = Chatter
unstable = Unstable

## crates/core/src/run/story/words/lasting.rs

the-command-answers-command-after-the-start = The command answers { $command } after the start, the feed only after { $feed }, since the command channel has a dead time of { $dead }
the-command-answers-command-after-contact-th = The command answers { $command } after contact, the feed only after { $feed }, since the command channel has a dead time of { $dead }
the-command-answers-command-after-the-step-t = The command answers { $command } after the step, the feed only after { $feed }, since the command channel has a dead time of { $dead }
the-command-answers-command-after-the-change = The command answers { $command } after the change, the feed only after { $feed }, since the command channel has a dead time of { $dead }
the-command-answers-command-after-it-the-fee = The command answers { $command } after it, the feed only after { $feed }, since the command channel has a dead time of { $dead }
the-command-answers-command-after-this-the-f = The command answers { $command } after this, the feed only after { $feed }, since the command channel has a dead time of { $dead }
until-then-name-goes-size-below-its-target = until then { $name } goes { $size } below its target
until-then-name-goes-size-above-its-target = until then { $name } goes { $size } above its target
the-feed-command-stands-at-its-upper-limit-v = The feed command stands at its upper limit, { $value } ({ $share } % override)
the-feed-command-stands-at-its-lower-limit-v = The feed command stands at its lower limit, { $value } ({ $share } % override)
the-spindle-speed-command-stands-at-its-uppe = The spindle speed command stands at its upper limit, { $value } ({ $share } % override)
the-spindle-speed-command-stands-at-its-lowe = The spindle speed command stands at its lower limit, { $value } ({ $share } % override)
at-share-of-this-time = { $at }, { $share } % of this time
name-is-outside-the-model-meanwhile = { $name } is outside the model meanwhile
meanwhile-name-is-size-below-its-target-with = meanwhile { $name } is { $size } below its target, within the tolerance
meanwhile-name-is-size-below-its-target-outs = meanwhile { $name } is { $size } below its target, outside the tolerance
meanwhile-name-is-size-above-its-target-with = meanwhile { $name } is { $size } above its target, within the tolerance
meanwhile-name-is-size-above-its-target-outs = meanwhile { $name } is { $size } above its target, outside the tolerance
meanwhile-ra-with-dynamics-is-size-below-its = meanwhile Ra with dynamics is { $size } below its target, within the tolerance
meanwhile-ra-with-dynamics-is-size-below-its-2 = meanwhile Ra with dynamics is { $size } below its target, outside the tolerance
meanwhile-ra-with-dynamics-is-size-above-its = meanwhile Ra with dynamics is { $size } above its target, within the tolerance
meanwhile-ra-with-dynamics-is-size-above-its-2 = meanwhile Ra with dynamics is { $size } above its target, outside the tolerance
meanwhile-ra-with-dynamics-is-outside-the-mo = meanwhile Ra with dynamics is outside the model instead of at its target
without-dynamics-size-below-it = without dynamics { $size } below it
without-dynamics-size-above-it = without dynamics { $size } above it
the-model-of-the-force-for-a-target-ra-model = The model of the force for a target Ra ({ $model }) is used outside what it was made for: its answer is a guess.
the-model-of-the-feed-for-a-force-model-is-u = The model of the feed for a force ({ $model }) is used outside what it was made for: its answer is a guess.
the-model-of-the-speed-for-a-force-model-is = The model of the speed for a force ({ $model }) is used outside what it was made for: its answer is a guess.
the-model-of-the-cutting-force-model-is-used = The model of the cutting force ({ $model }) is used outside what it was made for: its answer is a guess.
the-model-of-ra-model-is-used-outside-what-i = The model of Ra ({ $model }) is used outside what it was made for: its answer is a guess.
the-model-of-ra-with-dynamics-model-is-used = The model of Ra with dynamics ({ $model }) is used outside what it was made for: its answer is a guess.
the-model-of-the-force-for-a-target-ra-model-2 = The model of the force for a target Ra ({ $model }) is used outside its range
the-model-of-the-feed-for-a-force-model-is-u-2 = The model of the feed for a force ({ $model }) is used outside its range
the-model-of-the-speed-for-a-force-model-is-2 = The model of the speed for a force ({ $model }) is used outside its range
the-model-of-the-cutting-force-model-is-used-2 = The model of the cutting force ({ $model }) is used outside its range
the-model-of-ra-model-is-used-outside-its-ra = The model of Ra ({ $model }) is used outside its range
the-model-of-ra-with-dynamics-model-is-used-2 = The model of Ra with dynamics ({ $model }) is used outside its range
the-target-ra-goes-to-value = the target Ra goes to { $value }
the-force-asked-for-goes-to-value = the force asked for goes to { $value }
the-feed-goes-to-value = the feed goes to { $value }
the-spindle-speed-goes-to-value = the spindle speed goes to { $value }
the-force-goes-to-value = the force goes to { $value }
the-force-with-dynamics-goes-to-value = the force with dynamics goes to { $value }
it-holds-from-low-to-high-unit = it holds from { $low } to { $high } { $unit }
it-holds-from-low-unit-on = it holds from { $low } { $unit } on
it-holds-up-to-high-unit = it holds up to { $high } { $unit }
it-holds-elsewhere = it holds elsewhere
it-ends-where-the-depth-changes = It ends where the depth changes.
it-ends-where-the-tool-leaves-the-part = It ends where the tool leaves the part.
it-ends-while-the-depth-stays-the-same = It ends while the depth stays the same.
it-goes-on-to-the-end = It goes on to the end.
it-still-goes-on = It still goes on.
chatter-at-depth-depth-and-speed-teeth-jump = Chatter at { $depth } depth and { $speed }: teeth jump out of the cut, and the force goes to { $largest } where it would be { $mean } without vibration
chatter-at-depth-depth-and-speed-the-teeth-k = Chatter at { $depth } depth and { $speed }: the teeth keep contact, but the vibration does not die down and leaves marks, up to ±{ $marks } µm from tooth to tooth, and the force goes to { $largest } where it would be { $mean } without vibration
ra-is-with-where-it-would-be-without-without = Ra is { $with } where it would be { $without } without
the-tool-wears-from-from-to-to-of-its-life-s = The tool wears from { $from } to { $to } % of its life so far
the-tool-wears-from-from-to-to-of-its-life-i = The tool wears from { $from } to { $to } % of its life in this run
here-it-falls-by-size = here it falls by { $size }
here-it-grows-by-size = here it grows by { $size }
the-force-falls-by-size = the force falls by { $size }
the-force-grows-by-size = the force grows by { $size }
force-with-the-feed-kept-at-feed = { $force } with the feed kept at { $feed }
force-while-the-feed-goes-from-from-to-to = { $force } while the feed goes from { $from } to { $to }
at-safe-constant-feed-the-force-falls-by-siz = at safe constant feed the force falls by { $size }
at-safe-constant-feed-the-force-grows-by-siz = at safe constant feed the force grows by { $size }
at-constant-feed-the-force-falls-by-size = at constant feed the force falls by { $size }
at-constant-feed-the-force-grows-by-size = at constant feed the force grows by { $size }
unstable-feed-and-force-swing-without-dying = Unstable: feed and force swing without dying down (a limit cycle), with a period of { $period }, { $times } times the dead time of { $dead }; the force by ±{ $force }, the feed by ±{ $feed }.
unstable-feed-and-force-swing-without-dying-2 = Unstable: feed and force swing without dying down (a limit cycle), with a period of { $period }; the force by ±{ $force }, the feed by ±{ $feed }.
from-from-to-to-s = from { $from } to { $to } s
n-times-first-up-to-last = { $n } times { $first } up to { $last }
on-share-of-the-time-a-model-was-used-outsid = On { $share } of the time a model was used outside its range, where it is continued beyond what was measured.
ra-lies-outside-its-model-on-the-whole-lengt = Ra lies outside its model on the whole length: whether the target was held is not known.
ra-with-dynamics-was-within-tolerance-of-its = Ra with dynamics was within ±{ $tolerance } % of its target on { $share } of the length
ra-without-dynamics-was-within-tolerance-of = Ra without dynamics was within ±{ $tolerance } % of its target on { $share } of the length
ra-was-within-tolerance-of-its-target-on-sha = Ra was within ±{ $tolerance } % of its target on { $share } of the length
the-force-without-dynamics-was-within-tolera = The force without dynamics was within ±{ $tolerance } % of its reference on { $share } of the length
the-force-was-within-tolerance-of-its-refere = The force was within ±{ $tolerance } % of its reference on { $share } of the length
within-without-dynamics-on-share = { $within } (without dynamics on { $share })
within-and-outside-for-time-at-the-longest = { $within }, and outside for { $time } at the longest
the-target-was-held-that-takes-share = the target was held (that takes { $share } %)
the-target-was-not-held-that-takes-share = the target was not held (that takes { $share } %)
with-unknown-of-it-outside-the-model-whether-3 = with { $unknown } of it outside the model, whether the target was held is not known (that takes { $share } %)
the-reference-was-held-that-takes-share = the reference was held (that takes { $share } %)
the-reference-was-not-held-that-takes-share = the reference was not held (that takes { $share } %)
with-unknown-of-it-outside-the-model-whether-4 = with { $unknown } of it outside the model, whether the reference was held is not known (that takes { $share } %)
too-rough-on-share-alone-elsewhere-smoother = too rough on { $share } alone, elsewhere smoother than asked

## crates/core/src/run/story/words.rs

a-hard-spot-begins-here-size-times-the-force = a hard spot begins here: { $size } times the force over { $length }
a-gap-begins-here-over-length = a gap begins here: over { $length }
a-depth-step-begins-here-size-mm-deeper-over = a depth step begins here: { $size } mm deeper over { $length }
the-tool-s-wear-jumps-here-size-mm-more-vb = the tool's wear jumps here: { $size } mm more VB
a-tooth-breaks-here-the-next-one-cuts-its-fe = a tooth breaks here: the next one cuts its feed too
a-chatter-burst-begins-here-size-of-the-forc = a chatter burst begins here: { $size } % of the force over { $length }, imposed
the-sensor-drops-out-here-and-reads-0-over-l = the sensor drops out here and reads 0 over { $length }
a-sensor-drift-begins-here-size-n-in-the-end = a sensor drift begins here: { $size } N in the end over { $length }
a-longer-dead-time-begins-here-size-s-longer = a longer dead time begins here: { $size } s longer over { $length }
an-operator-s-override-begins-here-size-of-t = an operator's override begins here: { $size } % of the feed over { $length }
the-hard-spot-ends-here = the hard spot ends here
the-gap-ends-here = the gap ends here
the-depth-step-ends-here = the depth step ends here
the-wear-jump-has-grown-to-its-end-here = the wear jump has grown to its end here
the-broken-tooth-has-grown-to-its-end-here = the broken tooth has grown to its end here
the-chatter-burst-ends-here = the chatter burst ends here
the-sensor-dropout-ends-here = the sensor dropout ends here
the-sensor-drift-has-grown-to-its-end-here = the sensor drift has grown to its end here
the-longer-dead-time-ends-here = the longer dead time ends here
the-operator-s-override-ends-here = the operator's override ends here
the-cut-begins-at-the-programmed-feed-and-sp = the cut begins at the programmed { $feed } and { $speed }
the-tool-meets-the-part = the tool meets the part
the-tool-leaves-the-part = the tool leaves the part
the-part-gets-size-deeper-here = the part gets { $size } deeper here
the-part-gets-size-shallower-here = the part gets { $size } shallower here
the-radial-depth-goes-from-from-to-to = the radial depth goes from { $from } to { $to }
the-target-ra-is-moved-and-comes-back-to-to = the target Ra is moved and comes back to { $to }
the-target-ra-goes-from-from-to-to = the target Ra goes from { $from } to { $to }
the-reference-force-is-moved-and-comes-back = the reference force is moved and comes back to { $to }
the-reference-force-goes-from-from-to-to = the reference force goes from { $from } to { $to }
setting-is-moved-and-comes-back-to-to = { $setting } is moved and comes back to { $to }
setting-goes-from-from-to-to = { $setting } goes from { $from } to { $to }
first-and-next = { $first }, and { $next }
ra-without-dynamics = Ra without dynamics
the-force = the force
the-force-without-dynamics = the force without dynamics
stays-within-the-tolerance-held = stays within the tolerance { $held }
leaves-the-tolerance-held = leaves the tolerance { $held }
comes-into-the-tolerance-held = comes into the tolerance { $held }
stays-outside-the-tolerance-held = stays outside the tolerance { $held }
is-within-the-tolerance-held = is within the tolerance { $held }
is-outside-the-tolerance-held = is outside the tolerance { $held }
leaves-a-surface-that-the-model-cannot-judge = leaves a surface that the model cannot judge { $held }
is-smoother-than-asked-held = is smoother than asked { $held }
stays-below-the-tolerance-held = stays below the tolerance { $held }
is-back-in-the-tolerance-held-after-time-out = is back in the tolerance { $held } after { $time } outside, furthest { $value }
comes-into-the-tolerance-held-after-time-out = comes into the tolerance { $held } after { $time } outside, furthest { $value }
met-furthest-value = { $met }, furthest { $value }
stays-within-the-tolerance-in-the-mean-held = stays within the tolerance in the mean { $held }
comes-into-the-tolerance-in-the-mean-held = comes into the tolerance in the mean { $held }
is-within-the-tolerance-in-the-mean-held = is within the tolerance in the mean { $held }
from-to-to = { $from } to { $to }
name-value = ({ $name } { $value })
ra-with-dynamics-with-without-without = (Ra with dynamics { $with }, without { $without })
name-from-to-to = ({ $name } { $from } to { $to })
keeps-the-feed-at-feed = keeps the feed at { $feed }
lowers-the-feed-by-size-from-to-to = lowers the feed by { $size } ({ $from } to { $to })
raises-the-feed-by-size-from-to-to = raises the feed by { $size } ({ $from } to { $to })
moves-lowers-the-speed-by-size = { $moves }, lowers the speed by { $size }
moves-raises-the-speed-by-size = { $moves }, raises the speed by { $size }
nothing-settles-within-band = nothing settles within ±{ $band }
no-error-remains-without-dynamics = No error remains without dynamics
no-error-remains = No error remains
error-but-name-still-moves-by-swing = { $error }, but { $name } still moves by ±{ $swing }
error-about-which-name-still-moves-by-swing = { $error }, about which { $name } still moves by ±{ $swing }
the-law-has-no-integral = the law has no integral
it-is-still-on-its-way = It is still on its way.
it-does-not-come-to-rest-in-this-stretch = It does not come to rest in this stretch.
the-remaining-error-is-size-below-the-target = The remaining error is { $size } below the target Ra
the-remaining-error-is-size-above-the-target = The remaining error is { $size } above the target Ra
without-dynamics-size-below-the-target-ra-re = Without dynamics { $size } below the target Ra remain
without-dynamics-size-above-the-target-ra-re = Without dynamics { $size } above the target Ra remain
the-remaining-error-is-size-below-the-refere = The remaining error is { $size } below the reference force
the-remaining-error-is-size-above-the-refere = The remaining error is { $size } above the reference force
without-dynamics-size-below-the-reference-fo = Without dynamics { $size } below the reference force remain
without-dynamics-size-above-the-reference-fo = Without dynamics { $size } above the reference force remain
begin-so-far-furthest = { $begin }: so far { $furthest }.
twin-feed-met = { $twin }, { $feed }, { $met }
twin-met = { $twin } { $met }
begin-so-far-does = { $begin }: so far { $does }.
begin-does = { $begin }: { $does }.
value-ra-at-the-furthest-time-outside-the-to = { $value } Ra at the furthest, { $time } outside the tolerance
value-at-the-furthest-time-outside-the-toler = { $value } at the furthest, { $time } outside the tolerance
it-acts-only-while-feed-or-speed-moves-where = It acts only while feed or speed moves: where nothing changes within its length, nothing shows.
it-acts-only-while-feed-or-speed-moves-it-sh = It acts only while feed or speed moves: it shows most at the next change of depth, at { $time }.
it-acts-only-while-feed-or-speed-moves-no-ch = It acts only while feed or speed moves: no change of depth lies ahead.
the-controller-is-unstable-here-feed-and-for = the controller is unstable here, feed and force swing without dying down
the-cut-at-the-programmed-feed-met = the cut at the programmed feed { $met }
the-controller-moves-and-met = the controller { $moves } and { $met }
the-controller-met = the controller { $met }
the-tool-is-in-the-air-for-length-no-force-a = The tool is in the air for { $length }: no force and no surface; the feed goes to { $feed }.
