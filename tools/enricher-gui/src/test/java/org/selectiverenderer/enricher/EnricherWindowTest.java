package org.selectiverenderer.enricher;

import static java.awt.image.BufferedImage.TYPE_INT_RGB;
import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.Graphics2D;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import javax.swing.JTree;
import javax.swing.SwingUtilities;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.authoring.enrichment.ChoiceMetadata;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.authoring.headless.HeadlessEnrichment;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.enricher.component.AccessibleCanvas;
import org.selectiverenderer.enricher.diff.DiffDialog;
import org.selectiverenderer.enricher.ratings.RatingsDialog;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.AccessibleNameCheck;
import org.selectiverenderer.testing.robot.GuiRobot;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

/** The window under the hands of an author. */
@ShowsWindows
@Timeout(value = 180, unit = TimeUnit.SECONDS)
class EnricherWindowTest {
  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();
  private EnricherWindow window;

  private EnricherSession open(Path scene, String theme) throws IOException {
    Path settings = Files.createDirectories(folder.resolve("settings"));
    Files.writeString(settings.resolve("enricher.properties"), "theme=" + theme + "\n");
    window = GuiRobot.onEdt(() -> new EnricherWindow(settings, () -> {}));
    hands.show(window.frame());
    GuiRobot.onEdt(
        () -> {
          window.open(scene);
          return true;
        });
    hands.await("the scene", () -> window.session().isPresent());
    // A preview that is loading keeps the event queue busy, which the robot would wait for.
    GuiRobot.onEdt(
        () -> {
          window.bench().orElseThrow().showTab(broken(window) ? 2 : 4);
          return true;
        });
    return window.session().orElseThrow();
  }

  private static boolean broken(EnricherWindow window) {
    return window.session().orElseThrow().document().fault().isPresent();
  }

  @AfterEach
  void close() {
    if (window != null) {
      GuiRobot.onEdt(
          () -> {
            window.dispose();
            return true;
          });
    }
  }

  private Container content() {
    return window.frame().getContentPane();
  }

  private void clickRow(int row) {
    JTree tree = GuiRobot.named(content(), "Nodes of the scene", JTree.class);
    hands.click(tree);
    GuiRobot.onEdt(
        () -> {
          tree.setSelectionRow(row);
          return true;
        });
  }

  private void fill(String field, String letters) {
    JTextField text = GuiRobot.named(content(), field, JTextField.class);
    hands.click(text);
    letters.chars().forEach(hands::press);
    hands.press(KeyEvent.VK_ENTER);
  }

  private Path scene() throws IOException {
    return TestSessions.with(
            folder,
            TestSessions.object("Cup") + "<ProximitySensor DEF='KitchenArea' size='4 3 4'/>\n")
        .file()
        .path();
  }

  /** Thesis Fig 45. */
  @Test
  void anObjectIsChosenFilledInSavedAndThereAgain() throws IOException {
    EnricherSession session = open(scene(), "light");
    clickRow(0);
    JComboBox<?> type = GuiRobot.named(content(), "Type of choice 0", JComboBox.class);
    hands.click(type);
    hands.press(KeyEvent.VK_DOWN);
    hands.press(KeyEvent.VK_ENTER);
    fill("Schemas of choice 0", "KITCHEN");
    clickRow(1);
    fill("Schemas on entering", "KITCHEN");
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
    DiffDialog changes = hands.dialog(DiffDialog.class);
    GuiRobot.picture(changes.getContentPane(), "window-diff-light", 1);
    hands.choose(changes, "Save");
    hands.await("the saved file", () -> !session.document().modified());

    DocumentEnrichment again =
        new DocumentEnrichment(
            DocumentFile.open(session.file().path()).document(), NodeCatalogue.load());
    ChoiceMetadata first = again.switches().get(0).values().get(0);
    assertThat(first.schemas()).containsExactly("kitchen");
    assertThat(first.type()).isPresent();
    assertThat(again.sensors().get(0).schemas().enter()).containsExactly("kitchen");
    assertThat(session.file().backup()).exists();
  }

