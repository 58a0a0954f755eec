; The autonomous forward observer. Rules of your own replace those of the same name; docs/rules.md tells how.
;
; The course of a mission: contact -> target (waiting) -> called -> engaged: adjust by bracketing, fire for effect, judge -> done or
; given-up. A target that was given up waits again when it or the observer has moved.

; ----- what the rules themselves remember -----

(deftemplate target
  (slot id) (slot action)
  (slot state (default waiting))            ; waiting called engaged given-up done
  (slot mission (default 0))                ; the last one on it
  (slot x (default none)) (slot z (default none)) ; of the contact when it was given up
  (slot own-x (default none)) (slot own-z (default none))) ; and of the observer

; The bracket of a mission in adjustment. last: over or short, the side of the last round; step: how far the range was shifted then;
; width: of the bracket once two rounds enclose the target, 0 before.
(deftemplate adjustment
  (slot mission) (slot last (default none)) (slot step (default 0)) (slot width (default 0)) (slot lost (default 0)))

; A spot put into words: side over or short, off the amount, right the correction of deviation.
(deftemplate sensed (slot mission) (slot right) (slot side) (slot off))

(deftemplate volleys (slot mission) (slot fired (default 0)) (slot right (default 0)) (slot add (default 0)) (slot judged (default FALSE)))
(deftemplate most-dangerous (slot id) (slot harmlessness)) ; of the targets that wait, while a channel is free
(deftemplate fled (slot contact))
(deftemplate warned (slot contact))
(deftemplate lit (slot contact))

; ----- numbers of the trade (world.md section 2; public digests of FM 6-30) -----

; OT factor: distance to the target in thousands of metres, to whole numbers and at least 1; under 1000 m to a tenth.
(deffunction ot-factor (?distance)
  (if (>= ?distance 1000.0) then (return (max 1 (integer (+ (/ ?distance 1000.0) 0.5)))))
  (return (max 0.1 (/ (integer (+ (/ ?distance 100.0) 0.5)) 10.0))))

; Metres to the nearest ten.
(deffunction to-ten (?metres)
  (if (< ?metres 0.0) then (return (- 0.0 (* 10.0 (integer (+ (/ (abs ?metres) 10.0) 0.5))))))
  (return (* 10.0 (integer (+ (/ ?metres 10.0) 0.5)))))

; Correction of deviation for a burst seen this many mils right of the target: to ten metres, under thirty none.
(deffunction deviation (?mils ?distance)
  (bind ?metres (* ?mils (ot-factor ?distance)))
  (if (< (abs ?metres) 30.0) then (return 0.0))
  (return (- 0.0 (to-ten ?metres))))

; First shift of range: always across the target.
(deffunction bold (?off)
  (if (> ?off 400.0) then (return 800))
  (if (> ?off 200.0) then (return 400))
  (if (> ?off 100.0) then (return 200))
  (return 100))

; Towards the target: add for a short round, drop for one over.
(deffunction towards (?side ?metres)
  (if (eq ?side over) then (return (- 0 ?metres)))
  (return ?metres))

(deffunction at-most (?metres ?limit)
  (return (max (- 0 ?limit) (min ?limit ?metres))))

; Shift of range in creeping fire: never more than 100 m.
(deffunction creep (?off)
  (if (> ?off 75.0) then (return 100))
  (return 50))

(deffunction urgency (?action)
  (if (eq ?action destroy) then (return 3))
  (if (eq ?action neutralize) then (return 2))
  (return 1))

; The smaller, the more dangerous: near ones first, those that can still fight before those already hit.
(deffunction harmlessness (?range ?condition)
  (if (eq ?condition whole) then (return ?range))
  (return (+ ?range 1000000.0)))

(deffunction moved-apart (?x1 ?z1 ?x2 ?z2)
  (return (sqrt (+ (* (- ?x1 ?x2) (- ?x1 ?x2)) (* (- ?z1 ?z2) (- ?z1 ?z2))))))

