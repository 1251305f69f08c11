(define-sort R () Real)(declare-fun x () R)(declare-fun y () R) ; comment
(define-fun f ((a Real) (b Bool)) Real (ite b (+ a 1) (- a y)))
(define-fun c () Real (/ 1 3))
(assert (let ((x y) (y x)) (let ((z (+ x y x x x x))) (< (f z true) (* c (- z) 2)))))
(assert (or (or (let ((q (> x y))) q) false) (< (to_real 1) 0)))
