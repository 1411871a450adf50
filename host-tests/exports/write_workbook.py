"""Excel and OpenDocument workbooks, as far as make_exports.py needs them."""
import datetime as dt
import io
import zipfile

SHEET = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
RELATION = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"


def archive_of(parts):
    """A zip archive of XML parts, the same bytes each time."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in parts.items():
            archive.writestr(zipfile.ZipInfo(name, (2026, 5, 13, 14, 30, 0)),
                             '<?xml version="1.0" encoding="UTF-8"?>' + text)
    return out.getvalue()


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
    return archive_of(parts)


def cells(row, *values):
    """A row of (kind, value): s a shared word, i a word of its own, digits a style."""
    text = "".join(
        f'<c r="{"ABCDEF"[i]}{row}" t="s"><v>{value}</v></c>' if kind == "s" else
        f'<c r="{"ABCDEF"[i]}{row}" t="inlineStr"><is><t>{value}</t></is></c>' if kind == "i" else
        f'<c r="{"ABCDEF"[i]}{row}" s="{kind}"><v>{value}</v></c>'
        for i, (kind, value) in enumerate(values) if value is not None)
    return f'<row r="{row}">{text}</row>'


def open_document(sheets):
    """An ods file; sheets: (name, rows of cells). A datetime is a date, None an empty cell."""
    def cell(value):
        if value is None:
            return '<table:table-cell/>'
        if isinstance(value, dt.datetime):
            return ('<table:table-cell office:value-type="date" office:date-value='
                    f'"{value.isoformat()}"><text:p>{value:%d.%m.%Y}</text:p></table:table-cell>')
        if isinstance(value, float):
            return ('<table:table-cell office:value-type="float" office:value='
                    f'"{value!r}"><text:p>{value:.0f}</text:p></table:table-cell>')
        return ('<table:table-cell office:value-type="string"><office:annotation><text:p>seen'
                f'</text:p></office:annotation><text:p>{value}</text:p></table:table-cell>')
    tables = "".join(
        f'<table:table table:name="{name}">' + "".join(
            "<table:table-row>" + "".join(map(cell, row)) +
            '<table:table-cell table:number-columns-repeated="16380"/></table:table-row>'
            for row in rows) +
        '<table:table-row table:number-rows-repeated="1048000"><table:table-cell '
        'table:number-columns-repeated="16384"/></table:table-row></table:table>'
        for name, rows in sheets)
    names = "".join(f' xmlns:{prefix}="urn:oasis:names:tc:opendocument:xmlns:{prefix}:1.0"'
                    for prefix in ("office", "table", "text"))
    return archive_of({
        "mimetype": "application/vnd.oasis.opendocument.spreadsheet",
        "content.xml": f"<office:document-content{names}><office:body><office:spreadsheet>"
                       f"{tables}</office:spreadsheet></office:body></office:document-content>"})