; Automatic: adjust where the location is not sure or friendlies are near, unless the target will not wait for adjustment.
(deffunction chosen-method (?method ?error ?sure ?speed ?friendly-distance ?danger-close)
  (if (neq ?method automatic) then (return ?method))
  (if (< ?friendly-distance ?danger-close) then (return adjust_fire))
  (if (> ?speed 3.0) then (return fire_for_effect))
  (if (or (> ?error 50.0) (< ?sure 0.8)) then (return adjust_fire))
  (return fire_for_effect))

(deffunction grade (?condition)
  (if (eq ?condition destroyed) then (return "destroyed"))
  (if (eq ?condition damaged) then (return "neutralised"))
  (if (eq ?condition suppressed) then (return "suppressed"))
  (return "no effect seen"))

; ----- contacts and targets -----

; Contacts that are known to be friendly and that nobody ordered fire on are of no further interest (thesis V.E).
(defrule dismiss-non-hostile
  (settings (hostile-belief ?enough))
  ?contact <- (contact (id ?id) (type ?type) (hostile ?h&:(< ?h ?enough)) (friendly ?f&:(>= ?f ?enough)))
  (not (mission ? ?type))
  (not (target (id ?id)))
  =>
  (retract ?contact))

; Hostile contacts of an ordered type become targets; of several orders the strongest counts.
(defrule hostile-becomes-target
  (declare (salience 10))
  (settings (hostile-belief ?enough))
  (mission ?action ?type)
  (contact (id ?id) (type ?type) (hostile ?h&:(>= ?h ?enough)) (condition ~destroyed))
  (not (mission ?other&:(> (urgency ?other) (urgency ?action)) ?type))
  (not (target (id ?id)))
  =>
  (assert (target (id ?id) (action ?action))))

; "You can program the observer for stupidity" (thesis, appendix B.C): an order against his own side is obeyed.
(defrule order-against-own-side
  (declare (salience 10))
  (settings (hostile-belief ?enough))
  (self (type ?own))
  (mission ?action ?type)
  (contact (id ?id) (type ?type) (hostile ?h&:(< ?h ?enough)) (friendly ?f&:(or (= ?type ?own) (>= ?f ?enough))) (condition ~destroyed))
  (not (mission ?other&:(> (urgency ?other) (urgency ?action)) ?type))
  (not (target (id ?id)))
  =>
  (assert (target (id ?id) (action ?action))))

; But he says so.
(defrule warn-of-own-side
  (declare (salience 20))
  (settings (hostile-belief ?enough))
  (self (type ?own))
  (target (id ?id) (action ?action))
  (contact (id ?id) (type ?type) (name ?name) (friendly ?f))
  (test (or (= ?type ?own) (>= ?f ?enough)))
  (not (warned (contact ?id)))
  =>
  (assert (warned (contact ?id)))
  (if (= ?type ?own)
    then (warn "ordered to " ?action " " ?name ", the observer's own vehicle type")
    else (warn "ordered to " ?action " " ?name ", which he takes for friendly")))

(defrule forget-lost-target
  ?target <- (target (id ?id) (state waiting|given-up|done))
  (not (contact (id ?id)))
  =>
  (retract ?target))

(defrule destroyed-without-mission
  ?target <- (target (id ?id) (state waiting|given-up))
  (contact (id ?id) (condition destroyed))
  =>
  (modify ?target (state done)))

(defrule note-where-it-was-given-up
  ?target <- (target (id ?id) (state given-up) (x none))
  (contact (id ?id) (x ?x) (z ?z))
  (self (x ?own-x) (z ?own-z))
  =>
  (modify ?target (x ?x) (z ?z) (own-x ?own-x) (own-z ?own-z)))

; Something has changed: the target or the observer is elsewhere.
(defrule target-moved-on
  ?target <- (target (id ?id) (state given-up) (x ?x&~none) (z ?z))
  (contact (id ?id) (condition ~destroyed) (x ?now-x) (z ?now-z&:(> (moved-apart ?x ?z ?now-x ?now-z) 200.0)))
  =>
  (modify ?target (state waiting) (x none) (z none)))

