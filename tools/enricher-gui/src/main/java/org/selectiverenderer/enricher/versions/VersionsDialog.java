package org.selectiverenderer.enricher.versions;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.Window;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.versions.PlannedFile;
import org.selectiverenderer.authoring.versions.VersionsEdit;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.enricher.component.InitialFocus;
import org.selectiverenderer.enricher.component.TextChangeListener;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.enricher.text.Remarks;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.swing.WindowPacker;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The dialog that makes versions of an object: the author sets the number of vertices of each and
 * sees its mesh and figures; applying writes the files and the Switch in the scene as one undo
 * step.
 */
@SuppressWarnings("serial") // never written
public final class VersionsDialog extends JDialog {
  private static final long serialVersionUID = 1L;

  private final EnricherSession session;
  private final VersionsModel model;
  private final VersionsUpdater work;
  private final TurntableCamera turntable = new TurntableCamera();
  private final JPanel columns = new JPanel(new MigLayout("insets 0, fill", "", "[grow,fill]"));
  private final List<VersionPanel> shown = new ArrayList<>();
  private final JLabel summary = PlainText.only(new JLabel(" "));
  private final JList<String> problems = PlainText.entries(new JList<>());
  private final JScrollPane problemPane = new JScrollPane(problems);
  private final JProgressBar progress = new JProgressBar();
  private final JLabel doing = new JLabel(Texts.of("versions.computing"));
  private final JTextField name = new JTextField(14);
  private final JButton stop = Mnemonics.button("versions.stop");
  private final JButton more = Mnemonics.button("versions.add");
  private final JButton fewer = Mnemonics.button("versions.remove");
  private final JButton apply = Mnemonics.button("versions.apply");
  private final org.selectiverenderer.authoring.DocumentListener changes;
  private int made;

  /** Whether the dialog can make versions of an element, with or without a DEF name. */
  public static boolean takes(DocumentElement element) {
    return element.use().isEmpty() && VersionsModel.isObject(element);
  }

  /**
   * @param object the object, or an element in it
   */
  public VersionsDialog(Window owner, EnricherSession session, DocumentElement object) {
    super(owner, Texts.of("versions.apply"), ModalityType.DOCUMENT_MODAL);
    this.session = session;
    this.model = VersionsModel.of(session.document(), object);
    this.work = new VersionsUpdater(session, model, this::failed);
    this.changes = change -> model.outdate();
    setDefaultCloseOperation(DISPOSE_ON_CLOSE);
    JPanel content =
        new JPanel(
            new MigLayout("insets dialog, fill, hidemode 3", "[grow,fill]", "[][grow,fill][][][]"));
    content.add(choice(), "wrap");
    JScrollPane scrolling = new JScrollPane(columns);
    scrolling.setBorder(null);
    content.add(scrolling, "grow, wrap");
    content.add(summary, "wrap");
    content.add(problemPane, "wrap");
    content.add(buttons());
    summary.getAccessibleContext().setAccessibleName(Texts.of("versions.result"));
    problems.setVisibleRowCount(3);
    problems.getAccessibleContext().setAccessibleName(Texts.of("versions.problems"));
    setContentPane(content);
    getRootPane().setDefaultButton(apply);
    getRootPane()
        .registerKeyboardAction(
            e -> dispose(), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_IN_FOCUSED_WINDOW);
    session.document().addListener(changes);
    model.addListener(this::refresh);
    refresh();
    work.start();
    refresh();
    WindowPacker.pack(this);
    setLocationRelativeTo(owner);
  }

  private JPanel choice() {
    JPanel panel = new JPanel(new MigLayout("insets 0, fillx", "[][]unrel[][]unrel[][]push"));
    JComboBox<String> objects =
        PlainText.entries(
            new JComboBox<>(model.choices(session.document()).toArray(String[]::new)));
    objects.setPrototypeDisplayValue("Transform_OfSomeObject");
    objects.setSelectedItem(model.object());
    objects.getAccessibleContext().setAccessibleName(Texts.of("versions.object.name"));
    objects.addActionListener(e -> model.object(String.valueOf(objects.getSelectedItem())));
    JLabel label = Mnemonics.label("versions.object");
    label.setLabelFor(objects);

    more.addActionListener(e -> model.add());

    fewer.addActionListener(e -> model.removeLast());
    panel.add(label);
    panel.add(objects);
    JLabel nameLabel = Mnemonics.label("versions.name");
    nameLabel.setLabelFor(name);
    name.setName("Name of the files");
    name.getAccessibleContext().setAccessibleName(Texts.of("versions.name.described"));
    name.setToolTipText(Texts.of("versions.name.described"));
    name.getDocument()
        .addDocumentListener(new TextChangeListener(() -> model.name(name.getText())));
    panel.add(nameLabel);
    panel.add(name);
    panel.add(more);
    panel.add(fewer);
    return panel;
  }

