package org.selectiverenderer.app.window;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Font;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.swing.PlainText;

/** The header of a page: title, text and picture; the whole page if it has no questions. */
final class PageHeader {
  private static final int SIDE = 20;
  private static final float TEXT = 15f;

  /** Font size on a page to be read. */
  private static final float READ = 16f;

  private PageHeader() {}

  /**
   * Returns the header of a page.
   *
   * @param named whether to show the participant's id
   * @param width of the window in pixels
   */
  static JComponent of(
      QuestionnairePage page,
      ParticipantMessages wording,
      String participant,
      boolean named,
      int width) {
    JPanel head = new JPanel();
    head.setLayout(new BoxLayout(head, BoxLayout.Y_AXIS));
    head.setBorder(BorderFactory.createEmptyBorder(18, SIDE, 12, SIDE));
    int room = width - 2 * SIDE - 24;
    if (named) {
      JLabel id = new JLabel(PlainText.of(wording.of("form.id") + ": " + participant));
      id.setAlignmentX(0);
      head.add(id);
      head.add(Box.createVerticalStrut(6));
    }
    if (!page.title().isEmpty()) {
      JLabel title = new JLabel(PlainText.of(page.title()));
      title.setFont(title.getFont().deriveFont(Font.PLAIN, 24f));
      title.setAlignmentX(0);
      head.add(title);
      head.add(Box.createVerticalStrut(8));
    }
    boolean read = page.questions().isEmpty();
    page.text()
        .lines()
        .filter(line -> !line.isBlank())
        .forEach(
            line -> {
              JComponent text = WrappedTextArea.of(line, read ? READ : TEXT, room);
              text.setAlignmentX(0);
              head.add(text);
              head.add(Box.createVerticalStrut(read ? 10 : 4));
            });
    page.picture()
        .ifPresent(
            file -> {
              head.add(Box.createVerticalStrut(6));
              head.add(new ScaledPicture(file, room));
            });
    if (!read) {
      return head;
    }
    // On a small screen the page scrolls.
    JPanel top = new JPanel(new BorderLayout());
    top.setBackground(QuestionRow.PLAIN);
    head.setOpaque(false);
    top.add(head, BorderLayout.NORTH);
    JScrollPane scroll = new JScrollPane(top);
    scroll.setBorder(BorderFactory.createEmptyBorder());
    scroll.getVerticalScrollBar().setUnitIncrement(24);
    scroll.setAlignmentX(Component.LEFT_ALIGNMENT);
    return scroll;
  }
}
