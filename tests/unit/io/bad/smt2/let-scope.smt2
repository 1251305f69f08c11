(set-logic QF_LRA)
(declare-fun x () Real)
(declare-fun y () Real)
(assert (and (let ((a x)) (< a 1)) (< a 2)))
