package org.selectiverenderer.enricher.diff;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.Window;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.table.AbstractTableModel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.file.ThreeWayMerge;
import org.selectiverenderer.authoring.file.ThreeWayMerge.Choice;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.WindowPacker;
import org.selectiverenderer.x3d.source.DocumentError;

/**
 * Shows the document and its changed file side by side, marks which lines of both are taken, and
 * lets the author decide where both have changed the same lines.
 */
@SuppressWarnings("serial") // never written
public final class MergeDialog extends JDialog {
  private static final long serialVersionUID = 1L;

  private final ThreeWayMerge merge;
  private final MergeRows rows;
  private final JTable table;
  private final JLabel summary = new JLabel();
  private final JButton next = new JButton(Texts.of("merge.next"));
  private final JButton apply = new JButton(Texts.of("merge.apply"));
  private final Map<Choice, JButton> deciding = new EnumMap<>(Choice.class);
  private boolean confirmed;
  private boolean warned;

  public MergeDialog(Window owner, ThreeWayMerge merge) {
    super(owner, Texts.of("merge.title"), ModalityType.DOCUMENT_MODAL);
    this.merge = merge;
    this.rows = new MergeRows(merge);
    this.table = table();
    setDefaultCloseOperation(DISPOSE_ON_CLOSE);
    JPanel content =
        new JPanel(new MigLayout("insets dialog, fill", "[grow,fill]", "[][grow,fill][][]"));
    content.add(summary, "wmin 0, wrap");
    JScrollPane scrolling = new JScrollPane(table);
    int line = table.getRowHeight();
    scrolling.setPreferredSize(new Dimension(56 * line, 26 * line));
    content.add(scrolling, "grow, wrap");
    content.add(decisions(), "wrap");
    content.add(buttons());
    summary.setName("Merge summary");
    setContentPane(content);
    getRootPane()
        .registerKeyboardAction(
            e -> dispose(), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_IN_FOCUSED_WINDOW);
    getRootPane()
        .registerKeyboardAction(
            e -> next(), KeyStroke.getKeyStroke("F3"), JComponent.WHEN_IN_FOCUSED_WINDOW);
    next();
    refresh();
    WindowPacker.pack(this);
    setLocationRelativeTo(owner);
  }

  private JTable table() {
    JTable made = new JTable(new Lines());
    made.setName("Merge");
    made.getAccessibleContext().setAccessibleName(Texts.of("merge.table"));
    made.setFont(new Font(Font.MONOSPACED, Font.PLAIN, made.getFont().getSize()));
    made.setDefaultRenderer(
        Object.class,
        new MergeLineRenderer(
            rows, conflict -> selected().filter(row -> row.conflict() == conflict).isPresent()));
    made.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    made.setShowGrid(false);
    made.setIntercellSpacing(new Dimension(1, 0));
    made.setRowHeight(made.getFontMetrics(made.getFont()).getHeight() + 1);
    made.getTableHeader().setReorderingAllowed(false);
    made.getSelectionModel().addListSelectionListener(e -> refresh());
    return made;
  }

  private JPanel decisions() {
    JPanel panel = new JPanel(new MigLayout("insets 0", "[][][][]unrel[]"));
    char[] letters = {'H', 'D', 'A', 'B'};
    for (Choice choice : Choice.values()) {
      JButton button = new JButton(Texts.of(text(choice)));
      button.setName(choice.name());
      button.setMnemonic(letters[choice.ordinal()]);
      button.addActionListener(e -> decide(choice));
      deciding.put(choice, button);
      panel.add(button);
    }
    next.setName("Next conflict");
    next.setMnemonic('N');
    next.setToolTipText("F3");
    next.addActionListener(e -> next());
    panel.add(next);
    return panel;
  }

  private static String text(Choice choice) {
    return switch (choice) {
      case MINE -> "merge.mine";
      case THEIRS -> "merge.theirs";
      case MINE_FIRST -> "merge.mine.first";
      case THEIRS_FIRST -> "merge.theirs.first";
    };
  }

  private JPanel buttons() {
    JPanel panel = new JPanel(new MigLayout("insets 0, fillx", "push[][]"));
    JButton cancel = new JButton(Texts.of("keep.cancel"));
    cancel.addActionListener(e -> dispose());
    apply.setName("Merge all");
    apply.setMnemonic('M');
    apply.addActionListener(e -> confirm());
    panel.add(apply, "tag ok");
    panel.add(cancel, "tag cancel");
    return panel;
  }

  private Optional<MergeRows.Row> selected() {
    int row = table.getSelectedRow();
    return row < 0
        ? Optional.empty()
        : Optional.of(rows.rows().get(row)).filter(each -> each.conflict() >= 0);
  }

  private void decide(Choice choice) {
    selected()
        .ifPresent(
            row -> {
              rows.decide(row.conflict(), choice);
              warned = false;
              table.repaint();
              if (rows.undecided() > 0) {
                next();
              }
              refresh();
            });
  }

  private void next() {
    int row = rows.next(table.getSelectedRow());
    if (row >= 0) {
      table.setRowSelectionInterval(row, row);
      table.scrollRectToVisible(table.getCellRect(Math.max(0, row - 3), 0, true));
      table.scrollRectToVisible(table.getCellRect(row, 0, true));
    }
  }

  private void refresh() {
    boolean conflict = selected().isPresent();
    deciding.values().forEach(button -> button.setEnabled(conflict));
    next.setEnabled(rows.conflicts() > 0);
    apply.setEnabled(rows.undecided() == 0);
    int theirs = merge.count(ThreeWayMerge.Kind.THEIRS);
    int mine = merge.count(ThreeWayMerge.Kind.MINE);
    summary.setText(
        Texts.of(
            "merge.summary",
            DecimalFormatter.grouped(mine),
            DecimalFormatter.grouped(theirs),
            DecimalFormatter.grouped(rows.conflicts()),
            DecimalFormatter.grouped(rows.undecided())));
  }

  /** Confirms the merge; warns first if the result is not well-formed XML. */
  private void confirm() {
    Optional<DocumentError> fault = fault();
    if (fault.isPresent() && !warned) {
      warned = true;
      summary.setText(
          Texts.of(
              "merge.faulty",
              String.valueOf(fault.get().location().line()),
              fault.get().message()));
      return;
    }
    confirmed = true;
    dispose();
  }

  private Optional<DocumentError> fault() {
    try {
      return SceneDocument.of("", rows.text().getBytes(StandardCharsets.UTF_8)).fault();
    } catch (IOException e) {
      throw new IllegalStateException("a text that is not compressed can be read", e);
    }
  }

  /** Shows the dialog, waits, and returns the decisions; empty if the author cancels. */
  public Optional<List<Choice>> decided() {
    setVisible(true);
    return choices();
  }

  /** The decisions; empty if the author has not confirmed them. */
  Optional<List<Choice>> choices() {
    return confirmed ? Optional.of(rows.choices()) : Optional.empty();
  }

  private final class Lines extends AbstractTableModel {
    private static final long serialVersionUID = 1L;

    @Override
    public int getRowCount() {
      return rows.rows().size();
    }

    @Override
    public int getColumnCount() {
      return 2;
    }

    @Override
    public String getColumnName(int column) {
      return Texts.of(column == 0 ? "merge.here" : "merge.there");
    }

    @Override
    public Object getValueAt(int row, int column) {
      MergeRows.Row line = rows.rows().get(row);
      return column == 0 ? line.mine() : line.theirs();
    }
  }
}
