(set-info :source "never
ended)
