"""The commands, one a module; heavy imports wait inside them."""
