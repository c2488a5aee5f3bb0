package org.selectiverenderer.enricher.source;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.enricher.EventThread.edt;
import static org.selectiverenderer.enricher.EventThread.get;

import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import javax.swing.JFrame;
import javax.swing.text.BadLocationException;
import org.fife.ui.rsyntaxtextarea.RSyntaxDocument;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rsyntaxtextarea.Token;
import org.fife.ui.rsyntaxtextarea.TokenTypes;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;

/** A line of many numbers in the source view. */
@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class LongLinesTest {
  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();
  private final JFrame window = get(() -> new JFrame("Source"));
  private EnricherSession session;
  private SourcePanel panel;
  private RSyntaxTextArea area;

  private String open(int numbers) throws IOException {
    TestSessions.theme(false);
    session =
        TestSessions.with(
            folder,
            "<Shape DEF='Cup'>\n<Box/>\n</Shape>\n<Coordinate DEF='Many' point='"
                + "1.25 2.5 -3 ".repeat(numbers / 3)
                + "'/>\n<Shape DEF='Pot'>\n<Box/>\n</Shape>\n");
    panel = get(() -> new SourcePanel(session));
    area = panel.area();
    edt(
        () -> {
          window.getContentPane().add(panel.component());
          window.setBounds(10, 10, 900, 600);
        });
    hands.show(window);
    edt(() -> area.requestFocusInWindow()); // its middle is far outside of the window
    hands.await("the focus", area::isFocusOwner);
    return text();
  }

  @AfterEach
  void close() {
    edt(
        () -> {
          panel.dispose();
          window.dispose();
        });
  }

  private String text() {
    return get(() -> session.document().snapshot().text());
  }

  private int lineOf(String words) {
    String all = get(area::getText);
    return (int) all.substring(0, all.indexOf(words)).chars().filter(c -> c == '\n').count();
  }

  private boolean hasType(String words, int type) {
    int line = lineOf(words);
    return get(
        () -> {
          Token each = ((RSyntaxDocument) area.getDocument()).getTokenListForLine(line);
          while (each != null && each.getType() != type) {
            each = each.getNextToken();
          }
          return each != null;
        });
  }

  private void theRestIsColoredAndFolded() {
    for (String words : new String[] {"<Shape DEF='Cup'", "<Shape DEF='Pot'"}) {
      assertThat(hasType(words, TokenTypes.MARKUP_TAG_NAME)).as(words).isTrue();
      assertThat(hasType(words, TokenTypes.MARKUP_TAG_ATTRIBUTE_VALUE)).as(words).isTrue();
      int line = lineOf(words);
      hands.await("a fold of " + words, () -> area.getFoldManager().getFoldForLine(line) != null);
    }
  }

  /** Puts the caret in the long line, presses End and types a space. */
  private String typedAtEnd(String before) {
    int at = get(() -> area.getText().indexOf("<Coordinate DEF='Many'"));
    edt(() -> area.setCaretPosition(at));
    hands.press(KeyEvent.VK_END);
    int end = get(() -> area.getText().indexOf("'/>\n<Shape DEF='Pot'") + 3);
    hands.await("the caret at the end", () -> area.getCaretPosition() == end);
    hands.await("the end in view", this::caretIsSeen);
    edt(() -> area.replaceSelection(" "));
    hands.await("the caret in view", this::caretIsSeen);
    edt(panel::flush);
    return before.replace("'/>\n<Shape DEF='Pot'", "'/> \n<Shape DEF='Pot'");
  }

  private boolean caretIsSeen() {
    try {
      return area.getVisibleRect()
          .contains(area.modelToView2D(area.getCaretPosition()).getBounds());
    } catch (BadLocationException e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void aLongLineIsColoredToItsEndWhichCanBeReached() throws IOException {
    String before = open(40_000);
    theRestIsColoredAndFolded();
    assertThat(hasType("<Coordinate", TokenTypes.MARKUP_TAG_ATTRIBUTE_VALUE)).isTrue();
    assertThat(typedAtEnd(before)).isEqualTo(text());
    GuiRobot.picture(window.getContentPane(), "long-line", 1);
  }

  @Test
  void aVeryLongLineIsPlainAndTheLinesAroundItAreNot() throws IOException {
    String before = open(270_000);
    theRestIsColoredAndFolded();
    assertThat(hasType("<Coordinate", TokenTypes.MARKUP_TAG_NAME)).isFalse();
    assertThat(typedAtEnd(before)).isEqualTo(text());
  }

  @Test
  void noTokenOfALongLineIsLongAsEachClickMeasuresIt() throws IOException {
    open(40_000);
    int line = lineOf("<Coordinate");
    int longest =
        get(
            () -> {
              int most = 0;
              Token each = ((RSyntaxDocument) area.getDocument()).getTokenListForLine(line);
              for (; each != null; each = each.getNextToken()) {
                most = Math.max(most, each.length());
              }
              return most;
            });
    assertThat(longest).isBetween(1, 1000);
  }
}
