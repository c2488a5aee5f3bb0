package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.accessibility.AccessibleContext;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import javax.swing.JTree;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.ResourceLock;
import org.junit.jupiter.api.parallel.Resources;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;
import org.selectiverenderer.x3d.source.DocumentElement;

/** What a window is like that is worked in for an hour. */
@ShowsWindows
@Timeout(value = 180, unit = TimeUnit.SECONDS)
class WindowUsabilityTest {
  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();
  private EnricherWindow window;

  @AfterEach
  void close() {
    GuiRobot.onEdt(
        () -> {
          window.dispose();
          return true;
        });
  }

  private Path scene() throws IOException {
    return TestSessions.with(
            folder,
            "<Group DEF='Table'>"
                + TestSessions.object("Cup")
                + "</Group>"
                + TestSessions.object("Chair")
                + TestSessions.object("Armchair"))
        .file()
        .path();
  }

  private void show() throws IOException {
    Path settings = Files.createDirectories(folder.resolve("settings"));
    Files.writeString(settings.resolve("enricher.properties"), "theme=light\ntab=Help\n");
    window = GuiRobot.onEdt(() -> new EnricherWindow(settings, () -> {}));
    hands.show(window.frame());
  }

  private EnricherSession open(Path scene) {
    Optional<EnricherSession> before = window.session();
    GuiRobot.onEdt(
        () -> {
          window.open(scene);
          return true;
        });
    hands.await(
        "the scene", () -> window.session().isPresent() && !window.session().equals(before));
    return window.session().orElseThrow();
  }

  @Test
  void openingIsSaidAtOnceAndAFileThatCannotBeOpenedLeavesTheWelcome() throws IOException {
    show();
    JLabel welcome =
        GuiRobot.named(
            window.frame().getContentPane(),
            "Drop an X3D scene here, or press Ctrl+O to open one",
            JLabel.class);
    Path scene = scene();
    String said =
        GuiRobot.onEdt(
            () -> {
              window.open(scene);
              return welcome.getText();
            });
    assertThat(said).isEqualTo("Opening scene.x3d\u2026");
    hands.await("the scene", () -> window.session().isPresent());
  }

  @Test
  void anOpeningThatIsCancelledLeavesTheWelcome() throws IOException {
    show();
    JLabel welcome =
        GuiRobot.named(
            window.frame().getContentPane(),
            "Drop an X3D scene here, or press Ctrl+O to open one",
            JLabel.class);
    Path scene = scene();
    boolean cancelled =
        GuiRobot.onEdt(
            () -> {
              window.openUnasked(scene);
              return window.cancelTasks();
            });
    assertThat(cancelled).isTrue();
    hands.await("the welcome", () -> welcome.getText().startsWith("Drop an X3D scene"));
    assertThat(window.session()).isEmpty();
    assertThat(window.has(scene)).isFalse();
  }

  @Test
  void theFormKeepsItsWidthHoweverManyScenesAreOpened() throws IOException {
    show();
    Path scene = scene();
    open(scene);
    int before = formWidth();
    for (int i = 0; i < 3; i++) {
      open(scene);
    }
    assertThat(formWidth()).isEqualTo(before);
  }

  private int formWidth() {
    JComponent form =
        GuiRobot.named(
            window.frame().getContentPane(), "Form of the selected node", JComponent.class);
    return GuiRobot.onEdt(form::getWidth);
  }

  @Test
  void enterGoesFromHitToHitAndAProblemInAHiddenNodeShowsIt() throws IOException {
    show();
    EnricherSession session = open(scene());
    JTextField search =
        GuiRobot.named(window.frame().getContentPane(), "Search nodes", JTextField.class);
    JTree tree = GuiRobot.named(window.frame().getContentPane(), "Nodes of the scene", JTree.class);
    hands.click(search);
    "CHAIR".chars().forEach(hands::press);
    hands.press(KeyEvent.VK_ENTER);
    assertThat(selected(session)).contains("Switch_Chair");
    hands.press(KeyEvent.VK_ENTER);
    assertThat(selected(session)).contains("Switch_Armchair");
    hands.press(KeyEvent.VK_ENTER);
    assertThat(selected(session)).as("again from the first").contains("Switch_Chair");
    assertThat(GuiRobot.onEdt(search::isFocusOwner)).isTrue();
    GuiRobot.onEdt(
        () -> {
          search.setText("cup");
          search.postActionEvent();
          return true;
        });
    assertThat(selected(session)).contains("Switch_Cup");
    hands.await("the tree, which has the only hit", tree::isFocusOwner);
    GuiRobot.onEdt(
        () -> {
          var document = session.document();
          int at = document.text().toString().indexOf("DEF='Table'");
          document.type(at, at, "bboxSize='wide' ");
          return true;
        });
    hands.await(
        "the problem",
        () -> {
          window.bench().orElseThrow().nextProblem();
          return session.selection().flatMap(DocumentElement::def).equals(Optional.of("Table"));
        });
    assertThat(GuiRobot.onEdt(tree::getLastSelectedPathComponent))
        .isSameAs(session.selection().orElseThrow());
    String searched = GuiRobot.onEdt(search::getText);
    assertThat(searched).isEmpty();
  }

