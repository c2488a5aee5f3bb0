package org.selectiverenderer.enricher.ratings;

import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Window;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.filechooser.FileNameExtensionFilter;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.ratings.RatingScale;
import org.selectiverenderer.authoring.ratings.ViewedObjects;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.enricher.component.InitialFocus;
import org.selectiverenderer.enricher.component.NamedFileChooser;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.swing.WindowPacker;

/**
 * Imports a table of expectancy ratings: the author chooses the file, corrects which Switch each
 * object is, reviews the implied metadata, and applies it as one undo step. Head logs propose the
 * consistency of objects from what participants looked at; the author accepts proposals one by one,
 * and those accepted take the place of ratings.
 */
@SuppressWarnings("serial") // never written
public final class RatingsDialog extends JDialog {
  private static final long serialVersionUID = 1L;

  private final EnricherSession session;
  private final RatingsImportModel model;
  private final JPanel gaze;
  private final JTextField file = new JTextField(30);
  private final JCheckBox follow =
      Mnemonics.on(new JCheckBox("", true), Texts.of("ratings.follow"));
  private final JCheckBox linear = Mnemonics.on(new JCheckBox(), Texts.of("ratings.linear"));
  private final JLabel summary = PlainText.only(new JLabel());
  private final JTabbedPane messages = new JTabbedPane();
  private final JList<String> leftOut = PlainText.entries(new JList<>());
  private final JList<String> problems = PlainText.entries(new JList<>());
  private final JButton proposals = Mnemonics.button("ratings.proposals");
  private final JButton apply = new JButton(Texts.of("ratings.apply"));
  private boolean closed;

  public RatingsDialog(Window owner, EnricherSession session) {
    super(owner, Texts.of("ratings.title"), ModalityType.DOCUMENT_MODAL);
    this.session = session;
    this.model = new RatingsImportModel(session.enrichment());
    this.gaze =
        RatingsTableFactory.captioned(
            Mnemonics.label("ratings.caption.gaze"),
            RatingsTableFactory.gaze(new GazeTableModel(model)),
            142,
            8);
    setDefaultCloseOperation(DISPOSE_ON_CLOSE);
    JPanel content =
        new JPanel(new MigLayout("insets dialog, fill", "[grow,fill]", "[][][grow,fill][][][][]"));
    content.add(source(), "wrap");
    content.add(summary, "wrap");
    content.add(tables(), "grow, wrap");
    gaze.setVisible(false);
    content.add(gaze, "grow, wrap, hidemode 3");
    content.add(options(), "wrap");
    content.add(messages(), "grow, wrap");
    content.add(buttons());
    summary.getAccessibleContext().setAccessibleName(Texts.of("ratings.result"));
    setContentPane(content);
    getRootPane().setDefaultButton(apply);
    getRootPane()
        .registerKeyboardAction(
            e -> dispose(), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_IN_FOCUSED_WINDOW);
    model.addListener(this::refresh);
    refresh();
    WindowPacker.pack(this);
    setLocationRelativeTo(owner);
  }

  private JPanel source() {
    JPanel panel = new JPanel(new MigLayout("insets 0, fillx", "[][grow,fill][][]"));
    JLabel label = Mnemonics.label("ratings.file");
    label.setLabelFor(file);
    file.getAccessibleContext().setAccessibleName(Texts.of("ratings.file.name"));
    file.putClientProperty("JTextField.placeholderText", "RATINGS.csv: object,schema,rating");
    file.addActionListener(e -> open(Path.of(file.getText().strip())));
    JButton browse = Mnemonics.button("ratings.browse");
    browse.addActionListener(e -> browse());
    panel.add(label);
    panel.add(file);
    panel.add(browse);
    JButton logs = Mnemonics.button("ratings.logs");
    logs.setToolTipText(Texts.of("ratings.logs.tip"));
    logs.addActionListener(e -> browseLogs());
    panel.add(logs);
    return panel;
  }

