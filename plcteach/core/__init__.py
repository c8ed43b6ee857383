"""The words that every other room speaks: frozen values, no behaviour that needs a machine or a screen."""
