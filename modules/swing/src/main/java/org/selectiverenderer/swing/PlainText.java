package org.selectiverenderer.swing;

import java.util.regex.Pattern;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JTable;
import javax.swing.table.TableCellRenderer;

/**
 * Has Swing show texts of scenes, studies and names of files letter by letter. Labels, buttons,
 * menus, tips and cells take a text that begins with {@code <html>} for HTML, and would load the
 * pictures in it from wherever it says.
 */
public final class PlainText {
  /** At the start of any line, since option panes make a label of each. */
  private static final Pattern HTML = Pattern.compile("(?im)^(?=<html>)");

  private static final String ZERO_WIDTH_SPACE = "\u200b";

  private static final String DISABLE = "html.disable"; // named in JComponent's Javadoc

  private PlainText() {}

  /** Returns a text that looks the same and is no HTML. */
  public static String of(String text) {
    return text.length() < 6 ? text : HTML.matcher(text).replaceAll(ZERO_WIDTH_SPACE);
  }

  /**
   * Has a component take no text for HTML, whatever text it is given. Its tips are not included.
   */
  public static <C extends JComponent> C only(C component) {
    component.putClientProperty(DISABLE, true);
    return component;
  }

  /** Has the cells and heads of a table without renderers of its own take no text for HTML. */
  public static void cells(JTable table) {
    only(table.getDefaultRenderer(Object.class));
    only(table.getDefaultRenderer(Number.class));
    only(table.getTableHeader().getDefaultRenderer());
  }

  private static void only(TableCellRenderer renderer) {
    if (renderer instanceof JComponent component) {
      only(component);
    }
  }

  /** Has the entries of a list take no text for HTML. */
  public static <L extends JList<?>> L entries(L list) {
    list.setCellRenderer(only(new DefaultListCellRenderer()));
    return list;
  }

  /** Has the entries of a combo box take no text for HTML. */
  public static <B extends JComboBox<?>> B entries(B box) {
    box.setRenderer(only(new DefaultListCellRenderer()));
    return box;
  }
}
