"""The page with all results, the same for programs, the README's tables; the style of pictures."""
