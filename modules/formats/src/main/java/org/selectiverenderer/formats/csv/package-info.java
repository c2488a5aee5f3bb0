/**
 * CSV and TSV tables: one reader for every table that a user supplies, and one writer.
 *
 * <p><b>Reading.</b> The reader accepts UTF-8 with or without a byte order mark, RFC 4180 quotes,
 * and a header that names the columns in any letter case and order; it skips empty lines. Cells are
 * separated by commas, tabs or semicolons, the same in all rows: the first of these that splits the
 * header into the columns that the caller needs, else the one that occurs most often in the header
 * outside quotation marks ({@link org.selectiverenderer.formats.csv.CsvDelimiter}). Empty cells
 * beyond the header are ignored, and columns that the caller does not need may be missing at the
 * end of a row; any other row with more or fewer cells than the header is an error, unless the
 * caller's {@link org.selectiverenderer.formats.csv.CsvColumnSpec} allow it. A caller may also pass
 * a text that it has decoded from another encoding.
 *
 * <p><b>Numbers.</b> Numbers have a decimal point or a decimal comma. A table uses one of the two
 * throughout, and a number with the other one is an error, as it may be a thousands separator.
 * Programs write semicolons between the cells in locales whose decimal sign is the comma, so in
 * such a table every comma is a decimal comma. Where commas or tabs separate the cells, {@code
 * "4,5"} is a number too, but {@code "1,234"}, with exactly three digits after the comma, is
 * ambiguous and is refused with a hint.
 *
 * <p><b>Writing.</b> {@link org.selectiverenderer.formats.csv.CsvWriter} writes commas, quotes
 * where needed, and LF.
 *
 * <p>In: a file's bytes or text. Out: {@link org.selectiverenderer.formats.csv.CsvTable}, rows of
 * cells with their location in the file, or, from {@link
 * org.selectiverenderer.formats.csv.TimeSeriesReader}, arrays of numbers; and errors of one
 * sentence with file:line:column. The caller interprets the cells. Uses {@code base.problem} and
 * {@code base.files}.
 *
 * <p><b>No library.</b> Tests compare both directions with Commons CSV on random texts; the program
 * does without it. Its records know where a row begins, but not the column of a cell, which our
 * errors name, and it needs the separator in advance. Of a log of 260,000 rows and ten columns it
 * keeps 147 MB of records, this reader 3 MB beside the text; both read it in a quarter of a second.
 * Writing takes ten lines, and does not justify 60 kB that bring Commons IO and Commons Codec,
 * another 940 kB.
 */
@NullMarked
package org.selectiverenderer.formats.csv;

import org.jspecify.annotations.NullMarked;
