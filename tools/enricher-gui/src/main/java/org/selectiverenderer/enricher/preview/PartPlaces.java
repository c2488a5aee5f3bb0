package org.selectiverenderer.enricher.preview;

import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.enricher.preview.ScenePatch.Place;

/**
 * Finds the places in a document of what is found in a part of it. A value.
 *
 * @param start where the part begins in the document
 * @param added how many characters stand before it that the document does not have
 */
record PartPlaces(Place start, int added) {
  /** The places of a part that is the whole document. */
  static final PartPlaces WHOLE = new PartPlaces(new Place(1, 1), 0);

  /** Returns the place of a location in the part. */
  Place of(SourceLocation at) {
    return at.line() == 1
        ? new Place(start.line(), start.column() + at.column() - 1 - added)
        : new Place(start.line() + at.line() - 1, at.column());
  }
}
