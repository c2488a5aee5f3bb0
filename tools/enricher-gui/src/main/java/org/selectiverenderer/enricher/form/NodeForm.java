package org.selectiverenderer.enricher.form;

import javax.swing.JPanel;

/** The form of one node. */
interface NodeForm {
  JPanel component();

  /**
   * Shows the node as it is now.
   *
   * @return false if it needs another form
   */
  boolean refresh();

  /** Takes over what is typed. */
  void commit();

  /** Takes back what it has asked for. */
  void dispose();
}
