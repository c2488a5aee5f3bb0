/**
 * Tables as text: one reader of every table that a person brings, and one writer.
 *
 * <p><b>What is read.</b> UTF-8 with or without a byte order mark; RFC 4180 quotes; a header that
 * names the columns in any case and any order; empty lines passed over. Cells are separated by
 * commas, tabs or semicolons, in all rows alike: by the first of these that divides the header into
 * the columns that the reader needs, else by whichever the header has most of outside quotation
 * marks ({@link org.selectiverenderer.base.csv.Separator}). Empty cells beyond the header are
 * passed over, and columns that the reader does not need may be missing at the end of a row; any
 * other row with more or fewer cells than the header is a fault, unless the reader's {@link
 * org.selectiverenderer.base.csv.CsvColumns} allow it. A reader may also hand in a text that it has
 * decoded from another encoding.
 *
 * <p><b>Numbers.</b> With a decimal point or a decimal comma; a table has one sign throughout, and
 * a number with the other one is a fault, as it may be a separator of thousands. Programs write
 * semicolons between the cells where the comma is the decimal sign, so in such a table every comma
 * is one. Where commas or tabs separate, {@code "4,5"} is a number too, but {@code "1,234"}, with
 * exactly three digits behind the comma, says too little of what it means and is refused with
 * advice.
 *
 * <p><b>What is written.</b> {@link org.selectiverenderer.base.csv.CsvText}: commas, quotes where
 * needed, LF.
 *
 * <p>In: a file's bytes or text. Out: {@link org.selectiverenderer.base.csv.CsvTable}, rows of
 * cells that know their place, or, from {@link org.selectiverenderer.base.csv.NumberTable}, arrays;
 * and faults with file:line:column in one sentence each. What the cells mean is the reader's
 * business. Uses {@code base.problem} and {@code base.files}; only this package uses commons-csv.
 */
@NullMarked
package org.selectiverenderer.base.csv;

import org.jspecify.annotations.NullMarked;
