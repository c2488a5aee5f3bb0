package org.selectiverenderer.enricher.problems;

import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.DocumentCheck;
import org.selectiverenderer.authoring.ElementFinding;
import org.selectiverenderer.authoring.editing.FindingSuppression;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The list of the scene's problems, updated live. A click or Enter goes to the place; Alt+Enter or
 * the button applies a known fix. Buttons with the counts filter by severity.
 *
 * <p>For the event dispatch thread.
 */
public final class ProblemsPanel extends JPanel {
  private static final long serialVersionUID = 1L;

  private final transient EnricherSession session;
  private final transient ProblemsModel model;
  private final transient ProblemsUpdater feed;
  private final ProblemsTableModel rows;
  private final JTable table;
  private final JButton fix = Mnemonics.button("problems.fix");
  private final JButton ignore = Mnemonics.button("problems.ignore");
  private final JLabel checking = new JLabel(" ");
  private boolean busy;

  /** Shows how many objects and areas are not enriched yet. */
  private final JLabel left = new JLabel(" ");

  private final Map<Severity, JToggleButton> filters = new EnumMap<>(Severity.class);
  private final transient Action goTo = action(Texts.of("problems.goto"), this::visit);
  private final transient Action mend = action(Texts.of("problems.fixes"), this::fix);
  private final transient Action accept =
      action(Mnemonics.without(Texts.of("problems.ignore")), this::ignore);
  private transient Consumer<ProblemCounts> onCounts = counts -> {};
  private transient Consumer<SourceLocation> onElsewhere = place -> {};
  private transient Consumer<Optional<String>> onExplain = rule -> {};
  private transient IntConsumer onPlace = offset -> {};
  private transient Runnable onEntries = () -> {};

  /**
   * @param checks checks that run in the background after each pause in editing
   */
  public ProblemsPanel(EnricherSession session, List<DocumentCheck> checks) {
    super(new MigLayout("insets 0, gap 0, wrap 1", "[grow,fill]", "[][grow,fill]"));
    this.session = session;
    model = new ProblemsModel(session.document(), session.enrichment());
    rows = new ProblemsTableModel(session.document());
    table = new ProblemsTable(rows);
    JPanel bar = new JPanel(new MigLayout("insets 2 6 2 6", "[][][][]push[][][]"));
    for (Severity severity : Severity.values()) {
      bar.add(filter(severity));
    }
    left.setName("unenriched");
    left.setEnabled(false);
    left.setToolTipText(Texts.of("counts.unenrichedtip"));
    bar.add(left, "gapbefore 12");
    checking.setEnabled(false);
    checking.getAccessibleContext().setAccessibleName(Texts.of("problems.state"));
    bar.add(checking);

    fix.setEnabled(false);
    fix.addActionListener(mend);
    bar.add(fix);
    ignore.setEnabled(false);
    ignore.setToolTipText(Texts.of("problems.ignoretip"));
    ignore.addActionListener(event -> ignore());
    bar.add(ignore);
    JScrollPane scroll = new JScrollPane(table);
    scroll
        .getVerticalScrollBar()
        .getAccessibleContext()
        .setAccessibleName(Texts.of("problems.scroll"));
    add(bar);
    add(scroll, "wmin 0, hmin 0");
    getAccessibleContext().setAccessibleName(Texts.of("problems.panel"));
    keys();
    feed = new ProblemsUpdater(session, model, checks, this::refreshed, this::checking);
    feed.begin();
  }

  private JToggleButton filter(Severity severity) {
    JToggleButton button = new JToggleButton(new SeverityIcon(severity), true);
    button.setMnemonic(
        switch (severity) {
          case ERROR -> 'R';
          case WARNING -> 'W';
          case INFO -> 'O';
        });
    button.setToolTipText(Texts.of("problems.filter"));
    button.addActionListener(event -> rows.show(severity, button.isSelected()));
    filters.put(severity, button);
    return button;
  }

