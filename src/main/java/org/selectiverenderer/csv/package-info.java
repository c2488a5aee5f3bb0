/**
 * CSV files that users write, as rows of cells that know their place, and tables of numbers over
 * time; columns are found by their names.
 *
 * <p>In: a file's bytes. Out: {@link org.selectiverenderer.csv.CsvTable} or, from {@link
 * org.selectiverenderer.csv.NumberTable}, arrays; and faults with file:line:column in one sentence
 * each. What the cells mean is the reader's business. Uses {@code x3d} for places and problems, and
 * commons-csv.
 */
@NullMarked
package org.selectiverenderer.csv;

import org.jspecify.annotations.NullMarked;
