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

(deftemplate most-dangerous (slot id) (slot harmlessness)) ; of the targets that wait, while a channel is free
(deftemplate fled (slot contact))
(deftemplate warned (slot contact))
(deftemplate lit (slot contact))

; ----- judgement -----

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
