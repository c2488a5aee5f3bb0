package org.selectiverenderer.enricher.diff;

import java.awt.Dimension;
import java.awt.Window;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.file.UnifiedDiff;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.task.BackgroundTask;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.WindowPacker;

/** Shows the changes that saving will make to the file, and asks whether to save. */
@SuppressWarnings("serial") // never written
public final class DiffDialog extends JDialog {
  private static final long serialVersionUID = 1L;

  private final DiffView view = new DiffView();
  private final JLabel summary = new JLabel(Texts.of("diff.comparing"));
  private final JButton previous = Mnemonics.button("diff.previous");
  private final JButton next = Mnemonics.button("diff.next");
  private final JButton save = Mnemonics.button("diff.save");
  private final BackgroundTask comparing;
  private boolean confirmed;

  public DiffDialog(Window owner, EnricherSession session) {
    super(owner, Texts.of("diff.title"), ModalityType.DOCUMENT_MODAL);
    setDefaultCloseOperation(DISPOSE_ON_CLOSE);
    JPanel content =
        new JPanel(new MigLayout("insets dialog, fill", "[]push[][]unrel[][]", "[][grow,fill][]"));
    summary.setLabelFor(view);
    content.add(summary, "span, growx, wrap");
    JScrollPane scrolling = new JScrollPane(view);
    int line = view.getFontMetrics(view.getFont()).getHeight();
    scrolling.setPreferredSize(new Dimension(60 * line, 28 * line));
    content.add(scrolling, "span, grow, wrap");
    JButton cancel = new JButton(Texts.of("keep.cancel"));
    button(previous, "diff.previous.tip", view::previous);
    button(next, "diff.next.tip", view::next);
    button(save, "diff.save.tip", this::confirm);
    cancel.addActionListener(e -> dispose());
    content.add(previous, "skip 1");
    content.add(next);
    content.add(save);
    content.add(cancel);
    setContentPane(content);
    getRootPane().setDefaultButton(save);
    key("ESCAPE", this::dispose);
    key("F3", view::next);
    key("shift F3", view::previous);
    view.getInputMap().put(KeyStroke.getKeyStroke("N"), "next");
    view.getInputMap().put(KeyStroke.getKeyStroke("P"), "previous");
    view.getActionMap().put("next", new Step(view::next));
    view.getActionMap().put("previous", new Step(view::previous));
    enableButtons(false);
    comparing = compare(session);
    WindowPacker.pack(this);
    setLocationRelativeTo(owner);
  }

  private static final class Step extends javax.swing.AbstractAction {
    private static final long serialVersionUID = 1L;
    private final Runnable work;

    Step(Runnable work) {
      this.work = work;
    }

    @Override
    public void actionPerformed(java.awt.event.ActionEvent event) {
      work.run();
    }
  }

  private static void button(JButton button, String help, Runnable work) {
    button.setToolTipText(Texts.of(help));
    button.addActionListener(e -> work.run());
  }

  private void key(String key, Runnable work) {
    getRootPane()
        .registerKeyboardAction(
            e -> work.run(), KeyStroke.getKeyStroke(key), JComponent.WHEN_IN_FOCUSED_WINDOW);
  }

  private BackgroundTask compare(EnricherSession session) {
    Path file = session.file().path();
    Optional<String> common = session.file().common();
    DocumentSnapshot snapshot = session.document().snapshot();
    return session
        .tasks()
        .run(
            Texts.of("diff.task", String.valueOf(file.getFileName())),
            () -> Changes.of(file, common, snapshot),
            this::show,
            failure ->
                summary.setText(Texts.of("diff.unread", String.valueOf(failure.getMessage()))));
  }

  /**
   * The author's changes of a file.
   *
   * @param outside whether another program has changed the file too, since document and file last
   *     had the same text; the changes are those to that text then, as what the other program added
   *     is no deletion of the author's
   */
  record Changes(DiffLines lines, boolean outside) {
    /**
     * Compares a document with its file; a missing file counts as empty.
     *
     * @param common the last text that file and document had in common; empty for none
     */
    static Changes of(Path file, Optional<String> common, DocumentSnapshot document)
        throws IOException {
      String name = String.valueOf(file.getFileName());
      boolean there = Files.exists(file);
      String now =
          there ? SceneDocument.of(name, InputFileReader.bytes(file)).text().toString() : "";
      boolean outside = there && common.isPresent() && !common.get().equals(now);
      String before = outside ? common.get() : now;
      return new Changes(
          DiffLines.of(
              UnifiedDiff.of(name, Texts.of("diff.edited", name), before, document.text())),
          outside);
    }
  }

  private void show(Changes changes) {
    DiffLines lines = changes.lines();
    view.show(lines);
    String counts =
        lines.lines().isEmpty()
            ? Texts.of("diff.nothing")
            : Texts.of(
                "diff.summary",
                lines.changes().size(),
                DecimalFormatter.grouped(lines.changes().size()),
                lines.added(),
                DecimalFormatter.grouped(lines.added()),
                DecimalFormatter.grouped(lines.removed()));
    summary.setText(changes.outside() ? counts + " " + Texts.of("diff.outside") : counts);
    enableButtons(!lines.changes().isEmpty());
    view.requestFocusInWindow();
  }

  private void enableButtons(boolean changes) {
    previous.setEnabled(changes);
    next.setEnabled(changes);
    save.setEnabled(true); // saving is possible even if the file cannot be read
  }

  @Override
  public void dispose() {
    comparing.cancel();
    super.dispose();
  }

  private void confirm() {
    confirmed = true;
    dispose();
  }

  /** Shows the dialog, waits, and returns whether the author wants to save. */
  public boolean confirmed() {
    setVisible(true);
    return confirmed;
  }
}
