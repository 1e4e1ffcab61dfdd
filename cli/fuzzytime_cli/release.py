"""Which fuzzytime this is."""


def installed_version() -> str:
    """Give the version that is installed; a checkout that is run without being installed has none."""
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version("fuzzytime-planner")
    except PackageNotFoundError:
        return "of a checkout, not installed"
