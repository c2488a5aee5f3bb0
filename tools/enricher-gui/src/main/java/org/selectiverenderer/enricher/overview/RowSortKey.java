package org.selectiverenderer.enricher.overview;

/**
 * The sort order of the rows.
 *
 * @param column of the model: 0 is the object's name; -1 for the order of the document
 */
record RowSortKey(int column, boolean descending) {
  /** As in the document. */
  static final RowSortKey DOCUMENT = new RowSortKey(-1, false);

  /** The order after a click on a column header: ascending, descending, then document order. */
  RowSortKey clicked(int other) {
    if (column != other) {
      return new RowSortKey(other, false);
    }
    return descending ? DOCUMENT : new RowSortKey(column, true);
  }
}
