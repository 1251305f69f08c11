(declare-const b Bool)
(maximize b)
