package org.selectiverenderer.enricher;

import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.KeyStroke;

/** Something the author can do from a menu or by a key. */
final class Command extends AbstractAction {
  private static final long serialVersionUID = 1L;

  private final transient Runnable work;

  /**
   * @param name as the menu shows it; {@code &} before the letter that chooses it
   * @param key as {@link KeyStroke#getKeyStroke(String)} reads it; empty for none
   */
  Command(String name, String key, Runnable work) {
    this.work = work;
    int letter = name.indexOf('&');
    putValue(NAME, name.replace("&", ""));
    if (letter >= 0) {
      putValue(MNEMONIC_KEY, KeyEvent.getExtendedKeyCodeForChar(name.charAt(letter + 1)));
    }
    if (!key.isEmpty()) {
      putValue(ACCELERATOR_KEY, KeyStroke.getKeyStroke(key));
    }
  }

  @Override
  public void actionPerformed(ActionEvent e) {
    work.run();
  }

  /** Shows another name. */
  void rename(String name) {
    putValue(Action.NAME, name.replace("&", ""));
  }
}
