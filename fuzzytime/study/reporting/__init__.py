"""An analysis as numbers, figures and a page."""
