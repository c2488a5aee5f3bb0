package org.selectiverenderer.enricher.source;

import java.awt.Component;
import java.util.function.Consumer;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.selectiverenderer.enricher.text.Texts;

/** The context menu of the source, rebuilt each time it shows. */
final class SourceContextMenu extends JPopupMenu {
  private static final long serialVersionUID = 1L;

  private final transient RSyntaxTextArea area;
  private final transient Runnable atCaret;
  private final transient Consumer<JPopupMenu> node;

  /**
   * @param atCaret selects the element at the caret
   * @param node appends the commands for that element
   */
  SourceContextMenu(RSyntaxTextArea area, Runnable atCaret, Consumer<JPopupMenu> node) {
    this.area = area;
    this.atCaret = atCaret;
    this.node = node;
    setName("sourceMenu");
  }

  @Override
  public void show(Component over, int x, int y) {
    atCaret.run();
    removeAll();
    boolean some = area.getSelectionStart() < area.getSelectionEnd();
    add("node.textCut", "textCut", some && area.isEditable(), area::cut);
    add("node.textCopy", "textCopy", some, area::copy);
    add("node.textPaste", "textPaste", area.isEditable(), area::paste);
    node.accept(this);
    super.show(over, x, y);
  }

  private void add(String text, String name, boolean enabled, Runnable work) {
    JMenuItem item = new JMenuItem(Texts.of(text));
    item.setName(name);
    item.setEnabled(enabled);
    item.addActionListener(event -> work.run());
    add(item);
  }
}
