# Texts of the program, written by its tests: see ARCHITECTURE.md.

## assets/missions/depth-step-at-constant-feed.toml

what-ra-is-and-why-one-programmed-feed-canno = What Ra is, and why one programmed feed cannot hold it on a part of two depths.
the-part-is-not-cut-to-its-end-cut-it-whole = The part is not cut to its end: cut it whole.
ra-is-out-of-its-tolerance-on-part-of-the-fa = Ra is out of its tolerance on part of the face: rougher where the part is deeper and the force too large, or smoother than asked where the feed is low throughout. What can lower the feed in the deeper stretch alone?
ra-k5-f-f-k4-f-n-a-d-a-d0 = Ra = K5(F),  F = K4(f, n) A_D / A_D0
sdnrp-2007-models-k4-and-k5 = SDNRP 2007, models K4 and K5
roughness-follows-the-cutting-force-and-the = Roughness follows the cutting force, and the force follows depth and feed. Where the depth grows the feed must fall, if Ra is to stay. One feed for the whole part is either too fast for the deep stretch or too slow for all the rest.
finish-the-part-with-ra-in-its-tolerance-ove = Finish the part with Ra in its tolerance over at least 95 % of the length.
ra-is-the-mean-height-of-the-surface-s-profi = Ra is the mean height of the surface's profile. It follows the cutting force here: what makes the force grow in the middle?
the-depth-cannot-be-changed-the-blank-is-as = The depth cannot be changed: the blank is as it is. What is left that makes the force smaller?
a-lower-feed-for-the-whole-part-would-do-and = A lower feed for the whole part would do, and costs time everywhere. A controller lowers it only where it must: choose Tracking.
what-does-the-surface-do-in-the-deeper-stret = What does the surface do in the deeper stretch?
it-gets-smoother = It gets smoother
a-deeper-cut-takes-more-force-and-a-larger-f = A deeper cut takes more force, and a larger force leaves a rougher surface.
it-stays-the-same-the-feed-is-the-same = It stays the same: the feed is the same
the-feed-is-the-same-the-chip-is-not-the-edg = The feed is the same, the chip is not: the edge is in the material over a greater depth, and the force grows.
it-gets-rougher = It gets rougher
the-depth-rises-from-2-0-mm-to-2-3-mm-at-45 = The depth rises from 2.0 mm to 2.3 mm at 45 mm and falls back at 85 mm. The feed stays as it is programmed.
predict = Predict
what-does-ra-come-to-in-the-deeper-stretch-a = What does Ra come to in the deeper stretch, at constant feed?
it-stays-inside-its-tolerance = It stays inside its tolerance
it-grows-by-about-a-third = It grows by about a third
it-more-than-doubles = It more than doubles
cut-from-the-start-at-constant-feed-and-read = Cut from the start at constant feed, and read Ra before the step and between 60 and 84 mm.
watch-the-cut-as-it-comes-and-nothing-change = Watch the cut as it comes, and nothing changed: Ra and the force before the deeper stretch and in it.
see-it = See it
change-what-is-open-to-you-and-cut-again = Change what is open to you and cut again.
mend-it = Mend it
the-drawing-asks-for-ra-0-81-m-on-the-whole = The drawing asks for Ra 0.81 µm on the whole face. The program has one feed. In the middle the blank is 0.3 mm thicker, so the cutter goes deeper there.
why-a-deeper-stretch-breaks-constant-feed = Why a deeper stretch breaks constant feed

## assets/missions/gain-leaves-an-error.toml

