package org.selectiverenderer.enricher;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.event.KeyEvent;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JDialog;
import javax.swing.JMenuItem;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.MenuElement;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.Main;
import org.selectiverenderer.enricher.diff.DiffDialog;
import org.selectiverenderer.enricher.importing.ImportDialog;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.versions.BatchVersionsDialog;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Scenes of strangers are made selective in the window only: five objects of each get versions and
 * schemas, one of them an imported model, in a room with an area, and switch on a walk.
 */
@ShowsWindows
@Timeout(value = 300, unit = TimeUnit.SECONDS)
class StrangersScenesTest {
  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();
  private EnricherWindow window;

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

  @Test
  void anOfficeOfAModellerWithoutNames() throws IOException {
    Path scene = StrangersScenes.office(work());
    assertThat(Files.size(scene)).isGreaterThan(1_000_000);
    EnricherSession session = open(scene);
    enrich(session, "office", List.of());
    verify(scene, scene);
  }

  @Test
  void aHouseInVrml97WithSharedAppearances() throws IOException {
    Path scene = StrangersScenes.vrml(work());
    byte[] before = Files.readAllBytes(scene);
    show();
    EventQueue.invokeLater(() -> window.open(scene));
    hands.choose(hands.dialog(JDialog.class), "Convert");
    EnricherSession session = opened();
    enrich(session, "vrml", List.of("Table", "Stool", "Basket", "Lamp"));
    assertThat(scene).hasBinaryContent(before);
    verify(session.file().path(), session.file().path());
  }

  @Test
  void aRoomFileWithPrototypesOfItsOwnAndOfAnotherFile() throws IOException {
    Path scene = StrangersScenes.room(work());
    EnricherSession session = open(scene);
    enrich(session, "room", List.of("Chair1", "Armchair1", "Pouffe", "Globe"));
    verify(scene, scene.resolveSibling("house.x3d"));
  }

  private Path work() throws IOException {
    return Files.createDirectories(folder.resolve("work"));
  }

  private void show() throws IOException {
    Path settings = Files.createDirectories(folder.resolve("settings"));
    Files.writeString(
        settings.resolve("enricher.properties"),
        "theme=light\nlanguage=en\ntab=Preview\n"
            + "window.x=0\nwindow.y=0\nwindow.width=1280\nwindow.height=980\n");
    window = GuiRobot.onEdt(() -> new EnricherWindow(settings, () -> {}));
    hands.show(window.frame());
  }

  private EnricherSession open(Path scene) throws IOException {
    show();
    EventQueue.invokeLater(() -> window.open(scene));
    return opened();
  }

  private EnricherSession opened() {
    hands.await("the scene", () -> window.session().isPresent());
    hands.await("a picture", () -> window.bench().orElseThrow().drawnBy().isPresent());
    return window.session().orElseThrow();
  }

  private Container content() {
    return window.frame().getContentPane();
  }

  /**
   * All that an author does.
   *
   * @param named objects that the scene names; the first pieces that are found where it names none
   */
  private void enrich(EnricherSession session, String picture, List<String> named)
      throws IOException {
    importModel(session);
    versions(named, picture);
    List<String> made =
        GuiRobot.onEdt(
            () -> session.enrichment().switches().stream().map(each -> each.name()).toList());
    assertThat(made).hasSize(5).allMatch(each -> each.startsWith("Switch_"));
    assertThat(made).anyMatch(each -> each.contains("vase") || each.contains("Vase"));
    area(session, made.get(0));
    describe(session, made);
    GuiRobot.picture(window.frame().getRootPane(), "strangers-" + picture, 1);
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
    hands.choose(hands.dialog(DiffDialog.class), "Save");
    hands.await("the saved file", () -> !session.document().modified());
  }

  /** Drops a model from another folder on the preview. */
  private void importModel(EnricherSession session) throws IOException {
    Path model = StrangersScenes.glb(folder.resolve("downloads"));
    EventQueue.invokeLater(
        () -> {
          Component preview = window.bench().orElseThrow().drops().preview();
          Point at = new Point(preview.getWidth() * 3 / 5, preview.getHeight() * 4 / 5);
          window.imports().dropped(model, preview, at);
        });
    hands.choose(hands.dialog(ImportDialog.class), "Import");
    hands.await("the model", () -> session.document().text().toString().contains("vase.x3d"));
  }

  private static Optional<JMenuItem> item(MenuElement in, String text) {
    if (in instanceof JMenuItem item && text.equals(item.getText())) {
      return Optional.of(item);
    }
    return Stream.of(in.getSubElements()).flatMap(each -> item(each, text).stream()).findFirst();
  }

