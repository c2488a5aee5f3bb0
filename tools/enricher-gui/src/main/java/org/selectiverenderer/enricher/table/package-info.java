/**
 * The base of the tables in the enricher's window: a table model of rows, and status colours.
 *
 * <p>In: rows and the heads of columns. Out: a model that Swing asks. Uses nothing else of ours.
 */
@NullMarked
package org.selectiverenderer.enricher.table;

import org.jspecify.annotations.NullMarked;