proportional-control-of-the-force-and-the-er = Proportional control of the force, and the error that it leaves.
in-the-deeper-stretch-the-mean-force-is-stil = In the deeper stretch the mean force is still more than 7 % above the desired one. Where the loop is calm a larger gain brings it nearer; where it swings, a smaller one.
the-force-does-not-come-to-rest-in-the-deepe = The force does not come to rest in the deeper stretch: it swings, and its mean says nothing. The gain is more than the dead time allows.
the-loop-overshoots-the-gain-is-more-than-th = The loop overshoots: the gain is more than the dead time allows.
f-set-f-d-kp-f-d-f-m-f-k2-f-set-n-k3-f-set = F_set = F_d + Kp (F_d - F_m),  f = K2(F_set),  n = K3(F_set)
sdnrp-2007-the-controller-s-structure-remain = SDNRP 2007, the controller's structure; remaining error of proportional control: textbook
proportional-control-needs-an-error-to-act-o = Proportional control needs an error to act on, so one remains: the larger the gain, the smaller it is. The dead time sets how large the gain can be. A remaining error is no fault of tuning; it is what this kind of controller does.
bring-the-force-in-the-deeper-stretch-to-wit = Bring the force in the deeper stretch to within 7 % of the desired one by the gain alone, without swinging.
compare-the-measured-force-with-the-desired = Compare the measured force with the desired one in the deeper stretch, for two gains.
the-correction-is-kp-times-the-error-without = The correction is Kp times the error: without an error there is none. A larger Kp needs a smaller error for the same correction.
raise-kp-in-steps-and-watch-the-first-instan = Raise Kp in steps and watch the first instants of the cut: overshoot tells when it is too much.
where-does-the-force-come-to-rest-in-the-dee = Where does the force come to rest in the deeper stretch?
exactly-on-the-desired-force = Exactly on the desired force
the-correction-is-proportional-to-the-error = The correction is proportional to the error. On the desired force the error is zero, and so is the correction: who then lowers the feed?
above-it-nearer-than-at-constant-feed = Above it, nearer than at constant feed
nowhere-it-keeps-swinging = Nowhere: it keeps swinging
kp-is-small-and-so-is-what-a-measured-error = Kp is small, and so is what a measured error moves: the loop is calm here. Look at the force after the step.
kp-is-0-5-the-part-gets-15-deeper-at-45-mm = Kp is 0.5. The part gets 15 % deeper at 45 mm.
by-how-many-percent-of-the-desired-force-f-d = By how many percent of the desired force F_d is the force F above it in the deeper stretch, with Kp as it is given (0.5)?
solve-f-1-15-f-d-kp-f-d-f-for-f-f-d = Solve F = 1.15 (F_d + Kp (F_d - F)) for F / F_d.
the-models-are-of-the-shallow-part-15-more-d = The models are of the shallow part: 15 % more depth takes 15 % more force than what is asked of them. What is asked is the desired force, corrected by Kp times the error: at rest F = 1.15 (F_d + Kp (F_d - F)).
predict-how-far = Predict how far
find-the-gain-that-meets-the-goal = Find the gain that meets the goal.
tune = Tune
the-part-is-the-one-with-the-deeper-stretch = The part is the one with the deeper stretch. This time SDNRP moves feed and speed: it asks its models for a force that is corrected by Kp times what the force is off by.
a-gain-comes-near-and-stays-off = A gain comes near, and stays off

## assets/missions/integral-action-holds.toml

integral-action-brings-the-force-onto-the-de-2 = Integral action brings the force onto the desired one at another depth too, as long as it finds room to act.
the-force-does-not-come-to-rest-in-the-deepe-2 = The force does not come to rest in the deeper stretch: the loop is unstable. The sum acts on errors of before: less of Ki, or of Kp, lets it settle.
the-mean-force-in-the-deeper-stretch-is-not = The mean force in the deeper stretch is not the desired one. A gain alone leaves an error; a sum takes it away, if it has the time, does not swing, and the override is at no limit.
ra-is-outside-its-tolerance-over-too-much-of = Ra is outside its tolerance over too much of the length: after each step the force comes to the desired one too slowly, or it swings.
u-1-kp-e-ki-sum-e-e-1-f-m-f-ref = u = 1 + Kp e + Ki sum e,  e = 1 - F_m / F_ref
textbook-form-of-pi-control-the-override-loo = Textbook form of PI control; the override loop of the combined system, 2005
the-sum-of-the-errors-stops-changing-only-wh-2 = The sum of the errors stops changing only where the error is zero. That is why integral action holds the force at another depth, or in another material, as long as three things hold: the override is at no limit, the loop is stable, and a smaller feed still means a smaller force. At a limit the sum stands still, and the error stays. Its price: it reacts to what was, so too large a gain swings.
let-the-force-in-the-deeper-stretch-rest-wit = Let the force in the deeper stretch rest within 0.5 % of the desired one, with Ra in tolerance over 95 % of the length.
what-would-an-override-do-that-keeps-falling = What would an override do that keeps falling as long as there is any error?
set-the-integral-gain-ki-above-zero-small-it = Set the integral gain Ki above zero. Small: it takes seconds. Large: it overshoots. What is changed during the cut acts only from there on: set it, then cut from the start.
set-ki-to-0-2-press-cut-from-the-start-and-c = Set Ki to 0.2, press “Cut from the start”, and check the cut.
with-an-integral-gain-above-zero-where-does = With an integral gain above zero, where does the force come to rest?
on-the-desired-force-at-2-3-mm-as-at-2-0-mm = On the desired force, at 2.3 mm as at 2.0 mm
on-the-desired-force-at-2-0-mm-only = On the desired force at 2.0 mm only
the-sum-goes-on-changing-as-long-as-there-is = The sum goes on changing as long as there is any error, at 2.3 mm too: it can only rest where the error is zero.
nearer-but-off-as-with-the-gain-alone = Nearer, but off, as with the gain alone
a-gain-needs-an-error-to-hold-its-correction = A gain needs an error to hold its correction. A sum holds what it has added up, with no error left.
find-an-integral-gain-ki-that-meets-the-goal = Find an integral gain Ki that meets the goal. The part is judged over its whole length, so a gain that is set during the cut comes too late: set it, then press “Cut from the start”.
the-same-part-again-now-the-controller-is-p = The same part again. Now the controller is P: it moves the feed override by its gain times the relative error, and leaves the rest of it, as you have seen. It can also add the error up from sample to sample.
adding-up-the-error-takes-it-away = Adding up the error takes it away