  /** Makes versions of five objects at once: the named ones, else the first, and the model. */
  private void versions(List<String> named, String picture) {
    JMenuItem many =
        GuiRobot.onEdt(
            () ->
                item(window.frame().getJMenuBar(), "Make Versions of Many Objects...")
                    .orElseThrow());
    EventQueue.invokeLater(many::doClick);
    BatchVersionsDialog dialog = hands.dialog(BatchVersionsDialog.class);
    JTable table = GuiRobot.named(dialog, "Objects to make versions of", JTable.class);
    hands.await("the objects", () -> table.getRowCount() >= 5);
    hands.click(GuiRobot.named(dialog, "Untick All", JButton.class));
    List<String> wanted = new ArrayList<>(named);
    for (int row = 0; row < GuiRobot.onEdt(table::getRowCount); row++) {
      int at = row;
      String name = GuiRobot.onEdt(() -> String.valueOf(table.getValueAt(at, 1)));
      boolean model = name.toLowerCase(java.util.Locale.ROOT).contains("vase");
      boolean chosen = named.isEmpty() ? wanted.size() < 4 : named.contains(name);
      if (model || chosen) {
        hands.click(table, at, 0);
        hands.await("the tick of " + name, () -> Boolean.TRUE.equals(table.getValueAt(at, 0)));
        if (named.isEmpty() && !model) {
          wanted.add(name);
        }
      }
    }
    GuiRobot.picture(dialog.getContentPane(), "strangers-" + picture + "-versions", 1);
    JButton make = GuiRobot.named(dialog, "Make Versions", JButton.class);
    hands.await("ticks", make::isEnabled);
    hands.click(make);
    hands.await("the versions", () -> !dialog.isShowing());
  }

  /** Puts an area around an object, by the keys, and says what it is of. */
  private void area(EnricherSession session, String around) {
    select(session, around);
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_A);
    hands.dialog(JDialog.class);
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
    hands.write("DeskArea");
    hands.press(KeyEvent.VK_ENTER);
    hands.await("the area", () -> session.enrichment().sensorsByName().containsKey("DeskArea"));
    fill("Schemas on entering", "DeskSchema");
    fill("Schemas on leaving", "OfficeSchema");
  }

  private void fill(String field, String text) {
    hands.click(GuiRobot.named(content(), field, JTextField.class));
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
    hands.write(text);
    hands.press(KeyEvent.VK_ENTER);
  }

  private void choose(String list, int key) {
    hands.click(GuiRobot.named(content(), list, JComboBox.class));
    hands.press(key);
    hands.press(KeyEvent.VK_ENTER);
  }

  private void select(EnricherSession session, String def) {
    JTextField search = GuiRobot.named(content(), "Search nodes", JTextField.class);
    hands.click(search);
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
    hands.write(def);
    for (int tries = 0; tries < 8 && !selected(session, def); tries++) {
      hands.press(KeyEvent.VK_ENTER); // from hit to hit
    }
    hands.await("the node " + def, () -> selected(session, def));
  }

  private static boolean selected(EnricherSession session, String def) {
    return session.selection().flatMap(DocumentElement::def).filter(def::equals).isPresent();
  }

  /** The first object by its form, the others by its copied metadata. */
  private void describe(EnricherSession session, List<String> objects) {
    for (String object : objects) {
      select(session, object);
      if (object.equals(objects.get(0))) {
        choose("Type of choice 0", KeyEvent.VK_I);
        fill("Degree of choice 0", "low");
        fill("Schemas of choice 0", "DeskSchema");
        choose("Type of choice 1", KeyEvent.VK_C);
        fill("Degree of choice 1", "high");
        fill("Schemas of choice 1", "OfficeSchema");
        hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_ALT, KeyEvent.VK_C);
      } else {
        hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_ALT, KeyEvent.VK_V);
      }
    }
    assertThat(session.enrichment().switches()).allMatch(each -> each.enriched());
  }

  private static String run(String... args) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    PrintStream print = new PrintStream(out, true, UTF_8);
    int got = Main.execute(args, print, print);
    assertThat(got).as(out.toString(UTF_8)).isZero();
    return out.toString(UTF_8);
  }

  /** The saved scene has no errors, and on a walk to the area and back all five objects switch. */
  private void verify(Path scene, Path walked) throws IOException {
    assertThat(run("validate", scene.toString())).doesNotContain("error:");
    String happened = run("simulate", walked.toString(), "--path=" + StrangersScenes.walk(folder));
    assertThat(happened.lines().filter(line -> line.contains(" switch ")))
        .as(happened)
        .hasSizeGreaterThanOrEqualTo(5);
  }
}
