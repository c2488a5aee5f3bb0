package org.selectiverenderer.runtime.scene;

/** A listener that knows its field, so that the node need not note it. */
public interface ListenerOfField extends FieldListener {
  /** The index of the field. */
  int field();
}
