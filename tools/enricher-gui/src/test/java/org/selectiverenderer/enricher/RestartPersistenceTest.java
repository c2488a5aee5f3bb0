package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.swing.JDialog;
import javax.swing.JTabbedPane;
import javax.swing.JTree;
import javax.swing.SwingUtilities;
import javax.swing.TransferHandler;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.ratings.RatingsDialog;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;

/** What is remembered from one start of the window to the next, and what a crash leaves. */
@ShowsWindows
@Timeout(value = 180, unit = TimeUnit.SECONDS)
class RestartPersistenceTest {
  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();
  private EnricherWindow window;

  private void start(Optional<Path> scene) throws IOException {
    Path settings = folder.resolve("settings");
    if (Files.notExists(settings)) {
      Files.createDirectories(settings);
      Files.writeString(settings.resolve("enricher.properties"), "theme=light\ntab=Help\n");
    }
    window = GuiRobot.onEdt(() -> new EnricherWindow(settings, () -> {}));
    hands.show(window.frame());
    SwingUtilities.invokeLater(() -> window.begin(scene));
  }

  private EnricherSession opened(Path scene) {
    hands.await(
        "the scene",
        () -> window.session().filter(open -> open.file().path().equals(scene)).isPresent());
    return window.session().orElseThrow();
  }

  private void run(Runnable work) {
    GuiRobot.onEdt(
        () -> {
          work.run();
          return true;
        });
  }

  @AfterEach
  void end() {
    run(() -> Stream.of(java.awt.Window.getWindows()).forEach(java.awt.Window::dispose));
    if (window != null) {
      run(window::dispose);
    }
  }

  private Path scene(String name) throws IOException {
    Path own = Files.createDirectories(folder.resolve(name));
    return TestSessions.with(own, TestSessions.object(name)).file().path();
  }

  /** Unsaved work, kept, in a window that goes without asking. */
  private void crash(Path scene) throws IOException {
    start(Optional.of(scene));
    EnricherSession session = opened(scene);
    run(() -> session.document().type(0, 0, "<!-- mine -->"));
    run(() -> window.bench().orElseThrow().autosave().keep());
    hands.await("the kept copy", () -> kept() == 2);
    run(window::dispose);
  }

  /** Files of what is kept, but for those that are still being written under another name. */
  private long kept() {
    try (Stream<Path> files = Files.list(folder.resolve("settings/recovery"))) {
      return files.filter(file -> file.toString().matches(".*\\.(scene|properties)")).count();
    } catch (IOException e) {
      return 0; // there is no folder before something is kept
    }
  }

  @Test
  void workThatACrashLeftIsOfferedAlsoWithAnotherSceneAndKeptUntilOneDecides() throws IOException {
    Path cup = scene("Cup");
    Path bowl = scene("Bowl");
    crash(cup);
    start(Optional.of(bowl));
    JDialog question = hands.dialog(JDialog.class);
    GuiRobot.picture(question.getContentPane(), "window-kept", 2);
    hands.choose(question, "Decide Later");
    opened(bowl);
    run(window::close);
    assertThat(kept()).isEqualTo(2);

    start(Optional.empty());
    hands.choose(hands.dialog(JDialog.class), "Restore");
    EnricherSession session = opened(cup.toAbsolutePath());
    assertThat(session.document().text().toString()).startsWith("<!-- mine -->");
    assertThat(session.document().history().undoName()).contains("Recover unsaved changes");
    assertThat(cup).content().doesNotContain("mine");
    assertThat(kept()).as("until it is saved").isEqualTo(2);
    run(() -> session.document().history().undo());
    run(window::close);
    assertThat(kept()).isZero();
  }

  @Test
  void aKeptCopyIsDiscardedOnlyWhenTheAuthorSaysSo() throws IOException {
    Path cup = scene("Cup");
    crash(cup);
    start(Optional.of(cup));
    hands.choose(hands.dialog(JDialog.class), "Discard the Kept Copy");
    EnricherSession session = opened(cup);
    assertThat(session.document().modified()).isFalse();
    assertThat(kept()).isZero();
  }

