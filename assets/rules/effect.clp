; Fire for effect: when it is enough, repeated or given up. Loaded after adjustment.clp.

; The vehicles of ordered types within 100 m of the target, and how many of them are damaged or destroyed.
(deftemplate area (slot mission) (slot vehicles (default 0)) (slot hit (default 0)))
(deftemplate counted (slot mission) (slot contact))

(deffunction grade (?condition)
  (if (eq ?condition destroyed) then (return "destroyed"))
  (if (eq ?condition damaged) then (return "neutralised"))
  (if (eq ?condition suppressed) then (return "suppressed"))
  (return "no effect seen"))

; From three vehicles on it is an area: neutralised from 10 %, destroyed from 30 % of them.
(deffunction share (?vehicles ?hit)
  (if (< ?vehicles 3) then (return 0.0))
  (return (/ ?hit ?vehicles)))

(deffunction verdict (?condition ?vehicles ?hit)
  (if (< (share ?vehicles ?hit) 0.1) then (return (grade ?condition)))
  (return (str-cat (grade ?condition) ", area " (if (>= (share ?vehicles ?hit) 0.3) then "destroyed" else "neutralised")
                   " (" ?hit " of " ?vehicles " vehicles hit)")))

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

(defrule look-over-the-area
  (declare (salience 14))
  (fire-mission (mission ?mission) (state effect_over))
  (volleys (mission ?mission) (judged TRUE))
  (target (state engaged) (mission ?mission))
  (not (area (mission ?mission)))
  =>
  (assert (area (mission ?mission))))

(defrule count-vehicle-in-the-area
  (declare (salience 13))
  (fire-mission (mission ?mission) (contact ?id) (state effect_over))
  (volleys (mission ?mission) (judged TRUE))
  (contact (id ?id) (x ?x) (z ?z))
  (contact (id ?other) (type ?type) (condition ?condition) (x ?its-x) (z ?its-z&:(<= (moved-apart ?x ?z ?its-x ?its-z) 100.0)))
  (exists (mission ? ?type))
  (not (counted (mission ?mission) (contact ?other)))
  ?area <- (area (mission ?mission) (vehicles ?vehicles) (hit ?hit))
  =>
  (assert (counted (mission ?mission) (contact ?other)))
  (modify ?area (vehicles (+ ?vehicles 1)) (hit (+ ?hit (if (or (eq ?condition damaged) (eq ?condition destroyed)) then 1 else 0)))))

(defrule effect-is-enough
  (declare (salience 10))
  (fire-mission (mission ?mission) (contact ?id) (state effect_over) (method ?method))
  ?volleys <- (volleys (mission ?mission) (judged TRUE))
  ?target <- (target (id ?id) (state engaged) (mission ?mission) (action ?action))
  (contact (id ?id) (condition ?condition))
  (area (mission ?mission) (vehicles ?vehicles) (hit ?hit))
  (test (or (eq ?condition destroyed)
            (eq ?action special)
            (and (eq ?action neutralize) (or (neq ?condition whole) (>= (share ?vehicles ?hit) 0.1)))
            (and (neq ?method adjust_fire) (neq ?method fire_for_effect))))
  =>
  (retract ?volleys)
  (if (eq ?method illuminate)
    then (end-of-mission ?mission "illuminated") (modify ?target (state given-up))
    else (if (eq ?method smoke) then (end-of-mission ?mission "screened") else (end-of-mission ?mission (verdict ?condition ?vehicles ?hit)))
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
  (area (mission ?mission) (vehicles ?vehicles) (hit ?hit))
  (test (or (>= ?fired 10) (eq ?seen FALSE)))
  =>
  (retract ?volleys)
  (end-of-mission ?mission (if (eq ?seen FALSE) then (str-cat "target out of sight, " (verdict ?condition ?vehicles ?hit)) else (str-cat (verdict ?condition ?vehicles ?hit) " after " ?fired " volleys")))
  (modify ?target (state given-up)))

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

(defrule forget-area
  (declare (salience 4))
  ?area <- (area (mission ?mission))
  (not (fire-mission (mission ?mission) (state effect_over)))
  =>
  (retract ?area))

(defrule forget-count
  (declare (salience 4))
  ?counted <- (counted (mission ?mission))
  (not (area (mission ?mission)))
  =>
  (retract ?counted))