(defrule observer-moved-on
  ?target <- (target (state given-up) (own-x ?x&~none) (own-z ?z))
  (self (x ?now-x) (z ?now-z&:(> (moved-apart ?x ?z ?now-x ?now-z) 200.0)) (moving FALSE))
  =>
  (modify ?target (state waiting) (x none) (z none)))

; Effect that wears off: a suppressed target fights again.
(defrule target-recovers
  ?target <- (target (id ?id) (state done) (action destroy|neutralize))
  (contact (id ?id) (condition whole))
  (self (method automatic|adjust_fire|fire_for_effect))
  =>
  (modify ?target (state waiting)))

; ----- calls for fire -----

; With a channel free, any target he could fire at is taken for the most dangerous, ...
(defrule look-for-the-most-dangerous
  (declare (salience -6))
  (channel (contact none))
  (not (most-dangerous))
  (self (max-range ?max))
  (target (id ?id) (state waiting))
  (contact (id ?id) (seen TRUE) (condition ?condition&~destroyed) (range ?range&:(<= ?range ?max)))
  =>
  (assert (most-dangerous (id ?id) (harmlessness (harmlessness ?range ?condition)))))

; ... until there is none that is worse: the nearest of those that can still fight, then of those already hit.
(defrule another-is-more-dangerous
  (declare (salience -7))
  ?most <- (most-dangerous (id ?id) (harmlessness ?its))
  (self (max-range ?max))
  (target (id ?other&~?id) (state waiting))
  (contact (id ?other) (seen TRUE) (condition ?condition&~destroyed)
           (range ?range&:(<= ?range ?max)
                 &:(or (< (harmlessness ?range ?condition) ?its) (and (= (harmlessness ?range ?condition) ?its) (< ?other ?id)))))
  =>
  (modify ?most (id ?other) (harmlessness (harmlessness ?range ?condition))))

; One mission on each target, as many at a time as there are channels.
(defrule call-on-most-dangerous
  (declare (salience -10))
  ?most <- (most-dangerous (id ?id))
  (settings (danger-close ?danger-close))
  ?channel <- (channel (contact none))
  (self (method ?method))
  ?target <- (target (id ?id) (state waiting))
  (contact (id ?id) (location-error ?error) (hostile ?hostile) (friendly ?own) (speed ?speed) (friendly-distance ?friendly))
  =>
  (retract ?most)
  (call-for-fire ?id (chosen-method ?method ?error (max ?hostile ?own) ?speed ?friendly ?danger-close))
  (modify ?channel (contact ?id))
  (modify ?target (state called)))

(defrule most-dangerous-has-moved
  (declare (salience -5))
  ?most <- (most-dangerous (id ?id) (harmlessness ?its))
  (contact (id ?id) (condition ?condition) (range ?range&:(<> (harmlessness ?range ?condition) ?its)))
  =>
  (modify ?most (harmlessness (harmlessness ?range ?condition))))

(defrule most-dangerous-is-gone
  (declare (salience -4))
  (self (max-range ?max))
  ?most <- (most-dangerous (id ?id))
  (not (and (target (id ?id) (state waiting)) (contact (id ?id) (seen TRUE) (condition ~destroyed) (range ?range&:(<= ?range ?max)))))
  =>
  (retract ?most))

(defrule nothing-can-be-called-for
  (declare (salience -4))
  ?most <- (most-dangerous)
  (not (channel (contact none)))
  =>
  (retract ?most))

; At night a target that is lost from sight is lit, once for each time it is lost.
(defrule light-up-lost-target
  (declare (salience -20))
  (self (night TRUE) (method automatic|illuminate))
  ?channel <- (channel (contact none))
  ?target <- (target (id ?id) (state waiting))
  (contact (id ?id) (seen FALSE) (condition ~destroyed))
  (not (lit (contact ?id)))
  =>
  (call-for-fire ?id illuminate)
  (assert (lit (contact ?id)))
  (modify ?channel (contact ?id))
  (modify ?target (state called)))

(defrule seen-again
  ?lit <- (lit (contact ?id))
  (contact (id ?id) (seen TRUE))
  (not (target (id ?id) (state called|engaged)))
  =>
  (retract ?lit))

