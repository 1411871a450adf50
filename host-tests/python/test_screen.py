"""What stickband.screen hands to its workers; a cluster of them: host-tests/screen."""
from stickband import screen


def test_a_worker_elsewhere_sees_the_file_of_pairs(tmp_path, monkeypatch):
    (tmp_path / "rules.csv").write_text("loop,u,y\n")
    monkeypatch.chdir(tmp_path)
    whole = str(tmp_path / "rules.csv")
    seen = screen._seen_from_anywhere
    assert seen(["--ts", "1", "--pairs", "rules.csv"]) == ["--ts", "1", "--pairs", whole]
    assert seen(["--pairs=rules.csv", "--apart"]) == [f"--pairs={whole}", "--apart"]
    assert seen(["--pairs", "*.OP/*.PV"]) == ["--pairs", "*.OP/*.PV"]
