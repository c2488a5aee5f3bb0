package org.selectiverenderer.enricher.component;

import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;

/**
 * A listener that does the same on every change of a text component's text.
 *
 * @param changed runs after each change
 */
public record TextChangeListener(Runnable changed) implements DocumentListener {
  @Override
  public void insertUpdate(DocumentEvent event) {
    changed.run();
  }

  @Override
  public void removeUpdate(DocumentEvent event) {
    changed.run();
  }

  @Override
  public void changedUpdate(DocumentEvent event) {
    changed.run();
  }
}
