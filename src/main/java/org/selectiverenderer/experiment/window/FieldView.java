package org.selectiverenderer.experiment.window;

import javax.swing.JComponent;

/** A field of an answer on the screen. */
interface FieldView {
  /** Hears what is filled in. */
  interface Listener {
    /**
     * The value is another one; empty where it is taken back or is not yet one.
     *
     * @param settled whether it may be kept as it is: not while somebody is typing
     */
    void filled(String value, boolean settled);
  }

  /** What is seen of it. */
  JComponent component();

  /** Shows a value without telling of it. */
  void show(String value);

  /**
   * A character was typed while the field's row is marked.
   *
   * @return whether it chose something
   */
  boolean key(char typed);

  /** Takes the keys that are typed, where it takes any. */
  void focus();

  /** Whether keys are to be typed into it. */
  boolean takesText();

  /** Tells of what was typed and not yet told. */
  void settle();
}
