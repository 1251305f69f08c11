(set-logic QF_LRA)
(declare-fun x () Real)
(declare-fun y () Real)
(assert (< (/ 1 x) 1))
