package org.selectiverenderer.control;

import org.web3d.x3d.sai.InvalidNodeException;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DFieldEventListener;

/** Removes listeners from fields. */
final class FieldListeners {
  private FieldListeners() {}

  /** Removes a listener from a field whose node may be gone, and its listeners with it. */
  static void remove(X3DField field, X3DFieldEventListener listener) {
    try {
      field.removeX3DEventListener(listener);
    } catch (InvalidNodeException e) {
      // The application has disposed of the node: there is nothing to remove.
    }
  }
}
