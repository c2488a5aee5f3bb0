package org.selectiverenderer.enricher.preview;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.KeyListener;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import javax.swing.KeyStroke;
import org.joml.Vector2d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.document.area.GridStep;
import org.selectiverenderer.enricher.Swing;
import org.selectiverenderer.enricher.area.NodeCommands;
import org.selectiverenderer.enricher.area.PlanPicture;
import org.selectiverenderer.enricher.area.SceneProbe;
import org.selectiverenderer.enricher.compare.CompareMode;
import org.selectiverenderer.enricher.driving.ControlNames;
import org.selectiverenderer.geometry.Bounds;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.x3d.source.DocumentElement;

@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class PreviewPanelTest {
  private static final int GREEN = 0x00ff00;
  private static final int RED = 0xff0000;
  private static final int BLUE = 0x0000ff;
  private static final int OUTLINE = 0xff8c00;

  /**
   * Seen from (0, 0, 10): an object in two versions in the middle, an unnamed shape at its right.
   */
  private static final String SCENE =
      """
      <X3D profile='Immersive' version='4.0'><Scene>
        <NavigationInfo type='"FLY"' speed='20' headlight='true'/>
        <Background skyColor='0.5 0.5 0.5'/>
        <Viewpoint position='0 0 10'/>
        <ProximitySensor DEF='Desk' size='3 3 3'>
          <MetadataSet containerField='metadata'>
            <MetadataString containerField='value' name='enterTimeSchema' value='"DeskSchema"'/>
            <MetadataString containerField='value' name='exitTimeSchema' value='"OfficeSchema"'/>
          </MetadataSet>
        </ProximitySensor>
        <Switch DEF='TrashCan' whichChoice='0'>
          <MetadataSet containerField='metadata'>
            <MetadataSet containerField='value'>
              <MetadataString containerField='value' name='schemaBelonginess' value='"OfficeSchema"'/>
            </MetadataSet>
            <MetadataSet containerField='value'>
              <MetadataString containerField='value' name='schemaBelonginess' value='"DeskSchema"'/>
            </MetadataSet>
          </MetadataSet>
          <Shape DEF='Low'><Appearance><UnlitMaterial emissiveColor='0 1 0'/></Appearance>
            <Box size='1 1 1'/></Shape>
          <Shape DEF='High'><Appearance><UnlitMaterial emissiveColor='1 0 0'/></Appearance>
            <Sphere radius='0.7'/></Shape>
        </Switch>
        <Transform translation='3 0 0'>
          <Shape><Appearance><UnlitMaterial emissiveColor='0 0 1'/></Appearance>
            <Box size='1 1 1'/></Shape>
        </Transform>
      </Scene></X3D>
      """;

  @TempDir Path folder;

  private PreviewWindow open() throws Exception {
    Path scene = Files.writeString(folder.resolve("scene.x3d"), SCENE);
    PreviewWindow window = new PreviewWindow(scene);
    window.awaitPicture();
    return window;
  }

  private static int middle(PreviewFrame frame) {
    return rgb(frame.image(), 0.5, 0.5);
  }

  private static int rgb(BufferedImage image, double x, double y) {
    return image.getRGB((int) (x * image.getWidth()), (int) (y * image.getHeight())) & 0xffffff;
  }

  private static long count(PreviewFrame frame, int color) {
    BufferedImage image = frame.image();
    return Arrays.stream(
            image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth()))
        .filter(rgb -> (rgb & 0xffffff) == color)
        .count();
  }

  private static void boxes(PreviewWindow window, boolean shown) {
    Swing.edt(() -> window.panel.sensorsShown(shown));
  }

  @Test
  void aClickSelectsTheSwitchAroundAShapeAndOutlinesIt() throws Exception {
    try (PreviewWindow window = open()) {
      boxes(window, false);
      PreviewFrame before = window.await(frame -> middle(frame) == GREEN);
      assertThat(count(before, OUTLINE)).isZero();
      window.click(before.image().getWidth() / 2, before.image().getHeight() / 2);
      PreviewFrame after = window.await(frame -> frame.selected().isPresent());
      assertThat(Swing.get(() -> window.session.selection()).flatMap(DocumentElement::def))
          .contains("TrashCan");
      assertThat(count(after, OUTLINE)).isGreaterThan(100);
      assertThat(middle(after)).as("the object itself").isEqualTo(GREEN);
    }
  }

  @Test
  void aClickOnAShapeWithoutNamesSelectsItsElement() throws Exception {
    try (PreviewWindow window = open()) {
      boxes(window, false);
      PreviewFrame shown = window.await(frame -> count(frame, BLUE) > 100);
      BufferedImage image = shown.image();
      int y = image.getHeight() / 2;
      int x = image.getWidth() / 2;
      while ((image.getRGB(x, y) & 0xffffff) != BLUE) {
        x++;
      }
      window.click(x + 10, y);
      window.await(frame -> frame.selected().isPresent());
      assertThat(Swing.get(() -> window.session.selection()).map(DocumentElement::name))
          .contains("Shape");
    }
  }

  @Test
  void asIfInASchemaShowsItsVersionsAndTheirPolygons() throws Exception {
    try (PreviewWindow window = open()) {
      boxes(window, false);
      PreviewFrame start = window.await(frame -> middle(frame) == GREEN);
      assertThat(start.polygons()).isEqualTo(24);
      Swing.edt(() -> window.panel.asIf(List.of("OfficeSchema", "DeskSchema")));
      PreviewFrame desk = window.await(frame -> middle(frame) == RED);
      assertThat(desk.polygons()).isGreaterThan(24);
      assertThat(desk.schemas()).containsExactly("OfficeSchema", "DeskSchema");
      Swing.edt(() -> window.panel.asIf(List.of("DeskSchema", "OfficeSchema")));
      assertThat(window.await(frame -> middle(frame) == GREEN).polygons()).isEqualTo(24);
    }
  }

  @Test
  void sensorBoxesAreDrawnAndLabelledAndALabelSelectsItsSensor() throws Exception {
    try (PreviewWindow window = open()) {
      boxes(window, false);
      PreviewFrame without = window.await(frame -> frame.labels().isEmpty());
      boxes(window, true);
      PreviewFrame with = window.await(frame -> !frame.labels().isEmpty());
      PreviewFrame.Label label = with.labels().get(0);
      assertThat(PictureView.text(label))
          .contains("Desk", "DeskSchema", "OfficeSchema", "12 polygons");
      int changed = 0;
      for (int y = 0; y < with.image().getHeight(); y++) {
        for (int x = 0; x < with.image().getWidth(); x++) {
          changed += with.image().getRGB(x, y) == without.image().getRGB(x, y) ? 0 : 1;
        }
      }
      assertThat(changed).as("pixels of the box").isGreaterThan(5000);
      window.screenshot("preview-boxes");
      window.click(label.x(), label.y() - 6);
      PreviewFrame selected = window.await(frame -> frame.selected().isPresent());
      assertThat(selected.labels().get(0).selected()).isTrue();
      assertThat(Swing.get(() -> window.session.selection()).flatMap(DocumentElement::def))
          .contains("Desk");
    }
  }

  @Test
  void labelsFollowTheMetadataAndFadeBehindAWall() throws Exception {
    try (PreviewWindow window = open()) {
      PreviewFrame open = window.await(frame -> !frame.labels().isEmpty());
      assertThat(open.labels().get(0).hidden()).isFalse();
      replace(window, "value='\"DeskSchema\"'", "value='\"ShelfSchema\"'");
      window.await(frame -> PictureView.text(frame.labels().get(0)).contains("ShelfSchema"));
      replace(
          window,
          "<Switch DEF='TrashCan'",
          "<Transform translation='0 0 5'><Shape><Box size='40 40 0.1'/></Shape></Transform>"
              + "<Switch DEF='TrashCan'");
      PreviewFrame behind = window.await(frame -> frame.labels().get(0).hidden());
      assertThat(PictureView.text(behind.labels().get(0))).contains("Desk");
    }
  }

  @Test
  void anEditIsShownFromWhereTheAuthorLooksAndAFaultKeepsThePicture() throws Exception {
    try (PreviewWindow window = open()) {
      boxes(window, false);
      window.await(frame -> middle(frame) == GREEN);
      window.robot.mouseMove(5, 5);
      // Farther away: the object gets smaller, and stays so after the edit.
      long near = count(window.await(frameAfter(window, "MINUS")), GREEN);
      replace(window, "emissiveColor='0 1 0'", "emissiveColor='1 1 0'");
      PreviewFrame edited = window.await(frame -> middle(frame) == 0xffff00);
      assertThat(count(edited, 0xffff00)).isBetween(near - 50, near + 50);
      replace(window, "</Switch>", "</Swich>");
      window.panel.reload();
      assertThat(Swing.get(window.panel::message)).contains("not well formed");
      assertThat(Swing.get(() -> window.panel.view().frame()))
          .get()
          .satisfies(kept -> assertThat(middle(kept)).isEqualTo(0xffff00));
    }
  }

  @Test
  void layersThatAreNotShownAreTold() throws Exception {
    String layers = "<LayerSet order='0 1 2'><Layer/><Layer/></LayerSet>";
    try (PreviewWindow window = open()) {
      window.await(frame -> frame.otherLayers() == 0);
      replace(window, "</Scene>", layers + "</Scene>");
      window.await(frame -> frame.otherLayers() == 2);
      assertThat(Swing.get(window.panel::message)).contains("2 others");
      replace(window, layers, "");
      window.await(frame -> frame.otherLayers() == 0);
      assertThat(Swing.get(window.panel::message)).isBlank();
    }
  }

  @Test
  void whatUnsavedTextNamesIsReadBesideTheFileAndPickedAsTheInline() throws Exception {
    Files.writeString(folder.resolve("more.x3d"), SCENE.replace("0 1 0", "0 1 1"));
    try (PreviewWindow window = open()) {
      boxes(window, false);
      window.await(frame -> middle(frame) == GREEN);
      replace(
          window,
          "<Switch DEF='TrashCan'",
          "<Transform translation='0 0 3'><Inline DEF='More' url='\"more.x3d\"'/></Transform>"
              + "<Switch DEF='TrashCan'");
      PreviewFrame both = window.await(frame -> middle(frame) == 0x00ffff);
      assertThat(both.polygons()).isEqualTo(48);
      window.click(both.image().getWidth() / 2, both.image().getHeight() / 2);
      window.await(frame -> frame.selected().isPresent());
      assertThat(Swing.get(() -> window.session.selection()).flatMap(DocumentElement::def))
          .contains("More");
    }
  }

  /** Presses a key of the picture by its action and says which frame is wanted. */
  private static Predicate<PreviewFrame> frameAfter(PreviewWindow window, String key) {
    PictureView view = window.panel.view();
    long before = Swing.get(() -> count(view.frame().orElseThrow(), GREEN));
    Swing.edt(
        () -> {
          Object name = view.getInputMap().get(KeyStroke.getKeyStroke(key));
          view.getActionMap().get(name).actionPerformed(new ActionEvent(view, 0, key));
        });
    return frame -> count(frame, GREEN) < before;
  }

  private static void replace(PreviewWindow window, String what, String by) {
    Swing.edt(
        () -> {
          int at = window.session.document().text().toString().indexOf(what);
          window.session.document().type(at, at + what.length(), by);
        });
  }

  @Test
  void walkingEntersAreasUnderTheController() throws Exception {
    try (PreviewWindow window = open()) {
      boxes(window, false);
      PreviewFrame start = window.await(frame -> middle(frame) == GREEN);
      window.takeKeyboard(start.image().getWidth() - 20, 20);
      Swing.edt(() -> window.panel.walk(true));
      assertThat(window.await(PreviewFrame::walking).areas()).isEmpty();
      window.robot.keyPress(KeyEvent.VK_W);
      PreviewFrame inside = window.await(frame -> frame.areas().contains("Desk"));
      window.robot.keyRelease(KeyEvent.VK_W);
      assertThat(Swing.get(() -> taken(window, KeyEvent.VK_S, 0))).as("S walks").isTrue();
      for (int modifier :
          new int[] {
            InputEvent.CTRL_DOWN_MASK, InputEvent.ALT_DOWN_MASK, InputEvent.META_DOWN_MASK
          }) {
        assertThat(Swing.get(() -> taken(window, KeyEvent.VK_S, modifier)))
            .as("S with another key is the window's")
            .isFalse();
      }
      assertThat(inside.schemas()).containsExactly("DeskSchema");
      assertThat(inside.polygons()).isGreaterThan(24);
      window.robot.keyPress(KeyEvent.VK_ESCAPE);
      window.robot.keyRelease(KeyEvent.VK_ESCAPE);
      PreviewFrame after = window.await(frame -> !frame.walking());
      assertThat(after.polygons()).isEqualTo(24);
    }
  }

  /** Whether the picture keeps a key for itself. */
  private static boolean taken(PreviewWindow window, int key, int modifiers) {
    PictureView view = window.panel.view();
    KeyEvent pressed = new KeyEvent(view, KeyEvent.KEY_PRESSED, 0, modifiers, key, 's');
    for (KeyListener listener : view.getKeyListeners()) {
      listener.keyPressed(pressed);
      listener.keyReleased(new KeyEvent(view, KeyEvent.KEY_RELEASED, 0, modifiers, key, 's'));
    }
    return pressed.isConsumed();
  }

  @Test
  void everyControlHasAnAccessibleName() throws Exception {
    try (PreviewWindow window = open()) {
      Swing.edt(() -> assertThat(ControlNames.missing(window.panel)).isEmpty());
    }
  }

  @Test
  void disposingEndsItsThreads() throws Exception {
    Set<Thread> own;
    try (PreviewWindow window = open()) {
      own = threads();
      assertThat(window.panel.isShowing()).isTrue();
      assertThat(own).extracting(Thread::getName).contains("enricher-preview");
    }
    for (Thread thread : own) {
      thread.join(TimeUnit.SECONDS.toMillis(60));
      assertThat(thread.isAlive()).as(thread.getName()).isFalse();
    }
  }

  private static Set<Thread> threads() {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(thread -> thread.getName().startsWith("enricher-preview"))
        .collect(Collectors.toSet());
  }

  /** Of Desk: the middle of its right face is seen from the start viewpoint. */
  private static Vector2d handle(PreviewWindow window, int which) {
    return Swing.get(
        () -> {
          var areas = new NodeCommands(window.session);
          var sensor = window.session.selection().orElseThrow();
          var camera = window.panel.view().frame().orElseThrow().camera();
          return AreaDrag.inPicture(AreaDrag.place(areas.area(sensor).orElseThrow(), which), camera)
              .orElseThrow();
        });
  }

  private static String desk(PreviewWindow window) {
    return Swing.get(
        () ->
            window
                .session
                .document()
                .text(window.session.selection().orElseThrow())
                .lines()
                .findFirst()
                .orElseThrow());
  }

  @Test
  void aHandleOfTheSelectedAreaIsDraggedLiveAndIsOneStepOfUndoAndEscapeTakesItBack()
      throws Exception {
    try (PreviewWindow window = open()) {
      Swing.edt(
          () -> {
            window.panel.grid(() -> new GridStep(0.5));
            window.session.select(
                window.session.enrichment().sensorsByName().get("Desk").element(), this);
          });
      window.await(frame -> frame.selected().isPresent());
      String before = desk(window);
      Vector2d from = handle(window, 1);
      int x = (int) Math.round(from.x);
      int y = (int) Math.round(from.y);
      window.drag(x, y, x + 60, y);
      Swing.edt(() -> {});
      assertThat(desk(window)).as("nothing is written before the end").isEqualTo(before);
      window.robot.keyPress(KeyEvent.VK_ESCAPE);
      window.robot.keyRelease(KeyEvent.VK_ESCAPE);
      window.drop();
      assertThat(desk(window)).as("taken back").isEqualTo(before);
      window.drag(x, y, x + 60, y);
      window.drop();
      assertThat(desk(window)).matches(".*size='[45](\\.5)? 3 3' center='[01](\\.[0-9]+)? 0 0'>");
      assertThat(Swing.get(() -> window.session.document().history().names()))
          .containsExactly("Resize Desk");
      Swing.edt(() -> window.session.document().history().undo());
      assertThat(desk(window)).isEqualTo(before);
    }
  }

  @Test
  void besideAllPolygonsTheHandlesStandWhereTheBoxIs() throws Exception {
    try (PreviewWindow window = open()) {
      Swing.edt(
          () -> {
            window.panel.compare(CompareMode.BESIDE);
            window.session.select(
                window.session.enrichment().sensorsByName().get("Desk").element(), this);
          });
      int whole = Swing.get(() -> window.panel.view().getWidth());
      PreviewFrame beside =
          window.await(
              frame -> frame.selected().isPresent() && frame.image().getWidth() == whole / 2);
      Vector2d from =
          Swing.get(
              () ->
                  AreaDrag.inPicture(
                          AreaDrag.place(
                              new NodeCommands(window.session)
                                  .area(window.session.selection().orElseThrow())
                                  .orElseThrow(),
                              1),
                          beside.camera())
                      .orElseThrow());
      String before = desk(window);
      int x = (int) Math.round(from.x);
      int y = (int) Math.round(from.y);
      window.drag(whole / 2 + x, y, whole / 2 + x + 40, y);
      window.drop();
      assertThat(Swing.get(() -> window.session.document().history().names()))
          .containsExactly("Resize Desk");
      Swing.edt(() -> window.session.document().history().undo());
      window.drag(x, y, x + 40, y);
      window.drop();
      assertThat(desk(window)).as("the left picture has no handles").isEqualTo(before);
    }
  }

  @Test
  void theRoomIsMeasuredAndThePlanDrawnByTheRunningScene() throws Exception {
    Path scene =
        Files.writeString(
            folder.resolve("room.x3d"),
            """
            <X3D version='4.0'><Scene>
              <Viewpoint position='0 1.6 0'/>
              <Shape DEF='Room'><Box solid='false' size='6 3 4'/></Shape>
              <Transform translation='0 1.5 0'><Shape><Box solid='false' size='6 3 4'/></Shape></Transform>
              <Transform DEF='Table' translation='1 0.4 1'><Shape><Box size='1 0.8 1'/></Shape></Transform>
            </Scene></X3D>
            """);
    try (PreviewWindow window = new PreviewWindow(scene)) {
      window.awaitPicture();
      SceneProbe probe = window.panel.probe();
      Bounds room = answer(probe::room);
      assertThat(room.minX()).isCloseTo(-3, within(1e-3));
      assertThat(room.maxZ()).isCloseTo(2, within(1e-3));
      assertThat(room.height()).isCloseTo(1.5, within(1e-3));
      DocumentElement table =
          Swing.get(() -> window.session.document().tree().orElseThrow().named("Table"))
              .orElseThrow();
      Bounds around = answer(answered -> probe.around(table, answered));
      assertThat(around.width()).isCloseTo(3, within(1e-3));
      assertThat(around.minY()).isLessThan(0.01);
      Bounds raised = answer(answered -> probe.raised(new Bounds(-2, 1, -1, -1, 1, 0), answered));
      assertThat(raised.minY()).isCloseTo(0, within(1e-3));
      assertThat(raised.maxY()).isCloseTo(1.5, within(1e-3));
      PlanPicture plan = answer(answered -> probe.plan(Optional.of(1.0), answered));
      assertThat(plan.extent().width()).isCloseTo(6, within(1e-3));
      assertThat(plan.walls()).as("a rectangle or two").hasSizeGreaterThanOrEqualTo(16);
      int side = plan.image().getWidth();
      assertThat(plan.image().getRGB(side / 2, plan.image().getHeight() / 2) >>> 24).isEqualTo(255);
    }
  }

  private static <T> T answer(Consumer<Consumer<Optional<T>>> question) throws Exception {
    CompletableFuture<Optional<T>> answer = new CompletableFuture<>();
    Swing.edt(() -> question.accept(answer::complete));
    return answer.get(60, TimeUnit.SECONDS).orElseThrow();
  }
}
