package org.selectiverenderer.enricher.versions;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Window;
import java.io.IOException;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JScrollPane;
import javax.swing.JSpinner;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.SpinnerNumberModel;
import javax.swing.SwingUtilities;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.versions.BatchProgress;
import org.selectiverenderer.authoring.versions.BatchVersionsEdit;
import org.selectiverenderer.authoring.versions.PlannedFile;
import org.selectiverenderer.authoring.versions.VersionCandidate;
import org.selectiverenderer.authoring.versions.VersionCandidateFinder;
import org.selectiverenderer.authoring.versions.VersionsEdit;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.enricher.component.InitialFocus;
import org.selectiverenderer.enricher.component.ShortcutTable;
import org.selectiverenderer.enricher.component.TextChangeListener;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.task.BackgroundTask;
import org.selectiverenderer.enricher.task.TaskProgress;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.enricher.text.Remarks;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.swing.WindowPacker;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The dialog that makes versions of many objects: a table of the scene's pieces, or of what is
 * selected, in which the author ticks objects and sets names and goals; applying writes all files
 * and changes the scene as one undo step.
 */
@SuppressWarnings("serial") // never written
public final class BatchVersionsDialog extends JDialog {
  private static final long serialVersionUID = 1L;
  private static final String FOLDER = "inlineNodes";
  private static final int STEPS = 1000;

  private final EnricherSession session;
  private final List<DocumentElement> selected;
  private final BatchTableModel model = new BatchTableModel();
  private final JTable table = new ShortcutTable(model);
  private final JCheckBox only = new JCheckBox();
  private final JSpinner above =
      new JSpinner(new SpinnerNumberModel(VersionCandidateFinder.FEW, 0, 10_000_000, 100));
  private final JComboBox<BatchGoal.Kind> kind = new JComboBox<>(BatchGoal.Kind.values());
  private final JTextField goal = new JTextField(BatchGoal.Kind.PERCENT.usual(), 8);
  private final JProgressBar progress = new JProgressBar(0, STEPS);
  private final JLabel state = PlainText.only(new JLabel(" "));
  private final JList<String> problems = PlainText.entries(new JList<>());
  private final JScrollPane problemPane = new JScrollPane(problems);
  private final JButton stop = Mnemonics.button("versions.stop");
  private final JButton make = Mnemonics.button("manyversions.make");
  private final org.selectiverenderer.authoring.DocumentListener changes = change -> dispose();
  private List<VersionCandidate> found = List.of();
  private @Nullable BackgroundTask running;

  /** What is said in place of the number of objects, until the author does something. */
  private String notice = "";

  /** Creates the dialog; two or more selected elements are what it begins with. */
  public BatchVersionsDialog(Window owner, EnricherSession session) {
    super(owner, Texts.of("manyversions.title"), ModalityType.DOCUMENT_MODAL);
    this.session = session;
    this.selected = session.selectedElements();
    setDefaultCloseOperation(DISPOSE_ON_CLOSE);
    JPanel content =
        new JPanel(
            new MigLayout("insets dialog, fill, hidemode 3", "[grow,fill]", "[][grow,fill][][][]"));
    content.add(choice(), "wrap");
    content.add(table(), "grow, wrap");
    content.add(state, "wmin 0, wrap");
    content.add(problemPane, "wrap");
    content.add(buttons());
    state.getAccessibleContext().setAccessibleName(Texts.of("versions.result"));
    problems.setVisibleRowCount(3);
    problems.getAccessibleContext().setAccessibleName(Texts.of("versions.problems"));
    problemPane.setVisible(false);
    setContentPane(content);
    getRootPane().setDefaultButton(make);
    getRootPane()
        .registerKeyboardAction(
            e -> dispose(), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_IN_FOCUSED_WINDOW);
    session.document().addListener(changes);
    model.addTableModelListener(
        e -> {
          notice = "";
          refresh();
        });
    model.onRefused(this::say);
    WindowPacker.pack(this);
    setLocationRelativeTo(owner);
    search();
  }

  /** Shows the dialog and waits until it is closed. */
  public void showAndWait() {
    goal.selectAll();
    InitialFocus.show(this, goal);
  }

