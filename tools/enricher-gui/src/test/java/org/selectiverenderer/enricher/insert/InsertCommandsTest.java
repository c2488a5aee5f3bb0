package org.selectiverenderer.enricher.insert;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.EventQueue;
import java.awt.datatransfer.Clipboard;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JPanel;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.browser.viewer.Pose;
import org.selectiverenderer.enricher.menu.StructureCommands;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.task.TaskExecutor;
import org.selectiverenderer.testing.robot.GuiRobot;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Insertions whose place is known only a while after they were asked for. */
class InsertCommandsTest {
  @TempDir Path folder;

  private final Deque<Consumer<Optional<Vector3d>>> waiting = new ArrayDeque<>();
  private final List<String> messages = new ArrayList<>();
  private Optional<Pose> viewer = Optional.empty();
  private EnricherSession session;
  private InsertCommands commands;

  @BeforeEach
  void open() throws IOException {
    open("<Group DEF='A'/>\n<Group DEF='B'/>\n");
  }

  private void open(String nodes) throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("scene.x3d"),
            "<X3D version='4.0'>\n<Scene>\n" + nodes + "</Scene>\n</X3D>\n");
    session =
        new EnricherSession(
            DocumentFile.open(file),
            NodeCatalogue.load(),
            new TaskExecutor(EventQueue::invokeLater),
            messages::add);
    StructureCommands structure = new StructureCommands(session, new Clipboard("test"));
    commands = new InsertCommands(session, structure, () -> viewer, waiting::add);
  }

  private Optional<DocumentElement> named(String name) {
    return session.document().tree().orElseThrow().named(name);
  }

  private void select(String name) {
    session.select(named(name).orElseThrow(), this);
  }

  private void ask(String template) {
    GuiRobot.onEdt(
        () -> {
          commands.insert(template, new JPanel());
          return true;
        });
  }

  private void answer(double x, double y, double z) {
    waiting.removeFirst().accept(Optional.of(new Vector3d(x, y, z)));
  }

  private String parentOf(String name) {
    return named(name).flatMap(DocumentElement::parent).map(DocumentElement::toString).orElse("");
  }

  private void remove(String name) {
    select(name);
    new StructureCommands(session, new Clipboard("test")).delete();
  }

  @Test
  void whatWasAskedForGoesToWhatWasSelectedThen() {
    select("A");
    ask("box");
    select("B");
    answer(1, 0, 2);
    assertThat(parentOf("Box")).isEqualTo("Group A");
    assertThat(named("Box").orElseThrow().text("translation")).contains("1 0.5 2");
  }

  @Test
  void withoutASelectionItGoesToTheEndOfTheSceneWhateverIsSelectedLater() {
    ask("box");
    select("B");
    answer(0, 0, 0);
    assertThat(parentOf("Box")).isEqualTo("Scene");
  }

  @Test
  void whereItsGoalIsGoneThatIsSaid() {
    select("A");
    ask("box");
    remove("A");
    messages.clear();
    answer(1, 0, 2);
    assertThat(named("Box")).isEmpty();
    assertThat(messages)
        .containsExactly(
            "Nothing was inserted: Group A, where it was to go, is no longer in the scene."
                + " Select another place and insert it again.");
  }

  @Test
  void inASceneThatHasChangedItsPlaceIsFoundAnew() {
    select("A");
    ask("box");
    ask("box");
    answer(1, 0, 2);
    assertThat(named("Box")).isPresent();
    answer(1, 0, 2);
    assertThat(named("Box_2")).as("not yet placed on what is there now").isEmpty();
    answer(1, 1, 2);
    assertThat(named("Box_2").orElseThrow().text("translation")).contains("1 1.5 2");
  }

  @Test
  void theNewNodeIsToldWhenItIsThere() {
    List<String> told = new ArrayList<>();
    commands.onInserted(element -> told.add(element.toString()));
    select("A");
    ask("box");
    assertThat(told).isEmpty();
    answer(0, 0, 0);
    assertThat(told).containsExactly("Transform Box");
  }

  /** What stands in a room that is moved and turned stands on that room's floor. */
  @Test
  void inATransformItStandsWhereItWouldInTheScene() throws Exception {
    open(
        "<Transform DEF='A' translation='10 3 0' rotation='0 1 0 1.5707963' scale='2 2 2'>\n"
            + "<Group/>\n</Transform>\n");
    select("A");
    ask("box");
    answer(8, 3, 0);
    assertThat(parentOf("Box")).isEqualTo("Transform A");
    assertThat(named("Box").orElseThrow().text("translation")).contains("0 0.5 -1");
  }

  @Test
  void whereTheTextDoesNotTellTheCoordinatesItIsAtTheirOrigin() throws Exception {
    open("<Billboard DEF='A'/>\n");
    select("A");
    ask("box");
    assertThat(waiting).isEmpty();
    assertThat(named("Box").orElseThrow().text("translation")).contains("0 0.5 0");
  }

  /** A view from above has its eyes far over the ground. */
  @Test
  void aLampHangsOverTheGroundNotOverTheEyes() {
    viewer = Optional.of(new Pose(new Vector3d(0, 20, 0), new Quaterniond(), 1));
    select("A");
    ask("lamp");
    answer(1, 0, 2);
    assertThat(named("Lamp").orElseThrow().text("location")).contains("1 2 2");
  }

  @Test
  void aLampOverATableHangsNoHigherThanInTheRoom() {
    viewer = Optional.of(new Pose(new Vector3d(0, 1.6, 0), new Quaterniond(), 1));
    select("A");
    ask("lamp");
    answer(1, 0.75, 2);
    assertThat(named("Lamp").orElseThrow().text("location")).contains("1 2 2");
  }
}
