package org.selectiverenderer.enricher.component;

import java.awt.Component;
import java.awt.Insets;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.base.markup.MarkupEscaper;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.WindowPacker;

/**
 * A modal dialog with OK and Cancel around fields to fill in. Its first field has the focus when
 * the dialog is shown, and gets every key that was typed from the moment that the dialog was asked
 * for; Enter presses OK, Escape cancels. What is invalid is complained of in the dialog, which
 * stays.
 */
public final class InputDialog {
  private static final int WIDTH = 320;

  private final JDialog dialog;
  private final JComponent first;
  private final JLabel wrong = new JLabel(" ");
  private final JButton ok = new JButton(Texts.of("window.ok"));
  private boolean accepted;

  /**
   * @param owner the component over whose window the dialog opens
   * @param content the fields with their labels
   * @param first the field in {@code content} that gets the focus
   */
  public InputDialog(Component owner, String title, JComponent content, JComponent first) {
    this.first = first;
    Window window =
        owner instanceof Window itself ? itself : SwingUtilities.getWindowAncestor(owner);
    dialog = new JDialog(window, title, JDialog.ModalityType.DOCUMENT_MODAL);
    dialog.setDefaultCloseOperation(JDialog.DISPOSE_ON_CLOSE);
    JPanel panel =
        new JPanel(new MigLayout("insets dialog, fill", "[grow,fill]", "[grow,fill][][]"));
    panel.add(content, "wmin " + WIDTH + ", wrap");
    wrong.setName("wrong");
    wrong.putClientProperty("FlatLaf.styleClass", "small");
    panel.add(wrong, "wmin 0, wrap");
    JButton cancel = new JButton(Texts.of("keep.cancel"));
    cancel.addActionListener(event -> dialog.dispose());
    panel.add(ok, "split 2, tag ok, growx 0, sizegroup buttons");
    panel.add(cancel, "tag cancel, growx 0, sizegroup buttons");
    dialog.setContentPane(panel);
    dialog
        .getRootPane()
        .registerKeyboardAction(
            event -> dialog.dispose(),
            KeyStroke.getKeyStroke("ESCAPE"),
            JComponent.WHEN_IN_FOCUSED_WINDOW);
    dialog.getRootPane().setDefaultButton(ok);
    WindowPacker.pack(dialog);
    dialog.setLocationRelativeTo(window);
  }

  /**
   * Shows the dialog and waits until the author enters something valid or cancels.
   *
   * @param complaint returns why what is entered is invalid; empty if it is valid
   * @return whether the author has pressed OK
   */
  public boolean ask(Supplier<Optional<String>> complaint) {
    ok.addActionListener(
        event -> {
          Optional<String> why = complaint.get();
          accepted = why.isEmpty();
          if (accepted) {
            dialog.dispose();
          } else {
            complain(why.get());
          }
        });
    InitialFocus.show(dialog, first);
    return accepted;
  }

  private void complain(String why) {
    wrong.setText("<html><body width=" + WIDTH + ">" + MarkupEscaper.text(why));
    wrong.getAccessibleContext().setAccessibleName(why);
    dialog.pack();
    first.requestFocusInWindow();
  }

  /**
   * Asks for one line of text.
   *
   * @param label what is asked for
   * @param proposal the text that is there, selected, at first
   * @param complaint returns why a text is invalid; empty for a valid one
   * @return the text without spaces around it; empty if the author cancels
   */
  public static Optional<String> ask(
      Component owner,
      String title,
      String label,
      String proposal,
      Function<String, Optional<String>> complaint) {
    JTextField field = field(label, proposal);
    return new InputDialog(owner, title, labelled(label, field), field).answer(field, complaint);
  }

  private static JTextField field(String label, String proposal) {
    JTextField field = new JTextField(proposal, 24);
    field.selectAll();
    field.getAccessibleContext().setAccessibleName(label);
    return field;
  }

  private static JPanel labelled(String label, JTextField field) {
    JLabel labelled = new JLabel(label);
    labelled.setLabelFor(field);
    JPanel content = new JPanel(new MigLayout("insets 0, wrap 1", "[grow,fill]"));
    content.add(labelled);
    content.add(field);
    return content;
  }

  private Optional<String> answer(JTextField field, Function<String, Optional<String>> complaint) {
    return ask(() -> complaint.apply(field.getText().strip()))
        ? Optional.of(field.getText().strip())
        : Optional.empty();
  }

  /**
   * Asks for one line of text beside a view, so that what the text is for is seen: over what is at
   * its right, as far as the screen has room.
   *
   * @param label what is asked for
   * @param proposal the text that is there, selected, at first
   * @param complaint returns why a text is invalid; empty for a valid one
   * @return the text without spaces around it; empty if the author cancels
   */
  public static Optional<String> askBeside(
      Component view,
      String title,
      String label,
      String proposal,
      Function<String, Optional<String>> complaint) {
    JTextField field = field(label, proposal);
    InputDialog asking = new InputDialog(view, title, labelled(label, field), field);
    if (view.isShowing()) {
      asking.moveBeside(view);
    }
    return asking.answer(field, complaint);
  }

  private void moveBeside(Component view) {
    Rectangle screen = view.getGraphicsConfiguration().getBounds();
    Insets bars = dialog.getToolkit().getScreenInsets(view.getGraphicsConfiguration());
    Point at = view.getLocationOnScreen();
    int most = screen.x + screen.width - bars.right - dialog.getWidth();
    int lowest = screen.y + screen.height - bars.bottom - dialog.getHeight();
    dialog.setLocation(
        Math.max(screen.x, Math.min(at.x + view.getWidth(), most)),
        Math.max(screen.y, Math.min(at.y + view.getHeight() / 4, lowest)));
  }
}