  private JPanel choice() {
    JPanel panel =
        new JPanel(new MigLayout("insets 0, hidemode 3", "[][]unrel[]unrel[][][]push[]"));
    JLabel aboveLabel = Mnemonics.label("manyversions.above");
    aboveLabel.setLabelFor(above);
    name(above, "manyversions.above.name");
    above.addChangeListener(e -> fill());
    Mnemonics.on(only, Texts.of("manyversions.selected", String.valueOf(selected.size())));
    only.setSelected(selected.size() > 1);
    only.setVisible(selected.size() > 1);
    only.addActionListener(e -> search());
    JLabel goalLabel = Mnemonics.label("manyversions.goal");
    goalLabel.setLabelFor(goal);
    name(goal, "manyversions.goal.name");
    goal.setToolTipText(Texts.of("manyversions.goal.tip"));
    goal.getDocument().addDocumentListener(new TextChangeListener(this::goalTyped));
    name(kind, "manyversions.kind");
    kind.addActionListener(e -> goal.setText(kind().usual()));
    JButton all = Mnemonics.button("manyversions.all");
    all.addActionListener(e -> model.choose(true));
    JButton none = Mnemonics.button("manyversions.none");
    none.addActionListener(e -> model.choose(false));
    panel.add(aboveLabel);
    panel.add(above);
    panel.add(only);
    panel.add(goalLabel);
    panel.add(goal);
    panel.add(kind);
    panel.add(all, "split 2");
    panel.add(none);
    return panel;
  }

  private static void name(JComponent component, String text) {
    component.getAccessibleContext().setAccessibleName(Texts.of(text));
  }

  private BatchGoal.Kind kind() {
    return kind.getItemAt(kind.getSelectedIndex());
  }

  private JScrollPane table() {
    PlainText.cells(table);
    name(table, "manyversions.table");
    table.setDefaultRenderer(Integer.class, new GroupedNumberRenderer());
    table.setFillsViewportHeight(true);
    table.setAutoCreateRowSorter(true);
    table.putClientProperty("terminateEditOnFocusLost", true);
    table.getTableHeader().setReorderingAllowed(false);
    int[] widths = {40, 200, 90, 80, 90, 420};
    for (int i = 0; i < widths.length; i++) {
      table.getColumnModel().getColumn(i).setPreferredWidth(UIScale.scale(widths[i]));
    }
    JScrollPane pane = new JScrollPane(table);
    pane.setPreferredSize(new Dimension(UIScale.scale(940), UIScale.scale(380)));
    return pane;
  }

  private JPanel buttons() {
    JPanel panel = new JPanel(new MigLayout("insets 0, fillx, hidemode 2", "[][]push[][]"));
    name(progress, "versions.progress");
    stop.addActionListener(e -> stop());
    JButton cancel = new JButton(Texts.of("keep.cancel"));
    cancel.addActionListener(e -> dispose());
    make.addActionListener(e -> make());
    panel.add(progress);
    panel.add(stop);
    panel.add(make, "tag ok");
    panel.add(cancel, "tag cancel");
    return panel;
  }

  private VersionsEdit.Request request() {
    return new VersionsEdit.Request(session.file().path(), "", List.of(), FOLDER)
        .allowing(session.access());
  }

  /** Runs work in the background and shows its progress. */
  private <T> void run(String task, TaskWork<T> work, Consumer<T> done) {
    stop();
    notice = "";
    progress.setValue(0);
    running =
        session
            .tasks()
            .run(
                task,
                progressOfTask -> work.run((share, name) -> tell(progressOfTask, share, name)),
                result -> {
                  running = null;
                  done.accept(result);
                  refresh();
                },
                failure -> {
                  running = null;
                  say(
                      failure.getMessage() == null
                          ? Texts.of("versions.failed", failure.toString())
                          : Remarks.of(failure));
                });
    refresh();
  }

  private interface TaskWork<T> {
    T run(BatchProgress progress) throws Exception;
  }

  private void tell(TaskProgress task, double share, String name) {
    task.check();
    task.done(share);
    SwingUtilities.invokeLater(
        () -> {
          progress.setValue((int) (share * STEPS));
          if (running != null && !name.isEmpty()) {
            state.setText(Texts.of("versions.task", name));
          }
        });
  }

  private void search() {
    DocumentSnapshot snapshot = session.document().snapshot();
    List<Integer> chosen =
        only.isSelected()
            ? selected.stream()
                .filter(DocumentElement::attached)
                .map(DocumentElement::start)
                .toList()
            : List.of();
    run(
        Texts.of("manyversions.searching"),
        told -> VersionCandidateFinder.find(snapshot, request(), chosen, session.catalogue(), told),
        objects -> {
          found = objects;
          fill();
        });
    state.setText(Texts.of("manyversions.searching"));
  }