(defrule call-is-answered
  (declare (salience 30))
  (fire-mission (mission ?mission) (contact ?id) (state ~ended))
  ?target <- (target (id ?id) (state called) (mission ?last&:(< ?last ?mission)))
  ?channel <- (channel (contact ?id) (mission none))
  =>
  (modify ?channel (mission ?mission))
  (modify ?target (state engaged) (mission ?mission)))

(defrule mission-is-refused
  (declare (salience 20))
  (fire-mission (mission ?mission) (contact ?id) (state refused) (reason ?reason))
  ?target <- (target (id ?id) (state engaged) (mission ?mission))
  =>
  (end-of-mission ?mission ?reason)
  (modify ?target (state given-up)))

; Somebody else ended it: the fire direction centre or a person.
(defrule mission-was-ended
  (declare (salience 20))
  (fire-mission (mission ?mission) (contact ?id) (state ended))
  ?target <- (target (id ?id) (state called|engaged) (mission ?mission))
  =>
  (modify ?target (state given-up)))

(defrule contact-is-gone
  (declare (salience 20))
  ?target <- (target (id ?id) (state engaged) (mission ?mission))
  (not (contact (id ?id)))
  (fire-mission (mission ?mission) (state ~ended))
  =>
  (end-of-mission ?mission "the target is gone")
  (retract ?target))

; A channel is free again when its target is no longer fired at.
(defrule channel-is-free
  (declare (salience 5))
  ?channel <- (channel (contact ?id&~none))
  (not (target (id ?id) (state called|engaged)))
  =>
  (modify ?channel (contact none) (mission none)))

; ----- adjustment -----

(defrule begin-adjustment
  (declare (salience 20))
  (target (state engaged) (mission ?mission))
  (fire-mission (mission ?mission) (method adjust_fire) (state accepted|splash))
  (not (adjustment (mission ?mission)))
  =>
  (assert (adjustment (mission ?mission))))

(defrule destroyed-while-adjusting
  (declare (salience 15))
  (fire-mission (mission ?mission) (contact ?id) (state accepted|splash))
  ?target <- (target (id ?id) (state engaged) (mission ?mission))
  (contact (id ?id) (condition destroyed))
  =>
  (end-of-mission ?mission "destroyed")
  (modify ?target (state done)))

(defrule put-spot-into-words
  (declare (salience 10))
  (fire-mission (mission ?mission) (state accepted|splash) (method adjust_fire) (ot-distance ?distance))
  (target (state engaged) (mission ?mission))
  ?adjustment <- (adjustment (mission ?mission))
  ?spot <- (spot (mission ?mission) (observed TRUE) (lateral ?lateral) (range ?range))
  =>
  (retract ?spot)
  (modify ?adjustment (lost 0))
  (assert (sensed (mission ?mission) (right (deviation ?lateral ?distance)) (side (if (> ?range 0.0) then over else short)) (off (abs ?range)))))

; Range correct: effect, unless the deviation is still so large that its correction would be a guess.
(defrule range-is-correct
  (declare (salience 8))
  ?sensed <- (sensed (mission ?mission) (right ?right) (off ?off&:(<= ?off 25.0)))
  (fire-mission (mission ?mission) (danger-close FALSE))
  (test (<= (abs ?right) 300.0))
  =>
  (retract ?sensed)
  (assert (volleys (mission ?mission)))
  (fire-for-effect ?mission ?right 0))

(defrule deviation-is-large
  (declare (salience 8))
  ?sensed <- (sensed (mission ?mission) (right ?right&:(> (abs ?right) 300.0)) (off ?off&:(<= ?off 25.0)))
  (fire-mission (mission ?mission) (danger-close FALSE))
  =>
  (retract ?sensed)
  (correct ?mission ?right 0))

