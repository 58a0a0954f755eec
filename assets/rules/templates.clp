; What the forward observer knows. The simulator asserts these facts and keeps them up to date; rules reason on them and decide
; with (call-for-fire ...), (correct ...), (fire-for-effect ...), (end-of-mission ...), (withdraw ...) and (warn ...).
; docs/rules.md explains every slot. Lengths are metres, angles mils (6400 to the circle), speeds metres per second.
;
; Beside these there are the ordered facts of the thesis: (mission destroy|neutralize|special TYPE), what he is there for;
; (location NAME X Z) and (mountedon TYPE), if his facts file has them.

(deftemplate settings
  (slot danger-close (default 600.0))       ; friendlies nearer to a target than this: creep
  (slot hostile-belief (default 0.6)))      ; belief from which a contact counts as hostile or friendly

; One for each fire mission he may have open at a time.
(deftemplate channel
  (slot number)
  (slot contact (default none))             ; the contact it is in use for
  (slot mission (default none)))            ; the number of the mission, once the fire direction centre has answered

(deftemplate self
  (slot x) (slot z)
  (slot type)                               ; of the vehicle he is mounted on
  (slot max-range)                          ; he sees no farther
  (slot moving)                             ; TRUE FALSE
  (slot night)                              ; TRUE FALSE
  (slot method)                             ; automatic adjust_fire fire_for_effect suppress immediate_suppression smoke illuminate
  (slot self-preservation))                 ; TRUE FALSE

(deftemplate contact
  (slot id) (slot type) (slot name)         ; name of the type
  (slot x) (slot z) (slot range) (slot azimuth) (slot speed)
  (slot location-error)                     ; circular error probable of x and z, as he judges it
  (slot hostile) (slot friendly)            ; beliefs, 0 to 1
  (slot condition)                          ; whole damaged suppressed destroyed
  (slot seen)                               ; TRUE while in sight
  (slot friendly-distance))                 ; of the nearest friendly from it

(deftemplate fire-mission
  (slot mission) (slot contact)
  (slot state)                              ; refused accepted splash effect effect_over ended
  (slot method)
  (slot rounds)                             ; adjusting rounds spotted
  (slot danger-close)                       ; TRUE FALSE
  (slot ot-distance)                        ; observer to target
  (slot reason))                            ; of a refusal

; What he saw of a burst, in his own frame. Lives for one run of the rules.
(deftemplate spot
  (slot mission) (slot round)
  (slot observed)                           ; FALSE: lost
  (slot lateral)                            ; mils right of the target; left is negative
  (slot range))                             ; beyond the target; short is negative

; A hostile burst or shot this far away. Lives for one run of the rules.
(deftemplate incoming (slot distance))