  @Test
  void theWindowStandsWhereItWasWithTheSameViewInFront() throws IOException {
    Path cup = scene("Cup");
    start(Optional.of(cup));
    opened(cup);
    JTabbedPane tabs = GuiRobot.named(window.frame(), "Views of the scene", JTabbedPane.class);
    run(
        () -> {
          tabs.setSelectedIndex(tabs.indexOfTab("Source"));
          window.frame().setBounds(123, 64, 900, 640);
        });
    hands.await("the size", () -> window.frame().getWidth() == 900);
    run(window::close);
    start(Optional.of(cup));
    opened(cup);
    assertThat(GuiRobot.onEdt(() -> window.frame().getSize()))
        .hasToString(new java.awt.Dimension(900, 640).toString());
    assertThat(GuiRobot.onEdt(() -> window.frame().getLocation())).isEqualTo(new Point(123, 64));
    JTabbedPane again = GuiRobot.named(window.frame(), "Views of the scene", JTabbedPane.class);
    assertThat(GuiRobot.onEdt(() -> again.getTitleAt(again.getSelectedIndex())))
        .isEqualTo("Source");
    assertThat(window.recent().list()).containsExactly(cup.toAbsolutePath().normalize());
  }

  @Test
  void aWindowOfAScreenThatIsGoneStandsOnOneThatIsThere() throws IOException {
    Path settings = Files.createDirectories(folder.resolve("settings"));
    Files.writeString(
        settings.resolve("enricher.properties"), "theme=light\nwindow.x=9000\nwindow.y=-5000\n");
    start(Optional.empty());
    Point at = GuiRobot.onEdt(() -> window.frame().getLocation());
    assertThat(window.frame().getGraphicsConfiguration().getBounds())
        .satisfies(screen -> assertThat(screen.contains(at)).isTrue());
  }

  @Test
  void aWindowThatIsLargerThanTheScreenIsMadeToFit() throws IOException {
    Path settings = Files.createDirectories(folder.resolve("settings"));
    Files.writeString(
        settings.resolve("enricher.properties"),
        "theme=light\nwindow.x=200\nwindow.y=50\nwindow.width=5000\nwindow.height=4000\n");
    start(Optional.empty());
    Rectangle screen = GuiRobot.onEdt(() -> window.frame().getGraphicsConfiguration().getBounds());
    assertThat(screen.contains(GuiRobot.onEdt(() -> window.frame().getBounds()))).isTrue();
  }

  /** Files as a desktop hands them over. */
  private record Dropped(List<File> files) implements Transferable {
    @Override
    public DataFlavor[] getTransferDataFlavors() {
      return new DataFlavor[] {DataFlavor.javaFileListFlavor};
    }

    @Override
    public boolean isDataFlavorSupported(DataFlavor flavor) {
      return flavor.equals(DataFlavor.javaFileListFlavor);
    }

    @Override
    public Object getTransferData(DataFlavor flavor) {
      return files;
    }
  }

  @Test
  void aDroppedSceneIsOpenedAndDroppedRatingsAreReviewed() throws IOException {
    Path cup = scene("Cup");
    start(Optional.empty());
    TransferHandler drop = GuiRobot.onEdt(() -> window.frame().getTransferHandler());
    boolean taken =
        GuiRobot.onEdt(
            () ->
                drop.importData(
                    new TransferHandler.TransferSupport(
                        window.frame().getRootPane(), new Dropped(List.of(cup.toFile())))));
    assertThat(taken).isTrue();
    opened(cup);

    JTree tree = GuiRobot.named(window.frame(), "Nodes of the scene", JTree.class);
    Path ratings = Files.writeString(folder.resolve("r.csv"), "object,schema,rating\nCup,Bar,5\n");
    GuiRobot.onEdt(
        () ->
            tree.getTransferHandler()
                .importData(
                    new TransferHandler.TransferSupport(
                        tree, new Dropped(List.of(ratings.toFile())))));
    RatingsDialog dialog = hands.dialog(RatingsDialog.class);
    hands.choose(dialog, "Cancel");
  }

  @Test
  void aSceneThatIsNotThereIsToldInOneSentence() throws IOException {
    start(Optional.of(folder.resolve("none.x3d")));
    JDialog told = hands.dialog(JDialog.class);
    GuiRobot.picture(told.getContentPane(), "window-none", 2);
    hands.choose(told, "OK");
    assertThat(window.session()).isEmpty();
  }
}
