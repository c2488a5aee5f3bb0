package org.selectiverenderer.enricher.overview;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.DefaultListCellRenderer;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ListSelectionModel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.ElementFinding;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Lists the schemas that no area activates or no object belongs to, with buttons that show and fix
 * each.
 */
@SuppressWarnings("serial") // never written
final class SchemaFindingsPanel extends JPanel {
  private static final long serialVersionUID = 1L;

  private final DefaultListModel<ElementFinding> found = new DefaultListModel<>();
  private final JList<ElementFinding> list = new JList<>(found);
  private final JButton fix = PlainText.only(Mnemonics.button("overview.fix"));
  private final JButton show = Mnemonics.button("overview.show");

  SchemaFindingsPanel(Consumer<DocumentElement> select, Consumer<Supplier<Edit>> make) {
    super(new MigLayout("insets 0, fill, hidemode 3", "[grow,fill][]", "[][]"));
    list.setVisibleRowCount(3);
    list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    list.getAccessibleContext().setAccessibleName(Texts.of("overview.findings"));
    list.setCellRenderer(
        new DefaultListCellRenderer() {
          private static final long serialVersionUID = 1L;

          {
            PlainText.only(this);
          }

          @Override
          public java.awt.Component getListCellRendererComponent(
              JList<?> of, Object value, int index, boolean selected, boolean focused) {
            String text =
                value instanceof ElementFinding finding ? "\u26a0 " + finding.message() : "";
            return super.getListCellRendererComponent(of, text, index, selected, focused);
          }
        });
    list.addListSelectionListener(e -> enableButtons());

    show.setToolTipText(Texts.of("overview.show.tip"));
    show.addActionListener(e -> select.accept(list.getSelectedValue().element()));

    fix.addActionListener(e -> list.getSelectedValue().fix().ifPresent(f -> make.accept(f.edit())));
    JLabel label = new JLabel(Texts.of("overview.findings"));
    label.setLabelFor(list);
    add(label, "span, wrap");
    add(new JScrollPane(list), "spany 2, grow");
    add(fix, "growx, wrap");
    add(show, "growx, top");
    enableButtons();
  }

  void show(List<ElementFinding> findings) {
    int selected = Math.max(0, list.getSelectedIndex());
    found.clear();
    found.addAll(findings);
    list.setSelectedIndex(Math.min(selected, findings.size() - 1));
    setVisible(!findings.isEmpty());
    enableButtons();
  }

  private void enableButtons() {
    ElementFinding finding = list.getSelectedValue();
    show.setEnabled(finding != null);
    fix.setEnabled(finding != null && finding.fix().isPresent());
    fix.setText(
        finding == null
            ? Mnemonics.without(Texts.of("overview.fix"))
            : finding.fix().map(ElementFinding.Fix::name).orElse(Texts.of("overview.nofix")));
  }
}