  @Test
  void aStepIsUndoneAndMadeAgainByKeys() throws IOException {
    EnricherSession session = open(scene(), "light");
    String before = session.document().snapshot().text();
    clickRow(0);
    fill("Schemas of choice 1", "OFFICE");
    hands.await("the edit", () -> session.document().modified());
    assertThat(window.frame().getJMenuBar().getMenu(1).getItem(0).getText())
        .isEqualTo("Undo Describe choice 1 of Switch_Cup");
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
    hands.await("the undone edit", () -> !session.document().modified());
    assertThat(session.document().snapshot().text()).isEqualTo(before);
    JTextField field = GuiRobot.named(content(), "Schemas of choice 1", JTextField.class);
    String text = GuiRobot.onEdt(field::getText);
    assertThat(text).isEmpty();
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_Z);
    hands.await("the edit again", () -> session.document().modified());
  }

  /** Thesis 5.4: what questionnaires say becomes the apartment's metadata. */
  @Test
  void theApartmentIsEnrichedFromItsRatings() throws IOException {
    Path plain = Path.of("scenes/apartment-plain.x3d");
    Path ratings = Path.of("scenes/apartment-ratings.csv");
    EnricherSession session = open(plain, "light");
    clickRow(0);
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_R);
    RatingsDialog dialog = hands.dialog(RatingsDialog.class);
    GuiRobot.onEdt(
        () -> {
          dialog.open(ratings);
          return true;
        });
    JButton apply = GuiRobot.named(dialog, "Apply", JButton.class);
    hands.await("the plan", apply::isEnabled);
    hands.choose(dialog, "Apply");
    assertThat(session.document().history().names()).hasSize(1);
    Path headless = folder.resolve("headless.x3d");
    HeadlessEnrichment.of(
            new HeadlessEnrichment.Request(plain, ratings, null, plain),
            NodeCatalogue.load(),
            new ProblemCollector())
        .orElseThrow()
        .save(headless);
    assertThat(session.document().snapshot().text()).isEqualTo(Files.readString(headless));
    GuiRobot.onEdt(() -> session.document().history().undo());
    assertThat(session.document().modified()).isFalse();
  }

  @Test
  void aFileThatMayNotBeWrittenIsToldAndNothingIsLost() throws IOException {
    EnricherSession session = open(scene(), "dark");
    clickRow(0);
    fill("Schemas of choice 0", "KITCHEN");
    Path backup = Files.createDirectory(session.file().backup());
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
    hands.choose(hands.dialog(DiffDialog.class), "Save");
    JDialog told = hands.dialog(JDialog.class);
    GuiRobot.picture(told.getContentPane(), "window-cannot-save-dark", 1);
    hands.choose(told, "OK");
    assertThat(session.document().modified()).isTrue();
    assertThat(session.file().path()).content().doesNotContain("kitchen");
    Files.delete(backup);
    clickRow(0); // no window manager gives the focus back
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
    hands.choose(hands.dialog(DiffDialog.class), "Save");
    hands.await("the saved file", () -> !session.document().modified());
    assertThat(session.file().path()).content().contains("kitchen");
  }

  @Test
  void aChangeByAnotherProgramIsAskedAboutBeforeItIsOverwritten() throws IOException {
    EnricherSession session = open(scene(), "light");
    clickRow(0);
    fill("Schemas of choice 0", "KITCHEN");
    Files.writeString(session.file().path(), "<X3D><Scene><!-- theirs --></Scene></X3D>");
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
    JDialog asked = hands.dialog(JDialog.class);
    assertThat(asked).as("the question comes before the changes").isNotInstanceOf(DiffDialog.class);
    GuiRobot.picture(asked.getContentPane(), "window-overwrite-light", 1);
    hands.choose(asked, "Cancel");
    assertThat(session.file().path()).content().contains("theirs");
    assertThat(session.document().modified()).isTrue();
  }

  @Test
  void everyPartIsReachedByOneKey() throws IOException {
    open(scene(), "light");
    clickRow(0);
    JTree tree = GuiRobot.named(content(), "Nodes of the scene", JTree.class);
    JComponent form = GuiRobot.named(content(), "Form of the selected node", JComponent.class);
    JComponent problems = GuiRobot.named(content(), "Problems", JComponent.class);
    hands.await("the focus", tree::isFocusOwner);
    hands.press(KeyEvent.VK_F6);
    hands.press(KeyEvent.VK_F6);
    hands.await("the form", () -> hasFocus(form));
    hands.press(KeyEvent.VK_F6);
    hands.await("the problems", () -> hasFocus(problems));
    hands.press(KeyEvent.VK_F6);
    hands.await("the tree", tree::isFocusOwner);
  }

  /** The keys of a view (M, F, arrows) work at once, and are not typed into its tool bar. */
  @Test
  void theKeyOfAViewGivesItsPictureTheFocus() throws IOException {
    open(scene(), "light");
    clickRow(0);
    for (int key : new int[] {KeyEvent.VK_4, KeyEvent.VK_1, KeyEvent.VK_4}) {
      hands.press(KeyEvent.VK_CONTROL, key);
      awaitFocusOfPicture(key == KeyEvent.VK_4 ? "area.plan" : "preview.picture");
    }
  }

  private void awaitFocusOfPicture(String text) {
    String wanted = Texts.of(text);
    hands.await(
        "the keyboard in " + wanted,
        () ->
            KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner()
                    instanceof AccessibleCanvas picture
                && picture.isShowing()
                && picture.getAccessibleContext().getAccessibleName().equals(wanted));
  }

  /** On a busy machine the tabs are laid out before the focus has left the hidden view. */
  @Test
  void aViewLaidOutBeforeTheFocusArrivesKeepsItsPictureFocused() throws IOException {
    open(scene(), "light");
    clickRow(0);
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_4);
    awaitFocusOfPicture("area.plan");
    GuiRobot.onEdt(
        () -> {
          window.bench().orElseThrow().showTab(0);
          window.frame().validate();
          return true;
        });
    awaitFocusOfPicture("preview.picture");
  }

  private static boolean hasFocus(Container part) {
    Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
    return owner != null && SwingUtilities.isDescendingFrom(owner, part);
  }

  /** What a menu does by a key it shows; only the recent files, which change, have none. */
  @Test
  void everyCommandOfTheMenusShowsAKey() throws IOException {
    open(scene(), "light");
    List<String> keyless =
        GuiRobot.onEdt(
            () ->
                Stream.of(window.frame().getJMenuBar().getComponents())
                    .flatMap(menu -> Stream.of(((JMenu) menu).getMenuComponents()))
                    .filter(item -> item instanceof JMenuItem && !(item instanceof JMenu))
                    .map(JMenuItem.class::cast)
                    .filter(item -> item.getAccelerator() == null && item.getMnemonic() == 0)
                    .map(JMenuItem::getText)
                    .toList());
    assertThat(keyless).isEmpty();
  }

  @Test
  void aSceneThatIsNotWellFormedOpensAtTheFault() throws IOException {
    Path broken = Files.writeString(folder.resolve("broken.x3d"), "<X3D>\n<Scene>\n</X3D>\n");
    open(broken, "light");
    JTabbedPane tabs = GuiRobot.named(content(), "Views of the scene", JTabbedPane.class);
    String shown = GuiRobot.onEdt(() -> tabs.getTitleAt(tabs.getSelectedIndex()));
    assertThat(shown).isEqualTo("Source");
    RSyntaxTextArea source =
        GuiRobot.named(content(), "Source of the scene", RSyntaxTextArea.class);
    hands.await("the error's mark", () -> reddish(source));
    GuiRobot.picture(content(), "window-broken-light", 1);
  }

  /** Whether a line is marked: much more red than blue, over a whole line's length. */
  private static boolean reddish(JComponent shown) {
    BufferedImage image = new BufferedImage(shown.getWidth(), shown.getHeight(), TYPE_INT_RGB);
    Graphics2D graphics = image.createGraphics();
    shown.paint(graphics);
    graphics.dispose();
    int red = 0;
    for (int y = 0; y < image.getHeight(); y++) {
      int rgb = image.getRGB(image.getWidth() - 2, y);
      red += (rgb >> 16 & 0xff) - (rgb & 0xff) > 25 ? 1 : 0;
    }
    return red > 8;
  }

  private static long colours(JComponent shown) {
    BufferedImage image = new BufferedImage(shown.getWidth(), shown.getHeight(), TYPE_INT_RGB);
    Graphics2D graphics = image.createGraphics();
    shown.paint(graphics);
    graphics.dispose();
    int width = image.getWidth();
    return Arrays.stream(image.getRGB(0, 0, width, image.getHeight(), null, 0, width))
        .distinct()
        .count();
  }

  @ParameterizedTest
  @ValueSource(strings = {"light", "dark"})
  void everyControlHasAName(String theme) throws IOException {
    Path scene = Path.of("scenes/apartment.x3d");
    EnricherSession session = open(scene, theme);
    GuiRobot.onEdt(
        () -> {
          session.select(
              session.document().tree().orElseThrow().named("Switch_TrashCan").orElseThrow(), this);
          return true;
        });
    JTabbedPane tabs = GuiRobot.named(content(), "Views of the scene", JTabbedPane.class);
    JComponent picture = GuiRobot.named(content(), "Picture of choice 0", JComponent.class);
    hands.await("the picture", () -> colours(picture) > 10);
    for (String view : List.of("Preview", "Schemas", "Source", "Help")) {
      GuiRobot.onEdt(
          () -> {
            tabs.setSelectedIndex(tabs.indexOfTab(view));
            return true;
          });
      hands.await("quiet", () -> session.tasks().running().isEmpty());
      if (view.equals("Preview")) {
        JComponent shown = GuiRobot.named(content(), "3D preview", JComponent.class);
        hands.await("a picture", () -> colours(shown) > 50);
      }
      String name = "window-" + view.toLowerCase(java.util.Locale.ROOT) + "-" + theme;
      GuiRobot.picture(window.frame().getRootPane(), name, 1);
      GuiRobot.picture(window.frame().getRootPane(), name + "-200", 2);
    }
    List<String> unnamed = GuiRobot.onEdt(() -> AccessibleNameCheck.missing(window.frame()));
    assertThat(unnamed).isEmpty();
  }
}
