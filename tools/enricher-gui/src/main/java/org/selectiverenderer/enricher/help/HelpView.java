package org.selectiverenderer.enricher.help;

import javax.swing.JComponent;
import javax.swing.JEditorPane;
import javax.swing.JScrollPane;

/** The help as a part of the window. */
public final class HelpView {
  private HelpView() {}

  public static JComponent create() {
    JEditorPane page = new JEditorPane("text/html", HelpTexts.page());
    page.putClientProperty(JEditorPane.HONOR_DISPLAY_PROPERTIES, true);
    page.setEditable(false);
    page.setCaretPosition(0);
    page.getAccessibleContext().setAccessibleName("Help");
    JScrollPane scroll = new JScrollPane(page);
    scroll.getVerticalScrollBar().getAccessibleContext().setAccessibleName("Scroll the help");
    scroll.getHorizontalScrollBar().getAccessibleContext().setAccessibleName("Scroll the help");
    return scroll;
  }
}