## assets/missions/dead-time-against-gain.toml

a-gain-that-is-good-at-a-short-dead-time-swi = A gain that is good at a short dead time swings at a long one.
ra-leaves-its-tolerance-on-more-than-a-tenth = Ra leaves its tolerance on more than a tenth of the length: it swings, or creeps. Which of the two do you see?
k-l-pi-2-k-rate-of-the-integrator-with-all-t = K L < pi / 2,  K: rate of the integrator with all that follows it, 1/s,  L: dead time, s
textbook-stability-limit-of-an-integrator-be = Textbook: stability limit of an integrator behind a dead time
within-the-dead-time-the-loop-is-blind-what = Within the dead time the loop is blind: what it adds in that time it adds without seeing what came of it. So gain times dead time is what is limited. Twice the dead time allows about half the gain.
find-the-largest-integral-gain-that-still-ho = Find the largest integral gain that still holds Ra over 90 % of the length, at a dead time of 160 ms.
for-160-ms-the-controller-goes-on-asking-for = For 160 ms the controller goes on asking for more, since it sees nothing of what it has asked for. How far can it go too far in that time?
halve-the-gain-and-look-at-the-overshoot = Halve the gain and look at the overshoot.
the-edge-for-a-good-cut-lies-between-0-2-and = The edge for a good cut lies between 0.2 and 0.35.
what-will-the-cut-do = What will the cut do?
the-same-80-ms-later = The same, 80 ms later
the-command-is-late-in-every-round-of-the-lo = The command is late in every round of the loop, not once: the controller corrects an error that it has already corrected.
it-swings-and-ra-with-it = It swings, and Ra with it
it-gets-slower-and-stays-calm = It gets slower, and stays calm
a-slower-answer-would-need-a-smaller-gain-th = A slower answer would need a smaller gain. The gain is the same: only what it sees is old.
the-integral-gain-is-0-8-as-on-the-machine-w = The integral gain is 0.8, as on the machine with 80 ms, where it worked.
lower-the-gain-until-the-cut-is-good-and-no = Lower the gain until the cut is good, and no further than you must.
find-the-edge = Find the edge
on-this-machine-the-plc-passes-the-override = On this machine the PLC passes the override on twice as slowly: 160 ms after it was asked for. The gains were tuned on the other machine, and now the table shakes.
dead-time-against-gain-find-the-edge = Dead time against gain: find the edge

## assets/missions/smith-predictor.toml

why-a-predictor-helps-against-dead-time-and = Why a predictor helps against dead time, and what a wrong dead time in it does.
it-still-swings-the-predictor-has-to-know-ho = It still swings. The predictor has to know how long the command really takes.
y-y-u-0-u-a-u-a-with-and-u-0-without-the-ass = y* = y u_0 / u_a,  u_a with and u_0 without the assumed dead time
o-j-m-smith-1957-here-in-multiplicative-form = O. J. M. Smith 1957; here in multiplicative form, since the force goes with the feed
the-predictor-takes-the-measured-force-for-w = The predictor takes the measured force for what it would be without the dead time, by a model of the override's way. With the right dead time the loop can be tuned as if there were none. With one that is far too long it corrects what is no error, and swings; one that is somewhat too short does less harm. A model is good for as much as it is true.
keep-the-integral-gain-at-0-8-and-hold-ra-ov = Keep the integral gain at 0.8 and hold Ra over 88 % of the length.
switch-the-smith-predictor-on-and-look-at-th = Switch the Smith predictor on and look at the force: is it calm?
the-predictor-assumes-a-dead-time-which-one = The predictor assumes a dead time. Which one does it assume here, and which one does the machine have?
set-the-assumed-dead-time-to-0-16-s = Set the assumed dead time to 0.16 s.
you-switch-the-predictor-on-and-change-nothi = You switch the predictor on and change nothing else. What happens?
the-cut-is-as-calm-as-without-dead-time = The cut is as calm as without dead time
it-would-be-if-its-model-were-true-it-expect = It would be if its model were true. It expects an answer after 300 ms that comes after 160 ms, and takes what comes early for a disturbance.
it-still-swings-the-model-is-wrong = It still swings: the model is wrong
the-part-is-cut-with-a-constant-feed = The part is cut with a constant feed
the-predictor-changes-what-the-controller-se = The predictor changes what the controller sees, not whether it acts.
the-predictor-assumes-a-dead-time-of-300-ms = The predictor assumes a dead time of 300 ms; the machine has 160 ms.
make-the-controller-s-belief-fit-the-machine = Make the controller's belief fit the machine.
make-it-true = Make it true
the-machine-with-160-ms-again-the-gain-must = The machine with 160 ms again. The gain must stay high, since the boss wants short times. The controller can be given a model of the command's way: it then knows what it has asked for and not yet seen.
a-model-that-waits-the-smith-predictor = A model that waits: the Smith predictor

