/**
 * CSV files that users write, as rows of cells that know their place.
 *
 * <p>In: a file's bytes. Out: {@link org.selectiverenderer.csv.CsvTable}, and faults with
 * file:line:column in one sentence each. What the cells mean is the reader's business. Uses {@code
 * x3d.Location} and commons-csv.
 */
@NullMarked
package org.selectiverenderer.csv;

import org.jspecify.annotations.NullMarked;
