package org.selectiverenderer.enricher.form;

import javax.swing.JComponent;

/** A form that edits or describes one element of the document. */
interface Form {
  JComponent component();

  /** Whether its controls still fit the element; else the form is built again. */
  boolean fits();

  /** Updates the controls from the document. */
  void follow();

  /** Writes what has been typed. */
  void commit();

  /** Releases what the form holds; it is not used any more. */
  void dispose();
}