## assets/missions/noise-against-tolerance.toml

scatter-of-the-force-becomes-scatter-of-ra-a = Scatter of the force becomes scatter of Ra; a tolerance must leave room for it.
less-than-80-of-the-length-is-in-the-toleran = Less than 80 % of the length is in the tolerance that you ask for. Is it the controller's answer to the noise, or the noise itself?
so-wide-a-tolerance-will-not-be-granted-at-m = So wide a tolerance will not be granted: at most 25 %. Calm the controller first.
ra-k5-f-an-error-of-1-in-the-force-is-one-of = Ra = K5(F): an error of 1 % in the force is one of several percent in Ra
sdnrp-2007-table-3-force-and-ra-of-the-same = SDNRP 2007, Table 3 (force and Ra of the same rows); Bode's integral for the limits of feedback
feedback-corrects-what-lasts-longer-than-its = Feedback corrects what lasts longer than its dead time. What changes faster, it cannot correct, and a fast controller adds to it. The rest is a matter of the process: a tolerance has to leave room for its scatter.
tune-the-controller-for-this-noise-and-find = Tune the controller for this noise, and find the tolerance to ask the designer for: the smallest one that is held over 80 % of the length.
how-much-do-the-force-and-ra-scatter-while-n = How much do the force and Ra scatter while nothing else changes?
a-controller-that-answers-each-wiggle-adds-t = A controller that answers each wiggle adds to them: it is late by the dead time. Let it answer more slowly.
try-a-response-time-of-1-to-3-s-then-widen-t = Try a response time of 1 to 3 s, then widen the tolerance step by step.
you-make-the-controller-answer-faster-what-d = You make the controller answer faster. What does the share of the face in tolerance do?
it-grows-errors-are-corrected-sooner = It grows: errors are corrected sooner
errors-that-last-are-noise-has-changed-its-s = Errors that last are. Noise has changed its sign before the correction arrives, 80 ms and a drive's lag later.
it-falls-or-stays-it-answers-noise-with-nois = It falls or stays: it answers noise with noise
first-the-response-time-then-the-tolerance = First the response time, then the tolerance.
tune-then-ask = Tune, then ask
steel-is-not-the-same-from-place-to-place-ed = Steel is not the same from place to place, edges pass, the sensor hisses. The drawing allows 10 % around Ra 0.81 µm. The foreman asks why a fifth of the face is out of tolerance at best, with a controller that was praised.
what-no-controller-can-hold-noise-against-to = What no controller can hold: noise against tolerance

## assets/missions/another-material.toml

a-model-based-controller-on-a-material-that = A model-based controller on a material that its models were not made for.
ra-is-not-held-the-controller-s-models-are-t = Ra is not held. The controller's models are those of another steel: which controller finds that out by itself?
gain-estimate-f-m-f-modelled = gain estimate = F_m / F_modelled
tracking-controller-observer-of-the-gain-mat = Tracking controller (observer of the gain); materials: specific cutting forces as listed in the program
a-model-is-a-belief-what-corrects-it-is-meas = A model is a belief. What corrects it is measurement: the ratio of measured to modelled force tells how wrong it is, and a controller that follows this ratio, or adds up the error, needs no constants of the new steel.
hold-ra-over-at-least-90-of-the-length-witho = Hold Ra over at least 90 % of the length, without knowing the new steel's constants.
the-controller-s-models-believe-in-ck45-what = The controller's models believe in Ck45. What tells it that they are wrong?
sdnrp-corrects-its-models-answer-by-a-gain-y = SDNRP corrects its models' answer by a gain. You know what a gain leaves.
tracking-estimates-how-much-larger-the-force = Tracking estimates how much larger the force is than modelled, and Adjustable PI and P with an integral gain add up the error.
what-roughness-will-the-part-have-at-the-end = What roughness will the part have at the end, in µm, where 0.81 is asked for?
the-force-of-this-steel-is-larger-by-a-fifth = The force of this steel is larger by a fifth and more. A few percent of force are tens of percent of Ra: cut once and look.
sdnrp-with-kp-0-5-its-models-belong-to-ck45 = SDNRP with Kp = 0.5; its models belong to Ck45.
choose-what-does-not-need-to-know-the-steel = Choose what does not need to know the steel.
hold-it = Hold it
the-store-has-run-out-of-ck45-and-brings-16m = The store has run out of Ck45 and brings 16MnCrSi5. The program, the models and the gain stay as they are: the models say that all is well.
another-steel-under-a-model-that-does-not-kn = Another steel under a model that does not know it

## assets/missions/wear-heard-and-seen.toml

