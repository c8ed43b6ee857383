"""Program and exercise to verdict: what is wrong with a list by itself, and whether it does what another one does."""
