(declare-fun p () Bool)
(declare-fun q () Bool)
(assert p)
(assert (=> p (or q (not q))))