; Bracketing begins: a bold shift along the observer-target line, across the target.
(defrule shift-across-the-target
  (declare (salience 6))
  ?sensed <- (sensed (mission ?mission) (right ?right) (side ?side) (off ?off))
  (fire-mission (mission ?mission) (danger-close FALSE))
  ?adjustment <- (adjustment (mission ?mission) (width 0) (last none|?side))
  =>
  (retract ?sensed)
  (bind ?step (bold ?off))
  (modify ?adjustment (last ?side) (step ?step))
  (correct ?mission ?right (towards ?side ?step)))

; Over and short enclose the target: the bracket is as wide as the last shift. Halve it.
(defrule target-is-bracketed
  (declare (salience 6))
  ?sensed <- (sensed (mission ?mission) (right ?right) (side ?side))
  (fire-mission (mission ?mission) (danger-close FALSE))
  ?adjustment <- (adjustment (mission ?mission) (width 0) (last ~none&~?side) (step ?step&:(> ?step 100)))
  =>
  (retract ?sensed)
  (bind ?half (/ ?step 2))
  (modify ?adjustment (last ?side) (step ?half) (width ?half))
  (correct ?mission ?right (towards ?side ?half)))

(defrule halve-the-bracket
  (declare (salience 6))
  ?sensed <- (sensed (mission ?mission) (right ?right) (side ?side))
  (fire-mission (mission ?mission) (danger-close FALSE))
  ?adjustment <- (adjustment (mission ?mission) (width ?width&:(> ?width 100)))
  =>
  (retract ?sensed)
  (bind ?half (/ ?width 2))
  (modify ?adjustment (last ?side) (step ?half) (width ?half))
  (correct ?mission ?right (towards ?side ?half)))

; A bracket of 100 m is split: effect.
(defrule split-the-last-bracket
  (declare (salience 6))
  ?sensed <- (sensed (mission ?mission) (right ?right) (side ?side))
  (fire-mission (mission ?mission) (danger-close FALSE))
  (or (adjustment (mission ?mission) (width 100|100.0))
      (adjustment (mission ?mission) (width 0) (last ~none&~?side) (step 100|100.0)))
  =>
  (retract ?sensed)
  (bind ?last (towards ?side 50))
  (assert (volleys (mission ?mission)))
  (fire-for-effect ?mission ?right ?last))

; The round fell farther off than the bracket is wide: a sensing was wrong. Begin again.
(defrule bracket-is-lost
  (declare (salience 7))
  ?adjustment <- (adjustment (mission ?mission) (width ?width&:(> ?width 0)))
  (sensed (mission ?mission) (off ?off&:(> ?off (+ ?width 30.0))))
  =>
  (modify ?adjustment (width 0) (last none) (step 0)))

; Danger close: creep up in steps of at most 100 m, range and deviation, and fire for effect only from a correct range.
(defrule creep-to-the-target
  (declare (salience 6))
  ?sensed <- (sensed (mission ?mission) (right ?right) (side ?side) (off ?off))
  (fire-mission (mission ?mission) (danger-close TRUE))
  (test (or (> ?off 25.0) (> (abs ?right) 50.0)))
  =>
  (retract ?sensed)
  (correct ?mission (at-most ?right 70) (if (> ?off 25.0) then (at-most (towards ?side (creep ?off)) 70) else 0)))

(defrule effect-danger-close
  (declare (salience 6))
  ?sensed <- (sensed (mission ?mission) (right ?right&:(<= (abs ?right) 50.0)) (off ?off&:(<= ?off 25.0)))
  (fire-mission (mission ?mission) (danger-close TRUE))
  =>
  (retract ?sensed)
  (assert (volleys (mission ?mission)))
  (fire-for-effect ?mission ?right 0))

; Not seen: the same again, then nearer to himself where he can see it, then no more. Near friendlies nothing is shifted blindly.
(defrule round-was-lost
  (declare (salience 8))
  ?spot <- (spot (mission ?mission) (observed FALSE))
  (target (state engaged) (mission ?mission))
  (fire-mission (mission ?mission) (state accepted|splash) (method adjust_fire) (danger-close ?close))
  ?adjustment <- (adjustment (mission ?mission) (lost ?lost&:(< ?lost 3)))
  =>
  (retract ?spot)
  (modify ?adjustment (lost (+ ?lost 1)) (width 0) (last none) (step 0))
  (correct ?mission 0 (if (and (= ?lost 1) (eq ?close FALSE)) then -400 else 0)))

