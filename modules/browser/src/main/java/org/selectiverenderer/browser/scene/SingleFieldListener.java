package org.selectiverenderer.browser.scene;

/** A listener that knows the field it listens to, so that the node need not store it. */
public interface SingleFieldListener extends FieldListener {
  /** Returns the index of the field. */
  int field();
}
