package org.selectiverenderer.enricher.preview;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.selectiverenderer.enricher.EventThread.edt;
import static org.selectiverenderer.enricher.EventThread.get;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.area.SnapGrid;
import org.selectiverenderer.enricher.placement.HandleSettings;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.RobotEventSync;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The handles of selected objects in a window, with a robot's mouse. */
@ShowsWindows
class ObjectHandlesTest extends PreviewFixture {
  private static final String ROOM =
      """
      <X3D profile='Immersive' version='4.0'><Scene>
        <Viewpoint position='0 1 10'/>
        <Transform translation='0 -0.1 0'><Shape><Box size='20 0.2 20'/></Shape></Transform>
        <Transform rotation='0 1 0 0.5' scale='2 2 2'>
          <Transform DEF='Chair' translation='-1 0.25 0'><Shape DEF='Seat'><Appearance>
            <UnlitMaterial emissiveColor='1 0 0'/></Appearance><Box size='0.5 0.5 0.5'/></Shape>
          </Transform>
          <Group DEF='Rest'><Transform DEF='Vase'
            translation='0.5 0.25 0'><Shape><Appearance>
            <UnlitMaterial emissiveColor='0 0 1'/></Appearance><Sphere radius='0.25'/></Shape>
          </Transform></Group>
        </Transform>
        <Shape DEF='Block'><Appearance><UnlitMaterial emissiveColor='0 1 0'/></Appearance>
          <Box size='0.6 0.6 0.6'/></Shape>
      </Scene></X3D>
      """;

  private final HandleSettings handles = new HandleSettings();

  private PreviewWindowDriver room() throws Exception {
    Path scene = Files.writeString(folder.resolve("room.x3d"), ROOM);
    PreviewWindowDriver window = new PreviewWindowDriver(scene);
    edt(
        () -> {
          window.panel.grid(() -> SnapGrid.NONE);
          window.panel.handles(handles);
        });
    window.awaitPicture();
    return window;
  }

  private static DocumentElement named(PreviewWindowDriver window, String def) {
    return window.session.document().tree().orElseThrow().named(def).orElseThrow();
  }

  /** Selects a node and returns the picture that has its box. */
  private static PreviewFrame select(PreviewWindowDriver window, String def) throws Exception {
    edt(() -> window.session.select(named(window, def), window));
    return window.await(
        frame ->
            frame.boxes().size() == 1
                && frame.image().getHeight() == get(() -> window.panel.view().getHeight())
                && frame.boxes().get(0).element().def().orElse("").equals(def));
  }

  private static String text(PreviewWindowDriver window) {
    return get(() -> window.session.document().text().toString());
  }

  private static Vector3d pivot(PreviewFrame frame) {
    var bounds = frame.boxes().get(0).bounds();
    return bounds.min().add(bounds.max()).mul(0.5);
  }

  private static Vector2d at(PreviewFrame frame, Vector3d place) {
    return new PictureRays(frame.camera()).project(place).orElseThrow();
  }

  /** The middle of the arrow along X. */
  private static Vector2d arrow(PreviewFrame frame) {
    Vector3d pivot = pivot(frame);
    double length = 56 * new PictureRays(frame.camera()).pixel(pivot);
    return at(frame, pivot.add(length, 0, 0));
  }

  @Test
  void theArrowMovesATransformInTurnedAndScaledOnesAlongTheAxisOfTheSceneAsOneStep()
      throws Exception {
    try (PreviewWindowDriver window = room()) {
      PreviewFrame frame = select(window, "Chair");
      Vector3d before = pivot(frame);
      Vector2d from = arrow(frame);
      window.drag((int) from.x, (int) from.y, (int) from.x + 60, (int) from.y + 25);
      window.drop();
      assertThat(get(() -> window.session.document().history().names())).hasSize(1);
      PreviewFrame after = window.await(each -> each.revision() > 0 && each.boxes().size() == 1);
      Vector3d shift = pivot(after).sub(before);
      assertThat(shift.x).isBetween(0.5, 3.0);
      assertThat(shift.y).isBetween(-1e-3, 1e-3);
      assertThat(shift.z).isBetween(-1e-3, 1e-3);
      assertThat(get(() -> named(window, "Chair").attached())).isTrue();
      edt(() -> window.session.document().history().undo());
      assertThat(text(window)).isEqualTo(ROOM);
    }
  }

