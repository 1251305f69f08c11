(set-logic QF_LRA)
(declare-const x Real)
(assert (or (< x 0) (> x 1)))
(check-sat)
