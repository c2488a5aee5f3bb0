package org.selectiverenderer.enricher.problems;

import java.awt.Component;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.function.IntConsumer;
import javax.swing.DefaultListCellRenderer;
import javax.swing.DefaultListModel;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.x3d.Location;

/** The bottom of the window: problems, each a click away from its place. */
public final class ProblemsPanel {
  private final EnricherSession session;
  private final ProblemList problems;
  private final IntConsumer reveal;
  private final DefaultListModel<ProblemList.Entry> model = new DefaultListModel<>();
  private final JList<ProblemList.Entry> list = new JList<>(model);
  private final JLabel title = new JLabel();
  private final JButton fix = new JButton("Mend");
  private final JPanel panel =
      new JPanel(new MigLayout("insets 6, gap 4, fill", "[grow]", "[][grow]"));

  /**
   * @param reveal brings an offset of the text into view
   */
  public ProblemsPanel(EnricherSession session, ProblemList problems, IntConsumer reveal) {
    this.session = session;
    this.problems = problems;
    this.reveal = reveal;
    list.setCellRenderer(new Row());
    list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    list.getAccessibleContext().setAccessibleName("Problems");
    list.addListSelectionListener(event -> selected());
    list.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent e) {
            go();
          }
        });
    list.registerKeyboardAction(
        event -> go(), KeyStroke.getKeyStroke("ENTER"), JPanel.WHEN_FOCUSED);
    fix.addActionListener(event -> fix());
    title.getAccessibleContext().setAccessibleName("Number of problems");
    JPanel head = new JPanel(new MigLayout("insets 0, hidemode 3", "[grow][]", "[26!]"));
    head.add(title, "growx, wmin 0");
    head.add(fix, "h 26!");
    panel.add(head, "growx, wrap");
    JScrollPane scroll = new JScrollPane(list);
    scroll.getVerticalScrollBar().getAccessibleContext().setAccessibleName("Scroll the problems");
    scroll.getHorizontalScrollBar().getAccessibleContext().setAccessibleName("Scroll the problems");
    panel.add(scroll, "grow, wmin 0, hmin 0");
    problems.addListener(this::refresh);
    refresh();
  }

  private static final class Row extends DefaultListCellRenderer {
    private static final long serialVersionUID = 1L;

    @Override
    public Component getListCellRendererComponent(
        JList<?> list, Object value, int index, boolean selected, boolean focused) {
      super.getListCellRendererComponent(list, value, index, selected, focused);
      if (value instanceof ProblemList.Entry entry) {
        Icon icon = new SeverityIcon(entry.problem().severity());
        setIcon(icon);
        Location at = entry.problem().location();
        String place = at.line() > 0 ? "  (line %d)".formatted(at.line()) : "";
        String message = entry.problem().message();
        setText(message + place);
        setToolTipText("<html><body width=360>" + message.replace("<", "&lt;"));
      }
      return this;
    }
  }

  public JPanel component() {
    return panel;
  }

  public JList<ProblemList.Entry> list() {
    return list;
  }

  private void refresh() {
    int before = list.getSelectedIndex();
    model.clear();
    model.addAll(problems.entries());
    int count = model.size();
    title.setText(count == 0 ? "No problems" : count == 1 ? "1 problem" : count + " problems");
    if (before >= 0 && before < count) {
      list.setSelectedIndex(before);
    }
    selected();
  }

  private void selected() {
    ProblemList.Entry entry = list.getSelectedValue();
    fix.setVisible(entry != null && entry.fix().isPresent());
    if (entry != null) {
      entry.fix().ifPresent(found -> fix.setText(found.name()));
    }
  }

  /** Goes to the place of the selected problem. */
  public void go() {
    ProblemList.Entry entry = list.getSelectedValue();
    if (entry == null) {
      return;
    }
    Location at = entry.problem().location();
    entry.element().ifPresent(element -> session.select(element, this));
    if (entry.element().isEmpty() && at.file().equals(session.document().name()) && at.line() > 0) {
      reveal.accept(session.document().offset(at.line(), Math.max(1, at.column())));
    }
  }

  /** Goes to the next problem, after the last to the first. */
  public void next() {
    if (!model.isEmpty()) {
      list.setSelectedIndex((list.getSelectedIndex() + 1) % model.size());
      list.ensureIndexIsVisible(list.getSelectedIndex());
      go();
    }
  }

  /** Mends the selected problem if its fix is known. */
  public void fix() {
    ProblemList.Entry entry = list.getSelectedValue();
    if (entry != null) {
      entry
          .fix()
          .ifPresent(
              found -> session.attempt(() -> session.document().perform(found.edit().get())));
    }
  }
}
