package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JRadioButton;
import javax.swing.JTable;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.access.AccessDialog;
import org.selectiverenderer.enricher.newscene.NewSceneDialog;
import org.selectiverenderer.enricher.settings.AllowedPlaces;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.AccessibleNameCheck;
import org.selectiverenderer.testing.robot.GuiRobot;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/** Several windows of one process, new scenes, and what scenes may read. */
@ShowsWindows
@Timeout(value = 180, unit = TimeUnit.SECONDS)
class EnricherWindowsTest {
  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();
  private final AtomicInteger closed = new AtomicInteger();
  private EnricherWindows windows;
  private EnricherWindow window;

  private void show() throws IOException {
    Path settings = Files.createDirectories(folder.resolve("settings"));
    Files.writeString(settings.resolve("enricher.properties"), "theme=light\ntab=Help\n");
    windows =
        GuiRobot.onEdt(
            () ->
                new EnricherWindows(settings, ContentAccessPolicy.none(), closed::incrementAndGet));
    window = GuiRobot.onEdt(() -> new EnricherWindow(windows));
    hands.show(window.frame());
  }

  @AfterEach
  void close() {
    GuiRobot.onEdt(
        () -> {
          windows.all().forEach(EnricherWindow::dispose);
          return true;
        });
    assertThat(closed).hasValue(1);
  }

  private Path scene(String name, String nodes) throws IOException {
    return Files.writeString(
        folder.resolve(name), "<X3D version='4.0'>\n<Scene>\n" + nodes + "</Scene>\n</X3D>\n");
  }

  private void open(EnricherWindow in, Path scene) {
    later(() -> in.open(scene));
    hands.await("the scene", () -> in.has(scene) && in.session().isPresent());
  }

  private static void later(Runnable work) {
    EventQueue.invokeLater(work);
  }

  @Test
  void eachWindowHasAFileOfItsOwnAndAFileIsInOneOnly() throws IOException {
    show();
    Path one = scene("one.x3d", "");
    Path two = scene("two.x3d", "");
    open(window, one);
    later(() -> windows.openNew(two));
    hands.await(
        "a second window",
        () -> windows.all().size() == 2 && windows.all().get(1).session().isPresent());
    EnricherWindow second = windows.all().get(1);
    assertThat(second.frame().getLocation()).isNotEqualTo(window.frame().getLocation());
    later(() -> windows.openNew(one));
    later(() -> second.open(one));
    hands.await("nothing new", () -> second.has(two) && !second.has(one));
    assertThat(windows.all()).hasSize(2);
    later(second::close);
    hands.await("one window", () -> windows.all().size() == 1);
    assertThat(closed).hasValue(0);
  }

  @Test
  void aNewRoomIsWrittenAndOpenedAndNothingIsReplacedUnasked() throws IOException {
    show();
    later(window.files()::newScene);
    NewSceneDialog dialog = hands.dialog(NewSceneDialog.class);
    assertThat(AccessibleNameCheck.missing(dialog)).isEmpty();
    Path file = folder.resolve("room");
    type(GuiRobot.named(dialog, "File", JTextField.class), file.toString());
    GuiRobot.picture(dialog.getContentPane(), "window-new-scene", 1);
    hands.choose(dialog, "Create");
    Path written = folder.resolve("room.x3d");
    hands.await("the scene", () -> window.session().isPresent());
    assertThat(window.has(written)).isTrue();
    assertThat(written).content().contains("DEF='WallNorth'");
    assertThat(window.session().orElseThrow().document().fault()).isEmpty();

    Files.writeString(folder.resolve("mine.x3d"), "mine");
    later(window.files()::newScene);
    NewSceneDialog again = hands.dialog(NewSceneDialog.class);
    hands.click(GuiRobot.named(again, "Empty, with a viewpoint", JRadioButton.class));
    type(GuiRobot.named(again, "File", JTextField.class), folder.resolve("mine.x3d").toString());
    hands.click(GuiRobot.named(again, "Create", JButton.class));
    hands.choose(question(again), "Cancel");
    hands.choose(again, "Cancel");
    assertThat(folder.resolve("mine.x3d")).hasContent("mine");
  }

  @Test
  void aFolderThatTheAuthorAllowsIsReadAndRemembered() throws IOException {
    show();
    Path shared = Files.createDirectories(folder.resolve("shared"));
    Files.writeString(shared.resolve("cup.x3d"), "<X3D version='4.0'><Scene/></X3D>");
    Path own = Files.createDirectories(folder.resolve("own/scenes"));
    Path scene =
        Files.writeString(
            own.resolve("scene.x3d"),
            "<X3D version='4.0'><Scene><Inline url='\"../../shared/cup.x3d\"'/></Scene></X3D>");
    open(window, scene);
    JTable problems =
        GuiRobot.named(window.frame().getContentPane(), "Problems of the scene", JTable.class);
    hands.await("the problem", () -> text(problems).contains("File > Allowed Folders and Hosts"));
    later(window.files()::allow);
    AccessDialog dialog = hands.dialog(AccessDialog.class);
    assertThat(AccessibleNameCheck.missing(dialog)).isEmpty();
    later(() -> dialog.allow(shared));
    type(GuiRobot.named(dialog, "Host to add", JTextField.class), "*.Example.org");
    GuiRobot.picture(dialog.getContentPane(), "window-allowed", 1);
    hands.choose(dialog, "OK");
    hands.await("no problem", () -> !text(problems).contains("points outside"));
    EnricherSettings stored = new EnricherSettings(folder.resolve("settings"));
    stored.load();
    AllowedPlaces kept = AllowedPlaces.of(stored, scene);
    assertThat(kept.folders()).containsExactly(shared);
    assertThat(kept.hosts()).extracting(host -> host.text()).containsExactly("*.example.org");
    assertThat(AllowedPlaces.of(stored, own.resolve("other.x3d"))).isEqualTo(AllowedPlaces.NONE);
  }

  /** Waits for a question over a dialog. */
  private JDialog question(JDialog over) {
    hands.await("a question", () -> over.getOwnedWindows().length > 0);
    return (JDialog) over.getOwnedWindows()[0];
  }

  private static void type(JTextField field, String text) {
    GuiRobot.onEdt(
        () -> {
          field.setText(text);
          return true;
        });
  }

  private static String text(JTable table) {
    StringBuilder text = new StringBuilder();
    for (int row = 0; row < table.getRowCount(); row++) {
      for (int column = 0; column < table.getColumnCount(); column++) {
        text.append(table.getValueAt(row, column)).append(' ');
      }
    }
    return text.toString();
  }
}