  private void keys() {
    table.getSelectionModel().setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    table.getSelectionModel().addListSelectionListener(event -> chosen());
    key("ENTER", "goTo", goTo);
    key("alt ENTER", "fix", mend);
    Action explain = action(Texts.of("problems.explain"), this::explain);
    key("F1", "explain", explain);
    Action copy = action(Texts.of("node.textCopy"), this::copy);
    key("ctrl C", "copyProblem", copy);
    JPopupMenu menu = new JPopupMenu(Texts.of("problems.problem"));
    menu.add(goTo);
    menu.add(mend);
    menu.add(accept);
    menu.add(copy);
    menu.add(explain);
    table.setComponentPopupMenu(menu);
    table.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mousePressed(MouseEvent event) {
            int row = table.rowAtPoint(event.getPoint());
            if (event.isPopupTrigger() && row >= 0) {
              table.setRowSelectionInterval(row, row);
            }
          }

          @Override
          public void mouseClicked(MouseEvent event) {
            if (event.getButton() == MouseEvent.BUTTON1
                && table.rowAtPoint(event.getPoint()) >= 0) {
              if (event.getClickCount() == 2) {
                visit();
              } else {
                go();
              }
            }
          }
        });
  }

  private void key(String stroke, String name, Action action) {
    table.getInputMap(WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke(stroke), name);
    table.getActionMap().put(name, action);
  }

  private static Action action(String name, Runnable does) {
    return new AbstractAction(name) {
      private static final long serialVersionUID = 1L;

      @Override
      public void actionPerformed(ActionEvent event) {
        does.run();
      }
    };
  }

  /** Sets the listener of the counts, which is called now and whenever they may have changed. */
  public void onCounts(Consumer<ProblemCounts> listener) {
    onCounts = listener;
    listener.accept(model.counts(busy));
  }

  /** Sets the listener of the problems, which is called now and whenever they may have changed. */
  public void onEntries(Runnable listener) {
    onEntries = listener;
    listener.run();
  }

  /** Returns the problems of a node, with those of its metadata, in document order. */
  public List<ElementFinding> about(DocumentElement node) {
    return model.about(node);
  }

  /** Sets what shows the offset of a problem in the text, after its element is selected. */
  public void onPlace(IntConsumer listener) {
    onPlace = listener;
  }

  /** Sets what opens the place of a problem in another file. */
  public void onElsewhere(Consumer<SourceLocation> listener) {
    onElsewhere = listener;
  }

  /**
   * Sets what explains the validator rule of a problem; called with empty where the problem names
   * none.
   */
  public void onExplain(Consumer<Optional<String>> listener) {
    onExplain = listener;
  }

  /** Whether there is an error or a warning about the element itself. */
  public boolean faulty(DocumentElement element) {
    return model.faulty(element);
  }

  private Optional<ProblemEntry> chosenEntry() {
    int row = table.getSelectedRow();
    return row < 0 || row >= rows.getRowCount() ? Optional.empty() : Optional.of(rows.row(row));
  }

  private void chosen() {
    Optional<ElementFinding.Fix> found = chosenEntry().flatMap(ProblemEntry::fix);
    fix.setText(found.map(ElementFinding.Fix::name).orElse(Texts.of("problems.fixes")));
    fix.setEnabled(found.isPresent());
    mend.setEnabled(found.isPresent());
    boolean ignorable =
        chosenEntry()
            .filter(entry -> entry.rule().isPresent() && entry.element().isPresent())
            .isPresent();
    ignore.setEnabled(ignorable);
    accept.setEnabled(ignorable);
    goTo.setEnabled(
        chosenEntry()
            .filter(entry -> entry.offset().isPresent() || entry.otherFile().isPresent())
            .isPresent());
  }

  /** Goes to the place of the selected problem. */
  public void go() {
    chosenEntry()
        .filter(ProblemEntry::current)
        .ifPresent(
            entry -> {
              entry.element().ifPresent(element -> session.select(element, this));
              entry.offset().ifPresent(onPlace::accept);
            });
  }

  /** Goes to the place of the selected problem, also in another file. */
  private void visit() {
    chosenEntry()
        .flatMap(ProblemEntry::otherFile)
        .ifPresentOrElse(other -> onElsewhere.accept(other), this::go);
  }

  private void explain() {
    onExplain.accept(chosenEntry().flatMap(ProblemEntry::rule));
  }

  /** Applies the fix of the selected problem, if it has one. */
  public void fix() {
    chosenEntry()
        .flatMap(ProblemEntry::fix)
        .ifPresent(found -> session.attempt(() -> session.perform(found.edit().get())));
  }

  /** Suppresses the rule of the selected problem for its element, in the scene itself. */
  private void ignore() {
    chosenEntry()
        .ifPresent(
            entry ->
                entry
                    .element()
                    .filter(DocumentElement::attached)
                    .ifPresent(
                        element ->
                            entry
                                .rule()
                                .ifPresent(
                                    rule ->
                                        session.attempt(
                                            () ->
                                                session.perform(
                                                    new FindingSuppression(session.document())
                                                        .suppress(rule, element))))));
  }

  /** Goes to the next problem; after the last to the first. */
  public void next() {
    step(+1);
  }

  /** Goes to the previous problem; before the first to the last. */
  public void previous() {
    step(-1);
  }

  private void step(int by) {
    int count = rows.getRowCount();
    if (count > 0) {
      int from = table.getSelectedRow();
      int row = from < 0 ? (by > 0 ? 0 : count - 1) : Math.floorMod(from + by, count);
      table.setRowSelectionInterval(row, row);
      table.scrollRectToVisible(table.getCellRect(row, 0, true));
      go();
    }
  }

  private void copy() {
    chosenEntry()
        .ifPresent(
            entry ->
                Toolkit.getDefaultToolkit()
                    .getSystemClipboard()
                    .setContents(
                        new StringSelection(
                            entry.location(session.document()) + ": " + entry.message()),
                        null));
  }

  private void checking(boolean now) {
    busy = now;
    checking.setText(now ? Texts.of("problems.checking") : " ");
    onCounts.accept(model.counts(now));
  }

  private void refreshed() {
    Optional<ProblemEntry> before = chosenEntry();
    rows.entries(model.entries());
    for (int row = 0; before.isPresent() && row < rows.getRowCount(); row++) {
      if (rows.row(row).repeats(before.get())) {
        table.setRowSelectionInterval(row, row);
        break;
      }
    }
    ProblemCounts counts = model.counts(busy);
    filters.forEach(
        (severity, button) -> {
          button.setText(counts.words(severity));
          button
              .getAccessibleContext()
              .setAccessibleName(Texts.of("counts.show", counts.words(severity)));
        });
    left.setText(counts.left().orElse(" "));
    left.getAccessibleContext()
        .setAccessibleName(counts.left().orElseGet(() -> Texts.of("counts.allenriched")));
    chosen();
    onCounts.accept(counts);
    onEntries.run();
  }

  /** Checks again, as the validator's settings have changed, though the document has not. */
  public void checkAgain() {
    feed.check();
  }

  /** Ends its checks. */
  public void dispose() {
    feed.dispose();
  }
}