  private JPanel buttons() {
    JPanel panel = new JPanel(new MigLayout("insets 0, fillx, hidemode 2", "[][][]push[][]"));
    progress.setIndeterminate(true);
    progress.getAccessibleContext().setAccessibleName(Texts.of("versions.progress"));

    stop.addActionListener(
        e -> {
          work.cancel();
          refresh();
          summary.setText(Texts.of("versions.stopped"));
        });
    JButton cancel = new JButton(Texts.of("keep.cancel"));
    cancel.addActionListener(e -> dispose());
    apply.addActionListener(e -> apply());
    panel.add(doing);
    panel.add(progress);
    panel.add(stop);
    panel.add(apply, "tag ok");
    panel.add(cancel, "tag cancel");
    return panel;
  }

  private void refresh() {
    int count = 1 + model.goals().size();
    if (shown.size() != count) {
      while (shown.size() < count) {
        shown.add(new VersionPanel(model, shown.size(), turntable));
      }
      while (shown.size() > count) {
        shown.remove(shown.size() - 1);
      }
      columns.removeAll();
      shown.forEach(column -> columns.add(column, "grow, sizegroup versions, gapright unrel"));
      columns.revalidate();
      columns.repaint();
    }
    shown.forEach(VersionPanel::refresh);
    boolean busy = !model.current() && work.busy();
    progress.setVisible(busy);
    doing.setVisible(busy);
    if (!name.getText().strip().equals(model.name())) {
      name.setText(model.name()); // another object was chosen
    }
    stop.setVisible(busy);
    more.setEnabled(model.goals().size() < VersionsModel.MOST);
    fewer.setEnabled(model.goals().size() > 1);
    apply.setEnabled(model.applicable());
    List<Problem> found = model.result().map(ComputedVersions::problems).orElse(List.of());
    problems.setListData(
        found.stream().map(Problem::toString).map(Remarks::shown).toArray(String[]::new));
    problemPane.setVisible(!found.isEmpty());
    summary.setText(busy ? " " : summary());
    revalidate();
    grow();
  }

  /** Enlarges the dialog to its preferred size, as far as the screen has room; never shrinks it. */
  private void grow() {
    if (isShowing()) {
      Rectangle screen = getGraphicsConfiguration().getBounds();
      Dimension wanted = getPreferredSize();
      int width = Math.min(Math.max(wanted.width, getWidth()), screen.width);
      int height = Math.min(Math.max(wanted.height, getHeight()), screen.height);
      if (width > getWidth() || height > getHeight()) {
        setSize(width, height);
        setLocationRelativeTo(getOwner());
      }
    }
  }

  private String summary() {
    Optional<VersionsEdit> edit = model.result().flatMap(ComputedVersions::edit);
    if (edit.isEmpty()) {
      return model.object().isEmpty()
          ? Texts.of("versions.choose")
          : Texts.of("versions.none", model.object());
    }
    if (edit.get().isEmpty()) {
      return Texts.of("versions.same");
    }
    List<String> files =
        edit.get().files().stream()
            .filter(file -> file.state() != PlannedFile.State.UNCHANGED)
            .map(
                file ->
                    file.state() == PlannedFile.State.CHANGED
                        ? Texts.of("versions.replaced", String.valueOf(file.file().getFileName()))
                        : String.valueOf(file.file().getFileName()))
            .toList();
    return files.isEmpty()
        ? Texts.of("versions.exist")
        : Texts.of("versions.writes", String.join(", ", files));
  }

  private void failed(String message) {
    refresh();
    summary.setText(message);
  }

  /** Shows the dialog, waits, and returns how many versions the object has been given. */
  public int made() {
    name.selectAll();
    InitialFocus.show(this, name);
    return made;
  }

  private void apply() {
    Optional<VersionsEdit> edit = model.result().flatMap(ComputedVersions::edit);
    if (edit.isEmpty() || !model.applicable()) {
      return;
    }
    if (!replacing(edit.get())) {
      return;
    }
    session.document().removeListener(changes);
    try {
      edit.get().apply(session.document());
      made = edit.get().versions().size();
      dispose();
    } catch (EditRejectedException | IOException e) {
      session.document().addListener(changes);
      summary.setText(Remarks.of(e));
    }
  }

  /** Asks before existing files are replaced, naming them; returns whether to go on. */
  private boolean replacing(VersionsEdit edit) {
    List<String> there =
        edit.files().stream()
            .filter(file -> file.state() == PlannedFile.State.CHANGED)
            .map(file -> String.valueOf(file.file().getFileName()))
            .toList();
    boolean byHand = edit.files().stream().anyMatch(PlannedFile::byHand);
    return there.isEmpty()
        || JOptionPane.showConfirmDialog(
                this,
                Texts.of(
                    byHand ? "versions.replace.hand" : "versions.replace",
                    String.join(", ", there)),
                Texts.of("versions.replace.title"),
                JOptionPane.OK_CANCEL_OPTION,
                JOptionPane.WARNING_MESSAGE)
            == JOptionPane.OK_OPTION;
  }

  @Override
  public void dispose() {
    work.close();
    session.document().removeListener(changes);
    super.dispose();
  }
}