  private JSplitPane tables() {
    JTable matches = RatingsTableFactory.matches(new MatchTableModel(model), model.candidates());
    JTable implied = RatingsTableFactory.implied(new ImpliedMetadataTableModel(model));
    JSplitPane split =
        new JSplitPane(
            JSplitPane.HORIZONTAL_SPLIT,
            RatingsTableFactory.captioned(
                Mnemonics.label("ratings.caption.matches"), matches, 50, 14),
            RatingsTableFactory.captioned(
                Mnemonics.label("ratings.caption.implied"), implied, 92, 14));
    split.setResizeWeight(0.4);
    split.setBorder(null);
    return split;
  }

  private JPanel options() {
    JPanel panel = new JPanel(new MigLayout("insets 0", "[]unrel[]"));

    proposals.setToolTipText(Texts.of("ratings.proposals.tip"));
    proposals.addActionListener(e -> model.acceptProposals());

    follow.addActionListener(e -> model.unratedFollow(follow.isSelected()));
    linear.setToolTipText(Texts.of("ratings.linear.tip"));
    linear.addActionListener(
        e -> model.scale(linear.isSelected() ? RatingScale.LINEAR : RatingScale.BANDS));
    panel.add(proposals);
    panel.add(follow, "wrap");
    panel.add(linear, "span");
    return panel;
  }

  private JTabbedPane messages() {
    leftOut.setVisibleRowCount(4);
    leftOut.getAccessibleContext().setAccessibleName(Texts.of("ratings.leftout.name"));
    problems.setVisibleRowCount(4);
    problems.getAccessibleContext().setAccessibleName(Texts.of("ratings.problems.name"));
    messages.addTab("", new JScrollPane(leftOut));
    messages.addTab("", new JScrollPane(problems));
    messages.setMnemonicAt(0, Mnemonics.code(Texts.of("ratings.tab.left", "")));
    messages.setMnemonicAt(1, Mnemonics.code(Texts.of("ratings.tab.problems", "")));
    messages.getAccessibleContext().setAccessibleName(Texts.of("ratings.messages"));
    return messages;
  }

  private JPanel buttons() {
    JPanel panel = new JPanel(new MigLayout("insets 0, fillx", "push[sizegroup b][sizegroup b]"));
    JButton cancel = new JButton(Texts.of("keep.cancel"));
    cancel.addActionListener(e -> dispose());
    apply.addActionListener(e -> apply());
    panel.add(apply, "tag ok");
    panel.add(cancel, "tag cancel");
    return panel;
  }

  private void browse() {
    File scene = session.file().path().toAbsolutePath().toFile();
    NamedFileChooser chooser = new NamedFileChooser();
    chooser.setCurrentDirectory(scene.getParentFile());
    chooser.setDialogTitle(Texts.of("ratings.chooser"));
    chooser.setFileFilter(new FileNameExtensionFilter(Texts.of("ratings.tables"), "csv"));
    if (chooser.showOpenDialog(this) == JFileChooser.APPROVE_OPTION) {
      open(chooser.chosen());
    }
  }

  private void browseLogs() {
    NamedFileChooser chooser = new NamedFileChooser();
    chooser.setCurrentDirectory(session.file().path().toAbsolutePath().toFile().getParentFile());
    chooser.setDialogTitle(Texts.of("ratings.chooser.logs"));
    chooser.setFileSelectionMode(JFileChooser.FILES_AND_DIRECTORIES);
    chooser.setMultiSelectionEnabled(true);
    chooser.setFileFilter(new FileNameExtensionFilter(Texts.of("ratings.tables.logs"), "csv"));
    if (chooser.showOpenDialog(this) == JFileChooser.APPROVE_OPTION) {
      openLogs(Stream.of(chooser.getSelectedFiles()).map(File::toPath).toList());
    }
  }

