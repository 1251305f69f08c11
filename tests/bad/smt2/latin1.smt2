(declare-fun |größe| () Real)
