package org.selectiverenderer.enricher;

import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.KeyStroke;
import org.selectiverenderer.enricher.text.MnemonicText;

/** A menu action with a mnemonic letter and an accelerator key. */
final class MenuAction extends AbstractAction {
  private static final long serialVersionUID = 1L;

  private final transient Runnable work;

  /**
   * @param name the text of the menu item, with {@code &} before its mnemonic letter
   * @param key the accelerator as {@link KeyStroke#getKeyStroke(String)} reads it; empty for none
   */
  MenuAction(String name, String key, Runnable work) {
    this.work = work;
    MnemonicText title = MnemonicText.of(name);
    putValue(NAME, title.words());
    if (title.letter() != KeyEvent.VK_UNDEFINED) {
      putValue(MNEMONIC_KEY, title.letter());
    }
    if (!key.isEmpty()) {
      putValue(ACCELERATOR_KEY, KeyStroke.getKeyStroke(key));
    }
  }

  @Override
  public void actionPerformed(ActionEvent e) {
    work.run();
  }

  /** Gives the menu item another name. */
  void rename(String name) {
    putValue(Action.NAME, MnemonicText.of(name).words());
  }
}
