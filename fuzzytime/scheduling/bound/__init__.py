"""What no schedule can cost less than: a Lagrangian bound, on grid after finer grid."""
