package org.selectiverenderer.app.window;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FlowLayout;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JTextArea;
import javax.swing.border.Border;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.swing.PlainText;

/** The footer of a page: progress, number of open questions, and the buttons back and next. */
final class PageFooter {
  private static final Color WARNING = new Color(0xa33a00);
  private static final int HINT_WIDTH = 560;

  private final ParticipantMessages wording;
  private final JPanel panel = new JPanel(new BorderLayout(16, 0));
  private final JLabel left = PlainText.only(new JLabel(" "));
  private final JTextArea hint;
  private final JLabel page = PlainText.only(new JLabel());
  private final JProgressBar progress = new JProgressBar();
  private final JButton back = PlainText.only(new JButton());
  private final JButton next = PlainText.only(new JButton());
  private final JButton again = PlainText.only(new JButton());
  private final Color plain = left.getForeground();

  /**
   * @param lines lines of the explanation of the keys
   */
  PageFooter(
      ParticipantMessages wording, int lines, Runnable goBack, Runnable goOn, Runnable playAgain) {
    this.wording = wording;
    hint = WrappedTextArea.of(" " + "\n ".repeat(lines - 1), 12f, HINT_WIDTH);
    again.setName("again");
    again.setText(wording.of("audio.again"));
    again.setFocusable(false);
    again.setVisible(false);
    again.addActionListener(event -> playAgain.run());
    next.setName("next");
    next.setFocusable(false);
    next.addActionListener(event -> goOn.run());
    back.setName("back");
    back.setText(wording.of("back"));
    back.setFocusable(false);
    back.addActionListener(event -> goBack.run());
    progress.setPreferredSize(new Dimension(120, 6));
    JPanel told = new JPanel(new BorderLayout(0, 2));
    told.add(left, BorderLayout.NORTH);
    told.add(hint, BorderLayout.CENTER);
    JPanel where = new JPanel(new FlowLayout(FlowLayout.RIGHT, 10, 0));
    where.add(page);
    where.add(progress);
    JPanel buttons = new JPanel(new FlowLayout(FlowLayout.RIGHT, 10, 0));
    buttons.add(again);
    buttons.add(back);
    buttons.add(next);
    JPanel right = new JPanel(new BorderLayout(0, 8));
    right.add(where, BorderLayout.NORTH);
    right.add(buttons, BorderLayout.SOUTH);
    panel.setBorder(
        BorderFactory.createCompoundBorder(
            rule(), BorderFactory.createEmptyBorder(10, 16, 14, 10)));
    panel.add(told, BorderLayout.CENTER);
    panel.add(right, BorderLayout.EAST);
  }

  /** Returns the border with the line above the footer. */
  static Border rule() {
    return BorderFactory.createMatteBorder(1, 0, 0, 0, new Color(0xd5d5d5));
  }

  JComponent component() {
    return panel;
  }

  /**
   * Shows the progress.
   *
   * @param at number of the page, from 0
   * @param pages number of pages after the answers so far
   * @param open number of questions of the page that still need an answer
   * @param asked number of questions on the page that need an answer
   * @param refused whether an answer refuses consent
   * @param keys explanation of the keys; empty for a page to be read
   * @param begins whether the session begins after the last page
   */
  void show(int at, int pages, int open, int asked, boolean refused, String keys, boolean begins) {
    left.setText(
        refused
            ? wording.of("form.refused")
            : open > 0 ? wording.filled(open == 1 ? "left.one" : "left", open, asked) : " ");
    left.setForeground(refused ? WARNING : plain);
    hint.setText(PlainText.of(keys));
    page.setText(wording.filled("page", at + 1, pages));
    page.setVisible(pages > 1);
    progress.setVisible(pages > 1);
    progress.setMaximum(pages);
    progress.setValue(at + 1);
    back.setVisible(pages > 1);
    back.setEnabled(at > 0);
    next.setText(wording.of(begins && at + 1 == pages ? "form.begin" : "next"));
    next.setEnabled(open == 0 && !refused);
  }

  /** Shows or hides the button that plays the page's audio again. */
  void audible(boolean audio) {
    again.setVisible(audio);
  }

  /** Disables the buttons. */
  void close() {
    next.setEnabled(false);
    back.setEnabled(false);
    again.setEnabled(false);
  }
}
