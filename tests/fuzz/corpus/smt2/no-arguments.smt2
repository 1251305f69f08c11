(set-logic QF_LRA)
(declare-fun x () Real)
(declare-fun y () Real)
(assert (< (* ) Re 1))
