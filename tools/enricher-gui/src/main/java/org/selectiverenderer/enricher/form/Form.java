package org.selectiverenderer.enricher.form;

import javax.swing.JComponent;

/** A form of one element. */
interface Form {
  JComponent component();

  /** Whether its controls are still the right ones for the element. */
  boolean fits();

  /** Shows what the document says now. */
  void follow();

  /** Writes what has been typed. */
  void commit();

  /** Nothing is asked of it any more. */
  void dispose();
}
