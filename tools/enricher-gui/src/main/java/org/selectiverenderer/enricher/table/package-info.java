/**
 * What the tables of the enricher's window have in common: rows, and colours that say something.
 *
 * <p>In: rows and the heads of columns. Out: a model that Swing asks. Uses nothing else of ours.
 */
@NullMarked
package org.selectiverenderer.enricher.table;

import org.jspecify.annotations.NullMarked;
