(assert (forall ((x Real)) (< x 1)))
