package org.selectiverenderer.app.window;

import java.awt.event.KeyEvent;
import javax.swing.JComponent;

/** The view of an input field. */
interface FieldView {
  /** Receives the values that are entered. */
  interface Listener {
    /**
     * The value has changed; it is empty if it was taken back or is not valid yet.
     *
     * @param settled whether the value is final; false while the participant is typing
     */
    void filled(String value, boolean settled);
  }

  /** Returns the Swing component. */
  JComponent component();

  /** Shows a value without notifying the listener. */
  void show(String value);

  /**
   * Handles a character that was typed while the field's row is current.
   *
   * @return whether the character chose an option
   */
  boolean key(char typed);

  /**
   * Handles a key that was pressed while the field's row is current, before the page does.
   *
   * @return whether the field has handled the key
   */
  default boolean pressed(KeyEvent key) {
    return false;
  }

  /** Returns whether the value that was entered last is complete, so that one may go on at once. */
  default boolean advances() {
    return false;
  }

  /** Takes the keyboard focus if the field takes text. */
  void focus();

  /** Returns whether the field takes text. */
  boolean takesText();

  /** Returns whether the field waits for a second digit of a number. */
  default boolean waits() {
    return false;
  }

  /** Reports text that was typed and is not reported yet. */
  void settle();
}
