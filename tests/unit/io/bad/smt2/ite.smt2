(set-logic QF_LRA)
(declare-fun x () Real)
(declare-fun y () Real)
(assert (< (ite (< x 0) x y) 1))
