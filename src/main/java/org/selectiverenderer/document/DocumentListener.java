package org.selectiverenderer.document;

import java.util.List;
import org.selectiverenderer.x3d.source.TextChange;

/** Hears of changes of a document, on the thread that makes them, after they are made. */
public interface DocumentListener {
  /**
   * What happened.
   *
   * @param revision of the document now
   * @param changes of the text, in the offsets before
   * @param readAnew whether all elements are new objects, or gone, or there again; otherwise those
   *     that are still attached are the same
   */
  record Change(long revision, List<TextChange> changes, boolean readAnew) {}

  void changed(Change change);
}
