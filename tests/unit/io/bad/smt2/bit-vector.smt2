(declare-fun a () (_ BitVec 8))
