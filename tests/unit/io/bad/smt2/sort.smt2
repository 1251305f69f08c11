(declare-fun a () (Array Int Real))
