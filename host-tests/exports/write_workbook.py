"""Excel workbooks, as far as make_exports.py needs them."""
import io
import zipfile

SHEET = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
RELATION = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"


def workbook(sheets, words=()):
    """An xlsx file; sheets: (name, rows of cells as XML). Styles: 1 date and time, 2 date,
    3 time of day, 4 a number with two places."""
    parts = {
        "[Content_Types].xml": "<Types/>",
        "xl/workbook.xml": f'<workbook xmlns="{SHEET}" xmlns:r="{RELATION}"><sheets>' + "".join(
            f'<sheet name="{name}" sheetId="{i + 1}" r:id="rId{i + 1}"/>'
            for i, (name, _) in enumerate(sheets)) + "</sheets></workbook>",
        "xl/_rels/workbook.xml.rels": "<Relationships>" + "".join(
            f'<Relationship Id="rId{i + 1}" Target="worksheets/sheet{i + 1}.xml"/>'
            for i in range(len(sheets))) + "</Relationships>",
        "xl/styles.xml": f'<styleSheet xmlns="{SHEET}"><numFmts><numFmt numFmtId="164" '
        'formatCode="dd/mm/yyyy\\ hh:mm:ss"/></numFmts><cellStyleXfs><xf numFmtId="0"/>'
        '</cellStyleXfs><cellXfs><xf numFmtId="0"/><xf numFmtId="164"/><xf numFmtId="14"/>'
        '<xf numFmtId="21"/><xf numFmtId="2"/></cellXfs></styleSheet>',
        "xl/sharedStrings.xml": f'<sst xmlns="{SHEET}">' + "".join(
            f"<si><t>{word}</t></si>" for word in words) + "</sst>"}
    for i, (_, rows) in enumerate(sheets):
        parts[f"xl/worksheets/sheet{i + 1}.xml"] = (
            f'<worksheet xmlns="{SHEET}"><sheetData>' + "".join(rows) +
            "</sheetData></worksheet>")
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in parts.items():
            archive.writestr(zipfile.ZipInfo(name, (2026, 5, 13, 14, 30, 0)),
                             '<?xml version="1.0" encoding="UTF-8"?>' + text)
    return out.getvalue()


def cells(row, *values):
    """A row of (kind, value): s a shared word, i a word of its own, digits a style."""
    text = "".join(
        f'<c r="{"ABCDEF"[i]}{row}" t="s"><v>{value}</v></c>' if kind == "s" else
        f'<c r="{"ABCDEF"[i]}{row}" t="inlineStr"><is><t>{value}</t></is></c>' if kind == "i" else
        f'<c r="{"ABCDEF"[i]}{row}" s="{kind}"><v>{value}</v></c>'
        for i, (kind, value) in enumerate(values) if value is not None)
    return f'<row r="{row}">{text}</row>'
