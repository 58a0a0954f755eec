(deftemplate thing (slot a))
(defrule r (thing (a ?x&:(> ?x 1))) => (assert (done ?x)))
(deffacts f (thing (a 2)) (location 1 2))
