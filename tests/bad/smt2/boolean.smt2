(declare-fun p () Bool)
(assert p)
