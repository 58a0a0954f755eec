; the rule on line 2 lacks its arrow
(defrule fire-at-will
  (contact (id ?id))
  (call-for-fire ?id adjust_fire))