what-force-sound-and-roughness-do-from-a-sha = What force, sound and roughness do from a sharp edge to a worn one.
the-part-is-not-finished-its-tool-was-worn-o = The part is not finished: its tool was worn out, or its time was over. Choose a shorter one.
at-its-end-the-surface-is-more-than-three-ti = At its end the surface is more than three times as rough as at its beginning. The tool has to be changed sooner.
f-f-sharp-1-growth-wear-used-life = F = F_sharp (1 + growth * wear(used life))
machine-model-2019-wear-sound-and-tool-life = Machine model 2019: wear, sound and tool life
wear-goes-in-three-parts-break-in-steady-gro = Wear goes in three parts: break-in, steady growth, failure. Force, sound and roughness rise together, which is why the sound can tell the time of a tool change before the surface shows it.
say-what-becomes-of-sound-and-roughness-and = Say what becomes of sound and roughness, and cut a part that ends while its Ra is no more than three times the first.
look-at-force-sound-and-ra-over-the-whole-li = Look at force, sound and Ra over the whole life. Which parts of it can you tell apart?
break-in-is-short-then-it-grows-steadily-the = Break-in is short, then it grows steadily, then fast.
a-shorter-part-ends-before-the-end-of-the-li = A shorter part ends before the end of the life: what is the length open to you for?
from-the-sharp-tool-to-the-worn-one-what-doe = From the sharp tool to the worn one, what does the sound of the cut do?
it-gets-louder = It gets louder
it-stays-the-same = It stays the same
the-force-grows-with-the-wear-and-a-larger-f = The force grows with the wear, and a larger force shakes the machine more. Compare the sound after 5 s with the sound at the end.
it-gets-quieter = It gets quieter
a-worn-edge-does-not-cut-it-presses-that-tak = A worn edge does not cut, it presses: that takes more force. Compare the sound after 5 s with the sound at the end.
choose-a-length-that-is-cut-before-the-surfa = Choose a length that is cut before the surface is spoilt.
stop-in-time = Stop in time
a-tool-cuts-from-its-first-to-its-last-minut = A tool cuts from its first to its last minute, shown in 52 seconds: one second stands for six minutes. The apprentice says that one cannot hear anything.
a-tool-s-life-heard-and-seen = A tool's life, heard and seen

## assets/missions/choose-for-the-2005-part.toml

five-cuts-of-changing-depth-and-width-which = Five cuts of changing depth and width: which controller, tuned how?
it-takes-too-long-on-light-sections-the-feed = It takes too long. On light sections the feed has to rise.
the-largest-force-is-above-1050-n-feedback-s = The largest force is above 1050 N. Feedback sees a heavier section only when the tool is in it: what knows it before?
u-f-ref-f-modelled-1-exponent-corrected-by-t = u = (F_ref / F_modelled)^(1 / exponent), corrected by the measured force
combined-system-2005-experiment-2-and-its-ta = Combined system 2005, Experiment 2 and its Table 1; Preview: this program's own controller
feedback-answers-what-has-happened-on-a-part = Feedback answers what has happened. On a part whose sections are known, feedforward lowers the feed before the section comes, and feedback corrects what the model got wrong. Both together beat either.
cut-the-part-in-less-than-92-s-with-no-force = Cut the part in less than 92 s, with no force above 1050 N.
where-does-the-largest-force-come-from-from = Where does the largest force come from: from where the cutter enters a deeper or wider section, before any measurement can tell.
what-could-a-controller-know-before-the-sect = What could a controller know before the section comes?
preview-reads-the-part-s-program = Preview reads the part's program.
the-feed-is-lowered-by-feedback-from-the-mea = The feed is lowered by feedback from the measured force. Where is the largest force?
in-the-middle-of-the-deepest-section = In the middle of the deepest section
there-the-controller-has-had-time-to-lower-t = There the controller has had time to lower the feed. Look at the first instants of a section.
where-a-heavier-section-begins = Where a heavier section begins
at-the-end-of-each-cut = At the end of each cut
the-engagement-does-not-grow-there-look-at-w = The engagement does not grow there. Look at where a heavier section begins.
choose-and-tune = Choose and tune
five-straight-cuts-of-different-depth-and-wi = Five straight cuts of different depth and width, tooth by tooth, the force to be held at 665 N. At constant feed the largest force is more than twice that. The customer pays by the minute; the tool breaks by the newton.
choose-and-tune-for-the-part-of-2005 = Choose and tune for the part of 2005

## assets/missions/beat-it-by-hand.toml