  private void fill() {
    int fewest = only.isSelected() ? 0 : ((Number) above.getValue()).intValue();
    above.setEnabled(!only.isSelected());
    String typed = goal.getText().strip();
    boolean valid = BatchGoal.read(kind(), typed).valid();
    model.show(found, fewest, valid ? typed : kind().usual());
  }

  private void goalTyped() {
    String text = goal.getText().strip();
    BatchGoal read = BatchGoal.read(kind(), text);
    goal.putClientProperty("JComponent.outline", read.valid() ? null : "error");
    if (read.valid()) {
      model.goals(kind(), text);
    }
    say(read.fault());
  }

  /** Says a sentence in place of the number of objects; nothing for an empty one. */
  private void say(String sentence) {
    notice = sentence;
    refresh();
  }

  private void refresh() {
    boolean busy = running != null;
    progress.setVisible(busy);
    stop.setVisible(busy);
    int count = model.chosen().size();
    make.setEnabled(!busy && count > 0 && BatchGoal.read(kind(), goal.getText()).valid());
    if (!busy) {
      state.setText(
          notice.isEmpty()
              ? Texts.of(
                  "manyversions.count",
                  count,
                  DecimalFormatter.grouped(count),
                  DecimalFormatter.grouped(model.getRowCount()))
              : notice);
    }
  }

  private void stop() {
    if (running != null) {
      running.cancel();
      running = null;
      say(Texts.of("manyversions.stopped"));
    }
  }

  private void make() {
    if (table.isEditing()) {
      table.getCellEditor().stopCellEditing();
    }
    DocumentSnapshot snapshot = session.document().snapshot();
    List<BatchVersionsEdit.Item> items = model.chosen();
    ProblemCollector told = new ProblemCollector();
    run(
        Texts.of("versions.computing"),
        reporting ->
            BatchVersionsEdit.plan(
                snapshot, request(), items, session.catalogue(), reporting, told),
        plan -> planned(plan, told));
  }

  private void planned(BatchVersionsEdit plan, ProblemCollector told) {
    List<String> said = told.list().stream().map(Problem::toString).toList();
    problems.setListData(said.stream().map(Remarks::shown).toArray(String[]::new));
    problemPane.setVisible(!said.isEmpty());
    revalidate();
    if (plan.isEmpty()) {
      say(Texts.of("manyversions.nothing"));
      return;
    }
    if (!confirmed(plan)) {
      return;
    }
    session.document().removeListener(changes);
    Set<DocumentElement> before = Set.copyOf(switches());
    try {
      plan.apply(session.document());
      dispose();
      List<DocumentElement> made =
          switches().stream().filter(element -> !before.contains(element)).toList();
      if (!made.isEmpty()) {
        session.selectAll(made, this); // as their schemas are stated next
      }
      session.message(
          Texts.of(
              "manyversions.made",
              plan.objects().size(),
              String.valueOf(plan.objects().size()),
              plan.objects().stream()
                  .map(BatchVersionsEdit.VersionedObject::name)
                  .limit(5)
                  .collect(Collectors.joining(", "))));
    } catch (EditRejectedException | IOException e) {
      session.document().addListener(changes);
      say(Remarks.of(e));
    }
  }

  private List<DocumentElement> switches() {
    return session.enrichment().switches().stream().map(EnrichedSwitch::element).toList();
  }

  /** Asks before existing files are replaced, naming them; returns whether to go on. */
  private boolean confirmed(BatchVersionsEdit plan) {
    List<PlannedFile> there =
        plan.files().stream().filter(file -> file.state() == PlannedFile.State.CHANGED).toList();
    if (there.isEmpty()) {
      return true;
    }
    boolean byHand = there.stream().anyMatch(PlannedFile::byHand);
    String names =
        there.stream()
            .map(file -> String.valueOf(file.file().getFileName()))
            .limit(12)
            .collect(Collectors.joining(", "));
    return JOptionPane.showConfirmDialog(
            this,
            Texts.of(
                byHand ? "versions.replace.hand" : "versions.replace",
                there.size() > 12 ? names + "\u2026" : names),
            Texts.of("versions.replace.title"),
            JOptionPane.OK_CANCEL_OPTION,
            JOptionPane.WARNING_MESSAGE)
        == JOptionPane.OK_OPTION;
  }

  @Override
  public void dispose() {
    if (running != null) {
      running.cancel();
    }
    session.document().removeListener(changes);
    super.dispose();
  }
}
