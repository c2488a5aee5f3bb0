package org.selectiverenderer.swing;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.lang.reflect.InvocationTargetException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.JOptionPane;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import org.jspecify.annotations.Nullable;

/** The dialog that shows what a file asks for beyond its own folder, and asks whether to agree. */
public final class TrustDialog {
  private static final int MOST_ROWS = 14;

  private TrustDialog() {}

  /**
   * The texts of the dialog.
   *
   * @param title of the window
   * @param sentence before the list
   * @param hint below it
   * @param agree the button that agrees
   * @param cancel the button that does not; it has the focus
   */
  public record Words(String title, String sentence, String hint, String agree, String cancel) {}

  /**
   * Shows the dialog and waits for the answer; from any thread.
   *
   * @param parent the window that it belongs to
   * @return the answer, no if the dialog is closed; empty if there is no display
   */
  public static Optional<Boolean> ask(Optional<Component> parent, Words words, List<String> lines) {
    if (GraphicsEnvironment.isHeadless()) {
      return Optional.empty();
    }
    if (EventQueue.isDispatchThread()) {
      return Optional.of(show(parent.orElse(null), words, lines));
    }
    AtomicBoolean agreed = new AtomicBoolean();
    try {
      EventQueue.invokeAndWait(() -> agreed.set(show(parent.orElse(null), words, lines)));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (InvocationTargetException e) {
      throw new IllegalStateException(e.getCause());
    }
    return Optional.of(agreed.get());
  }

  private static boolean show(@Nullable Component parent, Words words, List<String> lines) {
    Object[] buttons = {words.agree(), words.cancel()};
    // A text area, as labels would take text that begins with a tag for HTML.
    JTextArea list = text(String.join("\n", lines.stream().map(line -> "\u2022 " + line).toList()));
    list.setRows(Math.min(MOST_ROWS, 2 * lines.size() + 1));
    list.setOpaque(true);
    list.getAccessibleContext().setAccessibleName(words.sentence());
    JScrollPane scrolled = new JScrollPane(list);
    scrolled.setPreferredSize(
        new Dimension(
            scrolled.getPreferredSize().width,
            list.getPreferredScrollableViewportSize().height + 6));
    int answer =
        JOptionPane.showOptionDialog(
            parent,
            new Object[] {text(words.sentence()), scrolled, text(words.hint())},
            words.title(),
            JOptionPane.DEFAULT_OPTION,
            JOptionPane.WARNING_MESSAGE,
            null,
            buttons,
            words.cancel());
    return answer == 0;
  }

  private static JTextArea text(String content) {
    JTextArea area = new JTextArea(content, 0, 56);
    area.setEditable(false);
    area.setLineWrap(true);
    area.setWrapStyleWord(true);
    area.setOpaque(false);
    area.setFont(javax.swing.UIManager.getFont("Label.font"));
    area.setSize(area.getPreferredSize()); // so that the height is that of the wrapped lines
    return area;
  }
}