  /**
   * Reads head logs in the background and shows what they propose.
   *
   * @param logs files, and folders of sessions or studies
   */
  public void openLogs(List<Path> logs) {
    String scene = String.valueOf(session.file().path().getFileName());
    ViewedObjects objects = model.viewed();
    session
        .tasks()
        .run(
            Texts.of("ratings.reading.logs"),
            () -> RatingsImportModel.read(logs, scene, objects),
            model::take,
            failure ->
                model.unreadLogs(
                    new Problem(
                        Problem.Severity.ERROR,
                        SourceLocation.of(logs.get(0).toString()),
                        Texts.of("ratings.another", failure.getMessage()))));
  }

  /** Makes the proposals anew after another table was read or matched. */
  private void renewProposals() {
    GazeProposals logs = model.gaze().logs();
    if (model.takeGazeStale() && logs != null) {
      ViewedObjects objects = model.viewed();
      session
          .tasks()
          .run(
              Texts.of("ratings.reading.logs"),
              () -> logs.of(objects),
              proposals -> model.take(logs, objects, proposals),
              failure -> summary.setText(failure.getMessage()));
    }
  }

  /** Shows the dialog and waits until it is closed. */
  public void showAndWait() {
    InitialFocus.show(this, file);
  }

  /** Reads a table in the background and shows what it implies. */
  public void open(Path table) {
    file.setText(table.toString());
    session
        .tasks()
        .run(
            Texts.of("ratings.reading", String.valueOf(table.getFileName())),
            () ->
                RatingsImportModel.read(
                    String.valueOf(table.getFileName()), InputFileReader.bytes(table)),
            model::take,
            failure -> model.take(unread(table, failure)));
  }

  private static RatingsImportModel.Table unread(Path table, Exception failure) {
    String why =
        failure instanceof IOException ? Texts.of("ratings.unreadable") : failure.getMessage();
    Problem problem =
        new Problem(
            Problem.Severity.ERROR,
            SourceLocation.of(table.toString()),
            Texts.of("ratings.another", why));
    return new RatingsImportModel.Table(table.toString(), Optional.empty(), List.of(problem));
  }

  /** Makes room for the proposals, by the tables above where the screen is low. */
  private void showProposals() {
    gaze.setVisible(true);
    pack();
    Rectangle screen = getGraphicsConfiguration().getBounds();
    Insets bars = getToolkit().getScreenInsets(getGraphicsConfiguration());
    int height = Math.min(getHeight(), screen.height - bars.top - bars.bottom);
    setSize(Math.min(getWidth(), screen.width - bars.left - bars.right), height);
    int lowest = screen.y + screen.height - bars.bottom - height;
    setLocation(getX(), Math.max(screen.y + bars.top, Math.min(getY(), lowest)));
  }

  /** Closes the dialog; what is still being read is not shown any more. */
  @Override
  public void dispose() {
    closed = true;
    super.dispose();
  }

  private void refresh() {
    if (closed) {
      return;
    }
    renewProposals();
    if (!gaze.isVisible() && !model.gaze().proposals().isEmpty()) {
      showProposals();
    }
    List<String> left = model.leftOut();
    leftOut.setListData(left.toArray(String[]::new));
    problems.setListData(model.problems().stream().map(Problem::toString).toArray(String[]::new));
    messages.setTitleAt(
        0, Mnemonics.without(Texts.of("ratings.tab.left", DecimalFormatter.grouped(left.size()))));
    messages.setTitleAt(
        1,
        Mnemonics.without(
            Texts.of("ratings.tab.problems", DecimalFormatter.grouped(model.problems().size()))));
    messages.setSelectedIndex(model.problems().isEmpty() ? 0 : 1);
    summary.setText(model.summary());
    apply.setEnabled(model.applicable());
    proposals.setEnabled(
        model.matches().stream()
            .anyMatch(
                m ->
                    m.how()
                        == org.selectiverenderer.authoring.ratings.ObjectNameMatcher.How.PROPOSED));
  }

  private void apply() {
    try {
      model
          .edit()
          .ifPresent(
              edit -> {
                dispose();
                session.perform(edit);
              });
    } catch (EditRejectedException e) {
      summary.setText(e.getMessage());
    }
  }
}
