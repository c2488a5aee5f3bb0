package org.selectiverenderer.swing;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.util.List;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JTable;
import javax.swing.JToolTip;
import javax.swing.plaf.basic.BasicHTML;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PlainTextTest {
  private static final String HOSTILE = "<html><img src='http://192.0.2.1/seen.png'>desk";

  private static boolean isHtml(Component component) {
    return ((JComponent) component).getClientProperty(BasicHTML.propertyKey) != null;
  }

  @ParameterizedTest
  @ValueSource(strings = {HOSTILE, "<HTML>a", "<html>"})
  void htmlIsShownAsItsLetters(String text) {
    JToolTip tip = new JToolTip();
    tip.setTipText(PlainText.of(text));

    assertThat(isHtml(new JLabel(text))).isTrue(); // what Swing does otherwise
    assertThat(isHtml(new JLabel(PlainText.of(text)))).isFalse();
    assertThat(isHtml(tip)).isFalse();
    assertThat(PlainText.of(text)).endsWith(text).hasSize(text.length() + 1);
  }

  @Test
  void otherTextStays() {
    for (String text : List.of("", "desk", "a <html> b", "<htm", "a\nb")) {
      assertThat(PlainText.of(text)).isEqualTo(text);
    }
    assertThat(PlainText.of("a\n<html>b")).isEqualTo("a\n\u200b<html>b");
  }

  @Test
  void cellsEntriesAndHeadsShowLetters() {
    JTable table = new JTable(new Object[][] {{HOSTILE, HOSTILE}}, new Object[] {HOSTILE, "b"});
    PlainText.cells(table);
    JList<String> list = PlainText.entries(new JList<>(new String[] {HOSTILE}));
    JComboBox<String> box = PlainText.entries(new JComboBox<>(new String[] {HOSTILE}));
    JList<String> popup = new JList<>(box.getModel());

    assertThat(isHtml(table.prepareRenderer(table.getCellRenderer(0, 0), 0, 0))).isFalse();
    assertThat(
            isHtml(
                table
                    .getTableHeader()
                    .getDefaultRenderer()
                    .getTableCellRendererComponent(table, HOSTILE, false, false, -1, 0)))
        .isFalse();
    assertThat(
            isHtml(
                list.getCellRenderer()
                    .getListCellRendererComponent(list, HOSTILE, 0, false, false)))
        .isFalse();
    assertThat(
            isHtml(box.getRenderer().getListCellRendererComponent(popup, HOSTILE, 0, false, false)))
        .isFalse();
  }
}