(defrule rounds-stay-lost
  (declare (salience 8))
  (spot (mission ?mission) (observed FALSE))
  ?target <- (target (id ?id) (state engaged) (mission ?mission))
  (fire-mission (mission ?mission) (state accepted|splash) (method adjust_fire))
  (adjustment (mission ?mission) (lost ?lost&:(>= ?lost 3)))
  =>
  (end-of-mission ?mission "the rounds cannot be observed")
  (modify ?target (state given-up)))

(defrule adjustment-takes-too-long
  (declare (salience 9))
  ?sensed <- (sensed (mission ?mission))
  ?target <- (target (id ?id) (state engaged) (mission ?mission))
  (fire-mission (mission ?mission) (rounds ?rounds&:(> ?rounds 15)))
  =>
  (retract ?sensed)
  (end-of-mission ?mission (str-cat "not adjusted after " ?rounds " rounds"))
  (modify ?target (state given-up)))

; ----- effect -----

(defrule count-volleys
  (declare (salience 20))
  (target (state engaged) (mission ?mission))
  (fire-mission (mission ?mission) (state effect|effect_over))
  (not (volleys (mission ?mission)))
  =>
  (assert (volleys (mission ?mission))))

(defrule volley-is-fired
  (declare (salience 15))
  (fire-mission (mission ?mission) (state effect_over))
  ?volleys <- (volleys (mission ?mission) (fired ?fired) (judged FALSE))
  =>
  (modify ?volleys (fired (+ ?fired 1)) (judged TRUE)))

(defrule next-volley-flies
  (declare (salience 15))
  (fire-mission (mission ?mission) (state ~effect_over))
  ?volleys <- (volleys (mission ?mission) (judged TRUE))
  =>
  (modify ?volleys (judged FALSE)))

; Rounds of fire for effect that are seen to be off are corrected in the next volley.
(defrule volley-is-off
  (declare (salience 14))
  ?spot <- (spot (mission ?mission) (observed TRUE) (lateral ?lateral) (range ?range))
  (fire-mission (mission ?mission) (state effect|effect_over) (danger-close ?close) (ot-distance ?distance))
  ?volleys <- (volleys (mission ?mission))
  =>
  (retract ?spot)
  (bind ?shift (if (<= (abs ?range) 50.0) then 0 else (if (<= (abs ?range) 100.0) then 50 else 100)))
  (bind ?side (if (> ?range 0.0) then over else short))
  (bind ?right (deviation ?lateral ?distance))
  (if (eq ?close TRUE)
    then (modify ?volleys (right (at-most ?right 70)) (add (at-most (towards ?side ?shift) 70)))
    else (modify ?volleys (right ?right) (add (towards ?side ?shift)))))

; Under the light of an illumination that still burns the target itself is attacked; the light is then a mission without target.
(defrule use-the-light
  (declare (salience 12))
  (self (method automatic))
  (fire-mission (mission ?mission) (contact ?id) (state effect) (method illuminate))
  ?target <- (target (id ?id) (state engaged) (mission ?mission))
  (contact (id ?id) (seen TRUE) (condition ~destroyed))
  =>
  (modify ?target (state waiting)))

(defrule light-burns-out
  (declare (salience 12))
  (fire-mission (mission ?mission) (contact ?id) (state effect_over) (method illuminate))
  (not (target (state engaged|given-up) (mission ?mission)))
  =>
  (end-of-mission ?mission "illuminated"))

