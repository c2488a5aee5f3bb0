package org.selectiverenderer.enricher.preview;

import java.awt.Component;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;

/**
 * A popup with a check box for each schema, to simulate a set of active schemas. The order of
 * checking is the order of entering: a schema checked later overrules earlier ones.
 */
final class SchemaSimulatorPopup {
  private final Supplier<List<String>> known;
  private final Consumer<List<String>> chosen;
  private final List<String> checked = new ArrayList<>();

  /**
   * @param known the schemas of the scene
   * @param chosen called with the checked schemas, in the order of checking
   */
  SchemaSimulatorPopup(Supplier<List<String>> known, Consumer<List<String>> chosen) {
    this.known = known;
    this.chosen = chosen;
  }

  List<String> checked() {
    return List.copyOf(checked);
  }

  void choose(List<String> schemas) {
    checked.clear();
    checked.addAll(schemas);
    chosen.accept(checked());
  }

  /** Forgets schemas that the scene no longer has. */
  void follow() {
    if (checked.retainAll(known.get())) {
      chosen.accept(checked());
    }
  }

  JPopupMenu popup() {
    JPopupMenu popup = new JPopupMenu();
    popup.getAccessibleContext().setAccessibleName(Texts.of("preview.asif.popup"));
    JPanel boxes = new JPanel(new MigLayout("insets 8, wrap 1, gapy 2"));
    List<JCheckBox> all = new ArrayList<>();
    for (String schema : known.get()) {
      JCheckBox box = new JCheckBox(PlainText.of(schema), checked.contains(schema));
      box.addActionListener(
          event -> {
            checked.remove(schema);
            if (box.isSelected()) {
              checked.add(schema);
            }
            chosen.accept(checked());
          });
      all.add(box);
      boxes.add(box);
    }
    if (all.isEmpty()) {
      boxes.add(new JLabel(Texts.of("preview.asif.empty")));
    }
    JButton none = new JButton(Texts.of("preview.asif.none"));
    none.setToolTipText(Texts.of("preview.asif.none.tip"));
    none.addActionListener(
        event -> {
          all.forEach(box -> box.setSelected(false));
          choose(List.of());
        });
    JScrollPane scroll = new JScrollPane(boxes);
    scroll.setBorder(null);
    Dimension size = scroll.getPreferredSize();
    int most = none.getPreferredSize().height * 14;
    scroll.setPreferredSize(
        new Dimension(
            size.width + scroll.getVerticalScrollBar().getPreferredSize().width,
            Math.min(size.height, most)));
    JPanel content = new JPanel(new MigLayout("insets 0, wrap 1", "[grow,fill]"));
    content.add(scroll);
    content.add(none, "gapleft 8, gapright 8, gapbottom 6");
    popup.add(content);
    return popup;
  }

  void show(Component under) {
    JPopupMenu popup = popup();
    popup.show(under, 0, under.getHeight());
  }
}
