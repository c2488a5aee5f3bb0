package org.selectiverenderer.enricher.overview;

/**
 * The position of a cell in the overview table.
 *
 * @param row row of the filtered and sorted table
 * @param column column of the model: 0 is the object's name
 */
record CellPosition(int row, int column) {}