you-are-the-controller-the-operator-s-knob-i = You are the controller: the operator's knob is yours.
the-knob-was-not-turned-during-the-cut-one-f = The knob was not turned during the cut. One feed for all of the part is not what is asked for here.
the-override-went-beyond-120-where-a-machine = The override went beyond 120 %, where a machine's panel ends.
ra-is-out-of-tolerance-on-more-than-15-of-th = Ra is out of tolerance on more than 15 % of the length. Watch where the depth changes, and be there a moment before.
sdnrp-holds-more-of-the-length-than-you-did = SDNRP holds more of the length than you did.
f-u-f-n-2-3-mm-f-f-n-2-0-mm-solved-for-the-o = F(u f, n, 2.3 mm) = F(f, n, 2.0 mm), solved for the override u
sdnrp-2007-override-control-2005-combined-sy = SDNRP 2007 (override control); 2005 combined system (feedback against feedforward)
a-person-who-knows-the-part-does-what-feedfo = A person who knows the part does what feedforward does: acts before the step. What is tiring is to do it all day, on every part. A controller with feedback does not know the part, and does not get tired; one with preview does both.
turn-the-knob-during-the-cut-so-that-ra-is-i = Turn the knob during the cut so that Ra is in tolerance over 85 % of the length, better than SDNRP does.
at-45-mm-the-part-gets-deeper-at-85-mm-it-ge = At 45 mm the part gets deeper, at 85 mm it gets shallower. Where should the override be in between?
the-command-arrives-80-ms-later-and-the-driv = The command arrives 80 ms later, and the drive needs its time: begin a little before.
about-60-in-the-deeper-stretch-holds-ra-befo = About 60 % in the deeper stretch holds Ra; before and after it 100 %. The knob clicks every 2 %.
which-override-holds-ra-in-the-deeper-stretc = Which override holds Ra in the deeper stretch, in percent of 300 mm/min?
read-the-feed-in-the-deeper-stretch-when-a-c = Read the feed in the deeper stretch when a controller does it, or try: 15 % more depth needs far less feed, since the force goes slowly with the feed.
cut-and-turn-the-knob-while-it-cuts-pausing = Cut, and turn the knob while it cuts. Pausing and going back are allowed: what is turned there replaces what came after.
forty-years-ago-this-was-done-by-ear-with-a = Forty years ago this was done by ear, with a hand on the override. The part has a deeper stretch, and the knob of the feed override is yours: drag around it, or turn it by the mouse wheel, the keys + and -, or a finger. The screen Console shows what an operator sees, and scores you afterwards against every controller.
beat-the-controller-by-hand = Beat the controller by hand

## assets/missions/teach-in-feed-control.toml

a-control-that-learns-the-force-of-a-good-cu = A control that learns the force of a good cut, and gives way when the tool no longer cuts like that.
the-reference-of-the-first-cut-is-not-the-pe = The reference of the first cut is not the peak force of a good one. Teach in with the cut as it is set up: the edge chips only during the cut.
the-feed-was-never-lowered-with-fmin-at-100 = The feed was never lowered: with FMIN at 100 % the control watches and does nothing.
with-the-chipped-edge-there-is-hardly-less-f = With the chipped edge there is hardly less force than without control. Is FMIN low enough, and are the references those of a good cut?
u-limit-f-1-f-m-fmin-fmax-f-m-1-3-f-1-u-0-6 = u = limit(F_1 / F_m, FMIN, FMAX),  F_m = 1.3 F_1 u^0.6
adaptive-feed-control-afc-as-machine-control = Adaptive feed control (AFC) as machine controls have it; rates and thresholds chosen
teach-in-needs-no-model-the-good-part-is-the = Teach-in needs no model: the good part is the model. That is why it works on any machine, and why the first part must be good. The control lowers the force, it does not hold it: the lower feed lowers what it reads, so it comes to rest half way. And it cannot tell a chipped edge from a harder part: for both it gives way, and the log shows it.
teach-in-the-good-part-then-let-the-control = Teach in the good part, then let the control lower the feed when the edge chips: at least 7 % less force in the deepest stretch than without it, the part whole.
the-reference-is-the-force-of-a-good-cut-wha = The reference is the force of a good cut. What would it be, if it were taught in with the chipped edge?
on-the-screen-console-the-button-afc-opens-t = On the screen Console the button AFC... opens the window of the control. “Teach in” cuts the part once as it is set up, with the sharp tool, and enters what it has found.
fmin-says-how-far-the-feed-may-go-down-with = FMIN says how far the feed may go down: with 50 % there is room. FMIN and FMAX at 100 % only watch.
the-references-are-taught-in-fmin-and-fmax-a = The references are taught in, FMIN and FMAX are both 100 %. What does the control do when the edge chips?
it-lowers-the-feed-until-the-force-is-that-o = It lowers the feed until the force is that of the reference
it-may-go-no-lower-than-fmin-and-that-is-100 = It may go no lower than FMIN, and that is 100 % here.
it-watches-the-feed-stays-and-an-overload-is = It watches: the feed stays, and an overload is told
it-stops-the-machine-at-once = It stops the machine at once
an-overload-has-to-last-for-more-than-a-seco = An overload has to last for more than a second, and what happens then is chosen: message, stop, retract and stop.
where-does-the-feed-come-to-rest-in-the-deep = Where does the feed come to rest in the deepest stretch of the third cut, whose force is its reference, in percent of the programmed one?
t-1-1-3-would-be-77-but-at-a-lower-feed-the-fo = 1 / 1.3 would be 77 %. But at a lower feed the force is lower, too, and with it what the control reads: u = 1 / (1.3 u^0.6).
the-control-sets-the-feed-to-reference-over = The control sets the feed to reference over measured force. With the same feed the chipped edge needs 30 % more force; and the force falls with about the 0.6th power of the feed.
teach-in-with-the-window-afc-of-the-screen-c = Teach in with the window AFC of the screen Console, set FMIN and FMAX there or here, and cut the part.
teach-in-set-fmin-and-cut = Teach in, set FMIN and cut
the-machine-s-control-has-adaptive-feed-cont-2 = 
    The machine's control has adaptive feed control, AFC: the first part is cut at the programmed feed, and the peak force of every cut is kept as its reference. From then on the feed follows the force. Yesterday a cutting edge chipped in the second cut, and nobody noticed until the tool broke. Today the same will happen after 12 s.
    
    Two things more that such a control does. It tells an overload when the force stays over its limit for more than 1 s with the feed at FMIN: it cannot give way any further. And it switches itself off for the rest of the cut when the operator turns the override down by more than 10 %: then the hand has the feed.