  private static Optional<String> selected(EnricherSession session) {
    return GuiRobot.onEdt(() -> session.selection().flatMap(DocumentElement::def));
  }

  @Test
  void theListOfKeysIsMadeOfWhatTheCommandsSay() throws IOException {
    show();
    open(scene());
    List<KeyBindingList.Entry> keys =
        GuiRobot.onEdt(
            () -> KeyBindingList.of(window.frame().getJMenuBar(), window.frame().getContentPane()));
    assertThat(keys)
        .contains(
            new KeyBindingList.Entry("File", "Ctrl+S", "Save"),
            new KeyBindingList.Entry("3D preview", "W", "Walk, or stop walking"));
    assertThat(keys).allSatisfy(entry -> assertThat(entry.part()).isNotBlank());
    assertThat(HelpDialogs.aboutText(Optional.of("Mesa")))
        .contains("MIT", "Zotos", System.getProperty("java.version"), "Mesa");
  }

  @Test
  void lettersGrowWithAllOfTheWindowAndStaySo() throws IOException {
    show();
    open(scene());
    JTree tree = GuiRobot.named(window.frame().getContentPane(), "Nodes of the scene", JTree.class);
    int row = GuiRobot.onEdt(tree::getRowHeight);
    hands.click(tree);
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_EQUALS);
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_EQUALS);
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_EQUALS);
    hands.await("larger rows", () -> tree.getRowHeight() > row);
    float larger = GuiRobot.onEdt(() -> tree.getFont().getSize2D());
    GuiRobot.onEdt(
        () -> {
          window.close();
          return true;
        });
    window = GuiRobot.onEdt(() -> new EnricherWindow(folder.resolve("settings"), () -> {}));
    float again = GuiRobot.onEdt(() -> window.frame().getJMenuBar().getFont().getSize2D());
    assertThat(again).isEqualTo(larger);
    GuiRobot.onEdt(
        () -> {
          window.look().zoom(0);
          return true;
        });
    assertThat(GuiRobot.onEdt(() -> window.frame().getJMenuBar().getFont().getSize2D()))
        .isLessThan(larger);
  }

  @Test
  @ResourceLock(Resources.LOCALE)
  void theWindowSpeaksTheLanguageThatTheSettingsNameAndAltGreekLettersWork() throws IOException {
    Locale before = Locale.getDefault(Locale.Category.DISPLAY);
    try {
      Path settings = Files.createDirectories(folder.resolve("settings"));
      Files.writeString(settings.resolve("enricher.properties"), "theme=light\nlanguage=el\n");
      window = GuiRobot.onEdt(() -> new EnricherWindow(settings, () -> {}));
      hands.show(window.frame());
      JMenu file = GuiRobot.onEdt(() -> window.frame().getJMenuBar().getMenu(0));
      assertThat(file.getText()).isEqualTo("\u0391\u03c1\u03c7\u03b5\u03af\u03bf");
      assertThat(file.getDisplayedMnemonicIndex()).isZero();
      GuiRobot.onEdt(
          () -> {
            KeyEvent alt =
                new KeyEvent(
                    window.frame().getRootPane(),
                    KeyEvent.KEY_PRESSED,
                    0,
                    InputEvent.ALT_DOWN_MASK,
                    KeyEvent.getExtendedKeyCodeForChar('\u03b1'),
                    '\u03b1');
            SwingUtilities.processKeyBindings(alt);
            return true;
          });
      hands.await("the opened menu", file::isPopupMenuVisible);
      GuiRobot.picture(window.frame().getRootPane(), "window-greek", 1);
    } finally {
      Locale.setDefault(Locale.Category.DISPLAY, before);
    }
  }

  @Test
  @ResourceLock(Resources.LOCALE)
  void inGreekNothingThatIsShownIsEnglishAndLettersOfAMenuAreUnique() throws IOException {
    Locale before = Locale.getDefault(Locale.Category.DISPLAY);
    try {
      Path settings = Files.createDirectories(folder.resolve("settings"));
      Files.writeString(settings.resolve("enricher.properties"), "theme=light\nlanguage=el\n");
      window = GuiRobot.onEdt(() -> new EnricherWindow(settings, () -> {}));
      hands.show(window.frame());
      Path scene = scene();
      GuiRobot.onEdt(
          () -> {
            window.open(scene);
            return true;
          });
      hands.await("the scene", () -> window.session().isPresent());
      List<String> english =
          GuiRobot.onEdt(
              () -> {
                List<String> shown = new ArrayList<>();
                shown(window.frame().getJMenuBar(), shown);
                shown(window.frame().getContentPane(), shown);
                return shown.stream()
                    .filter(text -> text.matches("(?s).*[A-Za-z]{3}.*"))
                    .filter(text -> !text.matches("(?s).*\\p{IsGreek}.*"))
                    .filter(text -> !text.endsWith(".json")) // the place of a file
                    .filter(text -> !text.matches("(?s).*\\b(Switch|Cup|Chair|X3D|English)\\b.*"))
                    .distinct()
                    .toList();
              });
      assertThat(english).isEmpty();
      GuiRobot.picture(window.frame().getRootPane(), "window-greek-scene", 1);
      assertLettersAreUnique();
    } finally {
      Locale.setDefault(Locale.Category.DISPLAY, before);
    }
  }

  @Test
  void inEnglishTheLettersOfAMenuAreUniqueToo() throws IOException {
    show();
    open(scene());
    assertLettersAreUnique();
  }

  private void assertLettersAreUnique() {
    GuiRobot.onEdt(
        () -> {
          for (int i = 0; i < window.frame().getJMenuBar().getMenuCount(); i++) {
            List<Integer> letters = new ArrayList<>();
            for (Component item : window.frame().getJMenuBar().getMenu(i).getMenuComponents()) {
              if (item instanceof AbstractButton button && button.getMnemonic() != 0) {
                letters.add(button.getMnemonic());
              }
            }
            assertThat(letters)
                .as(window.frame().getJMenuBar().getMenu(i).getText())
                .doesNotHaveDuplicates();
          }
          return true;
        });
  }

  /** The texts of menus, buttons, labels and tabs in a container, and their tooltips. */
  private static void shown(Container in, List<String> texts) {
    Component[] all = in instanceof JMenu menu ? menu.getMenuComponents() : in.getComponents();
    if (in instanceof JComponent one && one.getToolTipText() != null) {
      texts.add(one.getToolTipText());
    }
    if (in instanceof AbstractButton button) {
      texts.add(String.valueOf(button.getText()));
    } else if (in instanceof JLabel label) {
      texts.add(String.valueOf(label.getText()));
    } else if (in instanceof JTabbedPane tabs) {
      for (int i = 0; i < tabs.getTabCount(); i++) {
        texts.add(tabs.getTitleAt(i));
      }
    }
    for (Component each : all) {
      if (each instanceof Container more) {
        shown(more, texts);
      }
    }
  }

  @Test
  void theIconIsDrawnForEverySizeOfADesktop() throws IOException {
    show();
    assertThat(window.frame().getIconImages())
        .extracting(image -> image.getWidth(null))
        .contains(16, 32, 48, 256);
    assertThat(WindowIcon.image(16).getRGB(4, 8)).isNotEqualTo(WindowIcon.image(16).getRGB(12, 8));
  }

  @Test
  void noDescriptionHasMarkupInIt() throws IOException {
    show();
    EnricherSession session = open(scene());
    GuiRobot.onEdt(
        () -> {
          session.select(
              session.document().tree().orElseThrow().named("Switch_Cup").orElseThrow(), this);
          return true;
        });
    List<String> marked = new ArrayList<>();
    GuiRobot.onEdt(
        () -> {
          markup(window.frame().getRootPane(), marked);
          return true;
        });
    assertThat(marked).isEmpty();
  }

  private static void markup(Container in, List<String> found) {
    for (Component each : in.getComponents()) {
      AccessibleContext context = each.getAccessibleContext();
      if (context != null) {
        Stream.of(
                String.valueOf(context.getAccessibleName()),
                String.valueOf(context.getAccessibleDescription()))
            .filter(text -> text.contains("<html"))
            .forEach(found::add);
      }
      if (each instanceof Container more) {
        markup(more, found);
      }
    }
  }
}
