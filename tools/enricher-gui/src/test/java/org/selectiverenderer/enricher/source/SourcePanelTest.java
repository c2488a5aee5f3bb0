package org.selectiverenderer.enricher.source;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.enricher.EventThread.edt;
import static org.selectiverenderer.enricher.EventThread.get;

import java.awt.Component;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;

/** The source view under the hands of an author. */
@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class SourcePanelTest {
  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();
  private final JFrame window = get(() -> new JFrame("Source"));
  private EnricherSession session;
  private SourcePanel panel;

  private void open(String nodes) throws IOException {
    TestSessions.theme(false);
    session = TestSessions.with(folder, nodes);
    panel = get(() -> new SourcePanel(session));
    edt(
        () -> {
          window.getContentPane().add(panel.component());
          window.setBounds(10, 10, 900, 600);
        });
    hands.show(window);
    hands.click(panel.area());
  }

  @AfterEach
  void close() {
    edt(
        () -> {
          panel.dispose();
          window.dispose();
        });
  }

  private SceneDocument document() {
    return session.document();
  }

  private String text() {
    return get(() -> document().snapshot().text());
  }

  private int steps() {
    return get(() -> document().history().names().size());
  }

  /** Types as a key does: at the caret, which follows. */
  private void type(String letters) {
    edt(() -> letters.chars().forEach(c -> panel.area().replaceSelection("" + (char) c)));
  }

  private void caretBehind(String words) {
    edt(
        () ->
            panel.area().setCaretPosition(panel.area().getText().indexOf(words) + words.length()));
  }

  @Test
  void aStepOfUndoEndsAtAPauseAJumpALineAndWhenTheFocusGoes() throws IOException {
    open("<Group DEF='A'/>\n<Group DEF='B'/>\n");
    String before = text();
    caretBehind("DEF='A");
    type("bc");
    edt(panel::flush);
    type("d");
    edt(panel::flush);
    assertThat(steps()).isEqualTo(1);
    hands.await("the pause", () -> !document().history().typing());
    type("e");
    caretBehind("DEF='B");
    assertThat(steps()).isEqualTo(2);
    type("f");
    caretBehind("<Group DEF='Bf'/>");
    type("\nx");
    edt(panel::flush);
    assertThat(steps()).isEqualTo(5);
    type("y");
    hands.await("the focus", () -> panel.area().isFocusOwner());
    edt(() -> window.getRootPane().setFocusable(true));
    edt(() -> window.getRootPane().requestFocusInWindow());
    hands.await("its going", () -> !document().history().typing());
    edt(() -> assertThat(panel.area().isFocusOwner()).isFalse());
    edt(() -> document().history().undo());
    assertThat(text()).contains("'Abcde'").contains("'Bf'/>\n\n");
    edt(() -> document().history().undo());
    edt(() -> document().history().undo());
    assertThat(text()).contains("'Abcde'").contains("DEF='B'/>");
    edt(() -> document().history().undo());
    assertThat(text()).contains("'Abcd'");
    edt(() -> document().history().undo());
    assertThat(text()).isEqualTo(before);
  }

  @Test
  void aShortSceneHasAllOfTheTab() throws IOException {
    open("<Group/>\n");
    int height = get(() -> panel.area().getParent().getParent().getHeight());
    assertThat(height).isGreaterThan(get(() -> panel.component().getHeight()) - 20);
  }

  @Test
  void wordsAreFoundCountedAndReplacedAsOneStep() throws IOException {
    open("<Group DEF='Cup1'/>\n<Group DEF='Cup2'/>\n<Group DEF='cup3'/>\n");
    edt(() -> panel.area().setCaretPosition(0));
    edt(() -> panel.find(true));
    JTextField words = named("findWords", JTextField.class);
    JTextField by = named("findReplacement", JTextField.class);
    edt(() -> words.setText("cup"));
    hands.await("the hits", () -> state().equals("1 of 3"));
    edt(() -> named("findMatchCase", JCheckBox.class).doClick());
    assertThat(get(this::state)).isEqualTo("1 of 1");
    edt(() -> named("findMatchCase", JCheckBox.class).doClick());
    assertThat(get(this::state)).isEqualTo("3 of 3");
    edt(() -> panel.findNext(1));
    assertThat(get(this::state)).isEqualTo("1 of 3, from the other end");
    assertThat(get(() -> panel.area().getSelectedText())).isEqualTo("Cup");
    GuiRobot.picture(window.getContentPane(), "source-find", 1);
    edt(() -> by.setText("Mug"));
    edt(() -> named("replaceAll", JButton.class).doClick());
    assertThat(text()).contains("'Mug1'").contains("'Mug2'").contains("'Mug3'");
    assertThat(steps()).isEqualTo(1);
    edt(() -> document().history().undo());
    assertThat(text()).contains("'Cup1'").contains("'cup3'");
  }

  private String state() {
    return named("findState", JLabel.class).getText();
  }

  private <T extends Component> T named(String name, Class<T> type) {
    return type.cast(NamedComponents.find(panel.component(), name));
  }

  @Test
  void whatTheCatalogueKnowsIsProposedAndTakenByKeys() throws IOException {
    open("<Shape>\n<Box size='1 1 1' />\n</Shape>\n");
    caretBehind("size='1 1 1' ");
    type("so");
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SPACE);
    hands.press(KeyEvent.VK_ENTER);
    assertThat(get(() -> panel.area().getText())).contains("size='1 1 1' solid=''/>");
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SPACE);
    hands.press(KeyEvent.VK_DOWN);
    hands.press(KeyEvent.VK_ENTER);
    edt(panel::flush);
    assertThat(text()).contains("<Box size='1 1 1' solid='false'/>");
  }

  @Test
  void theQuoteThatACompletionWroteIsTypedOver() throws IOException {
    open("<Shape>\n<Box size='1 1 1' />\n</Shape>\n");
    caretBehind("size='1 1 1' ");
    type("so");
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SPACE);
    hands.press(KeyEvent.VK_ENTER);
    type("true");
    hands.press(KeyEvent.VK_QUOTE);
    assertThat(get(() -> panel.area().getText())).contains("size='1 1 1' solid='true'/>");
    hands.press(KeyEvent.VK_QUOTE);
    assertThat(get(() -> panel.area().getText())).contains("solid='true''/>");
  }

  @Test
  void tabGoesFromTheWordsToWhatReplacesThem() throws IOException {
    open("<Group DEF='Cup1'/>\n");
    edt(() -> panel.find(true));
    hands.await("the keyboard", () -> named("findWords", JTextField.class).isFocusOwner());
    for (String next : List.of("findReplacement", "replaceOne", "replaceAll", "findPrevious")) {
      hands.press(KeyEvent.VK_TAB);
      hands.await("the keyboard in " + next, () -> named(next, JComponent.class).isFocusOwner());
    }
  }

  @Test
  void tagsAreMatchedCommentedAndLinesGoneTo() throws IOException {
    open("<Group DEF='G'>\n  <Shape/>\n</Group>\n");
    caretBehind("<Group");
    edt(panel::goToMatchingTag);
    int end = get(() -> panel.area().getText()).indexOf("</Group>");
    assertThat(get(() -> panel.area().getCaretPosition())).isEqualTo(end);
    edt(() -> panel.goToLine(4));
    edt(panel::toggleComment);
    assertThat(text()).contains("  <!-- <Shape/> -->\n");
    edt(panel::toggleComment);
    assertThat(text()).contains("\n  <Shape/>\n");
    assertThat(steps()).isEqualTo(2);
  }

  @Test
  void endTagsAreCompleted() throws IOException {
    open("<Group>\n");
    caretBehind("<Group>");
    type("<Shape><");
    edt(
        () ->
            panel
                .area()
                .dispatchEvent(
                    new KeyEvent(
                        panel.area(), KeyEvent.KEY_TYPED, 0, 0, KeyEvent.VK_UNDEFINED, '/')));
    assertThat(get(() -> panel.area().getText())).contains("<Group><Shape></Shape>\n");
  }

  /** A page of a large text is read when it is looked at, not for every selection elsewhere. */
  @Test
  void aHiddenPartOfALargeTextIsTurnedToWhenItIsSeen() throws IOException {
    StringBuilder nodes = new StringBuilder();
    for (int i = 0; i < 60_000; i++) {
      nodes.append("<Group DEF='Group_Number_").append(i).append("'/>\n");
    }
    open(nodes.toString());
    edt(() -> panel.component().setVisible(false));
    String shown = get(() -> panel.area().getText());
    edt(
        () ->
            session.select(
                document().tree().orElseThrow().named("Group_Number_50000").orElseThrow(), this));
    assertThat(get(() -> panel.area().getText())).isEqualTo(shown);
    edt(() -> panel.component().setVisible(true));
    hands.await(
        "the selected element",
        () -> panel.area().getText().startsWith("<Group DEF='Group_Number_50000'", caret()));
  }

  private int caret() {
    return panel.area().getCaretPosition();
  }
}