set-up-feed-control-by-teach-in = Set up feed control by teach-in

## assets/missions/quiet-speed.toml

at-one-speed-a-depth-chatters-at-another-the = At one speed a depth chatters, at another the same depth is quiet.
it-still-chatters-in-the-deeper-stretch-the = It still chatters in the deeper stretch. The chart tells at which speeds 2 mm lie below the limit.
b-lim-1-2-k-s-mu-re-g-omega-min = b_lim = -1 / (2 K_s mu Re[G(omega)]_min)
tobias-and-fishwick-1958-tlusty-and-polacek = Tobias and Fishwick 1958, Tlusty and Polacek 1963; machine of 2019
a-tooth-cuts-into-the-wave-that-the-tooth-be = A tooth cuts into the wave that the tooth before it left. If it meets it in phase, the chip is even and the cut is quiet; if not, the chip's thickness swings and feeds the vibration. The phase goes with the speed, so quiet speeds lie between lobes.
find-a-spindle-speed-at-which-the-deeper-str = Find a spindle speed at which the deeper stretch is cut without chatter, with the feed as programmed.
the-stability-chart-on-screen-machine-shows = The stability chart on screen Machine shows which depth is quiet at which speed.
chatter-depends-on-where-in-its-vibration-th = Chatter depends on where in its vibration the tooth meets the wave that the last tooth has left: that is a matter of speed, in lobes.
look-for-a-place-where-the-limit-is-above-2 = Look for a place where the limit is above 2 mm: near 1571 1/min there is one.
what-helps = What helps?
only-a-lower-speed = Only a lower speed
lower-is-not-quieter-as-such-below-each-quie = Lower is not quieter as such: below each quiet speed there is another lobe that chatters.
only-a-higher-speed = Only a higher speed
higher-is-not-quieter-as-such-at-1900-1-min = Higher is not quieter as such: at 1900 1/min it chatters as it does at 1800. Look at the chart.
a-certain-speed-there-are-quiet-ones-between = A certain speed: there are quiet ones between the lobes
at-1800-1-min-the-stretch-of-2-mm-chatters = At 1800 1/min the stretch of 2 mm chatters.
choose-a-speed-by-the-chart-and-cut = Choose a speed by the chart and cut.
find-it = Find it
the-deeper-stretch-sings-and-its-marks-can-b = The deeper stretch sings, and its marks can be felt. The depth is on the drawing, so it stays. "Go slower", says one. "Go faster", says the other.
a-quiet-speed-between-two-lobes = A quiet speed between two lobes

## assets/missions/plan-and-what-binds.toml

the-fastest-cut-within-seven-limits-which-of = The fastest cut within seven limits: which of them hold it back?
the-programmed-feed-is-not-that-of-the-optim = The programmed feed is not that of the optimum.
the-programmed-speed-is-not-that-of-the-opti = The programmed speed is not that of the optimum.
least-time-within-g-i-f-n-0-i-1-to-7 = least time within g_i(f, n) <= 0, i = 1 to 7
control-strategy-2013-particle-swarm-the-lim = Control strategy 2013 (particle swarm); the limits themselves are chosen, the paper does not give its list
an-optimum-within-limits-lies-on-some-of-the = An optimum within limits lies on some of them. Those that bind say what is worth paying for: here the force, which stands for the roughness, and the life of the edge. Ten times the power would not save a second.
plan-the-cut-program-what-the-plan-found-and = Plan the cut, program what the plan found, and say which limits bind.
screen-plan-shows-the-limits-as-lines-over-f = Screen Plan shows the limits as lines over feed and speed, and in a table with what is left of each.
a-limit-binds-where-nothing-is-left-of-it-th = A limit binds where nothing is left of it: the optimum lies on its line.
use-the-plan-s-button-to-program-the-optimum = Use the plan's button to program the optimum: about 167 mm/min at 2196 1/min.
which-limits-bind-at-the-optimum = Which limits bind at the optimum?
spindle-power-and-spindle-speed = Spindle power and spindle speed
look-at-what-is-left-of-them-in-the-table-ne = Look at what is left of them in the table: nearly all of the power, half of the speed. A stronger spindle would change nothing.
cutting-force-and-tool-life = Cutting force and tool life
cutter-deflection-and-feed = Cutter deflection and feed
look-at-what-is-left-of-them-in-the-table-mo = Look at what is left of them in the table: most of both. They do not hold the cut back.
run-the-plan-on-screen-plan = Run the plan on screen Plan.
program-the-optimum-and-cut-the-part = Program the optimum and cut the part.
program-it = Program it
before-the-first-chip-the-swarm-looks-for-th = Before the first chip the swarm looks for the feed and speed that cut the part fastest within seven limits. The works manager asks: what should we buy to be faster, a stronger spindle or a better edge?
plan-a-cut-and-say-what-binds = Plan a cut, and say what binds

