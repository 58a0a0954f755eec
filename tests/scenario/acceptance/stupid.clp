; appendix B.C of the thesis, with the observer's own vehicle as his mission
(deffacts forward-observer
  (location observer 25000.0 25000.0)
  (mountedon 8)
  (mission destroy 8)
  (location gun2 25505.0 25506.0)
  (location gun3 24000.0 24000.0)
  (location gun4 24500.0 24500.0))
