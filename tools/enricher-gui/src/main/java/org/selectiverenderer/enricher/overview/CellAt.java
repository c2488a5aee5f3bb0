package org.selectiverenderer.enricher.overview;

/**
 * A cell of the table.
 *
 * @param row of the table as it is shown
 * @param column of the model: 0 is the object's name
 */
record CellAt(int row, int column) {}