  @Test
  void escapeTakesADragBackAndAClickOnAHandleIsForWhatIsBehind() throws Exception {
    try (PreviewWindowDriver window = room()) {
      PreviewFrame frame = select(window, "Chair");
      Vector2d from = arrow(frame);
      window.drag((int) from.x, (int) from.y, (int) from.x + 60, (int) from.y);
      window.await(each -> each.boxes().size() == 1 && pivot(each).x > pivot(frame).x + 0.2);
      RobotEventSync.of(
          KeyEvent.KEY_RELEASED,
          1,
          () -> {
            window.robot.keyPress(KeyEvent.VK_ESCAPE);
            window.robot.keyRelease(KeyEvent.VK_ESCAPE);
          });
      window.drop();
      assertThat(text(window)).isEqualTo(ROOM);
      window.await(each -> each.boxes().size() == 1 && pivot(each).distance(pivot(frame)) < 1e-3);
    }
  }

  @Test
  void theRoundHandleIsNotCoveredByASquareThatIsSeenFromItsEdge() throws Exception {
    String above =
        ROOM.replace("position='0 1 10'", "position='0 7 7' orientation='1 0 0 -0.7854'")
            .replace("<Shape DEF='Block'>", "<Transform DEF='Moved'><Shape DEF='Block'>")
            .replace("size='0.6 0.6 0.6'/></Shape>", "size='0.6 0.6 0.6'/></Shape></Transform>");
    Path scene = Files.writeString(folder.resolve("above.x3d"), above);
    try (PreviewWindowDriver window = new PreviewWindowDriver(scene)) {
      edt(
          () -> {
            window.panel.grid(() -> SnapGrid.NONE);
            window.panel.handles(handles);
          });
      window.awaitPicture();
      PreviewFrame frame = select(window, "Moved");
      Vector2d from = at(frame, pivot(frame));
      // Near the middle, where the square of Y and Z is nearer to the mouse than the middle is.
      window.drag((int) from.x, (int) from.y - 3, (int) from.x + 60, (int) from.y);
      window.await(each -> each.boxes().size() == 1 && pivot(each).x > pivot(frame).x + 0.2);
      window.drop();
    }
  }

  @Test
  void aShapeWithoutATransformGetsOneAndStaysSelected() throws Exception {
    try (PreviewWindowDriver window = room()) {
      Vector2d from = arrow(select(window, "Block"));
      window.drag((int) from.x, (int) from.y, (int) from.x + 40, (int) from.y);
      window.drop();
      assertThat(text(window)).contains("<Transform translation='").contains("<Shape DEF='Block'>");
      assertThat(get(() -> window.session.selection().orElseThrow().def())).contains("Block");
      assertThat(get(() -> named(window, "Block").parent().orElseThrow().name()))
          .isEqualTo("Transform");
    }
  }

  @Test
  void theRingTurnsByStepsAndTheCornerScales() throws Exception {
    try (PreviewWindowDriver window = room()) {
      edt(() -> handles.use(HandleSettings.Mode.TURN));
      PreviewFrame frame = select(window, "Vase");
      Vector3d pivot = pivot(frame);
      double radius = 80 * new PictureRays(frame.camera()).pixel(pivot);
      Vector2d front = at(frame, new Vector3d(pivot).add(0, radius * 0.8, radius * 0.6));
      Vector2d up = at(frame, new Vector3d(pivot).add(radius * 0.8, radius * 0.6, 0));
      assertThat(front).isNotEqualTo(up);
      window.drag((int) up.x, (int) up.y, (int) up.x - 50, (int) up.y - 40);
      window.drop();
      String rotation = get(() -> named(window, "Vase").text("rotation").orElse(""));
      assertThat(rotation).isNotEmpty().doesNotContain("NaN");
      double angle = Double.parseDouble(rotation.split(" ")[3]);
      double steps = Math.toDegrees(angle) / 15;
      assertThat(steps).isCloseTo(Math.rint(steps), within(1e-3));

      edt(() -> handles.use(HandleSettings.Mode.SCALE));
      PreviewFrame turned = window.await(each -> each.revision() > 0 && each.boxes().size() == 1);
      var box = turned.boxes().get(0);
      Vector2d corner = at(turned, box.place().transformPosition(box.own().corner(7)));
      Vector2d centre = at(turned, pivot(turned));
      Vector2d out = new Vector2d(corner).sub(centre).mul(0.6).add(corner);
      window.drag((int) corner.x, (int) corner.y, (int) out.x, (int) out.y);
      window.drop();
      assertThat(get(() -> named(window, "Vase").text("scale").orElse(""))).startsWith("1.");
    }
  }

