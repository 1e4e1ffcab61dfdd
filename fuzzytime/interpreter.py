"""The meeting of language and rulebook: from text and context to fuzzy skills, with explanations."""
