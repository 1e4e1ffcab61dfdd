"""The model is found without being imported, and its files are compared with the official ones."""

from pathlib import Path

import pytest

from fuzzytime.language import installed_model, model_files, shipped_lexicon
from fuzzytime.language.sentence.trees import model
from fuzzytime.language.sentence.trees.model import ModelError, ModelPackage, parsed
from fuzzytime.language.sentence.trees.model_files import FileState, official_hashes

pytestmark = pytest.mark.model


def test_the_installed_model_has_a_name_and_a_version() -> None:
    found = installed_model()
    assert found.name in model.PACKAGES
    assert found.version.startswith("3.8")


def test_the_official_package_is_preferred() -> None:
    assert model.PACKAGES[0] == "en_core_web_sm"


def test_every_file_that_matters_is_the_official_one() -> None:
    files = model_files(installed_model())
    assert {file.path: file.state for file in files} == dict.fromkeys(official_hashes(), FileState.OFFICIAL)


def test_a_file_that_differs_or_is_missing_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    package = tmp_path / "tiny_model"
    (package / "tiny_model-1.0").mkdir(parents=True)
    (package / "__init__.py").write_text("")
    (package / "tiny_model-1.0" / "config.cfg").write_text("changed")
    monkeypatch.syspath_prepend(str(tmp_path))
    states = {file.path: file.state for file in model_files(ModelPackage("tiny_model", "1.0"))}
    assert states["config.cfg"] is FileState.DIFFERENT
    assert states["tagger/model"] is FileState.MISSING


def test_without_a_model_the_error_names_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(model, "PACKAGES", ("no_such_model",))
    with pytest.raises(ModelError, match="no_such_model"):
        installed_model()


def test_a_model_that_does_not_load_is_an_error_of_ours() -> None:
    with pytest.raises(ModelError, match="must load"):
        list(parsed(["text"], ModelPackage("no_such_model", "1.0"), shipped_lexicon()))


@pytest.mark.parametrize("text", ["flip  the\npancakes", "\ud800 go", " lead", "🍞 bake", "a\u0301 b"])
def test_words_of_a_tree_are_where_they_stand_in_the_text(text: str) -> None:
    (tree,) = parsed([text], installed_model(), shipped_lexicon())
    assert all(text[node.start : node.end] == node.text for node in tree.nodes)
    assert all(node.text.strip() for node in tree.nodes)
