package org.selectiverenderer.authoring;

import java.util.List;
import org.selectiverenderer.x3d.source.TextEdit;

/** Receives the changes of a document, on the thread that makes them, after they are made. */
public interface DocumentListener {
  /**
   * A change of a document.
   *
   * @param revision the document's revision after the change
   * @param changes changes of the text, in offsets before the change
   * @param readAnew whether the text was parsed anew, so that all elements are new objects;
   *     otherwise attached elements keep their identity
   */
  record Change(long revision, List<TextEdit> changes, boolean readAnew) {}

  void changed(Change change);
}
