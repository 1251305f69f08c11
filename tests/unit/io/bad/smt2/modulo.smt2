(set-logic QF_LIA)
(declare-fun n () Int)
(assert (= (mod n 2) 0))
