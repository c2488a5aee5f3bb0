package org.web3d.x3d.sai;

import org.jspecify.annotations.Nullable;

/**
 * A field of a node. Reading one that cannot be read throws {@link InvalidReadableFieldException},
 * writing one that cannot be written {@link InvalidWritableFieldException}.
 */
public interface X3DField {
  /** Name, type and access of the field. */
  X3DFieldDefinition getDefinition();

  /** Whether the value may be read now. */
  boolean isReadable();

  /** Whether the value may be written now. */
  boolean isWritable();

  /**
   * Calls the listener each time that the field sends an event; a listener that is there already is
   * not added again.
   */
  void addX3DEventListener(X3DFieldEventListener listener);

  /** Ends the calls; without effect if the listener is not there. */
  void removeX3DEventListener(X3DFieldEventListener listener);

  /** Attaches an object of the caller, which comes with each event; null takes it away. */
  void setUserData(@Nullable Object data);

  /** The attached object, or null. */
  @Nullable Object getUserData();
}
