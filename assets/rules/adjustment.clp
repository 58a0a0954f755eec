; Adjustment of fire: bracketing along the observer-target line, creeping near friendlies (world.md section 2; public digests of
; FM 6-30). Loaded after observer.clp.

; The bracket of a mission in adjustment. last: over or short, the side of the last round; step: how far the range was shifted then;
; width: of the bracket once two rounds enclose the target, 0 before.
(deftemplate adjustment
  (slot mission) (slot last (default none)) (slot step (default 0)) (slot width (default 0)) (slot lost (default 0)))

; A spot put into words: side over or short, off the amount, right the correction of deviation.
(deftemplate sensed (slot mission) (slot right) (slot side) (slot off))

; Volleys of effect fired so far, and the correction of the next one.
(deftemplate volleys (slot mission) (slot fired (default 0)) (slot right (default 0)) (slot add (default 0)) (slot judged (default FALSE)))

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

; ----- rounds and corrections -----

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

(defrule forget-adjustment
  (declare (salience 4))
  ?adjustment <- (adjustment (mission ?mission))
  (not (target (state engaged) (mission ?mission)))
  =>
  (retract ?adjustment))

(defrule forget-sensing
  (declare (salience 4))
  ?sensed <- (sensed (mission ?mission))
  (not (target (state engaged) (mission ?mission)))
  =>
  (retract ?sensed))