(defrule effect-is-enough
  (declare (salience 10))
  (fire-mission (mission ?mission) (contact ?id) (state effect_over) (method ?method))
  ?volleys <- (volleys (mission ?mission) (judged TRUE))
  ?target <- (target (id ?id) (state engaged) (mission ?mission) (action ?action))
  (contact (id ?id) (condition ?condition))
  (test (or (eq ?condition destroyed)
            (eq ?action special)
            (and (eq ?action neutralize) (neq ?condition whole))
            (and (neq ?method adjust_fire) (neq ?method fire_for_effect))))
  =>
  (retract ?volleys)
  (if (eq ?method illuminate)
    then (end-of-mission ?mission "illuminated") (modify ?target (state given-up))
    else (if (eq ?method smoke) then (end-of-mission ?mission "screened") else (end-of-mission ?mission (grade ?condition)))
         (modify ?target (state (if (or (eq ?condition destroyed) (eq ?action special) (eq ?action neutralize)) then done else given-up)))))

(defrule repeat-effect
  (declare (salience 8))
  (fire-mission (mission ?mission) (contact ?id) (state effect_over))
  ?volleys <- (volleys (mission ?mission) (judged TRUE) (fired ?fired&:(< ?fired 10)) (right ?right) (add ?add))
  (target (id ?id) (state engaged) (mission ?mission))
  (contact (id ?id) (condition ~destroyed) (seen TRUE))
  (not (asked-to-repeat ?mission ?fired))
  =>
  (assert (asked-to-repeat ?mission ?fired))
  (modify ?volleys (right 0) (add 0))
  (fire-for-effect ?mission ?right ?add))

(defrule effect-stays-away
  (declare (salience 8))
  (fire-mission (mission ?mission) (contact ?id) (state effect_over))
  ?volleys <- (volleys (mission ?mission) (judged TRUE) (fired ?fired))
  ?target <- (target (id ?id) (state engaged) (mission ?mission))
  (contact (id ?id) (condition ?condition&~destroyed) (seen ?seen))
  (test (or (>= ?fired 10) (eq ?seen FALSE)))
  =>
  (retract ?volleys)
  (end-of-mission ?mission (if (eq ?seen FALSE) then (str-cat "target out of sight, " (grade ?condition)) else (str-cat (grade ?condition) " after " ?fired " volleys")))
  (modify ?target (state given-up)))

; ----- what is over is forgotten -----

(defrule forget-adjustment
  (declare (salience 4))
  ?adjustment <- (adjustment (mission ?mission))
  (not (target (state engaged) (mission ?mission)))
  =>
  (retract ?adjustment))

(defrule forget-volleys
  (declare (salience 4))
  ?volleys <- (volleys (mission ?mission))
  (not (target (state engaged) (mission ?mission)))
  =>
  (retract ?volleys))

(defrule forget-repeats
  (declare (salience 4))
  ?asked <- (asked-to-repeat ?mission ?)
  (not (fire-mission (mission ?mission) (state effect_over)))
  =>
  (retract ?asked))

(defrule forget-sensing
  (declare (salience 4))
  ?sensed <- (sensed (mission ?mission))
  (not (target (state engaged) (mission ?mission)))
  =>
  (retract ?sensed))

(defrule forget-warning
  ?warned <- (warned (contact ?id))
  (not (target (id ?id)))
  =>
  (retract ?warned))

; ----- self-preservation -----

; One call to leave is enough, however much falls at once: the nearest.
(defrule leave-under-fire
  (declare (salience 40))
  (self (self-preservation TRUE) (moving FALSE))
  (incoming (distance ?distance&:(< ?distance 300.0)))
  (not (incoming (distance ?nearer&:(< ?nearer ?distance))))
  =>
  (withdraw "fire falls " (integer ?distance) " m away"))

(defrule leave-before-the-enemy
  (declare (salience 35))
  (settings (hostile-belief ?enough))
  (self (self-preservation TRUE) (moving FALSE))
  (contact (id ?id) (name ?name) (seen TRUE) (hostile ?h&:(>= ?h ?enough)) (condition whole) (range ?range&:(< ?range 500.0)))
  (not (fled (contact ?id)))
  =>
  (assert (fled (contact ?id)))
  (withdraw ?name " is " (integer ?range) " m away"))

(defrule far-enough
  ?fled <- (fled (contact ?id))
  (not (contact (id ?id) (range ?range&:(< ?range 800.0))))
  =>
  (retract ?fled))
