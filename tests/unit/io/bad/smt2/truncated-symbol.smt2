(declare-fun |x () Real)
(assert (< x 0))
