"""The best among schedules that satisfy equally."""
