package org.selectiverenderer.enricher.component;

import java.awt.event.KeyEvent;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.table.TableModel;

/**
 * A table in which the shortcuts of menus do not start to edit a cell. Any key starts that in a
 * {@link JTable}, before the menus get it.
 */
@SuppressWarnings("serial") // never written
public class ShortcutTable extends JTable {
  private static final long serialVersionUID = 1L;

  private static final String STARTS = "JTable.autoStartsEdit"; // named in JTable's Javadoc

  public ShortcutTable(TableModel model) {
    super(model);
  }

  @Override
  protected boolean processKeyBinding(
      KeyStroke stroke, KeyEvent event, int condition, boolean pressed) {
    if (!shortcut(event)) {
      return super.processKeyBinding(stroke, event, condition, pressed);
    }
    if (event.getID() == KeyEvent.KEY_TYPED) {
      return false; // the character that comes with it on some systems
    }
    Object before = getClientProperty(STARTS);
    putClientProperty(STARTS, false);
    try {
      return super.processKeyBinding(stroke, event, condition, pressed);
    } finally {
      putClientProperty(STARTS, before);
    }
  }

  /** Returns whether a key is one of commands, not of text; AltGr is Ctrl and Alt on Windows. */
  private static boolean shortcut(KeyEvent event) {
    boolean either = event.isControlDown() != event.isAltDown() && !event.isAltGraphDown();
    return either || event.isMetaDown() || event.isActionKey();
  }
}