## assets/missions/outside-its-range.toml

what-a-controller-promises-with-models-that = What a controller promises with models that nobody has tried there.
for-more-than-half-of-the-cut-a-model-is-out = For more than half of the cut a model is outside its range: what it says there, nobody has measured.
the-target-is-not-held-over-85-of-the-length = The target is not held over 85 % of the length.
k1-k5-valid-between-the-least-and-largest-va = K1..K5: valid between the least and largest values of Table 3
a-formula-answers-everywhere-it-is-known-onl = A formula answers everywhere; it is known only where it was measured. Outside, this program goes on with the slope at the end and says so. A lamp that says "outside" is worth more than a number with three digits.
find-the-roughest-target-that-is-held-over-8 = Find the roughest target that is held over 85 % of the length with the models inside their range for most of the cut.
the-chips-for-k1-to-k5-say-which-model-is-ou = The chips for K1 to K5 say which model is outside the range that it was made from.
table-3-of-2007-has-targets-from-0-38-to-1-5 = Table 3 of 2007 has targets from 0.38 to 1.52 µm. Beyond, the formulas only go on with their end slopes.
try-1-2-m-then-go-up-until-the-lamps-light-f = Try 1.2 µm, then go up until the lamps light for more than half of the cut.
what-roughness-does-the-part-get-at-the-end = What roughness does the part get at the end, in µm?
the-feed-that-the-model-asks-for-is-more-tha = The feed that the model asks for is more than the override allows: the command stays at its limit, and Ra with it.
the-target-is-4-m = The target is 4 µm.
lower-the-target-until-the-models-can-be-bel = Lower the target until the models can be believed.
find-the-end-of-what-is-known = Find the end of what is known
for-a-roughing-cut-somebody-sets-the-target = For a roughing cut somebody sets the target to Ra 4 µm. The controller has a formula for that, as for everything: formulas always answer.
a-model-outside-its-range = A model outside its range

## assets/missions/read-the-errata.toml

why-the-printed-equation-cannot-have-made-th = Why the printed equation cannot have made the printed table.
the-force-after-15-s-is-not-within-1-of-the = The force after 15 s is not within 1 % of the 166.5 N that Table 3 prints.
k2-f-0-for-f-177-07-n-as-printed-table-3-has = K2(F) < 0 for F < 177.07 N, as printed; Table 3 has forces from 166.5 N on
sdnrp-2007-equation-5-and-table-3-errata-of = SDNRP 2007, equation 5 and Table 3; errata of this program
printed-constants-lose-digits-signs-and-unit = Printed constants lose digits, signs and units on their way. Whoever repeats a result checks whether equation and table agree, and says which one was believed, and why.
find-the-calibration-with-which-simulation-1 = Find the calibration with which simulation 1 of Table 3 comes out as printed: 166.5 N after 15 s.
cut-simulation-1-with-the-models-as-printed = Cut simulation 1 with the models as printed, and look at the force after 15 s.
k2-as-printed-gives-the-feed-for-a-force-put = K2 as printed gives the feed for a force. Put 166 N into it: what comes out?
the-calibration-identified-takes-its-constan = The calibration `identified` takes its constants from the table itself, since the printed ones cannot be right.
why-can-k2-as-printed-not-have-made-table-3 = Why can K2 as printed not have made Table 3?
it-gives-forces-that-are-too-small = It gives forces that are too small
k2-gives-a-feed-not-a-force-read-its-erratum = K2 gives a feed, not a force. Read its erratum again.
its-feed-is-negative-for-half-of-the-forces = Its feed is negative for half of the forces in the table
its-unit-is-wrong-mm-instead-of-m = Its unit is wrong: mm instead of µm
that-is-another-erratum-of-the-reference-rou = That is another erratum, of the reference roughness. Look for K2, equation 5.
open-the-errata-on-screen-papers-and-the-car = Open the errata on screen Papers, and the card of K2.
read = Read
choose-the-calibration-that-repeats-the-row = Choose the calibration that repeats the row.
repeat-the-table = Repeat the table
you-are-asked-to-build-what-a-paper-describe = You are asked to build what a paper describes. Its equations are printed, and so are its results. You put the first into the second, and nothing fits.
read-the-errata = Read the errata