  @Test
  void clicksSelectWhatIsAroundAndSeveral() throws Exception {
    try (PreviewWindowDriver window = room()) {
      PreviewFrame frame = select(window, "Vase");
      Vector2d vase = at(frame, pivot(frame));
      Vector2d seat = at(select(window, "Chair"), pivot(select(window, "Seat")));
      edt(() -> window.session.select(null, window));
      window.await(each -> each.boxes().isEmpty());
      window.takeKeyboard(3, 3);
      click(window, vase, 0);
      selected(window, "Vase");
      click(window, vase, 0);
      selected(window, "Rest");
      click(window, vase, 0);
      selected(window, ""); // the Transform around, which has no name
      assertThat(get(() -> window.session.selection().orElseThrow().children())).hasSize(2);
      click(window, vase, 0);
      selected(window, "Vase");
      click(window, seat, KeyEvent.VK_CONTROL);
      PreviewFrame both = window.await(each -> each.boxes().size() == 2);
      assertThat(count(both, OUTLINE)).as("both are outlined").isGreaterThan(100);
      assertThat(get(() -> names(window.session.selectedElements())))
          .containsExactly("Vase", "Seat");
      click(window, vase, KeyEvent.VK_SHIFT);
      selected(window, "Seat");
    }
  }

  private static List<String> names(List<DocumentElement> elements) {
    return elements.stream().map(each -> each.def().orElse("")).toList();
  }

  private static void selected(PreviewWindowDriver window, String def) throws Exception {
    window.await(
        frame ->
            frame.boxes().size() == 1
                && frame.boxes().get(0).element().def().orElse("").equals(def));
  }

  private static void click(PreviewWindowDriver window, Vector2d at, int key) {
    if (key != 0) {
      window.robot.keyPress(key);
    }
    window.click((int) at.x, (int) at.y, InputEvent.BUTTON1_DOWN_MASK);
    if (key != 0) {
      RobotEventSync.of(KeyEvent.KEY_RELEASED, 1, () -> window.robot.keyRelease(key));
    }
  }

  @Test
  void twoClicksMeasureMetres() throws Exception {
    try (PreviewWindowDriver window = room()) {
      edt(() -> handles.measure(true));
      PreviewFrame frame = select(window, "Chair");
      Vector2d one = at(frame, new Vector3d(-2, 0, 3));
      Vector2d other = at(frame, new Vector3d(1, 0, 3));
      window.takeKeyboard(3, 3);
      RobotEventSync.of(MouseEvent.MOUSE_MOVED, 1, () -> window.robot.mouseMove(40, 400));
      window.click((int) one.x, (int) one.y);
      window.settle();
      window.click((int) other.x, (int) other.y);
      window.settle();
      assertThat(get(() -> names(window.session.selectedElements()))).containsExactly("Chair");
      String words = get(window.panel::measured);
      for (int tries = 0; tries < 200 && !words.contains("X "); tries++) {
        window.settle();
        words = get(window.panel::measured);
      }
      assertThat(words).matches("(2\\.9|3\\.0)\\d m .*");
      edt(() -> handles.use(HandleSettings.Mode.MOVE));
      assertThat(get(window.panel::measured)).doesNotContain("X ");
    }
  }
}
