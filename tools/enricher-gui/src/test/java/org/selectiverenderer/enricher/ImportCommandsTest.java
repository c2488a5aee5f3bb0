package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Point;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import javax.swing.JDialog;
import javax.swing.JRadioButton;
import javax.swing.JTree;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.importing.ImportDialog;
import org.selectiverenderer.enricher.importing.PackageDialog;
import org.selectiverenderer.enricher.newscene.NewSceneDialog;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.AccessibleNameCheck;
import org.selectiverenderer.testing.robot.GuiRobot;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Models that are dropped on a scene become part of it, and a scene leaves with its files. */
@ShowsWindows
@Timeout(value = 180, unit = TimeUnit.SECONDS)
class ImportCommandsTest {
  private static final String FLOOR =
      """
      <Viewpoint position='0 2 4' orientation='1 0 0 -0.6'/>
      <Transform translation='0 -0.5 0'><Shape><Box size='20 1 20'/></Shape></Transform>
      """;

  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();
  private EnricherWindow window;
  private Path model;

  private EnricherSession open() throws IOException {
    Path settings = Files.createDirectories(folder.resolve("settings"));
    Files.writeString(settings.resolve("enricher.properties"), "theme=light\ntab=Preview\n");
    window = GuiRobot.onEdt(() -> new EnricherWindow(settings, () -> {}));
    hands.show(window.frame());
    Path scene = scene("room.x3d");
    later(() -> window.open(scene));
    hands.await("the scene", () -> window.session().isPresent());
    model =
        Files.writeString(
            Files.createDirectories(folder.resolve("downloads")).resolve("block.obj"),
            "v 4 1 4\nv 6 1 4\nv 6 1 6\nv 5 3 5\nf 1 2 3\nf 1 2 4\n");
    return window.session().orElseThrow();
  }

  private Path scene(String name) throws IOException {
    return Files.writeString(
        Files.createDirectories(work()).resolve(name),
        "<X3D version='4.0'>\n<Scene>\n" + FLOOR + "</Scene>\n</X3D>\n");
  }

  private Path work() {
    return folder.resolve("work");
  }

  @AfterEach
  void close() {
    GuiRobot.onEdt(
        () -> {
          window.dispose();
          return true;
        });
  }

  private static void later(Runnable work) {
    EventQueue.invokeLater(work);
  }

  private ImportDialog drop(Component over, Point at) {
    later(() -> window.imports().dropped(model, over, at));
    ImportDialog dialog = hands.dialog(ImportDialog.class);
    assertThat(AccessibleNameCheck.missing(dialog)).isEmpty();
    return dialog;
  }

  private Component preview() {
    return window.bench().orElseThrow().drops().preview();
  }

  @Test
  void aModelDroppedOnThePreviewStandsWhereTheMouseIs() throws IOException {
    EnricherSession session = open();
    hands.await("a picture", () -> window.bench().orElseThrow().drawnBy().isPresent());
    ImportDialog dialog =
        drop(preview(), new Point(preview().getWidth() / 2, preview().getHeight() / 2));
    GuiRobot.picture(dialog.getContentPane(), "window-import", 1);
    assertThat(GuiRobot.named(dialog, "Link to it", JRadioButton.class).isEnabled()).isFalse();
    hands.choose(dialog, "Import");
    hands.await("the model", () -> session.document().text().toString().contains("block.x3d"));
    DocumentElement added = session.selection().orElseThrow();
    assertThat(added.def()).contains("block");
    String[] at = added.text("translation").orElseThrow().split(" ");
    assertThat(Double.parseDouble(at[0])).as("the middle of 4..6").isBetween(-6.0, -4.0);
    assertThat(Double.parseDouble(at[1])).as("on the floor").isBetween(-1.01, -0.99);
    assertThat(work().resolve("block.x3d")).exists();
    assertThat(session.document().history().undoName()).contains("Import block");
    GuiRobot.onEdt(() -> session.document().history().undo());
    assertThat(work().resolve("block.x3d")).doesNotExist();
    assertThat(session.document().modified()).isFalse();
  }

  @Test
  void aModelInTheScenesFolderIsLinkedFromTheTree() throws IOException {
    EnricherSession session = open();
    model = Files.copy(model, work().resolve("mine.obj"));
    JTree tree = GuiRobot.named(window.frame().getContentPane(), "Nodes of the scene", JTree.class);
    ImportDialog dialog = drop(tree, new Point(3, 3));
    hands.click(GuiRobot.named(dialog, "Link to it", JRadioButton.class));
    hands.choose(dialog, "Import");
    hands.await("the link", () -> session.document().text().toString().contains("mine.obj"));
    assertThat(work().resolve("mine.x3d")).doesNotExist();
  }

  @Test
  void anImportThatEndsAfterItsSceneWasLeftDoesNothing() throws IOException {
    open();
    Path other = scene("other.x3d");
    ImportDialog dialog = drop(preview(), new Point(30, 30));
    later(() -> window.open(other)); // is asked for first, and is open before the model is read
    hands.choose(dialog, "Import");
    hands.await("the other scene", () -> window.has(other) && window.session().isPresent());
    hands.await("the end", () -> window.session().orElseThrow().tasks().running().isEmpty());
    assertThat(window.session().orElseThrow().document().modified()).isFalse();
    assertThat(work().resolve("other.x3d")).content().doesNotContain("block");
  }

  @Test
  void aSceneIsPackagedWithItsFiles() throws IOException {
    EnricherSession session = open();
    Files.writeString(work().resolve("sky.png"), "sky");
    GuiRobot.onEdt(
        () -> {
          int at = session.document().text().toString().indexOf("<Viewpoint");
          session.document().type(at, at, "<Background backUrl='\"sky.png\"'/>");
          return true;
        });
    later(window.files()::packageScene);
    PackageDialog dialog = hands.dialog(PackageDialog.class);
    assertThat(AccessibleNameCheck.missing(dialog)).isEmpty();
    GuiRobot.picture(dialog.getContentPane(), "window-package", 1);
    hands.click(GuiRobot.named(dialog, "A folder", JRadioButton.class));
    hands.choose(dialog, "Package");
    Path packed = work().resolve("room-package");
    hands.await(
        "the package",
        () -> Files.exists(packed.resolve("room.x3d")) && Files.exists(packed.resolve("sky.png")));
    assertThat(packed.resolve("sky.png")).hasContent("sky");
    assertThat(packed.resolve("room.x3d")).content().contains("sky.png");
  }

  @Test
  void aNewSceneReplacesNoFileThatHasAppearedSinceItsDialog() throws IOException {
    open();
    Path theirs = Files.writeString(work().resolve("theirs.x3d"), "theirs");
    boolean[] ended = {false};
    later(
        () -> {
          window.files().create(new NewSceneDialog.Answer(theirs, "<X3D/>", false));
          ended[0] = true;
        });
    JDialog dialog = hands.dialog(JDialog.class);
    hands.choose(dialog, "Cancel");
    hands.await("the end", () -> ended[0]);
    assertThat(theirs).hasContent("theirs");
    assertThat(window.has(theirs)).isFalse();
  }
}
