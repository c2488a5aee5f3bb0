package org.selectiverenderer.enricher.preview;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.KeyListener;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.joml.Vector2d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.area.SnapGrid;
import org.selectiverenderer.enricher.EventThread;
import org.selectiverenderer.enricher.area.NodeCommands;
import org.selectiverenderer.enricher.compare.CompareMode;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The mouse and the keys over the picture: selecting, walking, dragging areas. */
@ShowsWindows
class PreviewInputControllerTest extends PreviewFixture {
  @Test
  void aClickSelectsTheSwitchAroundAShapeAndOutlinesIt() throws Exception {
    try (PreviewWindowDriver window = open()) {
      boxes(window, false);
      PreviewFrame before = window.await(frame -> middle(frame) == GREEN);
      assertThat(count(before, OUTLINE)).isZero();
      window.click(before.image().getWidth() / 2, before.image().getHeight() / 2);
      PreviewFrame after = window.await(frame -> frame.selected().isPresent());
      assertThat(EventThread.get(() -> window.session.selection()).flatMap(DocumentElement::def))
          .contains("TrashCan");
      assertThat(count(after, OUTLINE)).isGreaterThan(100);
      assertThat(middle(after)).as("the object itself").isEqualTo(GREEN);
    }
  }

  @Test
  void aClickOnAShapeWithoutNamesSelectsItsElement() throws Exception {
    try (PreviewWindowDriver window = open()) {
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
      assertThat(EventThread.get(() -> window.session.selection()).map(DocumentElement::name))
          .contains("Shape");
    }
  }

  @Test
  void theOtherButtonShowsTheMenuOfAnObjectAndWhereNothingIsThatOfTheScene() throws Exception {
    try (PreviewWindowDriver window = open()) {
      boxes(window, false);
      PreviewFrame shown = window.await(frame -> middle(frame) == GREEN);
      BlockingQueue<String> menus = new LinkedBlockingQueue<>();
      EventThread.edt(
          () ->
              window.panel.onMenu(
                  (over, at) ->
                      menus.add(window.session.selection().map(Object::toString).orElse(""))));
      int middle = shown.image().getHeight() / 2;
      window.click(shown.image().getWidth() / 2, middle, InputEvent.BUTTON3_DOWN_MASK);
      assertThat(menus.poll(60, TimeUnit.SECONDS)).contains("TrashCan");
      window.click(20, middle, InputEvent.BUTTON3_DOWN_MASK);
      assertThat(menus.poll(60, TimeUnit.SECONDS)).isNotNull().doesNotContain("TrashCan");
      assertThat(EventThread.get(() -> window.session.selection()).map(DocumentElement::name))
          .contains("Scene");
    }
  }

  @Test
  void whatUnsavedTextNamesIsReadBesideTheFileAndPickedAsTheInline() throws Exception {
    Files.writeString(folder.resolve("more.x3d"), SCENE.replace("0 1 0", "0 1 1"));
    try (PreviewWindowDriver window = open()) {
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
      assertThat(EventThread.get(() -> window.session.selection()).flatMap(DocumentElement::def))
          .contains("More");
    }
  }

  @Test
  void walkingEntersAreasUnderTheController() throws Exception {
    try (PreviewWindowDriver window = open()) {
      boxes(window, false);
      PreviewFrame start = window.await(frame -> middle(frame) == GREEN);
      window.takeKeyboard(start.image().getWidth() - 20, 20);
      EventThread.edt(() -> window.panel.walk(true));
      assertThat(window.await(PreviewFrame::walking).areas()).isEmpty();
      window.robot.keyPress(KeyEvent.VK_W);
      PreviewFrame inside = window.await(frame -> frame.areas().contains("Desk"));
      window.robot.keyRelease(KeyEvent.VK_W);
      assertThat(EventThread.get(() -> taken(window, KeyEvent.VK_S, 0))).as("S walks").isTrue();
      for (int modifier :
          new int[] {
            InputEvent.CTRL_DOWN_MASK, InputEvent.ALT_DOWN_MASK, InputEvent.META_DOWN_MASK
          }) {
        assertThat(EventThread.get(() -> taken(window, KeyEvent.VK_S, modifier)))
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
  private static boolean taken(PreviewWindowDriver window, int key, int modifiers) {
    PreviewCanvas view = window.panel.view();
    KeyEvent pressed = new KeyEvent(view, KeyEvent.KEY_PRESSED, 0, modifiers, key, 's');
    for (KeyListener listener : view.getKeyListeners()) {
      listener.keyPressed(pressed);
      listener.keyReleased(new KeyEvent(view, KeyEvent.KEY_RELEASED, 0, modifiers, key, 's'));
    }
    return pressed.isConsumed();
  }

  /** Of Desk: the middle of its right face is seen from the start viewpoint. */
  private static Vector2d handle(PreviewWindowDriver window, int which) {
    return EventThread.get(
        () -> {
          var areas = new NodeCommands(window.session);
          var sensor = window.session.selection().orElseThrow();
          var camera = window.panel.view().frame().orElseThrow().camera();
          return AreaHandleDrag.inPicture(
                  AreaHandleDrag.place(areas.area(sensor).orElseThrow(), which), camera)
              .orElseThrow();
        });
  }

  private static String desk(PreviewWindowDriver window) {
    return EventThread.get(
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
    try (PreviewWindowDriver window = open()) {
      EventThread.edt(
          () -> {
            window.panel.grid(() -> new SnapGrid(0.5));
            window.session.select(
                window.session.enrichment().sensorsByName().get("Desk").element(), this);
          });
      window.await(frame -> frame.selected().isPresent());
      String before = desk(window);
      Vector2d from = handle(window, 1);
      int x = (int) Math.round(from.x);
      int y = (int) Math.round(from.y);
      window.drag(x, y, x + 60, y);
      EventThread.edt(() -> {});
      assertThat(desk(window)).as("nothing is written before the end").isEqualTo(before);
      window.robot.keyPress(KeyEvent.VK_ESCAPE);
      window.robot.keyRelease(KeyEvent.VK_ESCAPE);
      window.drop();
      assertThat(desk(window)).as("taken back").isEqualTo(before);
      window.drag(x, y, x + 60, y);
      window.drop();
      assertThat(desk(window)).matches(".*size='[45](\\.5)? 3 3' center='[01](\\.[0-9]+)? 0 0'>");
      assertThat(EventThread.get(() -> window.session.document().history().names()))
          .containsExactly("Resize Desk");
      EventThread.edt(() -> window.session.document().history().undo());
      assertThat(desk(window)).isEqualTo(before);
    }
  }

  @Test
  void besideAllPolygonsTheHandlesStandWhereTheBoxIs() throws Exception {
    try (PreviewWindowDriver window = open()) {
      EventThread.edt(
          () -> {
            window.panel.compare(CompareMode.BESIDE);
            window.session.select(
                window.session.enrichment().sensorsByName().get("Desk").element(), this);
          });
      int whole = EventThread.get(() -> window.panel.view().getWidth());
      PreviewFrame beside =
          window.await(
              frame -> frame.selected().isPresent() && frame.image().getWidth() == whole / 2);
      Vector2d from =
          EventThread.get(
              () ->
                  AreaHandleDrag.inPicture(
                          AreaHandleDrag.place(
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
      assertThat(EventThread.get(() -> window.session.document().history().names()))
          .containsExactly("Resize Desk");
      EventThread.edt(() -> window.session.document().history().undo());
      window.drag(x, y, x + 40, y);
      window.drop();
      assertThat(desk(window)).as("the left picture has no handles").isEqualTo(before);
    }
  }
}
