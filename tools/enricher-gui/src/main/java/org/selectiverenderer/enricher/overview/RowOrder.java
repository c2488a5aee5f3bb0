package org.selectiverenderer.enricher.overview;

/**
 * The sort order of the rows.
 *
 * @param column of the model: 0 is the object's name; -1 for the order of the document
 */
record RowOrder(int column, boolean descending) {
  /** As in the document. */
  static final RowOrder DOCUMENT = new RowOrder(-1, false);

  /** The order after a click on a column header: ascending, descending, then document order. */
  RowOrder clicked(int other) {
    if (column != other) {
      return new RowOrder(other, false);
    }
    return descending ? DOCUMENT : new RowOrder(column, true);
  }
}
